#include "fastscene/nn/training_beginning.h"

#include <algorithm>
#include <string>

namespace fastscene::nn {
namespace {

using namespace std::chrono_literals;

constexpr auto kFirstNews = 7s, kNextNews = 30s;
// A step in passes forward through the network: one forward, and backward about two.
constexpr double kPassesOfStep = 3;
constexpr double kLeastPasses = 0.02;  // of fewer nothing can be told

std::string duration(double seconds) {
    const double minutes = seconds / 60;
    if (seconds < 90) return fmt::format("{:.0f} s", seconds);
    return minutes < 90 ? fmt::format("{:.0f} min", minutes) : fmt::format("{:.1f} h", minutes / 60);
}

}  // namespace

TrainingBeginning::TrainingBeginning(const TrainingTask& task, const TrainingParams& params, std::int64_t steps_done,
                                     const Run& run)
    : task_(task), params_(params), run_(run), steps_to_do_(params.steps - steps_done), passes_before_(passes()) {
    thread_ = std::jthread([this](const std::stop_token& end) {
        std::mutex mutex;
        std::condition_variable_any ended;
        std::unique_lock lock(mutex);
        for (auto wait = kFirstNews; !ended.wait_for(lock, end, wait, [&] { return end.stop_requested(); });
             wait = kNextNews)
            tell();
    });
}

void TrainingBeginning::first_step() {
    const std::lock_guard lock(mutex_);
    evaluates_ = false;
    begin_ = Clock::now();
    passes_before_ = passes();
}

double TrainingBeginning::passes() const { return task_.learners.front()->passes(); }

void TrainingBeginning::tell() {
    const std::lock_guard lock(mutex_);
    const double passed = passes() - passes_before_;
    const double seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
    const std::string what = evaluates_ ? "measuring the untrained network" : "first step";
    const double pictures = evaluates_ ? passed * task_.held_out_together : passed * params_.batch;
    if (passed < kLeastPasses) return run_.note(fmt::format("training: {}, since {}", what, duration(seconds)));
    const double all = evaluates_ ? std::max(passed, double(task_.held_out) / task_.held_out_together) : kPassesOfStep;
    // In the first step's way back nothing is asked for: it goes on as fast as the way there.
    const double step = std::max(kPassesOfStep * params_.batch * seconds / pictures, evaluates_ ? 0 : seconds);
    const double share = evaluates_ ? passed / all : std::min(passed, 1.0) / all;
    double left = step * static_cast<double>(steps_to_do_);
    if (params_.minutes > 0) left = std::min(left, 60 * params_.minutes);
    run_.note(fmt::format("training: {}, {:.0f} % in {}; a step takes about {}, the training about {}", what,
                          100 * std::min(share, 0.99), duration(seconds), duration(step), duration(left)));
}

}  // namespace fastscene::nn

#include "fastscene/nn/training.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <future>
#include <iterator>
#include <numbers>
#include <optional>

#include "fastscene/base/file.h"
#include "fastscene/base/folder_lock.h"
#include "fastscene/base/forced_exit.h"
#include "fastscene/io/image_io.h"
#include "fastscene/nn/runtime.h"
#include "fastscene/nn/process_group.h"
#include "fastscene/nn/training_beginning.h"
#include "fastscene/nn/training_folder.h"
#include "fastscene/nn/training_log.h"

namespace fastscene::nn {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int kShares = 1'000'000;  // resolution of the progress display: each step of a long training is seen

constexpr double kLookForNewcomers_s = 1;
constexpr double kMinRejoinTimeout_s = 5, kRejoinTimeoutSteps = 2;  // for members to rejoin: the longer of the two
constexpr int kMostLostInVain = 5;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }
double minutes_since(Clock::time_point begin) { return seconds_since(begin) / 60; }

// Broadcasts the state of rank 0, including its checkpoint, to the group.
std::int64_t same_beginning(const TrainingTask& task, std::int64_t step, ProcessGroup& group) {
    std::vector<at::Tensor> tensors;
    for (const auto& [name, tensor] : whole_state(task)) tensors.push_back(tensor);
    group.broadcast(tensors);
    for (Learner* learner : task.learners) {
        learner->set_steps(group.broadcast(learner->steps()));
        learner->join(group);
    }
    return group.broadcast(step);
}

// Running means over several steps.
class Means {
  public:
    void add(const Numbers& numbers) {
        if (sum_.empty()) {
            sum_ = numbers;
        } else {
            FASTSCENE_CHECK(sum_.size() == numbers.size());
            for (std::size_t i = 0; i < numbers.size(); ++i) sum_[i].second += numbers[i].second;
        }
        ++count_;
    }
    // Returns the means and resets.
    Numbers take() {
        for (auto& [name, value] : sum_) value /= count_;
        count_ = 0;
        return std::exchange(sum_, {});
    }
    bool empty() const { return count_ == 0; }

  private:
    Numbers sum_;
    int count_ = 0;
};

// Draws the examples of the next step while the current one is computed.
class Drawer {
  public:
    Drawer(const TrainingTask& task, std::uint64_t seed, const ProcessGroup* group)
        : task_(task), seed_(seed), world_size_(group ? group->world_size() : 1), rank_(group ? group->rank() : 0) {}
    Batch at(std::int64_t step, bool another_follows) {
        Batch now = next_.valid() ? next_.get() : draw(step);
        if (another_follows) next_ = std::async(std::launch::async, [this, step] { return draw(step + 1); });
        return now;
    }

  private:
    Batch draw(std::int64_t step) const {
        Random rng(seed_, "training step", static_cast<std::uint64_t>(step * world_size_ + rank_));
        return task_.draw(rng);
    }
    const TrainingTask& task_;
    std::uint64_t seed_;
    std::int64_t world_size_, rank_;
    std::future<Batch> next_;
};

// Tells of each learner's updates while it exists.
struct UpdateCalls {
    std::vector<Learner*> learners;
    UpdateCalls(std::vector<Learner*> all, const std::function<void()>& call) : learners(std::move(all)) {
        for (Learner* learner : learners) {
            learner->rest();
            learner->before_update(call);
        }
    }
    ~UpdateCalls() {
        for (Learner* learner : learners) learner->before_update({});
    }
    UpdateCalls(const UpdateCalls&) = delete;
    UpdateCalls& operator=(const UpdateCalls&) = delete;
};

std::string text_of(const Numbers& numbers) {
    std::string out;
    for (const auto& [name, value] : numbers) out += fmt::format("{}{} {:.4g}", out.empty() ? "" : ", ", name, value);
    return out;
}

// What lasts over all stretches of a training.
struct Whole {
    const TrainingTask& task;
    const TrainingParams& params;
    const fs::path& folder;
    const Run& run;
    ProcessGroup* group;  // null: alone
    Clock::time_point begin = Clock::now();
    double longest_step_s = 0;
    int lost_in_vain = 0;  // how often in a row a process was lost before a step was done
    bool keeps() const { return !group || group->rank() == 0; }  // only rank 0 writes
};

// The steps from one rendezvous of the processes to the next; alone, all of them. Begins with the last checkpoint.
class Stretch {
  public:
    explicit Stretch(Whole& whole)
        : whole_(whole),
          task_(whole.task),
          params_(whole.params),
          run_(whole.run),
          group_(whole.group),
          first_(beginning()),
          outcome_{first_, first_ >= params_.steps, {}},
          drawer_(task_, run_.seed, group_) {
        if (!whole.keeps()) return;
        log_.emplace(whole.folder, first_);
        minutes_before_ = log_->minutes();
    }
    std::int64_t first() const { return first_; }

    // Nothing if the processes must rejoin, since one more waits to take part.
    std::optional<TrainingOutcome> go();

  private:
    enum Next : std::int64_t { goes_on, time_is_up, stopped, must_rejoin };

    std::int64_t beginning() {
        for (Learner* learner : task_.learners) learner->forget_gradients();  // of a step that was not finished
        std::int64_t first = whole_.keeps() ? load_checkpoint(task_, whole_.folder) : 0;
        if (!group_) return first;
        // What a process that is lost in the first minutes leads back to.
        if (whole_.keeps() && !fs::exists(checkpoint_of(whole_.folder))) save_checkpoint(task_, first, whole_.folder);
        first = same_beginning(task_, first, *group_);
        group_->take_costs();  // of what was lost
        return first;
    }

    void log_now(const Numbers& more = {}) {
        if (!log_) return;
        const ExitHold hold;
        const double minutes = minutes_before_ + minutes_since(begin_);
        if (!means_.empty()) log_->add(outcome_.steps, minutes, means_.take());
        log_->add(outcome_.steps, minutes, more);
        log_->save();
    }

    void evaluate_now() {
        if (!whole_.keeps()) return;
        const Evaluation evaluation = task_.evaluate();
        outcome_.held_out = evaluation.held_out;
        Numbers named;
        for (const auto& [name, value] : evaluation.held_out) named.emplace_back(std::string(kHeldOut) + name, value);
        log_now(named);
        if (!evaluation.sheet.empty())
            save_png(whole_.folder / "sheets" / fmt::format("{:08}.png", outcome_.steps), evaluation.sheet);
        run_.note(fmt::format("training: step {}, held out: {}", outcome_.steps, text_of(evaluation.held_out)));
    }

    void keep() {
        const ExitHold hold;
        for (Learner* learner : task_.learners) learner->rest();
        if (whole_.keeps()) save_checkpoint(task_, outcome_.steps, whole_.folder);
        kept_ = Clock::now();
    }

    // All processes end after the same step: rank 0's clock and user decide.
    Next now_what() {
        const bool up = params_.minutes > 0 && minutes_since(whole_.begin) >= params_.minutes;
        const Next mine = run_.stop.stop_requested() ? stopped
                          : up                       ? time_is_up
                          : has_newcomer()           ? must_rejoin
                                                     : goes_on;
        return group_ ? static_cast<Next>(group_->broadcast(mine)) : mine;
    }
    bool has_newcomer() {
        if (!group_ || !whole_.keeps() || seconds_since(looked_) < kLookForNewcomers_s) return false;
        looked_ = Clock::now();
        return group_->has_newcomer();
    }

    void step() {
        means_.add(task_.step(drawer_.at(outcome_.steps, outcome_.steps + 1 < params_.steps), outcome_.steps,
                              learning_rate_at(params_, outcome_.steps)));
        ++outcome_.steps;
        outcome_.finished = outcome_.steps == params_.steps;
    }

    // Tells whether more processes would help: the share of a step that is communication.
    void tell_costs() {
        if (!group_ || group_->world_size() == 1 || !whole_.keeps() || outcome_.steps == first_) return;
        const auto steps = static_cast<double>(outcome_.steps - first_);
        const GroupCosts costs = group_->take_costs();
        run_.note(fmt::format(
            "training: {} processes, {:.3g} s a step: {:.2g} s ({:.1f} %) averaging {:.3g} MB of gradients, {:.2g} s "
            "({:.1f} %) waiting for each other",
            group_->world_size(), steps_s_ / steps, costs.averaging_s / steps, 100 * costs.averaging_s / steps_s_,
            static_cast<double>(costs.bytes) / steps / 1e6, costs.waiting_s / steps, 100 * costs.waiting_s / steps_s_));
    }

    Whole& whole_;
    const TrainingTask& task_;
    const TrainingParams& params_;
    const Run& run_;
    ProcessGroup* group_;
    std::int64_t first_;
    TrainingOutcome outcome_;
    Drawer drawer_;
    std::optional<TrainingLog> log_;
    double minutes_before_ = 0, steps_s_ = 0;
    Clock::time_point begin_ = Clock::now(), kept_ = begin_, looked_ = begin_;
    Means means_;
};

std::optional<TrainingOutcome> Stretch::go() {
    // A step may take minutes. A forced exit within one keeps those before it: until the step's first update the
    // weights are as after the last one, and from there to its end nothing can force the exit.
    std::optional<ExitHold> updating;
    const UpdateCalls calls(task_.learners, [&updating] {
        if (!updating) updating.emplace();
    });
    const ExitDuty save([&] {
        if (!whole_.keeps() || outcome_.steps == first_) return;
        log_now();
        save_checkpoint(task_, outcome_.steps, whole_.folder);
    });
    std::optional<TrainingBeginning> beginning;
    if (!outcome_.finished) beginning.emplace(task_, params_, first_, run_);
    if (first_ == 0 || outcome_.finished) evaluate_now();
    Progress progress(run_, "training", kShares);
    if (beginning) beginning->first_step();
    const double minutes_before_this = std::chrono::duration<double>(begin_ - whole_.begin).count() / 60;
    for (int shown = 0; outcome_.steps < params_.steps;) {
        const Clock::time_point before = Clock::now();
        const Next next = now_what();
        if (next == stopped || next == must_rejoin) {
            log_now();
            keep();
            tell_costs();
            if (next == stopped) throw Stopped();
            return {};
        }
        if (next == time_is_up) break;
        step();
        for (Learner* learner : task_.learners) learner->rest();
        updating.reset();
        beginning.reset();
        steps_s_ += seconds_since(before);
        whole_.longest_step_s = std::max(whole_.longest_step_s, seconds_since(before));
        whole_.lost_in_vain = 0;
        if (outcome_.steps % params_.eval_steps == 0 && !outcome_.finished) try {
                evaluate_now();
            } catch (const Stopped&) {
                keep();
                throw;
            }
        else if (outcome_.steps % params_.log_steps == 0) log_now();
        if (minutes_since(kept_) >= params_.checkpoint_minutes && !outcome_.finished) keep();
        const double share = std::max(
            static_cast<double>(outcome_.steps - first_) / static_cast<double>(params_.steps - first_),
            params_.minutes > 0 ? minutes_since(begin_) / std::max(1e-9, params_.minutes - minutes_before_this) : 0.0);
        const int now = std::min(kShares, static_cast<int>(share * kShares));
        if (now > shown) progress.advance(now - shown);
        shown = std::max(shown, now);
    }
    if (outcome_.steps > first_) {
        keep();
        evaluate_now();
    }
    tell_costs();
    return outcome_;
}

// "1, 4" of the processes in `all` that are not in `others`.
std::string missing(const std::vector<int>& all, const std::vector<int>& others) {
    std::vector<int> out;
    std::set_difference(all.begin(), all.end(), others.begin(), others.end(), std::back_inserter(out));
    return fmt::format("{}", fmt::join(out, ", "));
}

void tell_members(const std::vector<int>& before, const Whole& whole, std::int64_t step) {
    const std::vector<int>& now = whole.group->members();
    const std::string gone = missing(before, now), back = missing(now, before);
    std::string text = "training: ";
    if (!gone.empty()) text += fmt::format("process {} is gone; ", gone);
    if (!back.empty()) text += fmt::format("process {} takes part again; ", back);
    if (gone.empty() && back.empty()) text += "a process was lost and is back; ";
    text += fmt::format("going on after step {} with {} of {} processes", step, now.size(), whole.params.processes);
    if (back.empty() && whole.keeps()) return whole.run.warn(text);
    whole.run.note(text);
}

}  // namespace

double learning_rate_at(const TrainingParams& params, std::int64_t step) {
    const double warm = params.warmup > 0 ? std::min(1.0, static_cast<double>(step + 1) / params.warmup) : 1.0;
    const double share = std::min(1.0, static_cast<double>(step) / params.steps);
    return warm * (params.final_learning_rate + (params.learning_rate - params.final_learning_rate) * 0.5 *
                                                    (1 + std::cos(std::numbers::pi * share)));
}

TrainingOutcome train(const TrainingTask& task, const TrainingParams& params, const fs::path& folder, const Run& run) {
    use_our_threads();
    const std::unique_ptr<ProcessGroup> group = ProcessGroup::join(params, run);
    Whole whole{task, params, folder, run, group.get()};
    std::optional<FolderLock> lock;
    if (whole.keeps()) {
        make_directories(folder / "sheets");
        lock.emplace(folder);
        settle_settings(task, params, folder, run);
    }
    for (std::vector<int> before;;) {
        try {
            Stretch stretch(whole);
            if (!before.empty()) tell_members(before, whole, stretch.first());
            else if (stretch.first() > 0) run.note(fmt::format("training: resuming after step {}", stretch.first()));
            if (const auto outcome = stretch.go()) return *outcome;
        } catch (const ProcessLost& e) {
            if (++whole.lost_in_vain > kMostLostInVain) throw;
            run.note(e.what());
        }
        before = group->members();
        // A process may be within a step while the others notice that one is gone.
        group->rejoin(run, std::max(kMinRejoinTimeout_s, kRejoinTimeoutSteps * whole.longest_step_s));
    }
}

}  // namespace fastscene::nn

#include "fastscene/nn/training.h"

#include <chrono>
#include <cmath>
#include <future>
#include <numbers>
#include <optional>

#include "fastscene/base/file.h"
#include "fastscene/base/folder_lock.h"
#include "fastscene/base/forced_exit.h"
#include "fastscene/io/image_io.h"
#include "fastscene/nn/runtime.h"
#include "fastscene/nn/safetensors.h"
#include "fastscene/nn/process_group.h"
#include "fastscene/nn/training_beginning.h"
#include "fastscene/nn/training_log.h"

namespace fastscene::nn {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int kShares = 1'000'000;  // resolution of the progress display: each step of a long training is seen

double minutes_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count() / 60;
}

fs::path checkpoint_of(const fs::path& folder) { return folder / "checkpoint.safetensors"; }

NamedTensors whole_state(const TrainingTask& task) {
    NamedTensors all;
    for (const Learner* learner : task.learners)
        for (auto& item : learner->state()) all.push_back(std::move(item));
    return all;
}

void save_checkpoint(const TrainingTask& task, std::int64_t step, const fs::path& folder) {
    Weights out{checkpoint_of(folder), {}, {{"step", std::to_string(step)}}, {}};
    for (const Learner* learner : task.learners)
        for (const auto& [name, tensor] : learner->state_at_rest()) out.tensors[name] = weight_of(tensor);
    for (const Learner* learner : task.learners)
        out.metadata[learner->name() + ".steps"] = std::to_string(learner->steps());
    save_safetensors(checkpoint_of(folder), out);
}

std::int64_t metadata_number(const Weights& checkpoint, const std::string& name) {
    const auto found = checkpoint.metadata.find(name);
    if (found == checkpoint.metadata.end() || found->second.find_first_not_of("0123456789") != std::string::npos ||
        found->second.empty())
        throw Error("{}: expected a number as {} in its metadata, found {}", checkpoint.path.string(), name,
                    found == checkpoint.metadata.end() ? "none" : found->second);
    return std::stoll(found->second);
}

// The number of steps done; 0 in a new folder.
std::int64_t load_checkpoint(const TrainingTask& task, const fs::path& folder) {
    if (!fs::exists(checkpoint_of(folder))) return 0;
    const Weights checkpoint = load_weights(checkpoint_of(folder));
    load_into(whole_state(task), checkpoint);
    for (Learner* learner : task.learners) learner->set_steps(metadata_number(checkpoint, learner->name() + ".steps"));
    return metadata_number(checkpoint, "step");
}

// Records the settings in a new folder, or checks them against an existing one.
void settle_settings(const TrainingTask& task, const TrainingParams& params, const fs::path& folder, const Run& run) {
    Json wanted = lasting_settings(params);
    wanted["seed"] = run.seed;
    wanted.update(task.settings);
    const fs::path path = folder / "training.json";
    if (!fs::exists(path)) return write_json(path, wanted);
    const Json found = read_json(path);
    for (const auto& [name, value] : wanted.items())
        if (!found.contains(name) || found[name] != value)
            throw UsageError(
                "{}: expected a training with {} = {}, found {}: use the same settings to resume, or another folder",
                path.string(), name, value.dump(), found.contains(name) ? found[name].dump() : "none");
}

// Broadcasts the first process's state, including its checkpoint, to the group.
std::int64_t same_beginning(const TrainingTask& task, std::int64_t step, const ProcessGroup& group) {
    std::vector<at::Tensor> tensors;
    for (const auto& [name, tensor] : whole_state(task)) tensors.push_back(tensor);
    group.from_first(tensors);
    for (Learner* learner : task.learners) {
        learner->set_steps(group.from_first(learner->steps()));
        learner->join(group);
    }
    return group.from_first(step);
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
        : task_(task), seed_(seed), processes_(group ? group->size() : 1), process_(group ? group->process() : 0) {}
    Batch at(std::int64_t step, bool another_follows) {
        Batch now = next_.valid() ? next_.get() : draw(step);
        if (another_follows) next_ = std::async(std::launch::async, [this, step] { return draw(step + 1); });
        return now;
    }

  private:
    Batch draw(std::int64_t step) const {
        Random rng(seed_, "training step", static_cast<std::uint64_t>(step * processes_ + process_));
        return task_.draw(rng);
    }
    const TrainingTask& task_;
    std::uint64_t seed_;
    std::int64_t processes_, process_;
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

}  // namespace

double learning_rate_at(const TrainingParams& params, std::int64_t step) {
    const double warm = params.warmup > 0 ? std::min(1.0, static_cast<double>(step + 1) / params.warmup) : 1.0;
    const double share = std::min(1.0, static_cast<double>(step) / params.steps);
    return warm * (params.final_learning_rate + (params.learning_rate - params.final_learning_rate) * 0.5 *
                                                    (1 + std::cos(std::numbers::pi * share)));
}

TrainingOutcome train(const TrainingTask& task, const TrainingParams& params, const fs::path& folder, const Run& run) {
    use_our_threads();
    const std::unique_ptr<ProcessGroup> group = ProcessGroup::meet(params);
    const bool keeps = !group || group->process() == 0;  // only the first process writes
    std::optional<FolderLock> lock;
    if (keeps) {
        make_directories(folder / "sheets");
        lock.emplace(folder);
        settle_settings(task, params, folder, run);
    }
    std::int64_t first = keeps ? load_checkpoint(task, folder) : 0;
    if (group) first = same_beginning(task, first, *group);
    TrainingOutcome outcome{first, first >= params.steps, {}};
    std::optional<TrainingLog> log;
    if (keeps) log.emplace(folder, first);
    const double minutes_before = log ? log->minutes() : 0;
    const Clock::time_point begin = Clock::now();
    if (first > 0) run.note(fmt::format("training: resuming after step {}", first));

    Means means;
    const auto log_now = [&](const Numbers& more = {}) {
        if (!log) return;
        const ExitHold hold;
        if (!means.empty()) log->add(outcome.steps, minutes_before + minutes_since(begin), means.take());
        log->add(outcome.steps, minutes_before + minutes_since(begin), more);
        log->save();
    };
    const auto evaluate_now = [&] {
        if (!keeps) return;
        const Evaluation evaluation = task.evaluate();
        outcome.held_out = evaluation.held_out;
        Numbers named;
        for (const auto& [name, value] : evaluation.held_out) named.emplace_back(std::string(kHeldOut) + name, value);
        log_now(named);
        if (!evaluation.sheet.empty())
            save_png(folder / "sheets" / fmt::format("{:08}.png", outcome.steps), evaluation.sheet);
        run.note(fmt::format("training: step {}, held out: {}", outcome.steps, text_of(evaluation.held_out)));
    };
    const auto keep = [&] {
        const ExitHold hold;
        for (Learner* learner : task.learners) learner->rest();
        if (keeps) save_checkpoint(task, outcome.steps, folder);
    };
    // A step may take minutes. A forced exit within one keeps those before it: until the step's first update the
    // weights are as after the last one, and from there to its end nothing can force the exit.
    std::optional<ExitHold> updating;
    const UpdateCalls calls(task.learners, [&updating] {
        if (!updating) updating.emplace();
    });
    const ExitDuty save([&] {
        if (!keeps || outcome.steps == first) return;
        log_now();
        save_checkpoint(task, outcome.steps, folder);
    });
    // All processes end after the same step: the first one's clock and user decide.
    enum : std::int64_t { goes_on, time_is_up, stopped };
    const auto now_what = [&] {
        const bool up = params.minutes > 0 && minutes_since(begin) >= params.minutes;
        const std::int64_t mine = run.stop.stop_requested() ? stopped : up ? time_is_up : goes_on;
        return group ? group->from_first(mine) : mine;
    };

    Drawer drawer(task, run.seed, group.get());
    Clock::time_point kept = begin;
    std::optional<TrainingBeginning> beginning;
    if (!outcome.finished) beginning.emplace(task, params, first, run);
    if (first == 0 || outcome.finished) evaluate_now();
    Progress progress(run, "training", kShares);
    if (beginning) beginning->first_step();
    for (int shown = 0; outcome.steps < params.steps;) {
        const std::int64_t now_to_do = now_what();
        if (now_to_do == stopped) {
            log_now();
            keep();
            throw Stopped();
        }
        if (now_to_do == time_is_up) break;
        means.add(task.step(drawer.at(outcome.steps, outcome.steps + 1 < params.steps), outcome.steps,
                            learning_rate_at(params, outcome.steps)));
        ++outcome.steps;
        for (Learner* learner : task.learners) learner->rest();
        updating.reset();
        beginning.reset();
        outcome.finished = outcome.steps == params.steps;
        if (outcome.steps % params.eval_steps == 0 && !outcome.finished) try {
                evaluate_now();
            } catch (const Stopped&) {
                keep();
                throw;
            }
        else if (outcome.steps % params.log_steps == 0) log_now();
        if (minutes_since(kept) >= params.checkpoint_minutes && !outcome.finished) {
            keep();
            kept = Clock::now();
        }
        const double share = std::max(
            static_cast<double>(outcome.steps - first) / static_cast<double>(params.steps - first),
            params.minutes > 0 ? minutes_since(begin) / params.minutes : 0.0);
        const int now = std::min(kShares, static_cast<int>(share * kShares));
        if (now > shown) progress.advance(now - shown);
        shown = std::max(shown, now);
    }
    if (outcome.steps > first) {
        keep();
        evaluate_now();
    }
    return outcome;
}

}  // namespace fastscene::nn

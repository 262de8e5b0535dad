#include "fastscene/pipeline/stage_events.h"

#include <cmath>

namespace fastscene {
namespace {

// Shares of the run time, between those of a draft and of a standard run, and the number of progress tasks per stage.
// Measured; used only for the estimated remaining time.
struct StagePlan {
    std::string_view stage;
    double share;
    double first_work;  // share of the stage's time spent in its first task
};
constexpr StagePlan kPlan[] = {
    {"panorama", 0.35, 0.75}, {"depth", 0.01, 1}, {"walk", 0.11, 1}, {"views", 0.07, 1}, {"splat", 0.46, 1}};

}  // namespace

StageEvents::StageEvents(std::string_view stage, std::string_view last_stage, EventSink* sink)
    : stage_(stage), sink_(sink) {
    double total = 0;
    for (const StagePlan& plan : kPlan) {
        if (plan.stage == stage) begin_ = total, share_ = plan.share;
        total += plan.share;
        if (plan.stage == last_stage) break;
    }
    begin_ /= total;
    share_ /= total;
}

double StageEvents::overall(const ProgressEvent& event) {
    const std::lock_guard guard(mutex_);
    if (event.work != work_) {
        work_ = event.work;
        ++works_before_;
    }
    double first = 1;
    for (const StagePlan& plan : kPlan)
        if (plan.stage == stage_) first = plan.first_work;
    // Each task takes that share of what the previous ones left, so progress never goes back.
    const double left_over = std::pow(1 - first, works_before_);
    const double done = static_cast<double>(event.done) / static_cast<double>(event.total);
    const bool last_work = works_before_ > 0;
    return begin_ + share_ * (1 - left_over + left_over * (last_work ? 1 : first) * done);
}

void StageEvents::tell(const Event& event) {
    if (!sink_) return;
    if (const auto* progress = std::get_if<ProgressEvent>(&event)) {
        const std::string work = progress->work == stage_ ? stage_ : stage_ + ": " + progress->work;
        sink_->tell(ProgressEvent{work, progress->done, progress->total, overall(*progress)});
    } else {
        sink_->tell(event);
    }
}

}  // namespace fastscene

// The part that backends on the processor share: steps that are done when step() returns, on the caller's cloud.
#pragma once

#include <utility>

#include "fastscene/splat/backend.h"

namespace fastscene::splat {

class HostStepper : public Stepper {
  public:
    std::string device() const override { return "processor"; }
    void load(const Cloud&) override {}
    void set_views(std::vector<const View*> views, DepthOf depth_of) override {
        views_ = std::move(views), depth_of_ = std::move(depth_of);
    }
    void step(Cloud& cloud, std::size_t view, const StepPlan& plan) override {
        const View& v = *views_[view];
        losses_.push_back(step_now(cloud, v, depth_of_ ? &depth_of_(v) : nullptr, plan));
    }
    bool relocate(float, const Relocation&, std::uint64_t, int) override { return false; }
    std::vector<LossSums> losses() override { return std::exchange(losses_, {}); }
    void store(Cloud&) override {}

  private:
    virtual LossSums step_now(Cloud& cloud, const View& view, const ImageF* depth, const StepPlan& plan) = 0;
    std::vector<const View*> views_;
    DepthOf depth_of_;
    std::vector<LossSums> losses_;
};

}  // namespace fastscene::splat

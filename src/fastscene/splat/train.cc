#include "fastscene/splat/train.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fastscene/base/random.h"
#include "fastscene/splat/relocate.h"
#include "fastscene/splat/stepper.h"

namespace fastscene::splat {
namespace {

// The view of each step: every view once, in random order, then again in another order.
class ViewOrder {
  public:
    ViewOrder(std::size_t count, std::uint64_t seed) : order_(count), seed_(seed) { std::iota(order_.begin(), order_.end(), std::size_t{0}); }
    std::size_t next() {
        if (at_ == 0) {
            Random random(seed_, "splat.views", round_++);
            for (std::size_t i = order_.size() - 1; i > 0; --i)
                std::swap(order_[i], order_[static_cast<std::size_t>(random.index(static_cast<int>(i) + 1))]);
        }
        const std::size_t view = order_[at_];
        at_ = (at_ + 1) % order_.size();
        return view;
    }

  private:
    std::vector<std::size_t> order_;
    std::uint64_t seed_, round_ = 0;
    std::size_t at_ = 0;
};

std::array<float, kParameters> rates_at(float done, const SplatParams& params, const TrainTuning& t) {
    const float other = std::pow(t.other_end, done);
    const float mean = params.learning_rate_mean_m * std::pow(t.mean_end, done);
    const float scale = t.scale * other, rotation = t.rotation * other, logit = t.logit * other, sh0 = t.sh0 * other;
    return {mean, mean, mean, scale, scale, scale, rotation, rotation, rotation, rotation, logit, sh0, sh0, sh0};
}

// Means over the steps since the last point.
class Curve {
  public:
    void add(const LossSums& s) { loss_ += s.loss, squared_error_ += s.squared_error, ++steps_; }
    void close(int step, std::vector<CurvePoint>& out) {
        if (!steps_) return;
        const double mse = std::max(squared_error_ / steps_, 1e-10);
        out.push_back({step, static_cast<float>(loss_ / steps_), static_cast<float>(-10 * std::log10(mse))});
        *this = {};
    }

  private:
    double loss_ = 0, squared_error_ = 0;
    int steps_ = 0;
};

void check_views(const ViewSet& set) {
    if (set.views.empty()) throw Error("splat: no views to train on");
    for (const View& v : set.views) {
        if (v.color.empty() || v.color.width != v.camera.width || v.color.height != v.camera.height)
            throw Error("splat: view {}: camera is {}x{}, picture is {}x{}", v.name, v.camera.width, v.camera.height, v.color.width, v.color.height);
        if (!v.weight.empty() && !v.weight.same_size(v.color))
            throw Error("splat: view {}: weights are {}x{}, picture is {}x{}", v.name, v.weight.width, v.weight.height, v.color.width, v.color.height);
    }
}

}  // namespace

FittedSplats fit(const ViewSet& set, const SplatParams& params, const TrainTuning& tuning, const Run& run) {
    check_views(set);
    const Splats start = initial_splats(set.points, params.count, run);
    if (start.size() == 0) throw Error("splat: no usable starting points among {}", set.points.size());
    Cloud cloud(start, true);
    const std::unique_ptr<Stepper> stepper = make_stepper(params.backend);
    ViewOrder order(set.views.size(), run.seed);
    Progress progress(run, "splat", params.steps);
    FittedSplats out;
    Curve curve;
    constexpr int kCurveSteps = 50;
    // A splat is useless only if no view needs it: judge after every view has been seen.
    const int relocate_every = std::max(tuning.relocate_every, static_cast<int>(set.views.size()));
    for (int step = 1; step <= params.steps; ++step) {
        run.check_stop();
        const View& view = set.views[order.next()];
        const float done = static_cast<float>(step - 1) / static_cast<float>(params.steps);
        curve.add(stepper->step(cloud, view, params.lambda_dssim, rates_at(done, params, tuning), step));
        if (step % relocate_every == 0 && done < tuning.relocate_until) relocate(cloud, {tuning.relocate_fraction}, run.seed, step);
        if (step % kCurveSteps == 0 || step == params.steps) curve.close(step, out.curve);
        progress.advance();
    }
    out.splats = cloud.splats();
    return out;
}

}  // namespace fastscene::splat

namespace fastscene {

FittedSplats fit_splats(const ViewSet& views, const SplatParams& params, const Run& run) {
    check_fields("splat", params);
    return splat::fit(views, params, {}, run);
}

}  // namespace fastscene

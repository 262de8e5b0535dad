// One training step, the common interface of the backends: "cpu" is Engine, "reference" the slow reference
// implementation.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "fastscene/scene/view.h"
#include "fastscene/splat/engine.h"

namespace fastscene::splat {

struct StepPlan {
    float lambda_dssim = 0.2f;
    Vec3f background;
    StepRates rates;
    const ImageF* depth = nullptr;  // target depth of the view (depth_loss.h), or null
    float depth_strength = 0;
    float outside_m = std::numeric_limits<float>::infinity();  // Engine::set_outside
    float alpha_strength = 0;                                  // weight of the mean remaining transmittance
    bool judge = true;  // whether to collect statistics for density control: each splat's blending weight and error
};
struct Stepper {
    virtual ~Stepper() = default;
    // Renders the view, backpropagates and applies Adam.
    virtual LossSums step(Cloud& cloud, const View& view, const StepPlan& plan) = 0;
};
// Throws UsageError for an unknown backend.
std::unique_ptr<Stepper> make_stepper(const std::string& backend);

}  // namespace fastscene::splat

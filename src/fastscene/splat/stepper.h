// One training step, behind one door for the backends: "cpu" is Engine, "reference" the slow ruler.
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
    const ImageF* depth = nullptr;  // what the view should show (depth_loss.h), or null
    float depth_strength = 0;
    float outside_m = std::numeric_limits<float>::infinity();  // Engine::set_outside
    float alpha_strength = 0;                                  // of the mean transmittance left
    bool judge = true;  // whether what density control asks for is summed up: how much each splat shows, and what error
};
struct Stepper {
    virtual ~Stepper() = default;
    // Renders the view, differentiates, lets Adam move the cloud.
    virtual LossSums step(Cloud& cloud, const View& view, const StepPlan& plan) = 0;
};
// Throws UsageError when there is no such backend.
std::unique_ptr<Stepper> make_stepper(const std::string& backend);

}  // namespace fastscene::splat

// One training step, behind one door for the backends: "cpu" is Engine, "reference" the slow ruler.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "fastscene/scene/view.h"
#include "fastscene/splat/engine.h"

namespace fastscene::splat {

struct Stepper {
    virtual ~Stepper() = default;
    // Renders the view on black, differentiates, lets Adam move the cloud. adam_step counts from 1.
    virtual LossSums step(Cloud& cloud, const View& view, float lambda_dssim, const std::array<float, kParameters>& rates, int adam_step) = 0;
};
// Throws UsageError when there is no such backend.
std::unique_ptr<Stepper> make_stepper(const std::string& backend);

}  // namespace fastscene::splat

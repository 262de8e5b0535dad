#include "fastscene/nn/sphere_embedding.h"

#include <ATen/ATen.h>

#include <cmath>
#include <numbers>

namespace fastscene::nn {

using at::Tensor;

namespace {

constexpr double kTurn = 6.2832, kHalfTurn = 3.1416;  // as published: these digits, not pi's
constexpr double kLeastAhead = 1e-5;                  // z is at least this far from 0

Tensor pixels(std::int64_t count, std::int64_t step) { return at::arange(count, at::kDouble) * step + 0.5; }

}  // namespace

Tensor sphere_directions(std::int64_t height, std::int64_t width, const SphereSize& sphere, std::int64_t step) {
    const auto angle = [step](std::int64_t count, double size, double whole) {
        return (pixels(count, step) - size / 2) / size * whole;
    };
    const Tensor longitude = angle(width, sphere.width, kTurn).view({1, width}),
                 latitude = angle(height, sphere.height, kHalfTurn).view({height, 1}), level = latitude.cos();
    return at::stack({level * longitude.sin(), latitude.sin().expand({height, width}), level * longitude.cos()})
        .unsqueeze(0);
}

// Beyond the sphere (SphereSize) the angles fold and wrap, as published.
Tensor sphere_angles(const Tensor& directions) {
    const Tensor d = directions.flatten(2).select(0, 0), x = d.select(0, 0), y = d.select(0, 1), z = d.select(0, 2);
    const Tensor ahead = at::where(z < 0, at::clamp_max(z, -kLeastAhead), at::clamp_min(z, kLeastAhead));
    return at::stack({at::asin(at::clamp(y, -1, 1)), at::atan2(x, ahead)}, 1).unsqueeze(0);
}

Tensor sphere_embedding(const Tensor& angles, std::int64_t count, std::int64_t highest) {
    const Tensor frequencies =
        at::exp2(at::linspace(0, std::log2(static_cast<double>(highest)), count, angles.options())) * std::numbers::pi;
    return at::sin(angles.unsqueeze(3) * frequencies).flatten(2).to(at::kFloat);
}

}  // namespace fastscene::nn

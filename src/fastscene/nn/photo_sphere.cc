#include "fastscene/nn/photo_sphere.h"

#include <cmath>
#include <numbers>

#include "fastscene/base/error.h"
#include "fastscene/nn/clip_image.h"
#include "fastscene/nn/sd_model.h"

namespace fastscene::nn {

using at::Tensor;

PhotoOnSphere photo_on_sphere(const ImageRgb8& photo, int width, double fov_deg) {
    if (photo.width < 16 || photo.height < 16)
        throw Error("--photo: expected a picture of at least 16 x 16 pixels, found {} x {}", photo.width, photo.height);
    const int height = width / 2;
    const double half_width = std::tan(fov_deg / 360 * std::numbers::pi),
                 half_height = half_width * photo.height / photo.width;
    const Tensor lon = ((at::arange(width, at::kFloat) + 0.5) / width - 0.5) * (2 * std::numbers::pi);
    const Tensor lat = (0.5 - (at::arange(height, at::kFloat) + 0.5) / height) * std::numbers::pi;
    const Tensor forward = at::cos(lat).unsqueeze(1) * at::cos(lon).unsqueeze(0);
    const Tensor right = at::cos(lat).unsqueeze(1) * at::sin(lon).unsqueeze(0),
                 down = (-at::sin(lat)).unsqueeze(1).expand({height, width});
    const Tensor u = right / forward / half_width, v = down / forward / half_height;  // -1 to 1 across the photo
    const Tensor inside = (forward > 0).logical_and(u.abs() <= 1).logical_and(v.abs() <= 1);
    const Tensor place = at::where(inside.unsqueeze(-1), at::stack({u, v}, -1), at::zeros({1}));
    constexpr std::int64_t bilinear = 0, border = 1;
    const Tensor seen = at::grid_sampler(unit_picture(photo), place.unsqueeze(0), bilinear, border, false);
    const Tensor mask = inside.to(at::kFloat).unsqueeze(0).unsqueeze(0);
    return {mask * seen + (1 - mask) * unit_picture(pillow_bicubic(photo, width, height)), mask};
}

}  // namespace fastscene::nn

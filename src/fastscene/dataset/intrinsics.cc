#include "fastscene/dataset/intrinsics.h"

#include <algorithm>
#include <cmath>

#include "fastscene/image/color.h"

namespace fastscene::dataset {
namespace {

// The least that a channel of an albedo becomes: 0.24 %. Black would hide the light; and shading fits 16-bit floats.
constexpr std::uint8_t kDarkestAlbedo = 8;

}  // namespace

Intrinsics intrinsics_of(const ImageColor& radiance, const ImageColor& albedo, const ImageMask& has_albedo,
                         const Look& look) {
    Intrinsics out{ImageRgb8(radiance.width, radiance.height), ImageColor(radiance.width, radiance.height)};
    const float gain = std::exp2(look.exposure_ev);
    for (std::size_t i = 0; i < radiance.size(); ++i) {
        const Vec3f exposed = radiance.pixels[i] * gain;
        const Vec3f light{exposed.x / look.white.x, exposed.y / look.white.y, exposed.z / look.white.z};
        out.shading.pixels[i] = light;
        if (!has_albedo.pixels[i]) continue;
        Rgb8 a = srgb8_from_linear(albedo.pixels[i]);
        a = {std::max(a.r, kDarkestAlbedo), std::max(a.g, kDarkestAlbedo), std::max(a.b, kDarkestAlbedo)};
        out.albedo.pixels[i] = a;
        const Vec3f by = linear_from_srgb8(a);
        out.shading.pixels[i] = {light.x / by.x, light.y / by.y, light.z / by.z};
    }
    return out;
}

}  // namespace fastscene::dataset

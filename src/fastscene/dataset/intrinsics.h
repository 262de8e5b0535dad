// A picture taken apart: albedo times shading is the light that the camera's film gets (exposed and white balanced,
// linear).
#pragma once

#include "fastscene/image/image.h"
#include "fastscene/scene/room.h"

namespace fastscene::dataset {

struct Intrinsics {
    ImageRgb8 albedo;    // sRGB; black: none
    ImageColor shading;  // linear; where there is no albedo, the light itself
};
// `albedo`: linear. `has_albedo`: of each pixel; not the outside, light sources, mirrors. The shading is that of the
// albedo as rounded to 8 bits, so that their product is exact.
Intrinsics intrinsics_of(const ImageColor& radiance, const ImageColor& albedo, const ImageMask& has_albedo,
                         const Look& look);

}  // namespace fastscene::dataset

// Stills: one picture of splats through a flat camera, or of the whole sphere.
#pragma once

#include "fastscene/geometry/pinhole.h"
#include "fastscene/image/image.h"
#include "fastscene/math/rigid.h"
#include "fastscene/scene/splats.h"

namespace fastscene {

struct Still {
    ImageRgb8 color;
    ImageMask alpha;   // 255 where the splats hide all that lies behind
    ImageF distance;   // metres; flat: along the optical axis (depth_z), sphere: along the ray (range); 0 where nothing is
};

// On `background` (sRGB, 0..1).
Still still_of(const Splats& splats, const Pinhole& camera, const Rigid& world_from_camera, Vec3f background = {});
// Equirectangular, width = 2 height: six flat pictures put together.
Still sphere_of(const Splats& splats, int width, const Rigid& world_from_pano, Vec3f background = {});

}  // namespace fastscene

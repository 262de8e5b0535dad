// Picture: a room's light as a camera sees it.
#pragma once

#include <functional>

#include "fastscene/base/run.h"
#include "fastscene/image/image.h"
#include "fastscene/math/rigid.h"
#include "fastscene/trace/path.h"
#include "fastscene/trace/shade.h"
#include "fastscene/trace/trace.h"

namespace fastscene {

// Where a pixel's samples look, and how wide they are.
struct RayCamera {
    Rigid world_from_camera;
    int width = 0, height = 0;
    std::function<Vec3f(Vec2f)> direction;  // camera frame, any length
    float pixel_angle = 0;
    bool panorama = false;  // its columns wrap, and crowd towards the poles
};
RayCamera panorama_camera(const Rigid& world_from_pano, EquirectSize size);
RayCamera perspective_camera(const Rigid& world_from_camera, const Pinhole& camera);
Vec3f world_direction(const RayCamera& camera, Vec2f pixel);
inline bool is_asked_for(const ShotParts& parts, int x, int y) { return !parts.only || parts.only->at(x, y) != 0; }

// `samples` rays a pixel at most (ShotParts::noise, ::denoise). Radiances, or developed color when `look` is given;
// `albedo`: filled when given.
ImageColor cached_picture(const ShadeScene& scene, const RayCamera& camera, const ShotParts& parts, int samples,
                          const Look* look, ImageColor* albedo, const Run& run);
// The same by plain path tracing. Radiances are averaged over the pixel before they are developed.
ImageColor path_traced_picture(const PathScene& scene, const RayCamera& camera, const ShotParts& parts, int samples,
                               const Look* look, const Run& run);

}  // namespace fastscene

// Renders a picture of a room, from the irradiance cache or by path tracing.
#pragma once

#include <functional>

#include "fastscene/base/run.h"
#include "fastscene/image/image.h"
#include "fastscene/math/rigid.h"
#include "fastscene/trace/path.h"
#include "fastscene/trace/shade.h"
#include "fastscene/trace/trace.h"

namespace fastscene {

// Generates the camera rays of a picture.
struct RayCamera {
    Rigid world_from_camera;
    int width = 0, height = 0;
    std::function<Vec3f(Vec2f)> direction;  // by pixel position; camera frame, any length
    float pixel_angle = 0;
    bool panorama = false;                    // equirectangular: columns wrap, and crowd towards the poles
    std::function<Vec3f(Vec2f)> offset = {};  // of a ray's start, by pixel position; camera frame; empty: none
    // The same as plain data.
    Pinhole pinhole = {};  // of a perspective picture
    float eye_m = 0;       // of a panorama: offset to the right (TracedRoom::eye_panorama)
};
RayCamera panorama_camera(const Rigid& world_from_pano, EquirectSize size, float eye_m = 0);
RayCamera perspective_camera(const Rigid& world_from_camera, const Pinhole& camera);
Vec3f world_direction(const RayCamera& camera, Vec2f pixel);
// Where the ray through a pixel position starts.
Vec3f world_origin(const RayCamera& camera, Vec2f pixel);
inline bool is_asked_for(const ShotParts& parts, int x, int y) { return !parts.only || parts.only->at(x, y) != 0; }

// Renders from the cache with at most `samples` rays per pixel (ShotParts::noise, ::denoise). Returns radiance, or
// developed color if `look` is given; fills `albedo` if given.
ImageColor cached_picture(const ShadeScene& scene, const RayCamera& camera, const ShotParts& parts, int samples,
                          const Look* look, ImageColor* albedo, const Run& run);
// The same by path tracing. Radiance is averaged over the pixel before tone mapping.
ImageColor path_traced_picture(const PathScene& scene, const RayCamera& camera, const ShotParts& parts, int samples,
                               const Look* look, const Run& run);

}  // namespace fastscene

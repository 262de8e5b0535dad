// Renders a picture of a room, from the irradiance cache or by path tracing.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

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

class PixelTracer;  // pixel_tracer.h
struct PixelPlan;
using MakePixelTracer = std::function<std::unique_ptr<PixelTracer>(const PixelPlan&)>;

// The keys of a picture's random numbers, before a pixel's place is mixed in.
std::uint64_t picture_key(std::uint64_t seed);
std::uint64_t path_picture_key(std::uint64_t seed);

// Renders from the cache with at most `samples` rays per pixel (ShotParts::noise, ::denoise). Returns radiance, or
// developed color if `look` is given; fills `albedo` if given. `make`: makes what traces the rays; empty: Embree does.
ImageColor cached_picture(const ShadeScene& scene, const RayCamera& camera, const ShotParts& parts, int samples,
                          const Look* look, ImageColor* albedo, const Run& run, const MakePixelTracer& make = {});
// The same by path tracing. Radiance is averaged over the pixel before tone mapping.
ImageColor path_traced_picture(const PathScene& scene, const RayCamera& camera, const ShotParts& parts, int samples,
                               const Look* look, const Run& run);
// The picture of `sums` of `samples` paths a pixel.
ImageColor developed_paths(ImageColor sums, const ShotParts& parts, int samples, const Look* look);

}  // namespace fastscene

// Trace: looks at a Room. Path traced light (Embree), gathered once per room into a world-space
// irradiance cache that all views share, so that any number of exact pictures of one room agree with
// each other; sun, mirror-like reflection and emission are traced per view.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "fastscene/base/fields.h"
#include "fastscene/base/run.h"
#include "fastscene/geometry/pinhole.h"
#include "fastscene/image/image.h"
#include "fastscene/scene/panorama.h"
#include "fastscene/scene/room.h"

namespace fastscene {

struct TraceParams {
    float cell_m = 0.03f;     // size of an irradiance cell
    int cell_samples = 192;   // gathered paths per cell
    int pixel_samples = 16;   // camera rays per pixel
    bool keep_noise = false;  // panoramas are not denoised
};
template <class V>
void visit_fields(TraceParams& p, V&& v) {
    v("cell", p.cell_m, Bounds{0.005, 0.5}, "Size in metres of a cell of the irradiance cache.");
    v("cell-samples", p.cell_samples, Bounds{1, 65536}, "Light paths gathered in each cell.");
    v("pixel-samples", p.pixel_samples, Bounds{1, 4096}, "Camera rays a pixel.");
    v("keep-noise", p.keep_noise, "Leave the panorama's light as its rays found it: no denoiser.");
}

// Everything the first hit tells, per pixel. Each picture is empty unless asked for.
struct Shot {
    ImageColor color;  // linear, display-referred (after exposure and film curve), clamped to 0..1
    ImageF range;      // metres along the ray through the pixel's center; +inf where the ray leaves the room
    ImageF
        mirrored_range;  // the same to the virtual image where the ray meets a flat mirror: metres on to what it shows
    ImageColor albedo;   // mean over the pixel
    ImageColor normal;   // world, unit, of the center ray
    Image<std::int32_t> object;  // index into Room::objects of the center ray's hit; -1 = shell, -2 = outside
};
struct ShotParts {
    bool color = true, range = true, mirrored_range = false, albedo = false, normal = false, object = false;
    int pixel_samples = 0;  // camera rays a pixel; 0 = TraceParams::pixel_samples
    bool paths = false;     // plain path tracing: no cache, nothing shared between pixels; for measurements
    bool radiance = false;  // `color` holds the pixel's mean radiance, undeveloped
    bool contacts =
        false;  // where the cache is too coarse (edges, corners, small things) light is gathered for the very pixel
    bool frugal = false;  // reflections that add little are traced by a few rays only (Russian roulette): for many
                          // views that are averaged
    float min_alpha = 0;  // glossy surfaces, but mirrors, have at least this GGX alpha: what a coarse representation of
                          // reflections can hold
    bool denoise = false;  // average over neighbours what chance leaves in the light (denoise.h); takes samples / 16 to
                           // samples / 2 rays
    float noise = 0.f;  // > 0: stop a pixel's rays, 16 at a time, once the error of its mean is below this (sRGB, 0..1)
    const ImageMask* only =
        nullptr;  // of the picture's size: the pixels that are asked for (nonzero); what the others hold means nothing
};

// For pictures of final quality: as many camera rays as each pixel needs, `samples` at most; an even wall is exact at
// once, an outline is not.
inline ShotParts final_parts(int samples = 128) {
    return {.color = true, .range = true, .pixel_samples = samples, .contacts = true, .denoise = true, .noise = 0.006f};
}

// A room ready to be looked at: triangles in Embree, light in the cache, exposure fixed.
class TracedRoom {
  public:
    // Builds the BVH only; cheap (well under a second). The room is copied.
    explicit TracedRoom(Room room);
    ~TracedRoom();
    TracedRoom(TracedRoom&&) noexcept;
    TracedRoom& operator=(TracedRoom&&) noexcept;

    // Gathers the light (the long part) and fixes the exposure as seen from the world's origin. Needed before any
    // color. The same seed gives the same light for any number of threads. `viewpoints`: the places about which
    // pictures will be taken.
    void gather_light(const TraceParams& params, const Run& run, const std::vector<Vec3f>& viewpoints = {Vec3f{}});

    // `seed` varies the camera samples only; the light is the room's.
    Shot panorama(const Rigid& world_from_pano, EquirectSize size, const ShotParts& parts, const Run& run) const;
    Shot perspective(const Rigid& world_from_camera, const Pinhole& camera, const ShotParts& parts,
                     const Run& run) const;

    // The outside in every direction, as a camera sees it, as if no room stood around: linear light.
    ImageColor outside(const Mat3f& world_from_pano, EquirectSize size) const;

    // Distance in metres to the first surface along a ray; +inf = none. `direction` of length 1.
    float distance(Vec3f origin, Vec3f direction) const;
    // The first surface along a ray (`direction` of length 1), through clear glass: its distance in metres and its unit
    // normal, turned towards the ray's origin. +inf and zero: none.
    struct Surface {
        float distance;
        Vec3f normal;
    };
    Surface surface(Vec3f origin, Vec3f direction) const;
    // Along a ray, on through flat mirrors as a picture shows it: metres to the image behind the mirror; +inf = none.
    float distance_through_mirrors(Vec3f origin, Vec3f direction) const;
    // Whether nothing but clear glass is between two points. The last millimetres before `to` do not count: it may lie
    // on a surface.
    bool sees(Vec3f from, Vec3f to) const;
    // Radius of the empty ball around a point (0 inside an object), up to `limit_m`.
    float clearance(Vec3f point, float limit_m) const;

    const Room& room() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace fastscene

// Trace: renders a Room. Diffuse light is computed once per room (Embree, irradiance cache) and shared by all views, so
// that any number of renderings agree with each other; direct sun, specular reflection and emission are traced per
// view.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/base/fields.h"
#include "fastscene/base/run.h"
#include "fastscene/geometry/pinhole.h"
#include "fastscene/image/image.h"
#include "fastscene/scene/panorama.h"
#include "fastscene/scene/room.h"

namespace fastscene {

// The backends that there are (trace/trace_backends/), and a sentence about each for --help.
std::vector<std::string> trace_backend_names();
const std::string& about_trace_backends();

// What renders rooms.
struct TraceBackend {
    std::string name = "cpu";
    std::string device = "auto";  // of vulkan (gpu::choose_device)
};
template <class V>
void visit_fields(TraceBackend& b, V&& v) {
    v("trace-backend", b.name, Choices{trace_backend_names()}, about_trace_backends());
    v("trace-device", b.device,
      "vulkan: the graphics card, by number or part of its name; auto: the one with the most memory; list: names "
      "them.");
}

struct TraceParams {
    float cell_m = 0.03f;        // size of an irradiance cache cell
    int cell_samples = 192;      // paths gathered per cell
    int pixel_samples = 16;      // camera rays per pixel
    bool keep_noise = false;     // leave panoramas undenoised
    float outside_detail = 8.f;  // pixels per degree of the view through the windows, at the horizon
    std::string view_transform = "photo";
    float exposure_ev = 0.f;  // added to the automatic exposure, stops
    TraceBackend backend = {};
};
// Names of ViewTransform, in its order.
inline constexpr std::array<const char*, 3> kViewTransforms{"photo", "soft", "linear"};
template <class V>
void visit_fields(TraceParams& p, V&& v) {
    v("cell", p.cell_m, Bounds{0.005, 0.5}, "Cell size of the irradiance cache in metres; larger in halls.");
    v("cell-samples", p.cell_samples, Bounds{1, 65536}, "Light paths gathered per cell.");
    v("pixel-samples", p.pixel_samples, Bounds{1, 4096}, "Camera rays per pixel.");
    v("keep-noise", p.keep_noise, "Do not denoise the panorama.");
    v("outside-detail", p.outside_detail, Bounds{0, 40},
      "Pixels per degree of the view through the windows; 0: a blurred one.");
    v("view-transform", p.view_transform, Choices{{kViewTransforms.begin(), kViewTransforms.end()}},
      "How scene light becomes display color. photo: a photograph's contrast, with highlights that roll off into "
      "white; soft: less contrast, for editing afterwards; linear: clipped at white.");
    v("exposure", p.exposure_ev, Bounds{-5, 5},
      "Exposure compensation in stops, added to the automatic exposure; negative: darker.");
    visit_fields(p.backend, v);
}

// Per-pixel results of a rendering. Each image is empty unless requested in ShotParts.
struct Shot {
    ImageColor color;            // linear, display-referred (after exposure and film curve), clamped to 0..1
    ImageF range;                // metres along the ray through the pixel's center; +inf where it leaves the room
    ImageF mirrored_range;       // the same, but through flat mirrors: metres to the virtual image that they show
    ImageColor albedo;           // mean over the pixel
    ImageColor normal;           // world frame, unit, of the center ray
    Image<std::int32_t> object;  // center ray: index into Room::objects; -1 = walls, floor, ceiling, -2 = outside
    Image<std::int32_t> mesh;    // center ray: index into Room::meshes; -1 = outside
};
struct ShotParts {
    bool color = true, range = true, mirrored_range = false, albedo = false, normal = false, object = false,
         mesh = false;
    int pixel_samples = 0;  // camera rays per pixel; 0 = TraceParams::pixel_samples
    bool paths = false;     // path tracing: no cache, pixels are independent; the reference for measurements
    bool radiance = false;  // `color` holds mean radiance, without tone mapping
    bool contacts = false;  // sample the light per pixel where the cache is too coarse (edges, corners, small objects)
    bool frugal = false;    // Russian roulette on weak reflections: for many views whose noise averages out
    // minimum GGX alpha of glossy surfaces except mirrors: as sharp as the representation trained on the views can hold
    float min_alpha = 0;
    bool denoise = false;  // denoise the light (denoise.h); takes samples / 16 to samples / 2 rays per pixel
    // denoise only what glossy surfaces reflect, as far as `pixel_samples` rays of each pixel show it: for training
    // views, whose other noise averages out. A splat fits the specks of single views with its harmonics.
    bool denoise_reflections = false;
    // > 0: adaptive sampling, 16 rays at a time, until the standard error of the pixel's mean is below this (sRGB,
    // 0..1)
    float noise = 0.f;
    const ImageMask* only = nullptr;  // of the picture's size: pixels to render (nonzero); all others are undefined
};

// For final quality: adaptive sampling with at most `samples` rays per pixel; even walls need few, outlines many.
inline ShotParts final_parts(int samples = 128) {
    return {.color = true, .range = true, .pixel_samples = samples, .contacts = true, .denoise = true, .noise = 0.006f};
}

// A room ready to be rendered: BVH, irradiance cache and exposure.
class TracedRoom {
  public:
    // Builds the BVH only (well under a second). Copies the room.
    explicit TracedRoom(Room room);
    ~TracedRoom();
    TracedRoom(TracedRoom&&) noexcept;
    TracedRoom& operator=(TracedRoom&&) noexcept;

    // Computes the irradiance cache (the slow part) and fixes the exposure as seen from the world's origin. Required
    // before any color is rendered. The same seed gives the same light for any number of threads. `viewpoints`:
    // positions around which pictures will be taken.
    void gather_light(const TraceParams& params, const Run& run, const std::vector<Vec3f>& viewpoints = {Vec3f{}});

    // The light, its exposure and the outside, for a file: 66 bytes a cache cell, 6 a pixel.
    std::string light() const;
    // Takes what light() gave for this room and these settings, instead of gathering: the pictures are the same.
    // Returns false if a graphics card renders, which gathers faster. Throws Error naming `name` for anything else.
    bool take_light(const TraceParams& params, std::string_view bytes, const std::string& name);
    // gather_light for a room that was changed from `before`, whose light was gathered with the same settings. Cells
    // that the change hardly concerns keep their light; the exposure stays, unless it would differ visibly. Returns the
    // share of cells that kept their light, in [0, 1]; 0 if lamps, windows or the outside changed.
    double gather_light_again(const TraceParams& params, const Run& run, const std::vector<Vec3f>& viewpoints,
                              const TracedRoom& before);

    // `seed` varies the camera samples only, not the light.
    Shot panorama(const Rigid& world_from_pano, EquirectSize size, const ShotParts& parts, const Run& run) const;
    Shot perspective(const Rigid& world_from_camera, const Pinhole& camera, const ShotParts& parts,
                     const Run& run) const;

    // Omnidirectional stereo: the panorama of one eye, exact in every column: its rays start `eye_m` metres to the
    // right of the pose's center as seen in that column's direction (negative: the left eye). Towards the poles, where
    // the two eyes would turn about each other, the offset fades (eye_offset).
    Shot eye_panorama(const Rigid& world_from_pano, EquirectSize size, float eye_m, const ShotParts& parts,
                      const Run& run) const;

    // The outside in all directions, as if there were no room: linear radiance as a camera sees it.
    ImageColor outside(const Mat3f& world_from_pano, EquirectSize size) const;

    // Distance in metres to the first surface along a ray; +inf: none. `direction`: unit length.
    float distance(Vec3f origin, Vec3f direction) const;
    // The first surface along a ray (`direction` of unit length), through clear glass: distance in metres, unit normal
    // facing the ray's origin, and index into Room::meshes. +inf, zero and -1: none.
    struct Surface {
        float distance;
        Vec3f normal;
        int mesh = -1;
    };
    Surface surface(Vec3f origin, Vec3f direction) const;
    // Metres along a ray, through flat mirrors to the virtual image that a picture shows there; +inf: none.
    float distance_through_mirrors(Vec3f origin, Vec3f direction) const;
    // Display color (as ShotParts::color) of surfaces, each seen from straight in front of it: `samples` rays each.
    // Needs light. For baking; a mirror shows what lies straight in front.
    struct FacedPoint {
        Vec3f position, normal;  // world; unit, out of the surface
        float width_m;           // of what is seen
    };
    std::vector<Vec3f> colors_faced(const std::vector<FacedPoint>& points, int samples, const Run& run) const;
    // Whether two points see each other, clear glass ignored. The last millimetres before `to` are ignored too: it may
    // lie on a surface.
    bool sees(Vec3f from, Vec3f to) const;
    // Radius of the largest empty ball around a point, at most `limit_m`; 0 inside an object.
    float clearance(Vec3f point, float limit_m) const;

    const Room& room() const;
    // What gathered the light and renders pictures: a graphics card with its driver; empty: the processor.
    std::string device() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace fastscene

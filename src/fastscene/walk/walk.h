// Walk: from one panorama with range to many, at exactly known positions. Paper: CVS (coarse view synthesis: warp to a
// new position, mark holes) and PNVI (progressive novel view inpainting).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "fastscene/base/fields.h"
#include "fastscene/base/json.h"
#include "fastscene/base/run.h"
#include "fastscene/inpaint/inpaint.h"
#include "fastscene/scene/panorama.h"

namespace fastscene {

struct WalkParams {
    std::string kind = "auto";
    // "room": renderings of a known room.
    int room_viewpoints = 24;  // maximum number, besides panorama 0
    int width = 0;             // of a viewpoint's panorama; 0: as panorama 0
    int pixel_samples = 16;    // camera rays per pixel; noise averages out over the splats' views
    // "ours": panoramas around the first one, holes inpainted.
    int viewpoints = 14;     // number of new ones, besides panorama 0
    float reach_m = 0.7f;    // maximum distance of a viewpoint from panorama 0
    float clearance = 0.5f;  // and at most this share of the free distance
    // "paper", "paper-direct", "paper-far".
    float step = 0.02f;  // share of the greatest range
    int steps = 6;
    std::string inpainter = "auto";
    std::string inpaint_weights;
    std::string device = "auto";       // of the inpainter's network: auto, cpu or cuda
    std::vector<std::string> trusted;  // files whose code may run (models/trust.h); never recorded in a run
};
// A scene from a prompt is rendered from viewpoints all over its room; nothing is inpainted (room_walk.h).
inline constexpr const char* kRoomWalk = "room";
// Fills holes by rendering the known room instead of inpainting.
inline constexpr const char* kLookIntoRoom = "room";
inline std::vector<std::string> hole_fillers() {
    std::vector<std::string> names = registered_names<InpaintBackend>();
    names.push_back(kLookIntoRoom);
    names.push_back("auto");
    return names;
}
inline std::vector<std::string> walk_kinds() {
    return {"auto", kRoomWalk, "ours", "paper", "paper-direct", "paper-far"};
}
template <class V>
void visit_fields(WalkParams& p, V&& v) {
    v("kind", p.kind, Choices{walk_kinds()},
      "Kind of walk. room: renders the room of a prompt from viewpoints all over it; ours: moves around the first "
      "panorama and inpaints holes; paper, paper-direct, paper-far: as published, step by step in eight directions, "
      "inpainting on cube faces, on the panorama itself, or after one large step; auto: room for a prompt unless an "
      "inpainter is named, else ours.");
    v("room-viewpoints", p.room_viewpoints, Bounds{0, 400},
      "room: maximum number of viewpoints besides the first panorama; fewer are used if they suffice.");
    v("width", p.width, Bounds{0, 8192}, "room: width of a viewpoint's panorama in pixels; 0 = as the first panorama.");
    v("pixel-samples", p.pixel_samples, Bounds{1, 4096}, "room: camera rays per pixel of a viewpoint's panorama.");
    v("viewpoints", p.viewpoints, Bounds{0, 200}, "ours: number of new viewpoints besides the first panorama.");
    v("reach", p.reach_m, Bounds{0.01, 10}, "ours: maximum distance from the first viewpoint in metres.");
    v("clearance", p.clearance, Bounds{0.05, 0.95},
      "ours: maximum step as a share of the free distance in its direction.");
    v("step", p.step, Bounds{0.001, 0.5}, "paper: step length as a share of the greatest range.");
    v("steps", p.steps, Bounds{1, 50}, "paper: steps in each direction.");
    v("inpainter", p.inpainter, Choices{hole_fillers()},
      "How holes are filled, also those of a partial panorama: by a network (aotgan), by another that was exported as "
      "TorchScript, such as LaMa (torchscript), by smooth interpolation (harmonic), or, with ours and a prompt, by "
      "rendering the room (room). auto: aotgan, if the walk has holes.");
    v("inpaint-weights", p.inpaint_weights,
      "Weights for --walk-inpainter aotgan: the official G*.pt or a .safetensors; empty: the built-in ones. For "
      "torchscript: its file.");
    v("device", p.device, Choices{{"auto", "cpu", "cuda"}},
      "Where the network of --walk-inpainter runs; auto: CUDA if libtorch supports it.");
}
// Resolves "auto". `known_room`: the panorama was rendered from a room, and its range is exact.
WalkParams resolved(WalkParams params, bool known_room);

// Positions (world, metres) in the order of visits: each close to the ones before, distributed over the free space
// around panorama 0, including up and down.
std::vector<Vec3f> choose_viewpoints(const Panorama& first, const WalkParams& params);

// Receives each panorama when its color, range and `known` are complete: panorama 0, further given ones, then one per
// viewpoint. The walk does not keep them: twenty of 4096 columns are 3 GB.
using TakePanorama = std::function<void(Panorama panorama)>;
// Range from color alone: used by the published walk after each step. Metres along each ray, > 0, of the picture's
// size.
using RangeEstimator = std::function<ImageF(const ImageColor& color, const Run& run)>;
// Renders a known room for the nonzero pixels of a mask, from a given pose: color as in panorama 0, and metres along
// the ray, through flat mirrors, +inf = outside. Both of the mask's size; other pixels are undefined.
struct RoomSight {
    ImageColor color;
    ImageF range;
};
using RoomLook = std::function<RoomSight(const Rigid& world_from_pano, const ImageMask& asked, const Run& run)>;
// Callbacks that a walk may use; those that it does not need are optional.
struct WalkAdvice {
    RangeEstimator range;
    RoomLook room;  // for the inpainter "room"
};

// Returns the record for stage.json: fallbacks used, clipped settings. `more`: further panoramas of the same place with
// range, in the first's orientation; used by "ours" only, as observed surfaces, with the viewpoints divided among all.
// Pixels of `first` without a range (0, NaN, infinite) are far background. Throws Error if there is no free space to
// walk in.
Json walk_through(const Panorama& first, const WalkParams& params, const Run& run, const TakePanorama& take,
                  const WalkAdvice& advice = {}, const std::vector<Panorama>& more = {});

// The same, collecting all panoramas.
struct Walked {
    std::vector<Panorama> panoramas;
    Json about;
};
Walked walked_through(const Panorama& first, const WalkParams& params, const Run& run, const WalkAdvice& advice = {},
                      const std::vector<Panorama>& more = {});

}  // namespace fastscene

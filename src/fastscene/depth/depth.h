// Depth stage: equirectangular color -> range along each ray, in metres. Paper: panoramic depth.
// Backends: "exact" (the room behind a panorama from a prompt is asked), "image" (a range map of the user's,
// panorama/panorama.h), "egformer" (a network estimates it) and "layout" (a box room fitted to the picture's lines).
#pragma once

#include <string>
#include <string_view>

#include "fastscene/base/fields.h"
#include "fastscene/base/run.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/image/image.h"
#include "fastscene/scene/panorama.h"
#include "fastscene/trace/trace.h"

namespace fastscene {

struct DepthParams {
    std::string backend = "auto";
    std::string weights;           // of egformer
    float camera_height_m = 1.6f;  // over the floor: a tripod at eye height
    int tta = 0;                   // of the network at the picture, turned and mirrored
};
template <class V>
void visit_fields(DepthParams& p, V&& v) {
    v("backend", p.backend, Choices{{"auto", "exact", "image", "egformer", "layout"}},
      "What tells the range: auto takes exact for a prompt, image with --range, else egformer, with its shipped "
      "weights or --depth-weights; without any, layout.");
    v("weights", p.weights,
      "EGformer's weights (the published .pkl, or .safetensors); empty: those that come with the program, two networks "
      "whose mean counts.");
    v("tta", p.tta, Bounds{0, 8},
      "How often the network looks at the picture, turned and mirrored, the mean counts; 0: eight times if it is as "
      "small as those that ship, else once, as published.");
    v("camera-height", p.camera_height_m, Bounds{0.2, 20},
      "Height of the camera over the floor in metres, where range is estimated.");
}

// Range as seen from the world's origin (panorama 0); +inf where the ray leaves the room. Needs no gathered light.
ImageF exact_range(const TracedRoom& room, EquirectSize size, const Run& run);
// The same into flat mirrors (Panorama::mirrored_range); empty where none is seen.
ImageF exact_mirrored_range(const TracedRoom& room, EquirectSize size, const Run& run);

// The panorama with a range map from elsewhere. Sizes must be equal. 0 is "unknown" and is filled smoothly from its
// surroundings; +inf is sky. Throws Error naming `source` for NaN, negative values or nothing known at all.
Panorama with_range(Panorama panorama, ImageF range, std::string_view source = "range map");

}  // namespace fastscene

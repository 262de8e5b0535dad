// Depth stage: equirectangular color -> range along each ray, in metres. Paper: panoramic depth. The range of a
// prompt's room is ray traced, a map of the user's is read (panorama/panorama.h); else a backend estimates it
// (estimator.h).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fastscene/base/fields.h"
#include "fastscene/base/run.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/image/image.h"
#include "fastscene/scene/panorama.h"
#include "fastscene/trace/trace.h"

namespace fastscene {

// Values of DepthParams::backend besides the names of the backends that estimate.
inline constexpr const char* kAutoDepth = "auto";
inline constexpr const char* kExactDepth = "exact";  // ray traced in the room of a prompt
inline constexpr const char* kMapDepth = "image";    // a range map from the user
std::vector<std::string> depth_choices();
const std::string& about_depth_choices();

struct DepthParams {
    std::string backend = kAutoDepth;
    std::string weights;                    // of a network
    std::string device = "auto";            // of a network: auto, cpu or cuda
    float camera_height_m = 1.6f;           // above the floor: a tripod at eye height
    std::string da2_resize = "evaluation";  // how DA-2 sees a picture: nn/da2.h
    std::string da2_precision = "float";
    // What a network in TorchScript wants; auto and 0: as the JSON beside it says.
    std::string script_output = "auto", script_normalize = "auto";
    int script_width = 0;
    // Paths and hashes of files whose code may run (models/trust.h). Not a setting: never recorded in a run, which may
    // come from somebody else.
    std::vector<std::string> trusted;
    int tta = 0;  // test-time augmentation: number of rotated and mirrored variants averaged; 0: automatic
};
template <class V>
void visit_fields(DepthParams& p, V&& v) {
    v("backend", p.backend, Choices{depth_choices()}, about_depth_choices());
    v("weights", p.weights,
      "A network's weights: DA-2's model.safetensors, EGformer's (the published .pkl, or .safetensors), or the file of "
      "--depth-backend torchscript. auto recognizes DA-2's. Empty: those that `fastscene models pull` fetched, else "
      "the "
      "built-in ones, two networks whose outputs are averaged.");
    v("da2-resize", p.da2_resize, Choices{{"evaluation", "inference"}},
      "da2: how the picture comes to the network's size, both as published. evaluation: to 1092 x 546 with "
      "antialiasing, as for the published scores; inference: to about 600,000 pixels by area, as the authors' program "
      "does, whose viewing angles close only for a picture of 1092 x 546.");
    v("da2-precision", p.da2_precision, Choices{{"float", "bf16"}},
      "da2: bf16 rounds its products to bfloat16, but those of its last layers: faster on processors with AVX-512 BF16 "
      "and on graphics cards.");
    v("script-output", p.script_output, Choices{{"auto", "range", "disparity", "metres"}},
      "torchscript: what its output is. range and disparity: up to a scale, which the camera's height gives; auto: as "
      "the JSON beside the file says, else range.");
    v("script-width", p.script_width, Bounds{0, 8192},
      "torchscript: width of the panorama that it gets; 0: as the JSON beside the file says, else 1024.");
    v("script-normalize", p.script_normalize, Choices{{"auto", "unit", "imagenet", "symmetric"}},
      "torchscript: colors that it gets. unit: 0 to 1; imagenet: less ImageNet's mean, by its deviation; symmetric: -1 "
      "to 1; auto: as the JSON beside the file says, else unit.");
    v("device", p.device, Choices{{"auto", "cpu", "cuda"}},
      "Where the network runs; auto: CUDA if libtorch supports it.");
    v("tta", p.tta, Bounds{0, 8},
      "Test-time augmentation: the network's outputs for this many rotated and mirrored variants are averaged; 0: "
      "eight for networks as small as the built-in ones, two (half a turn apart, which closes the seam) for DA-2, else "
      "one, as published.");
    v("camera-height", p.camera_height_m, Bounds{0.2, 20},
      "Height of the camera above the floor in metres, if range is estimated.");
}

// Range from the world's origin (panorama 0); +inf where the ray leaves the room. Needs no gathered light.
ImageF exact_range(const TracedRoom& room, EquirectSize size, const Run& run);
// The same through flat mirrors (Panorama::mirrored_range); empty if none is visible.
ImageF exact_mirrored_range(const TracedRoom& room, EquirectSize size, const Run& run);

// Attaches a range map to a panorama of the same size. 0 means unknown and is interpolated smoothly; +inf is sky.
// Throws Error naming `source` for NaN, negative values or no known value at all.
Panorama with_range(Panorama panorama, ImageF range, std::string_view source = "range map");

}  // namespace fastscene

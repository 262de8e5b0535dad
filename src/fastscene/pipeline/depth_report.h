// How well is range estimated? Many pictures whose range is known, by any backend: `fastscene depth check`.
#pragma once

#include <filesystem>
#include <string>

#include "fastscene/base/json.h"
#include "fastscene/base/run.h"
#include "fastscene/depth/depth.h"

namespace fastscene {

struct DepthCheck {
    std::filesystem::path data;  // a folder (depth/examples.h)
    int count = 50;              // places looked at, one picture each
    bool all = false;   // of all places: a set that the network never saw; false: held-out ones only (depth/examples.h)
    DepthParams depth;  // backend egformer, layout or auto
};
// Mean scores aligned in scale and shift, in scale alone and not at all ("affine", "scale", "none"), the backend's name
// and CPU seconds a picture. The picture is the size of the file. `run` is told when there are fewer places than
// `count`. Throws Error when there is none.
Json check_depth(const DepthCheck& check, const Run& run);
std::string depth_check_text(const Json& report);

}  // namespace fastscene

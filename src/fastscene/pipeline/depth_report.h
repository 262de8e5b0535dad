// How well is range estimated? Many pictures whose range is known, by any backend: `fastscene depth check`.
#pragma once

#include <filesystem>
#include <string>

#include "fastscene/base/json.h"
#include "fastscene/base/run.h"
#include "fastscene/depth/depth.h"

namespace fastscene {

struct DepthCheck {
    std::filesystem::path data;   // a folder (depth/examples.h)
    int count = 50;               // places looked at, one picture each, held-out ones only
    DepthParams depth;            // backend egformer, layout or auto
};
// Mean scores aligned in scale and shift, in scale alone and not at all ("affine", "scale", "none"), the backend's name and CPU seconds a picture.
// The picture is the size of the file. Throws Error when nothing is held out.
Json check_depth(const DepthCheck& check, const Run& run);
std::string depth_check_text(const Json& report);

}  // namespace fastscene

// Evaluates depth backends on pictures with known range: `fastscene depth check`.
#pragma once

#include <filesystem>
#include <string>

#include "fastscene/base/json.h"
#include "fastscene/base/run.h"
#include "fastscene/depth/depth.h"

namespace fastscene {

struct DepthCheck {
    std::filesystem::path data;  // a folder (depth/examples.h)
    int count = 50;              // number of places, one picture each
    // all places, for sets that the network was not trained on; false: only held-out ones (depth/examples.h)
    bool all = false;
    DepthParams depth;  // any backend that estimates, or auto
};
// Mean scores after alignment of scale and shift, of scale alone, and without ("affine", "scale", "none"), the
// backend's name and CPU seconds per picture. Pictures are used at the file's size. Notes in `run` if there are fewer
// places than `count`. Throws Error if there are none.
Json check_depth(const DepthCheck& check, const Run& run);
std::string depth_check_text(const Json& report);

}  // namespace fastscene

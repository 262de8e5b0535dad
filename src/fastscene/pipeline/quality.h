// All settings of a run, and the three presets.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/depth/depth.h"
#include "fastscene/panorama/panorama.h"
#include "fastscene/splat/splat.h"
#include "fastscene/views/views.h"
#include "fastscene/walk/walk.h"

namespace fastscene {

struct SceneParams {
    PanoramaParams panorama;
    DepthParams depth;
    WalkParams walk;
    ViewsParams views;
    SplatParams splat;
};
// Calls v(section, params struct) for each stage with settings, in pipeline order.
template <class V>
void visit_sections(SceneParams& p, V&& v) {
    v("panorama", p.panorama);
    v("depth", p.depth);
    v("walk", p.walk);
    v("views", p.views);
    v("splat", p.splat);
}

std::vector<std::string> qualities();  // "draft", "standard", "high"
// Throws UsageError for an unknown name.
SceneParams params_of_quality(std::string_view quality);
// For splats of photographs, which have sparse initial points and unbounded scenes.
SplatParams capture_params_of_quality(std::string_view quality);

// Converts to and from run.json's sections and fields. Fields missing in the JSON keep their value of `base`.
Json json_of_params(const SceneParams& params);
SceneParams params_from_json(const Json& json, const SceneParams& base);
// Throws UsageError naming a flag that is out of bounds.
void check_params(SceneParams params);

}  // namespace fastscene

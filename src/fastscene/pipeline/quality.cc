#include "fastscene/pipeline/quality.h"

#include <type_traits>

namespace fastscene {
namespace {

// Two minutes a core: to see whether the prompt was understood as meant.
void fill_draft(SceneParams& p) {
    p.panorama.width = 1024;
    p.panorama.trace = {.cell_m = 0.045f, .cell_samples = 256, .pixel_samples = 16};
    p.walk.viewpoints = 8;
    p.views.size = 320;
    p.views.points = 200'000;
    p.splat.count = 100'000;
    p.splat.steps = 1200;
}
void fill_standard(SceneParams& p) {
    p.panorama.width = 2048;
    p.panorama.trace = {.cell_m = 0.03f, .cell_samples = 160, .pixel_samples = 16};
    p.walk.viewpoints = 14;
    p.views.size = 640;
    p.views.points = 500'000;
    p.splat.count = 250'000;
    p.splat.steps = 3000;
}
void fill_high(SceneParams& p) {
    p.panorama.width = 4096;
    p.panorama.trace = {.cell_m = 0.02f, .cell_samples = 512, .pixel_samples = 16};
    p.walk.viewpoints = 20;
    p.views.size = 1024;
    p.views.points = 1'200'000;
    p.splat.count = 600'000;
    p.splat.steps = 8000;
}

}  // namespace

std::vector<std::string> qualities() { return {"draft", "standard", "high"}; }

SceneParams params_of_quality(std::string_view quality) {
    SceneParams params;
    if (quality == "draft")
        fill_draft(params);
    else if (quality == "standard")
        fill_standard(params);
    else if (quality == "high")
        fill_high(params);
    else
        throw UsageError("--quality: expected one of {}, found \"{}\"", fmt::join(qualities(), ", "), quality);
    return params;
}

Json json_of_params(const SceneParams& params) {
    Json json = Json::object();
    SceneParams copy = params;
    visit_sections(copy, [&](std::string_view section, auto& fields) { json[std::string(section)] = fields_json(fields); });
    return json;
}

SceneParams params_from_json(const Json& json, const SceneParams& base) {
    SceneParams params = base;
    visit_sections(params, [&](std::string_view section, auto& fields) {
        const auto found = json.find(std::string(section));
        if (found != json.end()) fields_from_json(*found, fields);
    });
    return params;
}

void check_params(SceneParams params) {
    visit_sections(params, [](std::string_view section, auto& fields) { check_fields(section, fields); });
    if (params.panorama.width % 2 != 0)
        throw UsageError("--panorama-width: expected an even number of pixels, found {}", params.panorama.width);
}

}  // namespace fastscene

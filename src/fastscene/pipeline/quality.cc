#include "fastscene/pipeline/quality.h"

#include <type_traits>

namespace fastscene {
namespace {

// Scenes from panoramas have dense points on every surface, and a backdrop, so splats start as closed, opaque surfaces
// near their final positions.
void start_closed(SplatParams& p) {
    p.start_opacity = 0.95f;
    p.start_overlap = 0.6f;
    p.learning_rate_mean_m = 0.8e-3f;
    p.learning_rate_logit = 0.06f;
    p.opaque = 0.03f;
    p.outside_m = 200.f;  // the sky stands at 400 m or farther, and in the corner of a view at half that depth
    p.sh_degree = kAutomaticShDegree;
    // Views are renderings whose pixels average their area; a wider low-pass would blur every edge, and without
    // antialiasing joints narrower than a pixel would become too dark.
    p.low_pass_px2 = 0.1f;
    p.antialias = true;
}
SplatParams started_as_photographs(SplatParams p) {
    const SplatParams defaults;
    p.start_opacity = defaults.start_opacity;
    p.start_overlap = defaults.start_overlap;
    p.learning_rate_mean_m = defaults.learning_rate_mean_m;
    p.learning_rate_logit = defaults.learning_rate_logit;
    p.opaque = defaults.opaque;
    p.outside_m = defaults.outside_m;
    p.per_m2 = defaults.per_m2;
    p.sh_degree = defaults.sh_degree;
    p.low_pass_px2 = defaults.low_pass_px2;
    p.antialias = defaults.antialias;
    return p;
}

// Two minutes of CPU time, to check whether the prompt was understood.
void fill_draft(SceneParams& p) {
    p.panorama.width = 1024;
    p.panorama.trace = {.cell_m = 0.045f, .cell_samples = 256, .pixel_samples = 8, .outside_detail = 5};
    p.walk.viewpoints = 8;
    p.walk.room_viewpoints = 12;
    p.walk.pixel_samples = 2;
    p.views.size = 320;
    p.views.points = 250'000;
    p.views.outside_density = 3;
    p.views.outside_points = 50'000;
    p.splat.count = 250'000;
    p.splat.per_m2 = 800;
    p.splat.steps = 1200;
}
void fill_standard(SceneParams& p) {
    p.panorama.width = 2048;
    p.panorama.trace = {.cell_m = 0.03f, .cell_samples = 160, .pixel_samples = 8};
    p.walk.viewpoints = 14;
    p.walk.room_viewpoints = 20;
    p.walk.pixel_samples = 2;
    p.views.size = 640;
    p.views.points = 900'000;
    p.views.outside_density = 24;
    p.views.outside_points = 300'000;
    p.splat.count = 900'000;
    p.splat.per_m2 = 3500;
    p.splat.steps = 2200;
}
void fill_high(SceneParams& p) {
    p.panorama.width = 4096;
    p.panorama.trace = {.cell_m = 0.02f, .cell_samples = 512, .pixel_samples = 16, .outside_detail = 12};
    p.walk.viewpoints = 20;
    p.walk.room_viewpoints = 40;
    p.walk.pixel_samples = 4;
    p.views.size = 1024;
    p.views.points = 1'500'000;
    p.views.outside_density = 30;
    p.views.outside_points = 400'000;
    p.splat.count = 1'500'000;
    p.splat.per_m2 = 5000;
    p.splat.steps = 5000;
}

}  // namespace

std::vector<std::string> qualities() { return {"draft", "standard", "high"}; }

SceneParams params_of_quality(std::string_view quality) {
    SceneParams params;
    start_closed(params.splat);
    params.views.backdrop = 6000;  // 2.6 degrees apart
    if (quality == "draft") fill_draft(params);
    else if (quality == "standard") fill_standard(params);
    else if (quality == "high") fill_high(params);
    else throw UsageError("--quality: expected one of {}, found \"{}\"", fmt::join(qualities(), ", "), quality);
    return params;
}

SplatParams capture_params_of_quality(std::string_view quality) {
    return started_as_photographs(params_of_quality(quality).splat);
}

Json json_of_params(const SceneParams& params) {
    Json json = Json::object();
    SceneParams copy = params;
    visit_sections(copy,
                   [&](std::string_view section, auto& fields) { json[std::string(section)] = fields_json(fields); });
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

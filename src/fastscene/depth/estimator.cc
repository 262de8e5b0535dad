#include "fastscene/depth/estimator.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "fastscene/base/check.h"
#include "fastscene/depth/align.h"
#include "fastscene/depth/walls.h"

namespace fastscene {
namespace {

bool is_ready(const DepthBackend& backend, const DepthParams& params) {
    return !backend.ready || backend.ready(params);
}

// Those that "auto" may choose, the best first.
std::vector<const DepthBackend*> by_rank() {
    std::vector<const DepthBackend*> ranked;
    for (const DepthBackend& backend : registered<DepthBackend>())
        if (backend.auto_rank > 0) ranked.push_back(&backend);
    std::sort(ranked.begin(), ranked.end(),
              [](const DepthBackend* a, const DepthBackend* b) { return a->auto_rank > b->auto_rank; });
    return ranked;
}

}  // namespace

EstimatedRange in_metres(const ImageF& relative, const ImageColor& color, float camera_height_m, UnknownOfRange unknown,
                         Json about, const Run& run) {
    run.check_stop();
    const MetricFit fit = fit_metres(relative, camera_height_m, unknown);
    if (!fit.sure)
        run.warn(fmt::format(
            "depth: expected a level floor {} m below the camera, found too little of it: the scale is a guess",
            camera_height_m));
    const ImageF range = metric_range(relative, fit);
    about.update({{"camera_height_m", fit.camera_height_m},
                  {"ceiling_above_camera_m", fit.ceiling_m},
                  {"scale", fit.scale},
                  {"floor_share", fit.floor_share},
                  {"floor_found", fit.sure},
                  {"walls", json_of_walls(range, color, fit.camera_height_m, fit.ceiling_m)}});
    if (unknown == UnknownOfRange::scale_and_shift) about["shift"] = fit.shift;
    return {aligned_to_picture(range, color), std::move(about)};
}

std::vector<std::string> depth_choices() {
    std::vector<std::string> names{kAutoDepth, kExactDepth, kMapDepth};
    for (const DepthBackend& backend : registered<DepthBackend>()) names.push_back(backend.name);
    return names;
}

const std::string& about_depth_choices() {
    static const std::string text = [] {
        std::vector<std::string> ranked;
        for (const DepthBackend* backend : by_rank()) ranked.push_back(backend->name);
        std::string out = fmt::format(
            "What tells the range. auto: exact for a prompt, image with --range, else the first that has its weights "
            "of {}; exact: the room behind a prompt; image: the map of --range",
            fmt::join(ranked, ", "));
        for (const DepthBackend& backend : registered<DepthBackend>())
            out += fmt::format("; {}: {}", backend.name, backend.about);
        return out + ".";
    }();
    return text;
}

const DepthBackend& depth_backend_of(const DepthParams& params) {
    if (params.backend != kAutoDepth) return registered_entry<DepthBackend>("--depth-backend", params.backend);
    const std::vector<const DepthBackend*> ranked = by_rank();
    const auto found = std::find_if(ranked.begin(), ranked.end(),
                                    [&](const DepthBackend* backend) { return is_ready(*backend, params); });
    FASTSCENE_CHECK(found != ranked.end());  // layout needs nothing
    return **found;
}

std::vector<const DepthBackend*> depth_backends_with_models(const DepthParams& params) {
    std::vector<const DepthBackend*> out = params.backend == kAutoDepth
                                               ? by_rank()
                                               : std::vector<const DepthBackend*>{&depth_backend_of(params)};
    std::erase_if(out, [](const DepthBackend* backend) { return backend->model.empty(); });
    return out;
}

std::unique_ptr<DepthEstimator> make_depth_estimator(const DepthParams& params) {
    return depth_backend_of(params).make(params);
}

}  // namespace fastscene

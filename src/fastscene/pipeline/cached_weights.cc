#include "fastscene/pipeline/cached_weights.h"

#include "fastscene/depth/estimator.h"
#include "fastscene/models/cache.h"
#include "fastscene/pipeline/resolve.h"

namespace fastscene {
namespace fs = std::filesystem;

namespace {

void take_weights(const char* model, const std::optional<fs::path>& found, auto& weights, const Run& run) {
    if (!found) return;
    weights = found->string();
    run.note(fmt::format("{}: weights from {}", model, found->string()));
}

}  // namespace

void use_cached_depth_weights(DepthParams& depth, const Run& run) {
    for (const DepthBackend* backend : depth_backends_with_models(depth))
        if (depth.weights.empty())
            take_weights(backend->model.c_str(), cached_file(backend->model), depth.weights, run);
}

void use_cached_weights(SceneRequest& request, const Run& run) {
    const auto take = [&](const char* model, const std::optional<fs::path>& found, auto& weights) {
        take_weights(model, found, weights, run);
    };
    const auto asked_for = [](std::string_view what, std::string_view flag, std::string_view model) {
        return UsageError("{}: expected {}, or the model in the cache (fastscene models pull {}), found neither", what,
                          flag, model);
    };
    const PanoramaParams& panorama = request.params.panorama;
    if (auto* painting = std::get_if<PaintingSource>(&request.source); painting && painting->weights.empty()) {
        const char* model = painting->photo.empty() ? "diffusion360" : "diffusion360-photo";
        take(model, cached_model(model), painting->weights);
        if (painting->weights.empty())
            throw asked_for("--panorama diffusion360",
                            painting->photo.empty()
                                ? "--weights DIR with unet/ vae/ text_encoder/ tokenizer/ scheduler/"
                                : "--weights DIR with sr-base/ and sd-i2p/",
                            model);
    }
    auto* picture = std::get_if<PictureSource>(&request.source);
    if (picture && panorama.diffusion.upscale != "none" && picture->weights.empty()) {
        take("diffusion360", cached_model("diffusion360-upscale"), picture->weights);
        if (picture->weights.empty())
            throw asked_for("--panorama-upscale", "--weights DIR with sr-base/ and sr-control/",
                            "diffusion360-upscale");
    }
    const SceneSource& source = request.source;
    if (request.last_stage == "panorama") return;
    DepthParams& depth = request.params.depth;
    if (is_estimated(source, depth)) use_cached_depth_weights(depth, run);
    if (request.last_stage == "depth") return;
    WalkParams& walk = request.params.walk;
    const WalkParams resolved = walk_of(source, depth, walk);
    if (resolved.kind == kRoomWalk || !walk.inpaint_weights.empty()) return;
    if (const auto* inpainter = find_registered<InpaintBackend>(resolved.inpainter);
        inpainter && !inpainter->model.empty())
        take(inpainter->name.c_str(), cached_file(inpainter->model), walk.inpaint_weights);
}

}  // namespace fastscene

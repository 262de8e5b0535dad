#include "fastscene/pipeline/cached_weights.h"

#include "fastscene/models/cache.h"
#include "fastscene/pipeline/resolve.h"

namespace fastscene {
namespace fs = std::filesystem;

void use_cached_weights(SceneRequest& request, const Run& run) {
    const auto take = [&](const char* model, const std::optional<fs::path>& found, auto& weights) {
        if (!found) return;
        weights = found->string();
        run.note(fmt::format("{}: weights from {}", model, found->string()));
    };
    const auto asked_for = [](std::string_view what, std::string_view flag, std::string_view model) {
        return UsageError("{}: expected {}, or the model in the cache (fastscene models pull {}), found neither", what,
                          flag, model);
    };
    SceneSource& source = request.source;
    PanoramaParams& panorama = request.params.panorama;
    if (panorama.backend == "diffusion360" && source.weights.empty()) {
        const char* model = source.photo.empty() ? "diffusion360" : "diffusion360-photo";
        take(model, cached_model(model), source.weights);
        if (source.weights.empty())
            throw asked_for("--panorama diffusion360",
                            source.photo.empty() ? "--weights DIR with unet/ vae/ text_encoder/ tokenizer/ scheduler/"
                                                 : "--weights DIR with sr-base/ and sd-i2p/",
                            model);
    }
    if (!source.picture.empty() && panorama.diffusion.upscale != "none" && source.weights.empty()) {
        take("diffusion360", cached_model("diffusion360-upscale"), source.weights);
        if (source.weights.empty())
            throw asked_for("--panorama-upscale", "--weights DIR with sr-base/ and sr-control/",
                            "diffusion360-upscale");
    }
    if (request.last_stage == "panorama") return;
    DepthParams& depth = request.params.depth;
    const bool estimated = depth.backend == "egformer" || (depth.backend == "auto" && source.range_map.empty() &&
                                                           (!source.picture.empty() || !source.weights.empty()));
    if (estimated && depth.weights.empty())
        take("egformer", cached_file("egformer"), depth.weights);  // else the program may carry its own
    if (request.last_stage == "depth") return;
    WalkParams& walk = request.params.walk;
    const WalkParams resolved = walk_of(source, depth, walk);
    const bool paints = resolved.kind != kRoomWalk && resolved.inpainter == "aotgan";
    if (paints && walk.inpaint_weights.empty()) take("aotgan", cached_file("aotgan-places2"), walk.inpaint_weights);
}

}  // namespace fastscene

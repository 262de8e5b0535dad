#include "fastscene/pipeline/stage_splat.h"

#include <algorithm>
#include <optional>

#include "fastscene/base/file.h"
#include "fastscene/io/splat_io.h"
#include "fastscene/io/view_io.h"
#include "fastscene/pipeline/fit_report.h"

namespace fastscene {
namespace fs = std::filesystem;

namespace {

// Splats of an edited scene are nearly right: they need a part of the steps, at the learning rates of a training's end.
constexpr float kContinuedSteps = 0.25f, kBegun = 0.5f;
constexpr double kMostGrowth = 1.15;  // of the number of splats, by edits

}  // namespace

void make_splat(const RunFolder& folder, const SplatParams& params, const BeginSplats& begin_splats,
                const fs::path& out, const Run& run, const StepListener& on_step) {
    const ViewSet views = load_views(folder.views());
    SplatParams sized = params;
    sized.count = count_for(views.points, params);
    if (const int fit = most_that_fit(params); params.per_m2 > 0 && fit < sized.count) {
        run.warn(fmt::format("splat: the room needs {} Gaussians but memory suffices for {}: it will look coarser",
                             sized.count, fit));
        sized.count = fit;
    } else if (sized.count < params.count)
        run.note(fmt::format("splat: {} Gaussians for the size of the room", sized.count));
    else if (params.per_m2 > 0)
        run.note(fmt::format("splat: {} Gaussians, the most that --splat-count allows", sized.count));
    std::optional<Splats> begin;
    if (begin_splats) begin = begin_splats(views.points, sized);
    if (begin && static_cast<double>(begin->size()) > kMostGrowth * sized.count) {
        run.note("splat: begins from scratch: with the earlier Gaussians there would be too many");
        begin.reset();
    }
    if (begin) {
        sized.coarse = 0;
        if (sized.until > 0)
            sized.until = std::max(1, static_cast<int>(kContinuedSteps * static_cast<float>(sized.until)));
        sized.count = static_cast<int>(begin->size());
        sized.steps = std::max(1, static_cast<int>(kContinuedSteps * static_cast<float>(sized.steps)));
        sized.begun = kBegun;
    }
    save_fit(fit_and_keep_place(views, sized, folder, run, on_step, begin ? &*begin : nullptr), out);
    forget_place(folder);
}

FittedSplats fit_and_keep_place(const ViewSet& views, SplatParams params, const RunFolder& folder, const Run& run,
                                const StepListener& on_step, const Splats* begin) {
    if (!params.checkpoint.empty()) return fit_splats(views, params, run, on_step, begin);
    // a folder, so that temporary files of a killed process are deleted with it
    const fs::path place = folder.splat_place();
    params.checkpoint = (place / "checkpoint").string();
    if (!is_checkpoint_of(params.checkpoint, views, params, run.seed, begin))
        fs::remove_all(place);  // from other settings
    make_directories(place);
    return fit_splats(views, params, run, on_step, begin);
}

void forget_place(const RunFolder& folder) {
    fs::remove_all(folder.splat_place());
    fs::remove(folder.training_jpg());
}

void save_fit(const FittedSplats& fitted, const fs::path& out, Vec3d offset_m) {
    save_splat_ply(out / "scene.ply", fitted.splats, PlyBands::all, offset_m);
    save_compressed_ply(out / "scene.compressed.ply", fitted.splats);
    save_curves(out, fitted);
}

}  // namespace fastscene

// The splat stage.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "fastscene/pipeline/run_folder.h"
#include "fastscene/splat/splat.h"

namespace fastscene {

// `begin`: gives the splats to continue from, if there are any; else training begins at the views' points.
using BeginSplats = std::function<std::optional<Splats>(const std::vector<SurfacePoint>& points, const SplatParams&)>;
void make_splat(const RunFolder& folder, const SplatParams& params, const BeginSplats& begin,
                const std::filesystem::path& out, const Run& run, const StepListener& on_step = {});
// Like fit_splats, but if the user named no checkpoint, an interrupted training resumes from one in the run's folder,
// which is deleted once the splats are saved.
FittedSplats fit_and_keep_place(const ViewSet& views, SplatParams params, const RunFolder& folder, const Run& run,
                                const StepListener& on_step = {}, const Splats* begin = nullptr);
// Deletes what only an unfinished training needs.
void forget_place(const RunFolder& folder);

// Writes scene.ply, scene.compressed.ply and curve.json.
// `offset_m`: what was subtracted from the positions of a georeferenced capture; scene.ply tells it.
void save_fit(const FittedSplats& fitted, const std::filesystem::path& out, Vec3d offset_m = {});

}  // namespace fastscene

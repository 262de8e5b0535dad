// The splats as they meet the disk.
#pragma once

#include <filesystem>

#include "fastscene/pipeline/run_folder.h"
#include "fastscene/splat/splat.h"

namespace fastscene {

void make_splat(const RunFolder& folder, const SplatParams& params, const std::filesystem::path& out, const Run& run);
// As fit_splats, but where the user named no checkpoint a stopped training goes on from one in the run's folder: until
// its splats are saved, which a full disk may prevent, and the place is forgotten.
FittedSplats fit_and_keep_place(const ViewSet& views, SplatParams params, const RunFolder& folder, const Run& run);
void forget_place(const RunFolder& folder);

// scene.ply, scene.compressed.ply and curve.json.
void save_fit(const FittedSplats& fitted, const std::filesystem::path& out);

}  // namespace fastscene

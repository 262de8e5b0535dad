// Hole table: the paper's Table 1 for any panorama. How much of the picture has no color after a step, by axis and
// distance, for the official warp and ours.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/base/run.h"
#include "fastscene/walk/coarse_view.h"

namespace fastscene {

// Compares our holes to the true disocclusions. Both are sampled on a grid finer than the panorama, since after a short
// step a true hole is narrower than a pixel. Near: within one panorama pixel, as the sub-pixel position of a silhouette
// is unknown.
inline constexpr int kFiner = 3;  // grid points per pixel and side
struct HoleTruth {
    double ratio = 0;                  // share of pixels whose surface is hidden from the first viewpoint
    double precision = 1, recall = 1;  // share of our holes that are true; share of the true ones that we found
    double precision_near = 1, recall_near = 1;
};
struct HoleRow {
    char axis = 'x';   // official frame: x towards the picture's center, y up, z to its right
    double share = 0;  // signed step, as a share of the greatest range
    double step_m = 0;
    bool in_room = true;  // false: the step ends in or behind a surface
    double published = 0, ours = 0;
    double paper = 0;  // the paper's figure for its own scenes
    std::optional<HoleTruth> truth;
};
// Distance in metres from a point (panorama 0's frame) to the first surface along a unit direction; +inf: none.
using Distance = std::function<float(Vec3f from, Vec3f direction)>;

// Steps and axes as in the paper's table. `range` is downsampled to 1024 columns, as published, if it is wider. If
// `distance` is given, each row includes the ground truth (millions of rays).
std::vector<HoleRow> hole_table(const ImageF& range, const Run& run, const Distance& distance = {});

// Pixels that our warp of `source` leaves empty; pixels whose true surface is hidden from the source's viewpoint, the
// origin.
ImageMask our_holes(const WarpSource& source, EquirectSize size, Vec3f position);
ImageMask true_holes(EquirectSize size, Vec3f position, const Distance& distance);
// `reach`: tolerance in pixels.
HoleTruth compare_holes(const ImageMask& ours, const ImageMask& truth, int reach);
// All three on the finer grid.
HoleTruth hole_truth(const WarpSource& source, Vec3f position, const Distance& distance);

std::string hole_table_text(const std::vector<HoleRow>& rows);
Json hole_table_json(const std::vector<HoleRow>& rows);

}  // namespace fastscene

// Hole table: the paper's Table 1 for any panorama: how much of the picture a step leaves without a color, by axis and
// distance, as the official program warps and as we do.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/base/run.h"
#include "fastscene/walk/coarse_view.h"

namespace fastscene {

// Our holes against those that the true room has. Both are looked at on a finer grid than the panorama's, since after a
// short step a true hole is narrower than a pixel. Near: within one of the panorama's pixels, for nobody knows where in
// a pixel a silhouette runs.
inline constexpr int kFiner = 3;  // grid points a pixel and side
struct HoleTruth {
    double ratio = 0;                  // share of pixels whose surface the first viewpoint cannot see
    double precision = 1, recall = 1;  // of our holes are true; of the true ones are ours
    double precision_near = 1, recall_near = 1;
};
struct HoleRow {
    char axis = 'x';   // official frame: x to the middle of the picture, y up, z to its right
    double share = 0;  // signed step, in the greatest range
    double step_m = 0;
    bool in_room = true;  // false: the step ends in or behind a surface, where no one can stand
    double published = 0, ours = 0;
    double paper = 0;  // the paper's own figure for its scenes
    std::optional<HoleTruth> truth;
};
// Distance in metres from a point (panorama 0's frame) to the first surface along a unit direction; +inf = none.
using Distance = std::function<float(Vec3f from, Vec3f direction)>;

// Steps and axes of the paper's table. `range` is looked at 1024 pixels wide, as published, when it is wider. With
// `distance`, each row also has its truth (some millions of rays).
std::vector<HoleRow> hole_table(const ImageF& range, const Run& run, const Distance& distance = {});

// Pixels that our warp of `source` leaves open; pixels that a true room hides from the source's viewpoint, the origin.
ImageMask our_holes(const WarpSource& source, EquirectSize size, Vec3f position);
ImageMask true_holes(EquirectSize size, Vec3f position, const Distance& distance);
// `reach`: how many pixels apart is still near.
HoleTruth compare_holes(const ImageMask& ours, const ImageMask& truth, int reach);
// All three on the finer grid.
HoleTruth hole_truth(const WarpSource& source, Vec3f position, const Distance& distance);

std::string hole_table_text(const std::vector<HoleRow>& rows);
Json hole_table_json(const std::vector<HoleRow>& rows);

}  // namespace fastscene

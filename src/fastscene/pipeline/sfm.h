// Structure from motion as the paper has it: COLMAP finds the cameras of our views again from their pictures alone. We
// know them exactly, so what it finds is measured against what is true.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/base/run.h"
#include "fastscene/scene/capture.h"
#include "fastscene/scene/splat_edit.h"
#include "fastscene/scene/view.h"

namespace fastscene {

// The similarity that brings `found` cameras onto `known` ones of the same names best: the mean turn between their
// axes, then scale and place by least squares over their centers. Scale 1 where the centers coincide. Needs one camera
// in common.
Similarity known_from_found(const std::vector<View>& known, const std::vector<Photo>& found);

struct PoseError {
    std::string view;
    bool registered = false;
    double position_m = 0, rotation_deg = 0;
};
struct SfmReport {
    std::string mode;  // colmap or triangulate
    std::size_t views = 0, registered = 0, points = 0;
    double scale = 1;  // metres a unit of COLMAP's
    double position_median_m = 0, position_max_m = 0, rotation_median_deg = 0, rotation_max_deg = 0;
    double seconds = 0;
    std::vector<PoseError> errors;  // one a view
};
Json to_json(const SfmReport& report);
std::string table_of(const SfmReport& report);

struct SfmResult {
    ViewSet set;  // views that were registered, at the poses found, in our frame; COLMAP's points
    SfmReport report;
};
// `dir` holds the views as save_views wrote them (pictures named in order). mode "colmap": features, matches, mapper;
// "triangulate": poses stay the known ones, only the points are COLMAP's. Uses and removes dir/sfm. Throws Error when
// colmap is not here or fails.
SfmResult structure_from_motion(const std::filesystem::path& dir, const ViewSet& known, const std::string& mode,
                                const Run& run);

}  // namespace fastscene

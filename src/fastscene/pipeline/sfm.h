// Structure from motion as in the paper: COLMAP estimates the cameras of our views from the pictures alone. Since we
// know them exactly, this measures COLMAP's error.
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

// Similarity that best aligns `found` cameras with `known` ones of the same names: mean rotation between their axes,
// then scale and translation by least squares over the centers. Scale 1 if the centers coincide. Needs one camera in
// common.
Similarity known_from_found(const std::vector<View>& known, const std::vector<Photo>& found);

struct PoseError {
    std::string view;
    bool registered = false;
    double position_m = 0, rotation_deg = 0;
};
struct SfmReport {
    std::string mode;  // colmap or triangulate
    std::size_t views = 0, registered = 0, points = 0;
    double scale = 1;  // metres per unit of COLMAP's model
    double position_median_m = 0, position_max_m = 0, rotation_median_deg = 0, rotation_max_deg = 0;
    double seconds = 0;
    std::vector<PoseError> errors;  // one per view
};
Json to_json(const SfmReport& report);
std::string table_of(const SfmReport& report);

struct SfmResult {
    ViewSet set;  // registered views at the estimated poses, in our frame; COLMAP's points
    SfmReport report;
};
// `dir` holds the views as written by save_views (file names in order). mode "colmap": features, matches, mapper;
// "triangulate": poses are kept, only points are COLMAP's. Creates and removes dir/sfm. Throws Error if colmap is
// missing or fails.
SfmResult structure_from_motion(const std::filesystem::path& dir, const ViewSet& known, const std::string& mode,
                                const Run& run);

}  // namespace fastscene

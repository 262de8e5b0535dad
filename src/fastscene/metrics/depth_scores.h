// Accuracy of an estimated range map: the standard metrics of depth estimation (Eigen et al. 2014), as in EGformer's
// evaluation.
#pragma once

#include <string>
#include <vector>

#include "fastscene/image/image.h"

namespace fastscene {

// Alignment before the comparison. Networks trained with a scale- and shift-invariant loss are evaluated after affine
// alignment per picture, as published.
enum class DepthAlignment {
    none,    // metric evaluation
    scale,   // median of found / true scaled to 1
    affine,  // least squares: true = scale * found + shift
};

struct DepthScores {
    double abs_rel = 0;   // mean |found - true| / true
    double sq_rel = 0;    // mean (found - true)^2 / true, metres
    double rmse = 0;      // metres
    double rmse_log = 0;  // of natural logarithms
    double delta[3]{};    // share of pixels with max(found / true, true / found) < 1.25, 1.25^2, 1.25^3
    double scale = 1, shift = 0;
    std::size_t missing = 0;  // measured pixels for which the estimate is not a number; not counted
    std::size_t pixels = 0;   // number compared: where the truth is finite, > 0 and at most `farthest_m`
};

struct DepthScoreOptions {
    DepthAlignment alignment = DepthAlignment::affine;
    double farthest_m = 10;    // limit of the truth, as in the datasets' own evaluation
    bool solid_angle = false;  // weights pixels by solid angle; published figures weight them equally
    std::string found_name = "estimated range",
                truth_name = "measured range";  // names of the maps in errors: their files
};

// Equirectangular maps in metres of equal size. Throws Error if no pixel can be compared, or sizes differ.
DepthScores depth_scores(const ImageF& found, const ImageF& truth, const DepthScoreOptions& options = {});
// Mean of several pictures' scores, equally weighted; pixel counts are summed.
DepthScores mean_scores(const std::vector<DepthScores>& scores);

}  // namespace fastscene

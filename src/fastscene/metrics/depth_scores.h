// How good is an estimated range map? The measures of the depth literature (Eigen et al. 2014), as EGformer's
// evaluation uses them.
#pragma once

#include <string>
#include <vector>

#include "fastscene/image/image.h"

namespace fastscene {

// What is set right before the comparison. A network that is trained with a scale-and-shift-invariant loss is measured
// after affine alignment, per picture, as published.
enum class DepthAlignment {
    none,    // metres against metres
    scale,   // the median of found / true becomes 1
    affine,  // least squares: true = scale * found + shift
};

struct DepthScores {
    double abs_rel = 0;   // mean |found - true| / true
    double sq_rel = 0;    // mean (found - true)^2 / true, metres
    double rmse = 0;      // metres
    double rmse_log = 0;  // of natural logarithms
    double delta[3]{};    // share of pixels with max(found / true, true / found) < 1.25, 1.25^2, 1.25^3
    double scale = 1, shift = 0;
    std::size_t missing =
        0;  // of the measured pixels, those for which the estimate holds no number: they are not counted
    std::size_t pixels = 0;  // compared: where the truth is finite, > 0 and at most `farthest_m`
};

struct DepthScoreOptions {
    DepthAlignment alignment = DepthAlignment::affine;
    double farthest_m = 10;    // beyond, the truth is not counted (the datasets' own limit)
    bool solid_angle = false;  // weigh pixels by their solid angle; published figures count pixels alike
    std::string found_name = "estimated range",
                truth_name = "measured range";  // what errors call the maps: their files
};

// Equirectangular maps in metres of one size. Throws Error when they have no pixel to compare, or sizes differ.
DepthScores depth_scores(const ImageF& found, const ImageF& truth, const DepthScoreOptions& options = {});
// The mean of several pictures' scores, each picture counted alike; pixels are summed.
DepthScores mean_scores(const std::vector<DepthScores>& scores);

}  // namespace fastscene

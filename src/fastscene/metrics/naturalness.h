// What NIQE and BRISQUE share: natural scene statistics (Ruderman 1994; Mittal, Moorthy, Bovik 2012).
// Brightness made free of local mean and contrast looks Gaussian in undistorted pictures; how its histogram, and
// that of the products of neighbours, departs from that is what both scores read. All in double: the authors' MATLAB
// code is, and in single precision the square root of a cancelled difference is noise in flat areas.
#pragma once

#include <array>
#include <vector>

#include "fastscene/image/image.h"

namespace fastscene {

using Plane = Image<double>;

// MATLAB's rgb2gray: weights of Rec. 601 to 15 digits, rounded to whole numbers, 0..255.
Plane matlab_gray(const ImageRgb8& image);
// The Y of MATLAB's rgb2ycbcr: 16 for black to 235 for white, rounded.
Plane matlab_luma(const ImageRgb8& image);

// No statistics tell anything about a picture of one color.
bool is_constant(const ImageRgb8& image);

// MATLAB's imresize(plane, 0.5): cubic (a = -0.5) widened against aliasing, mirrored at the border; sides rounded up.
Plane matlab_half(const Plane& plane);

// 7 x 7 Gaussian, sigma 7/6; columns of the window first.
inline constexpr int kWindowRadius = 3, kWindowSide = 2 * kWindowRadius + 1;
using Window = std::array<double, kWindowSide * kWindowSide>;
constexpr std::size_t tap(int dx, int dy) {
    return static_cast<std::size_t>((dx + kWindowRadius) * kWindowSide + dy + kWindowRadius);
}
Window gaussian_window();

enum class Border { zero, replicate };
Plane blurred(const Plane& plane, Border border);

// Local contrast and brightness without it: sigma = sqrt|blur(x^2) - blur(x)^2|, (x - blur(x)) / (sigma + offset).
struct Normalized {
    Plane structure, sigma;
};
Normalized normalized(const Plane& plane, Border border, double offset = 1);

// A rectangle of a plane.
struct Block {
    int x = 0, y = 0, width = 0, height = 0;
};
// v(x, y) v(x - dx, y - dy) over the block, which is closed to a torus (MATLAB's circshift).
std::vector<double> neighbor_products(const Plane& plane, Block block, int dy, int dx);
std::vector<double> block_values(const Plane& plane, Block block);

// Generalized Gaussian about 0: shape alpha (2 = normal, 1 = Laplace) by moments, on the grid 0.2, 0.201, … 10.
struct Ggd {
    double alpha = 0, variance = 0;
};
Ggd fit_ggd(const std::vector<double>& values);

// Asymmetric generalized Gaussian: one shape, a deviation for each side. NaN where a side is empty (a flat block).
struct Aggd {
    double alpha = 0, left_std = 0, right_std = 0;
    double scale() const;  // sqrt(Gamma(1/alpha) / Gamma(3/alpha)): beta = std * scale
    double ratio() const;  // Gamma(2/alpha) / Gamma(1/alpha)
};
Aggd fit_aggd(const std::vector<double>& values);

}  // namespace fastscene

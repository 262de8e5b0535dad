// Shared by NIQE and BRISQUE: natural scene statistics (Ruderman 1994; Mittal, Moorthy, Bovik 2012). Locally normalized
// brightness is Gaussian in undistorted pictures; both scores measure how its histogram, and that of products of
// neighbours, deviate from that. In double precision like the authors' MATLAB code: in single precision, the square
// root of a cancelled difference is noise in uniform areas.
#pragma once

#include <array>
#include <vector>

#include "fastscene/image/image.h"

namespace fastscene {

using Plane = Image<double>;

// MATLAB's rgb2gray: Rec. 601 weights to 15 digits, rounded to integers, 0..255.
Plane matlab_gray(const ImageRgb8& image);
// The Y of MATLAB's rgb2ycbcr: 16 for black to 235 for white, rounded.
Plane matlab_luma(const ImageRgb8& image);

// The statistics are undefined for a constant picture.
bool is_constant(const ImageRgb8& image);

// MATLAB's imresize(plane, 0.5): antialiased bicubic (a = -0.5), mirrored borders; sides rounded up.
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

// Local contrast sigma = sqrt|blur(x^2) - blur(x)^2|, and normalized brightness (x - blur(x)) / (sigma + offset) (MSCN
// coefficients).
struct Normalized {
    Plane structure, sigma;
};
Normalized normalized(const Plane& plane, Border border, double offset = 1);

// A rectangle of a plane.
struct Block {
    int x = 0, y = 0, width = 0, height = 0;
};
// v(x, y) v(x - dx, y - dy) over the block, wrapped around (MATLAB's circshift).
std::vector<double> neighbor_products(const Plane& plane, Block block, int dy, int dx);
std::vector<double> block_values(const Plane& plane, Block block);

// Generalized Gaussian with mean 0: shape alpha (2 = normal, 1 = Laplace) by moment matching, on the grid 0.2, 0.201, …
// 10.
struct Ggd {
    double alpha = 0, variance = 0;
};
Ggd fit_ggd(const std::vector<double>& values);

// Asymmetric generalized Gaussian: one shape, a standard deviation per side. NaN if a side is empty (a uniform block).
struct Aggd {
    double alpha = 0, left_std = 0, right_std = 0;
    double scale() const;  // sqrt(Gamma(1/alpha) / Gamma(3/alpha)): beta = std * scale
    double ratio() const;  // Gamma(2/alpha) / Gamma(1/alpha)
};
Aggd fit_aggd(const std::vector<double>& values);

}  // namespace fastscene

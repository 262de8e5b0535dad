// Likeness of two pictures: PSNR and SSIM (Wang, Bovik, Sheikh, Simoncelli 2004), 11x11 Gaussian window, sigma 1.5, K1
// = 0.01, K2 = 0.03. Three definitions are in use and differ in the second decimal, so each has a name (Ssim). splat/
// has a fast SSIM with gradient; this is the readable one that it is tested against.
#pragma once

#include "fastscene/image/image.h"

namespace fastscene {

// Mean squared error over all pixels and channels, sRGB values in [0, 1]. Sizes must be equal.
// `mask`: nonzero = counts; empty = all. NaN when nothing counts.
double mean_squared_error(const ImageRgb8& a, const ImageRgb8& b, const ImageMask& mask = {});
// 10 log10(1 / MSE) in dB; +inf for equal pictures.
double psnr_of_mse(double mse);
inline double psnr(const ImageRgb8& a, const ImageRgb8& b, const ImageMask& mask = {}) {
    return psnr_of_mse(mean_squared_error(a, b, mask));
}

enum class Ssim {
    splats,  // 3D Gaussian splatting papers: per channel, what lies outside the picture counts as 0
    valid,   // scikit-image with Gaussian weights: per channel, only windows inside the picture
    wang,    // the 2004 paper's code: gray = 0.299 R + 0.587 G + 0.114 B, only windows inside the picture
};
// Mean of the SSIM map over pixels and channels, in [-1, 1]. Sizes must be equal; `valid` and `wang` need 11 x 11
// pixels.
double ssim(const ImageRgb8& a, const ImageRgb8& b, Ssim kind = Ssim::splats);

// The same for one channel of any numbers; `peak` is the largest value that a pixel can have.
double ssim_of_channel(const Image<double>& x, const Image<double>& y, double peak, bool windows_inside);
// Derivative of ssim_of_channel (peak 1, zeros outside) by each pixel of x.
Image<double> ssim_gradient(const Image<double>& x, const Image<double>& y);

}  // namespace fastscene

// Image similarity: PSNR and SSIM (Wang, Bovik, Sheikh, Simoncelli 2004) with an 11x11 Gaussian window, sigma 1.5, K1 =
// 0.01, K2 = 0.03. Three variants are in use that differ in the second decimal (enum Ssim). This is the reference
// implementation for the fast SSIM with gradient in splat/.
#pragma once

#include "fastscene/image/image.h"

namespace fastscene {

// Mean squared error over all pixels and channels, of sRGB values in [0, 1]. Sizes must be equal. `mask`: nonzero =
// counted; empty = all. NaN if no pixel is counted.
double mean_squared_error(const ImageRgb8& a, const ImageRgb8& b, const ImageMask& mask = {});
// 10 log10(1 / MSE) in dB; +inf for equal pictures.
double psnr_of_mse(double mse);
inline double psnr(const ImageRgb8& a, const ImageRgb8& b, const ImageMask& mask = {}) {
    return psnr_of_mse(mean_squared_error(a, b, mask));
}

enum class Ssim {
    splats,  // 3D Gaussian splatting papers: per channel, zero padding
    valid,   // scikit-image with Gaussian weights: per channel, only windows inside the picture
    wang,    // the 2004 paper's code: gray = 0.299 R + 0.587 G + 0.114 B, only windows inside the picture
};
// Mean of the SSIM map over pixels and channels, in [-1, 1]. Sizes must be equal; `valid` and `wang` need at least 11 x
// 11 pixels.
double ssim(const ImageRgb8& a, const ImageRgb8& b, Ssim kind = Ssim::splats);

// SSIM (Ssim::splats) of `picture` against a truth of which there are two renderings with independent noise, corrected
// for that noise: the truth's local variance is the covariance of the two, to which their noise adds nothing on
// average.
double ssim_of_noisy_truth(const ImageRgb8& picture, const ImageRgb8& truth, const ImageRgb8& again);

// The same for a single channel of any range; `peak` is the maximum possible value.
double ssim_of_channel(const Image<double>& x, const Image<double>& y, double peak, bool windows_inside);
// Derivative of ssim_of_channel (peak 1, zero padding) with respect to each pixel of x.
Image<double> ssim_gradient(const Image<double>& x, const Image<double>& y);

}  // namespace fastscene

// Likeness of two pictures: PSNR and SSIM (Wang et al. 2004), as 3DGS papers compute them:
// 11x11 Gaussian window, sigma 1.5, zero padding, per sRGB channel, K1 = 0.01, K2 = 0.03, L = 1.
// splat/ has a fast SSIM with gradient; this is the readable one that it is tested against.
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
// Mean of the SSIM map over pixels and channels, in [-1, 1].
double ssim(const ImageRgb8& a, const ImageRgb8& b);

}  // namespace fastscene

// Denoiser: averages the Monte Carlo noise in a picture's light over neighbours on the same surface.
//
// An à-trous wavelet filter (Dammertz et al. 2010) guided by position, normal and the variance of each pixel's mean
// (the spatial part of SVGF, Schied et al. 2017). It filters light only: the caller multiplies textures back in, so
// they stay sharp.
#pragma once

#include "fastscene/image/image.h"

namespace fastscene {

// Light per pixel, and the variance of the mean of its luminance.
struct NoisyLight {
    ImageColor value;
    ImageF variance;
};

struct Guides {
    // world space, at the first hit; a zero normal marks pixels that are neither filtered nor used (sky)
    ImageColor position, normal;
    bool wraps = false;  // a full panorama: the last column is next to the first
    ImageF rays = {};    // ray count per pixel; empty: the same everywhere
    float rays_of(int x, int y) const { return rays.empty() ? 1.f : rays.at(x, y); }
};

// Weight in 0..1 of the pixel (x, y) for a surface at `position` with the unit normal `normal`: 1 = same plane.
float same_surface(const Guides& guides, int x, int y, Vec3f position, Vec3f normal);

// Filters in place with `levels` passes of doubling reach: 2, 4, 8 … pixels. Deterministic for any number of threads.
void denoise(NoisyLight& light, const Guides& guides, int levels);

}  // namespace fastscene

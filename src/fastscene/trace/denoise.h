// Denoise: what chance left in a picture's light, averaged over neighbours on the same surface.
//
// The filter is an à-trous wavelet (Dammertz et al. 2010) guided by position, normal and the variance of each pixel's
// own mean (Schied et al. 2017, without its history). It sees light alone: textures, outlines and whatever else is
// known exactly are put back by the caller.
#pragma once

#include "fastscene/image/image.h"

namespace fastscene {

// Light by pixel, and the variance of the mean of its luminance.
struct NoisyLight {
    ImageColor value;
    ImageF variance;
};

struct Guides {
    ImageColor position, normal;  // of the first hit; a normal of zero: nothing, neither changed nor used
    bool wraps = false;           // the last column is the first one's neighbour
    ImageF rays = {};             // how many a pixel's light is the mean of; empty: all of equally many
    float rays_of(int x, int y) const { return rays.empty() ? 1.f : rays.at(x, y); }
};

// How much a pixel shows the surface at `position`: 1 = the same plane, 0 = another. `normal` of length 1.
float same_surface(const Guides& guides, int x, int y, Vec3f position, Vec3f normal);

// `levels`: neighbours up to 2, 4, 8 … pixels away. The same bytes for any number of threads.
void denoise(NoisyLight& light, const Guides& guides, int levels);

}  // namespace fastscene

// Data augmentation: the same room as seen by many cameras, so that a network trained on our pictures generalizes to
// photos.
#pragma once

#include "fastscene/base/random.h"
#include "fastscene/math/vec.h"
#include "fastscene/nn/egformer_training.h"

namespace fastscene {

struct PhotoLook {
    float turn = 0;  // rotation about the vertical axis, in turns: an exact symmetry of panoramas
    bool mirrored = false;
    float exposure_ev = 0;
    Vec3f white{1, 1, 1};  // multiplies linear color
    float gamma = 1, saturation = 1;
    float blur_px = 0, noise = 0;  // noise: standard deviation of sRGB values
    int jpeg_quality = 100;        // 100 = no compression
};
PhotoLook random_photo_look(Random& rng);

// Rotates and mirrors color and range together; everything else affects color only. `rng` generates the noise.
DepthExample seen_as(const DepthExample& example, const PhotoLook& look, Random& rng);

}  // namespace fastscene

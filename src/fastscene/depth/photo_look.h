// One room seen by many cameras: what training varies so that a network trained on pictures of ours understands photos.
#pragma once

#include "fastscene/base/random.h"
#include "fastscene/math/vec.h"
#include "fastscene/nn/egformer_training.h"

namespace fastscene {

struct PhotoLook {
    float turn = 0;  // about the vertical axis, in whole turns: free on a panorama
    bool mirrored = false;
    float exposure_ev = 0;
    Vec3f white{1, 1, 1};  // multiplies linear color
    float gamma = 1, saturation = 1;
    float blur_px = 0, noise = 0;  // noise: deviation of sRGB values
    int jpeg_quality = 100;        // 100 = never compressed
};
PhotoLook random_photo_look(Random& rng);

// Color and range turned and mirrored together; the rest is done to the color. `rng` makes the noise.
DepthExample seen_as(const DepthExample& example, const PhotoLook& look, Random& rng);

}  // namespace fastscene

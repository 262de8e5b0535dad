// One photo as the beginning of a panorama: where it lies on the sphere, and what surrounds it before anything is
// painted there. Diffusion360's image-to-panorama. Private to nn/ (torch).
#pragma once

#include <ATen/ATen.h>

#include "fastscene/image/image.h"

namespace fastscene::nn {

struct PhotoOnSphere {
    at::Tensor color;  // [1, 3, width / 2, width] in [0, 1]: the photo in the middle; around it, as published, all of
                       // it stretched over the sphere
    at::Tensor mask;   // [1, 1, width / 2, width]: 1 where the photo is
};
// The photo looks along +z (the middle of the panorama) and sees fov_deg from left to right. Throws Error when it is no
// picture.
PhotoOnSphere photo_on_sphere(const ImageRgb8& photo, int width, double fov_deg);

}  // namespace fastscene::nn

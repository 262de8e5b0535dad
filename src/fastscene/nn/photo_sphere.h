// A photo as the start of a panorama: its place on the sphere, and the initial surroundings. For Diffusion360's
// image-to-panorama. Private to nn/ (torch).
#pragma once

#include <ATen/ATen.h>

#include "fastscene/image/image.h"

namespace fastscene::nn {

struct PhotoOnSphere {
    // [1, 3, width / 2, width] in [0, 1]: the photo in the center; around it, as published, the whole photo stretched
    // over the sphere
    at::Tensor color;
    at::Tensor mask;  // [1, 1, width / 2, width]: 1 where the photo is
};
// The photo is centered on +z and has a horizontal field of view of fov_deg. Throws Error for an empty picture.
PhotoOnSphere photo_on_sphere(const ImageRgb8& photo, int width, double fov_deg);

}  // namespace fastscene::nn

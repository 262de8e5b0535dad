// A picture with its mip levels, for Pattern::image.
#pragma once

#include <memory>

#include "fastscene/scene/room.h"

namespace fastscene {

// Half as wide and high; means of linear colors.
ImageRgb8 halved(const ImageRgb8& image);
std::shared_ptr<const TextureImage> texture_image(ImageRgb8 image);
// The same of numbers that are no colors (normals, roughness): means of bytes. Halved first until no side has more
// texels than that.
std::shared_ptr<const TextureImage> data_texture_at_most(ImageRgb8 image, int texels);

}  // namespace fastscene

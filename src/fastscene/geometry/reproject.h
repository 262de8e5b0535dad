// Reproject: pictures move between the sphere and flat cameras. Bilinear at subpixel positions; where
// the target's pixels are larger than the source's, several samples a pixel are averaged (area filter).
#pragma once

#include "fastscene/geometry/pinhole.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/image/image.h"
#include "fastscene/math/rigid.h"

namespace fastscene {

// Bilinear value of an equirectangular picture at picture point `pixel` (pixel centers at +0.5). Columns wrap;
// above the top row the picture goes on over the pole, half a turn away.
Vec3f sample_equirect(const ImageColor& equirect, Vec2f pixel);
// Bilinear value of a flat picture; outside, the border pixel.
Vec3f sample_flat(const ImageColor& picture, Vec2f pixel);

// What a pinhole camera at the panorama's center sees. Rotation pano_from_camera.
ImageColor pinhole_from_equirect(const ImageColor& equirect, const Pinhole& camera, const Mat3f& pano_from_camera);
// The panorama at another size and orientation.
ImageColor equirect_from_equirect(const ImageColor& equirect, EquirectSize size, const Mat3f& source_from_target = {});

}  // namespace fastscene

// Reprojection between the sphere and perspective cameras. Bilinear at subpixel positions; supersampled (area filter)
// where target pixels are larger than the source's.
#pragma once

#include "fastscene/geometry/pinhole.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/image/image.h"
#include "fastscene/math/rigid.h"

namespace fastscene {

// Bilinear sample of an equirectangular picture at picture point `pixel` (pixel centers at +0.5). Columns wrap; above
// the top row the picture continues across the pole.
Vec3f sample_equirect(const ImageColor& equirect, Vec2f pixel);
// Bilinear sample of a perspective picture, clamped at the border.
Vec3f sample_flat(const ImageColor& picture, Vec2f pixel);

// The view of a pinhole camera at the panorama's center. Rotation: pano_from_camera.
ImageColor pinhole_from_equirect(const ImageColor& equirect, const Pinhole& camera, const Mat3f& pano_from_camera);
// The panorama at another size and orientation.
ImageColor equirect_from_equirect(const ImageColor& equirect, EquirectSize size, const Mat3f& source_from_target = {});

}  // namespace fastscene

// Cubemap: the sphere as six perspective faces. Faces may have a field of view above 90 degrees, so that they overlap.
#pragma once

#include <array>
#include <string_view>

#include "fastscene/geometry/reproject.h"

namespace fastscene {

enum class CubeFace { front, right, back, left, up, down };
inline constexpr std::array<CubeFace, 6> kCubeFaces{CubeFace::front, CubeFace::right, CubeFace::back,
                                                    CubeFace::left,  CubeFace::up,    CubeFace::down};
std::string_view name_of(CubeFace face);

// The rotation of a face's camera. The four sides are level; up and down are the front face tilted.
Mat3f pano_from_face(CubeFace face);
// The face whose axis is nearest to the direction.
CubeFace face_of_direction(Vec3f direction);

ImageColor face_from_equirect(const ImageColor& equirect, CubeFace face, const Pinhole& camera);
// Resamples to the sphere: each pixel comes from the face that contains its direction, supersampled where the faces are
// finer. All six pictures were taken with `camera`.
ImageColor equirect_from_faces(const std::array<ImageColor, 6>& faces, const Pinhole& camera, EquirectSize size);

}  // namespace fastscene

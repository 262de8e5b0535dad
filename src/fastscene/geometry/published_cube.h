// The official program's cubemap, reproduced with its quirks so that its figures can be repeated:
// - Faces are ordered back, down, front, left, right, up; x right, y down, z forward.
// - Picture -> faces: longitude and latitude are used as if the centers of the first and last column were at -pi and
// +pi, so W - 1 pixels span 360 degrees (half a pixel off at the seam), without wrapping.
// - Faces -> picture: the same for rows and columns; each pixel samples a single face. It is built for faces of
// `cube_length` pixels but given smaller ones: 512 instead of 1024.
// For other purposes use cubemap.h. Paper: E2C, C2E; see docs/decisions/0010.
#pragma once

#include <array>

#include "fastscene/geometry/cubemap.h"

namespace fastscene {

inline constexpr std::array<CubeFace, 6> kPublishedFaces{CubeFace::back, CubeFace::down,  CubeFace::front,
                                                         CubeFace::left, CubeFace::right, CubeFace::up};

enum class PublishedSampling { bilinear, nearest };

// Direction of each pixel of a face: (longitude / pi, latitude / (pi/2)), latitude growing downward. size >= 2.
Image<Vec2f> published_face_grid(CubeFace face, int size);
ImageColor published_face(const ImageColor& equirect, CubeFace face, int size,
                          PublishedSampling sampling = PublishedSampling::bilinear);
ImageF published_face(const ImageF& equirect, CubeFace face, int size,
                      PublishedSampling sampling = PublishedSampling::bilinear);

// The face (index into kPublishedFaces) that contains each pixel of a 2 height x height picture.
ImageMask published_face_index(int height);
// `faces` in the order of kPublishedFaces, square and of one size; cube_length: the size they are assumed to have.
ImageColor published_equirect(const std::array<ImageColor, 6>& faces, int cube_length, int height);

}  // namespace fastscene

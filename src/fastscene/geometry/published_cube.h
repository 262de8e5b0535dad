// The cubemap of the official program, kept with its habits so that its figures can be repeated:
//   - Faces come in the order back, down, front, left, right, up; x right, y down, z forward.
//   - Picture -> faces: longitude and latitude are used as if the first and the last column's centers lay at -pi and
//   +pi, so
//     W - 1 pixels span the turn (half a pixel off at the seam), and nothing wraps.
//   - Faces -> picture: the same for rows and columns; each pixel samples inside one face only. It is built for faces
//   of
//     `cube_length` pixels, and fed with smaller ones: 512 where 1024 was meant.
// For other work use cubemap.h. Paper: E2C, C2E; see docs/decisions/0010.
#pragma once

#include <array>

#include "fastscene/geometry/cubemap.h"

namespace fastscene {

inline constexpr std::array<CubeFace, 6> kPublishedFaces{CubeFace::back, CubeFace::down,  CubeFace::front,
                                                         CubeFace::left, CubeFace::right, CubeFace::up};

enum class PublishedSampling { bilinear, nearest };

// Where each pixel of a face looks: (longitude / pi, latitude / (pi/2)), latitude growing downward. size >= 2.
Image<Vec2f> published_face_grid(CubeFace face, int size);
ImageColor published_face(const ImageColor& equirect, CubeFace face, int size,
                          PublishedSampling sampling = PublishedSampling::bilinear);
ImageF published_face(const ImageF& equirect, CubeFace face, int size,
                      PublishedSampling sampling = PublishedSampling::bilinear);

// Which face (index into kPublishedFaces) each pixel of a picture of 2 height x height looks through.
ImageMask published_face_index(int height);
// `faces` in the order of kPublishedFaces, square and of one size; cube_length: the size they are taken for.
ImageColor published_equirect(const std::array<ImageColor, 6>& faces, int cube_length, int height);

}  // namespace fastscene

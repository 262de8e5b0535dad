// The official program's inpainting of a panorama (the paper's PNVI, one step): holes go to six cube faces, each face
// is painted, and only hole pixels of the panorama are replaced by what comes back. Everything passes through 8 bits,
// cut off, not rounded.
#pragma once

#include <array>
#include <functional>

#include "fastscene/geometry/published_cube.h"

namespace fastscene {

struct PublishedFace {
    ImageRgb8 color;  // holes white
    ImageMask hole;   // nonzero = a hole: any face pixel that a hole's pixel touches
};
// In the order of kPublishedFaces. `hole`: nonzero = a hole.
// The masks alone.
std::array<ImageMask, 6> published_hole_faces(const ImageMask& hole, int face_size);
std::array<PublishedFace, 6> published_faces(const ImageRgb8& color, const ImageMask& hole, int face_size);
// `painted` goes back with the official's factor of two between the size that is meant and the size that is there.
ImageRgb8 published_merge(const ImageRgb8& color, const ImageMask& hole, const std::array<ImageRgb8, 6>& painted);

// Paints a flat picture; may change known pixels too (they are dropped in the merge, but for the faces' seams).
using Painter = std::function<ImageRgb8(const ImageRgb8& color, const ImageMask& hole)>;
ImageRgb8 published_inpaint(const ImageRgb8& color, const ImageMask& hole, int face_size, const Painter& paint);

}  // namespace fastscene

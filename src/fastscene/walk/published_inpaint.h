// The official program's panorama inpainting (one step of the paper's PNVI): holes are projected to six cube faces,
// each face is inpainted, and only the panorama's hole pixels are replaced by the result. All values pass through 8
// bits by truncation.
#pragma once

#include <array>
#include <functional>

#include "fastscene/geometry/published_cube.h"

namespace fastscene {

struct PublishedFace {
    ImageRgb8 color;  // holes white
    ImageMask hole;   // nonzero = hole: any face pixel touched by a hole pixel
};
// In the order of kPublishedFaces. `hole`: nonzero = hole. Masks only.
std::array<ImageMask, 6> published_hole_faces(const ImageMask& hole, int face_size);
std::array<PublishedFace, 6> published_faces(const ImageRgb8& color, const ImageMask& hole, int face_size);
// Projects `painted` back, with the official program's mismatch of a factor of two between the assumed and the actual
// face size.
ImageRgb8 published_merge(const ImageRgb8& color, const ImageMask& hole, const std::array<ImageRgb8, 6>& painted);

// Inpaints a perspective picture. May change known pixels, which the merge drops except at face borders.
using Painter = std::function<ImageRgb8(const ImageRgb8& color, const ImageMask& hole)>;
ImageRgb8 published_inpaint(const ImageRgb8& color, const ImageMask& hole, int face_size, const Painter& paint);

}  // namespace fastscene

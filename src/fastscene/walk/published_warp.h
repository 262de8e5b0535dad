// The official program's coarse view (the paper's CVS), with its habits: a pixel's direction is that of its upper left
// corner; each pixel of the source lands on one pixel of the target, found by floor, the nearest wins; row 0 and column
// 0 are never written and nothing wraps. So cracks open even where nothing was hidden, and the far shines through the
// near. docs/decisions/0010 lists what was observed.
#pragma once

#include <algorithm>
#include <cstdint>

#include "fastscene/image/image.h"

namespace fastscene {

inline constexpr std::int32_t kNoSource = -1;

struct PublishedWarp {
    ImageRgb8 color;             // holes white
    Image<double> range;         // from the new position; holes 0
    Image<std::int32_t> source;  // index of the pixel that landed here, or kNoSource: a hole
    double hole_ratio() const;
};

// `move` in the units of `range`, in the official frame: x towards the middle of the picture, y up, z to its right.
// Sizes must agree; ranges > 0. A tie in distance goes to the first pixel in reading order.
PublishedWarp published_warp(const ImageRgb8& color, const Image<double>& range, Vec3d move);

// The official program computes in double.
inline Image<double> in_double(const ImageF& image) {
    Image<double> out(image.width, image.height);
    std::copy(image.pixels.begin(), image.pixels.end(), out.pixels.begin());
    return out;
}

// Unit directions of a picture's pixels, official frame.
Image<Vec3d> published_directions(int width, int height);

// The official units: a share of the greatest range; what is unknown (0) lies at the greatest. Not finite: likewise.
Image<double> published_units(const Image<double>& range);

// The eight ways in which the official program walks, in its order; diagonals are longer by a square root of two, as
// published.
struct PublishedDirection {
    const char* name;
    Vec3d move;  // official frame
};
inline constexpr PublishedDirection kPublishedDirections[] = {
    {"+x", {1, 0, 0}},  {"-x", {-1, 0, 0}},   {"+z", {0, 0, 1}},    {"-z", {0, 0, -1}},
    {"+xz", {1, 0, 1}}, {"-xz", {-1, 0, -1}}, {"+x-z", {1, 0, -1}}, {"-x+z", {-1, 0, 1}}};

// World (x right, y down, z forward) from the official frame.
template <class F>
constexpr Vec3<F> world_from_published(Vec3<F> p) {
    return {p.z, -p.y, p.x};
}

}  // namespace fastscene

// The official program's coarse view (the paper's CVS), reproduced with its quirks: a pixel's direction is that of its
// top left corner; each source pixel is forward-mapped to one target pixel by floor, nearest range wins; row 0 and
// column 0 are never written, and nothing wraps. This opens cracks where nothing is disoccluded, and background shows
// through foreground. docs/decisions/0010 lists the observations.
#pragma once

#include <algorithm>
#include <cstdint>

#include "fastscene/image/image.h"

namespace fastscene {

inline constexpr std::int32_t kNoSource = -1;

struct PublishedWarp {
    ImageRgb8 color;             // holes white
    Image<double> range;         // from the new position; 0 in holes
    Image<std::int32_t> source;  // index of the source pixel, or kNoSource for a hole
    double hole_ratio() const;
};

// `move`: in units of `range`, in the official frame: x towards the picture's center, y up, z to its right. Sizes must
// match; ranges > 0. Ties in distance go to the first pixel in reading order.
PublishedWarp published_warp(const ImageRgb8& color, const Image<double>& range, Vec3d move);

// The official program computes in double precision.
inline Image<double> in_double(const ImageF& image) {
    Image<double> out(image.width, image.height);
    std::copy(image.pixels.begin(), image.pixels.end(), out.pixels.begin());
    return out;
}

// Unit directions of a picture's pixels, official frame.
Image<Vec3d> published_directions(int width, int height);

// Range in official units, as a share of the greatest range; unknown (0) and non-finite pixels get the greatest.
Image<double> published_units(const Image<double>& range);

// The eight directions of the official program, in its order; diagonals are longer by sqrt(2), as published.
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

// Editing operations on splats that need no pictures: transforming, selecting, reducing SH degrees, cleaning.
#pragma once

#include <cstdint>
#include <vector>

#include "fastscene/scene/splats.h"

namespace fastscene {

// p_new = scale * new_from_old * p_old + translation. new_from_old is orthogonal; reflections also mirror shapes and
// colors. scale > 0.
struct Similarity {
    Mat3d new_from_old;
    double scale = 1;
    Vec3d translation;
};
Similarity inverse(const Similarity& new_from_old);
Similarity compose(const Similarity& c_from_b, const Similarity& b_from_a);
void transform(Splats& splats, const Similarity& new_from_old);

// The splats with the given indices, in that order.
Splats chosen(const Splats& splats, const std::vector<std::uint32_t>& indices);
// The splats whose means lie inside the box.
Splats cropped(const Splats& splats, Vec3f low_m, Vec3f high_m);
// The `count` splats with the largest coverage (opacity times largest cross section), in their original order.
Splats strongest(const Splats& splats, std::size_t count);
// The splats with at least this opacity, 0..1.
Splats opaque(const Splats& splats, float least_opacity);
// Drops SH degrees above `degree`; does not add missing ones.
void reduce_sh(Splats& splats, int degree);
// Drops the highest SH degrees while all their coefficients are zero.
void trim_sh(Splats& splats);

// Makes all splats drawable. Drops those with NaN, or an infinite position, size or color; repairs infinite opacities,
// zero sizes and zero quaternions, whose meaning is clear.
struct Cleaning {
    std::size_t dropped = 0, repaired = 0;
};
Cleaning clean(Splats& splats);

}  // namespace fastscene

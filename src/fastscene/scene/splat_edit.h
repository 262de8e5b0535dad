// What can be done to splats without looking at pictures: other axes, fewer of them, fewer bands, no broken ones.
#pragma once

#include <cstdint>
#include <vector>

#include "fastscene/scene/splats.h"

namespace fastscene {

// p_new = scale * new_from_old * p_old + translation. new_from_old is orthogonal; with a mirror in it the splats are
// mirrored, too (their shapes and colors with them). scale > 0.
struct Similarity {
    Mat3d new_from_old;
    double scale = 1;
    Vec3d translation;
};
Similarity inverse(const Similarity& new_from_old);
Similarity compose(const Similarity& c_from_b, const Similarity& b_from_a);
void transform(Splats& splats, const Similarity& new_from_old);

// Those of the given indices, in that order.
Splats chosen(const Splats& splats, const std::vector<std::uint32_t>& indices);
// Those whose means lie inside.
Splats cropped(const Splats& splats, Vec3f low_m, Vec3f high_m);
// The `count` that cover most (opacity times the area of the largest shadow), in their old order.
Splats strongest(const Splats& splats, std::size_t count);
// Those at least this opaque, 0..1.
Splats opaque(const Splats& splats, float least_opacity);
// Bands above `degree` are dropped; missing ones are not added.
void reduce_sh(Splats& splats, int degree);
// Drops the highest bands while all of their coefficients are zero.
void trim_sh(Splats& splats);

// Makes every number one that can be drawn. Splats with a NaN, or an infinite place, size or color, are dropped; an
// opacity of infinity, a size of zero and a quaternion of length zero have a meaning and are repaired.
struct Cleaning {
    std::size_t dropped = 0, repaired = 0;
};
Cleaning clean(Splats& splats);

}  // namespace fastscene

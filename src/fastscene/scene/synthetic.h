// Synthetic worlds with known truth: a box room with boxes in it, seen exactly from any pose.
#pragma once

#include <vector>

#include "fastscene/scene/panorama.h"

namespace fastscene {

enum class SyntheticPaint { plain, smooth, checker, planks };

struct SyntheticBox {
    Vec3f low, high;  // world, metres
    Vec3f color;      // linear
    SyntheticPaint paint = SyntheticPaint::plain;
};
struct SyntheticWorld {
    SyntheticBox room;                // seen from inside
    std::vector<SyntheticBox> boxes;  // seen from outside
    SyntheticPaint floor = SyntheticPaint::plain;

    // A room of 5 x 2.7 x 6 m about the origin, with a table, a cupboard and a sofa of boxes.
    static SyntheticWorld furnished(SyntheticPaint walls, SyntheticPaint floor);
};

struct SyntheticHit {
    float range = 0;
    Vec3f color;
};
// What the ray from `origin` along the unit vector `direction` meets. `origin` must lie in the room.
SyntheticHit trace_synthetic(const SyntheticWorld& world, Vec3f origin, Vec3f direction);
// `samples` x `samples` rays a pixel for the color; the range is the middle ray's.
Panorama render_synthetic(const SyntheticWorld& world, Vec3f position, EquirectSize size, int samples = 2);

}  // namespace fastscene

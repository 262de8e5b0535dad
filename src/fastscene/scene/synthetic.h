// Synthetic worlds with exact ground truth: a box room with boxes, rendered from any pose.
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

    // A room of 5 x 2.7 x 6 m centered at the origin, with a table, a cupboard and a sofa made of boxes.
    static SyntheticWorld furnished(SyntheticPaint walls, SyntheticPaint floor);
};

struct SyntheticHit {
    float range = 0;
    Vec3f color;
};
// The hit of a ray from `origin`, which must be inside the room, along the unit vector `direction`.
SyntheticHit trace_synthetic(const SyntheticWorld& world, Vec3f origin, Vec3f direction);
// `samples` x `samples` rays per pixel for color; range is that of the center ray.
Panorama render_synthetic(const SyntheticWorld& world, Vec3f position, EquirectSize size, int samples = 2);

}  // namespace fastscene

// Where a visitor's eyes may be: a floor with holes, and a range of heights over it.
#pragma once

#include <vector>

#include "fastscene/math/vec.h"

namespace fastscene {

// World frame, metres. A point on the floor is a Vec2f whose x and y are the world's x and z. The world's y points
// down, so low_y is how far up the eyes may go and high_y how far down.
struct WalkableArea {
    // Closed polygons, the last vertex joined to the first; outlines and holes (furniture) alike, even-odd rule.
    std::vector<std::vector<Vec2f>> rings_m;
    float low_y = 0, high_y = 0;  // the eyes stay within [low_y, high_y]
    float floor_y = 0;            // eye heights count from here
};

bool contains(const WalkableArea& area, Vec2f point);
bool contains(const WalkableArea& area, Vec3f position);
// The point itself where the area contains it, else the nearest one that it contains, a millimetre off the boundary.
Vec2f nearest_inside(const WalkableArea& area, Vec2f point);
Vec3f nearest_inside(const WalkableArea& area, Vec3f position);
// Square metres; its sign tells which way round the ring goes.
double signed_area(const std::vector<Vec2f>& ring);
// Index of the ring that encloses most floor.
std::size_t largest_ring(const WalkableArea& area);

}  // namespace fastscene

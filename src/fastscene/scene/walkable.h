// Where a visitor's eyes may be: a floor polygon with holes, and a range of heights above it.
#pragma once

#include <vector>

#include "fastscene/math/vec.h"

namespace fastscene {

// World frame, metres. A point on the floor is a Vec2f with the world's x and z. The world's y points down, so low_y is
// the upper and high_y the lower limit of the eyes.
struct WalkableArea {
    // Closed polygons, the last vertex connected to the first; outlines and holes (furniture) alike, even-odd rule.
    std::vector<std::vector<Vec2f>> rings_m;
    float low_y = 0, high_y = 0;  // above floor_y eyes stay within [low_y, high_y]
    float floor_y = 0;            // reference of eye heights: of the lowest floor
    // Of a floor with tiers and steps: its parts, each of one height, and above each the eyes as far from it as above
    // floor_y. Empty: all of it is level.
    struct Level {
        std::vector<std::vector<Vec2f>> rings_m;
        float floor_y = 0;
    };
    std::vector<Level> levels = {};
};

// The floor (world y) at a point of the area; elsewhere that of the nearest part. And how far above floor_y it is.
float floor_at(const WalkableArea& area, Vec2f point);
inline float raised_at(const WalkableArea& area, Vec2f point) {
    return area.levels.empty() ? 0.f : area.floor_y - floor_at(area, point);
}

bool contains(const WalkableArea& area, Vec2f point);
bool contains(const WalkableArea& area, Vec3f position);
// The point itself if the area contains it, else the nearest contained point, a millimetre off the boundary.
Vec2f nearest_inside(const WalkableArea& area, Vec2f point);
Vec3f nearest_inside(const WalkableArea& area, Vec3f position);
// Square metres; the sign gives the ring's orientation.
double signed_area(const std::vector<Vec2f>& ring);
// Index of the ring with the largest area.
std::size_t largest_ring(const WalkableArea& area);

}  // namespace fastscene

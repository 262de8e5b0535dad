// Openings: where a wall ends because panorama 0 looked through it (windows, open doors). A ray that leaves the room
// there must not end on a continuation of the wall.
#pragma once

#include "fastscene/image/image.h"
#include "fastscene/scene/panorama.h"
#include "fastscene/walk/planes.h"

namespace fastscene {

enum class Wall : std::uint8_t { solid, open, sky };  // sky: panorama 0 saw only the outside through it

struct Openings {
    Image<Wall> wall;   // on the grid of the plane's picture; hidden positions copy the nearest visible one
    float depth_m = 0;  // distance of the window frame behind the wall
    bool any() const { return !wall.empty(); }
};
// `plane`: a hull plane whose grid starts at `low` and has the size of `grid`. Empty if panorama 0 nowhere saw through
// it.
Openings find_openings(const ImageF& range, const ScenePlane& plane, EquirectSize grid, float metres_per_pixel);

}  // namespace fastscene

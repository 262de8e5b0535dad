// Openings: where a wall ends because panorama 0 looked through it: windows, open doors. A ray that leaves the room
// there must not end on a wall continued outside.
#pragma once

#include "fastscene/image/image.h"
#include "fastscene/scene/panorama.h"
#include "fastscene/walk/planes.h"

namespace fastscene {

enum class Wall : std::uint8_t { solid, open, sky };  // sky: panorama 0 saw nothing but the outside through it

struct Openings {
    Image<Wall> wall;   // on the grid of the plane's picture; what is hidden takes after the nearest place seen
    float depth_m = 0;  // how far behind the wall the window's frame stands
    bool any() const { return !wall.empty(); }
};
// `plane`: of the hull; its grid begins at `low`, and has the size of `grid`. Empty when panorama 0 saw through it
// nowhere.
Openings find_openings(const ImageF& range, const ScenePlane& plane, EquirectSize grid, float metres_per_pixel);

}  // namespace fastscene

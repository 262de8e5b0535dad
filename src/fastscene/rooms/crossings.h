// Crossings: what reaches into something solid, found on the triangles. The layout's boxes (validate.h) miss what is
// not a box: a leaf in a wall, a handle in a bed, a lamp in a beam.
#pragma once

#include <vector>

#include "fastscene/scene/room.h"

namespace fastscene {

struct Crossing {
    int object;  // index into Room::objects: what reaches …
    int into;    // … into which object; -1: the shell
    Vec3f at;    // world, the deepest point that was found
    float depth_m;
};

// Pairs of things of which one has points deeper than `tolerance_m` inside the other. Looked at are corners and points
// along edges, every 2 cm. What may sink (rugs under legs, cushions), what belongs to the shell (windows, doors,
// panels) against the shell, and the roses of hanging lamps are left out.
std::vector<Crossing> room_crossings(const Room& room, float tolerance_m = 0.012f);

}  // namespace fastscene

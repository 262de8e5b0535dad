// Boxes with doors, drawers or open compartments.
#pragma once

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// A case of boards: sides, top, bottom, back; the front is open.
void carcass(Kit& k, int wood, Vec3f s, float y0, float t = 0.022f);

// A closed cabinet on legs or a plinth with a grid of fronts.
void chest(Kit& k, Vec3f s, float leg, int columns, int rows, float clearance);

// Sliding doors of upright slats.
void slatted_chest(Kit& k, Vec3f s, float leg, float clearance);

bool slatted(Kit& k);

// What stands on one shelf: books, a vase, a basket, a bowl; `room_y` = free height.
void fill_shelf(Kit& k, float x0, float x1, float y, float room_y, float z_back, float depth);

}  // namespace fastscene::furniture

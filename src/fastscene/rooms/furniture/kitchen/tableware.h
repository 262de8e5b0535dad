// Cups, plates, bottles.
#pragma once

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

int glazed(Kit& k);

void bottle_at(Kit& k, int mat, Vec3f at, float r, float h);

}  // namespace fastscene::furniture

// What kitchen units and washbasins share: fronts, worktop, tap.
#pragma once

#include <string>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// A part of the units in what was asked for it.
Material part_in(Material usual, const std::string& material, const std::string& color);

Material worktop(const Kit& k);

Material kitchen_front(const Kit& k);

void tap(Kit& k, int chrome, Vec3f at, float h);

}  // namespace fastscene::furniture

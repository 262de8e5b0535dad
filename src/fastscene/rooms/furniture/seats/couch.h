// An upholstered seat with arms, back and cushions.
#pragma once

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// Sofas of any width: seat cushions, back cushions, arms by the style's type.
void couch(Kit& k, float width, int seats, int pillows);

}  // namespace fastscene::furniture

// Fur.
#pragma once

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// Short fur, darker in its depth.
Material coat_of(Vec3f color);

}  // namespace fastscene::furniture

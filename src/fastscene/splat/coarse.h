// Half-size views for the first training steps: a quarter of the cost, and large errors show just as well.
#pragma once

#include "fastscene/scene/view.h"

namespace fastscene::splat {

// Averages 2 x 2 pixels, weighted by their mask weights. An odd last column or row is dropped. Views too small to be
// halved, and equirectangular ones of odd size, are returned unchanged.
View half_view(const View& view);

}  // namespace fastscene::splat

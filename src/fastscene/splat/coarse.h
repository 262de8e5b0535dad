// Views of half the size: what the first steps look at. They cost a quarter, and what is far from right is as wrong in
// them.
#pragma once

#include "fastscene/scene/view.h"

namespace fastscene::splat {

// Each pixel the mean of four, weighted as they are. A last odd column or row is left out; a view too small to be
// halved, and an equirectangular one of odd size, whose camera could not be, comes back as it is.
View half_view(const View& view);

}  // namespace fastscene::splat

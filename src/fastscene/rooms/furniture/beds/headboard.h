// Headboards, by form.
#pragma once

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void headboard(Kit& k, BedForm form, float width, float length, int wood, int head);

}  // namespace fastscene::furniture

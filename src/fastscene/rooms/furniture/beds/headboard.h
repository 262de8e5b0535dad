// Headboards, by form.
#pragma once

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

enum class BedForm { panels, tufted, slats, board, low, iron, posts };
void headboard(Kit& k, BedForm form, float width, float length, int wood, int head);

}  // namespace fastscene::furniture

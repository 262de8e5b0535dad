// Steps of make_plan. Private to rooms/plan*.cc.
#pragma once

#include "fastscene/rooms/plan.h"

namespace fastscene {

// One of the paints that go with the room's style.
void choose_paint(const PromptSpec& spec, Plan& plan, Random& dice);
// Tiles for a bathroom or laundry, as the style has them.
void tile_wet_room(Plan& plan, Random& dice);

}  // namespace fastscene

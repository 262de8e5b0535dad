// What stands around the house, by Sky::View.
#pragma once

#include "fastscene/scene/room.h"
#include "fastscene/trace/outdoors_world.h"

namespace fastscene::outdoors {

// `facing`: azimuth (atan2(x, z)) that the main window looks to; streets and garden are laid out along it.
World make_world(const Sky& sky, float facing);

}  // namespace fastscene::outdoors

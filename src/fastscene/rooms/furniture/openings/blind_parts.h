// Blinds and shutters: what hangs in windows besides curtains. They fill their opening: size.x by size.y, origin at the
// middle of the lower edge of the opening's outer plane; what is drawn up leaves the lower part free.
#pragma once

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

inline constexpr Vec3f kUsualWindow{1.2f, 1.35f, 0.05f};

// Of cloth: what is dyed deeply lets less through.
int blind_cloth(Kit& k, Material m, float through);

// Where a drawn blind ends: its share of the window, by the request's seed alone, so that all windows of a room are
// drawn alike.
float drawn(Kit& k, float least, float most);

}  // namespace fastscene::furniture

// Table tops on legs, and the cloth on them.
#pragma once

#include <span>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// A rectangular table: top, apron, legs. size.y is the height of the top.
void plain_table(Kit& k, Vec3f s, float thick);

void round_table(Kit& k, float d, float y, float thick);

// A cloth over a top of this outline (counter-clockwise from above): it lies on it, and hangs over its rim in folds.
void lay_cloth_on(Kit& k, std::span<const Vec2f> rim, float y, float down);

// The same over a rectangular table of this size, by the cloth solver: its corners hang in folds.
void drape_cloth_over(Kit& k, Vec3f size, float down);

bool has_cloth(const Kit& k);

}  // namespace fastscene::furniture

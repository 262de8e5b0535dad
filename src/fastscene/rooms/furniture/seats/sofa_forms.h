// The forms that distinguish a sofa or an armchair of one style from that of another.
#pragma once

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void frame_sofa(Kit& k, float width, int seats);
void chesterfield(Kit& k, float width, int seats);
void channel_seat(Kit& k, float width, int channels);  // a sofa, or a tub chair when narrow

void wing_chair(Kit& k);
void sling_chair(Kit& k);
void rattan_chair(Kit& k);

}  // namespace fastscene::furniture

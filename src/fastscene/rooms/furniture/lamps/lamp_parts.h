// Shades and feet that lamps of a style share.
#pragma once

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// A shade of the style's family whose lower rim is at y, radius r; the light of the bulb inside. `paper`: what a paper
// shade is made of.
void lamp_head(Kit& k, float y, float r, bool hanging, LampFamily family, int paper = -1);

void lamp_head(Kit& k, float y, float r, bool hanging);

int lamp_metal(Kit& k);

void foot_disc(Kit& k, int m, float r);

}  // namespace fastscene::furniture

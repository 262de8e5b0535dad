// Motifs: what a picture can show because the prompt speaks of it ("a pirate bedroom", "a painting of a lion").
#pragma once

#include <string_view>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

bool is_motif(std::string_view name);

// A flat print of this motif on the plane z = `at.z`, centered at `at`, within `width` by `height`; its ground is the
// picture's main material.
void draw_motif(Kit& k, std::string_view name, Vec3f at, float width, float height);

}  // namespace fastscene::furniture

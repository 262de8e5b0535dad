// Pictures for walls that are bare.
#pragma once

#include <string>

#include "fastscene/rooms/layout.h"

namespace fastscene::furnishing {

// Hangs pictures (pieces of this kind), or one across two or three frames, in the middle of the longest bare stretches
// of wall, each in proportion to its stretch, until `most` groups hang or no stretch is left.
void hang_art(Layout& layout, const std::string& kind, int most);

}  // namespace fastscene::furnishing

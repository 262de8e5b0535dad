// Silhouettes: pixels that show two surfaces, told apart. A range map says which surface the middle of a pixel lies on;
// how much of the pixel that surface covers stands in its color, and with it where within the pixel the silhouette
// runs.
#pragma once

#include "fastscene/image/image.h"

namespace fastscene {

struct Silhouettes {
    ImageColor color;  // of each pixel its own surface's
    // How much of the pixel its own surface covers, from 0 (half of it) to 255 (all of it); what color does not tell
    // stands at kUsualShare.
    ImageMask share;
};
// The cut between two pixels, seen from the first one's middle towards the second's, runs at 0.5 + own_share(first) -
// own_share(second) of the way.
inline constexpr std::uint8_t kUsualShare = 128;
inline float own_share(std::uint8_t share) { return 0.5f + 0.5f / 255.f * static_cast<float>(share); }

// `color` linear in light, W x H, columns wrap; `cuts` by range_edges.
Silhouettes find_silhouettes(const ImageColor& color, const ImageMask& cuts);

}  // namespace fastscene

// Silhouettes: separates the two surfaces mixed in a pixel (alpha matting). The range map tells which surface the
// pixel's center is on; the color tells how much of the pixel it covers, and thus where within the pixel the silhouette
// is.
#pragma once

#include "fastscene/image/image.h"

namespace fastscene {

struct Silhouettes {
    ImageColor color;  // each pixel's own surface color
    // Coverage of the pixel by its own surface, from 0 (half) to 255 (all); kUsualShare where the color does not tell.
    ImageMask share;
};
// The cut between two pixels, as a fraction of the way from the first center to the second: 0.5 + own_share(first) -
// own_share(second).
inline constexpr std::uint8_t kUsualShare = 128;
inline float own_share(std::uint8_t share) { return 0.5f + 0.5f / 255.f * static_cast<float>(share); }

// `color`: linear, W x H, columns wrap; `cuts`: from range_edges.
Silhouettes find_silhouettes(const ImageColor& color, const ImageMask& cuts);

}  // namespace fastscene

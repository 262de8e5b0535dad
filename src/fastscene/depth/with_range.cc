#include <algorithm>
#include <utility>

#include "fastscene/depth/depth.h"
#include "fastscene/geometry/range_edges.h"

namespace fastscene {
namespace {

// Replaces unknown pixels by the mean of their known surroundings, from small neighbourhoods to large ones; columns
// wrap. Works on 1/range, so that the sky (0) can be averaged.
void fill_unknown(ImageF& inverse, ImageMask& known) {
    if (inverse.width <= 1 || inverse.height <= 1) return;
    const int w = (inverse.width + 1) / 2, h = (inverse.height + 1) / 2;
    ImageF half(w, h);
    ImageMask half_known(w, h);
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            float sum = 0;
            int count = 0;
            for (int j = 2 * y; j < std::min(2 * y + 2, inverse.height); ++j)
                for (int i = 2 * x; i < std::min(2 * x + 2, inverse.width); ++i)
                    if (known.at(i, j)) sum += inverse.at(i, j), ++count;
            half_known.at(x, y) = count > 0;
            if (count) half.at(x, y) = sum / static_cast<float>(count);
        }
    if (std::any_of(half_known.pixels.begin(), half_known.pixels.end(), [](std::uint8_t v) { return v == 0; }))
        fill_unknown(half, half_known);
    for (int y = 0; y < inverse.height; ++y)
        for (int x = 0; x < inverse.width; ++x)
            if (!known.at(x, y)) inverse.at(x, y) = half.at(x / 2, y / 2);
    // A few smoothing sweeps remove block artifacts.
    for (int sweep = 0; sweep < 8; ++sweep)
        for (int y = 0; y < inverse.height; ++y)
            for (int x = 0; x < inverse.width; ++x) {
                if (known.at(x, y)) continue;
                const int up = std::max(0, y - 1), down = std::min(inverse.height - 1, y + 1);
                inverse.at(x, y) = 0.25f * (inverse.at(wrap_column(x - 1, inverse.width), y) +
                                            inverse.at(wrap_column(x + 1, inverse.width), y) + inverse.at(x, up) +
                                            inverse.at(x, down));
            }
}

}  // namespace

Panorama with_range(Panorama panorama, ImageF range, std::string_view source) {
    if (!range.same_size(panorama.color))
        throw Error("{}: expected the panorama's size {} x {}, found {} x {}", source, panorama.color.width,
                    panorama.color.height, range.width, range.height);
    ImageMask known(range.width, range.height);
    bool any = false, all = true;
    for (int y = 0; y < range.height; ++y)
        for (int x = 0; x < range.width; ++x) {
            const float r = range.at(x, y);
            if (!(r >= 0.f))
                throw Error("{}: expected metres >= 0 (0 = unknown), found {} at ({}, {})", source, r, x, y);
            known.at(x, y) = r > 0.f;
            any |= r > 0.f;
            all &= r > 0.f;
        }
    if (!any) throw Error("{}: expected ranges in metres, found zeros only", source);
    if (!all) {
        ImageF inverse(range.width, range.height);
        for (std::size_t i = 0; i < range.size(); ++i)
            if (known.pixels[i]) inverse.pixels[i] = inverse_range(range.pixels[i]);
        fill_unknown(inverse, known);
        for (std::size_t i = 0; i < range.size(); ++i)
            if (!known.pixels[i]) range.pixels[i] = 1.f / std::max(inverse.pixels[i], 1.f / kFarthestRange);
    }
    panorama.range = std::move(range);
    return panorama;
}

}  // namespace fastscene

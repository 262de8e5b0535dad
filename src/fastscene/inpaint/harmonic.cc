#include "fastscene/inpaint/harmonic.h"

#include <algorithm>

namespace fastscene {
namespace {

// Relaxation sweeps per level: starting from the coarser level's solution, few are enough.
constexpr int kSweeps = 24;

struct Level {
    ImageColor color;
    ImageMask hole;
};

// Downsamples by 2: a pixel is the mean of its known children, and a hole only if it has none.
Level coarser(const Level& fine) {
    const int w = (fine.color.width + 1) / 2, h = (fine.color.height + 1) / 2;
    Level out{ImageColor(w, h), ImageMask(w, h)};
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            Vec3f sum;
            int count = 0;
            for (int j = 2 * y; j < std::min(2 * y + 2, fine.color.height); ++j)
                for (int i = 2 * x; i < std::min(2 * x + 2, fine.color.width); ++i)
                    if (!fine.hole.at(i, j)) {
                        sum += fine.color.at(i, j);
                        ++count;
                    }
            out.hole.at(x, y) = count == 0;
            if (count) out.color.at(x, y) = sum / static_cast<float>(count);
        }
    return out;
}

// Red-black Gauss-Seidel. Every new value is a mean of existing ones, so values stay within the rim's range.
void relax(Level& level) {
    const int w = level.color.width, h = level.color.height;
    std::vector<int> rows;
    for (int y = 0; y < h; ++y)
        if (std::any_of(level.hole.row(y), level.hole.row(y) + w, [](std::uint8_t v) { return v != 0; }))
            rows.push_back(y);
    for (int sweep = 0; sweep < kSweeps; ++sweep)
        for (int parity = 0; parity < 2; ++parity)
            for (const int y : rows)
                for (int x = (y + parity) & 1; x < w; x += 2) {
                    if (!level.hole.at(x, y)) continue;
                    Vec3f sum;
                    int count = 0;
                    if (x > 0) sum += level.color.at(x - 1, y), ++count;
                    if (x + 1 < w) sum += level.color.at(x + 1, y), ++count;
                    if (y > 0) sum += level.color.at(x, y - 1), ++count;
                    if (y + 1 < h) sum += level.color.at(x, y + 1), ++count;
                    if (count) level.color.at(x, y) = sum / static_cast<float>(count);
                }
}

void solve(Level& level) {
    const bool any_hole = std::any_of(level.hole.pixels.begin(), level.hole.pixels.end(),
                                      [](std::uint8_t v) { return v != 0; });
    if (!any_hole || (level.color.width <= 1 && level.color.height <= 1)) return;
    Level coarse = coarser(level);
    solve(coarse);
    for (int y = 0; y < level.color.height; ++y)
        for (int x = 0; x < level.color.width; ++x)
            if (level.hole.at(x, y)) level.color.at(x, y) = coarse.color.at(x / 2, y / 2);
    relax(level);
}

// Clamps each channel to the range of the known pixels, against rounding.
void hold_to_span(ImageColor& filled, const ImageColor& color, const ImageMask& hole) {
    Vec3f low{1e30f, 1e30f, 1e30f}, high{-1e30f, -1e30f, -1e30f};
    for (std::size_t i = 0; i < color.size(); ++i)
        if (!hole.pixels[i])
            for (std::size_t c = 0; c < 3; ++c) {
                low[c] = std::min(low[c], color.pixels[i][c]);
                high[c] = std::max(high[c], color.pixels[i][c]);
            }
    for (std::size_t i = 0; i < color.size(); ++i)
        if (hole.pixels[i])
            for (std::size_t c = 0; c < 3; ++c) filled.pixels[i][c] = std::clamp(filled.pixels[i][c], low[c], high[c]);
}

}  // namespace

ImageColor HarmonicInpainter::fill(const ImageColor& color, const ImageMask& hole, const Run& run) const {
    FASTSCENE_CHECK(color.same_size(hole));
    run.check_stop();
    const bool any_known = std::any_of(hole.pixels.begin(), hole.pixels.end(), [](std::uint8_t v) { return v == 0; });
    if (!any_known) return ImageColor(color.width, color.height);  // nothing is known: black
    Level level{color, hole};
    solve(level);
    hold_to_span(level.color, color, hole);
    return level.color;
}

}  // namespace fastscene

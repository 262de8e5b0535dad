#include "fastscene/geometry/outlook.h"

#include <algorithm>
#include <cmath>

#include "fastscene/base/parallel.h"
#include "fastscene/geometry/reproject.h"

namespace fastscene {
namespace {

constexpr int kSweeps = 24;          // per level; the coarser level provides the initial values
constexpr float kAcross = 0.5f;      // weight of vertical neighbours relative to horizontal ones, within a layer
constexpr float kSameColor = 1e-4f;  // square of an imperceptible difference

// An outside pixel whose neighbours are all outside.
bool is_outside(const ImageF& range, int x, int y) {
    for (int j = std::max(0, y - 1); j <= std::min(range.height - 1, y + 1); ++j)
        for (int i = x - 1; i <= x + 1; ++i)
            if (std::isfinite(range.at(wrap_column(i, range.width), j))) return false;
    return true;
}

struct Level {
    ImageColor color;
    ImageMask known;
};

// Downsamples rows, then columns. A pixel is the mean of its known children.
Level coarser(const Level& fine) {
    const int w = fine.color.width, h = fine.color.height;
    const int across = w > 1 ? 2 : 1, down = w == 1 ? 2 : 1;
    Level out{ImageColor((w + across - 1) / across, (h + down - 1) / down),
              ImageMask((w + across - 1) / across, (h + down - 1) / down)};
    for (int y = 0; y < out.color.height; ++y)
        for (int x = 0; x < out.color.width; ++x) {
            Vec3f sum;
            int count = 0;
            for (int j = down * y; j < std::min(down * (y + 1), h); ++j)
                for (int i = across * x; i < std::min(across * (x + 1), w); ++i)
                    if (fine.known.at(i, j)) {
                        sum += fine.color.at(i, j);
                        ++count;
                    }
            out.known.at(x, y) = count > 0;
            if (count) out.color.at(x, y) = sum / static_cast<float>(count);
        }
    return out;
}

// Vertical weights between row y and the next: nonzero if they belong to one layer, i.e. their means differ by less
// than the variation within each.
std::vector<float> weights_across(const Level& level) {
    const int w = level.color.width, h = level.color.height;
    std::vector<Vec3f> mean(static_cast<std::size_t>(h));
    std::vector<float> spread(static_cast<std::size_t>(h), -1.f);  // negative: unknown
    for (int y = 0; y < h; ++y) {
        Vec3f sum;
        float squares = 0, count = 0;
        for (int x = 0; x < w; ++x)
            if (level.known.at(x, y)) {
                sum += level.color.at(x, y);
                squares += dot(level.color.at(x, y), level.color.at(x, y));
                ++count;
            }
        if (count == 0) continue;
        const auto i = static_cast<std::size_t>(y);
        mean[i] = sum / count;
        spread[i] = std::max(0.f, squares / count - dot(mean[i], mean[i]));
    }
    std::vector<float> out(static_cast<std::size_t>(h), kAcross);
    for (std::size_t y = 0; y + 1 < out.size(); ++y) {
        if (spread[y] < 0 || spread[y + 1] < 0) continue;
        const Vec3f step = mean[y + 1] - mean[y];
        out[y] = kAcross * std::exp(-0.5f * dot(step, step) / (spread[y] + spread[y + 1] + kSameColor));
    }
    return out;
}

// Relaxation: repeatedly replaces unknown pixels by the mean of their neighbours, with circular columns. Even rows,
// then odd rows, so that each half can run in parallel.
void relax(Level& level) {
    const int w = level.color.width, h = level.color.height;
    const std::vector<float> across = weights_across(level);
    for (int sweep = 0; sweep < kSweeps; ++sweep)
        for (int parity = 0; parity < 2; ++parity)
            parallel_for((h + 1 - parity) / 2, 16, [&](std::int64_t begin, std::int64_t end) {
                for (int y = static_cast<int>(2 * begin) + parity; y < static_cast<int>(2 * end) + parity; y += 2)
                    for (int x = 0; x < w; ++x) {
                        if (level.known.at(x, y)) continue;
                        Vec3f sum = level.color.at(wrap_column(x - 1, w), y) + level.color.at(wrap_column(x + 1, w), y);
                        float weight = 2;
                        for (const int j : {y - 1, y + 1})
                            if (j >= 0 && j < h) {
                                const float share = across[static_cast<std::size_t>(std::min(j, y))];
                                sum += level.color.at(x, j) * share;
                                weight += share;
                            }
                        level.color.at(x, y) = sum / weight;
                    }
            });
}

void solve(Level& level) {
    const bool whole = std::all_of(level.known.pixels.begin(), level.known.pixels.end(),
                                   [](std::uint8_t v) { return v != 0; });
    if (whole || level.color.size() == 1) return;
    Level coarse = coarser(level);
    solve(coarse);
    const int w = level.color.width, h = level.color.height;
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x)
            if (!level.known.at(x, y))
                level.color.at(x, y) = coarse.color.at(x * coarse.color.width / w, y * coarse.color.height / h);
    relax(level);
}

}  // namespace

ImageColor outside_picture(const ImageColor& color, const ImageF& range) {
    Level level{color, ImageMask(color.width, color.height)};
    const auto mark = [&](auto&& is_known) {
        bool any = false;
        for (int y = 0; y < color.height; ++y)
            for (int x = 0; x < color.width; ++x) {
                level.known.at(x, y) = is_known(x, y);
                any |= level.known.at(x, y) != 0;
            }
        return any;
    };
    // If the outside consists of slits and specks only, their mixed colors are used.
    if (!mark([&](int x, int y) { return is_outside(range, x, y); }) &&
        !mark([&](int x, int y) { return !std::isfinite(range.at(x, y)); }))
        return {};
    solve(level);
    return level.color;
}

}  // namespace fastscene

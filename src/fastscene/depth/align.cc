#include "fastscene/depth/align.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/parallel.h"
#include "fastscene/geometry/reproject.h"
#include "fastscene/image/color.h"

namespace fastscene {
namespace {

constexpr int kReach = 2;           // coarse pixels to each side
constexpr float kColorSigma = 0.07f;  // of sRGB values: about the noise of a photo, well under an edge
constexpr float kPixelSigma = 1.1f;

Vec3f as_seen(Vec3f c) { return {srgb_from_linear(c.x), srgb_from_linear(c.y), srgb_from_linear(c.z)}; }

struct Neighbour {
    float value, weight;
};

float weighted_median(std::array<Neighbour, (2 * kReach + 2) * (2 * kReach + 2)>& items, std::size_t count) {
    std::sort(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(count),
              [](const Neighbour& a, const Neighbour& b) { return a.value < b.value; });
    float total = 0;
    for (std::size_t i = 0; i < count; ++i) total += items[i].weight;
    // Between the two in the middle, so that a smooth surface stays smooth.
    float sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const float before = sum;
        sum += items[i].weight;
        if (sum < 0.5f * total) continue;
        if (i == 0) return items[0].value;
        const float middle_here = before + 0.5f * items[i].weight, middle_before = before - 0.5f * items[i - 1].weight;
        if (0.5f * total >= middle_here) {
            if (i + 1 == count) return items[i].value;
            const float next = sum + 0.5f * items[i + 1].weight, t = (0.5f * total - middle_here) / (next - middle_here);
            return items[i].value + t * (items[i + 1].value - items[i].value);
        }
        const float t = (0.5f * total - middle_before) / (middle_here - middle_before);
        return items[i - 1].value + t * (items[i].value - items[i - 1].value);
    }
    return items[count - 1].value;
}

}  // namespace

ImageF aligned_to_picture(const ImageF& coarse, const ImageColor& picture) {
    const EquirectSize small{coarse.width, coarse.height}, large{picture.width, picture.height};
    const ImageColor guide = equirect_from_equirect(picture, small);
    ImageColor seen(small.width, small.height);
    std::transform(guide.pixels.begin(), guide.pixels.end(), seen.pixels.begin(), as_seen);

    ImageF out(large.width, large.height);
    const float sx = static_cast<float>(small.width) / static_cast<float>(large.width),
                sy = static_cast<float>(small.height) / static_cast<float>(large.height);
    parallel_for(large.height, 16, [&](std::int64_t begin, std::int64_t end) {
        std::array<Neighbour, (2 * kReach + 2) * (2 * kReach + 2)> items;
        for (int y = static_cast<int>(begin); y < end; ++y)
            for (int x = 0; x < large.width; ++x) {
                const Vec3f color = as_seen(picture.at(x, y));
                const float cx = (static_cast<float>(x) + 0.5f) * sx - 0.5f, cy = (static_cast<float>(y) + 0.5f) * sy - 0.5f;
                const int x0 = static_cast<int>(std::floor(cx)), y0 = static_cast<int>(std::floor(cy));
                std::size_t count = 0;
                for (int j = y0 - kReach + 1; j <= y0 + kReach; ++j)
                    for (int i = x0 - kReach + 1; i <= x0 + kReach; ++i) {
                        if (j < 0 || j >= small.height) continue;
                        const int column = wrap_column(i, small.width);
                        const float dx = static_cast<float>(i) - cx, dy = static_cast<float>(j) - cy;
                        const float color_gap = length(seen.at(column, j) - color) / kColorSigma;
                        const float weight = std::exp(-0.5f * ((dx * dx + dy * dy) / (kPixelSigma * kPixelSigma) + color_gap * color_gap));
                        items[count++] = {coarse.at(column, j), weight + 1e-6f};
                    }
                out.at(x, y) = weighted_median(items, count);
            }
    });
    return out;
}

}  // namespace fastscene

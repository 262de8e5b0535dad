#include "fastscene/geometry/range_edges.h"

#include <algorithm>
#include <cmath>

#include "fastscene/base/parallel.h"

namespace fastscene {
namespace {

// On surfaces seen at more than about 80 degrees from head-on, range changes by six pixel angles per pixel.
constexpr float kSteepness = 6.f;
// Relative error within which a slope still explains a step.
constexpr float kExplained = 0.35f;

// Whether the step from b to c is a jump. a and d are the adjacent pixels on the same line.
bool is_jump(float a, float b, float c, float d, float tolerance) {
    const float jump = std::fabs(c - b);
    if (jump <= tolerance * std::fmin(b, c)) return false;
    const float miss = std::fmin(std::fabs(c - b - (b - a)), std::fabs(c - b - (d - c)));
    return !(miss <= kExplained * jump);
}

}  // namespace

ImageMask range_edges(const ImageF& range) {
    const int w = range.width, h = range.height;
    ImageF inverse(w, h);
    std::transform(range.pixels.begin(), range.pixels.end(), inverse.pixels.begin(), inverse_range);
    ImageMask cuts(w, h);
    const float down = kSteepness * std::numbers::pi_v<float> / static_cast<float>(h);
    parallel_for(h, 16, [&](std::int64_t begin, std::int64_t end) {
        for (int y = static_cast<int>(begin); y < end; ++y) {
            // Pixels of a row are closer together towards the poles.
            const float right = std::fmax(0.2f, std::sin((static_cast<float>(y) + 0.5f) / static_cast<float>(h) *
                                                         std::numbers::pi_v<float>)) *
                                down;
            const auto q = [&](int x, int row) { return inverse.at(wrap_column(x, w), std::clamp(row, 0, h - 1)); };
            for (int x = 0; x < w; ++x) {
                std::uint8_t bits = 0;
                if (is_jump(q(x - 1, y), q(x, y), q(x + 1, y), q(x + 2, y), right)) bits |= kCutRight;
                if (y + 1 < h && is_jump(q(x, y - 1), q(x, y), q(x, y + 1), q(x, y + 2), down)) bits |= kCutDown;
                cuts.at(x, y) = bits;
            }
        }
    });
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            const auto mark = [&](int x1, int y1) {
                const bool first_is_far = inverse.at(x, y) < inverse.at(x1, y1);
                cuts.at(x, y) |= first_is_far ? kFarSide : kNearSide;
                cuts.at(x1, y1) |= first_is_far ? kNearSide : kFarSide;
            };
            if (cuts.at(x, y) & kCutRight) mark(wrap_column(x + 1, w), y);
            if (cuts.at(x, y) & kCutDown) mark(x, y + 1);
        }
    return cuts;
}

}  // namespace fastscene

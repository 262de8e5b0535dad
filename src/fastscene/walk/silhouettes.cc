#include "fastscene/walk/silhouettes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/parallel.h"
#include "fastscene/geometry/range_edges.h"

namespace fastscene {
namespace {

constexpr float kFaint = 0.03f;  // colors that differ by less, relative to the brighter one, cannot be separated

bool beside_a_cut(std::uint8_t bits) { return bits & (kFarSide | kNearSide); }

// The four neighbours of a pixel, and which of them are across a cut.
struct Around {
    const ImageMask& cuts;
    int x, y;

    static constexpr std::array<std::array<int, 2>, 4> kSteps{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};
    bool exists(std::size_t side, int steps) const {
        const int row = y + steps * kSteps[side][1];
        return row >= 0 && row < cuts.height;
    }
    std::array<int, 2> pixel(std::size_t side, int steps) const {
        return {wrap_column(x + steps * kSteps[side][0], cuts.width), y + steps * kSteps[side][1]};
    }
    // Whether there is a cut between the pixels at distance `steps` - 1 and `steps`.
    bool cut(std::size_t side, int steps) const {
        const bool backward = side == 0 || side == 2;
        const auto [cx, cy] = pixel(side, backward ? steps : steps - 1);
        return cuts.at(cx, cy) & (side < 2 ? kCutRight : kCutDown);
    }
};

struct Sum {
    Vec3f sum;
    int count = 0;
    void add(Vec3f v) { sum += v, ++count; }
    Vec3f mean() const { return sum / static_cast<float>(count); }
};

// The two colors mixed in a pixel: that of its own surface, from neighbours showing nothing else, and that of the
// surfaces across its cuts.
struct Parts {
    Sum own, other;
};
Parts parts_of(const ImageColor& color, const ImageMask& cuts, int x, int y) {
    const Around around{cuts, x, y};
    Parts parts;
    for (std::size_t side = 0; side < 4; ++side) {
        if (!around.exists(side, 1)) continue;
        const auto [x1, y1] = around.pixel(side, 1);
        if (!around.cut(side, 1)) {
            if (!beside_a_cut(cuts.at(x1, y1))) parts.own.add(color.at(x1, y1));
        } else if (around.exists(side, 2) && !around.cut(side, 2)) {  // the pixel just behind the cut is mixed too
            const auto [x2, y2] = around.pixel(side, 2);
            if (!beside_a_cut(cuts.at(x2, y2))) parts.other.add(color.at(x2, y2));
        }
    }
    return parts;
}

}  // namespace

Silhouettes find_silhouettes(const ImageColor& color, const ImageMask& cuts) {
    const int w = color.width, h = color.height;
    Silhouettes out{color, ImageMask(w, h, kUsualShare)};
    parallel_for(h, 16, [&](std::int64_t begin, std::int64_t end) {
        for (int y = static_cast<int>(begin); y < end; ++y)
            for (int x = 0; x < w; ++x) {
                const std::uint8_t bits = cuts.at(x, y);
                if (!beside_a_cut(bits)) continue;
                const Parts parts = parts_of(color, cuts, x, y);
                if (!parts.own.count) continue;
                const Vec3f own = parts.own.mean(), here = color.at(x, y);
                if (bits & kFarSide) out.color.at(x, y) = own;
                if (!parts.other.count) continue;
                // Least-squares fit of color = share * own + (1 - share) * other; a large residual or low contrast
                // makes it unreliable.
                const Vec3f other = parts.other.mean(), apart = own - other;
                const float contrast = dot(apart, apart);
                const float brightest = std::max({own.x, own.y, own.z, other.x, other.y, other.z, 0.01f});
                const float faint = kFaint * brightest;
                const float share = std::clamp(dot(here - other, apart) / std::max(contrast, 1e-12f), 0.5f, 1.f);
                const Vec3f left_over = here - (own * share + other * (1.f - share));
                const float trust = contrast / (contrast + faint * faint + 8.f * dot(left_over, left_over));
                const float usual = own_share(kUsualShare);
                const float trusted = usual + trust * (share - usual);
                out.share.at(x, y) = static_cast<std::uint8_t>(std::lround((trusted - 0.5f) * 2.f * 255.f));
                if (bits & kFarSide) continue;
                const Vec3f unmixed = (here - other * (1.f - share)) / share;
                out.color.at(x, y) = lerp(
                    here, Vec3f{std::max(0.f, unmixed.x), std::max(0.f, unmixed.y), std::max(0.f, unmixed.z)}, trust);
            }
    });
    return out;
}

}  // namespace fastscene

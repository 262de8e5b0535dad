// Equivariance: a panorama rotated about the vertical or mirrored, seen from the correspondingly moved position, gives
// the rotated or mirrored view.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fastscene/scene/synthetic.h"
#include "fastscene/walk/coarse_view.h"

namespace fastscene {
namespace {

constexpr EquirectSize kTurnedSize{256, 128};

// Maps pixel (x, y) of the transformed picture to the original.
struct Change {
    const char* name;
    int turned = 0;  // columns to the right
    bool left_right = false, up_down = false;

    template <class T>
    Image<T> of(const Image<T>& image) const {
        const int w = image.width, h = image.height;
        Image<T> out(w, h);
        for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x)
                out.at(x, y) = image.at(wrap_column((left_right ? w - 1 - x : x) - turned, w), up_down ? h - 1 - y : y);
        return out;
    }
    Vec3f of(Vec3f p) const {
        const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(turned) /
                            static_cast<float>(kTurnedSize.width);
        const float s = std::sin(angle), c = std::cos(angle);
        return {(c * p.x + s * p.z) * (left_right ? -1.f : 1.f), up_down ? -p.y : p.y, c * p.z - s * p.x};
    }
};

CoarseView seen_from(const ImageColor& color, const ImageF& range, Vec3f position) {
    return coarse_view(std::vector<WarpSource>{make_warp_source(color, range, {}, {}, {})}, kTurnedSize, position);
}

TEST(CoarseView, TurnsAndMirrorsWithThePanorama) {
    const Panorama first = render_synthetic(SyntheticWorld::furnished(SyntheticPaint::smooth, SyntheticPaint::planks),
                                            {}, kTurnedSize, 2);
    const Change changes[] = {
        {"half a turn", 128}, {"37 columns", 37}, {"left and right", 0, true}, {"up and down", 0, false, true}};
    for (const Vec3f position : {Vec3f{0.4f, 0.1f, -0.3f}, {-0.05f, 0.3f, 0.6f}, {0, -0.5f, 0}}) {
        const CoarseView plain = seen_from(first.color, first.range, position);
        for (const Change& change : changes) {
            const CoarseView view = seen_from(change.of(first.color), change.of(first.range), change.of(position));
            const ImageColor color = change.of(plain.color);
            const ImageF range = change.of(plain.range);
            const Image<Cover> cover = change.of(plain.cover);
            std::size_t other = 0;  // where a ray hits an edge, rounding decides
            for (std::size_t i = 0; i < color.size(); ++i)
                other += view.cover.pixels[i] != cover.pixels[i] ||
                         std::fabs(view.range.pixels[i] - range.pixels[i]) > 0.01f * range.pixels[i] ||
                         length(view.color.pixels[i] - color.pixels[i]) > 0.02f;
            EXPECT_LT(other, color.size() / 500)
                << change.name << " from " << position.x << ' ' << position.y << ' ' << position.z;
        }
    }
}

}  // namespace
}  // namespace fastscene

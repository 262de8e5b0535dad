// Where the camera stands.
#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/rooms/layout.h"

namespace fastscene {
namespace {

constexpr float kEyeHeight = 1.5f;

}  // namespace

// How many of the pieces that were asked for nothing can be seen of: other pieces stand before them.
int Layout::hidden_wishes(Vec3f eye) const {
    int hidden = 0;
    for (std::size_t i = 0; i < placed_.size(); ++i) {
        if (placed_[i].wish.klass.empty()) continue;
        const Footprint box = footprint_of(placed_[i]);
        const auto axes = axes_of(box);
        bool seen = false;
        for (const float along : {0.f, -0.7f, 0.7f})
            for (const float up : {0.95f, 0.5f}) {
                if (seen) break;
                const Vec2f at = box.center + axes[0] * (along * box.half.x);
                const Vec3f target{at.x, box.y0 + up * (box.y1 - box.y0), at.y};
                seen = true;
                for (std::size_t k = 0; k < placed_.size() && seen; ++k) {
                    if (k == i || placed_[k].flat || placed_[k].on == static_cast<int>(i) || placed_[i].on == static_cast<int>(k) ||
                        placed_[i].below == static_cast<int>(k))
                        continue;
                    seen = !passes(footprint_of(placed_[k]), eye, target);
                }
            }
        hidden += !seen;
    }
    return hidden;
}

Vec3f Layout::camera_position() const {
    Vec3f best{0, kEyeHeight, 0};
    float best_score = -1e9f;
    for (float x = -plan_.width / 2 + 0.6f; x <= plan_.width / 2 - 0.6f; x += 0.1f)
        for (float z = -plan_.depth / 2 + 0.6f; z <= plan_.depth / 2 - 0.6f; z += 0.1f) {
            float tall = plan_.air_around({x, kEyeHeight, z}), low = 1.f;
            for (const Placed& p : placed_) {
                if (p.flat) continue;
                const Footprint f = footprint_of(p);
                const float far = distance_to(f, {x, z});
                // Heights within the ball of 0.7 m about the eyes count fully; what is lower only keeps the feet away.
                if (f.y1 > kEyeHeight - 0.7f && f.y0 < kEyeHeight + 0.7f) tall = std::min(tall, far);
                else if (f.y1 < kEyeHeight) low = std::min(low, far);
            }
            // Beyond 1.1 m more space is no gain; the middle of the room shows most of it.
            float score = 3.f * std::min(tall, 1.1f) + 0.8f * std::min(low, 0.4f) - 0.35f * std::hypot(x, z);
            // Air around the eyes comes before all that may be seen, and behind a barrier of tables nobody stands.
            constexpr float kMustBeFree = 0.58f;
            if (tall < kMustBeFree) score -= 100.f * (kMustBeFree - tall) + 10.f;
            if (score <= best_score) continue;
            if (!ways_.reaches({x, z})) score -= 50.f;
            if (score <= best_score) continue;
            score -= 0.6f * static_cast<float>(hidden_wishes({x, kEyeHeight, z}));
            if (score > best_score) best_score = score, best = {x, kEyeHeight, z};
        }
    return best;
}

}  // namespace fastscene

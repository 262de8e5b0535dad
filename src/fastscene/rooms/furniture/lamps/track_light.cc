// Track light.
#include <algorithm>
#include <cmath>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/lamps/lamp_parts.h"

namespace fastscene::furniture {

// A rail under the ceiling with spots that look down to both sides.
void build_track_light(Kit& k) {
    const Vec3f s = k.wanted({1.4f, 0.2f, 0.2f});
    const int metal = lamp_metal(k), lens = k.material(glow("spot", k.style.lamp_light * 3.2f));
    k.board(metal, {0, -0.03f, 0}, {s.x, 0.03f, 0.035f}, 0.003f);
    const int heads = std::max(2, static_cast<int>(std::lround(s.x / 0.36f)));
    for (int i = 0; i < heads; ++i) {
        const float x = s.x * ((static_cast<float>(i) + 0.5f) / static_cast<float>(heads) - 0.5f),
                    side = i % 2 == 0 ? 1.f : -1.f;
        const Vec3f joint{x, -0.075f, 0},
            aim = normalize(Vec3f{0.25f * (static_cast<float>(i % 3) - 1.f), -1.f, 0.55f * side});
        k.rod(metal, {x, -0.03f, 0}, joint, 0.01f);
        k.rod(metal, joint - aim * 0.03f, joint + aim * 0.11f, 0.034f, -1, 24);
        k.rod(lens, joint + aim * 0.1105f, joint + aim * 0.113f, 0.027f, -1, 20);
    }
    k.piece.mount = Mount::ceiling;
}

}  // namespace fastscene::furniture

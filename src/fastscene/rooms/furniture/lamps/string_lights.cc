// String lights.
#include <cmath>
#include <vector>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// Small bulbs on a wire that hangs in three bows along a wall.
void build_string_lights(Kit& k) {
    const Vec3f s = k.wanted({2.1f, 0.3f, 0.03f});
    const int wire = k.main(plain("wire", {0.05f, 0.05f, 0.045f}, 0.6f));
    Material bulb = glow("fairy light", Vec3f{13.f, 7.2f, 2.3f} * 1.6f);
    bulb.pattern = Pattern::screen;  // who asks for them wants them lit, by day too
    const int light = k.material(bulb);
    constexpr int kBows = 3, kEach = 8;
    std::vector<Vec3f> path;
    for (int i = 0; i <= kBows * kEach; ++i) {
        const float t = static_cast<float>(i) / static_cast<float>(kBows * kEach),
                    in = t * kBows - std::floor(t * kBows);
        path.push_back({(t - 0.5f) * s.x, s.y - (s.y - 0.06f) * 4 * in * (1 - in), 0.015f});
    }
    k.add(shapes::tube(path, 0.0025f, 6), wire);
    for (std::size_t i = 0; i < path.size(); ++i)
        k.add(shapes::ball(path[i] - Vec3f{0, 0.016f, 0}, {0.009f, 0.013f, 0.009f}, 8), light);
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.85f;
}

}  // namespace fastscene::furniture

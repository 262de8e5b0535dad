// A blanket thrown over a seat.
#include <algorithm>
#include <cmath>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/prints.h"

namespace fastscene::furniture {
namespace {

// Wool unless it was said otherwise; patchwork: squares of the room's own colors.
Material throw_cloth(Kit& k) {
    Material m = tinted(k.style.fabric2, k.accent());
    m.name = "wool";
    m.pattern = Pattern::knit, m.scale_m = 0.012f, m.bump_m = 0.002f;
    if (k.request.pattern == "patchwork") {
        m.name = "patchwork";
        m.pattern = Pattern::fabric, m.scale_m = 0.002f, m.bump_m = 0.f;
        m.color_a = k.style.palette[0], m.color_b = lerp(k.style.palette[1], {0.7f, 0.66f, 0.58f}, 0.5f),
        m.color_c = k.style.palette[2];
    }
    return m;
}

}  // namespace

// One long cloth folded to and fro, lying flat: it turns over at the front and at the back, and no layer lies quite
// like the last.
void build_throw(Kit& k) {
    const int cloth = k.main(throw_cloth(k));
    constexpr int kLayers = 4;
    constexpr float kThick = 0.022f, kRise = 0.03f;  // of a layer; from one to the next
    const Vec3f size = k.wanted({0.5f, 0, 0.36f});
    const float straight = size.z - kRise, turn = 0.5f * kPi * kRise, lap = straight + turn,
                length = kLayers * lap - turn;
    const std::uint32_t seed = k.seed();
    const auto point = [=](float u, float v) {
        const float layer = std::min(std::floor(v * length / lap), kLayers - 1.f), along = v * length - layer * lap;
        const float way = static_cast<int>(layer) % 2 == 0 ? 1.f : -1.f,
                    bend = std::clamp((along - straight) / turn, 0.f, 1.f) * kPi;
        const float x = (u - 0.5f) * size.x * (0.98f + 0.02f * shapes::wobble({layer, 4.f, 2.f}, seed)) +
                        0.01f * shapes::wobble({layer * 3.7f, 1.f, 0.f}, seed);
        const float z = way * (std::min(along, straight) - 0.5f * straight + 0.5f * kRise * std::sin(bend));
        const float sag = 0.006f * shapes::wobble({x * 6.f, 3.f, z * 6.f}, seed + 1) +
                          0.003f * shapes::wobble({x * 19.f, layer, z * 19.f}, seed + 2);
        return Vec3f{
            x, kThick + kRise * (layer + 0.5f * (1.f - std::cos(bend))) + std::max(0.f, sag) * (0.3f + 0.25f * layer),
            z};
    };
    // From front to back, so that the sheet's outer side looks up.
    k.add(shapes::slab(20, 120, kThick, [&](float u, float v) { return point(1.f - u, v); }), cloth);
    k.piece.mount = Mount::surface;
}

}  // namespace fastscene::furniture

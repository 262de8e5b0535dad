// Footstools without legs or back.
#include <array>
#include <cmath>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_ottoman(Kit& k) {
    const int cloth = k.main(k.style.fabric2), wood = k.material(k.style.wood);
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f})
            k.rod(wood, {sx * 0.24f, 0, sz * 0.18f}, {sx * 0.23f, 0.16f, sz * 0.17f}, 0.014f, 0.022f);
    k.soft(cloth, {0, 0.15f, 0}, {0.65f, 0.27f, 0.5f}, {0.05f, 0.012f, 0.003f, 14});
    k.top(0.418f, 0, 0, 0.22f, 0.15f);
}

void build_pouf(Kit& k) {
    Material m = k.style.fabric2;
    m.pattern = Pattern::knit;
    m.scale_m = 0.02f;
    m.bump_m = 0.004f;
    const int cloth = k.main(m);
    std::array<Vec2f, 9> p{};
    for (std::size_t i = 0; i < p.size(); ++i) {
        const float t = 3.14159f * static_cast<float>(i) / 8.f;
        p[i] = {i == 0 || i == 8 ? 0.f : 0.27f * std::pow(std::sin(t), 0.55f),
                0.2f - 0.2f * std::copysign(std::pow(std::fabs(std::cos(t)), 0.8f), std::cos(t))};
    }
    k.add(shapes::lathe(p, 32, true), cloth);
    k.top(0.4f, 0, 0, 0.12f, 0.12f);
}

}  // namespace fastscene::furniture

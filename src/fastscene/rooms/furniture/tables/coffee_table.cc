// Coffee tables and side tables.
#include <cmath>

#include "fastscene/rooms/furniture/forms.h"
#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/tables/table_parts.h"

namespace fastscene::furniture {
namespace {

// A drum with flutes; a slab on two cheeks; two tops of different height.
void drum_table(Kit& k, float d, float y) {
    const int wood = k.main(k.style.wood), metal = k.material(k.style.metal);
    k.add(shapes::prism(shapes::circle(0.42f * d, 40), 0.02f, y - 0.03f, 0.004f), wood);
    for (int i = 0; i < 32; ++i) {
        const float a = 0.19635f * static_cast<float>(i);
        k.rod(wood, {0.42f * d * std::cos(a), 0.02f, 0.42f * d * std::sin(a)},
              {0.42f * d * std::cos(a), y - 0.03f, 0.42f * d * std::sin(a)}, 0.022f, -1, 8);
    }
    k.add(shapes::prism(shapes::circle(0.5f * d, 48), y - 0.03f, y, 0.006f), wood);
    k.add(shapes::prism(shapes::circle(0.46f * d, 40), 0.f, 0.022f, 0.004f), metal);
    k.top(y, 0, 0, 0.33f * d, 0.33f * d);
}

void slab_table(Kit& k, Vec3f s) {
    const int wood = k.main(k.style.wood);
    k.board(wood, {0, s.y - 0.06f, 0}, {s.x, 0.06f, s.z}, 0.01f);
    for (const float sx : {-1.f, 1.f})
        k.board(wood, {sx * (0.5f * s.x - 0.16f), 0, 0}, {0.06f, s.y - 0.06f, s.z - 0.08f}, 0.008f);
    k.board(wood, {0, 0.1f, 0}, {s.x - 0.38f, 0.025f, s.z - 0.12f}, 0.004f);
    k.top(s.y, 0, 0, 0.46f * s.x, 0.46f * s.z);
}

void twin_table(Kit& k, Vec3f s) {
    const int wood = k.main(k.style.wood), second = k.material(k.style.wood2);
    const auto low = [&](int mat, float x, float z, float d, float y) {
        k.add(shapes::prism(shapes::circle(0.5f * d, 44), y - 0.025f, y, 0.006f), mat, {x, 0, z});
        for (int i = 0; i < 3; ++i) {
            const float a = 2.0944f * static_cast<float>(i) + x;
            k.rod(mat, {x + 0.4f * d * std::cos(a), 0, z + 0.4f * d * std::sin(a)},
                  {x + 0.28f * d * std::cos(a), y - 0.02f, z + 0.28f * d * std::sin(a)}, 0.011f, 0.018f);
        }
    };
    low(wood, -0.2f * s.x, 0.02f, 0.66f * s.z * 1.1f, s.y);
    low(second, 0.26f * s.x, -0.02f, 0.5f * s.z * 1.1f, s.y + 0.08f);
    k.top(s.y, -0.2f * s.x - 0.03f, 0.02f, 0.2f * s.z, 0.2f * s.z);
}

}  // namespace

void build_coffee_table(Kit& k) {
    using enum CoffeeTableForm;
    const Vec3f s = k.wanted({1.1f, 0.4f, 0.6f});
    if (k.request.pattern == "round")
        return round_table(k, k.request.size_m.x > 0 ? std::min(s.x, s.z) : 0.8f * s.x, s.y, 0.03f);
    switch (form_for(k, k.style.forms.coffee_table)) {
        case round: return round_table(k, 0.8f * s.x, s.y, 0.03f);
        case drum: return drum_table(k, 0.75f * s.x, s.y);
        case slab: return slab_table(k, s);
        case twin: return twin_table(k, s);
        default: break;
    }
    plain_table(k, s, 0.035f);
    if (k.style.legs == LegType::square || k.style.legs == LegType::metal_frame)
        k.board(k.piece.main_material, {0, 0.1f, 0}, {s.x - 0.16f, 0.02f, s.z - 0.14f});
}

void build_side_table(Kit& k) { round_table(k, 0.45f, 0.53f, 0.022f); }

}  // namespace fastscene::furniture

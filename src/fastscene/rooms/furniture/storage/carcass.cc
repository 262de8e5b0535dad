// Boxes with doors, drawers or open compartments.
#include "fastscene/rooms/furniture/storage/carcass.h"

#include <algorithm>
#include <array>
#include <utility>

#include "fastscene/rooms/furniture/forms.h"

namespace fastscene::furniture {

void carcass(Kit& k, int wood, Vec3f s, float y0, float t) {
    for (const float sx : {-1.f, 1.f}) k.board(wood, {sx * 0.5f * (s.x - t), y0, 0}, {t, s.y - y0, s.z}, 0.003f);
    k.board(wood, {0, s.y - t, 0}, {s.x - 2 * t, t, s.z - 0.002f}, 0.003f);
    k.board(wood, {0, y0, 0}, {s.x - 2 * t, t, s.z - 0.002f}, 0.003f);
    k.board(wood, {0, y0 + t, -0.5f * s.z + 0.006f}, {s.x - 2 * t, s.y - y0 - 2 * t, 0.01f}, 0.002f);
}

void chest(Kit& k, Vec3f s, float leg, int columns, int rows, float clearance) {
    const int wood = k.main(k.style.wood), metal = k.material(k.style.metal);
    const bool rich = k.style.mouldings == Mouldings::rich;
    if (leg > 0.03f)
        legs(k, k.style.legs == LegType::metal_frame ? metal : wood, 0.5f * s.x - 0.05f, 0.5f * s.z - 0.05f,
             leg + 0.002f, 0.045f);
    else k.board(wood, {0, 0, -0.01f}, {s.x - 0.04f, leg + 0.001f, s.z - 0.06f});
    k.board(wood, {0, leg, -0.012f}, {s.x, s.y - leg - 0.024f, s.z - 0.03f}, 0.004f);
    const float lip = rich ? 0.025f : 0.004f;
    k.board(wood, {0, s.y - 0.024f, lip * 0.3f}, {s.x + 2 * lip, 0.024f, s.z + lip}, rich ? 0.01f : 0.003f);
    fronts(k, wood, metal, -0.5f * s.x + 0.012f, 0.5f * s.x - 0.012f, leg + 0.012f, s.y - 0.034f, 0.5f * s.z - 0.028f,
           columns, rows);
    k.top(s.y, 0, 0, 0.46f * s.x, 0.42f * s.z);
    k.piece.clearance_front_m = clearance;
    k.piece.against_wall = true;
}

void slatted_chest(Kit& k, Vec3f s, float leg, float clearance) {
    const int wood = k.main(k.style.wood);
    legs(k, wood, 0.5f * s.x - 0.09f, 0.5f * s.z - 0.07f, leg + 0.002f, 0.045f);
    k.board(wood, {0, leg, -0.012f}, {s.x, s.y - leg, s.z - 0.03f}, 0.006f);
    const int count = static_cast<int>((s.x - 0.06f) / 0.032f);
    Mesh slats;
    for (int i = 0; i < count; ++i) {
        if (i == count / 2) continue;
        Mesh m = shapes::box({0.02f, s.y - leg - 0.07f, 0.016f}, 0.003f);
        shapes::lay_grain(m, {0.1f * static_cast<float>(i), 0, 0});
        shapes::append(slats,
                       shapes::move(m, {(static_cast<float>(i) + 0.5f) / static_cast<float>(count) * (s.x - 0.06f) -
                                            0.5f * s.x + 0.03f,
                                        0.5f * (s.y + leg), 0.5f * s.z - 0.02f}));
    }
    k.add(std::move(slats), wood);
    k.top(s.y, 0, 0, 0.46f * s.x, 0.42f * s.z);
    k.piece.clearance_front_m = clearance;
    k.piece.against_wall = true;
}

bool slatted(Kit& k) { return form_for(k, k.style.forms.chest) == ChestForm::slatted; }

void fill_shelf(Kit& k, float x0, float x1, float y, float room_y, float z_back, float depth) {
    static constexpr std::array<std::array<const char*, 6>, 3> kOthers{
        {{"towel_stack", "toiletries", "bottles", "towel_stack", "storage_box", "plant_small"},
         {"bottles", "pot", "bowl", "storage_box", "cup", "plant_small"},
         {"teddy_bear", "toy_blocks", "storage_box", "book_stack", "globe", "teddy_bear"}}};
    const Shelves kind = k.style.shelves;
    float x = x0 + 0.015f;
    while (x < x1 - 0.12f) {
        const float left = x1 - x - 0.01f;
        const int what = k.rng.index(10);
        if (kind != Shelves::books && !(kind == Shelves::toys && what < 4)) {
            const auto& others = kOthers[static_cast<std::size_t>(kind) - 1];
            const Piece p = k.small(others[static_cast<std::size_t>(k.rng.index(6))]);
            const bool fits = p.size_m.x < left && p.size_m.y < room_y - 0.02f && p.size_m.z < depth + 0.02f;
            if (fits) k.merge(p, {x + 0.5f * p.size_m.x, y, z_back + 0.5f * depth});
            x += fits ? p.size_m.x + k.rng.uniform(0.03f, 0.12f) : 0.06f;
            continue;
        }
        if (what < 6) {
            const float w = std::min(left, k.rng.uniform(0.18f, 0.4f));
            books(k, {x, y, z_back + 0.01f}, w, room_y - 0.03f, std::min(0.2f, depth - 0.03f));
            x += w + 0.02f;
        } else {
            Piece p = k.small(what == 6 ? "vase_small" : what == 7 ? "book_stack" : what == 8 ? "bowl" : "plant_small");
            if (p.size_m.x < left && p.size_m.y < room_y - 0.02f && p.size_m.z < depth + 0.02f)
                k.merge(p, {x + 0.5f * p.size_m.x, y, z_back + 0.5f * depth});
            x += std::min(left, p.size_m.x + k.rng.uniform(0.02f, 0.1f));
        }
    }
}

}  // namespace fastscene::furniture

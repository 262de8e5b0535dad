// Kitchen units along a wall, and the island before them.
#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/kitchen/worktop.h"

namespace fastscene::furniture {

void build_kitchen_counter(Kit& k) {
    const Vec3f s = k.wanted({2.8f, 2.2f, 0.62f});
    const int front = k.main(kitchen_front(k)), top = k.material(worktop(k)), metal = k.material(k.style.metal),
              chrome = k.material(steel()), dark = k.material(plain("black glass", {0.032f, 0.032f, 0.035f}, 0.08f));
    Material splash = k.style.mouldings == Mouldings::none ? *material_named("marble") : *material_named("tiles");
    if (k.style.mouldings != Mouldings::none) splash.pattern = Pattern::subway, splash.scale_m = 0.15f;
    if (!k.request.back_material.empty() && k.request.back_material != "tile") splash = *material_named("plaster");
    const int tiles = k.material(
        part_in(splash, k.request.back_material == "tile" ? "" : k.request.back_material, k.request.back_color));
    const float w = s.x, d = 0.6f, z0 = -0.5f * d;
    const bool cupboards = s.y > 1.5f;  // a low run stands below a window
    k.board(dark, {0, 0, -0.04f}, {w, 0.1f, d - 0.1f});
    k.board(front, {0, 0.1f, -0.02f}, {w, 0.76f, d - 0.04f});
    k.board(top, {0, 0.86f, 0.01f}, {w + 0.01f, 0.04f, d + 0.03f}, 0.005f);
    k.board(tiles, {0, 0.9f, z0 + 0.004f}, {w, cupboards ? 0.55f : 0.06f, 0.008f}, 0.001f);
    const int units = std::max(3, static_cast<int>(std::lround(w / 0.6f)));
    const float uw = w / static_cast<float>(units), fz = 0.5f * d - 0.04f;
    const int oven = units - 2, sink = std::min(1, units - 2) - (units <= 3 ? 1 : 0);
    for (int i = 0; i < units; ++i) {
        const float x0 = -0.5f * w + uw * static_cast<float>(i), cx = x0 + 0.5f * uw;
        if (i == oven && k.request.cooks) {
            k.board(dark, {cx, 0.22f, fz + 0.008f}, {uw - 0.01f, 0.48f, 0.02f}, 0.004f);
            k.rod(chrome, {cx - 0.38f * uw, 0.66f, fz + 0.045f}, {cx + 0.38f * uw, 0.66f, fz + 0.045f}, 0.008f);
            for (const float e : {-0.34f, 0.34f})
                k.rod(chrome, {cx + e * uw, 0.66f, fz + 0.01f}, {cx + e * uw, 0.66f, fz + 0.045f}, 0.006f);
            k.board(chrome, {cx, 0.71f, fz + 0.008f}, {uw - 0.01f, 0.13f, 0.02f}, 0.004f);
            for (int j = -2; j <= 2; ++j)
                k.rod(dark, {cx + 0.09f * static_cast<float>(j), 0.775f, fz + 0.015f},
                      {cx + 0.09f * static_cast<float>(j), 0.775f, fz + 0.04f}, 0.018f, 0.015f, 16);
            k.board(dark, {cx, 0.9f, 0.01f}, {uw - 0.04f, 0.006f, 0.5f}, 0.002f);
            for (int j = 0; j < 4; ++j)
                k.add(shapes::ring(0.08f, 0.004f, 24), chrome,
                      {cx + (j % 2 ? 0.13f : -0.13f), 0.906f, 0.01f + (j / 2 ? 0.12f : -0.12f)});
            const std::array<Vec2f, 3> pot{Vec2f{0.095f, 0}, {0.1f, 0.01f}, {0.1f, 0.11f}};
            k.add(shapes::vessel(pot, 0.004f, 28), chrome, {cx - 0.13f, 0.906f, -0.11f});
            if (!cupboards) continue;
            // The hood: a chimney over a slanted body.
            k.board(chrome, {cx, 1.52f, z0 + 0.2f}, {uw, 0.06f, 0.4f}, 0.006f);
            k.board(chrome, {cx, 1.575f, z0 + 0.15f}, {0.26f, s.y - 1.575f, 0.26f}, 0.006f);
        } else {
            const int rows = i == sink ? 1 : (i + static_cast<int>(k.request.seed & 1)) % 2 == 0 ? 3 : 1;
            fronts(k, front, metal, x0 + 0.003f, x0 + uw - 0.003f, 0.105f, 0.855f, fz, 1, rows);
            if (cupboards) {
                k.board(front, {cx, 1.45f, z0 + 0.165f}, {uw - 0.001f, s.y - 1.45f, 0.33f}, 0.003f);
                fronts(k, front, metal, x0 + 0.003f, x0 + uw - 0.003f, 1.45f, s.y, z0 + 0.33f, 1, 1);
            }
            if (i == sink) {
                k.board(chrome, {cx, 0.9f, 0.03f}, {0.48f, 0.004f, 0.4f}, 0.002f);
                k.board(dark, {cx, 0.902f, 0.03f}, {0.43f, 0.004f, 0.35f}, 0.002f);
                tap(k, k.material(k.style.tap), {cx, 0.9f, -0.2f}, 0.26f);
            } else {
                k.top(0.9f, cx, 0.f, 0.42f * uw, 0.2f);
            }
        }
    }
    k.piece.clearance_front_m = 0.9f;
    k.piece.against_wall = true;
}

void build_kitchen_island(Kit& k) {
    const Vec3f s = k.wanted({1.6f, 0.92f, 0.85f});
    const int front = k.main(kitchen_front(k)), top = k.material(worktop(k)), metal = k.material(k.style.metal),
              dark = k.material(plain("plinth", {0.04f, 0.04f, 0.04f}, 0.6f));
    k.board(dark, {0, 0, 0}, {s.x - 0.16f, 0.1f, s.z - 0.2f});
    k.board(front, {0, 0.1f, 0}, {s.x - 0.08f, s.y - 0.14f, s.z - 0.12f});
    k.board(top, {0, s.y - 0.04f, 0}, {s.x, 0.04f, s.z}, 0.006f);
    fronts(k, front, metal, -0.5f * s.x + 0.045f, 0.5f * s.x - 0.045f, 0.105f, s.y - 0.045f, 0.5f * s.z - 0.06f, 3, 2);
    k.top(s.y, 0, 0, 0.44f * s.x, 0.42f * s.z);
    k.piece.clearance_front_m = k.piece.clearance_side_m = 0.8f;
}

}  // namespace fastscene::furniture

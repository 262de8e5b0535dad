// Shutters.
#include <algorithm>
#include <cmath>
#include <utility>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/openings/blind_parts.h"

namespace fastscene::furniture {

// Panels of louvres on hinges, shut, their louvres open.
void build_shutters(Kit& k) {
    const Vec3f s = k.wanted(kUsualWindow);
    const int wood = k.main(k.style.of(k.style.made_of.shutters)), metal = k.material(k.style.metal);
    const int panels = std::max(2, 2 * static_cast<int>(std::lround(s.x / 1.1f)));
    const float each = s.x / static_cast<float>(panels), stile = std::min(0.052f, 0.15f * each), rail = 0.075f,
                mid = 0.03f, thick = 0.028f;
    const float tilt = drawn(k, 18.f, 34.f);
    const bool divided = s.y > 1.25f;
    for (int p = 0; p < panels; ++p) {
        const float x = each * (static_cast<float>(p) + 0.5f) - 0.5f * s.x, w = each - 0.004f;
        for (const float sx : {-1.f, 1.f})
            k.board(wood, {x + sx * 0.5f * (w - stile), 0.003f, mid}, {stile, s.y - 0.006f, thick}, 0.003f);
        const float inner = w - 2 * stile, y1 = s.y - 0.003f - rail, half = 0.56f * s.y;
        k.board(wood, {x, 0.003f, mid}, {inner, rail, thick}, 0.003f);
        k.board(wood, {x, y1, mid}, {inner, rail, thick}, 0.003f);
        if (divided) k.board(wood, {x, half, mid}, {inner, 0.06f, thick}, 0.003f);
        const auto louvres = [&](float from, float to) {
            const int count = std::max(1, static_cast<int>(std::lround((to - from) / 0.056f)));
            const float step = (to - from) / static_cast<float>(count);
            Mesh all;
            for (int i = 0; i < count; ++i) {
                Mesh one = shapes::box({inner - 0.004f, 0.0085f, 0.058f}, 0.0035f);
                shapes::lay_grain(one, {k.rng.uniform(0, 3), k.rng.uniform(0, 3), 0});
                shapes::turn(one, {1, 0, 0}, tilt);
                shapes::append(all, shapes::move(one, {x, from + step * (static_cast<float>(i) + 0.5f), mid}));
            }
            k.add(std::move(all), wood);
            k.rod(wood, {x, from + 0.6f * step, mid + 0.034f}, {x, to - 0.6f * step, mid + 0.034f}, 0.005f, -1, 8);
        };
        if (divided) louvres(0.003f + rail, half), louvres(half + 0.06f, y1);
        else louvres(0.003f + rail, y1);
        if (p % 2 == 0)
            for (const float y : {0.16f * s.y, 0.84f * s.y})
                k.board(metal, {x - 0.5f * w + 0.004f, y, mid + 0.015f}, {0.012f, 0.07f, 0.006f}, 0.002f);
        else
            k.add(shapes::ball({x - 0.5f * w + 0.6f * stile, 0.48f * s.y, mid + 0.022f}, {0.01f, 0.01f, 0.011f}, 10),
                  metal);
    }
    k.piece.mount = Mount::wall;
}

}  // namespace fastscene::furniture

// Shoji.
#include <algorithm>
#include <cmath>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/openings/blind_parts.h"

namespace fastscene::furniture {

// Sliding panels of paper on a lattice, one before the other where they meet.
void build_shoji(Kit& k) {
    const Vec3f s = k.wanted(kUsualWindow);
    const int wood = k.main(k.style.of(k.style.made_of.shoji));
    Material rice = plain("shoji paper", {0.72f, 0.7f, 0.65f}, 0.95f);
    rice.transmission = 0.6f;
    rice.specular = 0.02f;
    const int paper = k.material(rice);
    const int panels = std::max(2, static_cast<int>(std::lround(s.x / 0.8f)));
    const float lap = 0.035f, each = (s.x + lap * static_cast<float>(panels - 1)) / static_cast<float>(panels);
    for (int p = 0; p < panels; ++p) {
        const float x = 0.5f * each + (each - lap) * static_cast<float>(p) - 0.5f * s.x,
                    z = p % 2 == 0 ? 0.012f : 0.036f, f = 0.036f, deep = 0.022f;
        for (const float sx : {-1.f, 1.f})
            k.board(wood, {x + sx * 0.5f * (each - f), 0.002f, z}, {f, s.y - 0.004f, deep}, 0.003f);
        for (const float y : {0.002f, s.y - 0.002f - 1.2f * f})
            k.board(wood, {x, y, z}, {each - 2 * f, 1.2f * f, deep}, 0.003f);
        const float inner = each - 2 * f, y0 = 1.2f * f, y1 = s.y - 1.2f * f;
        const int columns = std::max(2, static_cast<int>(std::lround(inner / 0.2f))),
                  rows = std::max(3, static_cast<int>(std::lround((y1 - y0) / 0.26f)));
        for (int i = 1; i < columns; ++i)
            k.board(wood, {x + inner * (static_cast<float>(i) / static_cast<float>(columns) - 0.5f), y0, z + 0.003f},
                    {0.011f, y1 - y0, 0.013f}, 0.002f);
        for (int i = 1; i < rows; ++i)
            k.board(wood, {x, y0 + (y1 - y0) * static_cast<float>(i) / static_cast<float>(rows) - 0.0055f, z + 0.004f},
                    {inner, 0.011f, 0.011f}, 0.002f);
        k.add(shapes::sheet(1, 1,
                            [&](float u, float v) {
                                return Vec3f{x + inner * (u - 0.5f), y0 + (y1 - y0) * v, z - 0.006f};
                            }),
              paper);
    }
    k.piece.mount = Mount::wall;
}

}  // namespace fastscene::furniture

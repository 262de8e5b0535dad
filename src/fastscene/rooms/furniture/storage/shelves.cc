// Shelves with what stands on them.
#include <algorithm>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/storage/carcass.h"

namespace fastscene::furniture {

void build_bookshelf(Kit& k) {
    const Vec3f s = k.wanted({0.95f, 1.95f, 0.3f});
    const int wood = k.main(k.style.wood);
    carcass(k, wood, s, 0.05f);
    k.board(wood, {0, 0, 0.01f}, {s.x - 0.044f, 0.052f, s.z - 0.05f});
    const int rows = std::max(2, static_cast<int>(s.y / 0.36f)), columns = s.x > 1.3f ? 2 : 1;
    const float step = (s.y - 0.072f) / static_cast<float>(rows), w = (s.x - 0.044f) / static_cast<float>(columns);
    for (int j = 0; j < rows; ++j) {
        const float y = 0.05f + step * static_cast<float>(j);
        if (j > 0) k.board(wood, {0, y, 0}, {s.x - 0.044f, 0.022f, s.z - 0.012f});
        for (int i = 0; i < columns; ++i) {
            const float x0 = -0.5f * s.x + 0.022f + w * static_cast<float>(i);
            if (i > 0) k.board(wood, {x0, y + 0.022f, 0}, {0.022f, step - 0.022f, s.z - 0.014f});
            fill_shelf(k, x0 + (i > 0 ? 0.012f : 0.f), x0 + w - 0.012f, y + 0.022f, step - 0.022f, -0.5f * s.z + 0.012f,
                       s.z - 0.03f);
        }
    }
    k.top(s.y, 0, 0, 0.45f * s.x, 0.4f * s.z);
    k.piece.clearance_front_m = 0.5f;
    k.piece.against_wall = true;
}

void build_shelf(Kit& k) {
    const Vec3f s = k.wanted({0.9f, 0.f, 0.22f});
    const int wood = k.main(k.style.wood), metal = k.material(k.style.metal);
    k.board(wood, {0, 0.14f, 0.5f * s.z}, {s.x, 0.028f, s.z}, 0.005f);
    for (const float sx : {-1.f, 1.f}) {
        const float x = sx * (0.5f * s.x - 0.12f);
        k.board(metal, {x, 0.0f, 0.006f}, {0.022f, 0.142f, 0.012f});
        k.rod(metal, {x, 0.02f, 0.008f}, {x, 0.142f, s.z - 0.04f}, 0.006f, -1, 8);
    }
    fill_shelf(k, -0.5f * s.x, 0.5f * s.x, 0.168f, 0.36f, 0.01f, s.z - 0.02f);
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.25f;
}

void build_ladder_shelf(Kit& k) {
    const int wood = k.main(k.style.wood);
    for (const float sx : {-1.f, 1.f}) {
        k.rod(wood, {sx * 0.29f, 0, 0.24f}, {sx * 0.29f, 1.85f, -0.22f}, 0.018f, -1, 10);
        k.rod(wood, {sx * 0.29f, 0, -0.22f}, {sx * 0.29f, 1.85f, -0.225f}, 0.015f, -1, 10);
    }
    for (int i = 0; i < 4; ++i) {
        const float y = 0.3f + 0.42f * static_cast<float>(i), front = 0.24f - 0.46f * y / 1.85f, d = front + 0.23f;
        k.board(wood, {0, y, 0.5f * (front - 0.22f)}, {0.58f, 0.022f, d}, 0.004f);
        fill_shelf(k, -0.27f, 0.27f, y + 0.022f, 0.36f, -0.215f, std::max(0.12f, d - 0.02f));
    }
    k.piece.against_wall = true;
    k.piece.clearance_front_m = 0.4f;
}

}  // namespace fastscene::furniture

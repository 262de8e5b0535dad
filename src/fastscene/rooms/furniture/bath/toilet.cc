// Toilet.
#include <array>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/openings/blind_parts.h"

namespace fastscene::furniture {

void build_toilet(Kit& k) {
    const int white = k.main(porcelain()), chrome = k.material(steel());
    const auto oval = [](float w, float d, float z) {
        std::vector<Vec2f> o = shapes::circle(1.f, 40);
        for (Vec2f& p : o) p = {0.5f * w * p.x, z + 0.5f * d * p.y};
        return o;
    };
    // The foot widens into the bowl: a turned body, drawn out lengthwise and leaning forward.
    const std::array<Vec2f, 8> foot{Vec2f{0.115f, 0}, {0.12f, 0.01f},  {0.115f, 0.08f}, {0.12f, 0.15f},
                                    {0.145f, 0.23f},  {0.175f, 0.31f}, {0.188f, 0.36f}, {0.19f, 0.385f}};
    Mesh body = shapes::lathe(foot, 40, true);
    for (Vec3f& p : body.positions) p.z = p.z * 1.28f + 0.06f * (p.y / 0.385f);
    shapes::smooth_normals(body);
    k.add(std::move(body), white);
    k.add(shapes::prism(oval(0.39f, 0.5f, 0.06f), 0.38f, 0.4f, 0.008f), white);
    k.add(shapes::prism(oval(0.37f, 0.48f, 0.06f), 0.401f, 0.425f, 0.01f), white);
    k.soft(white, {0, 0.36f, -0.27f}, {0.38f, 0.42f, 0.18f}, {0.035f, 0.006f, 0.f, 10});
    k.soft(white, {0, 0.775f, -0.27f}, {0.4f, 0.03f, 0.2f}, {0.012f, 0.003f, 0.f, 8});
    k.rod(chrome, {0, 0.8f, -0.27f}, {0, 0.812f, -0.27f}, 0.022f, -1, 20);
    k.board(white, {0, 0, -0.25f}, {0.2f, 0.38f, 0.2f}, 0.02f);
    k.piece.clearance_front_m = 0.6f;
    k.piece.clearance_side_m = 0.2f;
    k.piece.against_wall = true;
}

}  // namespace fastscene::furniture

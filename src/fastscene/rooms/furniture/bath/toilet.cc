// Toilets.
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

// Of cells: a bowl and a basin in one body of steel.
void build_steel_toilet(Kit& k) {
    const int metal = k.main(steel()), dark = k.material(plain("shadow", {0.05f, 0.05f, 0.052f}, 0.5f)),
              water = k.material(plain("water", {0.12f, 0.14f, 0.15f}, 0.05f));
    // The column carries the basin; the bowl grows from its front.
    k.board(metal, {0, 0, -0.17f}, {0.4f, 0.86f, 0.32f}, 0.02f);
    const std::array<Vec2f, 6> bowl{Vec2f{0.13f, 0}, {0.14f, 0.2f}, {0.18f, 0.36f},
                                    {0.2f, 0.4f},    {0.2f, 0.42f}, {0.15f, 0.41f}};
    Mesh body = shapes::lathe(bowl, 28, true);
    for (Vec3f& p : body.positions) p.z *= 1.2f;
    shapes::smooth_normals(body);
    k.add(std::move(body), metal, {0, 0, 0.16f});
    Mesh hole = shapes::prism(shapes::circle(0.145f, 28), 0, 0.004f, 0.001f),
         pool = shapes::prism(shapes::circle(0.08f, 24), 0, 0.003f, 0.001f);
    k.add(std::move(hole), dark, {0, 0.412f, 0.17f});
    k.add(std::move(pool), water, {0, 0.416f, 0.17f});
    // The basin with its raised back, two buttons and a spout.
    k.board(metal, {0, 0.82f, -0.13f}, {0.46f, 0.06f, 0.4f}, 0.02f);
    k.add(shapes::prism(shapes::circle(0.14f, 28), 0, 0.004f, 0.001f), dark, {0, 0.88f, -0.09f});
    k.board(metal, {0, 0.86f, -0.29f}, {0.46f, 0.3f, 0.08f}, 0.015f);
    for (const float x : {-0.08f, 0.08f}) k.rod(metal, {x, 1.04f, -0.25f}, {x, 1.04f, -0.235f}, 0.02f, -1, 16);
    const std::array<Vec3f, 3> spout{Vec3f{0, 0.95f, -0.26f}, {0, 0.99f, -0.2f}, {0, 0.93f, -0.15f}};
    k.add(shapes::tube(spout, 0.011f), metal);
    k.piece.clearance_front_m = 0.6f, k.piece.clearance_side_m = 0.2f;
    k.piece.against_wall = true;
}

}  // namespace fastscene::furniture

// Guitar.
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_guitar(Kit& k) {
    Material spruce = *material_named("pine");
    spruce.roughness = 0.25f;
    const int body = k.main(spruce), dark = k.material(*material_named("mahogany")),
              black = k.material(plain("ebony", {0.033f, 0.031f, 0.03f}, 0.4f)), chrome = k.material(steel());
    Piece inner;  // the instrument stands upright in a small stand, leaning back
    std::vector<Vec2f> o;
    for (int i = 0; i < 64; ++i) {
        const float a = kTau * static_cast<float>(i) / 64.f, y = std::sin(a);
        const float r = 0.165f - 0.022f * y - 0.05f * std::exp(-18.f * (y - 0.25f) * (y - 0.25f));
        o.push_back({r * std::cos(a) * (1.f + 0.18f * (1.f - y * y)), -0.24f * y});
    }
    const auto upright = [&](Mesh m, int mat, Vec3f at) {
        shapes::turn(m, {1, 0, 0}, 90);
        shapes::move(m, at);
        shapes::turn(m, {1, 0, 0}, -14);
        k.add(std::move(m), mat, {0, 0.14f, 0.08f});
    };
    upright(shapes::prism(o, 0.f, 0.09f, 0.006f), dark, {0, 0.24f, -0.045f});
    for (Vec2f& p : o) p = p * 0.985f;
    upright(shapes::prism(o, 0.f, 0.004f, 0.001f), body, {0, 0.24f, 0.044f});
    upright(shapes::prism(shapes::circle(0.05f, 32), 0.f, 0.001f, 0.0002f), black, {0, 0.3f, 0.0482f});
    const auto piece_at = [&](Vec3f size, Vec3f at, int mat) {
        Mesh m = shapes::box(size, 0.003f);
        shapes::move(m, at);
        shapes::turn(m, {1, 0, 0}, -14);
        k.add(std::move(m), mat, {0, 0.14f, 0.08f});
    };
    piece_at({0.054f, 0.52f, 0.02f}, {0, 0.64f, 0.045f}, dark);
    piece_at({0.05f, 0.58f, 0.006f}, {0, 0.61f, 0.057f}, black);
    piece_at({0.075f, 0.16f, 0.016f}, {0, 0.97f, 0.04f}, dark);
    piece_at({0.15f, 0.025f, 0.012f}, {0, 0.13f, 0.052f}, black);
    for (int i = 0; i < 6; ++i) {
        const float x = -0.02f + 0.008f * static_cast<float>(i);
        Mesh s = shapes::rod({x, 0.13f, 0.062f}, {x, 0.92f, 0.062f}, 0.0007f, 0.0007f, 4);
        shapes::turn(s, {1, 0, 0}, -14);
        k.add(std::move(s), chrome, {0, 0.14f, 0.08f});
        piece_at({0.02f, 0.012f, 0.012f},
                 {(i % 2 ? 1.f : -1.f) * 0.046f, 0.92f + 0.04f * static_cast<float>(i / 2), 0.04f}, chrome);
    }
    for (const float sx : {-1.f, 1.f}) {
        k.rod(black, {sx * 0.16f, 0.f, 0.2f}, {sx * 0.07f, 0.14f, 0.0f}, 0.008f);
        k.rod(black, {sx * 0.08f, 0.14f, 0.f}, {sx * 0.08f, 0.14f, 0.16f}, 0.009f);
    }
    k.rod(black, {0, 0, -0.2f}, {0, 0.4f, -0.06f}, 0.008f);
    k.rod(black, {-0.08f, 0.14f, 0}, {0.08f, 0.14f, 0}, 0.008f);
    k.rod(black, {0, 0.14f, 0}, {0, 0.4f, -0.06f}, 0.008f);
}

}  // namespace fastscene::furniture

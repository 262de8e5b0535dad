// What stands in laboratories: microscopes, centrifuges, glassware, fume hoods, robots.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {

namespace {

int lab_liquid(Kit& k) {
    const Vec3f tones[5] = {
        {0.08f, 0.3f, 0.7f}, {0.7f, 0.35f, 0.05f}, {0.1f, 0.5f, 0.2f}, {0.55f, 0.08f, 0.3f}, {0.7f, 0.6f, 0.1f}};
    return color(k, "liquid", tones[k.rng.index(5)], 0.08f);
}

int clear_glass(Kit& k) {
    Material m = plain("clear glass", {0.66f, 0.72f, 0.74f}, 0.05f);
    m.transmission = 0.4f;
    return k.material(m);
}

// A flask with slanted walls, filled to its third.
void erlenmeyer(Kit& k, int clear, int liquid, Vec3f at, float h) {
    const float r = 0.36f * h, neck = 0.12f * h;
    const std::array<Vec2f, 3> fill{Vec2f{r, 0}, {r * 0.99f, 0.06f * h}, {0.66f * r, 0.36f * h}};
    k.add(shapes::lathe(fill, 18), liquid, at);
    const std::array<Vec2f, 4> upper{
        Vec2f{0.66f * r, 0.36f * h}, {neck, 0.76f * h}, {neck, 0.97f * h}, {1.25f * neck, h}};
    k.add(shapes::shade(upper, 18), clear, at);
}

}  // namespace

void build_microscope(Kit& k) {
    const int body = k.main(plain("microscope", {0.72f, 0.72f, 0.7f}, 0.35f)),
              dark = color(k, "black enamel", {0.025f, 0.025f, 0.028f}, 0.35f), metal = k.material(steel()),
              glassy = color(k, "slide", {0.5f, 0.6f, 0.65f}, 0.1f), lamp = lit(k, "microscope lamp", {2, 2, 1.8f});
    k.board(body, {0, 0, 0}, {0.17f, 0.035f, 0.22f}, 0.012f),
        k.board(body, {0, 0.03f, -0.07f}, {0.07f, 0.2f, 0.055f}, 0.014f);
    Mesh arm = shapes::box({0.06f, 0.15f, 0.06f}, 0.014f);
    shapes::turn(arm, {1, 0, 0}, 38), k.add(std::move(arm), body, {0, 0.265f, -0.035f});
    k.board(dark, {0, 0.13f, 0.02f}, {0.14f, 0.012f, 0.13f}, 0.004f),
        block(k, glassy, {0, 0.142f, 0.025f}, {0.075f, 0.002f, 0.025f});
    k.rod(dark, {0, 0.035f, 0.03f}, {0, 0.055f, 0.03f}, 0.03f, 0.026f, 16),
        k.rod(lamp, {0, 0.05f, 0.03f}, {0, 0.058f, 0.03f}, 0.02f, -1, 12);
    k.rod(metal, {0, 0.09f, 0.025f}, {0, 0.13f, 0.025f}, 0.02f, -1, 12);
    // The turret with three lenses, then the tube with its eyepieces, leaning towards who looks.
    k.board(body, {0, 0.285f, 0.025f}, {0.07f, 0.045f, 0.09f}, 0.012f),
        k.rod(dark, {0, 0.255f, 0.025f}, {0, 0.287f, 0.025f}, 0.034f, 0.036f, 16);
    for (const Vec3f d : {Vec3f{0, -0.075f, 0.0f}, Vec3f{-0.05f, -0.05f, -0.012f}, Vec3f{0.05f, -0.05f, -0.012f}})
        k.rod(metal, Vec3f{0, 0.262f, 0.025f}, Vec3f{0, 0.262f, 0.025f} + d, 0.014f, 0.009f, 10);
    for (const float sx : {-1.f, 1.f}) {
        k.rod(body, {sx * 0.018f, 0.315f, 0.02f}, {sx * 0.03f, 0.375f, 0.085f}, 0.019f, -1, 12),
            k.rod(dark, {sx * 0.03f, 0.372f, 0.082f}, {sx * 0.034f, 0.395f, 0.107f}, 0.016f, 0.019f, 12);
        k.rod(dark, {sx * 0.035f, 0.085f, -0.065f}, {sx * 0.06f, 0.085f, -0.065f}, 0.026f, -1, 16),
            k.rod(metal, {sx * 0.055f, 0.085f, -0.065f}, {sx * 0.075f, 0.085f, -0.065f}, 0.014f, -1, 12);
    }
    on_surface(k);
}

void build_centrifuge(Kit& k) {
    const int body = k.main(plain("centrifuge", {0.7f, 0.71f, 0.71f}, 0.35f)),
              gray = color(k, "lid", {0.2f, 0.24f, 0.3f}, 0.3f), dark = color(k, "gap", {0.02f, 0.02f, 0.022f}, 0.5f),
              screen = lit(k, "display", {0.2f, 0.7f, 1.1f}), metal = k.material(steel());
    k.board(body, {0, 0.012f, 0}, {0.36f, 0.2f, 0.4f}, 0.025f);
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f}) block(k, dark, {sx * 0.13f, 0, sz * 0.15f}, {0.035f, 0.014f, 0.035f});
    k.add(shapes::prism(shapes::circle(0.165f, 32), 0.21f, 0.216f, 0.002f), dark, {0, 0, -0.025f});
    const std::array<Vec2f, 4> lid{Vec2f{0.16f, 0}, {0.155f, 0.016f}, {0.12f, 0.032f}, {0.f, 0.038f}};
    k.add(shapes::lathe(lid, 32, true), gray, {0, 0.214f, -0.025f}),
        k.rod(metal, {-0.04f, 0.22f, 0.145f}, {0.04f, 0.22f, 0.145f}, 0.008f, -1, 8);
    k.add(shapes::prism(shapes::circle(0.05f, 20), 0.246f, 0.254f, 0.002f), k.material(glass()), {0, 0, -0.025f});
    block(k, dark, {0, 0.05f, 0.2005f}, {0.3f, 0.1f, 0.003f}),
        block(k, screen, {-0.06f, 0.075f, 0.202f}, {0.12f, 0.05f, 0.003f});
    k.rod(metal, {0.1f, 0.1f, 0.2f}, {0.1f, 0.1f, 0.222f}, 0.025f, 0.022f, 16);
    for (int i = 0; i < 3; ++i)
        block(k, i == 0 ? gray : body, {-0.1f + 0.035f * static_cast<float>(i), 0.058f, 0.202f},
              {0.024f, 0.012f, 0.004f});
    on_surface(k);
}

// A beaker, two flasks and a cylinder, each with something in it.
void build_glassware(Kit& k) {
    Material pane = plain("clear glass", {0.66f, 0.72f, 0.74f}, 0.05f);
    pane.transmission = 0.4f;
    const int clear = k.main(pane);
    const auto beaker = [&](Vec3f at, float r, float h, float fill) {
        const std::array<Vec2f, 2> in{Vec2f{r * 0.97f, 0}, {r * 0.97f, fill * h}};
        k.add(shapes::lathe(in, 18), lab_liquid(k), at);
        const std::array<Vec2f, 3> wall{Vec2f{r, fill * h}, {r, 0.95f * h}, {1.07f * r, h}};
        k.add(shapes::shade(wall, 18), clear, at);
    };
    erlenmeyer(k, clear, lab_liquid(k), {-0.11f, 0, -0.02f}, 0.17f),
        erlenmeyer(k, clear, lab_liquid(k), {0.02f, 0, -0.06f}, 0.13f);
    beaker({0.0f, 0, 0.055f}, 0.038f, 0.095f, k.rng.uniform(0.3f, 0.6f)),
        beaker({0.1f, 0, 0.03f}, 0.05f, 0.125f, k.rng.uniform(0.25f, 0.6f));
    // A graduated cylinder on its foot, and a round flask on a ring of cork.
    k.add(shapes::prism(shapes::circle(0.036f, 6), 0, 0.008f, 0.002f), clear, {0.11f, 0, -0.075f}),
        beaker({0.11f, 0.008f, -0.075f}, 0.017f, 0.23f, 0.55f);
    const int cork = color(k, "cork", {0.42f, 0.27f, 0.14f}, 0.9f), round = lab_liquid(k);
    k.add(shapes::ring(0.035f, 0.012f, 18), cork, {-0.1f, 0.012f, 0.085f});
    std::vector<Vec2f> below, above;
    for (int i = 0; i <= 6; ++i) {
        const float a = -0.5f * kPi + 0.55f * kPi * static_cast<float>(i) / 6,
                    b = 0.05f * kPi + 0.36f * kPi * static_cast<float>(i) / 6;
        below.push_back({0.048f * std::cos(a), 0.056f + 0.048f * std::sin(a)}),
            above.push_back({0.048f * std::cos(b), 0.056f + 0.048f * std::sin(b)});
    }
    above.push_back({0.0125f, 0.16f}), above.push_back({0.018f, 0.165f});
    k.add(shapes::lathe(below, 18, true), round, {-0.1f, 0, 0.085f}),
        k.add(shapes::shade(above, 18), clear, {-0.1f, 0, 0.085f});
    on_surface(k);
}

void build_test_tube_rack(Kit& k) {
    const int rack = k.main(k.rng.chance(0.5f) ? k.style.wood : plain("rack", {0.75f, 0.76f, 0.76f}, 0.4f)),
              clear = clear_glass(k);
    for (const float sx : {-1.f, 1.f}) k.board(rack, {sx * 0.125f, 0, 0}, {0.012f, 0.1f, 0.085f}, 0.003f);
    for (const float y : {0.006f, 0.075f}) k.board(rack, {0, y, 0}, {0.24f, 0.009f, 0.08f}, 0.002f);
    for (int r = 0; r < 2; ++r)
        for (int i = 0; i < 6; ++i) {
            if (k.rng.chance(0.15f)) continue;
            const Vec3f at{-0.1f + 0.04f * static_cast<float>(i), 0.015f, r ? 0.02f : -0.02f};
            const float fill = k.rng.uniform(0.07f, 0.11f);
            const std::array<Vec2f, 3> in{Vec2f{0.003f, 0}, {0.0085f, 0.008f}, {0.0085f, fill}},
                wall{Vec2f{0.009f, fill}, {0.009f, 0.135f}, {0.011f, 0.138f}};
            k.add(shapes::lathe(in, 10), lab_liquid(k), at), k.add(shapes::shade(wall, 10), clear, at);
        }
    on_surface(k);
}

// A cabinet whose sash of glass is half up: what is handled in it, the lit chamber, the duct above.
void build_fume_hood(Kit& k) {
    const int body = k.main(plain("lacquered steel", {0.68f, 0.7f, 0.71f}, 0.35f)),
              dark = color(k, "worktop", {0.05f, 0.055f, 0.06f}, 0.35f),
              inner = color(k, "lining", {0.55f, 0.56f, 0.56f}, 0.5f), pane = k.material(glass()),
              metal = k.material(steel()), lamp = k.material(glow("tube", {5, 5, 4.8f})),
              gas = color(k, "gas tap", {0.7f, 0.55f, 0.05f}, 0.4f),
              blue = color(k, "cabinet", {0.12f, 0.25f, 0.42f}, 0.4f);
    const float w = 1.5f, d = 0.82f;
    k.board(dark, {0, 0, -0.02f}, {w - 0.06f, 0.08f, d - 0.1f}, 0.004f),
        k.board(blue, {0, 0.08f, -0.02f}, {w, 0.74f, d - 0.06f}, 0.006f);
    for (const float sx : {-1.f, 1.f}) {
        k.board(blue, {sx * 0.25f * w, 0.1f, 0.5f * d - 0.045f}, {0.5f * w - 0.02f, 0.68f, 0.02f}, 0.004f),
            k.board(metal, {sx * 0.05f, 0.5f, 0.5f * d - 0.02f}, {0.014f, 0.16f, 0.02f}, 0.005f);
        k.board(body, {sx * (0.5f * w - 0.06f), 0.86f, 0}, {0.12f, 1.2f, d}, 0.01f);
        for (int i = 0; i < 3; ++i)
            k.rod(i ? gas : metal, {sx * (0.5f * w - 0.06f), 0.95f + 0.1f * static_cast<float>(i), 0.5f * d},
                  {sx * (0.5f * w - 0.06f), 0.95f + 0.1f * static_cast<float>(i), 0.5f * d + 0.035f}, 0.018f, -1, 8);
    }
    k.board(dark, {0, 0.82f, 0}, {w, 0.04f, d + 0.02f}, 0.008f),
        k.board(inner, {0, 0.86f, -0.5f * d + 0.05f}, {w - 0.24f, 1.2f, 0.03f}, 0.003f);
    for (const float y : {0.95f, 1.5f}) block(k, dark, {0, y, -0.5f * d + 0.067f}, {w - 0.4f, 0.02f, 0.003f});
    k.board(body, {0, 1.98f, 0}, {w, 0.3f, d}, 0.01f), block(k, lamp, {0, 1.972f, 0}, {w - 0.5f, 0.012f, 0.1f});
    block(k, pane, {0, 1.32f, 0.5f * d - 0.06f}, {w - 0.25f, 0.62f, 0.008f});
    for (const float y : {1.3f, 1.93f}) k.board(metal, {0, y, 0.5f * d - 0.06f}, {w - 0.24f, 0.03f, 0.025f}, 0.006f);
    k.rod(metal, {0, 2.27f, -0.1f}, {0, 2.5f, -0.1f}, 0.14f, -1, 20);
    k.merge(k.small("glassware"), {-0.25f, 0.86f, -0.05f}), k.merge(k.small("test_tube_rack"), {0.3f, 0.86f, 0.02f});
    k.piece.clearance_front_m = 0.8f, k.piece.against_wall = true;
}

// An industrial robot: base, shoulder, two arms, a gripper.
void build_robot_arm(Kit& k) {
    const int paint = k.main(plain("robot paint", {0.85f, 0.32f, 0.02f}, 0.35f)),
              dark = color(k, "joint", {0.04f, 0.04f, 0.043f}, 0.45f), metal = k.material(steel()),
              gray = color(k, "pedestal", {0.25f, 0.26f, 0.27f}, 0.5f);
    k.add(shapes::prism(shapes::circle(0.42f, 32), 0, 0.06f, 0.01f), gray);
    for (int i = 0; i < 8; ++i)
        k.rod(metal, around(kTau * static_cast<float>(i) / 8) * 0.36f + Vec3f{0, 0.05f, 0},
              around(kTau * static_cast<float>(i) / 8) * 0.36f + Vec3f{0, 0.08f, 0}, 0.02f, -1, 6);
    const std::array<Vec2f, 4> base{Vec2f{0.3f, 0.06f}, {0.28f, 0.2f}, {0.22f, 0.28f}, {0.22f, 0.42f}};
    k.add(shapes::lathe(base, 28), paint), k.add(shapes::prism(shapes::circle(0.25f, 28), 0.42f, 0.5f, 0.01f), dark);
    k.board(paint, {0, 0.48f, -0.02f}, {0.34f, 0.3f, 0.36f}, 0.05f);
    const float turn = k.rng.uniform(-0.2f, 0.2f);
    const Vec3f shoulder{0, 0.72f, 0.08f}, elbow{0, 1.52f, -0.22f + turn}, wrist{0, 1.62f, 0.56f + turn},
        tip{0, 1.36f, 0.72f + turn};
    k.rod(dark, shoulder + Vec3f{-0.23f, 0, 0}, shoulder + Vec3f{0.23f, 0, 0}, 0.15f, -1, 24);
    strut(k, paint, shoulder + Vec3f{0.15f, 0, 0}, elbow + Vec3f{0.15f, 0, 0}, 0.1f, 0.2f),
        strut(k, paint, shoulder + Vec3f{-0.15f, 0, 0}, elbow + Vec3f{-0.15f, 0, 0}, 0.06f, 0.12f);
    k.rod(dark, elbow + Vec3f{-0.21f, 0, 0}, elbow + Vec3f{0.21f, 0, 0}, 0.12f, -1, 20),
        k.rod(paint, elbow + Vec3f{0, 0.02f, -0.2f}, wrist, 0.11f, 0.07f, 18);
    k.rod(dark, elbow + Vec3f{0, 0.02f, -0.32f}, elbow + Vec3f{0, 0.02f, -0.19f}, 0.085f, -1, 16);
    k.rod(dark, wrist + Vec3f{-0.085f, 0, 0}, wrist + Vec3f{0.085f, 0, 0}, 0.07f, -1, 16),
        k.rod(paint, wrist, tip, 0.06f, 0.05f, 14);
    const Vec3f down = normalize(tip - wrist);
    k.rod(metal, tip, tip + down * 0.05f, 0.06f, -1, 14);
    for (const float sx : {-1.f, 1.f})
        k.rod(metal, tip + down * 0.05f, tip + down * 0.1f + Vec3f{sx * 0.08f, 0, 0}, 0.016f, -1, 8),
            k.rod(dark, tip + down * 0.1f + Vec3f{sx * 0.08f, 0, 0}, tip + down * 0.22f + Vec3f{sx * 0.045f, 0, 0},
                  0.016f, 0.01f, 8);
    std::vector<Vec3f> cable;
    for (int i = 0; i <= 12; ++i) {
        const float t = static_cast<float>(i) / 12;
        cable.push_back(lerp(Vec3f{0.22f, 0.45f, -0.16f}, elbow + Vec3f{0.1f, 0.05f, -0.3f}, t) +
                        Vec3f{0.1f * std::sin(kPi * t), 0, -0.18f * std::sin(kPi * t)});
    }
    k.add(shapes::tube(cable, 0.022f, 8), dark);
    k.piece.clearance_front_m = 0.6f;
}

}  // namespace fastscene::furniture

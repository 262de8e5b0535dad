// A car, a bicycle, the seats of trains.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {
namespace {

void wheel(Kit& k, int tyre, int rim, Vec3f at, float r, float wide) {
    const std::array<Vec2f, 6> p{
        Vec2f{0.62f * r, -0.5f * wide}, {0.95f * r, -0.5f * wide}, {r, -0.3f * wide}, {r, 0.3f * wide},
        {0.95f * r, 0.5f * wide},       {0.62f * r, 0.5f * wide}};
    const std::array<Vec2f, 2> disc{Vec2f{0.62f * r, -0.4f * wide}, {0.62f * r, 0.4f * wide}};
    Mesh rubber = shapes::lathe(p, 28), plate = shapes::lathe(disc, 20);
    for (Mesh* m : {&rubber, &plate}) shapes::turn(*m, {0, 0, 1}, 90);
    k.add(std::move(rubber), tyre, at), k.add(std::move(plate), rim, at);
    for (int i = 0; i < 5; ++i) {
        const float a = kTau * static_cast<float>(i) / 5;
        k.rod(tyre, at + Vec3f{std::copysign(0.42f * wide, at.x), 0.35f * r * std::cos(a), 0.35f * r * std::sin(a)},
              at + Vec3f{std::copysign(0.44f * wide, at.x), 0.35f * r * std::cos(a), 0.35f * r * std::sin(a)},
              0.12f * r, -1, 8);
    }
}

}  // namespace

// A compact car; its front looks along +z. The body is lofted from cross-sections.
void build_car(Kit& k) {
    const int paint = k.main(plain("car paint", k.accent(), 0.12f)),
              pane = color(k, "car window", {0.02f, 0.025f, 0.03f}, 0.05f),
              tyre = color(k, "tyre", {0.02f, 0.02f, 0.02f}, 0.8f), rim = k.material(steel()),
              dark = color(k, "trim", {0.025f, 0.025f, 0.025f}, 0.6f),
              lamp = color(k, "headlight", {0.72f, 0.72f, 0.7f}, 0.08f),
              red = color(k, "tail light", {0.45f, 0.02f, 0.02f}, 0.15f);
    // z, half width, y of the belt line: the lower body.
    struct Section {
        float z, half, low, high;
    };
    const std::array<Section, 9> lower{{{-1.9f, 0.68f, 0.38f, 0.82f},
                                        {-1.78f, 0.78f, 0.28f, 0.92f},
                                        {-1.2f, 0.84f, 0.22f, 0.95f},
                                        {-0.3f, 0.85f, 0.22f, 0.93f},
                                        {0.6f, 0.85f, 0.22f, 0.92f},
                                        {1.1f, 0.84f, 0.22f, 0.9f},
                                        {1.6f, 0.81f, 0.24f, 0.82f},
                                        {1.85f, 0.74f, 0.28f, 0.72f},
                                        {1.95f, 0.62f, 0.34f, 0.6f}}};
    const std::array<Section, 7> cabin{{{-1.72f, 0.6f, 0.85f, 0.94f},
                                        {-1.4f, 0.64f, 0.85f, 1.32f},
                                        {-0.9f, 0.66f, 0.85f, 1.45f},
                                        {-0.2f, 0.67f, 0.85f, 1.48f},
                                        {0.3f, 0.66f, 0.85f, 1.42f},
                                        {0.75f, 0.66f, 0.85f, 1.15f},
                                        {1.05f, 0.66f, 0.85f, 0.92f}}};
    const auto loft = [&](std::span<const Section> sections, float round, float inset, float grow, int material) {
        const int last = static_cast<int>(sections.size()) - 1;
        Mesh m = shapes::sheet(30, 6 * last, [&](float u, float v) {
            const float at = v * static_cast<float>(last);
            const auto i = static_cast<std::size_t>(std::min(static_cast<int>(at), last - 1));
            const float t = at - static_cast<float>(i);
            const Section &a = sections[i], &b = sections[i + 1];
            const float half = std::lerp(a.half, b.half, t) + grow, low = std::lerp(a.low, b.low, t),
                        high = std::lerp(a.high, b.high, t) + grow, z = std::lerp(a.z, b.z, t);
            const float angle = kTau * u, c = std::cos(angle), s = std::sin(angle);
            // A rounded box.
            const float cx = std::copysign(std::pow(std::fabs(c), round), c),
                        cy = std::copysign(std::pow(std::fabs(s), round), s);
            const float taper = 1.f - inset * std::max(0.f, cy);
            return Vec3f{-cx * half * taper, (low + high) / 2 + cy * (high - low) / 2, z};
        });
        shapes::lay_grain(m);
        k.add(std::move(m), material);
    };
    loft(lower, 0.35f, 0.04f, 0, paint), loft(cabin, 0.4f, 0.14f, 0, pane);
    // The roof over the panes, the pillars.
    const std::array<Section, 4> roof{{{-1.25f, 0.55f, 1.36f, 1.41f},
                                       {-0.9f, 0.565f, 1.42f, 1.465f},
                                       {-0.2f, 0.57f, 1.45f, 1.495f},
                                       {0.25f, 0.56f, 1.41f, 1.445f}}};
    loft(roof, 0.3f, 0.02f, 0.01f, paint);
    for (const float sx : {-1.f, 1.f}) {
        strut(k, paint, {sx * 0.655f, 0.9f, 1.02f}, {sx * 0.56f, 1.43f, 0.22f}, 0.05f, 0.05f),
            strut(k, paint, {sx * 0.655f, 0.9f, -0.25f}, {sx * 0.57f, 1.46f, -0.3f}, 0.05f, 0.07f),
            strut(k, paint, {sx * 0.63f, 0.9f, -1.62f}, {sx * 0.555f, 1.4f, -1.15f}, 0.06f, 0.14f);
        for (const float z : {-1.25f, 1.25f}) {
            Mesh arch = shapes::ball({0, 0, 0}, {0.1f, 0.38f, 0.38f}, 20);
            k.add(std::move(arch), dark, {sx * 0.76f, 0.34f, z}),
                wheel(k, tyre, rim, {sx * 0.77f, 0.31f, z}, 0.31f, 0.2f);
        }
        k.add(shapes::ball({sx * 0.58f, 0.66f, 1.83f}, {0.16f, 0.08f, 0.08f}, 14), lamp),
            k.board(red, {sx * 0.62f, 0.66f, -1.83f}, {0.2f, 0.16f, 0.08f}, 0.02f);
        k.add(shapes::ball({sx * 0.9f, 1.0f, 0.75f}, {0.1f, 0.07f, 0.06f}, 12), paint),
            k.board(dark, {sx * 0.846f, 0.74f, -0.1f}, {0.02f, 0.025f, 0.16f}, 0.006f),
            k.board(dark, {sx * 0.845f, 0.25f, 0}, {0.03f, 0.08f, 1.7f}, 0.01f);
    }
    k.board(dark, {0, 0.42f, 1.93f}, {0.8f, 0.14f, 0.06f}, 0.02f),
        k.board(lamp, {0, 0.52f, -1.9f}, {0.5f, 0.11f, 0.03f}, 0.004f),
        k.board(dark, {0, 0.28f, -1.86f}, {1.3f, 0.1f, 0.1f}, 0.03f),
        k.board(dark, {0, 0.2f, 0}, {1.4f, 0.06f, 3.2f}, 0.01f);
    k.piece.clearance_front_m = 0.6f, k.piece.clearance_side_m = 0.5f;
}

void build_bicycle(Kit& k) {
    const int paint = k.main(plain("bicycle paint", k.accent(), 0.15f)),
              tyre = color(k, "tyre", {0.02f, 0.02f, 0.02f}, 0.8f), metal = k.material(steel()),
              leather = color(k, "saddle", {0.12f, 0.05f, 0.02f}, 0.4f);
    const float r = 0.34f, back = -0.5f, front = 0.52f;
    for (const float z : {back, front}) {
        Mesh ring = shapes::ring(r - 0.015f, 0.035f, 36), rim = shapes::ring(r - 0.04f, 0.016f, 36);
        for (Mesh* m : {&ring, &rim}) shapes::turn(*m, {0, 0, 1}, 90);
        k.add(std::move(ring), tyre, {0, r, z}), k.add(std::move(rim), metal, {0, r, z}),
            k.rod(metal, {-0.05f, r, z}, {0.05f, r, z}, 0.018f);
        for (int i = 0; i < 14; ++i) {
            const float a = kTau * static_cast<float>(i) / 14;
            k.rod(metal, {0.012f, r, z}, {0, r + (r - 0.04f) * std::cos(a), z + (r - 0.04f) * std::sin(a)}, 0.0015f, -1,
                  4);
        }
    }
    const Vec3f seat{0, 0.86f, -0.22f}, crank{0, 0.3f, -0.08f}, head{0, 0.84f, 0.34f}, low{0, 0.7f, 0.38f};
    for (const auto& [a, b] :
         {std::pair{seat, crank}, {crank, low}, {seat - Vec3f{0, 0.06f, -0.01f}, head}, {low, head}})
        k.rod(paint, a, b, 0.018f, -1, 10);
    for (const float sx : {-1.f, 1.f})
        k.rod(paint, crank + Vec3f{sx * 0.02f, 0, 0}, {sx * 0.05f, r, back}, 0.011f, -1, 8),
            k.rod(paint, seat + Vec3f{sx * 0.015f, -0.1f, 0}, {sx * 0.05f, r, back}, 0.01f, -1, 8),
            k.rod(paint, low + Vec3f{sx * 0.03f, 0, 0}, {sx * 0.05f, r, front}, 0.013f, -1, 8);
    k.rod(metal, seat, {0, 0.95f, -0.25f}, 0.013f),
        k.add(shapes::ball({0, 0.97f, -0.25f}, {0.075f, 0.03f, 0.13f}, 14), leather),
        k.rod(metal, head, {0, 0.98f, 0.32f}, 0.013f),
        k.rod(metal, {-0.27f, 1.0f, 0.28f}, {0.27f, 1.0f, 0.28f}, 0.012f);
    for (const float sx : {-1.f, 1.f})
        k.rod(leather, {sx * 0.27f, 1.0f, 0.28f}, {sx * 0.29f, 0.99f, 0.16f}, 0.017f),
            k.rod(metal, crank + Vec3f{sx * 0.06f, 0, 0}, crank + Vec3f{sx * 0.08f, sx * 0.12f, sx * 0.12f}, 0.01f),
            k.board(tyre, crank + Vec3f{sx * 0.13f, sx * 0.12f - 0.01f, sx * 0.12f}, {0.09f, 0.02f, 0.07f}, 0.004f);
    Mesh ring = shapes::ring(0.09f, 0.012f, 24);
    shapes::turn(ring, {0, 0, 1}, 90);
    k.add(std::move(ring), metal, crank + Vec3f{0.05f, 0, 0}),
        k.rod(metal, {0.03f, 0, -0.05f}, {0.02f, 0.3f, -0.08f}, 0.009f, -1, 6);
    k.piece.clearance_front_m = 0.3f;
}

// A seat for two with a high back, as trains and buses have.
void build_train_seat(Kit& k) {
    const int cloth = k.main(tinted(k.style.fabric, {0.05f, 0.12f, 0.3f})),
              shell = color(k, "shell", {0.16f, 0.17f, 0.18f}, 0.4f), metal = k.material(steel()),
              white = color(k, "head cloth", {0.7f, 0.69f, 0.66f}, 0.9f),
              tray = color(k, "tray", {0.42f, 0.42f, 0.41f}, 0.45f),
              net = color(k, "net", {0.03f, 0.03f, 0.035f}, 0.9f);
    k.board(shell, {0, 0, -0.02f}, {0.9f, 0.3f, 0.16f}, 0.02f);
    for (const float sx : {-1.f, 1.f}) {
        k.soft(cloth, {sx * 0.235f, 0.34f, 0.05f}, {0.45f, 0.13f, 0.48f}, {0.04f, 0.015f, 0.001f, 7});
        Mesh back = shapes::soft_box({0.45f, 0.78f, 0.13f}, {0.04f, 0.018f, 0.001f, 7, k.seed()}),
             head = shapes::box({0.3f, 0.2f, 0.012f}, 0.004f);
        shapes::turn(back, {1, 0, 0}, -8), shapes::turn(head, {1, 0, 0}, -8);
        // Behind it, a tray that folds down, and a net.
        k.board(tray, {sx * 0.225f, 0.76f, -0.352f}, {0.38f, 0.25f, 0.02f}, 0.008f);
        k.board(shell, {sx * 0.225f, 1.02f, -0.352f}, {0.05f, 0.025f, 0.025f}, 0.008f);
        k.board(net, {sx * 0.225f, 0.46f, -0.35f}, {0.34f, 0.2f, 0.014f}, 0.006f);
        k.add(std::move(back), cloth, {sx * 0.235f, 0.82f, -0.24f}),
            k.add(std::move(head), white, {sx * 0.235f, 1.07f, -0.205f}),
            k.board(shell, {sx * 0.485f, 0.55f, 0.02f}, {0.05f, 0.05f, 0.4f}, 0.015f);
    }
    k.board(shell, {0, 0.32f, -0.33f}, {0.92f, 0.9f, 0.03f}, 0.012f),
        k.rod(metal, {-0.3f, 1.23f, -0.33f}, {0.3f, 1.23f, -0.33f}, 0.014f);
    k.piece.clearance_front_m = 0.35f;
}

// A pole to hold on to, with a button.
void build_grab_pole(Kit& k) {
    const Vec3f s = k.wanted({0.1f, 2.27f, 0.1f});
    const int metal = k.main(plain("pole", {0.6f, 0.42f, 0.03f}, 0.25f)),
              box = color(k, "stop box", {0.5f, 0.02f, 0.015f}, 0.35f),
              button = color(k, "stop button", {0.65f, 0.63f, 0.58f}, 0.3f);
    k.rod(metal, {0, 0, 0}, {0, s.y, 0}, 0.018f, -1, 14);
    for (const float y : {0.f, s.y - 0.03f})
        k.add(shapes::prism(shapes::circle(0.05f, 18), y, y + 0.03f, 0.004f), metal);
    // The button that asks the driver to stop, on both sides.
    k.board(box, {0, 1.22f, 0}, {0.06f, 0.14f, 0.06f}, 0.016f);
    for (const float side : {-1.f, 1.f}) {
        Mesh disc = shapes::prism(shapes::circle(0.021f, 16), 0, 0.008f, 0.002f);
        shapes::turn(disc, {1, 0, 0}, 90 * side);
        k.add(std::move(disc), button, {0, 1.28f, side * 0.033f});
    }
}

}  // namespace fastscene::furniture

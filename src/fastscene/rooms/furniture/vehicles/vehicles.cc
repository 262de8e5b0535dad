// A bicycle, the seats of trains.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {
void build_bicycle(Kit& k) {
    const int paint = k.main(plain("bicycle paint", k.accent(), 0.15f)),
              tire = color(k, "tire", {0.02f, 0.02f, 0.02f}, 0.8f), metal = k.material(steel()),
              leather = color(k, "saddle", {0.12f, 0.05f, 0.02f}, 0.4f);
    const float r = 0.34f, back = -0.5f, front = 0.52f;
    for (const float z : {back, front}) {
        Mesh ring = shapes::ring(r - 0.015f, 0.035f, 36), rim = shapes::ring(r - 0.04f, 0.016f, 36);
        for (Mesh* m : {&ring, &rim}) shapes::turn(*m, {0, 0, 1}, 90);
        k.add(std::move(ring), tire, {0, r, z}), k.add(std::move(rim), metal, {0, r, z}),
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
            k.board(tire, crank + Vec3f{sx * 0.13f, sx * 0.12f - 0.01f, sx * 0.12f}, {0.09f, 0.02f, 0.07f}, 0.004f);
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

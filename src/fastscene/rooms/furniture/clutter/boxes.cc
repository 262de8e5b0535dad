// Boxes of cardboard: for moving, for pizza.
#include <array>
#include <utility>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// Cardboard, taped; the one in front is still open.
void build_moving_boxes(Kit& k) {
    Material card = plain("cardboard", {0.37f, 0.24f, 0.125f}, 0.9f);
    const int board = k.main(card), tape = k.material(plain("packing tape", {0.5f, 0.38f, 0.22f}, 0.35f)),
              inside = k.material(plain("inside of a box", {0.2f, 0.125f, 0.065f}, 0.95f)),
              mark = k.material(plain("marker", {0.04f, 0.04f, 0.045f}, 0.8f));
    const auto closed = [&](Vec3f at, Vec3f size) {
        k.board(board, at, size, 0.006f);
        k.board(tape, at + Vec3f{0, size.y - 0.001f, 0}, {0.055f, 0.0018f, size.z - 0.004f}, 0.0004f);
        k.board(tape, at + Vec3f{0, 0.62f * size.y, 0.5f * size.z}, {0.055f, 0.38f * size.y, 0.0018f}, 0.0004f);
        for (int i = 0; i < 2; ++i)
            k.board(mark, at + Vec3f{-0.12f, 0.25f * size.y + 0.035f * static_cast<float>(i), 0.5f * size.z},
                    {0.11f - 0.03f * static_cast<float>(i), 0.012f, 0.0016f}, 0.0004f);
    };
    closed({-0.24f, 0, -0.08f}, {0.46f, 0.36f, 0.36f});
    closed({-0.2f, 0.36f, -0.09f}, {0.38f, 0.29f, 0.32f});
    // The open one: four walls, a dark inside, four flaps.
    const Vec3f s{0.4f, 0.3f, 0.34f}, at{0.25f, 0, 0.02f};
    for (const float sx : {-1.f, 1.f})
        k.board(board, at + Vec3f{sx * (0.5f * s.x - 0.004f), 0, 0}, {0.008f, s.y, s.z}, 0.002f);
    for (const float sz : {-1.f, 1.f})
        k.board(board, at + Vec3f{0, 0, sz * (0.5f * s.z - 0.004f)}, {s.x, s.y, 0.008f}, 0.002f);
    k.board(inside, at, {s.x - 0.012f, 0.2f * s.y, s.z - 0.012f}, 0.002f);
    for (const float sz : {-1.f, 1.f})
        strut(k, board, at + Vec3f{0, s.y - 0.002f, sz * 0.5f * s.z},
              at + Vec3f{0, s.y + 0.03f, sz * (0.5f * s.z + 0.13f)}, s.x - 0.01f, 0.005f);
    for (const float sx : {-1.f, 1.f}) {
        Mesh flap = shapes::box({0.005f, 0.14f, s.z - 0.01f}, 0.001f);
        shapes::turn(flap, {0, 0, 1}, -sx * 62.f);
        k.add(std::move(flap), board, at + Vec3f{sx * (0.5f * s.x + 0.06f), s.y + 0.03f, 0});
    }
    // Rolls and books look out.
    k.rod(k.material(plain("rolled paper", {0.66f, 0.62f, 0.54f}, 0.9f)), at + Vec3f{0.08f, 0.07f, 0.05f},
          at + Vec3f{0.13f, 0.5f, 0.0f}, 0.028f, -1, 16);
    for (int i = 0; i < 3; ++i)
        k.board(k.material(plain("book cover", k.accent(), 0.6f)),
                at + Vec3f{-0.12f + 0.05f * static_cast<float>(i), 0.07f, -0.03f},
                {0.035f, 0.2f + 0.03f * static_cast<float>(i), 0.17f}, 0.003f);
    k.top(0.65f, -0.2f, -0.09f, 0.15f, 0.12f);
}

// Two boxes one on the other, the lid of the upper one ajar, a slice left over, a can beside them.
void build_pizza_boxes(Kit& k) {
    const int card = k.main(plain("pizza box", {0.6f, 0.52f, 0.4f}, 0.85f)),
              red = k.material(plain("print", {0.45f, 0.04f, 0.03f}, 0.7f)),
              crust = k.material(plain("crust", {0.5f, 0.27f, 0.09f}, 0.8f)),
              cheese = k.material(plain("cheese", {0.66f, 0.4f, 0.08f}, 0.4f)),
              can = k.material(plain("soda can", {0.5f, 0.03f, 0.03f}, 0.25f)), lid = k.material(steel());
    const float w = 0.33f, h = 0.04f;
    k.board(card, {0, 0, 0}, {w, h, w}, 0.003f);
    const auto rim = [&](Vec3f at, Vec3f size) { k.board(card, at + Vec3f{0.015f, h, 0.012f}, size, 0.001f); };
    rim({0, 0, 0}, {w, 0.004f, w});
    for (const float s : {-1.f, 1.f}) {
        rim({s * (0.5f * w - 0.002f), 0.003f, 0}, {0.004f, h - 0.003f, w});
        rim({0, 0.003f, s * (0.5f * w - 0.002f)}, {w, h - 0.003f, 0.004f});
    }
    // A slice with its crust at the back.
    const std::array<Vec2f, 3> slice{Vec2f{-0.06f, -0.07f}, {0.06f, -0.07f}, {0.f, 0.1f}};
    k.add(shapes::prism(slice, h + 0.005f, h + 0.016f, 0.003f), cheese, {0.03f, 0, 0.02f});
    k.rod(crust, {-0.035f, h + 0.016f, -0.052f}, {0.095f, h + 0.016f, -0.052f}, 0.012f, -1, 10);
    for (int i = 0; i < 3; ++i)
        k.add(shapes::prism(shapes::circle(0.013f, 16), h + 0.015f, h + 0.019f, 0.001f), red,
              {0.03f + 0.028f * static_cast<float>(i - 1), 0, 0.0f + 0.03f * static_cast<float>(i % 2)});
    // The lid stands up at the back.
    const Vec3f hinge{0.015f, 2 * h, 0.012f - 0.5f * w};
    strut(k, card, hinge, hinge + Vec3f{0, 0.26f, -0.19f}, w, 0.004f);
    strut(k, red, hinge + Vec3f{0, 0.09f, -0.06f} + Vec3f{0, 0.0015f, 0.0022f},
          hinge + Vec3f{0, 0.17f, -0.12f} + Vec3f{0, 0.0015f, 0.0022f}, 0.2f, 0.001f);
    const std::array<Vec2f, 6> body{Vec2f{0.024f, 0}, {0.033f, 0.006f}, {0.033f, 0.1f},
                                    {0.028f, 0.112f}, {0.026f, 0.114f}, {0.0f, 0.112f}};
    k.add(shapes::lathe(body, 28), can, {0.24f, 0, 0.1f});
    k.add(shapes::prism(shapes::circle(0.025f, 24), 0.112f, 0.1135f, 0.0005f), lid, {0.24f, 0, 0.1f});
}

}  // namespace fastscene::furniture

// Couches that one lies on: of a doctor, of a tattooist.
#include <array>
#include <utility>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {

// Padded, its head raised, paper from a roll along its middle; a step before it.
void build_exam_couch(Kit& k) {
    const int pad = k.main(plain("couch vinyl", {0.1f, 0.2f, 0.26f}, 0.4f)),
              frame = color(k, "couch lacquer", {0.7f, 0.71f, 0.7f}, 0.35f), metal = k.material(steel()),
              paper = color(k, "couch paper", {0.76f, 0.76f, 0.74f}, 0.9f);
    // The head is at -z.
    k.board(frame, {0, 0.06f, 0.1f}, {0.5f, 0.46f, 1.3f}, 0.012f);
    fronts(k, frame, metal, -0.24f, 0.24f, 0.1f, 0.5f, 0.75f, 1, 2);
    k.board(frame, {0, 0, 0.1f}, {0.42f, 0.06f, 1.2f}, 0.006f);
    k.board(frame, {0, 0.52f, 0.05f}, {0.64f, 0.06f, 1.86f}, 0.012f);
    k.soft(pad, {0, 0.58f, 0.34f}, {0.66f, 0.12f, 1.26f}, {0.04f, 0.012f, 0, 12});
    Mesh head = shapes::soft_box({0.66f, 0.12f, 0.66f}, {0.04f, 0.012f, 0, 10, k.seed()}),
         sheet = shapes::box({0.5f, 0.004f, 0.64f}, 0.001f),
         pillow = shapes::soft_box({0.46f, 0.1f, 0.26f}, {0.05f, 0.02f, 0.002f, 10, k.seed()});
    for (Mesh* m : {&head, &sheet, &pillow}) shapes::turn(*m, {1, 0, 0}, 32);
    k.add(std::move(head), pad, {0, 0.78f, -0.55f});
    k.add(std::move(sheet), paper, {0, 0.833f, -0.516f});
    k.add(std::move(pillow), paper, {0, 0.97f, -0.66f});
    k.board(paper, {0, 0.699f, 0.34f}, {0.5f, 0.004f, 1.24f}, 0.001f);
    k.board(paper, {0, 0.5f, 0.977f}, {0.5f, 0.2f, 0.004f}, 0.001f);
    k.rod(paper, {-0.25f, 0.72f, -0.93f}, {0.25f, 0.72f, -0.93f}, 0.06f, -1, 18);
    for (const float x : {-0.29f, 0.29f}) k.rod(metal, {x, 0.56f, -0.8f}, {x, 0.73f, -0.94f}, 0.01f, -1, 8);
    // A step beside its foot.
    k.board(metal, {0, 0.2f, 1.2f}, {0.42f, 0.03f, 0.28f}, 0.006f);
    for (const float x : {-0.18f, 0.18f})
        for (const float z : {1.09f, 1.31f}) k.rod(metal, {x, 0, z}, {x, 0.2f, z}, 0.013f, -1, 8);
    k.piece.against_wall = true;
    k.piece.clearance_front_m = 0.6f, k.piece.clearance_side_m = 0.6f;
}

// Black pads in three parts on a column, an arm rest beside; a trolley with ink, the machine and a lamp on an arm.
void build_tattoo_chair(Kit& k) {
    const int pad = k.main(plain("black vinyl", {0.02f, 0.02f, 0.021f}, 0.35f)), metal = k.material(steel()),
              dark = color(k, "black steel", {0.03f, 0.03f, 0.032f}, 0.4f),
              film = color(k, "cling film", {0.3f, 0.32f, 0.33f}, 0.12f),
              lamp = k.material(glow("lamp", {8, 7.8f, 7.2f}));
    k.add(shapes::prism(shapes::circle(0.32f, 32), 0, 0.03f), dark);
    k.rod(metal, {0, 0.03f, 0}, {0, 0.5f, 0}, 0.06f, -1, 18);
    k.board(dark, {0, 0.47f, 0}, {0.4f, 0.06f, 0.5f}, 0.01f);
    k.soft(pad, {0, 0.53f, 0.02f}, {0.6f, 0.11f, 0.58f}, {0.04f, 0.012f, 0.001f, 10});
    Mesh back = shapes::soft_box({0.58f, 0.11f, 0.82f}, {0.04f, 0.012f, 0.001f, 10, k.seed()}),
         legs_pad = shapes::soft_box({0.52f, 0.1f, 0.72f}, {0.04f, 0.012f, 0.001f, 10, k.seed()}),
         rest = shapes::soft_box({0.34f, 0.1f, 0.24f}, {0.04f, 0.012f, 0.001f, 8, k.seed()});
    shapes::turn(back, {1, 0, 0}, 24), shapes::turn(rest, {1, 0, 0}, 24), shapes::turn(legs_pad, {1, 0, 0}, 8);
    k.add(std::move(back), pad, {0, 0.76f, -0.63f});
    k.add(std::move(rest), pad, {0, 0.98f, -1.1f});
    k.add(std::move(legs_pad), pad, {0, 0.54f, 0.68f});
    // the arm rest, wrapped, on its own foot
    k.add(shapes::prism(shapes::circle(0.17f, 24), 0, 0.02f), dark, {0.52f, 0, -0.25f});
    k.rod(metal, {0.52f, 0.02f, -0.25f}, {0.52f, 0.74f, -0.25f}, 0.018f, -1, 12);
    k.soft(pad, {0.52f, 0.74f, -0.2f}, {0.2f, 0.08f, 0.56f}, {0.03f, 0.01f, 0.001f, 10});
    k.board(film, {0.52f, 0.77f, -0.2f}, {0.208f, 0.055f, 0.3f}, 0.012f);
    // the trolley
    const Vec3f t{-0.66f, 0, 0.05f};
    for (const float x : {-1.f, 1.f})
        for (const float z : {-1.f, 1.f})
            k.rod(metal, t + Vec3f{0.2f * x, 0.03f, 0.15f * z}, t + Vec3f{0.2f * x, 0.85f, 0.15f * z}, 0.011f, -1, 8);
    for (const float y : {0.3f, 0.58f, 0.84f}) k.board(metal, t + Vec3f{0, y, 0}, {0.44f, 0.015f, 0.34f}, 0.004f);
    static constexpr Vec3f kInks[]{
        {0.02f, 0.02f, 0.02f}, {0.35f, 0.03f, 0.03f}, {0.04f, 0.1f, 0.3f}, {0.05f, 0.22f, 0.1f}, {0.5f, 0.34f, 0.04f}};
    for (int i = 0; i < 10; ++i) {
        const Vec3f at = t + Vec3f{-0.16f + 0.05f * static_cast<float>(i % 5), 0.855f,
                                   -0.1f + 0.05f * static_cast<float>(i / 5)};
        k.rod(color(k, "ink", kInks[i % 5], 0.3f), at, at + Vec3f{0, 0.09f, 0}, 0.018f, 0.016f, 10);
        k.rod(dark, at + Vec3f{0, 0.09f, 0}, at + Vec3f{0, 0.115f, 0}, 0.012f, 0.006f, 8);
    }
    k.rod(metal, t + Vec3f{0.02f, 0.875f, 0.08f}, t + Vec3f{0.14f, 0.885f, 0.1f}, 0.016f, 0.008f, 10);
    k.board(dark, t + Vec3f{-0.12f, 0.855f, 0.09f}, {0.12f, 0.05f, 0.09f}, 0.006f);
    k.rod(metal, t + Vec3f{-0.2f, 0.85f, -0.15f}, t + Vec3f{-0.2f, 1.55f, -0.15f}, 0.014f, -1, 10);
    k.rod(metal, t + Vec3f{-0.2f, 1.55f, -0.15f}, {-0.25f, 1.62f, 0}, 0.012f, -1, 8);
    k.add(shapes::lathe(std::array<Vec2f, 3>{Vec2f{0.11f, 0}, {0.1f, 0.03f}, {0.03f, 0.09f}}, 24), dark,
          {-0.25f, 1.55f, 0});
    k.add(shapes::prism(shapes::circle(0.09f, 24), -0.004f, 0), lamp, {-0.25f, 1.55f, 0});
    k.piece.clearance_front_m = 0.6f, k.piece.clearance_side_m = 0.5f;
}

}  // namespace fastscene::furniture

// Of hospitals, dentists and hairdressers.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {

// A wheeled bed with rails, raised at the head.
void build_hospital_bed(Kit& k) {
    const int frame = color(k, "bed lacquer", {0.66f, 0.68f, 0.68f}, 0.35f),
              sheet = k.main(plain("sheet", {0.72f, 0.74f, 0.74f}, 0.9f)),
              blanket = color(k, "blanket", {0.2f, 0.38f, 0.45f}, 0.9f), metal = k.material(steel()),
              dark = color(k, "wheel", {0.03f, 0.03f, 0.03f}, 0.6f);
    // The head is at -z.
    k.board(frame, {0, 0.38f, 0}, {0.9f, 0.08f, 2.0f}, 0.02f),
        k.board(frame, {0, 0.22f, 0}, {0.6f, 0.06f, 1.5f}, 0.01f);
    for (const float sx : {-1.f, 1.f})
        for (const float z : {-0.85f, 0.85f}) {
            k.rod(metal, {sx * 0.36f, 0.12f, z}, {sx * 0.36f, 0.4f, z}, 0.022f);
            k.rod(dark, {sx * 0.36f - 0.02f, 0.065f, z}, {sx * 0.36f + 0.02f, 0.065f, z}, 0.065f, -1, 16);
        }
    k.board(frame, {0, 0.35f, -1.02f}, {0.94f, 0.62f, 0.05f}, 0.02f),
        k.board(frame, {0, 0.35f, 1.02f}, {0.94f, 0.42f, 0.05f}, 0.02f);
    k.soft(sheet, {0, 0.46f, 0.36f}, {0.86f, 0.15f, 1.28f}, {0.04f, 0.01f, 0.001f, 12});
    Mesh head = shapes::soft_box({0.86f, 0.15f, 0.76f}, {0.04f, 0.01f, 0.001f, 10, k.seed()});
    shapes::turn(head, {1, 0, 0}, 28);
    k.add(std::move(head), sheet, {0, 0.69f, -0.6f});
    Mesh pillow = shapes::soft_box({0.6f, 0.14f, 0.4f}, {0.06f, 0.03f, 0.002f, 10, k.seed()});
    shapes::turn(pillow, {1, 0, 0}, 28);
    k.add(std::move(pillow), sheet, {0, 0.88f, -0.72f});
    k.soft(blanket, {0, 0.57f, 0.42f}, {0.9f, 0.07f, 1.12f}, {0.03f, 0.01f, 0.004f, 12});
    for (const float sx : {-1.f, 1.f}) {
        for (const float y : {0.72f, 0.84f})
            k.rod(metal, {sx * 0.47f, y, -0.45f}, {sx * 0.47f, y, 0.5f}, 0.013f, -1, 8);
        for (const float z : {-0.4f, 0.05f, 0.45f})
            k.rod(metal, {sx * 0.47f, 0.42f, z}, {sx * 0.47f, 0.84f, z}, 0.012f, -1, 8);
    }
    k.top(0.63f, 0, 0.4f, 0.35f, 0.5f);
    k.piece.clearance_front_m = 0.7f, k.piece.clearance_side_m = 0.6f;
    k.piece.against_wall = true;
}

void build_iv_stand(Kit& k) {
    const int metal = k.main(steel()), dark = color(k, "castor", {0.03f, 0.03f, 0.03f}, 0.6f),
              bag = color(k, "infusion", {0.62f, 0.66f, 0.66f}, 0.15f),
              pump = color(k, "pump", {0.5f, 0.55f, 0.6f}, 0.4f);
    for (int i = 0; i < 5; ++i) {
        const Vec3f d = around(kTau * static_cast<float>(i) / 5);
        k.rod(metal, {0, 0.11f, 0}, d * 0.27f + Vec3f{0, 0.07f, 0}, 0.012f, -1, 8),
            k.add(shapes::ball(d * 0.27f + Vec3f{0, 0.035f, 0}, {0.03f, 0.035f, 0.03f}, 10), dark);
    }
    k.rod(metal, {0, 0.09f, 0}, {0, 1.95f, 0}, 0.013f, -1, 12),
        k.rod(metal, {-0.16f, 1.93f, 0}, {0.16f, 1.93f, 0}, 0.008f);
    for (const float sx : {-1.f, 1.f})
        k.board(bag, {sx * 0.14f, 1.58f, 0}, {0.12f, 0.28f, 0.035f}, 0.012f),
            k.rod(bag, {sx * 0.14f, 1.58f, 0}, {sx * 0.03f, 1.15f, 0.05f}, 0.004f, -1, 6);
    k.board(pump, {0, 1.0f, 0.06f}, {0.14f, 0.2f, 0.1f}, 0.012f);
}

// A screen with curves on an arm with wheels: what watches over who sleeps there.
void build_patient_monitor(Kit& k) {
    const int body = k.main(plain("device", {0.62f, 0.63f, 0.62f}, 0.4f)), metal = k.material(steel()),
              dark = color(k, "bezel", {0.03f, 0.03f, 0.03f}, 0.3f),
              green = k.material(flame("trace", {0.2f, 3.f, 0.5f})),
              red = k.material(flame("trace", {3.f, 0.3f, 0.2f}));
    for (const int led : {green, red}) {
        Material& m = k.piece.materials[static_cast<std::size_t>(led)];
        m.burns = false, m.pattern = Pattern::screen;
    }
    k.board(metal, {0, 0.05f, 0}, {0.5f, 0.03f, 0.42f}, 0.01f), k.rod(metal, {0, 0.06f, 0}, {0, 1.1f, 0}, 0.025f),
        k.board(body, {0, 0.62f, 0}, {0.42f, 0.03f, 0.34f}, 0.01f),
        k.board(body, {0, 0.65f, 0}, {0.34f, 0.14f, 0.26f}, 0.02f);
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f})
            k.add(shapes::ball({sx * 0.22f, 0.03f, sz * 0.18f}, {0.03f, 0.03f, 0.03f}, 10), dark);
    k.board(body, {0, 1.08f, 0}, {0.42f, 0.34f, 0.14f}, 0.03f),
        k.board(dark, {0, 1.12f, 0.07f}, {0.36f, 0.26f, 0.006f}, 0.002f);
    for (int t = 0; t < 3; ++t)
        for (int i = 0; i < 16; ++i) {
            const float x = -0.16f + 0.32f * static_cast<float>(i) / 15, h = i % 5 == 2   ? 0.045f
                                                                             : i % 5 == 3 ? -0.01f
                                                                                          : 0.f;
            block(k, t == 1 ? red : green, {x, 1.16f + 0.075f * static_cast<float>(t) + std::min(h, 0.f), 0.077f},
                  {0.021f, 0.005f + std::fabs(h), 0.002f});
        }
    k.piece.clearance_front_m = 0.3f;
}

void build_dentist_chair(Kit& k) {
    const int pad = k.main(plain("dental vinyl", {0.06f, 0.32f, 0.36f}, 0.4f)),
              body = color(k, "unit", {0.7f, 0.71f, 0.71f}, 0.3f), metal = k.material(steel()),
              lamp = k.material(glow("operating light", {9, 9, 8.6f}));
    k.board(body, {0, 0, 0.1f}, {0.6f, 0.09f, 0.9f}, 0.04f),
        k.board(body, {0, 0.09f, 0.05f}, {0.26f, 0.34f, 0.32f}, 0.05f);
    k.soft(pad, {0, 0.42f, 0.1f}, {0.56f, 0.13f, 0.56f}, {0.05f, 0.015f, 0, 10});
    Mesh back = shapes::soft_box({0.54f, 0.86f, 0.12f}, {0.05f, 0.015f, 0, 10, k.seed()}),
         legs_pad = shapes::soft_box({0.48f, 0.12f, 0.8f}, {0.05f, 0.015f, 0, 10, k.seed()}),
         rest = shapes::soft_box({0.26f, 0.22f, 0.1f}, {0.04f, 0.015f, 0, 8, k.seed()});
    shapes::turn(back, {1, 0, 0}, -52), shapes::turn(rest, {1, 0, 0}, -52), shapes::turn(legs_pad, {1, 0, 0}, 14);
    k.add(std::move(back), pad, {0, 0.78f, -0.5f}), k.add(std::move(rest), pad, {0, 1.1f, -0.92f}),
        k.add(std::move(legs_pad), pad, {0, 0.42f, 0.72f});
    for (const float sx : {-1.f, 1.f})
        k.board(body, {sx * 0.34f, 0.62f, 0.0f}, {0.07f, 0.04f, 0.4f}, 0.015f),
            k.rod(metal, {sx * 0.34f, 0.45f, 0}, {sx * 0.34f, 0.63f, 0}, 0.016f);
    // The dentist's unit with its arms: instruments, a spittoon, the lamp.
    k.board(body, {-0.62f, 0, -0.25f}, {0.32f, 0.95f, 0.4f}, 0.05f),
        k.add(shapes::ball({-0.62f, 0.97f, -0.1f}, {0.13f, 0.06f, 0.13f}, 18), k.material(porcelain()));
    k.rod(metal, {-0.62f, 0.9f, -0.35f}, {-0.62f, 1.9f, -0.35f}, 0.025f);
    k.rod(metal, {-0.62f, 1.88f, -0.35f}, {0.0f, 1.8f, 0.02f}, 0.02f),
        k.board(body, {0, 1.68f, 0.06f}, {0.36f, 0.1f, 0.2f}, 0.04f),
        k.board(lamp, {0, 1.675f, 0.06f}, {0.28f, 0.01f, 0.13f}, 0.003f);
    k.rod(metal, {-0.62f, 1.0f, -0.35f}, {-0.3f, 0.98f, 0.45f}, 0.018f),
        k.board(body, {-0.18f, 0.95f, 0.5f}, {0.5f, 0.04f, 0.26f}, 0.015f);
    for (int i = 0; i < 4; ++i)
        k.rod(i % 2 ? metal : body, {-0.34f + 0.1f * static_cast<float>(i), 1.0f, 0.55f},
              {-0.34f + 0.1f * static_cast<float>(i), 1.01f, 0.38f}, 0.011f, 0.007f, 8);
    k.piece.clearance_front_m = 0.6f, k.piece.clearance_side_m = 0.6f;
}

void build_operating_table(Kit& k) {
    const int pad = k.main(plain("pad", {0.03f, 0.035f, 0.04f}, 0.4f)), metal = k.material(steel()),
              cloth = color(k, "surgical drape", {0.05f, 0.3f, 0.27f}, 0.9f),
              body = color(k, "lamp housing", {0.7f, 0.71f, 0.71f}, 0.3f),
              lamp = k.material(glow("operating light", {9, 9, 8.8f}));
    k.board(metal, {0, 0, 0}, {0.6f, 0.12f, 1.0f}, 0.03f), k.board(metal, {0, 0.12f, 0}, {0.3f, 0.64f, 0.4f}, 0.03f);
    k.board(metal, {0, 0.76f, 0}, {0.56f, 0.05f, 2.0f}, 0.01f),
        k.soft(pad, {0, 0.8f, 0}, {0.52f, 0.09f, 1.96f}, {0.03f, 0.005f, 0, 10}),
        k.soft(cloth, {0, 0.87f, 0.15f}, {0.62f, 0.05f, 1.4f}, {0.02f, 0.01f, 0.004f, 10});
    // The light stands on an arm of its own.
    k.rod(metal, {0.62f, 0, -0.8f}, {0.62f, 2.1f, -0.8f}, 0.03f),
        k.board(metal, {0.62f, 0, -0.8f}, {0.4f, 0.05f, 0.4f}, 0.02f),
        k.rod(metal, {0.62f, 2.08f, -0.8f}, {0.05f, 2.0f, 0}, 0.022f);
    const std::array<Vec2f, 4> dome{Vec2f{0.34f, 0}, {0.33f, 0.06f}, {0.2f, 0.12f}, {0.03f, 0.14f}};
    k.add(shapes::lathe(dome, 28, true), body, {0.05f, 1.82f, 0});
    for (int i = 0; i < 7; ++i) {
        const Vec3f d = i == 6 ? Vec3f{} : around(kTau * static_cast<float>(i) / 6) * 0.21f;
        k.add(shapes::prism(shapes::circle(0.075f, 16), 0, 0.012f, 0.002f), lamp, Vec3f{0.05f, 1.81f, 0} + d);
    }
    k.piece.clearance_front_m = 0.8f, k.piece.clearance_side_m = 0.8f;
}

// A padded chair on a round foot, before its own mirror when a recipe puts one there.
void build_salon_chair(Kit& k) {
    const int leather = k.main(plain("salon vinyl", {0.03f, 0.03f, 0.032f}, 0.35f)), metal = k.material(steel());
    k.add(shapes::prism(shapes::circle(0.3f, 32), 0, 0.03f, 0.008f), metal),
        k.rod(metal, {0, 0.02f, 0}, {0, 0.45f, 0}, 0.05f, -1, 16);
    k.soft(leather, {0, 0.42f, 0.02f}, {0.56f, 0.14f, 0.54f}, {0.05f, 0.015f, 0.001f, 10});
    Mesh back = shapes::soft_box({0.56f, 0.5f, 0.12f}, {0.05f, 0.02f, 0.001f, 10, k.seed()}),
         rest = shapes::soft_box({0.3f, 0.18f, 0.1f}, {0.04f, 0.015f, 0, 8, k.seed()});
    shapes::turn(back, {1, 0, 0}, -10), shapes::turn(rest, {1, 0, 0}, -10);
    k.add(std::move(back), leather, {0, 0.76f, -0.27f}), k.add(std::move(rest), leather, {0, 1.1f, -0.33f});
    for (const float sx : {-1.f, 1.f}) {
        const std::array<Vec3f, 4> arm{Vec3f{sx * 0.3f, 0.5f, -0.2f},
                                       {sx * 0.33f, 0.68f, -0.15f},
                                       {sx * 0.33f, 0.7f, 0.15f},
                                       {sx * 0.3f, 0.5f, 0.22f}};
        k.add(shapes::tube(arm, 0.018f), metal), k.board(leather, {sx * 0.33f, 0.69f, 0}, {0.07f, 0.04f, 0.3f}, 0.015f);
    }
    k.rod(metal, {-0.2f, 0.22f, 0.36f}, {0.2f, 0.22f, 0.36f}, 0.014f),
        k.rod(metal, {0, 0.3f, 0.1f}, {0, 0.22f, 0.36f}, 0.016f);
    k.piece.clearance_front_m = 0.5f;
}

// A mirror with lights above a shelf with brushes and bottles, at the wall.
void build_salon_station(Kit& k) {
    const Vec3f s = k.wanted({1.1f, 2.0f, 0.36f});
    const int wood = k.main(k.style.wood), bulb = k.material(glow("bulb", {7, 5.8f, 4.2f})),
              metal = k.material(k.style.metal);
    Material mirror = plain("mirror", {0.8f, 0.8f, 0.8f}, 0.05f);
    mirror.mirror = 1;
    k.board(wood, {0, 0.78f, 0}, {s.x, 0.05f, s.z}, 0.008f),
        k.board(wood, {0, 0, -0.04f}, {0.5f, 0.78f, s.z - 0.1f}, 0.008f),
        fronts(k, wood, metal, -0.24f, 0.24f, 0.06f, 0.74f, 0.5f * s.z - 0.09f, 1, 3);
    k.board(wood, {0, 0.83f, -0.5f * s.z + 0.02f}, {s.x - 0.1f, s.y - 0.83f, 0.04f}, 0.008f),
        k.board(k.material(mirror), {0, 0.92f, -0.5f * s.z + 0.042f}, {s.x - 0.34f, s.y - 1.02f, 0.004f}, 0.001f);
    for (const float sx : {-1.f, 1.f})
        for (int i = 0; i < 5; ++i)
            k.add(shapes::ball({sx * (0.5f * s.x - 0.11f), 1.02f + 0.2f * static_cast<float>(i), -0.5f * s.z + 0.07f},
                               {0.04f, 0.04f, 0.04f}, 14),
                  bulb);
    stock(k, Goods::bottles, -0.5f * s.x + 0.05f, -0.12f, 0.83f, 0.24f, 0.5f * s.z - 0.05f, 0.15f);
    k.top(0.83f, 0.25f, 0.05f, 0.2f, 0.1f);
    k.piece.against_wall = true, k.piece.clearance_front_m = 1.2f;
}

// A basin to lean the head back into, with its chair.
void build_shampoo_basin(Kit& k) {
    const int leather = k.main(plain("salon vinyl", {0.03f, 0.03f, 0.032f}, 0.35f)), white = k.material(porcelain()),
              metal = k.material(steel()), body = color(k, "pedestal", {0.06f, 0.06f, 0.06f}, 0.4f);
    k.board(body, {0, 0, -0.5f}, {0.46f, 0.82f, 0.3f}, 0.03f);
    const std::array<Vec2f, 3> basin{Vec2f{0.1f, 0}, {0.24f, 0.08f}, {0.27f, 0.17f}};
    k.add(shapes::vessel(basin, 0.018f, 24), white, {0, 0.8f, -0.42f});
    const std::array<Vec3f, 4> tap{
        Vec3f{0.16f, 0.9f, -0.62f}, {0.16f, 1.12f, -0.62f}, {0.1f, 1.14f, -0.54f}, {0.06f, 1.06f, -0.48f}};
    k.add(shapes::tube(tap, 0.014f), metal), k.board(body, {0, 0, 0.2f}, {0.4f, 0.32f, 0.5f}, 0.03f),
        k.soft(leather, {0, 0.32f, 0.24f}, {0.58f, 0.14f, 0.6f}, {0.05f, 0.015f, 0.001f, 10});
    Mesh back = shapes::soft_box({0.54f, 0.56f, 0.12f}, {0.05f, 0.02f, 0.001f, 10, k.seed()});
    shapes::turn(back, {1, 0, 0}, -24);
    k.add(std::move(back), leather, {0, 0.68f, -0.13f});
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.6f;
}

// Four seats side by side on one beam.
void build_waiting_chairs(Kit& k) {
    const Vec3f s = k.wanted({2.2f, 0.82f, 0.6f});
    const int seat = k.main(plain("seat shell", k.accent(), 0.4f)), metal = k.material(steel());
    const int count = std::max(2, static_cast<int>(s.x / 0.54f));
    const float w = s.x / static_cast<float>(count);
    k.board(metal, {0, 0.34f, -0.02f}, {s.x - 0.1f, 0.06f, 0.08f}, 0.008f);
    for (const float sx : {-1.f, 1.f})
        k.board(metal, {sx * (0.5f * s.x - 0.35f), 0.03f, -0.02f}, {0.06f, 0.32f, 0.06f}, 0.008f),
            k.board(metal, {sx * (0.5f * s.x - 0.35f), 0, -0.02f}, {0.07f, 0.035f, 0.56f}, 0.01f);
    for (int i = 0; i < count; ++i) {
        const float x = -0.5f * s.x + w * (static_cast<float>(i) + 0.5f);
        k.add(shapes::prism(shapes::rounded_rectangle(w - 0.06f, 0.46f, 0.08f), 0.4f, 0.44f, 0.012f), seat,
              {x, 0, 0.03f});
        k.add(shapes::slab(8, 6, 0.02f,
                           [&](float u, float v) {
                               return Vec3f{x + (w - 0.06f) * (u - 0.5f), 0.45f + 0.37f * v,
                                            -0.19f - 0.09f * v + 0.03f * (4.f * (u - 0.5f) * (u - 0.5f))};
                           }),
              seat);
    }
    k.top(0.44f, 0, 0.03f, 0.4f * s.x, 0.18f);
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.7f;
}

void build_massage_table(Kit& k) {
    const int pad = k.main(plain("massage vinyl", {0.5f, 0.42f, 0.32f}, 0.5f)), wood = k.material(k.style.wood),
              towel = color(k, "towel", {0.72f, 0.7f, 0.66f}, 0.95f);
    k.board(wood, {0, 0.1f, 0}, {0.6f, 0.5f, 1.7f}, 0.01f), k.board(wood, {0, 0.6f, 0}, {0.72f, 0.06f, 1.9f}, 0.01f),
        k.soft(pad, {0, 0.65f, 0}, {0.74f, 0.11f, 1.92f}, {0.04f, 0.01f, 0.001f, 12}),
        k.soft(towel, {0, 0.745f, 0.25f}, {0.78f, 0.03f, 1.1f}, {0.012f, 0.004f, 0.003f, 10});
    Mesh roll = shapes::rod({-0.22f, 0.8f, -0.7f}, {0.22f, 0.8f, -0.7f}, 0.06f, 0.06f, 18);
    k.add(std::move(roll), towel);
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f}) k.board(wood, {sx * 0.3f, 0, sz * 0.8f}, {0.07f, 0.1f, 0.07f}, 0.006f);
    k.piece.clearance_front_m = 0.6f, k.piece.clearance_side_m = 0.6f;
}

}  // namespace fastscene::furniture

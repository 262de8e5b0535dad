// Small things that make a room lived in: what stands about on tables, counters, shelves and floors.
#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/rooms/furniture_kit.h"

namespace fastscene::furniture {
namespace {

int glazed(Kit& k) {
    return k.main(plain("glazed ceramic", lerp(k.accent(), {0.75f, 0.72f, 0.66f}, k.dice.uniform(0.f, 0.6f)), 0.25f));
}
void on_surface(Kit& k) { k.piece.mount = Mount::surface; }

void cup_at(Kit& k, int mat, Vec3f at, float r = 0.04f, float h = 0.085f) {
    const std::array<Vec2f, 4> p{Vec2f{0.6f * r, 0}, {0.85f * r, 0.2f * h}, {r, 0.6f * h}, {0.98f * r, h}};
    Mesh m = shapes::vessel(p, 0.004f, 18);
    k.add(std::move(m), mat, at);
    std::vector<Vec3f> handle;
    for (int i = 0; i <= 6; ++i) {
        const float a = -1.4f + 2.8f * static_cast<float>(i) / 6.f;
        handle.push_back({0.88f * r + 0.45f * r * std::cos(a), 0.5f * h + 0.3f * h * std::sin(a), 0});
    }
    k.add(shapes::tube(handle, 0.005f, 6), mat, at);
}
void plate_at(Kit& k, int mat, Vec3f at, float r) {
    const std::array<Vec2f, 6> p{Vec2f{0.f, 0}, {0.6f * r, 0.f},     {0.65f * r, 0.006f},
                                 {r, 0.017f},   {0.985f * r, 0.02f}, {0.62f * r, 0.009f}};
    k.add(shapes::lathe(p, 28), mat, at);
}
void bottle_at(Kit& k, int mat, Vec3f at, float r, float h) {
    const std::array<Vec2f, 8> p{Vec2f{0.9f * r, 0},      {r, 0.01f},
                                 {r, 0.55f * h},          {0.85f * r, 0.66f * h},
                                 {0.36f * r, 0.78f * h},  {0.34f * r, 0.96f * h},
                                 {0.42f * r, 0.965f * h}, {0.42f * r, h}};
    k.add(shapes::lathe(p, 20), mat, at);
}

void cup(Kit& k) {
    const int mat = glazed(k);
    if (k.dice.chance(0.5f)) plate_at(k, mat, {}, 0.07f);
    cup_at(k, mat, {0, 0.008f, 0});
    on_surface(k);
}
// A tray with a pot and cups, or bottles and glasses.
void tray(Kit& k) {
    const int wood = k.main(k.style.wood2),
              china = k.material(plain("porcelain", lerp(k.accent(), {0.78f, 0.76f, 0.7f}, 0.6f), 0.2f));
    const float w = 0.38f, d = 0.27f;
    k.board(wood, {}, {w, 0.012f, d}, 0.004f);
    for (const float s : {-1.f, 1.f}) {
        k.board(wood, {0, 0.01f, s * (0.5f * d - 0.006f)}, {w, 0.025f, 0.012f}, 0.004f);
        k.board(wood, {s * (0.5f * w - 0.006f), 0.01f, 0}, {0.012f, 0.04f, d - 0.024f}, 0.004f);
    }
    if (k.dice.chance(0.5f)) {
        const std::array<Vec2f, 7> pot{Vec2f{0.045f, 0}, {0.065f, 0.02f},  {0.072f, 0.06f}, {0.055f, 0.1f},
                                       {0.03f, 0.115f},  {0.012f, 0.125f}, {0.012f, 0.14f}};
        k.add(shapes::lathe(shapes::curve(pot, 3), 24, true), china, {-0.07f, 0.012f, 0});
        k.rod(china, {-0.14f, 0.09f, 0}, {-0.17f, 0.125f, 0}, 0.009f, 0.006f);
        cup_at(k, china, {0.06f, 0.012f, 0.05f}, 0.036f, 0.055f);
        cup_at(k, china, {0.11f, 0.012f, -0.05f}, 0.036f, 0.055f);
    } else {
        Material green = glass();
        green.color_a = {0.12f, 0.25f, 0.12f};
        green.transmission = 0.4f;
        bottle_at(k, k.material(green), {-0.1f, 0.012f, 0.02f}, 0.037f, 0.28f);
        const int clear = k.material(glass());
        for (int i = 0; i < 2; ++i) {
            const std::array<Vec2f, 2> p{Vec2f{0.03f, 0}, {0.036f, 0.09f}};
            k.add(shapes::vessel(p, 0.003f, 18), clear,
                  {0.04f + 0.08f * static_cast<float>(i), 0.012f, i == 0 ? 0.05f : -0.04f});
        }
    }
    on_surface(k);
}
// A plate on a mat with cutlery and a glass: what the table is laid with.
void place_setting(Kit& k) {
    Material linen = tinted(k.style.fabric2, lerp(k.accent(), {0.7f, 0.67f, 0.6f}, 0.4f));
    const int mat = k.main(linen), china = k.material(porcelain()), metal = k.material(steel());
    k.board(mat, {}, {0.42f, 0.004f, 0.3f}, 0.001f);
    plate_at(k, china, {0, 0.004f, 0}, 0.13f);
    plate_at(k, china, {0, 0.013f, 0}, 0.09f);
    for (const float x : {-0.165f, 0.16f, 0.185f}) k.board(metal, {x, 0.004f, 0}, {0.014f, 0.004f, 0.19f}, 0.001f);
    const std::array<Vec2f, 2> p{Vec2f{0.028f, 0}, {0.034f, 0.1f}};
    k.add(shapes::vessel(p, 0.003f, 18), k.material(glass()), {0.15f, 0.004f, -0.105f});
    on_surface(k);
}
void bottles(Kit& k) {
    const int count = 2 + k.dice.index(3);
    for (int i = 0; i < count; ++i) {
        Material m = k.dice.chance(0.5f) ? glass() : plain("stoneware", k.accent(), 0.35f);
        if (m.transmission > 0)
            m.color_a = m.color_b = lerp(k.accent(), {0.3f, 0.4f, 0.3f}, 0.5f), m.transmission = 0.5f;
        const int mat = i == 0 ? k.main(m) : k.material(m);
        bottle_at(k, mat, {0.085f * static_cast<float>(i), 0, k.dice.uniform(-0.03f, 0.03f)},
                  k.dice.uniform(0.028f, 0.038f), k.dice.uniform(0.18f, 0.31f));
    }
    on_surface(k);
}
void photo_frame(Kit& k) {
    const int frame = k.main(k.dice.chance(0.5f) ? k.style.metal : k.style.wood);
    Material m = plain("photograph", {0.5f, 0.47f, 0.42f}, 0.25f);
    m.pattern = Pattern::art;
    m.color_a = k.accent(), m.color_b = k.accent(), m.color_c = {0.7f, 0.67f, 0.6f};
    m.scale_m = 0.15f;
    m.seed = k.seed();
    const int photo = k.material(m);
    const float w = k.dice.uniform(0.12f, 0.2f), h = w * k.dice.uniform(0.8f, 1.35f);
    Mesh back = shapes::box({w, h, 0.014f}, 0.004f), face = shapes::box({w - 0.035f, h - 0.035f, 0.003f}, 0.0005f);
    shapes::move(back, {0, 0.5f * h, 0});
    shapes::move(face, {0, 0.5f * h, 0.008f});
    face.coords = face.positions;
    for (Vec3f& c : face.coords) c.y -= 0.5f * h;
    for (Mesh* part : {&back, &face}) shapes::turn(*part, {1, 0, 0}, -10);
    k.add(back, frame);
    k.add(face, photo);
    k.board(frame, {0, 0, -0.05f}, {0.03f, 0.004f, 0.1f}, 0.001f);
    on_surface(k);
}
void sculpture(Kit& k) {
    const int kind = k.dice.index(3);
    Material stone = *material_named("marble");
    if (kind != 0)
        stone = kind == 1 ? k.style.metal : plain("plaster", lerp(k.accent(), {0.74f, 0.72f, 0.68f}, 0.7f), 0.7f);
    const int mat = k.main(stone);
    k.board(mat, {}, {0.11f, 0.03f, 0.11f}, 0.004f);
    if (kind == 0) {
        const std::array<Vec2f, 9> p{Vec2f{0.03f, 0.03f}, {0.05f, 0.06f},  {0.07f, 0.12f},
                                     {0.04f, 0.17f},      {0.03f, 0.19f},  {0.055f, 0.23f},
                                     {0.06f, 0.27f},      {0.04f, 0.315f}, {0.f, 0.33f}};
        k.add(shapes::lathe(shapes::curve(p, 3), 24, true), mat);
    } else if (kind == 1) {
        Mesh ring = shapes::ring(0.1f, 0.017f, 36);
        shapes::turn(ring, {1, 0, 0}, 90);
        k.add(std::move(ring), mat, {0, 0.145f, 0});
    } else {
        k.add(shapes::ball({0, 0.08f, 0}, {0.075f, 0.055f, 0.07f}), mat);
        k.add(shapes::ball({0.01f, 0.165f, 0}, {0.055f, 0.045f, 0.05f}), mat);
        k.add(shapes::ball({0, 0.235f, 0}, {0.035f, 0.03f, 0.035f}), mat);
    }
    on_surface(k);
}
void globe(Kit& k) {
    const int metal = k.main(k.style.metal);
    Material sea = plain("globe", {0.2f, 0.36f, 0.45f}, 0.35f);
    sea.pattern = Pattern::marble;
    sea.color_b = {0.55f, 0.47f, 0.25f};
    sea.scale_m = 0.15f;
    const std::array<Vec2f, 4> foot{Vec2f{0.075f, 0}, {0.07f, 0.014f}, {0.015f, 0.03f}, {0.012f, 0.09f}};
    k.add(shapes::lathe(foot, 24), metal);
    k.add(shapes::ball({0, 0.22f, 0}, {0.11f, 0.11f, 0.11f}, 24), k.material(sea));
    Mesh ring = shapes::ring(0.122f, 0.005f, 32);
    shapes::turn(ring, {1, 0, 0}, 90);
    shapes::turn(ring, {0, 0, 1}, 20);
    k.add(std::move(ring), metal, {0, 0.22f, 0});
    on_surface(k);
}
void laptop(Kit& k) {
    const int alu = k.main(plain("aluminium", {0.5f, 0.51f, 0.52f}, 0.35f)),
              dark = k.material(plain("dark plastic", {0.04f, 0.04f, 0.043f}, 0.4f));
    k.board(alu, {}, {0.32f, 0.014f, 0.22f}, 0.004f);
    if (k.dice.chance(0.4f)) return k.board(alu, {0, 0.014f, 0}, {0.32f, 0.008f, 0.22f}, 0.003f), on_surface(k);
    k.board(dark, {0, 0.0135f, -0.02f}, {0.28f, 0.002f, 0.1f}, 0.0005f);
    Mesh lid = shapes::box({0.32f, 0.21f, 0.007f}, 0.003f), face = shapes::box({0.3f, 0.19f, 0.002f}, 0.0005f);
    Material scr = plain("laptop screen", {0.1f, 0.16f, 0.24f}, 0.2f);
    scr.pattern = Pattern::screen;
    scr.emission = {0.4f, 0.6f, 0.85f};
    shapes::move(face, {0, 0, 0.004f});
    for (Mesh* m : {&lid, &face}) shapes::move(shapes::turn(*m, {1, 0, 0}, -18), {0, 0.112f, -0.14f});
    k.add(lid, alu);
    k.add(face, k.material(scr));
    on_surface(k);
}
void towel_stack(Kit& k) {
    Material m = k.style.fabric;
    m.pattern = Pattern::knit;
    m.scale_m = 0.008f;
    m.bump_m = 0.002f;
    const int first = k.main(tinted(m, lerp(k.accent(), {0.76f, 0.74f, 0.7f}, 0.5f))),
              second = k.material(tinted(m, {0.76f, 0.74f, 0.7f}));
    const int count = 2 + k.dice.index(3);
    for (int i = 0; i < count; ++i)
        k.soft(i % 2 == 0 ? first : second, {0, 0.058f * static_cast<float>(i), 0},
               {0.34f - 0.01f * static_cast<float>(i), 0.062f, 0.24f}, {0.024f, 0.01f, 0.002f, 10});
    on_surface(k);
}
void toiletries(Kit& k) {
    const int first = glazed(k), white = k.material(porcelain()), metal = k.material(k.style.metal);
    bottle_at(k, first, {-0.07f, 0, 0}, 0.03f, 0.16f);
    k.rod(metal, {-0.07f, 0.155f, 0}, {-0.07f, 0.19f, 0}, 0.006f);
    k.rod(metal, {-0.07f, 0.188f, 0}, {-0.07f, 0.183f, 0.04f}, 0.006f, 0.004f);
    const std::array<Vec2f, 2> cup{Vec2f{0.03f, 0}, {0.034f, 0.1f}};
    k.add(shapes::vessel(cup, 0.004f, 18), white, {0.02f, 0, -0.01f});
    k.rod(metal, {0.02f, 0.01f, -0.01f}, {0.045f, 0.18f, 0.01f}, 0.004f);
    k.rod(first, {0.015f, 0.01f, -0.01f}, {-0.015f, 0.175f, -0.02f}, 0.004f);
    k.add(shapes::prism(shapes::circle(0.035f), 0, 0.03f, 0.008f), k.material(plain("soap", {0.7f, 0.62f, 0.5f}, 0.5f)),
          {0.1f, 0, 0.01f});
    on_surface(k);
}
void kettle(Kit& k) {
    const int body = k.main(k.dice.chance(0.5f) ? steel() : plain("enamel", k.accent(), 0.2f)),
              dark = k.material(plain("black plastic", {0.035f, 0.035f, 0.037f}, 0.4f));
    const std::array<Vec2f, 7> p{Vec2f{0.08f, 0}, {0.092f, 0.015f}, {0.09f, 0.07f}, {0.068f, 0.15f},
                                 {0.05f, 0.175f}, {0.014f, 0.185f}, {0.f, 0.2f}};
    k.add(shapes::lathe(shapes::curve(p, 3), 26, true), body);
    k.rod(body, {-0.06f, 0.09f, 0}, {-0.125f, 0.15f, 0}, 0.018f, 0.01f);
    std::vector<Vec3f> handle;
    for (int i = 0; i <= 8; ++i) {
        const float a = 1.5f - 3.f * static_cast<float>(i) / 8.f;
        handle.push_back({0.065f + 0.06f * std::cos(a), 0.11f + 0.07f * std::sin(a), 0});
    }
    k.add(shapes::tube(handle, 0.01f, 8), dark);
    on_surface(k);
}
void toaster(Kit& k) {
    const int body = k.main(k.dice.chance(0.5f) ? steel() : plain("enamel", k.accent(), 0.25f)),
              dark = k.material(plain("black plastic", {0.035f, 0.035f, 0.037f}, 0.4f));
    k.board(dark, {}, {0.27f, 0.02f, 0.16f}, 0.005f);
    k.board(body, {0, 0.018f, 0}, {0.28f, 0.17f, 0.17f}, 0.035f);
    for (const float z : {-0.035f, 0.035f}) k.board(dark, {0, 0.1885f, z}, {0.19f, 0.001f, 0.024f}, 0.0003f);
    k.board(dark, {0.142f, 0.11f, 0}, {0.014f, 0.02f, 0.04f}, 0.004f);
    on_surface(k);
}
// A jar with spoons, a board that leans behind it.
void utensils(Kit& k) {
    const int jar = glazed(k), wood = k.material(k.style.wood2), metal = k.material(steel());
    const std::array<Vec2f, 4> p{Vec2f{0.05f, 0}, {0.058f, 0.02f}, {0.058f, 0.12f}, {0.052f, 0.15f}};
    k.add(shapes::vessel(p, 0.005f, 20), jar);
    for (int i = 0; i < 5; ++i) {
        const float a = 1.3f * static_cast<float>(i);
        const Vec3f tip{0.07f * std::cos(a), k.dice.uniform(0.24f, 0.3f), 0.05f * std::sin(a)};
        k.rod(i % 2 ? metal : wood, {0.02f * std::cos(a), 0.01f, 0.02f * std::sin(a)}, tip, 0.005f);
        k.add(shapes::ball(tip, {0.02f, 0.03f, 0.008f}, 10), i % 2 ? metal : wood);
    }
    Mesh board = shapes::box({0.22f, 0.32f, 0.018f}, 0.008f);
    shapes::lay_grain(board);
    shapes::turn(board, {1, 0, 0}, -9);
    k.add(std::move(board), wood, {0.16f, 0.163f, -0.035f});
    on_surface(k);
}
// A jar of pencils and brushes, and what lies before it: pens alone nobody would see from across the room.
void pens(Kit& k) {
    const int jar = glazed(k), wood = k.material(k.style.wood2);
    const std::array<Vec2f, 4> p{Vec2f{0.046f, 0}, {0.052f, 0.01f}, {0.052f, 0.1f}, {0.048f, 0.115f}};
    Mesh vessel = shapes::vessel(p, 0.004f, 20);
    k.add(std::move(vessel), jar, {-0.05f, 0, -0.03f});
    for (int i = 0; i < 8; ++i) {
        const float a = 0.8f * static_cast<float>(i);
        const Vec3f foot{-0.05f + 0.025f * std::cos(a), 0.01f, -0.03f + 0.025f * std::sin(a)},
            tip{-0.05f + 0.06f * std::cos(a), k.dice.uniform(0.17f, 0.24f), -0.03f + 0.05f * std::sin(a)};
        const int paint = k.material(plain("paint", k.accent(), 0.4f));
        k.rod(i % 2 ? wood : paint, foot, tip, 0.004f);
        k.add(shapes::ball(tip, {0.008f, 0.018f, 0.008f}, 8), paint);
    }
    for (int i = 0; i < 3; ++i) {
        const float z = 0.045f + 0.022f * static_cast<float>(i), x = k.dice.uniform(-0.01f, 0.03f);
        k.rod(k.material(plain("paint", k.accent(), 0.4f)), {x - 0.07f, 0.009f, z}, {x + 0.06f, 0.009f, z + 0.01f},
              0.009f, 0.007f);
    }
    on_surface(k);
}
void cutting_board(Kit& k) {
    const int wood = k.main(k.style.wood2);
    k.board(wood, {}, {0.34f, 0.022f, 0.22f}, 0.006f);
    const int loaf = k.material(plain("bread", {0.42f, 0.24f, 0.1f}, 0.8f));
    k.soft(loaf, {-0.04f, 0.018f, 0}, {0.2f, 0.09f, 0.1f}, {0.04f, 0.015f, 0.004f, 10});
    k.board(k.material(steel()), {0.1f, 0.022f, 0}, {0.02f, 0.003f, 0.14f}, 0.001f);
    on_surface(k);
}
void pot(Kit& k) {
    const int body = k.main(k.dice.chance(0.5f) ? steel() : plain("enamel", k.accent(), 0.25f));
    const std::array<Vec2f, 3> p{Vec2f{0.1f, 0}, {0.108f, 0.01f}, {0.108f, 0.12f}};
    k.add(shapes::vessel(p, 0.004f, 28), body);
    const std::array<Vec2f, 4> lid{Vec2f{0.108f, 0.12f}, {0.1f, 0.128f}, {0.03f, 0.14f}, {0.f, 0.142f}};
    k.add(shapes::lathe(lid, 28), body);
    k.add(shapes::ball({0, 0.152f, 0}, {0.018f, 0.014f, 0.018f}, 12), body);
    for (const float s : {-1.f, 1.f}) k.board(body, {s * 0.125f, 0.09f, 0}, {0.035f, 0.012f, 0.06f}, 0.004f);
    on_surface(k);
}
void magazines(Kit& k) {
    const int count = 2 + k.dice.index(3);
    for (int i = 0; i < count; ++i) {
        Material m = plain("magazine", lerp(k.accent(), {0.7f, 0.68f, 0.62f}, k.dice.uniform(0.f, 0.5f)), 0.35f);
        m.pattern = Pattern::art;
        m.color_b = k.accent();
        m.color_c = {0.75f, 0.73f, 0.68f};
        m.scale_m = 0.2f;
        m.seed = k.seed();
        const int mat = i == 0 ? k.main(m) : k.material(m);
        Mesh sheet = shapes::box({0.21f, 0.008f, 0.28f}, 0.001f);
        for (Vec3f& c : sheet.coords) c = {c.x, c.z, c.y};
        shapes::turn(sheet, {0, 1, 0}, k.dice.uniform(-14, 14));
        k.add(std::move(sheet), mat, {0, 0.004f + 0.008f * static_cast<float>(i), 0});
    }
    on_surface(k);
}
void teddy_bear(Kit& k) {
    Material fur = k.style.fabric;
    fur.pattern = Pattern::carpet;
    fur.bump_m = 0.003f;
    const int body = k.main(tinted(fur, {0.36f, 0.2f, 0.09f})),
              dark = k.material(plain("button", {0.03f, 0.025f, 0.02f}, 0.3f)),
              pale = k.material(tinted(fur, {0.6f, 0.44f, 0.26f}));
    k.add(shapes::ball({0, 0.1f, 0}, {0.085f, 0.1f, 0.075f}), body);
    k.add(shapes::ball({0, 0.24f, 0.01f}, {0.075f, 0.07f, 0.07f}), body);
    k.add(shapes::ball({0, 0.225f, 0.07f}, {0.035f, 0.028f, 0.025f}), pale);
    k.add(shapes::ball({0, 0.238f, 0.092f}, {0.012f, 0.009f, 0.008f}, 10), dark);
    for (const float s : {-1.f, 1.f}) {
        k.add(shapes::ball({s * 0.06f, 0.3f, 0}, {0.03f, 0.03f, 0.015f}), body);
        k.add(shapes::ball({s * 0.03f, 0.262f, 0.07f}, {0.008f, 0.008f, 0.006f}, 8), dark);
        k.add(shapes::ball({s * 0.1f, 0.13f, 0.03f}, {0.032f, 0.065f, 0.035f}), body);
        k.add(shapes::ball({s * 0.065f, 0.036f, 0.085f}, {0.036f, 0.036f, 0.07f}), body);
    }
    on_surface(k);
}
void toy_blocks(Kit& k) {
    for (int i = 0; i < 6; ++i) {
        const int mat = i == 0 ? k.main(plain("toy block", k.accent(), 0.5f))
                               : k.material(plain("toy block", k.accent(), 0.5f));
        const int row = i < 3 ? 0 : i < 5 ? 1 : 2;
        Mesh m = shapes::box({0.07f, 0.07f, 0.07f}, 0.006f);
        shapes::turn(m, {0, 1, 0}, k.dice.uniform(-20, 20));
        k.add(std::move(m), mat,
              {0.085f * (static_cast<float>(row == 0   ? i
                                            : row == 1 ? i - 3
                                                       : 0) +
                         0.5f * static_cast<float>(row)),
               0.035f + 0.07f * static_cast<float>(row), 0});
    }
    on_surface(k);
}
void alarm_clock(Kit& k) {
    const int body = k.main(k.style.metal), face = k.material(plain("dial", {0.76f, 0.74f, 0.68f}, 0.4f)),
              dark = k.material(plain("hands", {0.04f, 0.04f, 0.04f}, 0.4f));
    Mesh drum = shapes::prism(shapes::circle(0.05f, 32), -0.02f, 0.02f, 0.006f),
         dial = shapes::prism(shapes::circle(0.043f, 32), 0.f, 0.003f, 0.001f);
    shapes::turn(drum, {1, 0, 0}, 90);
    shapes::turn(dial, {1, 0, 0}, 90);
    k.add(std::move(drum), body, {0, 0.065f, 0});
    k.add(std::move(dial), face, {0, 0.065f, 0.019f});
    k.board(dark, {0, 0.063f, 0.024f}, {0.003f, 0.034f, 0.001f}, 0.0003f);
    k.board(dark, {0.01f, 0.064f, 0.024f}, {0.022f, 0.003f, 0.001f}, 0.0003f);
    for (const float s : {-1.f, 1.f}) k.rod(body, {s * 0.03f, 0, 0}, {s * 0.022f, 0.025f, 0}, 0.005f);
    on_surface(k);
}
void storage_box(Kit& k) {
    Material m = k.dice.chance(0.5f) ? *material_named("wicker")
                                     : tinted(k.style.fabric2, lerp(k.accent(), {0.6f, 0.57f, 0.5f}, 0.5f));
    const int mat = k.main(m);
    const Vec3f s = k.wanted({0.32f, 0.2f, 0.24f});
    k.board(mat, {}, {s.x, 0.8f * s.y, s.z}, 0.012f);
    k.board(mat, {0, 0.8f * s.y, 0}, {s.x + 0.012f, 0.2f * s.y, s.z + 0.012f}, 0.01f);
    on_surface(k);
}
// A narrow board with frames that lean on it.
void picture_ledge(Kit& k) {
    const Vec3f s = k.wanted({1.2f, 0.f, 0.11f});
    const int wood = k.main(k.style.wood);
    k.board(wood, {0, 0, 0.5f * s.z}, {s.x, 0.02f, s.z}, 0.003f);
    k.board(wood, {0, 0.02f, s.z - 0.008f}, {s.x, 0.025f, 0.014f}, 0.003f);
    float x = -0.5f * s.x + 0.06f;
    while (true) {
        PieceRequest r;
        r.klass = "picture";
        r.style = &k.style;
        r.seed = k.dice.next_u64();
        const float w = k.dice.uniform(0.22f, 0.42f);
        if (x + w > 0.5f * s.x - 0.04f) break;
        r.size_m = {w, w * k.dice.uniform(0.9f, 1.4f), 0};
        k.merge(make_piece(r), {x + 0.5f * w, 0.02f, 0.012f + k.dice.uniform(0.f, 0.012f)});
        x += w + k.dice.uniform(0.02f, 0.08f);
    }
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.2f;
}

constexpr Entry kClutter[] = {{"cup", cup},
                              {"tray", tray},
                              {"place_setting", place_setting},
                              {"bottles", bottles},
                              {"photo_frame", photo_frame},
                              {"sculpture", sculpture},
                              {"globe", globe},
                              {"laptop", laptop},
                              {"towel_stack", towel_stack},
                              {"toiletries", toiletries},
                              {"kettle", kettle},
                              {"toaster", toaster},
                              {"utensils", utensils},
                              {"pen", pens},
                              {"cutting_board", cutting_board},
                              {"pot", pot},
                              {"magazines", magazines},
                              {"teddy_bear", teddy_bear},
                              {"toy_blocks", toy_blocks},
                              {"alarm_clock", alarm_clock},
                              {"storage_box", storage_box},
                              {"picture_ledge", picture_ledge}};

}  // namespace

std::span<const Entry> clutter() { return kClutter; }

}  // namespace fastscene::furniture

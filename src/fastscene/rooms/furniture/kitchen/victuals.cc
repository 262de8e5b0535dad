// Food as shops and kitchens show it: jars, tins, bread, cakes, cheese, sausages, crates of fruit.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/print.h"
#include "fastscene/rooms/furniture/profiles.h"
#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {
namespace {

void victual(Kit& k, int material, Vec3f base_center, Vec3f size, float turn_deg = 0, int sides = 10) {
    Mesh m = shapes::ball({0, 0, 0}, size * 0.5f, sides);
    shapes::turn(m, {0, 1, 0}, turn_deg);
    k.add(std::move(m), material, base_center + Vec3f{0, 0.5f * size.y, 0});
}

// Flat on z, bent to a crescent, thick in the middle.
void croissant(Kit& k, int crust, Vec3f at, float turn) {
    for (int i = -2; i <= 2; ++i) {
        const float a = 0.5f * static_cast<float>(i) + turn, thick = 0.05f - 0.009f * static_cast<float>(std::abs(i));
        victual(k, crust, at + Vec3f{0.07f * std::sin(a), 0, 0.07f * std::cos(a) - 0.05f},
                {thick * 1.15f, thick, thick * 1.3f}, a * 57.f, 8);
    }
}

int wicker(Kit& k) { return k.main(*material_named("rattan")); }

// A glass foot with a plate on it.
float cake_foot(Kit& k, int material, float radius) {
    const std::array<Vec2f, 7> p{Vec2f{0.07f, 0}, {0.068f, 0.008f}, {0.02f, 0.02f},  {0.014f, 0.06f},
                                 {0.03f, 0.085f}, {radius, 0.093f}, {radius, 0.103f}};
    k.add(shapes::lathe(p, 24), material);
    return 0.103f;
}

}  // namespace

void build_jar(Kit& k) {
    static constexpr std::array<Vec3f, 6> kDry{Vec3f{0.55f, 0.4f, 0.16f}, {0.36f, 0.07f, 0.03f}, {0.6f, 0.52f, 0.38f},
                                               {0.2f, 0.22f, 0.08f},      {0.1f, 0.05f, 0.03f},  {0.45f, 0.27f, 0.1f}};
    const int contents = jar_contents(k, kDry[static_cast<std::size_t>(k.rng.index(6))]);
    const int lid = k.main(k.rng.chance(0.5f) ? materials::timber("natural", 0.6f) : steel());
    const float h = k.rng.uniform(0.16f, 0.28f);
    filled_jar(k, contents, lid, {0, 0, 0}, 0.052f, h, 18);
    k.add(shapes::ball({0, h + 0.008f, 0}, {0.014f, 0.012f, 0.014f}, 8), lid);
    const PrintSheet sheet = print_sheet(k, Print::preserves);
    k.add(printed_can(sheet[k.rng.index(sheet.cells)], 0.0526f, 0.25f * h, 0.52f * h, 18), sheet.material);
    on_surface(k);
}

// A pyramid of tins.
void build_food_cans(Kit& k) {
    const int lid = k.main(steel());
    const PrintSheet sheet = print_sheet(k, Print::tins);
    const float r = 0.0375f, h = 0.108f;
    const int brand = k.rng.index(sheet.cells), other = k.rng.index(sheet.cells);
    for (int row = 0; row < 3; ++row)
        for (int i = 0; i < 3 - row; ++i) {
            const Vec3f at{(2 * r + 0.003f) * (static_cast<float>(i) - 0.5f * static_cast<float>(2 - row)),
                           (h + 0.001f) * static_cast<float>(row), k.rng.uniform(-0.004f, 0.004f)};
            k.add(printed_can(sheet[(row + i) % 3 == 1 ? other : brand], r, 0.003f, h - 0.004f, 14), sheet.material,
                  at);
            const std::array<Vec2f, 2> foot{Vec2f{r, 0}, {r, 0.003f}};
            const std::array<Vec2f, 4> rim{
                Vec2f{r, 0}, {r + 0.0012f, 0.001f}, {r + 0.0012f, 0.004f}, {r - 0.003f, 0.0035f}};
            k.add(shapes::lathe(foot, 14), lid, at), k.add(shapes::lathe(rim, 14), lid, at + Vec3f{0, h - 0.004f, 0});
        }
    on_surface(k);
}

// Baguettes that stand out, loaves, rolls and a croissant.
void build_bread_basket(Kit& k) {
    const int cane = wicker(k), crust = color(k, "crust", {0.42f, 0.22f, 0.075f}, 0.75f),
              dark = color(k, "dark crust", {0.26f, 0.12f, 0.045f}, 0.75f),
              flour = color(k, "floured crust", {0.58f, 0.45f, 0.28f}, 0.95f),
              cloth = k.material(tinted(k.style.fabric, {0.68f, 0.64f, 0.55f}));
    const std::array<Vec2f, 3> side{Vec2f{0.17f, 0}, {0.2f, 0.07f}, {0.215f, 0.12f}};
    k.add(shapes::vessel(side, 0.012f, 28), cane), k.add(hoop(0.21f, 0.022f, 28), cane, {0, 0.12f, 0}),
        k.add(hoop(0.19f, 0.016f, 28), cane, {0, 0.05f, 0});
    victual(k, cloth, {0, 0.05f, 0}, {0.39f, 0.07f, 0.39f}, 0, 18);
    for (int i = 0; i < 3; ++i) {  // baguettes, across the rim
        const float z = -0.11f + 0.06f * static_cast<float>(i), aside = k.rng.uniform(-0.02f, 0.02f);
        Mesh long_loaf = shapes::ball({0, 0, 0}, {0.27f, 0.03f, 0.034f}, 12);
        shapes::turn(long_loaf, {0, 1, 0}, k.rng.uniform(-7, 7));
        shapes::turn(long_loaf, {0, 0, 1}, k.rng.uniform(-3, 3));
        k.add(std::move(long_loaf), crust,
              {0.02f * static_cast<float>(i), 0.145f + 0.012f * static_cast<float>(i % 2), z});
        for (int c = -3; c <= 3; ++c) {
            Mesh cut = shapes::ball({0, 0, 0}, {0.02f, 0.006f, 0.011f}, 6);
            shapes::turn(cut, {0, 1, 0}, 35);
            k.add(std::move(cut), flour,
                  {0.02f * static_cast<float>(i) + 0.055f * static_cast<float>(c),
                   0.17f + 0.012f * static_cast<float>(i % 2) - 0.0006f * static_cast<float>(c * c), z + aside});
        }
    }
    victual(k, dark, {-0.1f, 0.09f, 0.09f}, {0.17f, 0.11f, 0.14f}, 20, 12),
        victual(k, flour, {-0.1f, 0.187f, 0.09f}, {0.09f, 0.018f, 0.025f}, 20),
        victual(k, flour, {-0.1f, 0.185f, 0.06f}, {0.08f, 0.015f, 0.02f}, 20);
    for (int i = 0; i < 3; ++i)
        victual(k, i == 1 ? flour : crust,
                {0.02f + 0.075f * static_cast<float>(i % 2), 0.1f + 0.03f * static_cast<float>(i / 2),
                 0.05f + 0.06f * static_cast<float>(i)},
                {0.085f, 0.065f, 0.08f});
    croissant(k, crust, {0.13f, 0.11f, 0.06f}, 0.6f);
    on_surface(k);
}

// Small cakes and buns on a plate with a foot.
void build_cake_stand(Kit& k) {
    const int plate = k.main(porcelain()), crust = color(k, "crust", {0.42f, 0.22f, 0.075f}, 0.7f),
              cream = color(k, "cream", {0.72f, 0.64f, 0.5f}, 0.6f),
              choco = color(k, "chocolate", {0.06f, 0.025f, 0.012f}, 0.35f),
              pink = color(k, "icing", {0.62f, 0.22f, 0.26f}, 0.35f),
              red = color(k, "cherry", {0.4f, 0.015f, 0.02f}, 0.15f);
    const float y = cake_foot(k, plate, 0.15f);
    const auto cup_cake = [&](Vec3f at, int icing) {
        const std::array<Vec2f, 2> paper{Vec2f{0.022f, 0}, {0.031f, 0.034f}};
        const std::array<Vec2f, 4> swirl{Vec2f{0.033f, 0.034f}, {0.03f, 0.048f}, {0.018f, 0.062f}, {0, 0.07f}};
        k.add(shapes::lathe(paper, 12), crust, at), k.add(shapes::lathe(swirl, 12, true), icing, at),
            k.add(shapes::ball(at + Vec3f{0, 0.073f, 0}, {0.009f, 0.009f, 0.009f}, 8), red);
    };
    for (int i = 0; i < 7; ++i) {
        const float a = kTau * static_cast<float>(i) / 7.f;
        const Vec3f at{0.105f * std::cos(a), y, 0.105f * std::sin(a)};
        if (i % 3 == 2) croissant(k, crust, at, a);
        else cup_cake(at, i % 3 ? pink : cream);
    }
    cup_cake({0, y, 0}, choco);
    on_surface(k);
}

// Two layers, cream, candles that burn.
void build_birthday_cake(Kit& k) {
    const int icing = k.main(
                  plain("icing", k.rng.chance(0.5f) ? Vec3f{0.74f, 0.68f, 0.6f} : Vec3f{0.66f, 0.3f, 0.34f}, 0.45f)),
              plate = k.material(porcelain()), cream = color(k, "cream", {0.78f, 0.74f, 0.66f}, 0.55f),
              fire = k.material(flame("flame", {30, 17, 5}));
    const float y = cake_foot(k, plate, 0.17f);
    const std::array<Vec2f, 4> low{Vec2f{0.14f, y}, {0.142f, y + 0.075f}, {0.136f, y + 0.082f}, {0.1f, y + 0.082f}},
        high{Vec2f{0.094f, y + 0.08f}, {0.096f, y + 0.145f}, {0.09f, y + 0.152f}, {0, y + 0.153f}};
    k.add(shapes::lathe(low, 30), icing), k.add(shapes::lathe(high, 26), icing);
    for (int i = 0; i < 18; ++i) {
        const Vec3f d = around(kTau * static_cast<float>(i) / 18.f);
        k.add(shapes::ball(d * 0.14f + Vec3f{0, y + 0.006f, 0}, {0.018f, 0.014f, 0.018f}, 6), cream);
        if (i % 2 == 0) k.add(shapes::ball(d * 0.095f + Vec3f{0, y + 0.087f, 0}, {0.014f, 0.011f, 0.014f}, 6), cream);
    }
    static constexpr std::array<Vec3f, 3> kWax{Vec3f{0.1f, 0.3f, 0.6f}, {0.7f, 0.5f, 0.06f}, {0.6f, 0.1f, 0.15f}};
    for (int i = 0; i < 6; ++i) {
        const Vec3f at = around(kTau * static_cast<float>(i) / 6.f) * 0.062f + Vec3f{0, y + 0.152f, 0};
        k.rod(color(k, "wax", kWax[static_cast<std::size_t>(i % 3)], 0.5f), at, at + Vec3f{0, 0.065f, 0}, 0.0045f, -1,
              6);
        k.add(shapes::ball(at + Vec3f{0, 0.079f, 0}, {0.005f, 0.012f, 0.005f}, 6), fire);
    }
    on_surface(k);
}

// A low crate of slats, full of one sort of fruit or vegetable.
void build_fruit_crate(Kit& k) {
    static constexpr std::array<Vec3f, 6> kSorts{Vec3f{0.42f, 0.03f, 0.02f}, {0.6f, 0.24f, 0.02f},
                                                 {0.28f, 0.38f, 0.05f},      {0.5f, 0.05f, 0.02f},
                                                 {0.6f, 0.46f, 0.04f},       {0.09f, 0.2f, 0.05f}};
    const int wood = k.main(materials::timber("natural", 0.85f)),
              fruit = color(k, "fruit", kSorts[static_cast<std::size_t>(k.rng.index(6))], 0.3f),
              stalk = color(k, "stalk", {0.09f, 0.1f, 0.03f}, 0.8f),
              earth = color(k, "shade of a crate", {0.04f, 0.03f, 0.02f}, 0.95f);
    const float w = 0.5f, d = 0.34f, h = 0.2f;
    for (int i = 0; i < 3; ++i) {
        const float y = 0.01f + 0.062f * static_cast<float>(i);
        for (const float s : {-1.f, 1.f})
            k.board(wood, {0, y, s * 0.5f * d}, {w, 0.05f, 0.008f}, 0.002f),
                block(k, wood, {s * (0.5f * w - 0.005f), y, 0}, {0.01f, 0.05f, d});
    }
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f})
            block(k, wood, {sx * (0.5f * w - 0.022f), 0, sz * (0.5f * d - 0.018f)}, {0.025f, h + 0.02f, 0.025f});
    block(k, earth, {0, 0.01f, 0}, {w - 0.03f, 0.12f, d - 0.02f});
    for (int row = 0; row < 4; ++row)
        for (int i = 0; i < 6; ++i) {
            const float r = k.rng.uniform(0.033f, 0.039f);
            const Vec3f at{-0.19f + 0.076f * static_cast<float>(i) + k.rng.uniform(-0.006f, 0.006f),
                           0.15f + k.rng.uniform(0, 0.028f),
                           -0.115f + 0.077f * static_cast<float>(row) + k.rng.uniform(-0.006f, 0.006f)};
            k.add(shapes::ball(at, {r, 0.94f * r, r}, 9), fruit),
                k.rod(stalk, at + Vec3f{0, 0.8f * r, 0}, at + Vec3f{0.006f, 1.25f * r, 0}, 0.0022f, -1, 4);
        }
}

// On a board: a wheel that lacks a slice, the slice before it.
void build_cheese_wheel(Kit& k) {
    const int rind = k.main(
                  plain("rind", k.rng.chance(0.5f) ? Vec3f{0.6f, 0.36f, 0.07f} : Vec3f{0.42f, 0.05f, 0.03f}, 0.45f)),
              paste = color(k, "cheese", {0.68f, 0.5f, 0.18f}, 0.5f),
              hole = color(k, "hole", {0.5f, 0.33f, 0.09f}, 0.7f), wood = k.material(k.style.wood);
    k.add(shapes::prism(shapes::rounded_rectangle(0.42f, 0.34f, 0.03f, 3), 0, 0.02f), wood);
    // The rind, the face above and the two cuts, from one angle to another.
    const auto part = [&](Vec3f at, float from, float to, float r, float high, int steps) {
        const auto rim = [&](float v) { return around(to + (from - to) * v); };
        k.add(shapes::sheet(steps, 2, [&](float u, float v) { return rim(u) * r + Vec3f{0, high * v, 0}; }), rind, at);
        k.add(shapes::sheet(1, steps,
                            [&](float u, float v) {
                                return rim(v) * (r * (0.94f + 0.06f * u)) + Vec3f{0, high, 0};
                            }),
              rind, at);
        k.add(shapes::sheet(1, steps,
                            [&](float u, float v) {
                                return rim(v) * (r * (0.001f + 0.939f * u)) + Vec3f{0, high - 0.0005f, 0};
                            }),
              rind, at);
        k.add(shapes::sheet(1, 1,
                            [&](float u, float v) {
                                return around(to) * (r * u) + Vec3f{0, high * v, 0};
                            }),
              paste, at);
        k.add(shapes::sheet(1, 1,
                            [&](float u, float v) {
                                return around(from) * (r * (1 - u)) + Vec3f{0, high * v, 0};
                            }),
              paste, at);
    };
    part({-0.02f, 0.02f, -0.03f}, 1.75f, 7.1f, 0.14f, 0.095f, 26);
    part({0.02f, 0.02f, 0.03f}, 0.9f, 1.6f, 0.13f, 0.095f, 6);
    for (int i = 0; i < 5; ++i)
        k.add(shapes::ball({-0.03f - 0.004f * static_cast<float>(i), 0.045f + 0.03f * static_cast<float>(i % 2),
                            0.018f * static_cast<float>(i)},
                           {0.008f, 0.008f, 0.006f}, 6),
              hole);
    on_surface(k);
}

// A rail at the wall with salami, hams and strings of sausages on hooks.
void build_hanging_sausages(Kit& k) {
    const Vec3f s = k.wanted({1.4f, 0.62f, 0.16f});
    const int rail = k.main(steel()), red = color(k, "sausage", {0.3f, 0.06f, 0.03f}, 0.45f),
              brown = color(k, "smoked sausage", {0.2f, 0.07f, 0.03f}, 0.4f),
              pale = color(k, "salami", {0.5f, 0.42f, 0.36f}, 0.8f), ham = color(k, "ham", {0.32f, 0.13f, 0.05f}, 0.5f),
              fat = color(k, "rind of a ham", {0.55f, 0.38f, 0.2f}, 0.5f),
              string = color(k, "string", {0.6f, 0.52f, 0.38f}, 0.9f);
    const float z = 0.09f, top = s.y - 0.03f;
    k.rod(rail, {-0.5f * s.x, top, z}, {0.5f * s.x, top, z}, 0.012f, -1, 10);
    for (const float sx : {-1.f, 1.f})
        k.rod(rail, {sx * (0.5f * s.x - 0.06f), top, 0}, {sx * (0.5f * s.x - 0.06f), top, z}, 0.01f, -1, 8);
    const int count = std::max(3, static_cast<int>(s.x / 0.13f));
    for (int i = 0; i < count; ++i) {
        const float x = s.x * ((static_cast<float>(i) + 0.5f) / static_cast<float>(count) - 0.5f);
        k.rod(string, {x, top, z}, {x, top - 0.09f, z}, 0.003f, -1, 5);
        const int sort = (i + k.rng.index(2)) % 4;
        if (sort == 0) {  // salami, tied
            const float l = k.rng.uniform(0.28f, 0.42f);
            k.rod(pale, {x, top - 0.09f, z}, {x, top - 0.09f - l, z}, 0.034f, 0.038f, 12);
            for (int r = 1; r < 5; ++r)
                k.add(hoop(0.037f, 0.004f, 12), string, {x, top - 0.09f - l * static_cast<float>(r) / 5, z});
        } else if (sort == 1) {  // a ham
            const std::array<Vec2f, 6> p{Vec2f{0, -0.4f},  {0.055f, -0.37f}, {0.072f, -0.28f},
                                         {0.055f, -0.15f}, {0.022f, -0.06f}, {0.02f, 0}};
            k.add(shapes::lathe(shapes::curve(p, 1), 14, true), ham, {x, top - 0.07f, z});
            k.add(shapes::ball({x, top - 0.36f, z + 0.012f}, {0.056f, 0.08f, 0.062f}, 12), fat);
        } else {  // a string of sausages
            for (const float side : {-1.f, 1.f})
                for (int r = 0; r < 3; ++r)
                    k.add(shapes::ball({x + side * (0.018f + 0.004f * static_cast<float>(r)),
                                        top - 0.15f - 0.125f * static_cast<float>(r), z},
                                       {0.017f, 0.064f, 0.017f}, 8),
                          sort == 2 ? red : brown);
        }
    }
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 1.5f;
}

}  // namespace fastscene::furniture

// Counters: of cafés, bars, bakeries, shops and receptions. One serves behind them (-z) and comes to their front.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"
#include "fastscene/rooms/furniture/screen.h"

namespace fastscene::furniture {
namespace {

// Free floor before a counter: who orders, and who passes.
constexpr float kBefore = 1.0f;

struct Body {
    Vec3f size;
    int front, top;
};

// Panelled front on a plinth, a top that reaches over.
Body counter_body(Kit& k, Vec3f usual, bool main_is_wood, Material worktop) {
    const Vec3f s = k.wanted(usual);
    const int body = k.main(main_is_wood ? k.style.wood : plain("counter lacquer", k.accent(), 0.4f)),
              top = k.material(std::move(worktop)), dark = color(k, "plinth", {0.03f, 0.03f, 0.03f}, 0.6f);
    k.board(dark, {0, 0, -0.02f}, {s.x - 0.04f, 0.1f, s.z - 0.12f});
    k.board(body, {0, 0.1f, -0.02f}, {s.x - 0.04f, s.y - 0.14f, s.z - 0.08f});
    const int panels = std::max(2, static_cast<int>(s.x / 0.55f));
    for (int i = 0; i < panels; ++i) {
        const float w = (s.x - 0.08f) / static_cast<float>(panels),
                    x = -0.5f * s.x + 0.04f + w * (static_cast<float>(i) + 0.5f);
        k.board(body, {x, 0.14f, 0.5f * s.z - 0.055f}, {w - 0.03f, s.y - 0.22f, 0.02f}, 0.006f);
    }
    k.board(top, {0, s.y - 0.04f, 0}, {s.x, 0.04f, s.z}, 0.006f);
    k.piece.clearance_front_m = kBefore;
    return {s, body, top};
}

// ---- what lies in cases, on trays

using Colors = std::array<int, 3>;

struct Food {
    Colors colors;
    int tray;
    Vec2f pitch;  // metres across, and from front to back
    void (*put)(Kit&, const Colors&, Vec3f at);
};
using Foods = std::vector<Food>;

void rounded_lump(Kit& k, int material, Vec3f at, Vec3f radii) {
    k.add(shapes::ball(at + Vec3f{0, radii.y, 0}, radii, 8), material);
}
// A crescent of rolled dough: thick in the middle, its ends bent to the front.
void croissant(Kit& k, const Colors& c, Vec3f at) {
    for (int i = -2; i <= 2; ++i) {
        const float t = static_cast<float>(i) / 2, r = 0.03f - 0.013f * t * t;
        Mesh m = shapes::ball({0, 0, 0}, {0.021f, r, r}, 6);
        shapes::turn(m, {0, 1, 0}, -28.f * t);
        k.add(std::move(m), i % 2 == 0 ? c[0] : c[1], at + Vec3f{0.05f * t, r, 0.026f * t * t});
    }
}
void muffin(Kit& k, const Colors& c, Vec3f at) {
    const std::array<Vec2f, 2> paper{Vec2f{0.024f, 0}, {0.034f, 0.042f}};
    k.add(shapes::lathe(paper, 8), c[1], at);
    k.add(shapes::ball(at + Vec3f{0, 0.042f, 0}, {0.041f, 0.028f, 0.041f}, 8), c[0]);
    for (const Vec3f d : {Vec3f{0.014f, 0.066f, 0.012f}, {-0.016f, 0.064f, 0.016f}, {0.002f, 0.069f, -0.014f}})
        k.add(shapes::ball(at + d, {0.007f, 0.005f, 0.007f}, 5), c[2]);
}
void biscuit(Kit& k, const Colors& c, Vec3f at) {
    for (int i = 0; i < 2; ++i)
        k.add(shapes::ball(at + Vec3f{0.004f * static_cast<float>(i), 0.008f + 0.013f * static_cast<float>(i), 0},
                           {0.04f, 0.009f, 0.04f}, 8),
              c[0]);
    for (const Vec3f d : {Vec3f{0.018f, 0.029f, 0.006f}, {-0.014f, 0.029f, 0.014f}, {-0.004f, 0.03f, -0.016f}})
        k.add(shapes::ball(at + d, {0.006f, 0.004f, 0.006f}, 5), c[2]);
}
// A wedge of layers.
void cake(Kit& k, const Colors& c, Vec3f at) {
    const std::array<Vec2f, 3> wedge{Vec2f{0, 0.06f}, {0.038f, -0.06f}, {-0.038f, -0.06f}};
    float y = 0;
    for (const auto& [layer, high] : {std::pair{0, 0.022f}, {1, 0.006f}, {0, 0.022f}, {1, 0.008f}}) {
        k.add(shapes::prism(wedge, y, y + high, 0.001f), c[static_cast<std::size_t>(layer)], at);
        y += high;
    }
    k.add(shapes::ball(at + Vec3f{0, y + 0.006f, -0.035f}, {0.011f, 0.01f, 0.011f}, 6), c[2]);
}
void tart(Kit& k, const Colors& c, Vec3f at) {
    const std::array<Vec2f, 3> shell{Vec2f{0.032f, 0}, {0.042f, 0.022f}, {0.036f, 0.02f}};
    k.add(shapes::lathe(shell, 9), c[0], at);
    for (int i = 0; i < 5; ++i) {
        const Vec3f d = around(kTau * static_cast<float>(i) / 5) * 0.02f;
        k.add(shapes::ball(at + d + Vec3f{0, 0.026f, 0}, {0.012f, 0.01f, 0.012f}, 5), c[2]);
    }
    k.add(shapes::ball(at + Vec3f{0, 0.03f, 0}, {0.012f, 0.01f, 0.012f}, 5), c[2]);
}
void baguette_half(Kit& k, const Colors& c, Vec3f at) {
    rounded_lump(k, c[0], at, {0.035f, 0.018f, 0.085f});
    block(k, c[1], at + Vec3f{0, 0.022f, 0}, {0.068f, 0.008f, 0.15f});
    block(k, c[2], at + Vec3f{0, 0.03f, 0}, {0.06f, 0.006f, 0.14f});
    k.add(shapes::ball(at + Vec3f{0, 0.042f, 0}, {0.035f, 0.018f, 0.085f}, 8), c[0]);
}
void cheese(Kit& k, const Colors& c, Vec3f at) {
    const std::array<Vec2f, 4> wedge{Vec2f{-0.06f, 0.05f}, {0.06f, 0.05f}, {0.07f, -0.04f}, {-0.02f, -0.05f}};
    k.add(shapes::prism(wedge, 0, 0.07f, 0.004f), c[0], at);
    k.add(shapes::prism(wedge, 0.07f, 0.076f, 0.002f), c[1], at);
}
void sausage(Kit& k, const Colors& c, Vec3f at) {
    k.rod(c[0], at + Vec3f{0, 0.035f, -0.1f}, at + Vec3f{0, 0.035f, 0.08f}, 0.035f, -1, 12);
    k.rod(c[1], at + Vec3f{0, 0.035f, 0.08f}, at + Vec3f{0, 0.035f, 0.084f}, 0.031f, -1, 12);
}
void slices(Kit& k, const Colors& c, Vec3f at) {
    for (int i = 0; i < 6; ++i) {
        Mesh m = shapes::ball({0, 0, 0}, {0.05f, 0.05f, 0.005f}, 10);
        shapes::turn(m, {1, 0, 0}, -55);
        k.add(std::move(m), i % 2 == 0 ? c[0] : c[1], at + Vec3f{0, 0.032f, 0.06f - 0.024f * static_cast<float>(i)});
    }
}
// A bowl of salad or olives.
void bowl_of(Kit& k, const Colors& c, Vec3f at) {
    const std::array<Vec2f, 3> bowl{Vec2f{0.05f, 0}, {0.085f, 0.05f}, {0.09f, 0.06f}};
    k.add(shapes::vessel(bowl, 0.005f, 14), c[1], at);
    for (int i = 0; i < 14; ++i) {
        const Vec3f d = around(2.4f * static_cast<float>(i)) * (0.018f * std::sqrt(static_cast<float>(i)));
        k.add(shapes::ball(at + d + Vec3f{0, 0.058f - 4.f * dot(d, d), 0}, {0.02f, 0.014f, 0.02f}, 5),
              i % 4 == 0 ? c[2] : c[0]);
    }
}

Foods pastries(Kit& k) {
    const int crust = color(k, "croissant", {0.46f, 0.24f, 0.075f}, 0.45f),
              dark = color(k, "baked edge", {0.3f, 0.13f, 0.04f}, 0.5f),
              sponge = color(k, "sponge", {0.5f, 0.34f, 0.15f}, 0.85f),
              chocolate = color(k, "chocolate", {0.06f, 0.028f, 0.014f}, 0.4f),
              cream = color(k, "cream", {0.68f, 0.62f, 0.5f}, 0.5f),
              berry = color(k, "berry", {0.32f, 0.02f, 0.035f}, 0.3f),
              paper = color(k, "baking paper", {0.55f, 0.44f, 0.3f}, 0.9f), tray = k.material(steel()),
              board = k.material(k.style.wood2);
    return {{{crust, dark, crust}, board, {0.16f, 0.13f}, croissant},
            {{sponge, paper, berry}, tray, {0.125f, 0.14f}, muffin},
            {{chocolate, paper, cream}, tray, {0.125f, 0.14f}, muffin},
            {{crust, dark, chocolate}, board, {0.115f, 0.14f}, biscuit},
            {{sponge, cream, berry}, tray, {0.115f, 0.16f}, cake},
            {{chocolate, cream, berry}, tray, {0.115f, 0.16f}, cake},
            {{crust, dark, berry}, tray, {0.115f, 0.14f}, tart},
            {{crust, dark, crust}, board, {0.16f, 0.13f}, croissant}};
}

Foods deli_foods(Kit& k) {
    const int bread = color(k, "roll", {0.46f, 0.26f, 0.1f}, 0.6f),
              salad = color(k, "salad", {0.16f, 0.28f, 0.05f}, 0.6f), ham = color(k, "ham", {0.48f, 0.2f, 0.16f}, 0.5f),
              rind = color(k, "rind", {0.5f, 0.3f, 0.08f}, 0.5f),
              gouda = color(k, "cheese", {0.6f, 0.44f, 0.14f}, 0.5f),
              brie = color(k, "brie", {0.68f, 0.63f, 0.5f}, 0.6f),
              salami = color(k, "salami", {0.2f, 0.05f, 0.045f}, 0.55f),
              cut = color(k, "cut", {0.4f, 0.14f, 0.12f}, 0.5f),
              olive = color(k, "olives", {0.1f, 0.13f, 0.035f}, 0.3f),
              tomato = color(k, "tomato", {0.4f, 0.05f, 0.03f}, 0.35f), white = k.material(porcelain()),
              tray = k.material(steel()), board = k.material(k.style.wood2);
    return {{{bread, ham, salad}, board, {0.1f, 0.2f}, baguette_half},
            {{gouda, rind, gouda}, board, {0.17f, 0.15f}, cheese},
            {{brie, brie, brie}, board, {0.17f, 0.15f}, cheese},
            {{salami, cut, cut}, tray, {0.09f, 0.22f}, sausage},
            {{ham, cut, ham}, tray, {0.13f, 0.2f}, slices},
            {{olive, white, tomato}, tray, {0.21f, 0.21f}, bowl_of},
            {{salad, white, tomato}, tray, {0.21f, 0.21f}, bowl_of}};
}

// A glass case on a counter or on the floor: shelves with what is sold, lit.
void case_of(Kit& k, Vec3f at, Vec3f s, const std::string& what) {
    const int pane = k.material(glass()), metal = k.material(k.style.metal),
              white = color(k, "shelf", {0.72f, 0.71f, 0.68f}, 0.4f),
              strip = k.material(glow("case light", {5, 4.6f, 3.8f}));
    const Foods food = what == "deli" ? deli_foods(k) : pastries(k);
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f})
            k.rod(metal, at + Vec3f{sx * (0.5f * s.x - 0.01f), 0, sz * (0.5f * s.z - 0.01f)},
                  at + Vec3f{sx * (0.5f * s.x - 0.01f), s.y, sz * (0.5f * s.z - 0.01f)}, 0.008f, -1, 6);
    k.board(metal, at + Vec3f{0, s.y - 0.012f, 0}, {s.x, 0.012f, s.z}, 0.003f);
    k.board(strip, at + Vec3f{0, s.y - 0.03f, 0.5f * s.z - 0.04f}, {s.x - 0.06f, 0.016f, 0.03f}, 0.003f);
    k.board(pane, at + Vec3f{0, 0, 0.5f * s.z - 0.004f}, {s.x - 0.02f, s.y - 0.012f, 0.005f}, 0.001f);
    for (const float sx : {-1.f, 1.f})
        k.board(pane, at + Vec3f{sx * (0.5f * s.x - 0.004f), 0, 0}, {0.005f, s.y - 0.012f, s.z - 0.02f}, 0.001f);
    const int rows = s.y > 0.5f ? 2 : 1;
    for (int r = 0; r < rows; ++r) {
        const float y = s.y * static_cast<float>(r) / static_cast<float>(rows) + 0.01f;
        k.board(white, at + Vec3f{0, y - 0.01f, 0}, {s.x - 0.03f, 0.014f, s.z - 0.04f}, 0.002f);
        // Trays of one sort each.
        const int trays = std::max(1, static_cast<int>((s.x - 0.06f) / 0.32f));
        const float wide = (s.x - 0.06f) / static_cast<float>(trays);
        for (int t = 0; t < trays; ++t) {
            const float x0 = -0.5f * s.x + 0.03f + wide * static_cast<float>(t);
            const auto sort = static_cast<std::size_t>(k.rng.index(static_cast<int>(food.size())));
            const Food& of = food[sort];
            k.board(of.tray, at + Vec3f{x0 + 0.5f * wide, y + 0.004f, 0}, {wide - 0.02f, 0.008f, s.z - 0.08f}, 0.003f);
            const int across = std::max(1, static_cast<int>((wide - 0.03f) / of.pitch.x)),
                      deep = std::max(1, static_cast<int>((s.z - 0.1f) / of.pitch.y));
            for (int i = 0; i < across; ++i)
                for (int j = 0; j < deep; ++j) {
                    if (k.rng.chance(0.07f)) continue;  // sold
                    const Vec3f on{x0 + wide * (static_cast<float>(i) + 0.5f) / static_cast<float>(across), y + 0.012f,
                                   (s.z - 0.1f) * ((static_cast<float>(j) + 0.5f) / static_cast<float>(deep) - 0.5f)};
                    of.put(k, of.colors, at + on);
                }
            block(k, white, at + Vec3f{x0 + 0.5f * wide, y + 0.012f, 0.5f * s.z - 0.035f}, {0.07f, 0.035f, 0.003f});
        }
    }
}

// Two groups with portafilters, a boiler, cups on top.
void espresso_machine(Kit& k, Vec3f at) {
    const int body = k.material(steel()), dark = color(k, "black plastic", {0.03f, 0.03f, 0.03f}, 0.4f),
              cup = k.material(porcelain());
    k.board(body, at, {0.72f, 0.07f, 0.5f}, 0.012f);
    k.board(body, at + Vec3f{0, 0.07f, 0.12f}, {0.7f, 0.34f, 0.22f}, 0.02f);
    k.board(body, at + Vec3f{0, 0.3f, -0.02f}, {0.72f, 0.14f, 0.5f}, 0.03f);
    for (const float sx : {-1.f, 1.f}) {
        k.rod(dark, at + Vec3f{sx * 0.17f, 0.3f, -0.14f}, at + Vec3f{sx * 0.17f, 0.22f, -0.14f}, 0.036f, 0.032f, 14);
        k.rod(dark, at + Vec3f{sx * 0.17f, 0.235f, -0.16f}, at + Vec3f{sx * 0.17f, 0.22f, -0.3f}, 0.013f, 0.016f, 8);
        k.rod(body, at + Vec3f{sx * 0.33f, 0.3f, -0.18f}, at + Vec3f{sx * 0.35f, 0.1f, -0.26f}, 0.006f, -1, 6);
    }
    const std::array<Vec2f, 2> shape{Vec2f{0.028f, 0}, {0.04f, 0.06f}};
    for (int j = 0; j < 3; ++j)
        for (int i = -3; i <= 3; ++i)
            k.add(shapes::vessel(shape, 0.004f, 10), cup,
                  at + Vec3f{0.09f * static_cast<float>(i), 0.44f, -0.16f + 0.12f * static_cast<float>(j)});
}

void till(Kit& k, Vec3f at) {
    const int dark = color(k, "till", {0.04f, 0.04f, 0.045f}, 0.4f);
    k.board(dark, at, {0.34f, 0.09f, 0.34f}, 0.008f);
    k.rod(dark, at + Vec3f{0, 0.08f, 0}, at + Vec3f{0, 0.2f, 0.02f}, 0.02f);
    Mesh lid = shapes::box({0.32f, 0.22f, 0.02f}, 0.004f), face = screen_box({0.29f, 0.19f, 0.003f});
    // It looks to -z, to who serves.
    shapes::move(shapes::turn(face, {0, 1, 0}, 180), {0, -0.095f, -0.0115f});
    for (Mesh* m : {&lid, &face}) shapes::turn(*m, {1, 0, 0}, 20);
    k.add(std::move(lid), dark, at + Vec3f{0, 0.27f, 0.02f});
    k.add(std::move(face), lit_screen(k, Shown::till, kMonitorWhite, 0.29f), at + Vec3f{0, 0.27f, 0.02f});
}

Material stone(const char* name) { return *material_named(name); }

}  // namespace

void build_cafe_counter(Kit& k) {
    const Body b = counter_body(k, {3.0f, 1.05f, 0.7f}, true, k.style.wood2);
    const float x = 0.5f * b.size.x, y = b.size.y;
    espresso_machine(k, {-x + 0.55f, y, -0.02f});
    const float wide = std::min(1.3f, b.size.x - 1.9f);
    if (wide > 0.5f) case_of(k, {x - 0.75f - 0.5f * wide, y, 0.05f}, {wide, 0.42f, 0.5f}, "pastry");
    till(k, {x - 0.35f, y, 0});
    filled_jar(k, jar_contents(k, {0.05f, 0.025f, 0.012f}), color(k, "lid", {0.5f, 0.46f, 0.38f}, 0.35f),
               {-x + 1.02f, y, 0.2f}, 0.06f, 0.22f);
    // To the left of the case: what else a guest wants to be served from.
    k.top(y, -x + 1.3f, 0, std::max(0.1f, std::min(0.2f, 0.5f * (b.size.x - 1.9f - wide))), 0.26f);
}

void build_bar_counter(Kit& k) {
    const Body b = counter_body(k, {3.2f, 1.08f, 0.62f}, true, k.style.wood2);
    const float x = 0.5f * b.size.x, y = b.size.y;
    const int brass = k.material(*material_named("brass")), dark = color(k, "tap handle", {0.03f, 0.03f, 0.03f}, 0.3f),
              clear = k.material(glass());
    // A rail for the feet, beer pumps, glasses upside down.
    k.rod(brass, {-x + 0.1f, 0.2f, 0.5f * b.size.z + 0.06f}, {x - 0.1f, 0.2f, 0.5f * b.size.z + 0.06f}, 0.02f, -1, 12);
    for (float at = -x + 0.3f; at < x - 0.2f; at += 0.9f)
        k.rod(brass, {at, 0.2f, 0.5f * b.size.z - 0.05f}, {at, 0.2f, 0.5f * b.size.z + 0.06f}, 0.014f);
    k.rod(brass, {-0.3f, y, -0.1f}, {-0.3f, y + 0.3f, -0.1f}, 0.03f, -1, 14);
    k.rod(brass, {-0.52f, y + 0.31f, -0.1f}, {-0.08f, y + 0.31f, -0.1f}, 0.032f, -1, 14);
    for (int i = 0; i < 3; ++i) {
        const float at = -0.46f + 0.16f * static_cast<float>(i);
        k.rod(dark, {at, y + 0.33f, -0.1f}, {at, y + 0.52f, -0.06f}, 0.012f, 0.02f, 10);
        k.rod(brass, {at, y + 0.3f, -0.12f}, {at, y + 0.22f, -0.18f}, 0.01f, -1, 8);
    }
    const std::array<Vec2f, 2> tumbler{Vec2f{0.03f, 0}, {0.037f, 0.13f}};
    for (int i = 0; i < 8; ++i)
        k.add(shapes::vessel(tumbler, 0.003f, 10), clear,
              {0.35f + 0.1f * static_cast<float>(i % 4), y, -0.14f + 0.1f * static_cast<float>(i / 4)});
    k.top(y, -0.65f * x, 0.05f, 0.25f * x, 0.18f);
}

void build_pastry_counter(Kit& k) {
    const Vec3f s = k.wanted({2.4f, 1.25f, 0.75f});
    const int body = k.main(k.style.wood), stone_top = k.material(stone("marble"));
    k.board(body, {0, 0, 0}, {s.x, 0.55f, s.z - 0.06f}, 0.008f);
    case_of(k, {0, 0.55f, 0}, {s.x, s.y - 0.59f, s.z - 0.02f}, "pastry");
    k.board(stone_top, {0, s.y - 0.04f, 0}, {s.x, 0.04f, s.z}, 0.006f);
    till(k, {0.5f * s.x - 0.3f, s.y, 0});
    k.piece.clearance_front_m = kBefore;
    k.top(s.y, -0.2f * s.x, 0, 0.25f * s.x, 0.25f);
}

void build_deli_counter(Kit& k) {
    const Vec3f s = k.wanted({2.6f, 1.25f, 0.8f});
    const int body = k.main(plain("white enamel", {0.7f, 0.7f, 0.68f}, 0.3f)), top = k.material(steel());
    k.board(body, {0, 0, 0}, {s.x, 0.55f, s.z - 0.06f}, 0.02f);
    k.board(color(k, "stripe", k.accent(), 0.4f), {0, 0.38f, 0.5f * s.z - 0.03f}, {s.x, 0.1f, 0.01f}, 0.002f);
    case_of(k, {0, 0.55f, 0}, {s.x, s.y - 0.59f, s.z - 0.02f}, "deli");
    k.board(top, {0, s.y - 0.04f, 0}, {s.x, 0.04f, s.z}, 0.006f);
    till(k, {0.5f * s.x - 0.3f, s.y, 0});
    k.piece.clearance_front_m = kBefore;
    k.top(s.y, -0.2f * s.x, 0, 0.25f * s.x, 0.25f);
}

void build_checkout(Kit& k) {
    const Body b = counter_body(k, {1.8f, 0.95f, 0.65f}, true, k.style.wood2);
    till(k, {0.25f * b.size.x, b.size.y, 0});
    k.top(b.size.y, -0.2f * b.size.x, 0, 0.25f * b.size.x, 0.25f);
}

// A high front with a ledge; the desk behind it is lower, with a screen.
void build_reception_desk(Kit& k) {
    const Vec3f s = k.wanted({2.6f, 1.12f, 0.85f});
    const int wood = k.main(k.style.wood), top = k.material(stone("marble")), metal = k.material(k.style.metal);
    k.board(wood, {0, 0.08f, 0.5f * s.z - 0.06f}, {s.x, s.y - 0.12f, 0.1f}, 0.006f);
    for (float x = -0.5f * s.x + 0.05f; x < 0.5f * s.x - 0.02f; x += 0.075f)
        k.board(wood, {x, 0.1f, 0.5f * s.z - 0.004f}, {0.04f, s.y - 0.18f, 0.02f}, 0.004f);
    k.board(metal, {0, 0, 0.5f * s.z - 0.07f}, {s.x - 0.04f, 0.08f, 0.06f});
    k.board(top, {0, s.y - 0.04f, 0.5f * s.z - 0.13f}, {s.x + 0.04f, 0.04f, 0.32f}, 0.006f);
    for (const float sx : {-1.f, 1.f})
        k.board(wood, {sx * (0.5f * s.x - 0.03f), 0, -0.05f}, {0.06f, s.y - 0.04f, s.z - 0.1f});
    k.board(wood, {0, 0.72f, -0.1f}, {s.x - 0.12f, 0.03f, s.z - 0.25f});
    k.merge(k.small("monitor"), {-0.2f * s.x, 0.75f, -0.05f}, 180);
    k.top(s.y, 0.15f * s.x, 0.5f * s.z - 0.13f, 0.3f * s.x, 0.12f);
    k.piece.clearance_front_m = kBefore;
}

// A long table with a cloth, covered dishes and lamps above them.
void build_buffet(Kit& k) {
    const Vec3f s = k.wanted({2.8f, 0.9f, 0.8f});
    const int cloth = k.main(plain("table cloth", {0.72f, 0.7f, 0.66f}, 0.9f)), metal = k.material(steel());
    const std::array<int, 4> food{
        color(k, "vegetables", {0.12f, 0.25f, 0.04f}, 0.6f), color(k, "pasta", {0.6f, 0.4f, 0.12f}, 0.6f),
        color(k, "stew", {0.3f, 0.08f, 0.03f}, 0.4f), color(k, "rice", {0.7f, 0.66f, 0.56f}, 0.8f)};
    k.board(cloth, {0, 0.01f, 0}, {s.x, s.y - 0.01f, s.z}, 0.012f);
    const int dishes = std::max(2, static_cast<int>((s.x - 0.2f) / 0.6f));
    for (int i = 0; i < dishes; ++i) {
        const float x = (static_cast<float>(i) + 0.5f - 0.5f * static_cast<float>(dishes)) * 0.6f;
        for (const float sx : {-1.f, 1.f}) k.board(metal, {x + sx * 0.2f, s.y, 0}, {0.02f, 0.12f, 0.3f}, 0.003f);
        k.board(metal, {x, s.y + 0.12f, 0}, {0.5f, 0.05f, 0.36f}, 0.015f);
        k.board(food[static_cast<std::size_t>(i) % 4], {x, s.y + 0.155f, 0}, {0.44f, 0.025f, 0.3f}, 0.01f);
        Mesh lid = shapes::box({0.5f, 0.02f, 0.3f}, 0.008f);
        shapes::turn(lid, {1, 0, 0}, 65);
        if (i % 2 == 0) k.add(std::move(lid), metal, {x, s.y + 0.3f, -0.24f});
    }
    k.piece.clearance_front_m = kBefore;
}

}  // namespace fastscene::furniture

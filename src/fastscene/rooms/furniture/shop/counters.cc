// Counters: of cafés, bars, bakeries, shops and receptions. One serves behind them (-z) and comes to their front.
#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "fastscene/rooms/furniture/shop/goods.h"

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

// A glass case on a counter or on the floor: shelves with what is sold, lit.
void case_of(Kit& k, Vec3f at, Vec3f s, const std::string& what) {
    const int pane = k.material(glass()), metal = k.material(k.style.metal),
              white = color(k, "shelf", {0.72f, 0.71f, 0.68f}, 0.4f),
              strip = k.material(glow("case light", {5, 4.6f, 3.8f}));
    const std::array<int, 4> pastry{
        color(k, "croissant", {0.5f, 0.27f, 0.08f}, 0.6f), color(k, "chocolate", {0.07f, 0.03f, 0.015f}, 0.4f),
        color(k, "cream", {0.72f, 0.64f, 0.48f}, 0.5f), color(k, "berry", {0.45f, 0.03f, 0.05f}, 0.35f)};
    const std::array<int, 4> deli{
        color(k, "cheese", {0.66f, 0.48f, 0.14f}, 0.5f), color(k, "ham", {0.5f, 0.16f, 0.13f}, 0.5f),
        color(k, "salami", {0.24f, 0.05f, 0.05f}, 0.6f), color(k, "olives", {0.14f, 0.16f, 0.05f}, 0.3f)};
    const auto& food = what == "deli" ? deli : pastry;
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
        for (float x = -0.5f * s.x + 0.12f; x < 0.5f * s.x - 0.08f; x += 0.15f) {
            const int kind = food[static_cast<std::size_t>(k.rng.index(4))];
            for (float z = -0.5f * s.z + 0.1f; z < 0.5f * s.z - 0.06f; z += 0.13f) {
                if (what == "deli" && k.rng.chance(0.5f))
                    block(k, kind, at + Vec3f{x, y + 0.004f, z}, {0.12f, 0.07f, 0.1f});
                else k.add(shapes::ball({0, 0, 0}, {0.055f, 0.032f, 0.045f}, 8), kind, at + Vec3f{x, y + 0.036f, z});
            }
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
    Material screen = plain("screen", {0.1f, 0.16f, 0.24f}, 0.2f);
    screen.pattern = Pattern::screen;
    screen.emission = {0.4f, 0.5f, 0.6f};
    k.board(dark, at, {0.34f, 0.09f, 0.34f}, 0.008f);
    k.rod(dark, at + Vec3f{0, 0.08f, 0}, at + Vec3f{0, 0.2f, 0.02f}, 0.02f);
    Mesh lid = shapes::box({0.32f, 0.22f, 0.02f}, 0.004f), face = shapes::box({0.29f, 0.19f, 0.003f}, 0.0005f);
    shapes::move(face, {0, 0, -0.0115f});
    for (Mesh* m : {&lid, &face}) shapes::turn(*m, {1, 0, 0}, 20);
    k.add(std::move(lid), dark, at + Vec3f{0, 0.27f, 0.02f});
    k.add(std::move(face), k.material(screen), at + Vec3f{0, 0.27f, 0.02f});
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
    const std::array<Vec2f, 4> jar{Vec2f{0.06f, 0}, {0.065f, 0.02f}, {0.065f, 0.2f}, {0.05f, 0.23f}};
    k.add(shapes::lathe(jar, 14, true), color(k, "coffee beans", {0.05f, 0.025f, 0.012f}, 0.4f),
          {-x + 1.05f, y, 0.15f});
    k.top(y, -x + 1.25f, 0.1f, 0.1f, 0.2f);
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

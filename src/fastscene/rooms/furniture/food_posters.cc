// Posters of food: the dish that the word says, on a table.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/print_designs.h"

namespace fastscene::furniture {
namespace {

constexpr std::array<Vec3f, 5> kTables{Vec3f{0.24f, 0.13f, 0.06f},
                                       {0.05f, 0.05f, 0.052f},
                                       {0.6f, 0.54f, 0.42f},
                                       {0.1f, 0.18f, 0.13f},
                                       {0.4f, 0.1f, 0.06f}};
constexpr Vec3f kChina{0.7f, 0.69f, 0.66f}, kCutlery{0.5f, 0.5f, 0.5f}, kCrust{0.46f, 0.24f, 0.08f},
    kDarkCrust{0.28f, 0.12f, 0.035f}, kCrumb{0.66f, 0.52f, 0.3f}, kTomato{0.5f, 0.05f, 0.025f},
    kCheese{0.66f, 0.46f, 0.12f}, kHerb{0.06f, 0.2f, 0.03f}, kLettuce{0.18f, 0.36f, 0.06f}, kMeat{0.13f, 0.05f, 0.025f},
    kCreamy{0.7f, 0.66f, 0.56f}, kChocolate{0.09f, 0.035f, 0.018f}, kBerry{0.46f, 0.02f, 0.05f},
    kYolk{0.72f, 0.4f, 0.03f};

// Within a circle about c.
Vec2f strewn(Random& rng, Vec2f c, float radius) {
    const float a = rng.uniform(0, 6.283f), d = radius * std::sqrt(rng.uniform());
    return c + Vec2f{std::cos(a), std::sin(a)} * d;
}
void china_plate(Patch& p, Vec2f c, float r) {
    p.disc(c + Vec2f{0.04f, -0.05f} * r, {1.04f * r, 1.04f * r}, {0.02f, 0.02f, 0.02f}, 0.4f);
    p.disc(c, {r, r}, kChina), p.disc(c, {0.74f * r, 0.74f * r}, kChina * 0.88f);
}
void beside_plate(Patch& p) {
    for (const float x : {0.07f, 0.93f}) p.line(spot(p, x, 0.25f), spot(p, x, 0.6f), 0.022f * p.w, kCutlery);
}
// A long loaf with cuts across.
void baguette(Patch& p, Vec2f a, Vec2f b, float wide) {
    p.line(a + Vec2f{2, -4}, b + Vec2f{2, -4}, wide, {0.03f, 0.02f, 0.012f});
    p.line(a, b, wide, kDarkCrust), p.line(a, b, 0.78f * wide, kCrust);
    const Vec2f way = b - a, across = Vec2f{-way.y, way.x} * (0.34f * wide / length(way));
    for (int i = 1; i < 6; ++i) {
        const Vec2f m = a + way * (static_cast<float>(i) / 6);
        p.line(m - across - way * 0.035f, m + across + way * 0.035f, 0.16f * wide, kCrumb);
    }
}

void loaves(Patch& p, Random& rng, Vec2f c, float r) {
    p.fill(c + Vec2f{-1.12f, -0.8f} * r, c + Vec2f{1.12f, 0.86f} * r, {0.02f, 0.014f, 0.01f}, 0.5f);
    p.fill(c + Vec2f{-1.15f, -0.76f} * r, c + Vec2f{1.1f, 0.9f} * r, {0.36f, 0.2f, 0.09f});
    for (int i = 0; i < 6; ++i)
        p.line(c + Vec2f{-1.13f, -0.7f + 0.28f * static_cast<float>(i)} * r,
               c + Vec2f{1.08f, -0.66f + 0.28f * static_cast<float>(i)} * r, 1.2f, {0.26f, 0.13f, 0.06f});
    baguette(p, c + Vec2f{-0.95f, 0.2f} * r, c + Vec2f{0.7f, 0.75f} * r, 0.3f * r);
    baguette(p, c + Vec2f{-0.75f, -0.1f} * r, c + Vec2f{0.95f, 0.4f} * r, 0.3f * r);
    const Vec2f loaf = c + Vec2f{0.1f, -0.32f} * r;
    p.disc(loaf, {0.62f * r, 0.46f * r}, kDarkCrust), p.disc(loaf + Vec2f{0, 0.04f} * r, {0.56f * r, 0.4f * r}, kCrust);
    for (const float side : {-1.f, 1.f})
        p.line(loaf + Vec2f{-0.3f, 0.2f * side} * r, loaf + Vec2f{0.3f, -0.14f * side} * r, 0.08f * r, kCrumb);
    for (int i = 0; i < 90; ++i) p.disc(strewn(rng, loaf, 0.44f * r), {1.2f, 1.2f}, kCreamy, 0.6f);  // flour
}
void pizza(Patch& p, Random& rng, Vec2f c, float r) {
    p.disc(c + Vec2f{0.04f, -0.05f} * r, {1.06f * r, 1.06f * r}, {0.02f, 0.02f, 0.02f}, 0.5f);
    p.disc(c, {1.04f * r, 1.04f * r}, kDarkCrust), p.disc(c, {r, r}, kCrust),
        p.disc(c, {0.88f * r, 0.88f * r}, kTomato);
    for (int i = 0; i < 60; ++i) {
        const float size = rng.uniform(0.06f, 0.16f) * r;
        p.disc(strewn(rng, c, 0.76f * r), {size, 0.8f * size}, lerp(kCheese, kCreamy, rng.uniform(0, 0.7f)), 0.9f);
    }
    for (int i = 0; i < 11; ++i) {
        const Vec2f at = strewn(rng, c, 0.72f * r);
        p.disc(at, {0.13f * r, 0.13f * r}, {0.26f, 0.02f, 0.015f}),
            p.disc(at, {0.11f * r, 0.11f * r}, {0.42f, 0.05f, 0.03f});
    }
    for (int i = 0; i < 9; ++i) p.disc(strewn(rng, c, 0.7f * r), {0.09f * r, 0.05f * r}, kHerb);
    for (int i = 0; i < 4; ++i) {
        const float a = 0.785f * static_cast<float>(i) + 0.2f;
        const Vec2f way{std::cos(a) * r, std::sin(a) * r};
        p.line(c - way, c + way, 1.4f, kDarkCrust);
    }
}
void soup(Patch& p, Random& rng, Vec2f c, float r) {
    china_plate(p, c, 1.05f * r);
    p.disc(c, {0.84f * r, 0.84f * r}, kChina * 0.6f), p.disc(c, {0.78f * r, 0.78f * r}, {0.56f, 0.2f, 0.03f});
    Vec2f last = c;
    for (int i = 1; i < 60; ++i) {  // cream, stirred in
        const float a = 0.24f * static_cast<float>(i);
        const Vec2f at = c + Vec2f{std::cos(a), std::sin(a)} * (0.0095f * static_cast<float>(i) * r);
        p.line(last, at, 0.045f * r, kCreamy);
        last = at;
    }
    for (int i = 0; i < 26; ++i) p.disc(strewn(rng, c, 0.66f * r), {0.04f * r, 0.025f * r}, kHerb);
    p.line(c + Vec2f{1.12f, -0.7f} * r, c + Vec2f{1.2f, 0.5f} * r, 0.06f * r, kCutlery);
    p.disc(c + Vec2f{1.2f, 0.62f} * r, {0.12f * r, 0.2f * r}, kCutlery);
}
void cakes(Patch& p, Random& rng, Vec2f c, float r) {
    // A cake of three layers on a stand, seen from the side.
    p.fill(c + Vec2f{-1.1f, -0.66f} * r, c + Vec2f{1.1f, -0.58f} * r, kChina);
    p.fill(c + Vec2f{-0.14f, -1.f} * r, c + Vec2f{0.14f, -0.66f} * r, kChina * 0.8f);
    p.fill(c + Vec2f{-0.5f, -1.06f} * r, c + Vec2f{0.5f, -0.98f} * r, kChina);
    for (int i = 0; i < 3; ++i) {
        const float y = -0.58f + 0.4f * static_cast<float>(i);
        p.fill(c + Vec2f{-0.86f, y} * r, c + Vec2f{0.86f, y + 0.3f} * r, kChocolate * 1.6f);
        p.fill(c + Vec2f{-0.88f, y + 0.28f} * r, c + Vec2f{0.88f, y + 0.4f} * r, kCreamy);
    }
    p.fill(c + Vec2f{-0.9f, 0.56f} * r, c + Vec2f{0.9f, 0.76f} * r, {0.66f, 0.3f, 0.34f});
    for (int i = 0; i < 9; ++i) {  // icing that runs down
        const float x = -0.8f + 0.2f * static_cast<float>(i);
        p.line(c + Vec2f{x, 0.6f} * r, c + Vec2f{x, rng.uniform(0.1f, 0.45f)} * r, 0.13f * r, {0.66f, 0.3f, 0.34f});
    }
    for (int i = 0; i < 5; ++i) {
        const Vec2f at = c + Vec2f{-0.68f + 0.34f * static_cast<float>(i), 0.86f} * r;
        p.disc(at + Vec2f{0, -0.08f} * r, {0.14f * r, 0.1f * r}, kCreamy), p.disc(at, {0.1f * r, 0.1f * r}, kBerry);
    }
}
void salad(Patch& p, Random& rng, Vec2f c, float r) {
    p.disc(c + Vec2f{0.04f, -0.05f} * r, {1.06f * r, 1.06f * r}, {0.02f, 0.02f, 0.02f}, 0.5f);
    p.disc(c, {1.04f * r, 1.04f * r}, {0.3f, 0.15f, 0.06f}), p.disc(c, {0.92f * r, 0.92f * r}, {0.18f, 0.08f, 0.03f});
    for (int i = 0; i < 90; ++i) {
        const float size = rng.uniform(0.1f, 0.2f) * r;
        p.disc(strewn(rng, c, 0.76f * r), {size, size * rng.uniform(0.5f, 1.f)},
               lerp(kLettuce, kHerb, rng.uniform()) * rng.uniform(0.7f, 1.3f));
    }
    for (int i = 0; i < 9; ++i) {
        const Vec2f at = strewn(rng, c, 0.68f * r);
        p.disc(at, {0.13f * r, 0.13f * r}, kTomato), p.disc(at, {0.085f * r, 0.085f * r}, kTomato * 1.3f);
    }
    for (int i = 0; i < 8; ++i) {
        const Vec2f at = strewn(rng, c, 0.7f * r);
        p.disc(at, {0.12f * r, 0.11f * r}, kHerb * 1.3f), p.disc(at, {0.1f * r, 0.09f * r}, {0.5f, 0.6f, 0.34f});
    }
    for (int i = 0; i < 6; ++i) {
        const Vec2f at = strewn(rng, c, 0.65f * r);
        p.fill(at, at + Vec2f{0.14f, 0.12f} * r, kCreamy);
    }
}
void burger(Patch& p, Random& rng, Vec2f c, float r) {
    const auto layer = [&](float y0, float y1, float half, Vec3f color) {
        p.fill(c + Vec2f{-half, y0} * r, c + Vec2f{half, y1} * r, color);
        for (const float side : {-half, half})
            p.disc(c + Vec2f{side, 0.5f * (y0 + y1)} * r, {0.5f * (y1 - y0) * r, 0.5f * (y1 - y0) * r}, color);
    };
    p.disc(c + Vec2f{0, -0.86f} * r, {1.15f * r, 0.2f * r}, kChina);
    layer(-0.8f, -0.5f, 0.72f, kCrust);
    layer(-0.5f, -0.22f, 0.8f, kMeat);
    for (float x = -0.8f; x < 0.8f; x += 0.4f)
        for (float y = 0; y < 0.26f; y += 0.015f)
            p.fill(c + Vec2f{x + 0.7f * y, -0.22f - y} * r, c + Vec2f{x + 0.4f - 0.7f * y, -0.2f - y} * r, kCheese);
    layer(-0.22f, -0.12f, 0.8f, kCheese), layer(-0.12f, 0.02f, 0.76f, kTomato);
    for (int i = 0; i < 13; ++i)
        p.disc(c + Vec2f{-0.84f + 0.14f * static_cast<float>(i), 0.07f + 0.04f * static_cast<float>(i % 2)} * r,
               {0.12f * r, 0.09f * r}, kLettuce);
    for (float y = 0; y < 0.62f; y += 0.01f) {
        const float half = 0.86f * std::sqrt(std::max(0.f, 1 - y * y / 0.39f));
        p.fill(c + Vec2f{-half, 0.14f + y} * r, c + Vec2f{half, 0.155f + y} * r,
               lerp(kDarkCrust * 1.5f, kCrust * 1.15f, y / 0.62f));
    }
    for (int i = 0; i < 26; ++i) {
        const float a = rng.uniform(0.5f, 2.6f), d = rng.uniform(0.3f, 0.9f);
        p.disc(c + Vec2f{0.8f * d * std::cos(a), 0.18f + 0.56f * d * std::sin(a)} * r, {0.03f * r, 0.018f * r},
               kCreamy);
    }
}
void breakfast(Patch& p, Random& rng, Vec2f c, float r) {
    china_plate(p, c, r);
    for (const Vec2f at : {Vec2f{-0.3f, 0.16f}, {0.24f, 0.26f}}) {
        for (int i = 0; i < 8; ++i) p.disc(strewn(rng, c + at * r, 0.14f * r), {0.2f * r, 0.17f * r}, kCreamy * 1.06f);
        p.disc(c + at * r, {0.12f * r, 0.12f * r}, kYolk);
    }
    for (int i = 0; i < 3; ++i) {
        const Vec2f from = c + Vec2f{-0.5f, -0.16f - 0.15f * static_cast<float>(i)} * r;
        p.line(from, from + Vec2f{0.72f, 0.1f} * r, 0.1f * r, {0.3f, 0.05f, 0.03f});
        p.line(from, from + Vec2f{0.72f, 0.1f} * r, 0.03f * r, {0.6f, 0.36f, 0.28f});
    }
    p.fill(c + Vec2f{0.26f, -0.46f} * r, c + Vec2f{0.64f, 0.04f} * r, kDarkCrust),
        p.fill(c + Vec2f{0.29f, -0.43f} * r, c + Vec2f{0.61f, 0.01f} * r, kCrumb);
    const Vec2f cup = c + Vec2f{0.82f, 0.86f} * r;
    p.disc(cup, {0.36f * r, 0.36f * r}, kChina), p.disc(cup, {0.25f * r, 0.25f * r}, kChina * 0.7f),
        p.disc(cup, {0.22f * r, 0.22f * r}, kChocolate);
}
void pasta(Patch& p, Random& rng, Vec2f c, float r) {
    china_plate(p, c, r);
    for (int i = 0; i < 60; ++i) {
        const Vec2f middle = strewn(rng, c, 0.2f * r);
        const float turn = rng.uniform(0.2f, 0.46f) * r, from = rng.uniform(0, 6.283f);
        Vec2f last = middle + Vec2f{std::cos(from), std::sin(from)} * turn;
        for (int k = 1; k <= 8; ++k) {
            const float a = from + 0.3f * static_cast<float>(k);
            const Vec2f at = middle + Vec2f{std::cos(a), std::sin(a)} * turn;
            p.line(last, at, 0.04f * r, lerp(kCheese, kCrumb, rng.uniform()) * rng.uniform(0.8f, 1.1f));
            last = at;
        }
    }
    for (int i = 0; i < 22; ++i)
        p.disc(strewn(rng, c, 0.28f * r), {0.1f * r, 0.08f * r}, lerp(kTomato, kMeat, rng.uniform(0, 0.6f)));
    for (const Vec2f leaf : {Vec2f{-0.06f, 0.04f}, {0.08f, 0.07f}})
        p.disc(c + leaf * r, {0.11f * r, 0.07f * r}, kHerb * 1.3f);
    beside_plate(p);
}

void rolls(Patch& p, Random& rng, Vec2f c, float r) {
    p.disc(c + Vec2f{0.03f, -0.06f} * r, {1.1f * r, 0.86f * r}, {0.02f, 0.015f, 0.01f}, 0.5f);
    p.disc(c, {1.1f * r, 0.84f * r}, {0.26f, 0.14f, 0.06f}), p.disc(c, {1.f * r, 0.74f * r}, {0.14f, 0.07f, 0.03f});
    for (const Vec2f at :
         {Vec2f{-0.56f, 0.3f}, {0.02f, 0.4f}, {0.58f, 0.28f}, {-0.36f, -0.08f}, {0.32f, -0.06f}, {-0.02f, -0.42f}}) {
        const Vec2f o = c + at * r;
        p.disc(o + Vec2f{0.02f, -0.04f} * r, {0.35f * r, 0.29f * r}, kDarkCrust * 0.6f);
        p.disc(o, {0.33f * r, 0.27f * r}, kDarkCrust), p.disc(o + Vec2f{0, 0.03f} * r, {0.28f * r, 0.22f * r}, kCrust);
        p.line(o + Vec2f{-0.2f, 0.02f} * r, o + Vec2f{0.2f, 0.06f} * r, 0.07f * r, kCrumb);
        for (int i = 0; i < 12; ++i) p.disc(strewn(rng, o, 0.22f * r), {1.3f, 1.1f}, kCreamy, 0.8f);
    }
}
void pretzel(Patch& p, Random& rng, Vec2f c, float r) {
    // From one end, which lies on the lower bow, through the crossing, all around and back through it.
    constexpr std::array<Vec2f, 15> kKnot{Vec2f{-0.46f, -0.52f}, {-0.22f, -0.16f}, {0.f, 0.1f},     {0.3f, 0.5f},
                                          {0.66f, 0.62f},        {0.94f, 0.3f},    {0.84f, -0.24f}, {0.f, -0.68f},
                                          {-0.84f, -0.24f},      {-0.94f, 0.3f},   {-0.66f, 0.62f}, {-0.3f, 0.5f},
                                          {0.f, 0.1f},           {0.22f, -0.16f},  {0.46f, -0.52f}};
    std::vector<Vec2f> path = shapes::curve(kKnot, 6);
    for (Vec2f& at : path) at = c + at * r;
    for (const auto& [wide, color] : {std::pair{0.34f, kDarkCrust * 0.5f}, {0.29f, kDarkCrust}, {0.18f, kCrust}})
        for (std::size_t i = 0; i + 1 < path.size(); ++i) p.line(path[i], path[i + 1], wide * r, color);
    for (int i = 0; i < 46; ++i) {
        const Vec2f at = strewn(rng, path[static_cast<std::size_t>(rng.index(static_cast<int>(path.size())))],
                                0.09f * r);
        p.fill(at, at + Vec2f{2.6f, 2.2f}, kCreamy);
    }
}

struct Dish {
    std::string_view word;
    void (*draw)(Patch&, Random&, Vec2f, float);
};
constexpr std::array<Dish, 8> kDishes{{{"FRESH BREAD", loaves},
                                       {"PIZZA", pizza},
                                       {"SOUP OF THE DAY", soup},
                                       {"CAKES", cakes},
                                       {"SALADS", salad},
                                       {"BURGER", burger},
                                       {"BREAKFAST", breakfast},
                                       {"PASTA", pasta}}};

constexpr std::array<Dish, 4> kBaked{
    {{"FRESH BREAD", loaves}, {"CAKES", cakes}, {"ROLLS", rolls}, {"PRETZELS", pretzel}}};

void dish_poster(Patch& p, Random& rng, std::span<const Dish> dishes) {
    const Vec3f ground = varied(rng, one_of(rng, Colors(kTables))),
                ink = luminance(ground) > 0.3f ? kPrintBlack : kPrintWhite;
    p.fill(ground);
    for (int i = 0; i < 9; ++i)
        p.fill({0, p.h * static_cast<float>(i) / 9}, {p.w, p.h * static_cast<float>(i) / 9 + 1.5f}, ground * 0.7f);
    const Dish& dish = one_of(rng, dishes);
    dish.draw(p, rng, spot(p, 0.5f, 0.43f), 0.36f * p.w);
    p.title(dish.word, 0.5f * p.w, 0.82f * p.h, 0.86f * p.w, 0.1f * p.h, ink);
    small_print(p, rng, spot(p, 0.25f, 0.04f), spot(p, 0.75f, 0.1f), 0.012f * p.h, ink);
}

}  // namespace

void food_poster(Patch& p, Random& rng, const PrintStyle&) { dish_poster(p, rng, kDishes); }
void bakery_poster(Patch& p, Random& rng, const PrintStyle&) { dish_poster(p, rng, kBaked); }

}  // namespace fastscene::furniture

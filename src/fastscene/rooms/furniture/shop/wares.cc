// Clothes, shoes, hats, bags, jewelry and gifts, one by one.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/profiles.h"
#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {
namespace {

Material dyed(const Kit& k, Vec3f albedo) { return tinted(k.style.fabric, albedo); }

void ware_ball(Kit& k, int material, Vec3f center, Vec3f radii, int sides = 12) {
    k.add(shapes::ball(center, radii, sides), material);
}

void sneaker(Kit& k, int upper, int sole, int lace, int trim, Vec3f at) {
    std::vector<Vec2f> foot;
    for (int i = 0; i < 20; ++i) {
        const float a = kTau * static_cast<float>(i) / 20.f, z = std::sin(a);
        foot.push_back({(0.044f - 0.008f * std::abs(z - 0.3f)) * std::cos(a), 0.14f * z});
    }
    k.add(shapes::prism(foot, 0, 0.028f, 0.005f), sole, at);
    ware_ball(k, upper, at + Vec3f{0, 0.035f, 0.075f}, {0.041f, 0.036f, 0.064f}),
        ware_ball(k, upper, at + Vec3f{0, 0.06f, -0.06f}, {0.039f, 0.05f, 0.075f});
    ware_ball(k, sole, at + Vec3f{0, 0.028f, 0.115f}, {0.034f, 0.016f, 0.027f}, 10),
        ware_ball(k, trim, at + Vec3f{0, 0.07f, -0.128f}, {0.017f, 0.034f, 0.01f}, 8);
    k.rod(trim, at + Vec3f{0, 0.106f, -0.075f}, at + Vec3f{0, 0.111f, -0.075f}, 0.026f, -1, 12);
    Mesh tongue = shapes::box({0.038f, 0.008f, 0.1f}, 0.003f);
    shapes::turn(tongue, {1, 0, 0}, 35);
    k.add(std::move(tongue), lace, at + Vec3f{0, 0.093f, 0.008f});
    for (int i = 0; i < 4; ++i)
        k.rod(lace,
              at + Vec3f{-0.025f, 0.072f + 0.012f * static_cast<float>(i), 0.052f - 0.019f * static_cast<float>(i)},
              at + Vec3f{0.025f, 0.072f + 0.012f * static_cast<float>(i), 0.052f - 0.019f * static_cast<float>(i)},
              0.004f, -1, 5);
}

void boot(Kit& k, int upper, int sole, Vec3f at) {
    block(k, sole, at + Vec3f{0, 0.012f, 0.03f}, {0.08f, 0.014f, 0.2f}),
        block(k, sole, at + Vec3f{0, 0, -0.075f}, {0.07f, 0.03f, 0.07f});
    ware_ball(k, sole, at + Vec3f{0, 0.018f, 0.1f}, {0.042f, 0.014f, 0.045f}, 10),
        ware_ball(k, upper, at + Vec3f{0, 0.05f, 0.06f}, {0.041f, 0.04f, 0.085f}),
        ware_ball(k, upper, at + Vec3f{0, 0.06f, -0.05f}, {0.042f, 0.055f, 0.065f});
    const std::array<Vec2f, 4> shaft{Vec2f{0.046f, 0.06f}, {0.044f, 0.12f}, {0.05f, 0.22f}, {0.054f, 0.28f}};
    k.add(shapes::vessel(shaft, 0.004f, 16), upper, at + Vec3f{0, 0, -0.05f}),
        k.add(hoop(0.053f, 0.006f, 16), sole, at + Vec3f{0, 0.28f, -0.05f});
}

void pump(Kit& k, int upper, int sole, Vec3f at) {
    const std::array<Vec2f, 4> slope{Vec2f{-0.11f, 0.088f}, {0.05f, 0.002f}, {0.05f, 0.012f}, {-0.11f, 0.1f}},
        tip{Vec2f{0.045f, 0.002f}, {0.13f, 0.002f}, {0.13f, 0.012f}, {0.045f, 0.012f}};
    k.add(side_prism(slope, -0.028f, 0.028f, 0.003f), sole, at);
    k.add(side_prism(tip, -0.028f, 0.028f, 0.003f), sole, at);
    ware_ball(k, upper, at + Vec3f{0, 0.022f, 0.09f}, {0.034f, 0.024f, 0.052f}),
        ware_ball(k, upper, at + Vec3f{0, 0.112f, -0.092f}, {0.028f, 0.036f, 0.028f});
    for (const float sx : {-1.f, 1.f})
        k.rod(upper, at + Vec3f{sx * 0.028f, 0.028f, 0.06f}, at + Vec3f{sx * 0.024f, 0.118f, -0.09f}, 0.009f, 0.014f,
              6);
    k.rod(upper, at + Vec3f{0, 0, -0.1f}, at + Vec3f{0, 0.094f, -0.098f}, 0.005f, 0.014f, 8);
}

// A garment on a hanger, seen from the front; its collar at y = 0.
void garment(Kit& k, int cloth, int trim, Vec3f at, float length, float sleeve, float turn) {
    const auto put = [&](Mesh m, int mat) {
        shapes::turn(m, {0, 1, 0}, turn);
        k.add(std::move(m), mat, at);
    };
    const auto half = [&](float t) { return 0.2f + 0.025f * t; };
    put(shapes::slab(8, 8, 0.05f,
                     [&](float u, float v) {
                         const float x = (2 * u - 1) * half(1 - v) * (v > 0.9f ? 1.f - 3.f * (v - 0.9f) : 1.f),
                                     drop = v > 0.85f ? 0.5f * std::abs(2 * u - 1) * (v - 0.85f) : 0.f;
                         return Vec3f{x, -length * (1 - v) - drop,
                                      0.02f + 0.022f * std::cos(kPi * (u - 0.5f)) +
                                          0.008f * std::sin(17.f * u + 3.f * v) * (1 - v)};
                     }),
        cloth);
    for (const float sx : {-1.f, 1.f})
        put(shapes::rod({sx * 0.175f, -0.055f, 0.01f}, {sx * (0.21f + 0.18f * sleeve), -0.08f - 0.5f * sleeve, 0.015f},
                        0.058f, 0.042f, 9),
            cloth),
            put(shapes::rod({sx * 0.05f, 0.012f, 0.03f}, {sx * 0.005f, -0.07f, 0.046f}, 0.014f, 0.006f, 6), trim);
}

}  // namespace

// Wrapped, with a ribbon and a bow.
void build_gift(Kit& k) {
    const int paper = k.main(plain("wrapping paper", k.accent(), 0.4f)),
              ribbon = color(k, "ribbon", k.rng.chance(0.5f) ? Vec3f{0.5f, 0.03f, 0.04f} : Vec3f{0.62f, 0.45f, 0.12f},
                             0.3f);
    const Vec3f s{k.rng.uniform(0.2f, 0.3f), k.rng.uniform(0.12f, 0.24f), k.rng.uniform(0.18f, 0.26f)};
    k.board(paper, {}, s, 0.004f), block(k, paper, {0, s.y - 0.045f, 0}, {s.x + 0.008f, 0.048f, s.z + 0.008f});
    block(k, ribbon, {0, -0.001f, 0}, {0.03f, s.y + 0.006f, s.z + 0.012f}),
        block(k, ribbon, {0, -0.001f, 0}, {s.x + 0.012f, s.y + 0.006f, 0.03f});
    for (int i = 0; i < 4; ++i) {
        Mesh loop = hoop(0.032f, 0.014f, 14);
        shapes::turn(loop, {1, 0, 0}, 90), shapes::move(loop, {0.04f, 0, 0}), shapes::turn(loop, {0, 0, 1}, 28),
            shapes::turn(loop, {0, 1, 0}, 45.f + 90.f * static_cast<float>(i));
        k.add(std::move(loop), ribbon, {0, s.y + 0.014f, 0});
    }
    ware_ball(k, ribbon, {0, s.y + 0.02f, 0}, {0.02f, 0.018f, 0.02f}, 10);
    on_surface(k);
}

// A bunch on strings, held by a weight.
void build_balloons(Kit& k) {
    static constexpr std::array<Vec3f, 6> kColors{Vec3f{0.55f, 0.03f, 0.04f}, {0.04f, 0.2f, 0.55f},
                                                  {0.68f, 0.48f, 0.03f},      {0.06f, 0.35f, 0.12f},
                                                  {0.6f, 0.2f, 0.35f},        {0.66f, 0.64f, 0.6f}};
    const int first = k.main(plain("balloon", kColors[static_cast<std::size_t>(k.rng.index(6))], 0.18f)),
              string = color(k, "string", {0.6f, 0.58f, 0.54f}, 0.8f),
              weight = color(k, "weight", {0.5f, 0.4f, 0.12f}, 0.3f);
    const bool one_color = k.request.color || !k.request.color_name.empty();
    k.board(weight, {0, 0, 0}, {0.1f, 0.07f, 0.1f}, 0.008f);
    for (int i = 0; i < 7; ++i) {
        const float a = kTau * static_cast<float>(i) / 6.f, out = i == 6 ? 0.f : 0.22f,
                    y = i == 6 ? 1.95f : 1.52f + 0.2f * static_cast<float>(i % 3);
        const Vec3f foot{out * std::cos(a), y, out * std::sin(a)};
        const int skin = one_color || i == 0
                             ? first
                             : color(k, "balloon", kColors[static_cast<std::size_t>(k.rng.index(6))], 0.18f);
        const std::array<Vec2f, 7> p{Vec2f{0.008f, -0.01f}, {0.012f, 0.006f}, {0.07f, 0.08f}, {0.125f, 0.18f},
                                     {0.12f, 0.26f},        {0.06f, 0.315f},  {0, 0.325f}};
        k.add(shapes::lathe(shapes::curve(p, 1), 14, true), skin, foot),
            k.rod(skin, foot - Vec3f{0, 0.022f, 0}, foot, 0.016f, 0.006f, 8);
        const std::array<Vec3f, 3> line{Vec3f{0, 0.07f, 0}, {0.35f * foot.x, 0.55f * y, 0.35f * foot.z}, foot};
        k.add(shapes::tube(line, 0.002f, 4), string);
    }
}

void build_handbag(Kit& k) {
    Material hide = k.style.leather;
    if (k.request.material.empty()) {
        static constexpr std::array<Vec3f, 4> kHides{
            Vec3f{0.24f, 0.09f, 0.035f}, {0.02f, 0.02f, 0.022f}, {0.35f, 0.04f, 0.05f}, {0.45f, 0.34f, 0.22f}};
        hide = tinted(hide, kHides[static_cast<std::size_t>(k.rng.index(4))]);
    }
    const int body = k.main(hide), gold = k.material(*material_named("brass"));
    const std::array<Vec2f, 6> side{Vec2f{-0.07f, 0.0f}, {0.07f, 0.0f},   {0.072f, 0.06f},
                                    {0.03f, 0.23f},      {-0.03f, 0.23f}, {-0.072f, 0.06f}};
    Mesh bag = side_prism(side, -0.16f, 0.16f, 0.014f);
    for (Vec3f& p : bag.positions) p.x *= 1.f - 0.5f * p.y;
    k.add(std::move(bag), body);
    Mesh flap = shapes::box({0.27f, 0.1f, 0.012f}, 0.005f);
    shapes::turn(flap, {1, 0, 0}, -14);
    k.add(std::move(flap), body, {0, 0.18f, 0.05f}),
        k.board(gold, {0, 0.115f, 0.066f}, {0.04f, 0.028f, 0.012f}, 0.003f);
    for (const float z : {-0.03f, 0.03f}) {
        std::vector<Vec3f> bow;
        for (int i = 0; i <= 10; ++i) {
            const float a = kPi * static_cast<float>(i) / 10.f;
            bow.push_back({0.085f * std::cos(a), 0.22f + 0.12f * std::sin(a), z});
        }
        k.add(shapes::tube(bow, 0.008f, 8), body);
        for (const float sx : {-1.f, 1.f}) k.add(front_ring(0.012f, 0.004f, 12), gold, {sx * 0.085f, 0.22f, z});
    }
    on_surface(k);
}

// A felt hat: a dented crown, a brim that rises at its sides, a band.
void build_hat(Kit& k) {
    static constexpr std::array<Vec3f, 4> kFelts{
        Vec3f{0.2f, 0.12f, 0.06f}, {0.035f, 0.035f, 0.038f}, {0.35f, 0.3f, 0.24f}, {0.5f, 0.4f, 0.22f}};
    const int felt = k.main(plain("felt", kFelts[static_cast<std::size_t>(k.rng.index(4))], 0.95f)),
              band = color(k, "hat band", {0.03f, 0.02f, 0.018f}, 0.5f);
    const std::array<Vec2f, 6> brim{Vec2f{0.09f, 0.012f}, {0.15f, 0.004f}, {0.158f, 0.006f},
                                    {0.158f, 0.009f},     {0.12f, 0.012f}, {0.092f, 0.02f}},
        crown{Vec2f{0.094f, 0.008f}, {0.092f, 0.06f}, {0.082f, 0.11f}, {0.06f, 0.128f}, {0.03f, 0.118f}, {0, 0.108f}},
        strip{Vec2f{0.096f, 0.014f}, {0.0965f, 0.018f}, {0.0955f, 0.04f},
              {0.0945f, 0.044f},     {0.094f, 0.044f},  {0.09f, 0.044f}};
    const auto shaped = [&](std::span<const Vec2f> p, int mat, bool smooth) {
        Mesh m = shapes::lathe(p, 30, smooth);
        for (Vec3f& v : m.positions) {
            v.y += 1.6f * v.x * v.x * (std::hypot(v.x, v.z) > 0.11f ? 1.f : 0.f) -
                   (v.y > 0.07f ? 0.16f * (v.y - 0.07f) * (v.z > 0 ? 3.f : 0.f) : 0.f);
            v.z *= 1.14f;
        }
        k.add(std::move(m), mat);
    };
    shaped(brim, felt, false), shaped(crown, felt, true), shaped(strip, band, false);
    on_surface(k);
}

// A pair: trainers, boots or pumps.
void build_shoes(Kit& k) {
    static constexpr std::array<Vec3f, 6> kLeathers{Vec3f{0.62f, 0.6f, 0.56f}, {0.03f, 0.03f, 0.032f},
                                                    {0.2f, 0.09f, 0.035f},     {0.45f, 0.04f, 0.04f},
                                                    {0.05f, 0.1f, 0.26f},      {0.3f, 0.17f, 0.08f}};
    const std::string& form = k.request.pattern;
    const int kind = form == "boots" ? 1 : form == "heels" ? 2 : form == "sneakers" ? 0 : k.rng.index(3);
    const int upper = k.main(
                  plain("shoe leather",
                        kLeathers[static_cast<std::size_t>(kind == 1 ? 1 + k.rng.index(2) : k.rng.index(6))], 0.35f),
                  false),
              sole = color(k, "sole", kind == 0 ? Vec3f{0.7f, 0.69f, 0.66f} : Vec3f{0.03f, 0.02f, 0.016f}, 0.7f),
              lace = color(k, "lace", {0.72f, 0.71f, 0.68f}, 0.9f), trim = color(k, "trim", k.accent(), 0.5f);
    for (const float sx : {-1.f, 1.f}) {
        const Vec3f at{sx * 0.06f, 0, sx * 0.012f};
        if (kind == 0) sneaker(k, upper, sole, lace, trim, at);
        else if (kind == 1) boot(k, upper, sole, at);
        else pump(k, upper, sole, at);
    }
    on_surface(k);
}

// Sweaters, folded, one on the other.
void build_folded_clothes(Kit& k) {
    const int first = k.main(dyed(k, k.accent()));
    const int count = 3 + k.rng.index(3);
    const bool one_color = k.request.color || !k.request.color_name.empty();
    float y = 0;
    for (int i = 0; i < count; ++i) {
        const int cloth = one_color || i == 0
                              ? first
                              : k.material(dyed(k, k.rng.chance(0.4f)
                                                       ? Vec3f{0.6f, 0.57f, 0.5f} * k.rng.uniform(0.3f, 1.f)
                                                       : k.accent()));
        const float h = k.rng.uniform(0.038f, 0.052f), w = k.rng.uniform(0.29f, 0.31f);
        k.board(cloth, {k.rng.uniform(-0.006f, 0.006f), y, k.rng.uniform(-0.006f, 0.006f)}, {w, 0.55f * h, 0.26f},
                0.011f),
            k.board(cloth, {k.rng.uniform(-0.006f, 0.006f), y + 0.45f * h, 0.003f}, {w - 0.006f, 0.55f * h, 0.252f},
                    0.011f);
        y += h;
    }
    on_surface(k);
}

// Shirts and jackets on hangers along a rail at the wall, their fronts to the room.
void build_hung_clothes(Kit& k) {
    const Vec3f s = k.wanted({1.5f, 1.0f, 0.36f});
    const int metal = k.main(steel(), false), wood = k.material(materials::timber("natural", 0.5f)),
              pale = k.material(dyed(k, {0.66f, 0.64f, 0.6f}));
    k.rod(metal, {-0.5f * s.x, s.y - 0.04f, 0.2f}, {0.5f * s.x, s.y - 0.04f, 0.2f}, 0.014f, -1, 10);
    for (const float sx : {-1.f, 1.f})
        k.rod(metal, {sx * (0.5f * s.x - 0.08f), s.y - 0.04f, 0}, {sx * (0.5f * s.x - 0.08f), s.y - 0.04f, 0.2f},
              0.012f, -1, 8),
            k.rod(metal, {sx * (0.5f * s.x - 0.08f), s.y - 0.04f, 0}, {sx * (0.5f * s.x - 0.08f), s.y - 0.04f, 0.008f},
                  0.035f, -1, 12);
    const int count = std::max(2, static_cast<int>(s.x / 0.26f));
    for (int i = 0; i < count; ++i) {
        const float x = (s.x - 0.5f) * (count > 1 ? static_cast<float>(i) / static_cast<float>(count - 1) - 0.5f : 0.f),
                    turn = i + 1 == count ? -18.f : 48.f;
        const Vec3f at{x, s.y - 0.15f, 0.19f};
        const auto put = [&](Mesh m, int mat) {
            shapes::turn(m, {0, 1, 0}, turn);
            k.add(std::move(m), mat, at);
        };
        for (const float sx : {-1.f, 1.f})
            put(shapes::rod({0, 0.03f, 0}, {sx * 0.19f, -0.035f, 0}, 0.009f, 0.007f, 6), wood);
        put(shapes::rod({0, 0.03f, 0}, {0, 0.12f, 0}, 0.003f, 0.003f, 5), metal);
        const int cloth = k.material(dyed(k, k.request.color ? *k.request.color
                                             : k.request.color_name.empty()
                                                 ? k.accent()
                                                 : color_named(k.request.color_name).value_or(k.accent())));
        garment(k, cloth, pale, at, k.rng.uniform(0.6f, 0.78f) * (s.y - 0.15f), k.rng.chance(0.6f) ? 1.f : 0.35f, turn);
    }
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 1.0f;
}

// A bust of velvet with a necklace.
void build_necklace_bust(Kit& k) {
    const int velvet = k.main(
                  plain("velvet", k.rng.chance(0.5f) ? Vec3f{0.02f, 0.02f, 0.024f} : Vec3f{0.5f, 0.44f, 0.34f}, 0.95f)),
              gold = k.material(*material_named("brass")),
              stone = color(k, "stone", k.rng.chance(0.5f) ? Vec3f{0.03f, 0.2f, 0.12f} : Vec3f{0.3f, 0.01f, 0.03f},
                            0.05f);
    const std::array<Vec2f, 8> p{Vec2f{0.075f, 0}, {0.075f, 0.01f}, {0.085f, 0.04f}, {0.1f, 0.1f},
                                 {0.085f, 0.145f}, {0.04f, 0.175f}, {0.032f, 0.22f}, {0, 0.226f}};
    Mesh bust = shapes::lathe(shapes::curve(p, 2), 24, true);
    for (Vec3f& v : bust.positions) v.z *= 0.6f;
    for (Vec3f& n : bust.normals) n = normalize(Vec3f{n.x, n.y, n.z / 0.6f});
    k.add(std::move(bust), velvet);
    for (int i = 0; i <= 22; ++i) {
        const float t = static_cast<float>(i) / 22.f, a = kPi * (t - 0.5f), x = 0.056f * std::sin(a),
                    y = 0.16f - 0.072f * std::cos(a);
        const float r = std::lerp(0.064f, 0.1f, std::clamp((0.165f - y) / 0.065f, 0.f, 1.f)),
                    z = 0.6f * std::sqrt(std::max(0.f, r * r - x * x));
        k.add(shapes::ball({x, y, z + 0.003f}, {0.0042f, 0.0042f, 0.0042f}, 6), gold);
    }
    k.add(shapes::ball({0, 0.076f, 0.064f}, {0.009f, 0.013f, 0.007f}, 10), stone);
    on_surface(k);
}

// A tray of velvet with rows of rings.
void build_ring(Kit& k) {
    static constexpr std::array<Vec3f, 4> kStones{
        Vec3f{0.7f, 0.74f, 0.78f}, {0.35f, 0.01f, 0.03f}, {0.02f, 0.22f, 0.1f}, {0.03f, 0.06f, 0.4f}};
    const int velvet = k.main(plain(
                  "velvet", k.rng.chance(0.5f) ? Vec3f{0.025f, 0.025f, 0.03f} : Vec3f{0.2f, 0.02f, 0.035f}, 0.95f)),
              gold = k.material(*material_named("brass")), silver = k.material(steel()),
              wood = k.material(k.style.wood2);
    k.board(wood, {}, {0.24f, 0.02f, 0.17f}, 0.004f);
    for (int row = 0; row < 3; ++row) {
        const float z = -0.048f + 0.048f * static_cast<float>(row);
        k.rod(velvet, {-0.105f, 0.018f, z}, {0.105f, 0.018f, z}, 0.019f, -1, 10);
        for (int i = 0; i < 6; ++i) {
            const Vec3f at{-0.085f + 0.034f * static_cast<float>(i), 0.038f, z};
            k.add(front_ring(0.009f, 0.0022f, 12), k.rng.chance(0.6f) ? gold : silver, at);
            k.add(shapes::ball(at + Vec3f{0, 0.012f, 0}, {0.004f, 0.0045f, 0.004f}, 6),
                  color(k, "stone", kStones[static_cast<std::size_t>(k.rng.index(4))], 0.03f));
        }
    }
    on_surface(k);
}

// A cylinder of metal with two umbrellas and a cane.
void build_umbrella(Kit& k) {
    static constexpr std::array<Vec3f, 3> kCloths{
        Vec3f{0.025f, 0.025f, 0.028f}, {0.3f, 0.03f, 0.04f}, {0.04f, 0.09f, 0.2f}};
    const int body = k.main(k.style.metal), wood = k.material(materials::timber("walnut", 0.4f)),
              metal = k.material(steel()), inner = color(k, "inside of a stand", {0.02f, 0.02f, 0.02f}, 0.9f);
    const std::array<Vec2f, 3> side{Vec2f{0.115f, 0}, {0.115f, 0.02f}, {0.115f, 0.5f}};
    k.add(shapes::vessel(side, 0.004f, 28), body), k.add(hoop(0.116f, 0.01f, 28), body, {0, 0.5f, 0}),
        k.add(hoop(0.118f, 0.01f, 28), body, {0, 0.02f, 0});
    k.rod(inner, {0, 0.008f, 0}, {0, 0.02f, 0}, 0.1f, -1, 20);
    for (int i = 0; i < 3; ++i) {
        const float a = 2.1f * static_cast<float>(i) + 0.4f;
        const Vec3f foot = around(a) * -0.05f + Vec3f{0, 0.03f, 0},
                    dir = normalize(around(a) * 0.16f + Vec3f{0, 0.9f, 0});
        if (i < 2) {
            const int cloth = color(k, "umbrella cloth", kCloths[static_cast<std::size_t>(k.rng.index(3))], 0.8f);
            k.rod(metal, foot, foot + dir * 0.1f, 0.004f, -1, 6),
                k.rod(cloth, foot + dir * 0.08f, foot + dir * 0.62f, 0.014f, 0.036f, 9),
                k.rod(cloth, foot + dir * 0.62f, foot + dir * 0.68f, 0.036f, 0.014f, 9);
        }
        k.rod(i < 2 ? metal : wood, foot, foot + dir * 0.8f, i < 2 ? 0.006f : 0.011f, -1, 8);
        const Vec3f side_way = around(a + 1.2f);
        std::vector<Vec3f> crook{foot + dir * 0.74f};
        for (int c = 0; c <= 8; ++c) {
            const float t = kPi * static_cast<float>(c) / 8.f;
            crook.push_back(foot + dir * (0.84f + 0.05f * std::sin(t)) + side_way * (0.05f - 0.05f * std::cos(t)));
        }
        k.add(shapes::tube(crook, 0.011f, 8), wood);
    }
}

}  // namespace fastscene::furniture

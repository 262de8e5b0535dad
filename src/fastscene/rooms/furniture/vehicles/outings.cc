// For outings: a motorbike, a boat, a board for waves, skis, a tent, a parasol — and a snowman.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {

// On its side stand, facing +x.
void build_motorbike(Kit& k) {
    const int lacquer = k.main(plain("motorbike lacquer", {0.5f, 0.03f, 0.03f}, 0.12f)), chrome = k.material(steel()),
              tire = color(k, "tire", {0.025f, 0.025f, 0.025f}, 0.85f),
              dark = color(k, "engine", {0.09f, 0.09f, 0.095f}, 0.4f),
              leather = color(k, "saddle", {0.03f, 0.025f, 0.022f}, 0.45f),
              lamp = color(k, "headlight", {0.75f, 0.74f, 0.68f}, 0.05f),
              red = color(k, "rear light", {0.6f, 0.02f, 0.02f}, 0.1f);
    for (const float x : {-0.7f, 0.72f}) {
        const Vec3f c{x, 0.32f, 0};
        Mesh ring = shapes::ring(0.26f, 0.06f, 28), rim = shapes::ring(0.2f, 0.018f, 24);
        for (Mesh* m : {&ring, &rim}) shapes::turn(*m, {1, 0, 0}, 90);
        k.add(std::move(ring), tire, c), k.add(std::move(rim), chrome, c),
            k.rod(chrome, c - Vec3f{0, 0, 0.06f}, c + Vec3f{0, 0, 0.06f}, 0.045f, -1, 12);
        for (int i = 0; i < 14; ++i) {
            const float a = kTau * static_cast<float>(i) / 14;
            k.add(shapes::tube(
                      std::vector<Vec3f>{c + Vec3f{0.04f * std::cos(a), 0.04f * std::sin(a), i % 2 ? 0.04f : -0.04f},
                                         c + Vec3f{0.2f * std::cos(a), 0.2f * std::sin(a), 0}},
                      0.004f, 4),
                  chrome);
        }
        k.add(shapes::slab(1, 9, 0.006f,
                           [&](float u, float v) {
                               const float a = (x < 0 ? 0.25f : 0.2f) * kPi + 0.55f * kPi * v, r = 0.35f;
                               return c + Vec3f{r * std::cos(a), r * std::sin(a), 0.15f * (0.5f - u)};
                           }),
              lacquer);
    }
    for (const float s : {-1.f, 1.f}) {
        k.rod(chrome, {0.72f, 0.32f, s * 0.085f}, {0.5f, 0.86f, s * 0.085f}, 0.025f, 0.021f, 10),
            k.rod(dark, {-0.7f, 0.32f, s * 0.1f}, {-0.15f, 0.36f, s * 0.1f}, 0.024f, -1, 8),
            k.rod(chrome, {-0.62f, 0.36f, s * 0.12f}, {-0.48f, 0.7f, s * 0.12f}, 0.03f, -1, 10);
        k.add(shapes::tube(
                  std::vector<Vec3f>{
                      {0.5f, 0.96f, 0}, {0.46f, 0.99f, s * 0.12f}, {0.36f, 1.02f, s * 0.26f}, {0.3f, 1.0f, s * 0.37f}},
                  0.013f, 8),
              chrome),
            k.rod(tire, {0.335f, 1.01f, s * 0.31f}, {0.29f, 1.0f, s * 0.39f}, 0.02f, -1, 10);
        k.rod(chrome, {0.42f, 1.0f, s * 0.2f}, {0.4f, 1.16f, s * 0.27f}, 0.005f, -1, 5),
            k.add(shapes::ball({0.4f, 1.18f, s * 0.29f}, {0.015f, 0.035f, 0.05f}, 10), dark);
        k.rod(dark, {-0.05f, 0.28f, 0}, {-0.05f, 0.28f, s * 0.24f}, 0.016f, -1, 8);
    }
    k.add(shapes::tube(std::vector<Vec3f>{{0.52f, 0.84f, 0},
                                          {0.4f, 0.42f, 0},
                                          {0.22f, 0.22f, 0},
                                          {-0.2f, 0.22f, 0},
                                          {-0.28f, 0.4f, 0},
                                          {-0.3f, 0.62f, 0}},
                       0.028f, 8),
          dark),
        k.rod(dark, {0.5f, 0.86f, 0}, {-0.55f, 0.62f, 0}, 0.026f, -1, 8);
    k.board(dark, {0.02f, 0.24f, 0}, {0.42f, 0.22f, 0.26f}, 0.04f);
    for (const float lean : {-24.f, 24.f}) {
        Mesh cylinder = shapes::rod({0, 0, 0}, {0, 0.3f, 0}, 0.075f, 0.075f, 14);
        shapes::turn(cylinder, {0, 0, 1}, lean), k.add(std::move(cylinder), chrome, {0.04f, 0.42f, 0});
        for (int i = 0; i < 5; ++i) {
            Mesh fin = shapes::lathe(std::array<Vec2f, 2>{Vec2f{0.1f, 0}, {0.1f, 0.012f}}, 14);
            shapes::move(fin, {0, 0.08f + 0.04f * static_cast<float>(i), 0}), shapes::turn(fin, {0, 0, 1}, lean),
                k.add(std::move(fin), dark, {0.04f, 0.42f, 0});
        }
    }
    k.add(shapes::skin(std::vector<Limb>{{{0.34f, 0.84f, 0}, {-0.02f, 0.78f, 0}, 0.12f, 0.09f},
                                         {{0.3f, 0.8f, -0.06f}, {0.05f, 0.77f, -0.04f}, 0.1f, 0.07f},
                                         {{0.3f, 0.8f, 0.06f}, {0.05f, 0.77f, 0.04f}, 0.1f, 0.07f}},
                       0.04f, 0.04f),
          lacquer),
        k.rod(chrome, {0.22f, 0.93f, 0}, {0.22f, 0.96f, 0}, 0.035f, -1, 12);
    k.add(shapes::skin(std::vector<Limb>{{{-0.05f, 0.72f, 0}, {-0.3f, 0.7f, 0}, 0.07f, 0.1f},
                                         {{-0.2f, 0.7f, -0.07f}, {-0.35f, 0.71f, -0.07f}, 0.06f, 0.07f},
                                         {{-0.2f, 0.7f, 0.07f}, {-0.35f, 0.71f, 0.07f}, 0.06f, 0.07f},
                                         {{-0.4f, 0.76f, 0}, {-0.68f, 0.78f, 0}, 0.085f, 0.07f}},
                       0.05f, 0.045f),
          leather);
    k.add(shapes::ball({0.58f, 0.88f, 0}, {0.09f, 0.09f, 0.09f}, 16), chrome),
        k.add(shapes::ball({0.625f, 0.88f, 0}, {0.055f, 0.075f, 0.075f}, 14), lamp),
        k.board(red, {-0.92f, 0.7f, 0}, {0.04f, 0.06f, 0.1f}, 0.01f),
        k.rod(dark, {-0.92f, 0.72f, 0}, {-0.7f, 0.72f, 0}, 0.02f, -1, 6);
    for (const float y : {0.24f, 0.34f})
        k.add(shapes::tube(std::vector<Vec3f>{{0.14f, 0.5f, 0.1f},
                                              {0.22f, 0.38f, 0.17f},
                                              {0.1f, y, 0.18f},
                                              {-0.3f, y, 0.18f},
                                              {-0.86f, y + 0.05f, 0.19f}},
                           0.035f, 8),
              chrome);
    k.rod(dark, {-0.05f, 0.26f, -0.1f}, {-0.12f, 0.0f, -0.28f}, 0.014f, -1, 6);
    k.piece.clearance_front_m = 0.4f;
}

// A rowing boat with thwarts and oars; with the pattern "canoe" slender, with pointed ends.
void build_boat(Kit& k) {
    const bool canoe = k.request.pattern == "canoe";
    const Vec3f s = k.wanted(canoe ? Vec3f{4.0f, 0.5f, 0.85f} : Vec3f{2.9f, 0.55f, 1.2f});
    Material paint = canoe ? plain("canoe lacquer", {0.45f, 0.05f, 0.03f}, 0.25f) : k.style.wood;
    const int hull = k.main(paint), wood = k.material(materials::timber("natural", 0.5f)),
              iron = k.material(*material_named("iron"));
    const auto section = [&](float v, float u, float in) {
        const float x = 2 * v - 1,
                    beam = canoe   ? std::pow(1 - x * x, 0.7f)
                           : x < 0 ? std::sqrt(std::max(0.f, 1 - 0.36f * x * x))
                                   : std::pow(std::max(0.f, 1 - x * x), 0.6f),
                    side = 2 * u - 1, a = std::pow(std::abs(side), 0.6f), sheer = 0.72f + 0.28f * x * x,
                    rise = canoe ? 0.12f * std::pow(std::abs(x), 6.f) : std::max(0.f, x) * x * x * 0.25f;
        const float y = (rise + (sheer - rise) * (a * a)) * (s.y - in) + in;
        return Vec3f{(0.5f * s.x - in) * x, y,
                     (0.5f * s.z - in) * beam * (side < 0 ? -1.f : 1.f) * std::pow(std::abs(side), 0.55f)};
    };
    k.add(shapes::slab(20, 24, 0.022f, [&](float u, float v) { return section(0.004f + 0.992f * v, u, 0); }), hull);
    for (const float u : {0.f, 1.f}) {
        std::vector<Vec3f> rail;
        for (int i = 0; i <= 24; ++i) rail.push_back(section(0.004f + 0.992f * static_cast<float>(i) / 24, u, 0));
        k.add(shapes::tube(rail, 0.022f, 6), wood);
    }
    for (const float v : canoe ? std::vector<float>{0.008f, 0.992f} : std::vector<float>{0.99f}) {
        const Vec3f keel = section(v, 0.5f, 0), tip = section(v, 1, 0);
        k.rod(hull, {keel.x, keel.y, 0}, {tip.x, tip.y + 0.02f, 0}, std::max(0.03f, 0.8f * tip.z), -1, 10);
    }
    for (const float x : canoe ? std::vector<float>{-0.5f, 0.5f} : std::vector<float>{-0.72f, -0.1f, 0.45f}) {
        const Vec3f e = section(0.5f * (x + 1), 0.87f, 0.02f);
        k.board(wood, {e.x, 0.62f * s.y, 0}, {0.22f, 0.028f, 1.84f * std::abs(e.z)}, 0.006f);
    }
    if (!canoe) {
        const Vec3f t = section(0.004f, 1, 0);
        for (const auto& [low, wide] : {std::pair{0.02f, 0.9f}, {0.12f, 1.4f}, {0.28f, 1.8f}})
            k.board(hull, {t.x + 0.012f, low, 0}, {0.03f, t.y - low, wide * t.z}, 0.006f);
        for (const float sz : {-1.f, 1.f}) {
            k.rod(wood, {-0.9f, 0.69f * s.y, sz * 0.2f}, {0.85f, 0.72f * s.y, sz * 0.12f}, 0.02f, -1, 8),
                k.board(wood, {-1.02f, 0.66f * s.y, sz * 0.205f}, {0.42f, 0.015f, 0.13f}, 0.006f),
                k.rod(iron, section(0.45f, sz > 0 ? 1.f : 0.f, 0),
                      section(0.45f, sz > 0 ? 1.f : 0.f, 0) + Vec3f{0, 0.1f, 0}, 0.012f, -1, 6);
        }
    } else
        k.rod(wood, {-0.8f, 0.66f * s.y, 0.1f}, {0.5f, 0.68f * s.y, 0.02f}, 0.016f, -1, 8),
            k.board(wood, {0.68f, 0.66f * s.y, 0.01f}, {0.4f, 0.015f, 0.17f}, 0.006f);
    k.board(wood, {-0.06f * s.x, 0, 0}, {0.6f * s.x, 0.05f, 0.06f}, 0.01f);
}

// A board leaning on the wall.
void build_surfboard(Kit& k) {
    const int board = k.main(plain("surfboard", {0.74f, 0.72f, 0.66f}, 0.15f)),
              stripe = color(k, "stripe", k.accent(), 0.2f), dark = color(k, "fins", {0.03f, 0.03f, 0.033f}, 0.3f);
    const auto outline = [](float scale) {
        std::vector<Vec2f> o;
        for (int i = 0; i < 44; ++i) {
            const float a = kTau * static_cast<float>(i) / 44, y = std::sin(a);
            o.push_back(
                {0.26f * scale * std::cos(a) * (1 - 0.18f * y) * std::pow(std::max(0.001f, 1 - y * y * 0.35f), 0.5f),
                 -1.05f * y});
        }
        std::vector<Vec2f> r(o.rbegin(), o.rend());
        return r;
    };
    const auto lean = [&](Mesh m, int mat, Vec3f at) {
        if (shapes::signed_volume(m) < 0)
            for (std::size_t i = 0; i + 2 < m.triangles.size(); i += 3) std::swap(m.triangles[i], m.triangles[i + 1]);
        shapes::turn(m, {1, 0, 0}, 90), shapes::move(m, at), shapes::turn(m, {1, 0, 0}, -9),
            k.add(std::move(m), mat, {0, 0.02f, 0.17f});
    };
    auto o = outline(1.f);
    if (shapes::signed_volume(shapes::prism(o, 0, 0.05f, 0.f)) < 0) std::reverse(o.begin(), o.end());
    lean(shapes::prism(o, -0.03f, 0.03f, 0.018f), board, {0, 1.05f, 0}),
        lean(shapes::box({0.012f, 0.003f, 1.9f}, 0.0005f), dark, {0, 1.05f, 0.031f});
    for (const float sx : {-1.f, 1.f})
        lean(shapes::box({0.03f, 0.003f, 1.55f}, 0.0005f), stripe, {sx * 0.09f, 1.05f, 0.031f}),
            lean(shapes::box({0.006f, 0.1f, 0.12f}, 0.002f), dark, {sx * 0.1f, 0.28f, -0.07f});
    k.piece.against_wall = true;
}

// A pair with poles leaning on the wall.
void build_skis(Kit& k) {
    const int ski = k.main(plain("ski", k.accent(), 0.2f)), dark = color(k, "binding", {0.03f, 0.03f, 0.033f}, 0.4f),
              metal = k.material(steel()), white = color(k, "base", {0.7f, 0.7f, 0.68f}, 0.3f);
    for (const float sx : {-1.f, 1.f}) {
        k.add(shapes::slab(1, 16, 0.014f,
                           [&](float u, float v) {
                               const float w = 0.085f + 0.03f * (2 * v - 1) * (2 * v - 1),
                                           tip = std::max(0.f, v - 0.88f) / 0.12f;
                               return Vec3f{sx * 0.09f + w * std::sqrt(1 - 0.75f * tip * tip) * (u - 0.5f), 1.72f * v,
                                            0.28f - 0.25f * v + 0.1f * tip * tip};
                           }),
              ski);
        k.board(dark, {sx * 0.09f, 0.62f, 0.2f}, {0.07f, 0.1f, 0.05f}, 0.012f),
            k.board(dark, {sx * 0.09f, 0.88f, 0.165f}, {0.07f, 0.09f, 0.05f}, 0.012f),
            block(k, white, {sx * 0.09f, 0.73f, 0.185f}, {0.06f, 0.14f, 0.02f});
        k.rod(metal, {sx * 0.26f, 0.01f, 0.26f}, {sx * 0.22f, 1.2f, 0.06f}, 0.008f, -1, 8),
            k.rod(dark, {sx * 0.224f, 1.08f, 0.08f}, {sx * 0.22f, 1.22f, 0.056f}, 0.017f, -1, 8),
            k.add(shapes::ring(0.045f, 0.006f, 14), dark, {sx * 0.257f, 0.08f, 0.25f});
    }
    k.piece.against_wall = true;
}

// A ridge tent, its door rolled aside.
void build_tent(Kit& k) {
    const Vec3f s = k.wanted({1.9f, 1.35f, 2.3f});
    const int cloth = k.main(plain("tent cloth", {0.35f, 0.3f, 0.12f}, 0.9f)),
              dark = color(k, "inside", {0.05f, 0.045f, 0.03f}, 0.95f),
              pole = k.material(materials::timber("natural", 0.6f)),
              rope = color(k, "rope", {0.6f, 0.55f, 0.42f}, 0.9f),
              mat = color(k, "sleeping bag", {0.06f, 0.14f, 0.3f}, 0.9f);
    const float hx = 0.5f * s.x - 0.12f, hz = 0.5f * s.z - 0.2f;
    for (const float sx : {-1.f, 1.f})
        k.add(shapes::slab(8, 10, 0.008f,
                           [&](float u, float v) {
                               const float t = sx > 0 ? u : 1 - u,
                                           sag = 0.05f * std::sin(kPi * t) * (0.5f + 0.5f * std::sin(kPi * v));
                               return Vec3f{sx * (hx * t - sag),
                                            s.y * (1 - t) - sag - 0.03f * std::sin(kPi * v) * (1 - t),
                                            hz * (1 - 2 * v)};
                           }),
              cloth);
    k.add(shapes::slab(6, 6, 0.008f,
                       [&](float u, float v) {
                           return Vec3f{-hx * (1 - v) * (2 * u - 1), (s.y - 0.01f) * v, -hz};
                       }),
          cloth);
    for (const float sx : {-1.f, 1.f}) {
        k.add(shapes::slab(6, 6, 0.008f,
                           [&](float u, float v) {
                               const float w = sx > 0 ? u : 1 - u, open = 0.72f * (1 - v);
                               return Vec3f{sx * hx * (1 - v) * (open + (1 - open) * w), (s.y - 0.01f) * v,
                                            hz + 0.03f * std::sin(14 * w) * (1 - v)};
                           }),
              cloth);
        k.rod(pole, {0, 0, sx * (hz - 0.02f)}, {0, s.y + 0.06f, sx * (hz - 0.02f)}, 0.02f, -1, 8);
        for (const float z : {-1.f, 1.f})
            k.rod(rope, {sx * 0.45f * hx, 0.55f * s.y, z * hz}, {sx * (0.5f * s.x - 0.02f), 0.01f, z * (hz + 0.18f)},
                  0.006f, -1, 5);
    }
    block(k, dark, {0, 0, 0}, {2 * hx - 0.05f, 0.015f, 2 * hz - 0.05f}),
        k.soft(mat, {-0.25f, 0.015f, 0}, {0.55f, 0.09f, 1.7f}, {0.04f, 0.02f, 0.004f, 8}),
        k.soft(rope, {-0.25f, 0.08f, -0.68f}, {0.4f, 0.09f, 0.26f}, {0.035f, 0.02f, 0.002f, 5});
    k.piece.clearance_front_m = 0.5f;
}

// Open, in a heavy foot.
void build_parasol(Kit& k) {
    const int cloth = k.main(tinted(k.style.fabric, k.accent())),
              white = color(k, "pale gores", {0.74f, 0.72f, 0.66f}, 0.9f),
              wood = k.material(materials::timber("natural", 0.6f)),
              foot = color(k, "foot", {0.35f, 0.34f, 0.33f}, 0.8f);
    k.add(shapes::lathe(std::array<Vec2f, 4>{Vec2f{0.25f, 0}, {0.25f, 0.05f}, {0.06f, 0.09f}, {0.04f, 0.25f}}, 22),
          foot),
        k.rod(wood, {0, 0.05f, 0}, {0, 2.3f, 0}, 0.022f, -1, 12),
        k.add(shapes::ball({0, 2.33f, 0}, {0.03f, 0.04f, 0.03f}, 10), wood);
    constexpr int kGores = 8;
    const float r = 1.15f;
    for (int i = 0; i < kGores; ++i) {
        k.add(shapes::slab(4, 5, 0.004f,
                           [&](float u, float v) {
                               const float t = 1 - 0.97f * v, a = kTau * (static_cast<float>(i) + u) / kGores,
                                           flat = 1 - 0.07f * std::sin(kPi * u) * t;
                               return Vec3f{r * t * flat * std::cos(a),
                                            2.28f - 0.42f * std::pow(t, 1.35f) - 0.04f * std::sin(kPi * u) * t,
                                            -r * t * flat * std::sin(a)};
                           }),
              i % 2 ? white : cloth);
        const Vec3f d = around(kTau * static_cast<float>(i) / kGores);
        k.rod(wood, {0, 2.26f, 0}, d * (0.98f * r) + Vec3f{0, 1.86f, 0}, 0.008f, -1, 5),
            k.rod(wood, {0, 1.75f, 0}, d * (0.5f * r) + Vec3f{0, 2.08f, 0}, 0.007f, -1, 5);
    }
    k.add(shapes::rod({0, 1.7f, 0}, {0, 1.8f, 0}, 0.04f, 0.04f, 12), wood);
}

void build_snowman(Kit& k) {
    const int snow = k.main(plain("snow", {0.78f, 0.8f, 0.82f}, 0.95f)),
              coal = color(k, "coal", {0.02f, 0.02f, 0.02f}, 0.8f),
              carrot = color(k, "carrot", {0.65f, 0.2f, 0.02f}, 0.7f),
              felt = color(k, "hat", {0.03f, 0.03f, 0.033f}, 0.9f),
              wool = k.material(tinted(k.style.fabric, {0.55f, 0.04f, 0.04f})),
              twig = color(k, "twigs", {0.1f, 0.06f, 0.03f}, 0.9f);
    k.add(shapes::ball({0, 0.36f, 0}, {0.43f, 0.38f, 0.43f}, 28), snow),
        k.add(shapes::ball({0, 0.9f, 0}, {0.31f, 0.28f, 0.31f}, 24), snow),
        k.add(shapes::ball({0, 1.3f, 0}, {0.22f, 0.21f, 0.22f}, 22), snow);
    for (int i = 0; i < 4; ++i)
        k.add(shapes::ball({0, 0.78f + 0.1f * static_cast<float>(i),
                            i == 3   ? 0.27f
                            : i == 0 ? 0.285f
                                     : 0.31f},
                           {0.026f, 0.026f, 0.018f}, 8),
              coal);
    for (const float s : {-1.f, 1.f}) {
        k.add(shapes::ball({s * 0.075f, 1.36f, 0.195f}, {0.022f, 0.026f, 0.018f}, 8), coal),
            k.rod(twig, {s * 0.26f, 0.98f, 0.05f}, {s * 0.62f, 1.22f, 0.1f}, 0.014f, 0.008f, 6);
        for (const float d : {-0.09f, 0.02f, 0.1f})
            k.rod(twig, {s * 0.56f, 1.18f, 0.09f}, {s * 0.68f, 1.2f + d, 0.12f}, 0.007f, 0.004f, 5);
    }
    for (int i = -2; i <= 2; ++i)
        k.add(shapes::ball({0.045f * static_cast<float>(i), 1.205f + 0.012f * static_cast<float>(i * i), 0.195f},
                           {0.013f, 0.013f, 0.01f}, 6),
              coal);
    k.rod(carrot, {0, 1.3f, 0.2f}, {0, 1.29f, 0.4f}, 0.03f, 0.005f, 10);
    k.add(shapes::ring(0.18f, 0.045f, 24), wool, {0, 1.12f, 0}),
        k.soft(wool, {0.12f, 0.78f, 0.27f}, {0.12f, 0.34f, 0.04f}, {0.015f, 0.005f, 0.002f, 5});
    k.add(
        shapes::lathe(
            std::array<Vec2f, 5>{Vec2f{0.27f, 1.45f}, {0.27f, 1.47f}, {0.17f, 1.475f}, {0.175f, 1.72f}, {0.16f, 1.73f}},
            22),
        felt),
        k.add(shapes::lathe(std::array<Vec2f, 2>{Vec2f{0.176f, 1.48f}, {0.177f, 1.53f}}, 22), wool);
}

}  // namespace fastscene::furniture

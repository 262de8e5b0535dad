// Pieces that a theme or a pastime brings: a sea chest, a ship, a player's computer, drums, an easel, a telescope,
// strings of lights.
#include <array>
#include <cmath>

#include "fastscene/rooms/furniture_kit.h"

namespace fastscene::furniture {
namespace {

// A chest with a rounded lid, bound with iron, a lock in front.
void trunk(Kit& k) {
    const Vec3f s = k.wanted({0.85f, 0.52f, 0.48f});
    const int wood = k.main(*material_named("walnut"));
    Material iron = k.style.metal;
    if (luminance(iron.color_a) > 0.3f) iron = tinted(iron, {0.3f, 0.21f, 0.09f});
    const int band = k.material(iron);
    const float low = 0.62f * s.y, rise = s.y - low - 0.006f, half = 0.5f * s.z;
    k.board(wood, {}, {s.x, low - 0.004f, s.z}, 0.008f);
    // The lid: a low arch from front to back.
    const auto arch = [&](float x, float width, float grow, int material) {
        std::vector<Vec2f> outline;
        for (int i = 0; i <= 16; ++i) {
            const float a = kPi * static_cast<float>(i) / 16.f;
            outline.push_back({(half + grow) * std::cos(a), (rise + grow) * std::sin(a)});
        }
        Mesh m = shapes::prism(outline, -0.5f * width, 0.5f * width, 0.004f);
        // (x, y, z) of the prism: depth, width, height.
        for (auto* list : {&m.positions, &m.normals})
            for (Vec3f& v : *list) v = {v.y, v.z, v.x};
        k.add(std::move(m), material, {x, low, 0});
    };
    arch(0, s.x, 0.f, wood);
    for (const float sx : {-1.f, 1.f}) {
        const float x = sx * (0.5f * s.x - 0.1f);
        k.board(band, {x, 0, 0}, {0.05f, low, s.z + 0.01f}, 0.003f);
        arch(x, 0.05f, 0.005f, band);
        k.rod(band, {sx * (0.5f * s.x + 0.008f), 0.55f * low, -0.06f}, {sx * (0.5f * s.x + 0.008f), 0.55f * low, 0.06f},
              0.008f, -1, 10);
    }
    k.board(band, {0, low - 0.09f, half + 0.003f}, {0.11f, 0.13f, 0.012f}, 0.003f);
    k.add(shapes::ball({0, low - 0.03f, half + 0.01f}, {0.016f, 0.016f, 0.01f}, 12),
          k.material(plain("keyhole", {0.03f, 0.028f, 0.025f}, 0.6f)));
    k.piece.against_wall = true;
    k.piece.clearance_front_m = 0.3f;
}

// A three-masted ship on a stand.
void ship_model(Kit& k) {
    const int wood = k.main(k.style.wood2), dark = k.material(plain("rigging", {0.05f, 0.035f, 0.025f}, 0.7f));
    Material canvas = plain("sailcloth", {0.66f, 0.6f, 0.48f}, 0.9f);
    const int sail = k.material(canvas), flag = k.material(plain("pennant", k.accent(), 0.8f));
    const float length = 0.42f, keel = 0.07f, deck = 0.15f;
    k.board(wood, {0, 0, 0}, {0.2f, 0.012f, 0.09f}, 0.003f);
    for (const float sx : {-1.f, 1.f}) k.board(wood, {sx * 0.07f, 0.011f, 0}, {0.014f, keel, 0.05f}, 0.002f);
    // The hull: sections along x, fuller at the deck; bow to the right.
    k.add(shapes::slab(20, 10, 0.004f,
                       [&](float u, float v) {
                           const float t = 2 * u - 1, fine = t > 0 ? 1.f - t * t : 1.f - 0.35f * t * t,
                                       a = kPi * (v - 0.5f);
                           const float sheer = deck + 0.035f * t * t,
                                       depth = (sheer - keel) * std::sqrt(std::max(0.02f, fine));
                           return Vec3f{0.5f * length * t, sheer - depth * std::cos(a),
                                        0.045f * std::sqrt(std::max(0.01f, fine)) * std::sin(a)};
                       }),
          wood);
    k.add(shapes::sheet(12, 2,
                        [&](float u, float v) {
                            const float t = 2 * u - 1, fine = t > 0 ? 1.f - t * t : 1.f - 0.35f * t * t;
                            return Vec3f{0.49f * length * t, deck + 0.03f * t * t - 0.004f,
                                         (0.5f - v) * 0.086f * std::sqrt(std::max(0.01f, fine))};
                        }),
          wood);
    k.rod(dark, {0.47f * length, deck + 0.03f, 0}, {0.68f * length, deck + 0.09f, 0}, 0.004f, 0.0025f, 8);
    const std::array<float, 3> xs{-0.13f, 0.f, 0.12f}, tops{0.4f, 0.48f, 0.42f};
    for (std::size_t i = 0; i < 3; ++i) {
        k.rod(dark, {xs[i], deck, 0}, {xs[i], tops[i], 0}, 0.0045f, 0.003f, 8);
        for (int j = 0; j < 3; ++j) {
            const float y0 = deck + 0.03f + (tops[i] - deck - 0.06f) * static_cast<float>(j) / 3.f,
                        h = (tops[i] - deck - 0.06f) / 3.f - 0.008f, w = 0.1f - 0.022f * static_cast<float>(j);
            k.rod(dark, {xs[i] + 0.004f, y0 + h, -0.52f * w}, {xs[i] + 0.004f, y0 + h, 0.52f * w}, 0.0025f, -1, 6);
            // Full of wind from astern.
            k.add(
                shapes::slab(8, 6, 0.002f,
                             [&](float u, float v) {
                                 const float belly = 0.03f * std::sin(kPi * u) * std::sin(kPi * (0.15f + 0.8f * v));
                                 return Vec3f{xs[i] + 0.007f + belly, y0 + h * v, (0.5f - u) * w * (1.08f - 0.12f * v)};
                             }),
                sail);
        }
    }
    k.add(shapes::slab(6, 3, 0.0015f,
                       [&](float u, float v) {
                           return Vec3f{-0.06f * u, tops[1] - 0.026f + 0.024f * v - 0.004f * std::sin(5.f * u),
                                        0.003f * std::sin(7.f * u)};
                       }),
          flag);
    k.piece.mount = Mount::surface;
}

// A player's computer: a dark tower, a glass side, fans that glow.
void pc_tower(Kit& k) {
    const int body = k.main(plain("black steel", {0.035f, 0.035f, 0.038f}, 0.4f)),
              grille = k.material(plain("grille", {0.02f, 0.02f, 0.022f}, 0.7f));
    const float w = 0.22f, h = 0.46f, d = 0.42f;
    k.board(body, {0, 0.012f, 0}, {w, h - 0.012f, d}, 0.006f);
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f}) k.board(body, {sx * 0.08f, 0, sz * 0.16f}, {0.03f, 0.013f, 0.05f}, 0.002f);
    k.board(grille, {0, 0.035f, 0.5f * d}, {w - 0.03f, h - 0.06f, 0.006f}, 0.002f);
    static constexpr std::array<Vec3f, 3> kGlow{Vec3f{0.3f, 1.3f, 3.2f}, {2.6f, 0.25f, 2.2f}, {0.25f, 2.4f, 1.5f}};
    const auto first = static_cast<std::size_t>(k.dice.index(3));
    for (std::size_t i = 0; i < 3; ++i) {
        Material light = glow("computer fan", kGlow[(first + i / 2) % 3]);
        light.pattern = Pattern::screen;  // glows at any hour
        Mesh ring = shapes::ring(0.05f, 0.006f, 24);
        shapes::turn(ring, {1, 0, 0}, 90);
        k.add(std::move(ring), k.material(light), {0, 0.1f + 0.125f * static_cast<float>(i), 0.5f * d + 0.006f});
    }
    k.piece.against_wall = true;
}

// A bass drum with two toms, a floor tom, a snare and cymbals, its front to the listeners.
void drum(Kit& k) {
    const int shell = k.main(plain("drum shell", lerp(k.accent(), {0.3f, 0.02f, 0.02f}, 0.5f), 0.25f)),
              skin = k.material(plain("drum skin", {0.72f, 0.7f, 0.65f}, 0.6f)), chrome = k.material(steel()),
              brass = k.material(*material_named("brass"));
    const auto standing = [&](Vec3f at, float r, float h) {
        k.add(shapes::prism(shapes::circle(r, 32), 0.f, h, 0.004f), shell, at);
        for (const float y : {-0.004f, h - 0.008f})
            k.add(shapes::prism(shapes::circle(r + 0.008f, 32), 0.f, 0.012f, 0.003f), chrome, at + Vec3f{0, y, 0});
        k.add(shapes::prism(shapes::circle(r - 0.006f, 32), 0.f, 0.004f, 0.001f), skin, at + Vec3f{0, h + 0.003f, 0});
    };
    const auto lying = [&](float r, float from, float to, int material) {
        Mesh m = shapes::prism(shapes::circle(r, 36), from, to, 0.004f);
        shapes::turn(m, {1, 0, 0}, 90);
        k.add(std::move(m), material, {0, 0.29f, 0.1f});
    };
    lying(0.27f, -0.2f, 0.2f, shell);
    lying(0.285f, 0.185f, 0.205f, chrome);
    lying(0.262f, 0.2f, 0.209f, skin);
    for (const float sx : {-1.f, 1.f}) {
        k.rod(chrome, {sx * 0.24f, 0.3f, 0.2f}, {sx * 0.36f, 0.f, 0.32f}, 0.009f, -1, 8);
        standing({sx * 0.17f, 0.6f, 0.02f}, 0.14f, 0.2f);
        k.rod(chrome, {sx * 0.05f, 0.5f, 0.05f}, {sx * 0.1f, 0.64f, 0.04f}, 0.012f, -1, 8);
    }
    standing({-0.52f, 0.16f, -0.22f}, 0.19f, 0.36f);
    standing({0.46f, 0.5f, -0.28f}, 0.17f, 0.13f);
    k.rod(chrome, {0.46f, 0.f, -0.28f}, {0.46f, 0.51f, -0.28f}, 0.014f, -1, 10);
    for (int i = 0; i < 3; ++i) {
        const float a = 2.0944f * static_cast<float>(i);
        k.rod(chrome, {-0.52f + 0.19f * std::sin(a), 0.f, -0.22f + 0.19f * std::cos(a)},
              {-0.52f + 0.19f * std::sin(a), 0.4f, -0.22f + 0.19f * std::cos(a)}, 0.008f, -1, 8);
        k.rod(chrome, {0.46f + 0.22f * std::sin(a), 0.f, -0.28f + 0.22f * std::cos(a)}, {0.46f, 0.3f, -0.28f}, 0.008f,
              -1, 8);
    }
    for (const auto& [x, z, y, r] :
         {std::array{-0.5f, 0.16f, 0.98f, 0.2f}, {0.56f, 0.12f, 1.02f, 0.22f}, {0.7f, -0.14f, 0.8f, 0.16f}}) {
        k.rod(chrome, {x, 0.f, z}, {x, y + 0.03f, z}, 0.01f, 0.008f, 8);
        for (int i = 0; i < 3; ++i) {
            const float a = 2.0944f * static_cast<float>(i) + 0.5f;
            k.rod(chrome, {x + 0.2f * std::sin(a), 0.f, z + 0.2f * std::cos(a)}, {x, 0.22f, z}, 0.007f, -1, 8);
        }
        const std::array<Vec2f, 5> bow{
            Vec2f{r, 0.f}, {0.96f * r, 0.004f}, {0.35f * r, 0.016f}, {0.2f * r, 0.028f}, {0.02f, 0.034f}};
        Mesh m = shapes::lathe(bow, 32, true);
        shapes::turn(m, {0, 0, 1}, x < 0 ? 9.f : -9.f);
        k.add(std::move(m), brass, {x, y, z});
    }
    k.piece.against_wall = true;
    k.piece.clearance_front_m = 0.4f;
}

// Three legs and a canvas on a ledge.
void easel(Kit& k) {
    const int wood = k.main(k.style.wood), cloth = k.material(plain("canvas", {0.74f, 0.72f, 0.66f}, 0.85f));
    Material paint = plain("painting", k.style.palette[0], 0.6f);
    paint.pattern = Pattern::art;
    paint.color_b = k.style.palette[1];
    paint.color_c = k.style.palette[2];
    paint.seed = k.seed();
    paint.scale_m = 0.56f;
    for (const float sx : {-1.f, 1.f})
        k.rod(wood, {sx * 0.33f, 0, 0.26f}, {sx * 0.04f, 1.72f, -0.08f}, 0.019f, 0.015f, 8);
    k.rod(wood, {0, 0, -0.36f}, {0, 1.66f, -0.09f}, 0.018f, 0.014f, 8);
    k.rod(wood, {-0.25f, 0.48f, 0.17f}, {0.25f, 0.48f, 0.17f}, 0.014f, -1, 8);
    k.board(wood, {0, 0.74f, 0.15f}, {0.6f, 0.03f, 0.07f}, 0.004f);
    const float w = 0.6f, h = 0.76f;
    Mesh back = shapes::box({w, h, 0.024f}, 0.002f), front = shapes::box({w - 0.03f, h - 0.03f, 0.003f}, 0.0005f);
    front.coords = front.positions;
    for (Vec3f& c : front.coords) c = {c.x + 0.5f * w, 0.5f * h - c.y, c.z};
    shapes::move(front, {0, 0, 0.0125f});
    for (auto* m : {&back, &front}) shapes::turn(*m, {1, 0, 0}, -11.f);
    k.add(std::move(back), cloth, {0, 0.76f + 0.5f * h, 0.075f});
    k.add(std::move(front), k.material(paint), {0, 0.76f + 0.5f * h, 0.075f});
    k.piece.clearance_front_m = 0.5f;
}

// On a tripod, looking up.
void telescope(Kit& k) {
    const int tube = k.main(plain("telescope tube", {0.6f, 0.58f, 0.54f}, 0.3f)),
              brass = k.material(*material_named("brass")), wood = k.material(k.style.wood);
    const Vec3f head{0, 1.05f, 0}, dir = normalize(Vec3f{0, 0.5f, 0.86f});
    for (int i = 0; i < 3; ++i) {
        const float a = 2.0944f * static_cast<float>(i);
        k.rod(wood, {0.4f * std::sin(a), 0, 0.4f * std::cos(a)}, {0.04f * std::sin(a), 1.f, 0.04f * std::cos(a)},
              0.013f, 0.018f, 8);
        k.rod(brass, {0, 0.5f, 0}, {0.22f * std::sin(a), 0.5f, 0.22f * std::cos(a)}, 0.006f, -1, 6);
    }
    k.add(shapes::ball(head - Vec3f{0, 0.03f, 0}, {0.045f, 0.05f, 0.045f}, 14), brass);
    k.rod(tube, head + dir * -0.34f, head + dir * 0.4f, 0.045f, 0.052f, 24);
    for (const float t : {-0.3f, 0.f, 0.36f})
        k.rod(brass, head + dir * (t - 0.014f), head + dir * (t + 0.014f), 0.056f, 0.056f, 24);
    k.rod(brass, head + dir * -0.44f, head + dir * -0.33f, 0.02f, 0.03f, 16);
    k.rod(k.material(plain("lens", {0.05f, 0.06f, 0.08f}, 0.05f)), head + dir * 0.4f, head + dir * 0.404f, 0.046f, -1,
          24);
}

// A deck with its wheels, lying on the floor.
void skateboard(Kit& k) {
    const int deck = k.main(plain("deck", k.accent(), 0.5f)), metal = k.material(steel()),
              wheel = k.material(plain("wheels", {0.65f, 0.6f, 0.5f}, 0.5f)),
              grip = k.material(plain("grip tape", {0.035f, 0.035f, 0.035f}, 0.95f));
    const auto curve = [](float lift, float inset) {
        return [=](float u, float v) {
            const float x = (u - 0.5f) * (0.8f - inset), end = std::max(0.f, std::abs(x) - 0.28f);
            return Vec3f{x, 0.09f + lift + 0.5f * end, (0.5f - v) * (0.2f - inset) * (end > 0.06f ? 0.8f : 1.f)};
        };
    };
    k.add(shapes::slab(24, 4, 0.012f, curve(0.f, 0.f)), deck);
    k.add(shapes::slab(24, 4, 0.001f, curve(0.0015f, 0.006f)), grip);
    for (const float sx : {-0.21f, 0.21f}) {
        k.board(metal, {sx, 0.035f, 0}, {0.05f, 0.043f, 0.06f}, 0.004f);
        k.rod(metal, {sx, 0.027f, -0.09f}, {sx, 0.027f, 0.09f}, 0.005f, -1, 8);
        for (const float sz : {-0.085f, 0.085f})
            k.rod(wheel, {sx, 0.027f, sz - 0.016f}, {sx, 0.027f, sz + 0.016f}, 0.027f, -1, 20);
    }
}

// Small bulbs on a wire that hangs in three bows along a wall.
void string_lights(Kit& k) {
    const Vec3f s = k.wanted({2.1f, 0.3f, 0.03f});
    const int wire = k.main(plain("wire", {0.05f, 0.05f, 0.045f}, 0.6f));
    Material bulb = glow("fairy light", Vec3f{13.f, 7.2f, 2.3f} * 1.6f);
    bulb.pattern = Pattern::screen;  // who asks for them wants them lit, by day too
    const int light = k.material(bulb);
    constexpr int kBows = 3, kEach = 8;
    std::vector<Vec3f> path;
    for (int i = 0; i <= kBows * kEach; ++i) {
        const float t = static_cast<float>(i) / static_cast<float>(kBows * kEach),
                    in = t * kBows - std::floor(t * kBows);
        path.push_back({(t - 0.5f) * s.x, s.y - (s.y - 0.06f) * 4 * in * (1 - in), 0.015f});
    }
    k.add(shapes::tube(path, 0.0025f, 6), wire);
    for (std::size_t i = 0; i < path.size(); ++i)
        k.add(shapes::ball(path[i] - Vec3f{0, 0.016f, 0}, {0.009f, 0.013f, 0.009f}, 8), light);
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.85f;
}

constexpr Entry kThemed[] = {
    {"trunk", trunk}, {"ship_model", ship_model}, {"pc_tower", pc_tower},     {"drum", drum},
    {"easel", easel}, {"telescope", telescope},   {"skateboard", skateboard}, {"string_lights", string_lights}};

}  // namespace

std::span<const Entry> themed() { return kThemed; }

}  // namespace fastscene::furniture

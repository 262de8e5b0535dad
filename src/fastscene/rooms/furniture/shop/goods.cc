#include "fastscene/rooms/furniture/shop/goods.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace fastscene::furniture {
namespace {

constexpr int kColors = 6;

// Colors of labels and covers: bright ones, and white between.
std::array<int, kColors> labels(Kit& k, float roughness) {
    static constexpr std::array<Vec3f, 10> kInks{
        Vec3f{0.55f, 0.06f, 0.05f}, {0.06f, 0.16f, 0.45f}, {0.7f, 0.45f, 0.05f}, {0.08f, 0.32f, 0.12f},
        {0.72f, 0.7f, 0.66f},       {0.62f, 0.2f, 0.04f},  {0.04f, 0.3f, 0.36f}, {0.35f, 0.08f, 0.3f},
        {0.6f, 0.55f, 0.4f},        {0.12f, 0.12f, 0.13f}};
    std::array<int, kColors> out{};
    const int first = k.rng.index(static_cast<int>(kInks.size()));
    for (int i = 0; i < kColors; ++i)
        out[static_cast<std::size_t>(i)] = k.material(
            plain("label", kInks[static_cast<std::size_t>(first + 3 * i) % kInks.size()], roughness));
    return out;
}

Mesh low_box(Vec3f size) {
    Mesh m;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.f, 1.f}) {
            const std::size_t a = static_cast<std::size_t>(axis), b = (a + 1) % 3, c = (a + 2) % 3;
            Vec3f normal{};
            normal[a] = side;
            const auto base = static_cast<std::uint32_t>(m.positions.size());
            for (const auto& [u, v] : {std::pair{-1.f, -1.f}, {1.f, -1.f}, {1.f, 1.f}, {-1.f, 1.f}}) {
                Vec3f p{};
                p[a] = side * size[a] / 2, p[b] = u * side * size[b] / 2, p[c] = v * size[c] / 2;
                m.positions.push_back(p);
                m.normals.push_back(normal);
            }
            for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) m.triangles.push_back(base + i);
        }
    m.coords = m.positions;
    return m;
}

// Loaves, shoes and the like: an ellipsoid with few sides.
void lump(Kit& k, int material, Vec3f base_center, Vec3f size) {
    k.add(shapes::ball({0, 0, 0}, size * 0.5f, 8), material, base_center + Vec3f{0, 0.5f * size.y, 0});
}

void shoe(Kit& k, int upper, int sole, Vec3f at) {
    block(k, sole, at, {0.085f, 0.018f, 0.26f});
    lump(k, upper, at + Vec3f{0, 0.012f, 0.05f}, {0.088f, 0.075f, 0.17f});
    lump(k, upper, at + Vec3f{0, 0.012f, -0.06f}, {0.08f, 0.11f, 0.13f});
}

void toy(Kit& k, const std::array<int, kColors>& c, Vec3f at, float room_y) {
    const int first = c[static_cast<std::size_t>(k.rng.index(kColors))],
              second = c[static_cast<std::size_t>(k.rng.index(kColors))];
    switch (k.rng.index(4)) {
        case 0:  // a bear
            lump(k, first, at, {0.15f, 0.15f, 0.12f});
            lump(k, first, at + Vec3f{0, 0.13f, 0}, {0.12f, 0.11f, 0.1f});
            for (const float s : {-1.f, 1.f}) lump(k, first, at + Vec3f{s * 0.045f, 0.21f, 0}, {0.04f, 0.04f, 0.03f});
            break;
        case 1:  // a ball
            k.add(shapes::ball({0, 0, 0}, {0.09f, 0.09f, 0.09f}, 12), first, at + Vec3f{0, 0.09f, 0});
            break;
        case 2:  // a box with a window
            block(k, first, at, {0.2f, std::min(0.26f, room_y), 0.1f});
            block(k, second, at + Vec3f{0, 0.05f, 0.051f}, {0.13f, std::min(0.13f, room_y - 0.1f), 0.004f});
            break;
        default:  // a lorry
            block(k, first, at + Vec3f{0, 0.03f, -0.02f}, {0.12f, 0.1f, 0.14f});
            block(k, second, at + Vec3f{0, 0.03f, 0.08f}, {0.11f, 0.075f, 0.06f});
            break;
    }
}

void loaf(Kit& k, const std::array<int, 3>& crusts, Vec3f at) {
    const int crust = crusts[static_cast<std::size_t>(k.rng.index(3))];
    lump(k, crust, at, k.rng.chance(0.5f) ? Vec3f{0.15f, 0.1f, 0.27f} : Vec3f{0.19f, 0.12f, 0.2f});
}

// Books by the hundred: plain boxes, of which one sees the backs.
void spines(Kit& k, const std::array<int, kColors>& colors, Vec3f from, float x1, float tallest, float depth) {
    constexpr float kLeastDeep = 0.12f, kMostDeep = 0.2f;
    for (float x = from.x; x < x1 - 0.05f;) {
        const float wide = k.rng.uniform(0.022f, 0.05f), high = std::min(tallest, k.rng.uniform(0.19f, 0.29f)),
                    deep = std::min(depth - 0.01f, k.rng.uniform(kLeastDeep, kMostDeep));
        block(k, colors[static_cast<std::size_t>(k.rng.index(kColors))],
              {x + 0.5f * wide, from.y, from.z - 0.5f * deep}, {wide - 0.002f, high, deep});
        x += k.rng.chance(0.04f) ? wide + 0.08f : wide;
    }
}

float step_of(Goods goods) {
    switch (goods) {
        case Goods::shoes: return 0.21f;
        case Goods::toys: return 0.22f;
        case Goods::bread: return 0.2f;
        case Goods::boxes: return 0.4f;
        case Goods::cartons: return 0.11f;
        case Goods::films: return 0.142f;
        case Goods::jars: return 0.1f;
        case Goods::cans: return 0.085f;
        default: return 0.1f;
    }
}

}  // namespace

int lit(Kit& k, const char* name, Vec3f radiance) { return k.material(lit(name, radiance)); }

int color(Kit& k, const char* name, Vec3f albedo, float roughness) {
    return k.material(plain(name, albedo, roughness));
}

void block(Kit& k, int material, Vec3f base_center, Vec3f size) {
    k.add(low_box(size), material, base_center + Vec3f{0, 0.5f * size.y, 0});
}

void bottle(Kit& k, int glass, int cap, Vec3f at, float h, float r) {
    const std::array<Vec2f, 5> body{
        Vec2f{r, 0}, {r, 0.6f * h}, {0.4f * r, 0.78f * h}, {0.36f * r, 0.95f * h}, {0.36f * r, 0.955f * h}};
    k.add(shapes::lathe(body, 9, true), glass, at);
    const std::array<Vec2f, 2> lid{Vec2f{0.42f * r, 0}, {0.42f * r, 0.06f * h}};
    k.add(shapes::lathe(lid, 8), cap, at + Vec3f{0, 0.94f * h, 0});
}

void stock(Kit& k, Goods goods, float x0, float x1, float y, float room_y, float z_front, float depth) {
    const std::array<int, kColors> c = labels(k, goods == Goods::toys ? 0.7f : 0.45f);
    const auto any = [&] { return c[static_cast<std::size_t>(k.rng.index(kColors))]; };
    const std::array<int, 3> crusts{color(k, "crust", {0.36f, 0.17f, 0.06f}, 0.8f),
                                    color(k, "dark crust", {0.2f, 0.09f, 0.035f}, 0.8f),
                                    color(k, "roll", {0.5f, 0.3f, 0.12f}, 0.7f)};
    const int sole = color(k, "sole", {0.62f, 0.6f, 0.56f}, 0.8f);
    if (goods == Goods::books) return spines(k, c, {x0, y, z_front - 0.02f}, x1, room_y - 0.02f, depth);
    const float step = step_of(goods);
    int same = 0, ink = any();
    for (float x = x0 + 0.5f * step; x + 0.5f * step <= x1 + 0.001f; x += step) {
        // One brand stands side by side.
        if (--same <= 0) same = 2 + k.rng.index(4), ink = any();
        const float z = z_front - 0.02f;
        switch (goods) {
            case Goods::packets: {
                const float h = std::min(room_y - 0.03f, 0.16f + 0.06f * static_cast<float>(ink % 3));
                block(k, ink, {x, y, z - 0.06f}, {step - 0.008f, h, 0.12f});
                break;
            }
            case Goods::cans: {
                const std::array<Vec2f, 2> can{Vec2f{0.036f, 0}, {0.036f, 0.11f}};
                k.add(shapes::lathe(can, 10), ink, {x, y, z - 0.04f});
                if (room_y > 0.26f) k.add(shapes::lathe(can, 10), ink, {x, y + 0.112f, z - 0.04f});
                break;
            }
            case Goods::shoes: {
                const int upper = any();
                for (const float s : {-1.f, 1.f}) shoe(k, upper, sole, {x + s * 0.048f, y, z - 0.13f});
                break;
            }
            case Goods::toys: toy(k, c, {x, y, z - 0.09f}, room_y); break;
            case Goods::bread: loaf(k, crusts, {x, y, z - 0.14f}); break;
            case Goods::jars: {
                const std::array<Vec2f, 3> jar{Vec2f{0.04f, 0}, {0.04f, 0.12f}, {0.032f, 0.14f}};
                k.add(shapes::lathe(jar, 10, true), ink, {x, y, z - 0.05f});
                const std::array<Vec2f, 2> lid{Vec2f{0.035f, 0.135f}, {0.035f, 0.155f}};
                k.add(shapes::lathe(lid, 10), sole, {x, y, z - 0.05f});
                break;
            }
            case Goods::bottles:
                bottle(k, ink, sole, {x, y, z - 0.05f}, std::min(room_y - 0.02f, 0.29f), 0.036f);
                break;
            case Goods::cartons: block(k, ink, {x, y, z - 0.05f}, {0.08f, std::min(room_y - 0.02f, 0.2f), 0.1f}); break;
            case Goods::boxes: {
                const float h = std::min(room_y - 0.05f, k.rng.uniform(0.22f, 0.38f));
                block(k, crusts[2], {x, y, z - 0.2f}, {step - 0.04f, h, 0.34f});
                block(k, sole, {x, y + 0.3f * h, z - 0.029f}, {0.12f, 0.3f * h, 0.003f});
                break;
            }
            case Goods::films: {  // covers to the front: a picture, a title below
                const float high = std::min(room_y - 0.01f, 0.19f), lean = 0.02f;
                block(k, any(), {x, y, z - 0.03f - lean}, {0.132f, high, 0.016f});
                block(k, any(), {x, y + 0.34f * high, z - 0.021f - lean}, {0.1f, 0.56f * high, 0.002f});
                block(k, sole, {x, y + 0.12f * high, z - 0.021f - lean}, {0.09f, 0.1f * high, 0.002f});
                break;
            }
            default: break;
            case Goods::records:
                for (int i = 0; i < 6; ++i) {
                    Mesh sleeve = low_box({step * 3.f < 0.3f ? 0.31f : step, 0.31f, 0.006f});
                    shapes::turn(sleeve, {1, 0, 0}, -14.f);
                    k.add(std::move(sleeve), any(), {x, y + 0.16f, z - 0.05f - 0.06f * static_cast<float>(i)});
                }
                x += 0.22f;
                break;
        }
    }
}

}  // namespace fastscene::furniture

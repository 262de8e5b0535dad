// Of churches, studios and clubs: a pipe organ, foam on walls, a desk with turntables.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {

// A case with towers of pipes above its console, and a bench before it.
void build_pipe_organ(Kit& k) {
    const Vec3f s = k.wanted({2.6f, 3.6f, 1.25f});
    const int wood = k.main(k.style.wood2), tin = k.material(plain("organ pipe", {0.62f, 0.62f, 0.6f}, 0.22f)),
              gold = k.material(*material_named("gold")), dark = color(k, "shadow", {0.015f, 0.013f, 0.012f}, 0.9f),
              ivory = color(k, "keys", {0.76f, 0.73f, 0.64f}, 0.3f),
              ebony = color(k, "stops", {0.03f, 0.028f, 0.026f}, 0.3f);
    k.piece.materials[static_cast<std::size_t>(tin)].metal = 0.8f;
    const float back = -0.5f * s.z, deep = 0.62f * s.z, mid = back + 0.5f * deep, front = back + deep, low = 0.3f * s.y;
    k.board(wood, {0, 0, mid}, {s.x, 0.1f, deep}, 0.01f),
        k.board(wood, {0, 0.1f, mid}, {s.x - 0.1f, low - 0.1f, deep - 0.06f}, 0.008f);
    k.board(wood, {0, low, mid}, {s.x, 0.08f, deep}, 0.02f);
    k.board(dark, {0, low + 0.08f, back + 0.12f}, {s.x - 0.2f, 0.5f * s.y, 0.2f}, 0.003f);
    for (int i = 0; i < 6; ++i) {
        const float w = (s.x - 0.3f) / 6, x = -0.5f * s.x + 0.15f + w * (static_cast<float>(i) + 0.5f);
        if (std::abs(x) > 0.2f * s.x) k.board(wood, {x, 0.2f, front - 0.03f}, {w - 0.08f, low - 0.3f, 0.03f}, 0.012f);
    }
    struct Field {
        float x, wide, high;
        int pipes;
        bool tower;
    };
    const std::array<Field, 5> fields{Field{-0.4f, 0.2f, 0.9f, 5, true},
                                      {-0.2f, 0.2f, 0.62f, 6, false},
                                      {0, 0.2f, 1.f, 5, true},
                                      {0.2f, 0.2f, 0.62f, 6, false},
                                      {0.4f, 0.2f, 0.9f, 5, true}};
    for (const Field& f : fields) {
        const float w = f.wide * s.x, x0 = f.x * s.x, room = (s.y - low - 0.24f) * f.high,
                    z = front - (f.tower ? 0.16f : 0.26f);
        for (const float sx : {-1.f, 1.f})
            k.board(wood, {x0 + sx * (0.5f * w - 0.025f), low + 0.08f, mid}, {0.05f, room, deep - 0.12f}, 0.006f);
        k.board(wood, {x0, low + 0.08f + room, mid}, {w + 0.06f, 0.09f, deep - 0.04f}, 0.025f);
        k.board(gold, {x0, low + 0.05f + room, front - 0.03f}, {w - 0.02f, 0.02f, 0.02f}, 0.003f);
        if (f.tower) k.add(shapes::ball({x0, low + 0.2f + room, mid}, {0.06f, 0.075f, 0.06f}, 12), gold);
        for (int i = 0; i < f.pipes; ++i) {
            const float t = (static_cast<float>(i) + 0.5f) / static_cast<float>(f.pipes), c = 2 * t - 1,
                        pitch = (w - 0.1f) / static_cast<float>(f.pipes);
            const float tall = f.tower ? 1 - 0.22f * std::abs(c) : 0.55f + 0.4f * (f.x < 0 ? 1 - t : t),
                        r = 0.44f * pitch;
            const Vec3f at{x0 + (t - 0.5f) * (w - 0.1f), low + 0.08f, z + (f.tower ? 0.1f * (1 - c * c) : 0)};
            const float h = std::max(0.5f, (room - 0.05f) * tall), foot = 0.2f + 0.06f * std::abs(c);
            const std::array<Vec2f, 3> pipe{Vec2f{0.25f * r, 0}, {r, foot}, {r, h}};
            k.add(shapes::lathe(pipe, 12), tin, at);
            block(k, dark, at + Vec3f{0, foot + 0.02f, 0.92f * r}, {0.9f * r, 0.03f, 0.2f * r});
            block(k, gold, at + Vec3f{0, foot + 0.05f, 0.93f * r}, {0.9f * r, 0.05f, 0.18f * r});
        }
    }
    // The console: three rows of keys between the stops, a music desk, pedals.
    const float cw = 0.36f * s.x, cz = front + 0.1f;
    for (const float sx : {-1.f, 1.f}) {
        k.board(wood, {sx * 0.5f * cw, 0, cz}, {0.06f, 1.05f, 0.42f}, 0.015f);
        for (int row = 0; row < 4; ++row)
            for (int col = 0; col < 2; ++col) {
                const Vec3f at{sx * (0.5f * cw - 0.08f - 0.06f * static_cast<float>(col)),
                               0.82f + 0.055f * static_cast<float>(row), front - 0.02f};
                k.rod(ivory, at, at + Vec3f{0, 0, 0.06f}, 0.016f, -1, 8);
            }
    }
    k.board(dark, {0, 0.66f, front + 0.01f}, {cw, 0.4f, 0.03f}, 0.003f),
        k.board(wood, {0, 1.04f, front + 0.1f}, {cw + 0.1f, 0.04f, 0.3f}, 0.008f);
    for (int row = 0; row < 3; ++row) {
        const float y = 0.7f + 0.07f * static_cast<float>(row), z = cz + 0.12f - 0.09f * static_cast<float>(row),
                    kw = cw - 0.36f;
        k.board(wood, {0, y - 0.03f, z}, {kw + 0.06f, 0.03f, 0.14f}, 0.004f),
            block(k, ivory, {0, y, z}, {kw, 0.016f, 0.13f});
        for (int i = 0; i < 24; ++i)
            if (i % 7 != 2 && i % 7 != 6)
                block(k, ebony, {-0.5f * kw + kw * (static_cast<float>(i) + 1) / 25, y + 0.016f, z - 0.02f},
                      {0.012f, 0.01f, 0.08f});
    }
    Mesh desk = shapes::box({0.6f, 0.3f, 0.015f}, 0.004f);
    shapes::turn(desk, {1, 0, 0}, -15);
    k.add(std::move(desk), wood, {0, 1.24f, front + 0.1f}),
        k.board(color(k, "notes", {0.74f, 0.72f, 0.66f}, 0.9f), {0, 1.12f, front + 0.13f}, {0.42f, 0.2f, 0.006f},
                0.001f);
    for (int i = 0; i < 15; ++i)
        block(k, i % 2 ? ebony : wood, {-0.42f + 0.06f * static_cast<float>(i), 0.05f, front + 0.2f},
              {0.025f, 0.03f, 0.4f});
    k.board(wood, {0, 0.5f, 0.5f * s.z - 0.16f}, {0.36f * s.x, 0.05f, 0.32f}, 0.01f);
    for (const float sx : {-1.f, 1.f})
        k.board(wood, {sx * 0.16f * s.x, 0, 0.5f * s.z - 0.16f}, {0.05f, 0.5f, 0.3f}, 0.008f);
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.2f;
}

// Tiles of acoustic foam, wedges across and upright by turns.
void build_foam_panels(Kit& k) {
    const Vec3f s = k.wanted({1.2f, 1.2f, 0.055f});
    const int one = k.main(plain("acoustic foam", {0.06f, 0.06f, 0.065f}, 0.98f)),
              two = k.material(
                  plain("other foam", k.piece.materials[static_cast<std::size_t>(one)].color_a * 0.55f, 0.98f));
    const int nx = std::max(1, static_cast<int>(s.x / 0.38f)), ny = std::max(1, static_cast<int>(s.y / 0.38f));
    const float w = s.x / static_cast<float>(nx), h = s.y / static_cast<float>(ny);
    constexpr int kWedges = 6;
    for (int i = 0; i < nx; ++i)
        for (int j = 0; j < ny; ++j) {
            const bool across = (i + j) % 2 != 0;
            const int mat = across ? two : one;
            const Vec3f at{-0.5f * s.x + w * (static_cast<float>(i) + 0.5f), h * (static_cast<float>(j) + 0.5f), 0};
            k.add(shapes::box({w - 0.004f, h - 0.004f, 0.3f * s.z}, 0.002f), mat, at + Vec3f{0, 0, 0.15f * s.z});
            const float len = (across ? w : h) - 0.006f, step = ((across ? h : w) - 0.006f) / kWedges;
            for (int n = 0; n < kWedges; ++n) {
                const float off = step * (static_cast<float>(n) + 0.5f - 0.5f * kWedges);
                std::vector<Vec2f> wedge{{-0.5f * step, 0}, {0, 0.7f * s.z}, {0.5f * step, 0}};
                Mesh m = shapes::prism(wedge, -0.5f * len, 0.5f * len, 0.f);
                if (across) shapes::turn(m, {0, 0, 1}, 90);
                k.add(std::move(m), mat, at + (across ? Vec3f{0, off, 0.3f * s.z} : Vec3f{off, 0, 0.3f * s.z}));
            }
        }
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 1.0f;
}

// Two turntables and a mixer between them on a desk with a lit front.
void build_dj_desk(Kit& k) {
    const Vec3f s = k.wanted({1.7f, 1.0f, 0.65f});
    const int body = k.main(plain("desk lacquer", {0.03f, 0.03f, 0.033f}, 0.3f)), metal = k.material(steel()),
              vinyl = color(k, "record", {0.02f, 0.02f, 0.02f}, 0.25f),
              label = color(k, "record label", k.accent(), 0.6f), gray = color(k, "deck", {0.3f, 0.3f, 0.31f}, 0.35f),
              white = color(k, "knob", {0.68f, 0.68f, 0.66f}, 0.4f);
    const int light = lit(k, "desk light", k.rng.chance(0.5f) ? Vec3f{0.2f, 0.5f, 1.6f} : Vec3f{1.5f, 0.2f, 1.1f}),
              green = lit(k, "level", {0.1f, 0.9f, 0.2f});
    k.board(body, {0, 0, 0.5f * s.z - 0.03f}, {s.x, s.y + 0.06f, 0.05f}, 0.008f);
    for (const float sx : {-1.f, 1.f})
        k.board(body, {sx * (0.5f * s.x - 0.025f), 0, -0.02f}, {0.05f, s.y - 0.05f, s.z - 0.06f}, 0.008f);
    k.board(body, {0, s.y - 0.09f, -0.02f}, {s.x, 0.05f, s.z - 0.06f}, 0.008f);
    for (int i = 0; i < 5; ++i) {
        Mesh bar = shapes::box({0.025f, 0.62f * s.y, 0.01f}, 0.003f);
        shapes::turn(bar, {0, 0, 1}, i % 2 ? 28.f : -28.f);
        k.add(std::move(bar), light, {(static_cast<float>(i) - 2) * 0.19f * s.x, 0.5f * s.y, 0.5f * s.z});
    }
    const float y = s.y - 0.04f, z = -0.06f;
    for (const float sx : {-1.f, 1.f}) {
        const float x = sx * 0.29f * s.x;
        k.board(gray, {x, y, z}, {0.45f, 0.09f, 0.36f}, 0.01f);
        k.add(shapes::prism(shapes::circle(0.16f, 32), y + 0.09f, y + 0.11f, 0.003f), metal, {x - 0.03f, 0, z});
        k.add(shapes::prism(shapes::circle(0.15f, 32), y + 0.11f, y + 0.114f, 0.001f), vinyl, {x - 0.03f, 0, z});
        k.add(shapes::prism(shapes::circle(0.05f, 20), y + 0.114f, y + 0.1155f, 0.0005f), label, {x - 0.03f, 0, z});
        const std::vector<Vec3f> arm{
            {x + 0.18f, y + 0.13f, z + 0.12f}, {x + 0.18f, y + 0.135f, z - 0.02f}, {x + 0.1f, y + 0.13f, z - 0.09f}};
        k.add(shapes::tube(arm, 0.005f, 6), metal),
            k.rod(metal, {x + 0.18f, y + 0.09f, z + 0.1f}, {x + 0.18f, y + 0.13f, z + 0.1f}, 0.022f, -1, 12);
        k.add(shapes::prism(shapes::circle(0.02f, 12), y + 0.09f, y + 0.1f, 0.002f), white, {x + 0.19f, 0, z - 0.14f});
    }
    k.board(body, {0, y, z}, {0.3f, 0.1f, 0.36f}, 0.01f);
    for (int c = 0; c < 4; ++c) {
        const float x = -0.105f + 0.07f * static_cast<float>(c);
        for (int r = 0; r < 3; ++r)
            k.rod(white, {x, y + 0.1f, z + 0.12f - 0.05f * static_cast<float>(r)},
                  {x, y + 0.12f, z + 0.12f - 0.05f * static_cast<float>(r)}, 0.011f, 0.009f, 8);
        block(k, white, {x, y + 0.1f, z - 0.1f + k.rng.uniform(-0.03f, 0.03f)}, {0.016f, 0.018f, 0.026f});
        block(k, green, {x, y + 0.1f, z - 0.03f}, {0.008f, 0.003f, 0.06f});
    }
    k.piece.clearance_front_m = 0.7f;
}

}  // namespace fastscene::furniture

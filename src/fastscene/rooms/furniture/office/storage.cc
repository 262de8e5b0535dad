// Offices, libraries and banks: cabinets of steel, partitions, flip charts, book carts, cash machines.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {

// Drawers of sheet steel, each with a handle and a label.
void build_filing(Kit& k) {
    const Vec3f s = k.wanted({0.47f, 1.32f, 0.62f});
    const Vec3f tones[3] = {{0.42f, 0.44f, 0.45f}, {0.62f, 0.6f, 0.54f}, {0.1f, 0.11f, 0.12f}};
    const int body = k.main(plain("lacquered steel", tones[k.rng.index(3)], 0.35f)), metal = k.material(steel()),
              dark = color(k, "gap", {0.02f, 0.02f, 0.02f}, 0.7f),
              label = color(k, "label", {0.8f, 0.79f, 0.74f}, 0.8f);
    const int rows = std::max(1, static_cast<int>(std::round((s.y - 0.05f) / 0.32f)));
    k.board(dark, {0, 0, 0}, {s.x - 0.04f, 0.05f, s.z - 0.06f}, 0.003f);
    k.board(body, {0, 0.04f, -0.01f}, {s.x, s.y - 0.04f, s.z - 0.02f}, 0.006f);
    block(k, dark, {0, 0.055f, 0.5f * s.z - 0.0195f}, {s.x - 0.03f, s.y - 0.075f, 0.002f});
    const float step = (s.y - 0.08f) / static_cast<float>(rows), z = 0.5f * s.z - 0.018f;
    for (int i = 0; i < rows; ++i) {
        const float y = 0.06f + step * static_cast<float>(i), out = k.rng.chance(0.12f) ? 0.05f : 0.f;
        k.board(body, {0, y + 0.005f, z + 0.008f + 0.5f * out}, {s.x - 0.04f, step - 0.012f, 0.02f + out}, 0.005f);
        const float front = z + 0.019f + out;
        k.board(metal, {0, y + 0.62f * step, front + 0.014f}, {0.11f, 0.018f, 0.01f}, 0.004f);
        for (const float sx : {-1.f, 1.f})
            block(k, metal, {sx * 0.05f, y + 0.62f * step, front}, {0.012f, 0.018f, 0.025f});
        block(k, metal, {0, y + 0.76f * step, front}, {0.085f, 0.042f, 0.003f}),
            block(k, label, {0, y + 0.76f * step + 0.005f, front + 0.001f}, {0.072f, 0.032f, 0.003f});
    }
    k.rod(metal, {0.38f * s.x, s.y - 0.045f, z}, {0.38f * s.x, s.y - 0.045f, z + 0.024f}, 0.009f, -1, 10);
    k.top(s.y, 0, 0, 0.4f * s.x, 0.35f * s.z);
    k.piece.clearance_front_m = 0.6f, k.piece.against_wall = true;
}

// Panels of cloth in a U about a desk top that is open to the front.
void build_cubicle(Kit& k) {
    const Vec3f s = k.wanted({1.7f, 1.4f, 1.6f});
    const Vec3f tones[4] = {{0.3f, 0.34f, 0.4f}, {0.42f, 0.41f, 0.38f}, {0.2f, 0.3f, 0.32f}, {0.36f, 0.28f, 0.24f}};
    Material felt = k.style.fabric;
    felt.color_a = felt.color_b = felt.color_c = tones[k.rng.index(4)];
    const int cloth = k.main(felt), frame = k.material(plain("aluminum", {0.5f, 0.51f, 0.52f}, 0.35f)),
              top = k.material(plain("laminate", {0.62f, 0.58f, 0.52f}, 0.4f)),
              dark = color(k, "plastic", {0.05f, 0.05f, 0.055f}, 0.5f),
              paper = color(k, "paper", {0.82f, 0.82f, 0.78f}, 0.9f),
              note = color(k, "note", {0.85f, 0.7f, 0.15f}, 0.9f);
    const float w = 0.5f * s.x, d = 0.5f * s.z, t = 0.05f;
    const auto panel = [&](Vec3f base, Vec3f size) {
        const bool along = size.x > size.z;
        k.board(cloth, base + Vec3f{0, 0.09f, 0},
                {size.x - (along ? 0.06f : 0.f), size.y - 0.12f, size.z - (along ? 0.f : 0.06f)}, 0.006f);
        const Vec3f bar{along ? size.x : t + 0.01f, 0.03f, along ? t + 0.01f : size.z};
        block(k, frame, base + Vec3f{0, size.y - 0.03f, 0}, bar),
            block(k, frame, base + Vec3f{0, 0.02f, 0}, {bar.x, 0.08f, bar.z});
        for (const float e : {-1.f, 1.f})
            block(k, frame,
                  base + Vec3f{along ? e * (0.5f * size.x - 0.015f) : 0, 0, along ? 0 : e * (0.5f * size.z - 0.015f)},
                  {along ? 0.03f : t + 0.01f, size.y, along ? t + 0.01f : 0.03f});
    };
    panel({0, 0, -d + 0.03f}, {s.x, s.y, t});
    for (const float sx : {-1.f, 1.f}) panel({sx * (w - 0.03f), 0, 0.03f}, {t, s.y, s.z - 0.06f});
    // The desk: along the back and one side.
    k.board(top, {0, 0.71f, -d + 0.4f}, {s.x - 0.12f, 0.03f, 0.68f}, 0.006f);
    k.board(top, {-w + 0.33f, 0.71f, 0.36f}, {0.54f, 0.03f, s.z - 0.86f}, 0.006f);
    k.board(frame, {w - 0.3f, 0.03f, -d + 0.36f}, {0.4f, 0.66f, 0.5f}, 0.006f);
    for (int i = 0; i < 3; ++i) {
        block(k, frame, {w - 0.3f, 0.05f + 0.21f * static_cast<float>(i), -d + 0.615f}, {0.38f, 0.2f, 0.015f});
        block(k, dark, {w - 0.3f, 0.18f + 0.21f * static_cast<float>(i), -d + 0.626f}, {0.12f, 0.015f, 0.012f});
    }
    for (const float z : {0.1f, d - 0.12f}) k.rod(frame, {-w + 0.33f, 0, z}, {-w + 0.33f, 0.71f, z}, 0.025f, -1, 10);
    k.merge(k.small("computer"), {-0.1f, 0.74f, -d + 0.34f});
    k.merge(k.small("phone"), {w - 0.3f, 0.74f, -d + 0.36f});
    for (int i = 0; i < 5; ++i) {
        const float x = -0.55f * w + 0.26f * w * static_cast<float>(i) * 1.1f;
        block(k, i % 2 ? note : paper, {x, s.y - 0.34f + k.rng.uniform(-0.03f, 0.06f), -d + 0.057f},
              {i % 2 ? 0.08f : 0.15f, i % 2 ? 0.08f : 0.21f, 0.002f});
    }
    k.top(0.74f, -w + 0.33f, 0.36f, 0.2f, 0.5f * s.z - 0.55f);
    k.piece.clearance_front_m = 0.8f;
}

// A desk on two lifting columns, raised.
void build_standing_desk(Kit& k) {
    const Vec3f s = k.wanted({1.5f, 1.08f, 0.74f});
    const int wood = k.main(k.style.wood), metal = k.material(plain("frame", {0.04f, 0.04f, 0.043f}, 0.4f)),
              inner = k.material(steel());
    k.board(wood, {0, s.y - 0.03f, 0}, {s.x, 0.03f, s.z}, 0.006f);
    k.board(metal, {0, s.y - 0.07f, 0}, {s.x - 0.3f, 0.04f, 0.1f}, 0.006f);
    for (const float sx : {-1.f, 1.f}) {
        const float x = sx * (0.5f * s.x - 0.22f);
        k.board(metal, {x, 0.01f, 0}, {0.08f, 0.04f, s.z - 0.06f}, 0.012f),
            k.board(metal, {x, 0.04f, 0}, {0.09f, 0.56f * s.y, 0.07f}, 0.006f);
        k.board(inner, {x, 0.5f * s.y, 0}, {0.07f, 0.5f * s.y - 0.06f, 0.055f}, 0.005f),
            block(k, metal, {x, s.y - 0.06f, 0}, {0.07f, 0.03f, s.z - 0.14f});
        for (const float sz : {-1.f, 1.f}) block(k, metal, {x, 0, sz * (0.5f * s.z - 0.06f)}, {0.05f, 0.012f, 0.05f});
    }
    k.board(metal, {0.3f * s.x, s.y - 0.055f, 0.5f * s.z - 0.05f}, {0.12f, 0.022f, 0.06f}, 0.004f);
    k.top(s.y, 0, 0, 0.46f * s.x, 0.42f * s.z);
    k.piece.clearance_front_m = 0.8f;
}

// A pad of paper on a board with three legs.
void build_flip_chart(Kit& k) {
    const int frame = k.main(plain("aluminum", {0.5f, 0.51f, 0.52f}, 0.35f)),
              dark = color(k, "plastic", {0.05f, 0.05f, 0.055f}, 0.5f),
              paper = color(k, "paper", {0.84f, 0.84f, 0.82f}, 0.9f), blue = color(k, "marker", {0.03f, 0.08f, 0.4f}),
              red = color(k, "marker red", {0.55f, 0.03f, 0.03f}),
              green = color(k, "marker green", {0.03f, 0.3f, 0.08f});
    const float lean = -8.f, mid = 1.28f;
    const auto put = [&](int material, Vec3f at, Vec3f size, float bevel) {
        if (bevel < 0.001f) block(k, material, at - Vec3f{0, 0.5f * size.y, 0}, size);
        else k.add(shapes::box(size, bevel), material, at);
        shapes::move(shapes::turn(k.piece.meshes.back(), {1, 0, 0}, lean), {0, mid, 0});
    };
    put(frame, {0, 0, 0}, {0.7f, 1.0f, 0.02f}, 0.006f), put(paper, {0, -0.02f, 0.016f}, {0.64f, 0.94f, 0.012f}, 0.001f);
    put(dark, {0, 0.47f, 0.02f}, {0.68f, 0.04f, 0.025f}, 0.006f),
        put(dark, {0, -0.5f, 0.045f}, {0.66f, 0.015f, 0.07f}, 0.004f);
    for (int i = 0; i < 3; ++i)
        put(i == 0   ? blue
            : i == 1 ? red
                     : green,
            {-0.2f + 0.13f * static_cast<float>(i), -0.485f, 0.05f}, {0.11f, 0.014f, 0.014f}, 0.004f);
    // What was drawn: a heading, points, columns.
    put(blue, {-0.08f, 0.36f, 0.0225f}, {0.36f, 0.014f, 0.001f}, 0.0003f);
    for (int i = 0; i < 4; ++i)
        put(i % 2 ? blue : green, {-0.07f - k.rng.uniform(0, 0.05f), 0.26f - 0.075f * static_cast<float>(i), 0.0225f},
            {k.rng.uniform(0.24f, 0.34f), 0.009f, 0.001f}, 0.0003f),
            put(red, {-0.27f, 0.26f - 0.075f * static_cast<float>(i), 0.0225f}, {0.016f, 0.016f, 0.001f}, 0.0003f);
    for (int i = 0; i < 4; ++i) {
        const float h = 0.08f + 0.055f * static_cast<float>(i) + k.rng.uniform(-0.02f, 0.02f);
        put(i == 3 ? red : blue, {-0.16f + 0.1f * static_cast<float>(i), -0.37f + 0.5f * h, 0.0225f},
            {0.055f, h, 0.001f}, 0.0003f);
    }
    put(green, {0, -0.375f, 0.0225f}, {0.46f, 0.008f, 0.001f}, 0.0003f);
    for (const float sx : {-1.f, 1.f})
        k.rod(frame, {sx * 0.4f, 0, 0.2f}, {sx * 0.25f, mid + 0.42f, -0.08f}, 0.014f, -1, 10);
    k.rod(frame, {0, 0, -0.55f}, {0, mid + 0.42f, -0.09f}, 0.014f, -1, 10),
        k.rod(dark, {-0.26f, mid + 0.42f, -0.08f}, {0.26f, mid + 0.42f, -0.08f}, 0.016f, -1, 8);
    k.piece.clearance_front_m = 0.8f;
}

// Three shelves of books on wheels.
void build_book_cart(Kit& k) {
    const int frame = k.main(plain("lacquered steel", {0.5f, 0.48f, 0.42f}, 0.4f)),
              dark = color(k, "wheel", {0.03f, 0.03f, 0.03f}, 0.6f);
    for (const float sx : {-1.f, 1.f}) {
        k.board(frame, {sx * 0.43f, 0.12f, 0}, {0.025f, 0.92f, 0.42f}, 0.008f);
        k.rod(frame, {sx * 0.47f, 0.98f, -0.15f}, {sx * 0.47f, 0.98f, 0.15f}, 0.012f, -1, 8);
        for (const float z : {-0.15f, 0.15f})
            k.rod(frame, {sx * 0.43f, 0.98f, z}, {sx * 0.475f, 0.98f, z}, 0.01f, -1, 8),
                k.rod(dark, {sx * 0.38f - 0.014f, 0.06f, z}, {sx * 0.38f + 0.014f, 0.06f, z}, 0.06f, -1, 14);
    }
    for (const float y : {0.12f, 0.45f, 0.76f}) k.board(frame, {0, y, 0}, {0.84f, 0.02f, 0.42f}, 0.004f);
    for (const float y : {0.14f, 0.47f, 0.78f}) {
        block(k, frame, {0, y, 0}, {0.84f, 0.16f, 0.012f});
        books(k, {-0.41f, y, 0.01f}, k.rng.uniform(0.6f, 0.8f), 0.26f, 0.17f);
    }
    const std::size_t front = k.piece.meshes.size();  // one row faces the other way
    books(k, {-0.41f, 0.47f, 0.01f}, k.rng.uniform(0.5f, 0.8f), 0.26f, 0.17f);
    for (std::size_t i = front; i < k.piece.meshes.size(); ++i) shapes::turn(k.piece.meshes[i], {0, 1, 0}, 180);
    k.piece.clearance_front_m = 0.4f;
}

// Small drawers with brass pulls in a case on legs: the catalog of a library.
void build_card_catalog(Kit& k) {
    const Vec3f s = k.wanted({1.0f, 1.3f, 0.46f});
    const int wood = k.main(k.style.wood), brass = k.material(plain("brass", {0.6f, 0.42f, 0.14f}, 0.3f)),
              label = color(k, "label", {0.78f, 0.74f, 0.62f}, 0.8f);
    k.piece.materials[static_cast<std::size_t>(brass)].metal = 1.f;
    const float foot = 0.38f;
    legs(k, wood, 0.5f * s.x - 0.05f, 0.5f * s.z - 0.05f, foot);
    k.board(wood, {0, foot, -0.01f}, {s.x, s.y - foot - 0.02f, s.z - 0.02f}, 0.006f),
        k.board(wood, {0, s.y - 0.025f, 0}, {s.x + 0.03f, 0.025f, s.z + 0.02f}, 0.006f);
    const int columns = std::max(2, static_cast<int>(s.x / 0.19f)),
              rows = std::max(2, static_cast<int>((s.y - foot) / 0.145f));
    const float dx = (s.x - 0.06f) / static_cast<float>(columns), dy = (s.y - foot - 0.08f) / static_cast<float>(rows),
                z = 0.5f * s.z - 0.02f;
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c) {
            const float x = -0.5f * s.x + 0.03f + dx * (static_cast<float>(c) + 0.5f),
                        y = foot + 0.025f + dy * static_cast<float>(r);
            block(k, wood, {x, y + 0.008f, z + 0.006f}, {dx - 0.016f, dy - 0.016f, 0.016f});
            block(k, brass, {x, y + 0.52f * dy, z + 0.014f}, {0.07f, 0.042f, 0.003f}),
                block(k, label, {x, y + 0.52f * dy + 0.006f, z + 0.015f}, {0.058f, 0.03f, 0.003f});
            block(k, brass, {x, y + 0.24f * dy, z + 0.014f}, {0.03f, 0.016f, 0.026f});
        }
    k.top(s.y, 0, 0, 0.45f * s.x, 0.4f * s.z);
    k.piece.clearance_front_m = 0.6f, k.piece.against_wall = true;
}

// A thick door with a dial and a wheel.
void build_safe(Kit& k) {
    const Vec3f s = k.wanted({0.6f, 0.75f, 0.56f});
    const int body = k.main(plain("safe steel", {0.07f, 0.085f, 0.09f}, 0.4f)), metal = k.material(steel()),
              dark = color(k, "gap", {0.015f, 0.015f, 0.016f}, 0.6f),
              gold = k.material(plain("brass", {0.6f, 0.42f, 0.14f}, 0.3f));
    k.piece.materials[static_cast<std::size_t>(gold)].metal = 1.f;
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f})
            k.board(dark, {sx * (0.5f * s.x - 0.07f), 0, sz * (0.5f * s.z - 0.08f)}, {0.08f, 0.03f, 0.08f}, 0.004f);
    const float z = 0.5f * s.z - 0.06f, mid = 0.03f + 0.5f * (s.y - 0.03f);
    k.board(body, {0, 0.03f, -0.03f}, {s.x, s.y - 0.03f, s.z - 0.06f}, 0.02f);
    block(k, dark, {0, 0.08f, z - 0.001f}, {s.x - 0.09f, s.y - 0.13f, 0.004f}),
        k.board(body, {0, 0.09f, z + 0.012f}, {s.x - 0.11f, s.y - 0.15f, 0.03f}, 0.01f);
    const float f = z + 0.027f;
    for (int i = 0; i < 2; ++i)
        k.rod(metal, {-0.5f * s.x + 0.045f, mid + (i ? 0.12f : -0.26f) * s.y * 1.2f, z + 0.012f},
              {-0.5f * s.x + 0.045f, mid + (i ? 0.24f : -0.14f) * s.y * 1.2f, z + 0.012f}, 0.017f, -1, 10);
    // The dial with its ticks, the wheel with its spokes.
    k.rod(metal, {0.06f, mid + 0.13f, f}, {0.06f, mid + 0.13f, f + 0.02f}, 0.055f, 0.05f, 24),
        k.rod(dark, {0.06f, mid + 0.13f, f + 0.015f}, {0.06f, mid + 0.13f, f + 0.04f}, 0.026f, 0.022f, 16);
    for (int i = 0; i < 12; ++i) {
        const float a = kTau * static_cast<float>(i) / 12;
        block(k, dark, {0.06f + 0.042f * std::sin(a), mid + 0.127f + 0.042f * std::cos(a), f + 0.02f},
              {0.004f, 0.006f, 0.003f});
    }
    Mesh wheel = shapes::ring(0.085f, 0.009f, 28);
    shapes::turn(wheel, {1, 0, 0}, 90), k.add(std::move(wheel), gold, {0.06f, mid - 0.1f, f + 0.045f});
    for (int i = 0; i < 3; ++i) {
        const float a = kTau * static_cast<float>(i) / 6;
        const Vec3f d{0.085f * std::sin(a), 0.085f * std::cos(a), 0};
        k.rod(gold, Vec3f{0.06f, mid - 0.1f, f + 0.045f} - d, Vec3f{0.06f, mid - 0.1f, f + 0.045f} + d, 0.007f, -1, 8);
    }
    k.rod(metal, {0.06f, mid - 0.1f, f}, {0.06f, mid - 0.1f, f + 0.05f}, 0.02f, -1, 12),
        k.board(gold, {0.06f, mid + 0.21f, f - 0.003f}, {0.16f, 0.035f, 0.006f}, 0.002f);
    k.top(s.y, 0, -0.03f, 0.4f * s.x, 0.35f * s.z);
    k.piece.clearance_front_m = 0.6f, k.piece.against_wall = true;
}

// A cash machine: screen, keys, slots, a lit sign above.
void build_cash_machine(Kit& k) {
    const int body = k.main(plain("cash machine", {0.12f, 0.2f, 0.36f}, 0.35f)),
              gray = color(k, "fascia", {0.5f, 0.51f, 0.52f}, 0.35f),
              dark = color(k, "slot", {0.02f, 0.02f, 0.023f}, 0.4f), screen = lit(k, "display", {0.25f, 0.7f, 1.3f}),
              sign = lit(k, "sign", {1.6f, 1.7f, 1.9f}), green = lit(k, "slot light", {0.2f, 1.8f, 0.5f}),
              metal = k.material(steel());
    k.board(body, {0, 0, -0.05f}, {0.58f, 0.86f, 0.6f}, 0.02f),
        k.board(body, {0, 0.86f, -0.14f}, {0.58f, 0.64f, 0.42f}, 0.02f);
    for (const float sx : {-1.f, 1.f}) k.board(body, {sx * 0.275f, 0.84f, 0.02f}, {0.03f, 0.64f, 0.42f}, 0.01f);
    k.board(gray, {0, 0.86f, 0.14f}, {0.5f, 0.03f, 0.24f}, 0.008f),
        k.board(gray, {0, 0.9f, 0.075f}, {0.5f, 0.42f, 0.02f}, 0.006f);
    k.board(dark, {-0.04f, 1.0f, 0.087f}, {0.34f, 0.27f, 0.01f}, 0.003f),
        block(k, screen, {-0.04f, 1.02f, 0.0925f}, {0.3f, 0.23f, 0.002f});
    for (int i = 0; i < 4; ++i)
        for (const float sx : {-1.f, 1.f})
            block(k, metal, {-0.04f + sx * 0.19f, 1.03f + 0.055f * static_cast<float>(i), 0.087f},
                  {0.025f, 0.022f, 0.012f});
    block(k, dark, {0.2f, 1.2f, 0.086f}, {0.07f, 0.05f, 0.01f}),
        block(k, green, {0.2f, 1.222f, 0.0925f}, {0.05f, 0.005f, 0.002f});
    for (int i = 0; i < 12; ++i)
        block(k, metal, {-0.1f + 0.045f * static_cast<float>(i % 4), 0.889f, 0.14f + 0.04f * static_cast<float>(i / 4)},
              {0.034f, 0.01f, 0.028f});
    k.board(gray, {0, 0.62f, 0.25f}, {0.46f, 0.16f, 0.02f}, 0.006f),
        block(k, dark, {0, 0.68f, 0.262f}, {0.28f, 0.035f, 0.003f}),
        block(k, green, {0, 0.725f, 0.262f}, {0.2f, 0.006f, 0.002f});
    k.board(body, {0, 1.44f, 0.0f}, {0.6f, 0.2f, 0.5f}, 0.02f),
        block(k, sign, {0, 1.475f, 0.251f}, {0.5f, 0.13f, 0.004f});
    for (int i = 0; i < 3; ++i) {
        const float x = -0.13f + 0.13f * static_cast<float>(i), z = 0.255f;
        if (i == 1)
            block(k, body, {x, 1.57f - 0.015f, z}, {0.08f, 0.018f, 0.003f}),
                block(k, body, {x, 1.505f, z}, {0.02f, 0.06f, 0.003f});
        else {
            for (const float sx : {-1.f, 1.f}) block(k, body, {x + sx * 0.035f, 1.505f, z}, {0.018f, 0.07f, 0.003f});
            if (i == 0)
                block(k, body, {x, 1.555f, z}, {0.088f, 0.018f, 0.003f}),
                    block(k, body, {x, 1.53f, z}, {0.06f, 0.014f, 0.003f});
            else
                for (const float sx : {-1.f, 1.f})
                    slat(k, body, {x + sx * 0.03f, 1.57f, z}, {x, 1.53f, z}, 0.016f, 0.003f);
        }
    }
    k.piece.clearance_front_m = 0.8f, k.piece.against_wall = true;
}

}  // namespace fastscene::furniture

// Of game rooms, casinos and bowling alleys.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"
#include "fastscene/rooms/furniture/screen.h"

namespace fastscene::furniture {

void build_pool_table(Kit& k) {
    const int wood = k.material(k.style.wood), dark = color(k, "pocket", {0.015f, 0.015f, 0.015f}, 0.9f);
    const int cloth = k.main(plain("green cloth", {0.03f, 0.2f, 0.07f}, 0.95f));
    const float w = 2.5f, d = 1.4f, y = 0.8f;
    k.board(wood, {0, y - 0.22f, 0}, {w - 0.16f, 0.2f, d - 0.16f}, 0.01f);
    k.board(cloth, {0, y - 0.03f, 0}, {w - 0.2f, 0.025f, d - 0.2f}, 0.002f);
    for (const float sz : {-1.f, 1.f})
        k.board(wood, {0, y - 0.06f, sz * (0.5f * d - 0.06f)}, {w, 0.1f, 0.12f}, 0.015f),
            k.board(cloth, {0, y - 0.01f, sz * (0.5f * d - 0.14f)}, {w - 0.36f, 0.035f, 0.045f}, 0.01f);
    for (const float sx : {-1.f, 1.f})
        k.board(wood, {sx * (0.5f * w - 0.06f), y - 0.06f, 0}, {0.12f, 0.099f, d}, 0.015f),
            k.board(cloth, {sx * (0.5f * w - 0.14f), y - 0.01f, 0}, {0.045f, 0.035f, d - 0.36f}, 0.01f);
    for (const float sx : {-1.f, 0.f, 1.f})
        for (const float sz : {-1.f, 1.f})
            k.add(shapes::prism(shapes::circle(0.062f, 18), y + 0.036f, y + 0.043f, 0.001f), dark,
                  {sx * (0.5f * w - 0.12f), 0, sz * (0.5f * d - 0.12f)});
    const std::array<Vec2f, 8> leg{Vec2f{0.07f, 0}, {0.08f, 0.04f}, {0.05f, 0.1f},  {0.06f, 0.2f},
                                   {0.085f, 0.4f},  {0.06f, 0.46f}, {0.09f, 0.52f}, {0.09f, 0.6f}};
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f})
            k.add(shapes::lathe(leg, 16, true), wood, {sx * (0.5f * w - 0.28f), 0, sz * (0.5f * d - 0.28f)});
    static constexpr std::array<Vec3f, 8> kBalls{Vec3f{0.6f, 0.42f, 0.03f}, {0.03f, 0.08f, 0.4f}, {0.5f, 0.03f, 0.03f},
                                                 {0.2f, 0.04f, 0.3f},       {0.6f, 0.2f, 0.03f},  {0.03f, 0.25f, 0.06f},
                                                 {0.25f, 0.03f, 0.03f},     {0.02f, 0.02f, 0.02f}};
    int n = 0;
    for (int row = 0; row < 5; ++row)
        for (int i = 0; i <= row; ++i, ++n)
            k.add(shapes::ball({0.45f + 0.05f * static_cast<float>(row), y + 0.022f,
                                0.057f * (static_cast<float>(i) - 0.5f * static_cast<float>(row))},
                               {0.028f, 0.028f, 0.028f}, 10),
                  color(k, "ball", kBalls[static_cast<std::size_t>(n) % 8], 0.08f));
    k.add(shapes::ball({-0.55f, y + 0.022f, 0.05f}, {0.028f, 0.028f, 0.028f}, 12),
          color(k, "cue ball", {0.74f, 0.72f, 0.66f}, 0.08f));
    k.rod(k.material(materials::timber("oak", 0.3f)), {-1.1f, y + 0.06f, 0.3f}, {0.2f, y + 0.05f, 0.12f}, 0.014f,
          0.006f, 8);
    k.piece.clearance_front_m = 0.9f;
    k.piece.clearance_side_m = 0.9f;
}

void build_slot_machine(Kit& k) {
    const int body = k.main(plain("cabinet", k.accent(), 0.25f)), chrome = k.material(steel()),
              dark = color(k, "panel", {0.02f, 0.02f, 0.025f}, 0.2f),
              knob = color(k, "knob", {0.5f, 0.02f, 0.02f}, 0.15f);
    const int reels = lit_screen(k, Shown::reels, kGameWhite, 0.48f),
              top = lit_screen(k, Shown::jackpot, kGameWhite, 0.48f);
    k.board(body, {0, 0, -0.03f}, {0.62f, 0.72f, 0.54f}, 0.02f);
    k.board(body, {0, 0.72f, -0.12f}, {0.6f, 1.0f, 0.36f}, 0.02f);
    k.board(dark, {0, 0.76f, 0.0f}, {0.56f, 0.07f, 0.36f}, 0.02f);
    for (int i = 0; i < 5; ++i)
        k.rod(i % 2 ? knob : chrome, {-0.18f + 0.09f * static_cast<float>(i), 0.83f, 0.1f},
              {-0.18f + 0.09f * static_cast<float>(i), 0.845f, 0.1f}, 0.025f, -1, 12);
    k.board(chrome, {0, 0.92f, 0.06f}, {0.54f, 0.4f, 0.02f}, 0.006f),
        k.add(screen_box({0.48f, 0.34f, 0.006f}), reels, {0, 0.95f, 0.07f});
    k.board(chrome, {0, 1.38f, 0.06f}, {0.54f, 0.3f, 0.02f}, 0.006f),
        k.add(screen_box({0.48f, 0.24f, 0.006f}), top, {0, 1.41f, 0.07f});
    k.board(chrome, {0, 0.2f, 0.24f}, {0.4f, 0.12f, 0.06f}, 0.02f);
    k.rod(chrome, {0.33f, 0.9f, -0.1f}, {0.36f, 1.2f, -0.02f}, 0.014f),
        k.add(shapes::ball({0.36f, 1.22f, -0.015f}, {0.035f, 0.035f, 0.035f}, 14), knob);
    k.piece.against_wall = true;
    k.piece.clearance_front_m = 0.8f;
}

void build_arcade_machine(Kit& k) {
    const int side = k.main(plain("cabinet", k.accent(), 0.35f)),
              dark = color(k, "panel", {0.02f, 0.02f, 0.022f}, 0.5f),
              knob = color(k, "joystick", {0.5f, 0.03f, 0.03f}, 0.2f),
              blue = color(k, "button", {0.04f, 0.15f, 0.5f}, 0.2f);
    for (const float sx : {-1.f, 1.f})
        k.board(side, {sx * 0.32f, 0, -0.05f}, {0.03f, 1.8f, 0.6f}, 0.006f),
            k.board(side, {sx * 0.32f, 0.6f, 0.2f}, {0.03f, 0.4f, 0.4f}, 0.02f);
    k.board(dark, {0, 0, -0.05f}, {0.62f, 0.85f, 0.55f}, 0.006f),
        k.board(dark, {0, 0.85f, -0.22f}, {0.62f, 0.95f, 0.25f}, 0.006f),
        k.board(dark, {0, 0.85f, 0.15f}, {0.61f, 0.06f, 0.45f}, 0.01f);
    Mesh face = screen_box({0.54f, 0.42f, 0.01f});
    shapes::move(face, {0, -0.21f, 0}), shapes::turn(face, {1, 0, 0}, -15);
    k.add(std::move(face), lit_screen(k, Shown::game, kGameWhite, 0.54f), {0, 1.2f, -0.04f}),
        k.add(screen_box({0.6f, 0.2f, 0.02f}), lit_screen(k, Shown::marquee, kGameWhite, 0.6f), {0, 1.55f, 0.1f}),
        k.board(dark, {0, 1.5f, 0.0f}, {0.61f, 0.04f, 0.3f}, 0.004f);
    for (const float sx : {-1.f, 1.f}) {
        k.rod(dark, {sx * 0.17f, 0.9f, 0.2f}, {sx * 0.17f, 0.98f, 0.2f}, 0.008f),
            k.add(shapes::ball({sx * 0.17f, 1.0f, 0.2f}, {0.024f, 0.024f, 0.024f}, 12), knob);
        for (int i = 0; i < 3; ++i)
            k.rod(blue, {sx * 0.17f + 0.05f + 0.04f * static_cast<float>(i), 0.91f, 0.24f},
                  {sx * 0.17f + 0.05f + 0.04f * static_cast<float>(i), 0.925f, 0.24f}, 0.015f, -1, 10);
    }
    k.piece.against_wall = true;
    k.piece.clearance_front_m = 0.8f;
}

// A half-round table of green cloth with cards and chips.
void build_card_table(Kit& k) {
    const int wood = k.material(k.style.wood), cloth = k.main(plain("green cloth", {0.03f, 0.2f, 0.07f}, 0.95f)),
              leather = color(k, "rail", {0.05f, 0.02f, 0.012f}, 0.4f),
              card = color(k, "cards", {0.74f, 0.73f, 0.7f}, 0.5f);
    std::vector<Vec2f> outer, inner;
    for (int i = 0; i <= 24; ++i) {
        const float a = kPi * static_cast<float>(i) / 24;
        outer.push_back({1.0f * std::cos(a), 1.05f * std::sin(a) - 0.45f}),
            inner.push_back({0.88f * std::cos(a), 0.93f * std::sin(a) - 0.44f});
    }
    for (auto* o : {&outer, &inner})
        for (Vec2f& p : *o) p.x = -p.x;
    k.add(shapes::prism(outer, 0.7f, 0.76f, 0.012f), leather),
        k.add(shapes::prism(inner, 0.755f, 0.768f, 0.002f), cloth);
    k.board(wood, {0, 0.06f, 0}, {0.6f, 0.64f, 0.4f}, 0.02f), k.board(wood, {0, 0, 0}, {0.9f, 0.06f, 0.6f}, 0.01f);
    const std::array<int, 3> chips{color(k, "red chip", {0.5f, 0.03f, 0.03f}, 0.4f),
                                   color(k, "blue chip", {0.04f, 0.1f, 0.4f}, 0.4f),
                                   color(k, "white chip", {0.7f, 0.69f, 0.66f}, 0.4f)};
    for (int seat = 0; seat < 5; ++seat) {
        const float a = kPi * (static_cast<float>(seat) + 0.5f) / 5, c = std::cos(a), s = std::sin(a);
        for (int i = 0; i < 2; ++i)
            block(
                k, card,
                {0.6f * c + 0.05f * static_cast<float>(i), 0.768f + 0.001f * static_cast<float>(i), 0.62f * s - 0.44f},
                {0.06f, 0.001f, 0.09f});
        for (int i = 0; i < 3; ++i)
            k.rod(chips[static_cast<std::size_t>(i)],
                  {0.74f * c - 0.05f + 0.05f * static_cast<float>(i), 0.768f, 0.78f * s - 0.44f},
                  {0.74f * c - 0.05f + 0.05f * static_cast<float>(i),
                   0.79f + 0.01f * static_cast<float>(k.rng.index(4)), 0.78f * s - 0.44f},
                  0.02f, -1, 12);
    }
    k.piece.clearance_front_m = 0.8f;
}

void build_roulette_table(Kit& k) {
    const int wood = k.material(k.style.wood), cloth = k.main(plain("green cloth", {0.03f, 0.2f, 0.07f}, 0.95f)),
              red = color(k, "red field", {0.4f, 0.02f, 0.02f}, 0.9f),
              black = color(k, "black field", {0.02f, 0.02f, 0.02f}, 0.9f), gold = k.material(*material_named("brass")),
              ink = color(k, "line", {0.66f, 0.62f, 0.5f}, 0.9f);
    k.board(wood, {0, 0.66f, 0}, {2.5f, 0.12f, 1.2f}, 0.03f),
        k.board(cloth, {0, 0.775f, 0}, {2.4f, 0.008f, 1.1f}, 0.002f);
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f}) k.board(wood, {sx * 1.0f, 0, sz * 0.4f}, {0.16f, 0.66f, 0.16f}, 0.02f);
    for (int i = 0; i < 12; ++i)
        for (int j = 0; j < 3; ++j) {
            const Vec3f at{-0.35f + 0.115f * static_cast<float>(i), 0.783f, -0.17f + 0.17f * static_cast<float>(j)};
            block(k, ink, at, {0.113f, 0.001f, 0.168f}),
                block(k, (i + j) % 2 ? red : black, at + Vec3f{0, 0.001f, 0}, {0.1f, 0.001f, 0.155f});
        }
    const std::array<Vec2f, 6> bowl{Vec2f{0.4f, 0}, {0.42f, 0.12f}, {0.37f, 0.12f},
                                    {0.26f, 0.05f}, {0.12f, 0.05f}, {0.02f, 0.08f}};
    k.add(shapes::lathe(bowl, 36, true), wood, {-0.8f, 0.78f, 0});
    for (int i = 0; i < 36; ++i) {
        const float a = kTau * static_cast<float>(i) / 36;
        k.add(shapes::ball({-0.8f + 0.23f * std::cos(a), 0.84f, 0.23f * std::sin(a)}, {0.018f, 0.006f, 0.018f}, 6),
              i % 2 ? red : black);
    }
    k.rod(gold, {-0.8f, 0.85f, 0}, {-0.8f, 0.98f, 0}, 0.02f, 0.012f);
    k.piece.clearance_front_m = 0.8f;
}

// A lane of boards between gutters, pins at its far end; one bowls from the front.
void build_bowling_lane(Kit& k) {
    const Vec3f s = k.wanted({1.65f, 0.42f, 9.0f});
    const int boards = k.main(materials::boards(Pattern::planks, "oak", 0.04f)),
              gutter = color(k, "gutter", {0.05f, 0.05f, 0.055f}, 0.3f),
              pin = color(k, "pin", {0.75f, 0.74f, 0.7f}, 0.15f), red = color(k, "stripe", {0.5f, 0.02f, 0.02f}, 0.2f);
    const float high = 0.1f;
    k.board(boards, {0, 0, 0}, {1.06f, high, s.z}, 0.003f);
    for (const float sx : {-1.f, 1.f}) {
        k.board(gutter, {sx * 0.65f, 0, 0}, {0.24f, 0.04f, s.z}, 0.003f),
            k.board(gutter, {sx * 0.795f, 0, 0}, {0.05f, high + 0.01f, s.z}, 0.006f);
    }
    for (int i = -2; i <= 2; ++i) {
        const std::vector<Vec2f> arrow{{0.f, -0.12f}, {0.05f, 0.f}, {-0.05f, 0.f}};
        std::vector<Vec2f> turned(arrow.rbegin(), arrow.rend());
        Mesh m = shapes::prism(turned, high, high + 0.002f, 0.0005f);
        k.add(std::move(m), red,
              {0.2f * static_cast<float>(i), 0, 0.22f * s.z + 0.12f * std::fabs(static_cast<float>(i))});
    }
    const std::array<Vec2f, 9> shape{Vec2f{0.026f, 0}, {0.045f, 0.06f}, {0.06f, 0.115f},
                                     {0.05f, 0.17f},   {0.026f, 0.24f}, {0.023f, 0.28f},
                                     {0.032f, 0.33f},  {0.02f, 0.372f}, {0.002f, 0.38f}};
    const std::array<Vec2f, 2> band{Vec2f{0.0275f, 0.25f}, {0.0265f, 0.265f}};
    for (int row = 0; row < 4; ++row)
        for (int i = 0; i <= row; ++i) {
            const Vec3f at{0.3f * (static_cast<float>(i) - 0.5f * static_cast<float>(row)), high,
                           -0.5f * s.z + 1.3f - 0.26f * static_cast<float>(row)};
            k.add(shapes::lathe(shape, 12, true), pin, at), k.add(shapes::lathe(band, 12), red, at);
        }
    k.piece.clearance_front_m = 1.5f;
}

void build_ball_return(Kit& k) {
    const int body = k.main(plain("ball return", {0.06f, 0.06f, 0.065f}, 0.3f)), chrome = k.material(steel());
    k.board(body, {0, 0, 0}, {0.5f, 0.5f, 1.5f}, 0.04f);
    for (const float sx : {-1.f, 1.f})
        k.rod(chrome, {sx * 0.2f, 0.54f, -0.7f}, {sx * 0.2f, 0.54f, 0.7f}, 0.02f, -1, 12);
    static constexpr std::array<Vec3f, 5> kBalls{Vec3f{0.4f, 0.02f, 0.03f},
                                                 {0.03f, 0.06f, 0.35f},
                                                 {0.02f, 0.02f, 0.02f},
                                                 {0.03f, 0.25f, 0.1f},
                                                 {0.5f, 0.2f, 0.02f}};
    for (int i = 0; i < 5; ++i)
        k.add(shapes::ball({i % 2 ? 0.08f : -0.08f, 0.6f, -0.5f + 0.24f * static_cast<float>(i)},
                           {0.108f, 0.108f, 0.108f}, 20),
              color(k, "bowling ball", kBalls[static_cast<std::size_t>(i)], 0.06f));
    k.piece.clearance_front_m = 0.4f;
}

}  // namespace fastscene::furniture

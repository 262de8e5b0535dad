// What arcade machines and slot machines show.
#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/rooms/furniture/screen_parts.h"

namespace fastscene::furniture::screens {
namespace {

// ---- games

// Eight rows of eight points, the upper first.
void sprite(Patch& p, Vec2f at, float point, const std::array<unsigned, 8>& rows, Vec3f color) {
    for (int j = 0; j < 8; ++j)
        for (int i = 0; i < 8; ++i)
            if ((rows[static_cast<std::size_t>(j)] >> (7 - i) & 1u) != 0) {
                const Vec2f low = at + Vec2f{point * static_cast<float>(i), point * static_cast<float>(7 - j)};
                p.fill(low, low + Vec2f{point, point}, color);
            }
}
constexpr std::array<unsigned, 8> kCrab{0x42, 0x24, 0x7e, 0xdb, 0xff, 0xbd, 0xa5, 0x66},
    kSquid{0x18, 0x3c, 0x7e, 0xdb, 0xff, 0x24, 0x5a, 0xa5}, kGhost{0x3c, 0x7e, 0xdb, 0xdb, 0xff, 0xff, 0xff, 0xa5},
    kRocket{0x18, 0x18, 0x3c, 0x3c, 0x7e, 0xff, 0xff, 0x66};

void invasion(Patch& p, Random& rng) {
    p.fill(kShownBlack);
    for (int i = 0; i < 90; ++i) p.disc(spot(p, rng.uniform(), rng.uniform()), {1.1f, 1.1f}, {0.4f, 0.45f, 0.6f});
    const float u = 0.0062f * p.w;
    static constexpr std::array<Vec3f, 4> kRows{
        Vec3f{0.9f, 0.15f, 0.7f}, {0.1f, 0.8f, 0.9f}, {0.2f, 0.9f, 0.2f}, {0.95f, 0.8f, 0.1f}};
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 9; ++i)
            if (!rng.chance(0.12f))
                sprite(p, spot(p, 0.1f + 0.09f * static_cast<float>(i), 0.76f - 0.11f * static_cast<float>(j)), u,
                       j % 2 == 0 ? kSquid : kCrab, kRows[static_cast<std::size_t>(j)]);
    for (int i = 0; i < 4; ++i)
        p.fill(spot(p, 0.12f + 0.22f * static_cast<float>(i), 0.19f),
               spot(p, 0.22f + 0.22f * static_cast<float>(i), 0.26f), kGreenAccent);
    sprite(p, spot(p, 0.46f, 0.06f), 1.2f * u, kRocket, kShownWhite);
    p.fill(spot(p, 0.495f, 0.2f), spot(p, 0.503f, 0.3f), {0.95f, 0.9f, 0.3f});
    p.title("SCORE 04250", 0.24f * p.w, 0.91f * p.h, 0.36f * p.w, 0.05f * p.h, kShownWhite);
    p.title("HI 99800", 0.8f * p.w, 0.91f * p.h, 0.28f * p.w, 0.05f * p.h, kRedAccent);
}
void maze(Patch& p, Random& rng) {
    p.fill(kShownBlack);
    const Vec3f wall{0.05f, 0.1f, 0.9f};
    constexpr int kWide = 11, kHigh = 8;
    const Vec2f cell{0.9f * p.w / kWide, 0.8f * p.h / kHigh}, low = spot(p, 0.05f, 0.06f);
    for (int j = 0; j <= kHigh; ++j)
        for (int i = 0; i <= kWide; ++i) {
            const Vec2f at = low + Vec2f{cell.x * static_cast<float>(i), cell.y * static_cast<float>(j)};
            const bool edge_x = j == 0 || j == kHigh, edge_y = i == 0 || i == kWide;
            if (i < kWide && (edge_x || rng.chance(0.4f))) p.line(at, at + Vec2f{cell.x, 0}, 3.5f, wall);
            if (j < kHigh && (edge_y || rng.chance(0.3f))) p.line(at, at + Vec2f{0, cell.y}, 3.5f, wall);
            if (i < kWide && j < kHigh && !rng.chance(0.25f))
                p.disc(at + cell * 0.5f, {3.f, 3.f}, {0.95f, 0.75f, 0.5f});
        }
    const auto middle_of = [&](int i, int j) {
        return low + Vec2f{cell.x * (static_cast<float>(i) + 0.5f), cell.y * (static_cast<float>(j) + 0.5f)};
    };
    const float r = 0.36f * cell.y;
    p.disc(middle_of(3, 2), {r, r}, {0.95f, 0.85f, 0.05f});
    for (float y = -r; y < r; y += 1)  // its mouth
        p.fill(middle_of(3, 2) + Vec2f{std::abs(y) * 1.3f, y}, middle_of(3, 2) + Vec2f{r + 2, y + 1}, kShownBlack);
    for (int i = 0; i < 4; ++i)
        sprite(p, middle_of(2 + 2 * i, 3 + i % 3) - Vec2f{r, r}, 0.25f * r, kGhost,
               std::array<Vec3f, 4>{Vec3f{0.9f, 0.05f, 0.05f},
                                    {0.95f, 0.35f, 0.6f},
                                    {0.1f, 0.8f, 0.9f},
                                    {0.95f, 0.5f, 0.1f}}[static_cast<std::size_t>(i)]);
    p.title("1 UP 12070", 0.5f * p.w, 0.9f * p.h, 0.5f * p.w, 0.055f * p.h, kShownWhite);
}
void race(Patch& p, Random&) {
    const float level = 0.46f * p.h;
    fade(p, {0, level}, {p.w, p.h}, {0.95f, 0.2f, 0.4f}, {0.06f, 0.02f, 0.22f});
    p.disc({0.5f * p.w, level + 0.1f * p.h}, Vec2f{0.24f, 0.24f} * p.h, {1.f, 0.7f, 0.15f});
    for (int i = 0; i < 5; ++i)
        p.fill({0, level + (0.02f + 0.05f * static_cast<float>(i)) * p.h},
               {p.w, level + (0.032f + 0.05f * static_cast<float>(i)) * p.h}, {0.7f, 0.12f, 0.4f}, 0.8f);
    fade(p, {0, 0}, {p.w, level}, {0.03f, 0.01f, 0.09f}, {0.1f, 0.02f, 0.2f});
    for (int i = -9; i <= 9; ++i)
        p.line({(0.5f + 0.06f * static_cast<float>(i)) * p.w, level}, {(0.5f + 0.32f * static_cast<float>(i)) * p.w, 0},
               1.5f, {0.1f, 0.7f, 0.9f});
    for (float y = 1.f; y > 0.02f; y *= 0.72f)
        p.fill({0, level * (1 - y)}, {p.w, level * (1 - y) + 1.5f}, {0.1f, 0.7f, 0.9f});
    for (float y = 0; y < level; y += 1) {
        const float half = p.w * (0.42f * (1 - y / level) + 0.025f);
        p.fill({0.5f * p.w - half, y}, {0.5f * p.w + half, y + 1}, {0.035f, 0.03f, 0.06f});
    }
    for (float y = 0.9f; y > 0.05f; y *= 0.66f)
        p.fill({(0.5f - 0.012f * y) * p.w, level * (1 - y)}, {(0.5f + 0.012f * y) * p.w, level * (1 - 0.8f * y)},
               kShownWhite);
    const Vec2f car = spot(p, 0.56f, 0.06f);
    p.fill(car + Vec2f{-0.11f * p.w, 0}, car + Vec2f{0.11f * p.w, 0.09f * p.h}, {0.85f, 0.03f, 0.05f});
    p.fill(car + Vec2f{-0.08f * p.w, 0.09f * p.h}, car + Vec2f{0.08f * p.w, 0.17f * p.h}, {0.04f, 0.05f, 0.09f});
    for (const float side : {-1.f, 1.f}) {
        p.fill(car + Vec2f{side * 0.095f * p.w - 0.02f * p.w, -0.03f * p.h},
               car + Vec2f{side * 0.095f * p.w + 0.02f * p.w, 0.02f * p.h}, kShownBlack);
        p.fill(car + Vec2f{side * 0.08f * p.w - 0.02f * p.w, 0.05f * p.h},
               car + Vec2f{side * 0.08f * p.w + 0.02f * p.w, 0.075f * p.h}, {1.f, 0.5f, 0.1f});
    }
    p.title("TIME 58", 0.2f * p.w, 0.9f * p.h, 0.26f * p.w, 0.06f * p.h, {1.f, 0.85f, 0.2f});
    p.title("LAP 2/3", 0.8f * p.w, 0.9f * p.h, 0.26f * p.w, 0.06f * p.h, kShownWhite);
}

void rays(Patch& p, Vec3f ground, Vec3f ray) {
    p.fill(ground);
    for (int i = 0; i < 12; ++i) {
        const float a = 0.5236f * static_cast<float>(i);
        p.line(spot(p, 0.5f, 0.5f), spot(p, 0.5f, 0.5f) + Vec2f{std::cos(a), std::sin(a)} * p.w, 0.07f * p.w, ray);
    }
}

}  // namespace

void game(Patch& p, Random& rng, int variant) {
    if (variant == 0) return invasion(p, rng);
    if (variant == 1) return maze(p, rng);
    race(p, rng);
}

void marquee(Patch& p, Random&, int variant) {
    static constexpr std::array<const char*, 3> kNames{"STAR RAID", "MAZE KID", "TURBO"};
    static constexpr std::array<Vec3f, 3> kGrounds{
        Vec3f{0.05f, 0.02f, 0.3f}, {0.5f, 0.03f, 0.05f}, {0.02f, 0.2f, 0.3f}};
    const auto i = static_cast<std::size_t>(variant);
    rays(p, kGrounds[i], kGrounds[i] * 2.f);
    p.title(kNames[i], 0.5f * p.w + 4, 0.24f * p.h - 4, 0.86f * p.w, 0.52f * p.h, kShownBlack);
    p.title(kNames[i], 0.5f * p.w, 0.24f * p.h, 0.86f * p.w, 0.52f * p.h, {1.f, 0.8f, 0.1f});
}

void reels(Patch& p, Random& rng, int) {
    p.fill({0.1f, 0.01f, 0.015f});
    for (int i = 0; i < 3; ++i) {
        const float x = 0.04f + 0.32f * static_cast<float>(i);
        fade(p, spot(p, x, 0.05f), spot(p, x + 0.28f, 0.5f), {0.3f, 0.28f, 0.24f}, {0.9f, 0.88f, 0.8f});
        fade(p, spot(p, x, 0.5f), spot(p, x + 0.28f, 0.95f), {0.9f, 0.88f, 0.8f}, {0.3f, 0.28f, 0.24f});
        for (int j = 0; j < 3; ++j) {
            const Vec2f c = spot(p, x + 0.14f, 0.2f + 0.3f * static_cast<float>(j));
            const float u = 0.1f * p.h;
            switch (rng.index(4)) {
                case 0: p.title("7", c.x, c.y - u, 2 * u, 2 * u, kRedAccent); break;
                case 1:
                    p.fill(c + Vec2f{-1.1f * u, -0.5f * u}, c + Vec2f{1.1f * u, 0.5f * u}, kShownBlack);
                    p.title("BAR", c.x, c.y - 0.28f * u, 1.9f * u, 0.56f * u, kShownWhite);
                    break;
                case 2:
                    for (const float side : {-0.5f, 0.5f}) {
                        p.line(c + Vec2f{side * u, -0.3f * u}, c + Vec2f{0.2f * u, 0.9f * u}, 3, kGreenAccent);
                        p.disc(c + Vec2f{side * u, -0.45f * u}, {0.46f * u, 0.46f * u}, {0.75f, 0.01f, 0.03f});
                    }
                    break;
                default: p.disc(c, {0.9f * u, 0.75f * u}, {0.9f, 0.65f, 0.02f}); break;
            }
        }
    }
    p.fill(spot(p, 0, 0.492f), spot(p, 1, 0.508f), {0.9f, 0.1f, 0.05f});
}

void jackpot(Patch& p, Random&, int) {
    rays(p, {0.45f, 0.02f, 0.05f}, {0.75f, 0.1f, 0.03f});
    p.title("JACKPOT", 0.5f * p.w, 0.54f * p.h, 0.8f * p.w, 0.26f * p.h, {1.f, 0.85f, 0.25f});
    p.title("25 000", 0.5f * p.w, 0.18f * p.h, 0.6f * p.w, 0.22f * p.h, kShownWhite);
    for (int i = 0; i < 20; ++i)
        for (const float y : {0.05f, 0.95f})
            p.disc(spot(p, 0.025f + 0.05f * static_cast<float>(i), y), Vec2f{0.012f, 0.012f} * p.w, {1.f, 0.9f, 0.6f});
}

}  // namespace fastscene::furniture::screens

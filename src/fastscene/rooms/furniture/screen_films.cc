// What cinemas and televisions show.
#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/rooms/furniture/screen_parts.h"

namespace fastscene::furniture::screens {
namespace {

// ---- films

void sundown(Patch& p, Random& rng) {
    fade(p, spot(p, 0, 0.62f), spot(p, 1, 1), {0.3f, 0.12f, 0.2f}, {0.02f, 0.045f, 0.15f});
    fade(p, {0, 0}, spot(p, 1, 0.62f), {1.f, 0.46f, 0.1f}, {0.3f, 0.12f, 0.2f});
    for (int i = 0; i < 14; ++i)
        p.disc(spot(p, rng.uniform(), rng.uniform(0.55f, 0.9f)),
               {rng.uniform(0.06f, 0.2f) * p.w, rng.uniform(0.006f, 0.016f) * p.h}, {1.f, 0.42f, 0.22f}, 0.4f);
    const Vec2f sun = spot(p, 0.64f, 0.44f);
    halo(p, sun, 0.34f * p.h, {1.f, 0.6f, 0.2f});
    p.disc(sun, {0.07f * p.h, 0.07f * p.h}, {1.f, 0.9f, 0.6f});
    ridge(p, 0.4f, 0.1f, 7, 1.f, {0.3f, 0.1f, 0.1f});
    ridge(p, 0.32f, 0.08f, 9, 3.f, {0.13f, 0.045f, 0.055f});
    ridge(p, 0.24f, 0.05f, 6, 5.f, {0.045f, 0.02f, 0.028f});
    ridge(p, 0.13f, 0.03f, 3, 0.4f, kShownBlack);
    const Vec2f root = spot(p, 0.22f, 0.1f);
    p.line(root, root + Vec2f{0.01f * p.w, 0.26f * p.h}, 0.012f * p.w, kShownBlack);
    for (int i = 0; i < 26; ++i)
        p.disc(root + Vec2f{rng.uniform(-0.09f, 0.11f) * p.w, rng.uniform(0.22f, 0.4f) * p.h},
               Vec2f{0.024f, 0.016f} * p.w, kShownBlack);
    person(p, spot(p, 0.44f, 0.13f), 0.21f * p.h, 0.8f, kShownBlack);
    person(p, spot(p, 0.49f, 0.125f), 0.18f * p.h, 0.6f, kShownBlack);
}

void night_street(Patch& p, Random& rng) {
    fade(p, {0, 0}, {p.w, p.h}, {0.06f, 0.09f, 0.15f}, {0.012f, 0.022f, 0.06f});
    halo(p, spot(p, 0.5f, 0.42f), 0.5f * p.h, {0.3f, 0.36f, 0.5f});
    for (int i = 6; i >= 0; --i) {  // houses, nearer and nearer
        const float near = 1.f / (1.6f + 0.9f * static_cast<float>(i)), edge = 0.5f - 0.44f * near;
        const Vec3f wall = lerp(Vec3f{0.07f, 0.085f, 0.14f}, {0.012f, 0.013f, 0.02f}, std::min(1.f, 1.5f * near));
        for (const bool left : {true, false}) {
            const float up = 0.42f + near * rng.uniform(0.55f, 0.9f);
            p.fill(spot(p, left ? 0.f : 1 - edge, 0.36f - 0.4f * near), spot(p, left ? edge : 1.f, up), wall);
            for (float y = 0.44f; y < up - 0.06f; y += 0.13f * near + 0.02f)
                for (float x = 0.02f * near; x < edge - 0.05f * near; x += 0.075f * near + 0.006f) {
                    if (!rng.chance(0.4f)) continue;
                    const float x0 = left ? edge - x - 0.04f * near : 1 - edge + x;
                    p.fill(spot(p, x0, y), spot(p, x0 + 0.04f * near, y + 0.07f * near),
                           Vec3f{0.95f, 0.6f, 0.2f} * rng.uniform(0.2f, 0.9f));
                }
        }
    }
    // The wet street, with the light of lamps in it.
    for (float y = 0; y < 0.36f * p.h; y += 1) {
        const float t = y / (0.36f * p.h), half = 0.5f - 0.46f * t;
        p.fill({(0.5f - half) * p.w, y}, {(0.5f + half) * p.w, y + 1},
               lerp({0.03f, 0.04f, 0.06f}, {0.16f, 0.19f, 0.26f}, t));
    }
    for (int i = 0; i < 5; ++i) {
        const float near = 1.f / (1.f + 0.7f * static_cast<float>(i));
        for (const float side : {-1.f, 1.f}) {
            const Vec2f lamp = spot(p, 0.5f + side * 0.42f * near, 0.38f + 0.34f * near);
            p.line({lamp.x, (0.36f - 0.3f * near) * p.h}, lamp, 0.008f * p.w * near, kShownBlack);
            halo(p, lamp, 0.2f * p.h * near, {1.f, 0.72f, 0.34f});
            p.disc(lamp, Vec2f{0.02f, 0.02f} * (p.h * near), {1.f, 0.92f, 0.7f});
            for (int n = 0; n < 9; ++n) {
                const float y = (0.34f - 0.34f * near * static_cast<float>(n + 1) / 9) * p.h;
                p.disc({lamp.x - side * 0.05f * p.w * near + rng.uniform(-4, 4), y}, {0.02f * p.w * near, 0.006f * p.h},
                       {1.f, 0.66f, 0.3f}, 0.4f);
            }
        }
    }
    const Vec2f feet = spot(p, 0.5f, 0.06f);
    p.disc(feet, {0.05f * p.w, 0.01f * p.h}, kShownBlack, 0.7f);
    person(p, feet, 0.4f * p.h, 0.35f, kShownBlack);
    const Vec2f top = feet + Vec2f{0.012f * p.w, 0.47f * p.h};
    for (float y = 0; y < 0.07f * p.h; y += 1) {  // an umbrella
        const float half = 0.085f * p.w * std::sqrt(1 - y / (0.07f * p.h));
        p.fill({top.x - half, top.y + y}, {top.x + half, top.y + y + 1}, {0.2f, 0.012f, 0.014f});
    }
    p.line(top + Vec2f{0, 0.07f * p.h}, feet + Vec2f{0.012f * p.w, 0.24f * p.h}, 2.5f, kShownBlack);
}

void voyage(Patch& p, Random& rng) {
    const float sea = 0.36f * p.h;
    fade(p, {0, sea}, {p.w, p.h}, {1.f, 0.62f, 0.36f}, {0.1f, 0.12f, 0.34f});
    fade(p, {0, 0}, {p.w, sea}, {0.012f, 0.025f, 0.07f}, {0.5f, 0.26f, 0.22f});
    const Vec2f sun{0.4f * p.w, sea + 0.05f * p.h};
    halo(p, sun, 0.4f * p.h, {1.f, 0.8f, 0.45f});
    p.disc(sun, {0.075f * p.h, 0.075f * p.h}, {1.f, 0.95f, 0.75f});
    fade(p, {0, 0}, {p.w, sea}, {0.012f, 0.025f, 0.07f}, {0.5f, 0.26f, 0.22f});
    for (int i = 0; i < 260; ++i) {
        const float t = std::sqrt(rng.uniform()), y = sea * (1 - t), reach = (0.03f + 0.1f * t) * p.w;
        p.disc({sun.x + rng.uniform(-reach, reach), y}, {(0.004f + 0.02f * t) * p.w, 0.0035f * p.h},
               {1.f, 0.74f, 0.42f}, 0.7f);
    }
    for (int i = 0; i < 9; ++i)
        p.disc(spot(p, rng.uniform(), rng.uniform(0.6f, 0.92f)), {rng.uniform(0.08f, 0.22f) * p.w, 0.012f * p.h},
               {0.95f, 0.5f, 0.42f}, 0.4f);
    const Vec2f o{0.66f * p.w, sea - 0.05f * p.h};  // a ship
    const float u = 0.011f * p.w;
    for (float y = 0; y < 3 * u; y += 1)
        p.fill(o + Vec2f{-10 * u - 0.6f * y, y}, o + Vec2f{11 * u + 1.3f * y, y + 1}, kShownBlack);
    for (const float m : {-6.f, 0.f, 6.f}) {
        p.line(o + Vec2f{m * u, 0}, o + Vec2f{m * u, 22 * u}, 0.3f * u, kShownBlack);
        for (const float row : {5.f, 11.f, 16.5f}) {
            const float half = (2.9f - 0.09f * row) * u;
            p.fill(o + Vec2f{m * u - half, row * u}, o + Vec2f{m * u + half, (row + 4.8f) * u}, {0.03f, 0.018f, 0.03f});
        }
    }
    p.line(o + Vec2f{13 * u, 3 * u}, o + Vec2f{20 * u, 6 * u}, 0.3f * u, kShownBlack);
    ridge(p, 0.03f, 0.015f, 4, 2.f, kShownBlack);
}

// ---- television

void news(Patch& p, Random& rng) {
    fade(p, {0, 0}, {p.w, p.h}, {0.02f, 0.07f, 0.24f}, {0.05f, 0.2f, 0.5f});
    for (int i = 0; i < 7; ++i)
        p.line(spot(p, 0.15f * static_cast<float>(i), 0), spot(p, 0.15f * static_cast<float>(i) + 0.35f, 1),
               0.02f * p.w, {0.06f, 0.24f, 0.58f});
    p.fill(spot(p, 0.06f, 0.4f), spot(p, 0.5f, 0.92f), kShownWhite);
    fade(p, spot(p, 0.07f, 0.42f), spot(p, 0.49f, 0.9f), {0.7f, 0.5f, 0.3f}, {0.1f, 0.25f, 0.55f});
    for (int i = 0; i < 9; ++i)  // a skyline in the picture beside
        p.fill(spot(p, 0.07f + 0.046f * static_cast<float>(i), 0.42f),
               spot(p, 0.11f + 0.046f * static_cast<float>(i), rng.uniform(0.52f, 0.78f)),
               Vec3f{0.05f, 0.07f, 0.12f} * rng.uniform(0.6f, 1.6f));
    const Vec2f head = spot(p, 0.72f, 0.66f);  // who reads them
    const float u = 0.1f * p.h;
    p.disc({head.x, 0.12f * p.h}, {2.7f * u, 3.6f * u}, {0.025f, 0.03f, 0.055f});
    p.fill(head + Vec2f{-0.42f * u, -2.1f * u}, head + Vec2f{0.42f * u, -0.8f * u}, {0.42f, 0.24f, 0.16f});
    for (float y = 0; y < 2.1f * u; y += 1) {
        const float half = 0.62f * u * (1 - y / (2.1f * u));
        p.fill(head + Vec2f{-half, -1.65f * u - y}, head + Vec2f{half, -1.65f * u - y + 1}, kPaperWhite);
    }
    p.line(head + Vec2f{0, -1.8f * u}, head + Vec2f{0, -3.6f * u}, 0.28f * u, kRedAccent);
    p.disc(head + Vec2f{0, 0.25f * u}, {1.06f * u, 1.25f * u}, {0.04f, 0.022f, 0.014f});
    p.disc(head + Vec2f{0, -0.1f * u}, {0.86f * u, 1.12f * u}, {0.52f, 0.3f, 0.2f});
    for (const float side : {-1.f, 1.f})
        p.disc(head + Vec2f{0.34f * side * u, 0.02f * u}, {0.1f * u, 0.07f * u}, {0.03f, 0.02f, 0.02f});
    p.line(head + Vec2f{-0.22f * u, -0.62f * u}, head + Vec2f{0.22f * u, -0.62f * u}, 0.09f * u, {0.35f, 0.1f, 0.09f});
    p.fill(spot(p, 0, 0.2f), spot(p, 0.34f, 0.32f), kRedAccent);
    p.title("EVENING NEWS", 0.17f * p.w, 0.235f * p.h, 0.3f * p.w, 0.055f * p.h, kShownWhite);
    p.fill(spot(p, 0, 0.08f), spot(p, 1, 0.2f), kPaperWhite);
    p.title("CITY OPENS NEW BRIDGE OVER THE RIVER", 0.5f * p.w, 0.115f * p.h, 0.92f * p.w, 0.055f * p.h, kTextGray);
    p.fill({0, 0}, spot(p, 1, 0.08f), {0.02f, 0.05f, 0.16f});
    text_lines(p, rng, spot(p, 0.02f, 0), spot(p, 1.4f, 0.075f), 0.07f * p.h, kShownWhite);
}

void lake(Patch& p, Random& rng) {
    const float shore = 0.4f;
    fade(p, spot(p, 0, shore), {p.w, p.h}, {0.55f, 0.72f, 0.9f}, {0.09f, 0.26f, 0.66f});
    for (int i = 0; i < 16; ++i)
        p.disc(spot(p, rng.uniform(), rng.uniform(0.72f, 0.95f)),
               {rng.uniform(0.04f, 0.12f) * p.w, rng.uniform(0.012f, 0.035f) * p.h}, {0.95f, 0.96f, 1.f}, 0.45f);
    ridge(p, 0.66f, 0.13f, 8, 0.6f, {0.72f, 0.78f, 0.86f});
    ridge(p, 0.57f, 0.12f, 8, 0.7f, {0.2f, 0.26f, 0.34f});
    ridge(p, 0.5f, 0.05f, 11, 2.f, {0.05f, 0.14f, 0.07f});
    ridge(p, 0.45f, 0.025f, 38, 2.f, {0.02f, 0.07f, 0.03f});
    fade(p, {0, 0}, spot(p, 1, shore), {0.03f, 0.14f, 0.3f}, {0.3f, 0.45f, 0.58f});
    for (int i = 0; i < 130; ++i)
        p.disc(spot(p, rng.uniform(), shore * rng.uniform()), {rng.uniform(0.01f, 0.05f) * p.w, 0.003f * p.h},
               rng.chance(0.5f) ? Vec3f{0.04f, 0.12f, 0.1f} : Vec3f{0.6f, 0.72f, 0.82f}, 0.4f);
    ridge(p, 0.05f, 0.04f, 3, 4.f, {0.05f, 0.12f, 0.02f});
    p.title("NATURE", 0.9f * p.w, 0.9f * p.h, 0.12f * p.w, 0.04f * p.h, kShownWhite);
}

void match(Patch& p, Random& rng) {
    for (int i = 0; i < 12; ++i)
        p.fill(spot(p, static_cast<float>(i) / 12, 0), spot(p, static_cast<float>(i + 1) / 12, 0.8f),
               i % 2 == 0 ? Vec3f{0.04f, 0.26f, 0.04f} : Vec3f{0.055f, 0.34f, 0.05f});
    p.fill(spot(p, 0, 0.8f), spot(p, 1, 1), {0.05f, 0.05f, 0.07f});
    for (int i = 0; i < 900; ++i)
        p.disc(spot(p, rng.uniform(), rng.uniform(0.86f, 1.f)), {1.6f, 2.f},
               Vec3f{rng.uniform(), rng.uniform(), rng.uniform()} * 0.6f);
    p.fill(spot(p, 0, 0.79f), spot(p, 1, 0.85f), kBlueAccent);
    p.title("SPORT   ENERGY   AIRWAYS   SPORT", 0.5f * p.w, 0.803f * p.h, 0.96f * p.w, 0.034f * p.h, kShownWhite);
    p.line(spot(p, 0.5f, 0), spot(p, 0.5f, 0.79f), 2, kShownWhite);
    p.disc(spot(p, 0.5f, 0.38f), {0.13f * p.w, 0.15f * p.h}, kShownWhite);
    p.disc(spot(p, 0.5f, 0.38f), {0.13f * p.w - 2, 0.15f * p.h - 2}, {0.045f, 0.29f, 0.045f});
    for (int i = 0; i < 14; ++i) {
        const Vec2f feet = spot(p, rng.uniform(0.06f, 0.94f), rng.uniform(0.08f, 0.66f));
        const float tall = p.h * (0.15f - 0.09f * feet.y / p.h);
        p.disc(feet, {0.4f * tall, 0.07f * tall}, {0.01f, 0.08f, 0.01f}, 0.6f);
        person(p, feet, tall, rng.uniform(-0.9f, 0.9f), i % 2 == 0 ? Vec3f{0.75f, 0.04f, 0.04f} : kShownWhite);
    }
    p.disc(spot(p, 0.56f, 0.3f), {3.5f, 3.5f}, kShownWhite);
    p.fill(spot(p, 0.04f, 0.88f), spot(p, 0.3f, 0.96f), kShownBlack);
    p.title("RED 2 - 1 WHI", 0.17f * p.w, 0.9f * p.h, 0.22f * p.w, 0.04f * p.h, kShownWhite);
}

}  // namespace

void film(Patch& p, Random& rng, int variant) {
    if (variant == 0) return sundown(p, rng);
    if (variant == 1) return night_street(p, rng);
    voyage(p, rng);
}

void broadcast(Patch& p, Random& rng, int variant) {
    if (variant == 0) return lake(p, rng);
    if (variant == 1) return news(p, rng);
    match(p, rng);
}

}  // namespace fastscene::furniture::screens

// What computers, projectors and machines show.
#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/rooms/furniture/screen_parts.h"

namespace fastscene::furniture::screens {
void ridge(Patch& p, float base, float swing, float waves, float phase, Vec3f color) {
    for (float x = 0; x < p.w; x += 1) {
        const float t = x / p.w * waves + phase,
                    y = base + swing * (0.55f * std::sin(t) + 0.3f * std::sin(2.3f * t + 1.f) +
                                        0.15f * std::sin(5.9f * t + 2.f) + 0.05f * std::sin(17.f * t));
        p.fill({x, 0}, {x + 1, y * p.h}, color);
    }
}
void halo(Patch& p, Vec2f at, float radius, Vec3f color) {
    constexpr int kDiscs = 28;
    for (int i = kDiscs; i > 0; --i) {
        const float t = static_cast<float>(i) / kDiscs, r = radius * t * t;
        p.disc(at, {r, r}, color, 0.028f);
    }
}
void text_lines(Patch& p, Random& rng, Vec2f low, Vec2f high, float pitch, Vec3f ink) {
    const float tall = 0.42f * pitch;
    for (float y = high.y - pitch; y > low.y; y -= pitch) {
        const float end = low.x + (high.x - low.x) * rng.uniform(0.55f, 1.f);
        for (float x = low.x; x < end;) {
            const float word = std::min(end - x, tall * rng.uniform(1.2f, 4.6f));
            p.fill({x, y}, {x + word, y + tall}, ink, 0.85f);
            x += word + 0.7f * tall;
        }
    }
}
void bars(Patch& p, Random& rng, Vec2f low, Vec2f high, int count, Vec3f color) {
    const float pitch = (high.x - low.x) / static_cast<float>(count);
    p.fill(low, {high.x, low.y + 1.5f}, kTextGray);
    for (int i = 0; i < count; ++i) {
        const float x = low.x + pitch * (static_cast<float>(i) + 0.2f), up = (high.y - low.y) * rng.uniform(0.25f, 1.f);
        p.fill({x, low.y}, {x + 0.6f * pitch, low.y + up}, i % 3 == 2 ? lerp(color, kShownWhite, 0.4f) : color);
    }
}
void curve(Patch& p, Random& rng, Vec2f low, Vec2f high, Vec3f color, float weight) {
    constexpr int kPoints = 14;
    Vec2f last{};
    float y = 0.4f;
    for (int i = 0; i <= kPoints; ++i) {
        y = std::clamp(y + rng.uniform(-0.16f, 0.22f), 0.05f, 0.95f);
        const Vec2f at{low.x + (high.x - low.x) * static_cast<float>(i) / kPoints, low.y + (high.y - low.y) * y};
        if (i > 0) p.line(last, at, weight, color);
        last = at;
    }
}
void ring(Patch& p, Vec2f at, float outer, float inner, Vec3f color, Vec3f ground) {
    p.disc(at, {outer, outer}, color), p.disc(at, {inner, inner}, ground);
}

namespace {

// ---- computers

void window(Patch& p, Vec2f low, Vec2f high, Vec3f ground) {
    p.fill(low + Vec2f{4, -5}, high + Vec2f{4, -5}, kShownBlack, 0.4f);
    p.fill(low, high, ground);
    p.fill({low.x, high.y - 0.045f * p.h}, high, {0.5f, 0.52f, 0.55f});
    for (int i = 0; i < 3; ++i)
        p.disc({high.x - (0.02f + 0.028f * static_cast<float>(i)) * p.w, high.y - 0.0225f * p.h},
               Vec2f{0.008f, 0.008f} * p.w, kAccents[static_cast<std::size_t>(3 - i)]);
}
void task_bar(Patch& p) {
    p.fill({0, 0}, spot(p, 1, 0.055f), {0.02f, 0.025f, 0.035f});
    for (int i = 0; i < 7; ++i)
        p.fill(spot(p, 0.02f + 0.04f * static_cast<float>(i), 0.012f),
               spot(p, 0.045f + 0.04f * static_cast<float>(i), 0.043f),
               lerp(kAccents[static_cast<std::size_t>(i) % 4], kShownWhite, 0.15f));
    p.title("10:24", 0.95f * p.w, 0.018f * p.h, 0.06f * p.w, 0.022f * p.h, kShownWhite);
}

void windows_open(Patch& p, Random& rng) {
    fade(p, {0, 0}, {p.w, p.h}, {0.2f, 0.45f, 0.6f}, {0.03f, 0.1f, 0.34f});
    ridge(p, 0.36f, 0.1f, 5, 0.5f, {0.05f, 0.22f, 0.34f}), ridge(p, 0.22f, 0.08f, 4, 3.f, {0.025f, 0.11f, 0.2f});
    window(p, spot(p, 0.06f, 0.14f), spot(p, 0.55f, 0.92f), kPaperWhite);
    text_lines(p, rng, spot(p, 0.1f, 0.18f), spot(p, 0.51f, 0.72f), 0.036f * p.h, kTextGray);
    p.title("REPORT", 0.22f * p.w, 0.76f * p.h, 0.2f * p.w, 0.055f * p.h, kTextGray);
    window(p, spot(p, 0.47f, 0.24f), spot(p, 0.95f, 0.82f), {0.9f, 0.9f, 0.9f});
    fade(p, spot(p, 0.49f, 0.52f), spot(p, 0.93f, 0.75f), {0.9f, 0.55f, 0.3f}, {0.15f, 0.3f, 0.6f});
    for (float x = 0.49f * p.w; x < 0.93f * p.w; x += 1)
        p.fill({x, 0.52f * p.h}, {x + 1, (0.59f + 0.03f * std::sin(x * 0.06f) + 0.015f * std::sin(x * 0.17f)) * p.h},
               {0.05f, 0.1f, 0.09f});
    text_lines(p, rng, spot(p, 0.49f, 0.27f), spot(p, 0.93f, 0.5f), 0.036f * p.h, kTextGray);
    task_bar(p);
}

void code(Patch& p, Random& rng) {
    static constexpr std::array<Vec3f, 5> kTokens{Vec3f{0.62f, 0.65f, 0.7f},
                                                  {0.2f, 0.45f, 0.8f},
                                                  {0.75f, 0.35f, 0.15f},
                                                  {0.3f, 0.6f, 0.2f},
                                                  {0.55f, 0.25f, 0.6f}};
    p.fill({0.012f, 0.014f, 0.02f});
    p.fill({0, 0}, spot(p, 0.17f, 1), {0.02f, 0.023f, 0.032f});
    p.fill(spot(p, 0.17f, 0.94f), spot(p, 1, 1), {0.028f, 0.032f, 0.045f});
    p.fill(spot(p, 0.17f, 0.94f), spot(p, 0.33f, 1), {0.012f, 0.014f, 0.02f});
    text_lines(p, rng, spot(p, 0.02f, 0.3f), spot(p, 0.14f, 0.95f), 0.045f * p.h, {0.3f, 0.32f, 0.36f});
    const float pitch = 0.036f * p.h, tall = 0.42f * pitch;
    int deep = 0;
    for (float y = 0.9f * p.h; y > 0.05f * p.h; y -= pitch) {
        deep = std::clamp(deep + rng.index(3) - 1, 0, 4);
        p.fill({0.18f * p.w, y}, {0.195f * p.w, y + tall}, {0.09f, 0.1f, 0.12f});
        if (rng.chance(0.1f)) continue;
        const float end = p.w * rng.uniform(0.42f, 0.8f);
        for (float x = (0.215f + 0.028f * static_cast<float>(deep)) * p.w; x < end;) {
            const float word = tall * rng.uniform(1.2f, 5.f);
            p.fill({x, y}, {x + word, y + tall}, kTokens[static_cast<std::size_t>(rng.index(5))]);
            x += word + 0.7f * tall;
        }
    }
    for (int i = 0; i < 50; ++i)  // the whole file, small
        p.fill(spot(p, 0.93f, 0.92f - 0.012f * static_cast<float>(i)),
               spot(p, 0.93f + 0.05f * rng.uniform(), 0.926f - 0.012f * static_cast<float>(i)), {0.16f, 0.19f, 0.25f});
    p.fill({0, 0}, spot(p, 1, 0.03f), kBlueAccent);
}

void dashboard(Patch& p, Random& rng) {
    p.fill({0.62f, 0.65f, 0.7f});
    p.fill(spot(p, 0, 0.92f), spot(p, 1, 1), {0.03f, 0.08f, 0.2f});
    p.title("OVERVIEW", 0.12f * p.w, 0.94f * p.h, 0.18f * p.w, 0.035f * p.h, kShownWhite);
    p.fill({0, 0}, spot(p, 0.05f, 0.92f), {0.05f, 0.11f, 0.25f});
    static constexpr std::array<const char*, 4> kFigures{"1284", "73.5", "+ 12", "98.1"};
    for (int i = 0; i < 4; ++i) {
        const float x = 0.07f + 0.23f * static_cast<float>(i);
        p.fill(spot(p, x, 0.72f), spot(p, x + 0.21f, 0.89f), kShownWhite);
        p.title(kFigures[static_cast<std::size_t>(i)], (x + 0.105f) * p.w, 0.76f * p.h, 0.15f * p.w, 0.075f * p.h,
                kAccents[static_cast<std::size_t>(i)]);
    }
    p.fill(spot(p, 0.07f, 0.06f), spot(p, 0.53f, 0.69f), kShownWhite);
    bars(p, rng, spot(p, 0.1f, 0.12f), spot(p, 0.5f, 0.62f), 11, kBlueAccent);
    p.fill(spot(p, 0.55f, 0.36f), spot(p, 0.97f, 0.69f), kShownWhite);
    for (const Vec3f color : {kGreenAccent, kAmberAccent})
        curve(p, rng, spot(p, 0.58f, 0.4f), spot(p, 0.95f, 0.65f), color, 2.5f);
    p.fill(spot(p, 0.55f, 0.06f), spot(p, 0.97f, 0.33f), kShownWhite);
    ring(p, spot(p, 0.64f, 0.195f), 0.1f * p.h, 0.055f * p.h, kRedAccent, kShownWhite);
    text_lines(p, rng, spot(p, 0.74f, 0.09f), spot(p, 0.95f, 0.3f), 0.05f * p.h, kTextGray);
}

void table_of_numbers(Patch& p, Random& rng) {
    p.fill(kPaperWhite);
    p.fill(spot(p, 0, 0.93f), spot(p, 1, 1), {0.03f, 0.22f, 0.09f});
    p.fill(spot(p, 0, 0.88f), spot(p, 1, 0.93f), {0.66f, 0.68f, 0.7f});
    constexpr int kColumns = 9, kRows = 22;
    for (int i = 0; i <= kColumns; ++i)
        p.fill(spot(p, static_cast<float>(i) / kColumns, 0.05f),
               spot(p, static_cast<float>(i) / kColumns, 0.88f) + Vec2f{1, 0}, {0.55f, 0.56f, 0.58f});
    for (int j = 0; j < kRows; ++j) {
        const float y = 0.07f + 0.0365f * static_cast<float>(j);
        p.fill(spot(p, 0, y - 0.008f), spot(p, 1, y - 0.008f) + Vec2f{0, 1}, {0.55f, 0.56f, 0.58f});
        for (int i = 0; i < kColumns; ++i)
            if (rng.chance(0.78f)) {
                const float x1 = (static_cast<float>(i) + 0.9f) / kColumns,
                            x0 = i == 0 ? 0.01f : x1 - rng.uniform(0.03f, 0.07f);
                p.fill(spot(p, x0, y), spot(p, x1, y + 0.014f), i == 6 && rng.chance(0.4f) ? kRedAccent : kTextGray);
            }
    }
    p.fill(spot(p, 0.56f, 0.12f), spot(p, 0.96f, 0.52f), kShownWhite);
    bars(p, rng, spot(p, 0.6f, 0.17f), spot(p, 0.93f, 0.46f), 8, kGreenAccent);
    task_bar(p);
}

void desktop(Patch& p, Random& rng, int variant) {
    if (variant == 0) return windows_open(p, rng);
    if (variant == 1) return code(p, rng);
    if (variant == 2) return dashboard(p, rng);
    table_of_numbers(p, rng);
}

// ---- talks

void slides(Patch& p, Random& rng, int variant) {
    if (variant == 1) {
        fade(p, {0, 0}, {p.w, p.h}, {0.04f, 0.16f, 0.4f}, {0.015f, 0.04f, 0.14f});
        ridge(p, 0.26f, 0.07f, 5, 1.f, {0.06f, 0.26f, 0.5f}), ridge(p, 0.17f, 0.06f, 6, 3.f, {0.1f, 0.42f, 0.62f});
        p.title("WELCOME", 0.5f * p.w, 0.58f * p.h, 0.7f * p.w, 0.16f * p.h, kShownWhite);
        p.fill(spot(p, 0.32f, 0.53f), spot(p, 0.68f, 0.54f), kAmberAccent);
        p.title("ANNUAL MEETING", 0.5f * p.w, 0.43f * p.h, 0.5f * p.w, 0.055f * p.h, {0.6f, 0.7f, 0.85f});
        return;
    }
    p.fill({0.86f, 0.87f, 0.88f});
    p.fill(spot(p, 0, 0.84f), spot(p, 1, 1), {0.02f, 0.07f, 0.2f});
    p.title(variant == 0 ? "QUARTERLY RESULTS" : "OUR PLAN", 0.5f * p.w, 0.885f * p.h, 0.8f * p.w, 0.07f * p.h,
            kShownWhite);
    p.fill({0, 0}, spot(p, 1, 0.035f), kAmberAccent);
    for (int i = 0; i < 4; ++i) {
        const float y = 0.68f - 0.15f * static_cast<float>(i);
        p.disc(spot(p, 0.075f, y + 0.02f), Vec2f{0.011f, 0.011f} * p.w, kAmberAccent);
        text_lines(p, rng, spot(p, 0.11f, y - 0.065f), spot(p, 0.46f, y + 0.055f), 0.055f * p.h, kTextGray);
    }
    if (variant == 0) return bars(p, rng, spot(p, 0.54f, 0.14f), spot(p, 0.94f, 0.74f), 7, kBlueAccent);
    constexpr std::array<const char*, 3> kSteps{"IDEA", "TEST", "LAUNCH"};
    for (int i = 0; i < 3; ++i) {
        const float y = 0.6f - 0.22f * static_cast<float>(i);
        p.fill(spot(p, 0.58f, y), spot(p, 0.92f, y + 0.14f), kAccents[static_cast<std::size_t>(i)]);
        p.title(kSteps[static_cast<std::size_t>(i)], 0.75f * p.w, (y + 0.04f) * p.h, 0.26f * p.w, 0.06f * p.h,
                kShownWhite);
        if (i > 0) p.line(spot(p, 0.75f, y + 0.215f), spot(p, 0.75f, y + 0.15f), 5, kTextGray);
    }
}

// ---- counters and machines

void check_in(Patch& p, Random& rng, int variant) {
    static constexpr std::array<const char*, 4> kTowns{"OSLO", "LISBON", "VIENNA", "TOKYO"},
        kFlights{"NA 214", "TP 1307", "OS 88", "JX 402"};
    const auto i = static_cast<std::size_t>(variant);
    fade(p, {0, 0}, {p.w, p.h}, {0.01f, 0.03f, 0.09f}, {0.02f, 0.06f, 0.17f});
    p.fill(spot(p, 0, 0.78f), spot(p, 1, 1), kAccents[i]);
    p.title("CHECK-IN", 0.5f * p.w, 0.83f * p.h, 0.7f * p.w, 0.11f * p.h, kShownWhite);
    p.title(kTowns[i], 0.5f * p.w, 0.42f * p.h, 0.86f * p.w, 0.22f * p.h, {1.f, 0.78f, 0.12f});
    p.title(kFlights[i], 0.3f * p.w, 0.16f * p.h, 0.4f * p.w, 0.12f * p.h, kShownWhite);
    p.title(rng.chance(0.5f) ? "14:25" : "09:40", 0.78f * p.w, 0.16f * p.h, 0.3f * p.w, 0.12f * p.h, kShownWhite);
}
void till_screen(Patch& p, Random& rng, int) {
    p.fill({0.1f, 0.11f, 0.13f});
    p.fill(spot(p, 0.02f, 0.04f), spot(p, 0.33f, 0.96f), kPaperWhite);
    text_lines(p, rng, spot(p, 0.04f, 0.3f), spot(p, 0.24f, 0.92f), 0.07f * p.h, kTextGray);
    text_lines(p, rng, spot(p, 0.27f, 0.3f), spot(p, 0.32f, 0.92f), 0.07f * p.h, kTextGray);
    p.title("24.80", 0.175f * p.w, 0.1f * p.h, 0.26f * p.w, 0.11f * p.h, kTextGray);
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 5; ++i) {
            const Vec2f low = spot(p, 0.36f + 0.126f * static_cast<float>(i), 0.05f + 0.23f * static_cast<float>(j)),
                        high = low + Vec2f{0.11f * p.w, 0.2f * p.h};
            p.fill(low, high,
                   lerp(kAccents[static_cast<std::size_t>(rng.index(4))], kShownWhite, rng.uniform(0.05f, 0.3f)));
            p.fill(low + Vec2f{0.015f * p.w, 0.08f * p.h}, low + Vec2f{rng.uniform(0.05f, 0.095f) * p.w, 0.11f * p.h},
                   kShownWhite);
        }
}
void tickets(Patch& p, Random& rng, int) {
    p.fill({0.8f, 0.82f, 0.85f});
    p.fill(spot(p, 0, 0.86f), spot(p, 1, 1), kBlueAccent);
    p.title("TICKETS", 0.22f * p.w, 0.895f * p.h, 0.34f * p.w, 0.07f * p.h, kShownWhite);
    for (std::size_t l = 0; l < kAccents.size(); ++l) {
        Vec2f at = spot(p, 0.06f, 0.3f + 0.14f * static_cast<float>(l));
        for (int i = 0; i < 6; ++i) {
            const Vec2f next = at + Vec2f{0.095f * p.w, rng.index(3) == 0 ? rng.uniform(-0.12f, 0.12f) * p.h : 0.f};
            p.line(at, next, 6, kAccents[l]);
            p.disc(next, {6, 6}, kTextGray), p.disc(next, {4, 4}, kShownWhite);
            at = next;
        }
    }
    for (int i = 0; i < 4; ++i) {
        const float y = 0.64f - 0.17f * static_cast<float>(i);
        p.fill(spot(p, 0.7f, y), spot(p, 0.97f, y + 0.14f), lerp(kBlueAccent, kShownWhite, 0.1f));
        p.fill(spot(p, 0.74f, y + 0.05f), spot(p, rng.uniform(0.84f, 0.93f), y + 0.09f), kShownWhite);
    }
    p.fill(spot(p, 0.05f, 0.06f), spot(p, 0.3f, 0.17f), kRedAccent),
        p.fill(spot(p, 0.36f, 0.06f), spot(p, 0.62f, 0.17f), kGreenAccent);
}
void workout(Patch& p, Random& rng, int) {
    p.fill({0.008f, 0.012f, 0.02f});
    p.disc(spot(p, 0.3f, 0.56f), {0.25f * p.w, 0.33f * p.h}, {0.45f, 0.1f, 0.03f});
    p.disc(spot(p, 0.3f, 0.56f), {0.19f * p.w, 0.22f * p.h}, {0.008f, 0.012f, 0.02f});
    p.disc(spot(p, 0.49f, 0.68f), {10, 10}, kShownWhite);
    p.title("2.4 KM", 0.3f * p.w, 0.52f * p.h, 0.28f * p.w, 0.1f * p.h, kShownWhite);
    p.title("12.5", 0.78f * p.w, 0.68f * p.h, 0.32f * p.w, 0.2f * p.h, {0.3f, 0.95f, 0.4f});
    p.title("18:42", 0.78f * p.w, 0.42f * p.h, 0.32f * p.w, 0.13f * p.h, {0.3f, 0.7f, 1.f});
    bars(p, rng, spot(p, 0.06f, 0.05f), spot(p, 0.94f, 0.2f), 24, {0.1f, 0.5f, 0.85f});
}
void operations(Patch& p, Random& rng, int) {
    p.fill({0.006f, 0.016f, 0.04f});
    // Continents of dots.
    struct Land {
        Vec2f at, size;
    };
    static constexpr std::array<Land, 12> kLands{
        Land{{0.17f, 0.68f}, {0.1f, 0.12f}}, {{0.12f, 0.78f}, {0.09f, 0.07f}}, {{0.22f, 0.52f}, {0.04f, 0.07f}},
        {{0.27f, 0.33f}, {0.05f, 0.13f}},    {{0.28f, 0.42f}, {0.06f, 0.07f}}, {{0.47f, 0.7f}, {0.06f, 0.08f}},
        {{0.49f, 0.46f}, {0.07f, 0.1f}},     {{0.51f, 0.32f}, {0.04f, 0.12f}}, {{0.64f, 0.73f}, {0.14f, 0.12f}},
        {{0.7f, 0.58f}, {0.07f, 0.1f}},      {{0.57f, 0.58f}, {0.04f, 0.06f}}, {{0.8f, 0.31f}, {0.06f, 0.07f}}};
    const auto is_land = [&](Vec2f q) {
        return std::ranges::any_of(kLands, [&](const Land& l) {
            return std::hypot((q.x - l.at.x) / l.size.x, (q.y - l.at.y) / l.size.y) <
                   1.f + 0.12f * std::sin(70.f * q.x + 50.f * q.y);
        });
    };
    for (float y = 0.16f; y < 0.9f; y += 0.022f)
        for (float x = 0.02f; x < 0.9f; x += 0.011f)
            if (is_land({x, y})) p.disc(spot(p, x, y), {2.4f, 2.4f}, {0.06f, 0.42f, 0.62f});
    for (int i = 1; i < 8; ++i) {
        p.fill(spot(p, 0, 0.12f * static_cast<float>(i)), spot(p, 1, 0.12f * static_cast<float>(i)) + Vec2f{0, 1},
               {0.02f, 0.07f, 0.13f});
        p.fill(spot(p, 0.12f * static_cast<float>(i), 0), spot(p, 0.12f * static_cast<float>(i), 1) + Vec2f{1, 0},
               {0.02f, 0.07f, 0.13f});
    }
    for (int i = 0; i < 9; ++i) {
        const Vec2f a = kLands[static_cast<std::size_t>(rng.index(12))].at,
                    b = kLands[static_cast<std::size_t>(rng.index(12))].at;
        Vec2f last = spot(p, a.x, a.y);
        for (int n = 1; n <= 16; ++n) {
            const float t = static_cast<float>(n) / 16;
            const Vec2f q = spot(p, a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t + 0.35f * t * (1 - t));
            p.line(last, q, 1.6f, {0.9f, 0.5f, 0.08f});
            last = q;
        }
        p.disc(last, {5, 5}, {1.f, 0.3f, 0.1f});
    }
    p.fill(spot(p, 0.83f, 0.06f), spot(p, 0.985f, 0.94f), {0.012f, 0.045f, 0.09f});
    for (int i = 0; i < 4; ++i) {
        const float y = 0.1f + 0.21f * static_cast<float>(i);
        if (i % 2 == 0) bars(p, rng, spot(p, 0.845f, y), spot(p, 0.97f, y + 0.15f), 9, {0.1f, 0.7f, 0.5f});
        else curve(p, rng, spot(p, 0.845f, y), spot(p, 0.97f, y + 0.15f), {0.3f, 0.8f, 1.f}, 2);
    }
    p.title("NETWORK STATUS", 0.16f * p.w, 0.93f * p.h, 0.28f * p.w, 0.035f * p.h, {0.5f, 0.8f, 1.f});
}

}  // namespace

std::span<const ScreenStyle> screen_styles() {
    static constexpr std::array<ScreenStyle, static_cast<std::size_t>(Shown::count)> kAll{{
        {"film", 3, 960, 540, film},
        {"television", 3, 640, 366, broadcast},
        {"computer screen", 4, 640, 384, desktop},
        {"slides", 3, 800, 450, slides},
        {"game", 3, 480, 372, game},
        {"marquee", 3, 480, 160, marquee},
        {"reels", 2, 400, 284, reels},
        {"jackpot sign", 1, 400, 200, jackpot},
        {"check-in screen", 4, 480, 180, check_in},
        {"till screen", 2, 400, 262, till_screen},
        {"ticket screen", 2, 400, 300, tickets},
        {"treadmill screen", 2, 420, 200, workout},
        {"video wall", 2, 1200, 640, operations},
    }};
    return kAll;
}

}  // namespace fastscene::furniture::screens

// Of television studios.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"
#include "fastscene/rooms/furniture/print.h"
#include "fastscene/rooms/furniture/screen.h"

namespace fastscene::furniture {
// A camera with a prompter on a wheeled pedestal; it looks along +z.
void build_studio_camera(Kit& k) {
    const int body = k.main(plain("camera", {0.03f, 0.031f, 0.033f}, 0.45f)), metal = k.material(steel()),
              lens = color(k, "lens", {0.01f, 0.012f, 0.02f}, 0.05f), pane = k.material(glass()),
              shown = lit_screen(k, Shown::broadcast, kMonitorWhite, 0.3f), tally = k.material([] {
                  Material m = glow("tally", {4.f, 0.15f, 0.1f});
                  m.pattern = Pattern::screen;
                  return m;
              }());
    for (int i = 0; i < 3; ++i) {
        const Vec3f out = around(kTau * static_cast<float>(i) / 3 + 0.5f);
        k.rod(body, {0, 0.16f, 0}, out * 0.42f + Vec3f{0, 0.12f, 0}, 0.04f, -1, 10);
        k.add(shapes::ball(out * 0.42f + Vec3f{0, 0.06f, 0}, {0.06f, 0.06f, 0.06f}, 12), body);
    }
    const std::array<Vec2f, 4> column{Vec2f{0.13f, 0.1f}, {0.12f, 0.7f}, {0.07f, 0.72f}, {0.07f, 1.05f}};
    k.add(shapes::lathe(column, 24), body);
    k.add(shapes::ring(0.26f, 0.016f, 32), metal, {0, 0.82f, 0});
    k.board(metal, {0, 1.05f, 0}, {0.16f, 0.1f, 0.22f}, 0.01f);
    k.board(body, {0, 1.15f, -0.06f}, {0.2f, 0.26f, 0.5f}, 0.015f);
    const std::array<Vec2f, 5> barrel{Vec2f{0.09f, 0}, {0.09f, 0.2f}, {0.1f, 0.22f}, {0.1f, 0.34f}, {0.085f, 0.35f}};
    Mesh tube = shapes::lathe(barrel, 24);
    shapes::turn(tube, {1, 0, 0}, 90);
    k.add(std::move(tube), body, {0, 1.28f, 0.18f});
    k.add(shapes::ball({0, 1.28f, 0.5f}, {0.082f, 0.082f, 0.04f}, 18), lens);
    // The prompter: a hood, a pane at 45 degrees, its display below.
    k.board(body, {0, 1.06f, 0.66f}, {0.36f, 0.03f, 0.3f}, 0.006f);
    Mesh prompter = screen_box({0.3f, 0.24f, 0.004f}), finder = screen_box({0.2f, 0.14f, 0.004f});
    shapes::turn(prompter, {1, 0, 0}, -90), shapes::turn(finder, {0, 1, 0}, 180);
    k.add(std::move(prompter), shown, {0, 1.094f, 0.78f});
    Mesh sheet = shapes::box({0.34f, 0.4f, 0.006f}, 0.001f);
    shapes::turn(sheet, {1, 0, 0}, 45);
    k.add(std::move(sheet), pane, {0, 1.26f, 0.66f});
    for (const float sx : {-1.f, 1.f}) k.board(body, {sx * 0.18f, 1.08f, 0.62f}, {0.012f, 0.36f, 0.36f}, 0.003f);
    k.board(body, {0, 1.43f, 0.6f}, {0.38f, 0.012f, 0.34f}, 0.003f);
    // Viewfinder, tally lamp, pan bars.
    k.board(body, {0, 1.42f, -0.2f}, {0.24f, 0.18f, 0.1f}, 0.01f);
    k.add(std::move(finder), shown, {0, 1.44f, -0.254f});
    block(k, tally, {0, 1.6f, -0.2f}, {0.08f, 0.03f, 0.05f});
    for (const float sx : {-1.f, 1.f})
        k.rod(metal, {sx * 0.09f, 1.1f, -0.05f}, {sx * 0.3f, 0.98f, -0.66f}, 0.013f, -1, 8);
    k.piece.clearance_front_m = 0.6f;
}

// Lamps with barn doors and soft panels on pipes below the ceiling.
void build_studio_lights(Kit& k) {
    const Vec3f s = k.wanted({3.2f, 0.8f, 0.9f});
    const int black = k.main(plain("lamp housing", {0.02f, 0.02f, 0.022f}, 0.5f)), metal = k.material(steel()),
              lens = k.material(glow("studio lamp", {22, 20, 17}));
    for (const float sz : {-1.f, 1.f})
        k.rod(metal, {-0.5f * s.x, -0.12f, sz * 0.3f * s.z}, {0.5f * s.x, -0.12f, sz * 0.3f * s.z}, 0.025f);
    for (const float sx : {-1.f, 0.f, 1.f})
        k.rod(metal, {sx * 0.42f * s.x, 0, 0.3f * s.z}, {sx * 0.42f * s.x, -0.12f, 0.3f * s.z}, 0.014f);
    const int lamps = std::max(2, static_cast<int>(s.x / 0.8f));
    for (int i = 0; i < lamps; ++i) {
        const float x = -0.5f * s.x + s.x * (static_cast<float>(i) + 0.5f) / static_cast<float>(lamps),
                    z = (i % 2 == 0 ? 0.3f : -0.3f) * s.z, y = -s.y + 0.26f;
        k.rod(metal, {x, -0.12f, z}, {x, y + 0.16f, z}, 0.012f, -1, 8);
        if (i % 3 == 1) {  // a soft panel
            Mesh box = shapes::box({0.5f, 0.06f, 0.4f}, 0.008f), face = shapes::box({0.46f, 0.01f, 0.36f}, 0.002f);
            for (Mesh* m : {&box, &face}) shapes::turn(*m, {1, 0, 0}, 18);
            k.add(std::move(box), black, {x, y + 0.1f, z}), k.add(std::move(face), lens, {x, y + 0.065f, z + 0.01f});
            continue;
        }
        const std::array<Vec2f, 4> can{Vec2f{0.1f, 0}, {0.12f, 0.08f}, {0.12f, 0.26f}, {0.06f, 0.32f}};
        const std::array<Vec2f, 2> disc{Vec2f{0.095f, 0.005f}, {0.095f, 0.015f}};
        Mesh body = shapes::lathe(can, 20), eye = shapes::lathe(disc, 20);
        for (Mesh* m : {&body, &eye}) shapes::turn(*m, {1, 0, 0}, 25);
        k.add(std::move(body), black, {x, y - 0.1f, z}), k.add(std::move(eye), lens, {x, y - 0.11f, z - 0.004f});
        for (const float side : {-1.f, 1.f}) {
            Mesh leaf = shapes::box({0.16f, 0.004f, 0.13f}, 0.001f);
            shapes::turn(leaf, {0, 0, 1}, side * 60.f);
            k.add(std::move(leaf), black, {x + side * 0.13f, y - 0.15f, z});
        }
    }
    k.piece.mount = Mount::ceiling;
}

// A curved green wall that runs out onto the floor.
void build_green_screen(Kit& k) {
    const Vec3f s = k.wanted({3.6f, 2.7f, 1.9f});
    const int green = k.main(plain("chroma green", {0.03f, 0.45f, 0.07f}, 0.9f)), metal = k.material(steel());
    constexpr float kBend = 0.45f;
    const float flat_m = s.z - kBend - 0.06f, arc = 0.5f * kPi * kBend, up = s.y - kBend - 0.04f,
                all = flat_m + arc + up;
    k.add(
        shapes::slab(4, 40, 0.012f,
                     [&](float u, float v) {
                         const float at = v * all, x = s.x * (u - 0.5f), front = 0.5f * s.z;
                         if (at < flat_m) return Vec3f{x, 0.014f, front - at};
                         if (at < flat_m + arc) {
                             const float a = (at - flat_m) / kBend;
                             return Vec3f{x, 0.014f + kBend * (1 - std::cos(a)), front - flat_m - kBend * std::sin(a)};
                         }
                         return Vec3f{x, 0.014f + kBend + at - flat_m - arc, front - flat_m - kBend};
                     }),
        green);
    for (const float sx : {-1.f, 1.f})
        k.rod(metal, {sx * (0.5f * s.x - 0.05f), 0, -0.5f * s.z + 0.03f},
              {sx * (0.5f * s.x - 0.05f), s.y, -0.5f * s.z + 0.03f}, 0.022f);
    k.rod(metal, {-0.5f * s.x, s.y - 0.02f, -0.5f * s.z + 0.03f}, {0.5f * s.x, s.y - 0.02f, -0.5f * s.z + 0.03f},
          0.02f);
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.8f;
}

// The desk of those who read the news: curved, with a lit front.
void build_news_desk(Kit& k) {
    const Vec3f s = k.wanted({2.8f, 0.95f, 1.1f});
    const int body = k.main(plain("desk", {0.03f, 0.05f, 0.12f}, 0.2f)),
              top = color(k, "desk top", {0.6f, 0.61f, 0.62f}, 0.08f),
              paper = color(k, "paper", {0.75f, 0.75f, 0.73f}, 0.9f),
              lid = color(k, "laptop", {0.3f, 0.3f, 0.31f}, 0.3f), stripe = k.material([&] {
                  Material m = glow("lit edge", {0.35f, 0.9f, 2.6f});
                  m.pattern = Pattern::screen;
                  return m;
              }());
    const float sag = 0.32f;
    const auto bow = [&](float u) { return sag * (1.f - 4.f * (u - 0.5f) * (u - 0.5f)); };
    std::vector<Vec2f> outline;
    constexpr int kSteps = 18;
    for (int i = 0; i <= kSteps; ++i) {
        const float u = static_cast<float>(i) / kSteps;
        outline.push_back({0.5f * s.x - s.x * u, 0.5f * s.z - sag + bow(u)});
    }
    for (int i = 0; i <= kSteps; ++i) {
        const float u = 1.f - static_cast<float>(i) / kSteps;
        outline.push_back({0.5f * s.x - s.x * u, -0.5f * s.z + bow(u)});
    }
    std::reverse(outline.begin(), outline.end());
    k.add(shapes::prism(outline, s.y - 0.05f, s.y, 0.008f), top);
    const auto front = [&](float low, float high, float out, int material) {
        k.add(shapes::slab(24, 1, 0.02f,
                           [&](float u, float v) {
                               return Vec3f{(s.x - 0.1f) * (u - 0.5f), std::lerp(low, high, v),
                                            0.5f * s.z - sag - 0.06f + out + bow(u)};
                           }),
              material);
    };
    front(0.06f, s.y - 0.05f, 0, body), front(s.y - 0.16f, s.y - 0.12f, 0.012f, stripe),
        front(0.12f, 0.15f, 0.012f, stripe);
    for (const float sx : {-1.f, 1.f})
        k.board(body, {sx * (0.5f * s.x - 0.1f), 0, -0.18f}, {0.1f, s.y - 0.05f, 0.6f}, 0.01f);
    k.add(shapes::ball({0, 0.5f, 0.5f * s.z - 0.05f}, {0.2f, 0.2f, 0.02f}, 24), stripe);
    for (const float sx : {-1.f, 1.f}) {
        k.board(paper, {sx * 0.55f, s.y, -0.02f + 0.1f}, {0.21f, 0.012f, 0.297f}, 0.001f);
        k.board(lid, {sx * 0.95f, s.y, 0.02f}, {0.34f, 0.018f, 0.23f}, 0.004f);
        Mesh screen_lid = shapes::box({0.34f, 0.22f, 0.01f}, 0.003f);
        shapes::turn(screen_lid, {1, 0, 0}, -15);
        k.add(std::move(screen_lid), lid, {sx * 0.95f, s.y + 0.12f, 0.16f});
    }
    k.piece.clearance_front_m = 1.f;
}

// Screens side by side, one picture over all of them.
void build_video_wall(Kit& k) {
    constexpr Vec3f kWallWhite{1.3f, 1.3f, 1.3f};
    constexpr float kInset = 0.002f;  // share of the picture that a bezel hides
    const Vec3f s = k.wanted({3.6f, 1.9f, 0.12f});
    const int frame = k.main(plain("bezel", {0.015f, 0.015f, 0.016f}, 0.35f)),
              shown = lit_screen(k, Shown::operations, kWallWhite, s.x);
    const int columns = std::max(1, static_cast<int>(std::lround(s.x / 1.1f))),
              rows = std::max(1, static_cast<int>(std::lround(s.y / 0.63f)));
    k.board(frame, {0, 0, 0.5f * s.z}, s, 0.01f);
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const float w = s.x / static_cast<float>(columns), h = s.y / static_cast<float>(rows);
            const Vec2f low{static_cast<float>(i) / static_cast<float>(columns),
                            static_cast<float>(j) / static_cast<float>(rows)},
                high = low + Vec2f{1.f / static_cast<float>(columns), 1.f / static_cast<float>(rows)};
            k.add(printed_box({low + Vec2f{kInset, kInset}, high - Vec2f{kInset, kInset}},
                              {w - 0.018f, h - 0.024f, 0.008f}),
                  shown, {-0.5f * s.x + w * (static_cast<float>(i) + 0.5f), h * static_cast<float>(j) + 0.012f, s.z});
        }
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 0.75f;
}

}  // namespace fastscene::furniture

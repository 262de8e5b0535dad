// Of schools: desks, a lectern, a screen; and the benches and shelves of laboratories and computer rooms.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"
#include "fastscene/rooms/furniture/screen.h"

namespace fastscene::furniture {

// A pupil's table for two: a pale top on a steel frame, a shelf for books below.
void build_school_desk(Kit& k) {
    const Vec3f s = k.wanted({1.25f, 0.74f, 0.52f});
    const int top = k.main(materials::timber("natural", 0.35f)),
              steel_tube = color(k, "frame", {0.1f, 0.12f, 0.14f}, 0.35f);
    k.add(shapes::prism(shapes::rounded_rectangle(s.x, s.z, 0.04f), s.y - 0.025f, s.y, 0.006f), top);
    for (const float sx : {-1.f, 1.f}) {
        const float x = sx * (0.5f * s.x - 0.09f);
        k.rod(steel_tube, {x, s.y - 0.03f, 0}, {x, 0.03f, 0}, 0.02f, -1, 10);
        k.rod(steel_tube, {x, 0.022f, -0.5f * s.z + 0.03f}, {x, 0.022f, 0.5f * s.z - 0.03f}, 0.02f, -1, 10);
    }
    k.rod(steel_tube, {-0.5f * s.x + 0.09f, 0.32f, 0}, {0.5f * s.x - 0.09f, 0.32f, 0}, 0.014f, -1, 8);
    k.board(steel_tube, {0, s.y - 0.15f, -0.05f}, {s.x - 0.24f, 0.008f, s.z - 0.2f}, 0.002f);
    if (k.rng.chance(0.6f)) {
        const int paper = color(k, "exercise book", {0.7f, 0.69f, 0.64f}, 0.9f),
                  cover = color(k, "cover", k.accent(), 0.6f);
        k.board(cover, {-0.3f, s.y, 0.05f}, {0.17f, 0.012f, 0.23f}, 0.002f);
        k.board(paper, {0.28f, s.y, 0.06f}, {0.3f, 0.006f, 0.21f}, 0.001f);
        k.rod(color(k, "pencil", {0.6f, 0.4f, 0.05f}), {0.2f, s.y + 0.01f, 0.02f}, {0.33f, s.y + 0.01f, 0.05f}, 0.004f,
              -1, 6);
    }
    k.top(s.y, 0, 0, 0.42f * s.x, 0.4f * s.z);
    k.piece.clearance_front_m = 0.5f;
}

// Of lecture theatres: a writing top with a panel before the knees, and two folding seats behind it that stand up by
// themselves. Side by side they are one long bench.
void build_lecture_bench(Kit& k) {
    constexpr float kTop = 0.74f, kThick = 0.028f, kWriting = 0.34f, kLowest = 0.14f;
    const Vec3f s = k.wanted({1.1f, 0.86f, 0.86f});
    const int wood = k.main(k.style.wood), cloth = k.material(tinted(k.style.fabric, {0.05f, 0.06f, 0.08f})),
              steel_frame = color(k, "frame", {0.06f, 0.065f, 0.07f}, 0.4f);
    const float front = 0.5f * s.z, back = -front;
    k.board(wood, {0, kTop - kThick, front - 0.5f * kWriting}, {s.x, kThick, kWriting}, 0.004f);
    k.board(wood, {0, kLowest, front - 0.03f}, {s.x, kTop - kThick - kLowest, 0.02f}, 0.003f);
    for (const float sx : {-1.f, 1.f}) {
        const float x = sx * (0.5f * s.x - 0.06f);
        k.board(steel_frame, {x, 0.012f, front - 0.16f}, {0.04f, kTop - kThick - 0.012f, 0.07f}, 0.004f);
        k.board(steel_frame, {x, 0, front - 0.2f}, {0.06f, 0.014f, 0.3f}, 0.004f);
        k.board(steel_frame, {x, 0.012f, back + 0.1f}, {0.04f, 0.44f, 0.07f}, 0.004f);
        k.board(steel_frame, {x, 0, back + 0.12f}, {0.06f, 0.014f, 0.22f}, 0.004f);
    }
    k.board(steel_frame, {0, 0.4f, back + 0.1f}, {s.x - 0.12f, 0.05f, 0.05f}, 0.004f);
    for (const float sx : {-1.f, 1.f}) {
        const float x = 0.25f * sx * s.x;
        Mesh shell = shapes::box({0.48f, 0.4f, 0.02f}, 0.008f),
             pad = shapes::soft_box({0.44f, 0.34f, 0.03f}, {0.012f, 0.006f, 0.001f, 3, k.seed()}),
             folded = shapes::box({0.44f, 0.4f, 0.028f}, 0.008f);
        shapes::turn(shell, {1, 0, 0}, -7);
        shapes::turn(pad, {1, 0, 0}, -7);
        shapes::turn(folded, {1, 0, 0}, -4);
        k.add(std::move(shell), wood, {x, 0.66f, back + 0.045f});
        k.add(std::move(pad), cloth, {x, 0.67f, back + 0.068f});
        k.add(std::move(folded), wood, {x, 0.62f, back + 0.135f});
    }
    k.top(kTop, 0, front - 0.5f * kWriting, 0.46f * s.x, 0.42f * kWriting);
    k.piece.clearance_front_m = 0.2f;
}

void build_lectern(Kit& k) {
    const int wood = k.main(k.style.wood), metal = k.material(k.style.metal);
    k.board(wood, {0, 0, -0.02f}, {0.56f, 0.06f, 0.46f}, 0.01f);
    k.board(wood, {0, 0.06f, 0}, {0.46f, 0.98f, 0.34f}, 0.008f);
    k.board(wood, {0, 0.2f, 0.172f}, {0.32f, 0.7f, 0.014f}, 0.006f);
    Mesh slope = shapes::box({0.62f, 0.03f, 0.48f}, 0.006f), lip = shapes::box({0.62f, 0.05f, 0.02f}, 0.004f);
    shapes::turn(slope, {1, 0, 0}, -18);
    k.add(std::move(slope), wood, {0, 1.12f, 0});
    k.add(std::move(lip), wood, {0, 1.06f, -0.24f});
    const std::array<Vec3f, 4> neck{
        Vec3f{0.2f, 1.13f, 0.1f}, {0.2f, 1.28f, 0.08f}, {0.17f, 1.36f, -0.02f}, {0.12f, 1.38f, -0.1f}};
    k.add(shapes::tube(neck, 0.006f), metal);
    k.rod(color(k, "microphone", {0.03f, 0.03f, 0.03f}), {0.12f, 1.38f, -0.1f}, {0.09f, 1.375f, -0.15f}, 0.016f);
    k.piece.clearance_front_m = 0.6f;
}

// A white cloth that shows a picture, in a black border.
void build_projector_screen(Kit& k) {
    const Vec3f s = k.wanted({2.8f, 0, 0});
    const float w = s.x, h = s.y > 0 ? s.y : 0.5625f * w;
    const int border = k.main(plain("screen border", {0.02f, 0.02f, 0.02f}, 0.9f));
    // Cloth, not glass: matt. Its own white would let the lamps of the room wash out the picture.
    constexpr Vec3f kProjected{1.9f, 1.85f, 1.8f};
    const int shown = lit_screen(k, k.request.pattern == kFilmPattern ? Shown::film : Shown::slides, kProjected,
                                 w - 0.12f);
    Material& cloth = k.piece.materials[static_cast<std::size_t>(shown)];
    cloth.color_a = cloth.color_b = cloth.color_c = {0.06f, 0.06f, 0.06f}, cloth.roughness = 0.9f;
    k.board(border, {0, 0, 0.02f}, {w, h, 0.04f}, 0.006f);
    k.add(screen_box({w - 0.12f, h - 0.12f, 0.004f}), shown, {0, 0.06f, 0.042f});
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 0.95f;
}

namespace {

void flask(Kit& k, int clear, int liquid, Vec3f at, float size) {
    const std::array<Vec2f, 4> body{Vec2f{0.055f * size, 0},
                                    {0.05f * size, 0.02f * size},
                                    {0.016f * size, 0.12f * size},
                                    {0.018f * size, 0.17f * size}};
    k.add(shapes::lathe(body, 12, true), clear, at);
    const std::array<Vec2f, 3> in{
        Vec2f{0.05f * size, 0.004f}, {0.045f * size, 0.02f * size}, {0.034f * size, 0.06f * size}};
    k.add(shapes::lathe(in, 12, true), liquid, at);
}

}  // namespace

// A laboratory's island: cupboards, a dark resin top, taps, glassware, a microscope, a shelf down the middle.
void build_lab_bench(Kit& k) {
    const Vec3f s = k.wanted({2.4f, 0.92f, 0.9f});
    const int body = k.main(plain("lab lacquer", {0.68f, 0.69f, 0.68f}, 0.4f)),
              top = color(k, "resin top", {0.03f, 0.032f, 0.036f}, 0.3f), metal = k.material(steel()),
              clear = k.material(glass()), dark = color(k, "plinth", {0.05f, 0.05f, 0.05f}, 0.6f);
    k.board(dark, {0, 0, 0}, {s.x - 0.1f, 0.1f, s.z - 0.14f});
    k.board(body, {0, 0.1f, 0}, {s.x - 0.04f, s.y - 0.14f, s.z - 0.08f});
    fronts(k, body, metal, -0.5f * s.x + 0.03f, 0.5f * s.x - 0.03f, 0.12f, s.y - 0.06f, 0.5f * s.z - 0.04f, 4, 2);
    k.board(top, {0, s.y - 0.04f, 0}, {s.x, 0.04f, s.z}, 0.005f);
    for (const float sx : {-1.f, 0.f, 1.f})
        k.rod(metal, {sx * (0.5f * s.x - 0.1f), s.y, 0}, {sx * (0.5f * s.x - 0.1f), s.y + 0.62f, 0}, 0.018f);
    for (const float y : {0.34f, 0.62f}) k.board(clear, {0, s.y + y, 0}, {s.x - 0.1f, 0.012f, 0.26f}, 0.002f);
    static constexpr std::array<Vec3f, 5> kLiquids{Vec3f{0.04f, 0.2f, 0.5f},
                                                   {0.5f, 0.1f, 0.04f},
                                                   {0.1f, 0.4f, 0.12f},
                                                   {0.55f, 0.4f, 0.05f},
                                                   {0.35f, 0.06f, 0.35f}};
    constexpr float kFreeTop = 0.28f;  // to both sides of the middle, at the front, others may stand
    for (int i = 0; i < 12; ++i) {
        const int liquid = color(k, "liquid", kLiquids[static_cast<std::size_t>(k.rng.index(5))], 0.15f);
        const float x = -0.5f * s.x + 0.2f + (s.x - 0.4f) * (static_cast<float>(i % 6) + 0.5f) / 6 +
                        k.rng.uniform(-0.05f, 0.05f);
        if (i < 6) flask(k, liquid, liquid, {x, s.y + 0.352f, 0}, k.rng.uniform(0.9f, 1.3f));
        else if (const bool front = i % 2 == 0 && std::abs(x) > kFreeTop; k.rng.chance(0.7f))
            flask(k, liquid, liquid, {x, s.y, front ? 0.26f : -0.26f}, 1.3f);
    }
    // A microscope.
    const int white = color(k, "microscope", {0.7f, 0.7f, 0.68f}, 0.3f),
              black = color(k, "tube", {0.03f, 0.03f, 0.03f}, 0.3f);
    const Vec3f m{0.3f * s.x, s.y, 0.24f};
    k.board(black, m, {0.15f, 0.03f, 0.2f}, 0.006f);
    k.board(white, m + Vec3f{0, 0.03f, -0.07f}, {0.05f, 0.26f, 0.05f}, 0.012f);
    k.board(black, m + Vec3f{0, 0.12f, 0.02f}, {0.12f, 0.012f, 0.12f}, 0.002f);
    k.rod(white, m + Vec3f{0, 0.17f, 0.02f}, m + Vec3f{0, 0.38f, 0.1f}, 0.024f, 0.02f);
    // A sink with a bent tap.
    const std::array<Vec3f, 4> tap{Vec3f{-0.42f * s.x, s.y, 0.12f},
                                   {-0.42f * s.x, s.y + 0.3f, 0.12f},
                                   {-0.42f * s.x, s.y + 0.34f, 0.2f},
                                   {-0.42f * s.x, s.y + 0.26f, 0.25f}};
    k.add(shapes::tube(tap, 0.012f), metal);
    k.board(metal, {-0.42f * s.x, s.y - 0.002f, 0.26f}, {0.3f, 0.006f, 0.22f}, 0.002f);
    k.top(s.y, 0, 0.28f, 0.2f, 0.12f);
    k.piece.clearance_front_m = 0.9f;
}

// A dark cabinet of machines with blinking lights.
void build_server_rack(Kit& k) {
    const Vec3f s = k.wanted({0.6f, 2.05f, 0.95f});
    const int body = k.main(plain("rack", {0.03f, 0.03f, 0.033f}, 0.4f)),
              unit = color(k, "unit", {0.09f, 0.095f, 0.1f}, 0.35f),
              bright = color(k, "bezel", {0.3f, 0.31f, 0.32f}, 0.3f);
    const std::array<int, 3> leds{k.material(flame("green led", {0.3f, 5.f, 0.8f})),
                                  k.material(flame("blue led", {0.3f, 1.4f, 6.f})),
                                  k.material(flame("amber led", {5.f, 2.f, 0.1f}))};
    for (const int led : leds) {
        Material& m = k.piece.materials[static_cast<std::size_t>(led)];
        m.burns = false, m.pattern = Pattern::screen, m.color_a = m.color_b = m.color_c = {0.1f, 0.1f, 0.1f};
    }
    for (const float sx : {-1.f, 1.f}) k.board(body, {sx * (0.5f * s.x - 0.02f), 0, 0}, {0.04f, s.y, s.z}, 0.004f);
    k.board(body, {0, 0, -0.5f * s.z + 0.02f}, {s.x, s.y, 0.04f}, 0.004f);
    for (const float y : {0.f, s.y - 0.06f}) k.board(body, {0, y, 0}, {s.x, 0.06f, s.z}, 0.004f);
    for (float y = 0.08f; y < s.y - 0.16f;) {
        const float h = 0.0445f * static_cast<float>(1 + k.rng.index(3)), z = 0.5f * s.z - 0.05f;
        if (k.rng.chance(0.1f)) {
            y += h;
            continue;
        }
        block(k, unit, {0, y, -0.02f}, {s.x - 0.1f, h - 0.004f, s.z - 0.12f});
        for (int i = 0; i < 7; ++i)
            block(k, bright, {-0.19f + 0.055f * static_cast<float>(i), y + 0.008f, z - 0.028f},
                  {0.045f, h - 0.02f, 0.008f});
        for (int i = 0; i < 3; ++i)
            block(k, leds[static_cast<std::size_t>(k.rng.index(5)) % 3],
                  {0.2f + 0.014f * static_cast<float>(i), y + 0.4f * h, z - 0.028f}, {0.007f, 0.007f, 0.01f});
        y += h;
    }
    k.piece.clearance_front_m = 0.9f;
}

// A desk with a screen, a keyboard, a mouse and drawers.
void build_computer_desk(Kit& k) {
    const Vec3f s = k.wanted({1.4f, 0.74f, 0.72f});
    const int top = k.main(k.style.wood), metal = k.material(k.style.metal),
              dark = color(k, "plastic", {0.03f, 0.03f, 0.03f}, 0.4f),
              white = color(k, "pedestal", {0.6f, 0.6f, 0.58f}, 0.4f);
    k.board(top, {0, s.y - 0.028f, 0}, {s.x, 0.028f, s.z}, 0.005f);
    for (const float sx : {-1.f, 1.f}) {
        for (const float sz : {-1.f, 1.f})
            k.board(metal, {sx * (0.5f * s.x - 0.05f), 0, sz * (0.5f * s.z - 0.05f)}, {0.045f, s.y - 0.028f, 0.045f},
                    0.004f);
        k.board(metal, {sx * (0.5f * s.x - 0.05f), s.y - 0.075f, 0}, {0.04f, 0.045f, s.z - 0.1f}, 0.004f);
    }
    k.board(white, {0.5f * s.x - 0.3f, 0.04f, -0.02f}, {0.4f, 0.56f, 0.55f}, 0.006f);
    for (int i = 0; i < 3; ++i)
        k.board(metal, {0.5f * s.x - 0.3f, 0.14f + 0.18f * static_cast<float>(i), 0.262f}, {0.14f, 0.012f, 0.012f},
                0.003f);
    k.merge(k.small("monitor"), {0, s.y, -0.16f});
    k.board(dark, {0, s.y, 0.15f}, {0.43f, 0.018f, 0.14f}, 0.005f);
    k.board(dark, {0.3f, s.y, 0.16f}, {0.06f, 0.03f, 0.1f}, 0.012f);
    if (k.rng.chance(0.5f))
        k.board(color(k, "papers", {0.7f, 0.69f, 0.65f}, 0.9f), {-0.45f, s.y, 0.08f}, {0.21f, 0.02f, 0.3f}, 0.002f);
    k.top(s.y, -0.5f * s.x + 0.2f, -0.12f, 0.14f, 0.14f);
    k.piece.clearance_front_m = 0.6f;
}

// For a dozen: a boat-shaped top on two slabs.
void build_conference_table(Kit& k) {
    const Vec3f s = k.wanted({3.2f, 0.75f, 1.25f});
    const int wood = k.main(k.style.wood), metal = k.material(k.style.metal),
              dark = color(k, "hub", {0.03f, 0.03f, 0.03f}, 0.4f);
    std::vector<Vec2f> outline;
    constexpr int kSteps = 16;
    for (const float side : {1.f, -1.f})
        for (int i = 0; i <= kSteps; ++i) {
            const float t = 2.f * static_cast<float>(i) / kSteps - 1.f;
            outline.push_back({side * -t * 0.5f * s.x, side * -0.5f * s.z * (1.f - 0.14f * t * t)});
        }
    // Counter-clockwise seen from above.
    float area = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2f a = outline[i], b = outline[(i + 1) % outline.size()];
        area += a.x * b.y - a.y * b.x;
    }
    if (area > 0) std::reverse(outline.begin(), outline.end());
    k.add(shapes::prism(outline, s.y - 0.04f, s.y, 0.006f), wood);
    for (const float sx : {-1.f, 1.f}) {
        k.board(wood, {sx * 0.3f * s.x, 0.03f, 0}, {0.08f, s.y - 0.07f, 0.55f * s.z}, 0.006f);
        k.board(metal, {sx * 0.3f * s.x, 0, 0}, {0.16f, 0.03f, 0.62f * s.z}, 0.004f);
    }
    for (const float x : {-0.5f, 0.5f}) k.board(dark, {x, s.y, 0}, {0.24f, 0.012f, 0.12f}, 0.004f);
    k.top(s.y, 0, 0, 0.3f * s.x, 0.2f * s.z);
    k.piece.clearance_front_m = 0.6f;
}

}  // namespace fastscene::furniture

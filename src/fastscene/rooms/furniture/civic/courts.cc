// Of courts, banks, dungeons, temples and observatories.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {
namespace {

// A front of boards with raised panels, on the plane z.
void panels(Kit& k, int wood, float x0, float x1, float y0, float y1, float z, int count) {
    const float w = (x1 - x0) / static_cast<float>(count);
    for (int i = 0; i < count; ++i)
        k.board(wood, {x0 + w * (static_cast<float>(i) + 0.5f), y0 + 0.1f, z + 0.012f},
                {w - 0.16f, y1 - y0 - 0.2f, 0.024f}, 0.012f);
}

}  // namespace

// The judge's bench on its dais: a panelled front, a high chair behind, a coat of arms, a gavel.
void build_judges_bench(Kit& k) {
    const Vec3f s = k.wanted({3.6f, 2.3f, 1.9f});
    const int wood = k.main(k.style.wood), top = k.material(k.style.wood2), gold = k.material(*material_named("brass")),
              hide = k.material(k.style.leather), paper = color(k, "paper", {0.7f, 0.69f, 0.65f}, 0.9f);
    const float front = s.z / 2, dais = 0.36f, desk = 1.3f, hx = s.x / 2;
    k.board(wood, {0, 0, 0}, {s.x, dais, s.z}, 0.01f),
        k.board(top, {0, 0, front - 0.02f}, {s.x, dais / 2, 0.04f}, 0.004f);
    k.board(wood, {0, dais, front - 0.2f}, {s.x - 0.3f, desk - dais, 0.1f}, 0.01f);
    panels(k, wood, -hx + 0.2f, hx - 0.2f, dais, desk, front - 0.15f, 5);
    k.board(top, {0, desk, front - 0.34f}, {s.x - 0.2f, 0.05f, 0.5f}, 0.012f),
        k.board(top, {0, desk + 0.05f, front - 0.14f}, {s.x - 0.3f, 0.12f, 0.04f}, 0.01f);
    for (const float side : {-1.f, 1.f})
        k.board(wood, {side * (hx - 0.2f), dais, front - 0.6f}, {0.1f, desk - dais - 0.1f, 0.8f}, 0.01f);
    // The back wall with pilasters; arms of the law.
    k.board(wood, {0, dais, -front + 0.04f}, {s.x, s.y - dais, 0.08f}, 0.01f);
    panels(k, wood, -hx + 0.1f, hx - 0.1f, dais + 0.1f, s.y - 0.1f, -front + 0.08f, 4);
    for (const float x : {-1.f, -0.34f, 0.34f, 1.f})
        k.board(top, {x * (hx - 0.1f), dais, -front + 0.1f}, {0.14f, s.y - dais, 0.06f}, 0.01f);
    k.board(top, {0, s.y - 0.12f, -front + 0.1f}, {s.x, 0.12f, 0.16f}, 0.02f);
    Mesh disc = shapes::prism(shapes::circle(0.26f, 32), 0, 0.05f, 0.01f), rim = shapes::ring(0.26f, 0.04f, 32);
    for (Mesh* m : {&disc, &rim}) shapes::turn(*m, {1, 0, 0}, 90);
    const Vec3f arms{0, s.y - 0.5f, -front + 0.11f};
    k.add(std::move(disc), wood, arms), k.add(std::move(rim), gold, arms + Vec3f{0, 0, 0.04f});
    // A pair of scales in gold.
    k.rod(gold, arms + Vec3f{0, -0.16f, 0.06f}, arms + Vec3f{0, 0.14f, 0.06f}, 0.014f, -1, 8),
        k.rod(gold, arms + Vec3f{-0.15f, 0.1f, 0.06f}, arms + Vec3f{0.15f, 0.1f, 0.06f}, 0.01f, -1, 8);
    for (const float side : {-1.f, 1.f}) {
        k.rod(gold, arms + Vec3f{side * 0.14f, 0.1f, 0.06f}, arms + Vec3f{side * 0.14f, -0.03f, 0.06f}, 0.004f, -1, 6);
        k.add(shapes::ball(arms + Vec3f{side * 0.14f, -0.04f, 0.06f}, {0.07f, 0.022f, 0.02f}, 14), gold);
    }
    // Three chairs, the middle one the highest.
    for (const float x : {-1.f, 0.f, 1.f}) {
        const float high = x == 0.f ? 1.25f : 1.05f, cx = x * 1.05f, cz = -front + 0.5f;
        k.board(wood, {cx, dais, cz}, {0.5f, 0.42f, 0.46f}, 0.02f),
            k.soft(hide, {cx, dais + 0.42f, cz}, {0.5f, 0.1f, 0.46f}, {0.04f, 0.02f, 0.002f, 12});
        k.soft(hide, {cx, dais + 0.5f, cz - 0.22f}, {0.5f, high - 0.5f, 0.1f}, {0.04f, 0.02f, 0.002f, 12}),
            k.board(wood, {cx, dais + high, cz - 0.22f}, {0.56f, 0.08f, 0.1f}, 0.02f);
    }
    for (int i = 0; i < 3; ++i)
        k.board(paper, {-0.7f + 0.5f * static_cast<float>(i), desk + 0.05f, front - 0.4f}, {0.21f, 0.02f, 0.3f},
                0.002f);
    k.rod(wood, {0.5f, desk + 0.08f, front - 0.38f}, {0.72f, desk + 0.08f, front - 0.3f}, 0.01f, -1, 8),
        k.rod(wood, {0.46f, desk + 0.08f, front - 0.34f}, {0.5f, desk + 0.08f, front - 0.44f}, 0.035f, -1, 14);
    k.piece.against_wall = true, k.piece.clearance_front_m = 1.0f;
}

// A stand with a rail, for a witness.
void build_witness_stand(Kit& k) {
    const Vec3f s = k.wanted({1.15f, 1.25f, 1.1f});
    const int wood = k.main(k.style.wood), top = k.material(k.style.wood2), hide = k.material(k.style.leather),
              black = color(k, "microphone", {0.02f, 0.02f, 0.02f}, 0.5f);
    const float hx = s.x / 2, hz = s.z / 2;
    k.board(wood, {0, 0, 0}, {s.x, 0.18f, s.z}, 0.01f),
        k.board(wood, {0, 0.18f, hz - 0.04f}, {s.x, 0.76f, 0.06f}, 0.01f);
    panels(k, wood, -hx, hx, 0.18f, 0.94f, hz - 0.01f, 2);
    for (const float side : {-1.f, 1.f})
        k.board(wood, {side * (hx - 0.03f), 0.18f, 0.1f}, {0.06f, 0.76f, s.z - 0.3f}, 0.01f),
            k.board(top, {side * (hx - 0.03f), 0.94f, 0.1f}, {0.1f, 0.05f, s.z - 0.26f}, 0.01f);
    k.board(top, {0, 0.94f, hz - 0.1f}, {s.x, 0.05f, 0.22f}, 0.012f);
    k.board(wood, {0, 0.18f, -0.15f}, {0.45f, 0.4f, 0.42f}, 0.01f),
        k.soft(hide, {0, 0.56f, -0.15f}, {0.45f, 0.08f, 0.42f}, {0.03f, 0.02f, 0.002f, 10}),
        k.soft(hide, {0, 0.64f, -0.36f}, {0.45f, 0.55f, 0.08f}, {0.03f, 0.02f, 0.002f, 10});
    k.rod(black, {0.2f, 0.99f, hz - 0.08f}, {0.1f, s.y - 0.02f, hz - 0.16f}, 0.007f, -1, 6),
        k.add(shapes::ball({0.1f, s.y - 0.02f, hz - 0.16f}, {0.02f, 0.02f, 0.03f}, 10), black);
}

// Two rows of seats behind a panelled front, the second higher.
void build_jury_box(Kit& k) {
    const Vec3f s = k.wanted({3.6f, 1.4f, 2.0f});
    const int wood = k.main(k.style.wood), top = k.material(k.style.wood2), hide = k.material(k.style.leather);
    const float hx = s.x / 2, hz = s.z / 2;
    k.board(wood, {0, 0, hz - 0.04f}, {s.x, 0.85f, 0.06f}, 0.01f), panels(k, wood, -hx, hx, 0, 0.85f, hz - 0.01f, 6),
        k.board(top, {0, 0.85f, hz - 0.06f}, {s.x, 0.05f, 0.16f}, 0.012f);
    for (const float side : {-1.f, 1.f}) k.board(wood, {side * (hx - 0.03f), 0, 0}, {0.06f, 0.85f, s.z - 0.1f}, 0.01f);
    k.board(wood, {0, 0, -hz + 0.48f}, {s.x - 0.1f, 0.3f, 0.9f}, 0.01f);
    const int seats = std::max(3, static_cast<int>(s.x / 0.6f));
    for (int row = 0; row < 2; ++row)
        for (int i = 0; i < seats; ++i) {
            const float x = (s.x - 0.2f) * ((static_cast<float>(i) + 0.5f) / static_cast<float>(seats) - 0.5f),
                        y = row == 0 ? 0.f : 0.3f, z = row == 0 ? 0.3f : -0.55f;
            k.rod(wood, {x, y, z}, {x, y + 0.4f, z}, 0.04f, -1, 10),
                k.soft(hide, {x, y + 0.38f, z}, {0.46f, 0.1f, 0.44f}, {0.04f, 0.02f, 0.002f, 5}),
                k.soft(hide, {x, y + 0.48f, z - 0.24f}, {0.46f, 0.6f, 0.08f}, {0.03f, 0.02f, 0.002f, 5});
        }
    k.piece.clearance_front_m = 0.6f;
}

// A counter with glass above it, a window for each teller.
void build_teller_counter(Kit& k) {
    const Vec3f s = k.wanted({4.2f, 2.2f, 0.8f});
    const int wood = k.main(k.style.wood), stone = k.material(*material_named("marble")),
              brass = k.material(*material_named("brass")), pane = k.material(glass()),
              dark = color(k, "screen", {0.03f, 0.03f, 0.035f}, 0.3f);
    const int sign = lit(k, "window number", {2.2f, 1.9f, 1.2f});
    k.board(wood, {0, 0, 0}, {s.x, 1.05f, s.z - 0.1f}, 0.01f),
        k.board(stone, {0, 1.05f, 0}, {s.x + 0.06f, 0.05f, s.z}, 0.01f);
    const int count = std::max(2, static_cast<int>(s.x / 1.3f));
    panels(k, wood, -s.x / 2, s.x / 2, 0, 1.05f, s.z / 2 - 0.05f, 2 * count);
    for (int i = 0; i <= count; ++i)
        k.board(brass, {s.x * (static_cast<float>(i) / static_cast<float>(count) - 0.5f) * 0.985f, 1.1f, 0},
                {0.05f, s.y - 1.16f, 0.05f}, 0.008f);
    k.board(wood, {0, s.y - 0.16f, 0}, {s.x, 0.16f, 0.16f}, 0.012f);
    for (int i = 0; i < count; ++i) {
        const float w = s.x / static_cast<float>(count),
                    x = s.x * ((static_cast<float>(i) + 0.5f) / static_cast<float>(count) - 0.5f);
        // An opening to pass money through, bars before it.
        k.board(pane, {x, 1.34f, 0}, {w - 0.07f, s.y - 1.5f, 0.01f}, 0.002f),
            k.board(brass, {x, 1.32f, 0}, {w - 0.06f, 0.03f, 0.03f}, 0.004f);
        for (int j = 0; j < 7; ++j)
            k.rod(brass, {x + 0.08f * (static_cast<float>(j) - 3), 1.35f, 0.02f},
                  {x + 0.08f * (static_cast<float>(j) - 3), s.y - 0.32f, 0.02f}, 0.006f, -1, 6);
        k.board(sign, {x, s.y - 0.13f, 0.085f}, {0.16f, 0.1f, 0.01f}, 0.003f),
            k.board(dark, {x + 0.25f, 1.1f, -0.2f}, {0.36f, 0.26f, 0.03f}, 0.006f);
        k.board(brass, {x, 1.1f, 0.16f}, {0.34f, 0.012f, 0.2f}, 0.003f);
    }
    k.piece.clearance_front_m = 1.0f;
}

// The round door of a strong room, ajar, with its wheel and bolts.
void build_vault_door(Kit& k) {
    const Vec3f s = k.wanted({2.3f, 2.3f, 0.6f});
    const int metal = k.main(steel()), dark = color(k, "vault", {0.012f, 0.012f, 0.013f}, 0.6f),
              brass = k.material(*material_named("brass")),
              frame = color(k, "vault frame", {0.16f, 0.165f, 0.17f}, 0.35f);
    const float r = std::min(s.x, s.y) / 2 - 0.1f, back = -s.z / 2;
    const Vec3f mid{0, s.y / 2, back};
    k.board(frame, {0, 0, back + 0.06f}, {s.x, s.y, 0.12f}, 0.02f);
    k.rod(metal, mid + Vec3f{0, 0, 0.1f}, mid + Vec3f{0, 0, 0.2f}, r, r - 0.05f, 56);
    k.rod(dark, mid + Vec3f{0, 0, 0.19f}, mid + Vec3f{0, 0, 0.212f}, r - 0.12f, -1, 56);
    k.rod(metal, mid + Vec3f{0, 0, 0.2f}, mid + Vec3f{0, 0, 0.36f}, r - 0.16f, r - 0.22f, 56);
    for (const float ring_r : {0.9f, 0.55f}) {
        Mesh ring = shapes::ring((r - 0.24f) * ring_r, 0.04f, 48);
        shapes::turn(ring, {1, 0, 0}, 90);
        k.add(std::move(ring), brass, mid + Vec3f{0, 0, 0.37f});
    }
    for (int i = 0; i < 16; ++i) {
        const float a = kTau * static_cast<float>(i) / 16;
        const Vec3f out{std::cos(a), std::sin(a), 0};
        k.rod(brass, mid + out * (r - 0.32f) + Vec3f{0, 0, 0.38f}, mid + out * (r - 0.19f) + Vec3f{0, 0, 0.38f}, 0.032f,
              -1, 10);
    }
    for (int i = 0; i < 3; ++i) {
        const float a = kPi * static_cast<float>(i) / 3;
        const Vec3f out{0.3f * std::cos(a), 0.3f * std::sin(a), 0}, hub = mid + Vec3f{0, 0, 0.5f};
        k.rod(brass, hub - out, hub + out, 0.016f, -1, 10);
        for (const float side : {-1.f, 1.f}) k.add(shapes::ball(hub + out * side, {0.032f, 0.032f, 0.032f}, 12), brass);
    }
    k.rod(metal, mid + Vec3f{0, 0, 0.36f}, mid + Vec3f{0, 0, 0.53f}, 0.07f, 0.05f, 20);
    k.board(metal, {-s.x / 2 + 0.09f, s.y / 2 - 0.5f, back + 0.2f}, {0.16f, 1.0f, 0.2f}, 0.03f);
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.8f;
}

// Chains with shackles at a wall.
void build_wall_chains(Kit& k) {
    const int iron = k.main(plain("rusty iron", {0.11f, 0.065f, 0.045f}, 0.75f));
    for (const float side : {-1.f, 1.f}) {
        k.board(iron, {side * 0.28f, 1.2f, 0.015f}, {0.12f, 0.12f, 0.03f}, 0.01f);
        constexpr int kLinks = 11;
        for (int i = 0; i < kLinks; ++i) {
            Mesh link = shapes::ring(0.036f, 0.013f, 12);
            for (Vec3f& p : link.positions) p.z *= 1.35f;
            shapes::smooth_normals(link);
            shapes::turn(link, {1, 0, 0}, 90);
            if (i % 2 == 1) shapes::turn(link, {0, 1, 0}, 90);
            k.add(std::move(link), iron,
                  {side * (0.28f + 0.01f * static_cast<float>(i)), 1.2f - 0.075f * static_cast<float>(i), 0.05f});
        }
        Mesh shackle = shapes::ring(0.06f, 0.02f, 20);
        k.add(std::move(shackle), iron, {side * 0.4f, 0.33f, 0.07f});
    }
    Mesh collar = shapes::ring(0.09f, 0.024f, 22);
    k.add(std::move(collar), iron, {0, 0.95f, 0.115f}), k.rod(iron, {0, 0.95f, 0}, {0, 0.95f, 0.03f}, 0.02f, -1, 8);
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 0.45f;
}

// A pillory: two posts, boards with holes for head and hands.
void build_stocks(Kit& k) {
    Material old = plain("old oak", {0.2f, 0.12f, 0.06f}, 0.85f);
    old.pattern = Pattern::wood, old.color_b = {0.12f, 0.07f, 0.035f}, old.scale_m = 0.05f;
    const int wood = k.main(old), iron = k.material(*material_named("iron")),
              hole = color(k, "hole", {0.004f, 0.004f, 0.004f}, 1.f);
    k.board(wood, {0, 0, 0}, {1.5f, 0.16f, 0.8f}, 0.015f);
    for (const float side : {-1.f, 1.f})
        k.board(wood, {side * 0.62f, 0.16f, 0}, {0.12f, 1.45f, 0.12f}, 0.012f),
            k.board(iron, {side * 0.62f, 1.28f, 0.064f}, {0.16f, 0.05f, 0.01f}, 0.003f);
    for (const float y : {1.05f, 1.295f}) k.board(wood, {0, y, 0}, {1.12f, 0.24f, 0.07f}, 0.012f);
    for (const auto& [x, r] : {std::pair{0.f, 0.1f}, {-0.33f, 0.05f}, {0.33f, 0.05f}})
        k.rod(hole, {x, 1.293f, -0.037f}, {x, 1.293f, 0.037f}, r, -1, 24);
    k.piece.clearance_front_m = 0.4f;
}

// A great telescope on its pier.
void build_great_telescope(Kit& k) {
    const Vec3f s = k.wanted({1.7f, 3.0f, 3.0f});
    const int white = k.main(plain("telescope", {0.6f, 0.61f, 0.6f}, 0.3f)),
              dark = color(k, "mount", {0.06f, 0.08f, 0.1f}, 0.4f), brass = k.material(*material_named("brass")),
              stone = k.material(*material_named("concrete")), lens = color(k, "lens", {0.02f, 0.03f, 0.06f}, 0.05f);
    const std::array<Vec2f, 4> pier{Vec2f{0.55f, 0}, {0.5f, 0.15f}, {0.32f, 0.3f}, {0.26f, 1.2f}};
    k.add(shapes::lathe(pier, 28), stone);
    k.board(dark, {0, 1.2f, 0}, {0.5f, 0.3f, 0.5f}, 0.04f);
    // A polar axis with a counterweight; the tube looks up to +z.
    k.rod(dark, {-0.1f, 1.62f, 0}, {0.7f, 1.62f, 0}, 0.07f, -1, 18),
        k.rod(dark, {0.55f, 1.62f, 0}, {0.8f, 1.62f, 0}, 0.2f, -1, 26);
    for (const float side : {-1.f, 1.f}) k.board(dark, {side * 0.2f, 1.45f, 0}, {0.08f, 0.32f, 0.3f}, 0.02f);
    const Vec3f mid{-0.36f, 1.62f, 0}, along = normalize(Vec3f{0, 0.62f, 0.78f});
    k.rod(white, mid - along * 1.05f, mid + along * 1.45f, 0.25f, 0.29f, 40);
    for (const float t : {-1.0f, -0.3f, 0.3f, 1.1f})
        k.rod(brass, mid + along * t, mid + along * (t + 0.06f), 0.3f, -1, 40);
    k.rod(dark, mid + along * 1.4f, mid + along * 1.75f, 0.31f, -1, 40),
        k.rod(lens, mid + along * 1.752f, mid + along * 1.756f, 0.28f, -1, 36);
    k.rod(dark, mid - along * 1.05f, mid - along * 1.3f, 0.12f, 0.07f, 20),
        k.rod(brass, mid - along * 1.3f, mid - along * 1.45f, 0.04f, -1, 14);
    const Vec3f aside{-0.3f, 0.12f, 0};
    k.rod(brass, mid + aside - along * 0.95f, mid + aside + along * 0.2f, 0.05f, 0.06f, 16);
    // A hand wheel and circles to set it by.
    for (const float x : {-0.06f, 0.42f}) {
        Mesh circle = shapes::ring(0.3f, 0.03f, 40);
        shapes::turn(circle, {0, 0, 1}, 90);
        k.add(std::move(circle), brass, {x, 1.62f, 0});
    }
    // Steps to the eyepiece.
    for (int i = 0; i < 3; ++i)
        k.board(dark, {-0.36f, 0, -1.25f + 0.24f * static_cast<float>(i)},
                {0.6f, 0.2f + 0.2f * static_cast<float>(2 - i) * 0.5f, 0.22f}, 0.01f);
    k.piece.clearance_front_m = 0.6f;
    (void)s;
}

// The projector of a planetarium: two balls full of lenses on a frame.
void build_star_projector(Kit& k) {
    const int black = k.main(plain("projector", {0.025f, 0.027f, 0.035f}, 0.35f)), metal = k.material(steel()),
              star = lit(k, "projector lens", {4, 4.6f, 6.5f}), blue = lit(k, "edge light", {0.25f, 0.8f, 2.6f});
    k.add(shapes::prism(shapes::circle(0.8f, 40), 0, 0.12f, 0.02f), black),
        k.add(shapes::ring(0.79f, 0.025f, 48), blue, {0, 0.13f, 0});
    for (const float x : {-1.f, 1.f})
        for (const float z : {-1.f, 1.f})
            k.rod(metal, {x * 0.5f, 0.12f, z * 0.3f}, {x * 0.12f, 1.3f, 0}, 0.03f, -1, 10);
    for (const float side : {-1.f, 1.f}) {
        const Vec3f mid{side * 0.62f, 1.35f, 0};
        k.add(shapes::ball(mid, {0.38f, 0.38f, 0.38f}, 32), black);
        for (int i = 0; i < 46; ++i) {
            const float y = 1 - 2 * (static_cast<float>(i) + 0.5f) / 46, a = 2.39996f * static_cast<float>(i),
                        r = std::sqrt(1 - y * y);
            const Vec3f out{r * std::cos(a), y, r * std::sin(a)};
            k.rod(metal, mid + out * 0.37f, mid + out * 0.395f, 0.034f, -1, 10),
                k.add(shapes::ball(mid + out * 0.396f, {0.02f, 0.02f, 0.02f}, 8), star);
        }
    }
    k.rod(metal, {-0.4f, 1.35f, 0}, {0.4f, 1.35f, 0}, 0.14f, -1, 24);
    k.piece.clearance_front_m = 0.6f;
}

// A gilt Buddha on a lotus, on an altar with candles and incense.
void build_buddha_altar(Kit& k) {
    const Vec3f s = k.wanted({1.9f, 2.3f, 1.1f});
    const int gold = k.main(*material_named("brass")), red = color(k, "lacquer", {0.32f, 0.03f, 0.02f}, 0.25f),
              dark = color(k, "hair", {0.03f, 0.03f, 0.06f}, 0.5f), wax = color(k, "wax", {0.72f, 0.67f, 0.54f}, 0.6f),
              fire = k.material(flame("flame", {16, 8.5f, 1.4f})), halo = color(k, "halo", {0.42f, 0.13f, 0.03f}, 0.4f);
    k.board(red, {0, 0, 0}, {s.x, 0.75f, s.z}, 0.015f),
        k.board(gold, {0, 0.75f, 0}, {s.x + 0.06f, 0.05f, s.z + 0.04f}, 0.01f);
    for (int i = 0; i < 3; ++i)
        k.board(gold, {s.x * (static_cast<float>(i) - 1) / 3.2f, 0.15f, s.z / 2 + 0.005f}, {0.4f, 0.45f, 0.02f}, 0.01f);
    const Vec3f at{0, 0.8f, -0.18f};
    for (int i = 0; i < 16; ++i) {
        const Vec3f out = around(kTau * static_cast<float>(i) / 16);
        k.add(shapes::ball(at + out * 0.42f + Vec3f{0, 0.09f, 0}, {0.1f, 0.1f, 0.1f}, 10), gold);
    }
    k.add(shapes::prism(shapes::circle(0.42f, 30), 0.02f, 0.2f, 0.03f), gold, at);
    Mesh disc = shapes::prism(shapes::circle(0.34f, 36), 0, 0.02f, 0.004f), rim = shapes::ring(0.34f, 0.04f, 36);
    for (Mesh* m : {&disc, &rim}) shapes::turn(*m, {1, 0, 0}, 90);
    k.add(std::move(disc), halo, at + Vec3f{0, 1.12f, -0.16f}),
        k.add(std::move(rim), gold, at + Vec3f{0, 1.12f, -0.15f});
    // Crossed legs, body, arms in the lap, head with its knot of hair and long ears.
    const std::array<Limb, 12> body{Limb{{-0.36f, 0.28f, 0.1f}, {0.02f, 0.27f, 0.22f}, 0.09f, 0.07f},
                                    {{0.36f, 0.28f, 0.1f}, {-0.02f, 0.28f, 0.2f}, 0.09f, 0.07f},
                                    {{-0.36f, 0.28f, 0.1f}, {-0.12f, 0.32f, -0.06f}, 0.09f, 0.12f},
                                    {{0.36f, 0.28f, 0.1f}, {0.12f, 0.32f, -0.06f}, 0.09f, 0.12f},
                                    {{0, 0.34f, -0.05f}, {0, 0.6f, -0.06f}, 0.17f, 0.16f},
                                    {{0, 0.6f, -0.06f}, {0, 0.82f, -0.06f}, 0.16f, 0.13f},
                                    {{-0.2f, 0.84f, -0.06f}, {0.2f, 0.84f, -0.06f}, 0.08f, 0.08f},
                                    {{-0.22f, 0.84f, -0.05f}, {-0.29f, 0.58f, 0}, 0.075f, 0.06f},
                                    {{-0.29f, 0.58f, 0}, {-0.04f, 0.42f, 0.17f}, 0.06f, 0.045f},
                                    {{0.22f, 0.84f, -0.05f}, {0.29f, 0.58f, 0}, 0.075f, 0.06f},
                                    {{0.29f, 0.58f, 0}, {0.04f, 0.42f, 0.17f}, 0.06f, 0.045f},
                                    {{0, 0.86f, -0.05f}, {0, 1.0f, -0.03f}, 0.06f, 0.06f}};
    k.add(shapes::skin(body, 0.05f, 0.035f), gold, at);
    k.add(shapes::ball(at + Vec3f{0, 1.1f, -0.02f}, {0.115f, 0.145f, 0.12f}, 22), gold),
        k.add(shapes::ball(at + Vec3f{0, 1.17f, -0.045f}, {0.12f, 0.105f, 0.115f}, 20), dark),
        k.add(shapes::ball(at + Vec3f{0, 1.29f, -0.04f}, {0.05f, 0.05f, 0.05f}, 14), dark);
    for (const float side : {-1.f, 1.f}) {
        k.add(shapes::ball(at + Vec3f{side * 0.115f, 1.07f, -0.02f}, {0.018f, 0.07f, 0.03f}, 10), gold);
        const Vec3f stick{side * 0.7f, 0.8f, 0.2f};
        const std::array<Vec2f, 5> p{Vec2f{0.08f, 0}, {0.06f, 0.02f}, {0.02f, 0.06f}, {0.02f, 0.2f}, {0.05f, 0.22f}};
        k.add(shapes::lathe(p, 16, true), gold, stick),
            k.rod(wax, stick + Vec3f{0, 0.22f, 0}, stick + Vec3f{0, 0.42f, 0}, 0.024f, -1, 12),
            k.add(shapes::ball(stick + Vec3f{0, 0.46f, 0}, {0.012f, 0.03f, 0.012f}, 10), fire);
    }
    const std::array<Vec2f, 4> bowl{Vec2f{0.05f, 0}, {0.11f, 0.06f}, {0.12f, 0.12f}, {0.1f, 0.14f}};
    k.add(shapes::vessel(bowl, 0.01f, 20), gold, {0, 0.8f, 0.36f});
    for (int i = 0; i < 5; ++i)
        k.rod(red, {0.02f * (static_cast<float>(i) - 2), 0.85f, 0.36f},
              {0.03f * (static_cast<float>(i) - 2), 1.18f, 0.36f}, 0.003f, -1, 5);
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.9f;
    (void)s;
}

// The niche of a mosque that shows the direction of prayer: tiled, with a pointed arch, and lamps.
void build_mihrab(Kit& k) {
    const Vec3f s = k.wanted({2.4f, 3.2f, 0.5f});
    Material tiles = plain("glazed tiles", {0.02f, 0.13f, 0.33f}, 0.2f);
    tiles.pattern = Pattern::encaustic, tiles.color_b = {0.7f, 0.68f, 0.6f}, tiles.color_c = {0.03f, 0.32f, 0.34f},
    tiles.scale_m = 0.2f;
    const int tile = k.main(tiles), stone = k.material(*material_named("marble")),
              gold = k.material(*material_named("brass")), niche = color(k, "niche", {0.02f, 0.26f, 0.26f}, 0.35f);
    const int lamp = k.material(flame("mosque lamp", {9, 6, 2.2f}));
    k.board(tile, {0, 0, -s.z / 2 + 0.06f}, {s.x, s.y, 0.12f}, 0.006f);
    // The frame around, with a band of gold.
    for (const float side : {-1.f, 1.f})
        k.board(stone, {side * (s.x / 2 - 0.1f), 0, -0.02f}, {0.2f, s.y, s.z - 0.1f}, 0.012f),
            k.board(gold, {side * (s.x / 2 - 0.24f), 0.1f, -s.z / 2 + 0.13f}, {0.05f, s.y - 0.4f, 0.03f}, 0.006f);
    k.board(stone, {0, s.y - 0.25f, -0.02f}, {s.x, 0.25f, s.z - 0.1f}, 0.012f),
        k.board(gold, {0, s.y - 0.34f, -s.z / 2 + 0.13f}, {s.x - 0.44f, 0.05f, 0.03f}, 0.006f);
    // The pointed arch: its outline filled with the niche's tiles, a rope of stone around.
    const float w = 0.24f * s.x, spring = 0.52f * s.y, apex = 0.8f * s.y;
    std::vector<Vec2f> outline{{w, 0.02f}};
    for (int i = 0; i <= 14; ++i) {
        const float t = static_cast<float>(i) / 14;
        outline.push_back({w * (1 - t) * (1 + 0.35f * t), std::lerp(spring, apex, std::sin(0.5f * kPi * t))});
    }
    for (int i = 13; i >= 0; --i)
        outline.push_back({-outline[static_cast<std::size_t>(i + 1)].x, outline[static_cast<std::size_t>(i + 1)].y});
    outline.push_back({-w, 0.02f});
    std::vector<Vec3f> rope;
    for (const Vec2f& p : outline) rope.push_back({p.x, p.y, -s.z / 2 + 0.15f});
    k.add(shapes::tube(rope, 0.045f, 10), stone);
    for (Vec2f& p : outline) p.y = -p.y;
    Mesh face = shapes::prism(outline, 0, 0.02f, 0.003f);
    shapes::turn(face, {1, 0, 0}, 90);
    k.add(std::move(face), niche, {0, 0, -s.z / 2 + 0.12f});
    for (const float side : {-1.f, 1.f}) {
        const std::array<Vec2f, 6> column{Vec2f{0.1f, 0},           {0.1f, 0.08f},          {0.06f, 0.12f},
                                          {0.055f, spring - 0.12f}, {0.1f, spring - 0.03f}, {0.1f, spring}};
        k.add(shapes::lathe(column, 20), stone, {side * (w + 0.1f), 0, 0.02f});
    }
    k.rod(gold, {0, apex - 0.05f, -0.02f}, {0, spring + 0.12f, -0.02f}, 0.004f, -1, 6),
        k.add(shapes::ball({0, spring + 0.04f, -0.02f}, {0.07f, 0.1f, 0.07f}, 16), lamp),
        k.add(shapes::ring(0.07f, 0.014f, 20), gold, {0, spring + 0.06f, -0.02f});
    k.piece.against_wall = true, k.piece.clearance_front_m = 1.0f;
}

}  // namespace fastscene::furniture

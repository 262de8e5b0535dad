// Of cinemas, theatres and bands.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {

// A folding seat with arms, for rows.
void build_cinema_seat(Kit& k) {
    const int cloth = k.main(tinted(k.style.fabric, {0.28f, 0.02f, 0.025f})),
              dark = color(k, "frame", {0.025f, 0.025f, 0.025f}, 0.5f);
    k.soft(cloth, {0, 0.4f, 0.06f}, {0.46f, 0.12f, 0.44f}, {0.04f, 0.015f, 0.001f, 4});
    Mesh back = shapes::soft_box({0.48f, 0.62f, 0.11f}, {0.04f, 0.018f, 0.001f, 4, k.seed()});
    shapes::turn(back, {1, 0, 0}, -10);
    k.add(std::move(back), cloth, {0, 0.76f, -0.2f});
    for (const float sx : {-1.f, 1.f}) {
        block(k, dark, {sx * 0.265f, 0, 0}, {0.04f, 0.58f, 0.26f});
        k.board(dark, {sx * 0.265f, 0.58f, 0.03f}, {0.06f, 0.04f, 0.42f}, 0.01f);
    }
    k.piece.clearance_front_m = 0.35f;
}

// A low platform of boards with steps.
void build_stage(Kit& k) {
    const Vec3f s = k.wanted({4.0f, 0.4f, 2.0f});
    const int boards = k.main(k.style.wood), dark = color(k, "skirt", {0.02f, 0.02f, 0.022f}, 0.9f);
    k.board(dark, {0, 0, -0.01f}, {s.x - 0.04f, s.y - 0.03f, s.z - 0.04f}, 0.003f);
    const int count = std::max(4, static_cast<int>(s.z / 0.14f));
    for (int i = 0; i < count; ++i) {
        const float w = s.z / static_cast<float>(count);
        k.board(boards, {0, s.y - 0.03f, -0.5f * s.z + w * (static_cast<float>(i) + 0.5f)}, {s.x, 0.03f, w - 0.003f},
                0.002f);
    }
    k.top(s.y, 0, 0, 0.45f * s.x, 0.42f * s.z);
    k.piece.clearance_front_m = 0.9f;
    k.piece.against_wall = true;
}

// Heavy folds at a wall, from the floor up.
void build_stage_curtain(Kit& k) {
    const Vec3f s = k.wanted({1.2f, 2.6f, 0.2f});
    const int cloth = k.main(tinted(k.style.fabric, {0.3f, 0.02f, 0.025f})), gold = k.material(*material_named("gold"));
    const int folds = std::max(4, static_cast<int>(s.x / 0.16f));
    k.add(shapes::slab(folds * 8, 6, 0.012f,
                       [&](float u, float v) {
                           const float wave = std::sin(kTau * static_cast<float>(folds) * u);
                           return Vec3f{s.x * (u - 0.5f), s.y * v, 0.06f * wave * (1.1f - 0.3f * v)};
                       }),
          cloth);
    k.rod(gold, {-0.5f * s.x, 0.16f, 0.075f}, {0.5f * s.x, 0.16f, 0.075f}, 0.012f, -1, 6);
    k.piece.against_wall = true;
}

void build_drum_kit(Kit& k) {
    const int shell = k.main(plain("drum lacquer", {0.32f, 0.02f, 0.02f}, 0.15f)),
              head = color(k, "drum head", {0.72f, 0.71f, 0.67f}, 0.6f), metal = k.material(steel()),
              brass = k.material(*material_named("brass"));
    const auto drum = [&](Vec3f at, float r, float h, float tilt) {
        const std::array<Vec2f, 2> wall{Vec2f{r, 0}, {r, h}}, skin{Vec2f{r * 0.98f, h}, {r * 0.98f, h + 0.006f}};
        Mesh body = shapes::lathe(wall, 24), top = shapes::lathe(skin, 24), rim = shapes::ring(r + 0.004f, 0.016f, 24);
        shapes::move(rim, {0, h, 0});
        for (Mesh* m : {&body, &top, &rim}) shapes::turn(*m, {1, 0, 0}, tilt);
        k.add(std::move(body), shell, at), k.add(std::move(top), head, at), k.add(std::move(rim), metal, at);
    };
    drum({0, 0.29f, 0.05f}, 0.28f, 0.4f, 90);  // bass drum, to the front
    drum({-0.2f, 0.62f, 0.12f}, 0.15f, 0.2f, -18), drum({0.2f, 0.62f, 0.12f}, 0.16f, 0.22f, -18);
    drum({0.55f, 0.22f, -0.25f}, 0.2f, 0.36f, 0), drum({-0.5f, 0.5f, -0.3f}, 0.18f, 0.14f, 0);
    for (const float a : {0.f, 2.1f, 4.2f}) {
        k.rod(metal, {-0.5f, 0.5f, -0.3f}, {-0.5f + 0.22f * std::cos(a), 0, -0.3f + 0.22f * std::sin(a)}, 0.01f, -1, 6);
        k.rod(metal, {0.55f + 0.19f * std::cos(a), 0.3f, -0.25f + 0.19f * std::sin(a)},
              {0.55f + 0.22f * std::cos(a), 0, -0.25f + 0.22f * std::sin(a)}, 0.01f, -1, 6);
    }
    const auto cymbal = [&](Vec3f at, float r) {
        const std::array<Vec2f, 4> p{Vec2f{r, 0}, {0.3f * r, 0.02f}, {0.15f * r, 0.05f}, {0.01f, 0.055f}};
        Mesh m = shapes::lathe(p, 28, true);
        shapes::turn(m, {0, 0, 1}, 8);
        k.add(std::move(m), brass, at);
        k.rod(metal, {at.x, 0.4f, at.z}, at, 0.01f, -1, 8);
        for (const float a : {0.5f, 2.6f, 4.7f})
            k.rod(metal, {at.x, 0.42f, at.z}, at + Vec3f{0.25f * std::cos(a), -at.y, 0.25f * std::sin(a)}, 0.009f, -1,
                  6);
    };
    cymbal({-0.62f, 1.05f, 0.15f}, 0.22f), cymbal({0.66f, 1.1f, 0.1f}, 0.25f), cymbal({-0.78f, 0.86f, -0.25f}, 0.18f);
    const std::array<Vec2f, 4> seat{Vec2f{0.16f, 0}, {0.17f, 0.02f}, {0.17f, 0.07f}, {0.15f, 0.08f}};
    k.add(shapes::lathe(seat, 20, true), color(k, "leather", {0.03f, 0.03f, 0.03f}, 0.5f), {0, 0.45f, -0.62f});
    k.rod(metal, {0, 0, -0.62f}, {0, 0.46f, -0.62f}, 0.03f);
    k.piece.clearance_front_m = 0.4f;
}

void build_guitar_amp(Kit& k) {
    const int body = k.main(plain("amplifier vinyl", {0.03f, 0.03f, 0.03f}, 0.7f)),
              grill = color(k, "speaker cloth", {0.09f, 0.085f, 0.08f}, 0.95f),
              metal = k.material(*material_named("brass")), knob = color(k, "knob", {0.6f, 0.58f, 0.5f}, 0.3f);
    k.board(body, {0, 0, 0}, {0.66f, 0.62f, 0.3f}, 0.02f);
    k.board(grill, {0, 0.05f, 0.15f}, {0.58f, 0.42f, 0.012f}, 0.004f);
    k.board(metal, {0, 0.5f, 0.15f}, {0.58f, 0.08f, 0.01f}, 0.003f);
    for (int i = 0; i < 7; ++i)
        k.rod(knob, {-0.22f + 0.07f * static_cast<float>(i), 0.54f, 0.155f},
              {-0.22f + 0.07f * static_cast<float>(i), 0.54f, 0.175f}, 0.013f, 0.011f, 10);
    for (const float sx : {-1.f, 1.f}) k.board(metal, {sx * 0.31f, 0, 0.13f}, {0.045f, 0.045f, 0.05f}, 0.006f);
    k.board(body, {0, 0.62f, 0}, {0.2f, 0.025f, 0.03f}, 0.01f);
    k.top(0.62f, 0, 0, 0.25f, 0.1f);
    k.piece.clearance_front_m = 0.4f;
}

// An electric guitar leaning in its stand.
void build_guitar_stand(Kit& k) {
    const int body = k.main(plain("guitar lacquer", k.accent(), 0.12f)),
              neck = k.material(materials::timber("oak", 0.4f)), metal = k.material(steel()),
              black = color(k, "stand", {0.02f, 0.02f, 0.02f}, 0.5f),
              plate = color(k, "pickguard", {0.7f, 0.68f, 0.62f}, 0.3f);
    for (const float sx : {-1.f, 1.f})
        k.rod(black, {0, 0.45f, -0.12f}, {sx * 0.24f, 0, -0.2f}, 0.011f, -1, 8),
            k.rod(black, {sx * 0.1f, 0.28f, -0.06f}, {sx * 0.1f, 0.26f, 0.1f}, 0.012f, -1, 8);
    k.rod(black, {0, 0.28f, -0.08f}, {0, 0, 0.2f}, 0.011f, -1, 8);
    k.rod(black, {-0.1f, 0.28f, -0.06f}, {0.1f, 0.28f, -0.06f}, 0.011f, -1, 8);
    k.rod(black, {0, 0.28f, -0.08f}, {0, 0.72f, -0.14f}, 0.011f, -1, 8);
    std::vector<Vec2f> outline;
    for (int i = 0; i < 40; ++i) {
        const float a = kTau * static_cast<float>(i) / 40.f,
                    r = 0.165f + 0.03f * std::cos(2 * a) * (std::sin(a) > 0 ? 0.9f : 1.2f) - 0.02f * std::cos(4 * a);
        outline.push_back({r * 0.95f * std::cos(a), r * 1.25f * std::sin(a)});
    }
    std::reverse(outline.begin(), outline.end());
    Mesh slab = shapes::prism(outline, -0.022f, 0.022f, 0.008f),
         guard = shapes::prism(shapes::rounded_rectangle(0.12f, 0.22f, 0.05f), 0.022f, 0.026f, 0.001f);
    for (Mesh* m : {&slab, &guard}) shapes::turn(*m, {1, 0, 0}, 78);
    k.add(std::move(slab), body, {0, 0.5f, 0}), k.add(std::move(guard), plate, {0.02f, 0.5f, 0});
    k.rod(neck, {0, 0.62f, -0.02f}, {0, 1.12f, -0.13f}, 0.024f, 0.02f, 8);
    Mesh head = shapes::box({0.08f, 0.17f, 0.016f}, 0.004f);
    shapes::turn(head, {1, 0, 0}, -16);
    k.add(std::move(head), neck, {0, 1.2f, -0.15f});
    for (int i = 0; i < 6; ++i)
        k.rod(metal, {-0.012f + 0.005f * static_cast<float>(i), 0.42f, 0.045f},
              {-0.012f + 0.005f * static_cast<float>(i), 1.14f, -0.105f}, 0.001f, -1, 4);
    k.piece.clearance_front_m = 0.3f;
}

void build_electric_guitar(Kit& k) { build_guitar_stand(k); }

void build_microphone(Kit& k) {
    const int metal = k.material(steel()), black = k.main(plain("stand", {0.03f, 0.03f, 0.032f}, 0.4f));
    k.add(shapes::prism(shapes::circle(0.15f, 28), 0, 0.025f, 0.004f), black);
    k.rod(black, {0, 0.02f, 0}, {0, 1.42f, 0}, 0.012f, -1, 10);
    k.rod(black, {0, 1.42f, 0}, {0, 1.5f, 0.09f}, 0.018f, 0.024f, 12);
    k.add(shapes::ball({0, 1.525f, 0.115f}, {0.032f, 0.036f, 0.032f}, 16), metal);
}

// A desk of faders, screens and two loudspeakers.
void build_mixing_desk(Kit& k) {
    const Vec3f s = k.wanted({2.0f, 0.85f, 0.95f});
    const int wood = k.main(k.style.wood), dark = color(k, "console", {0.06f, 0.062f, 0.066f}, 0.4f),
              fader = color(k, "fader", {0.66f, 0.66f, 0.64f}, 0.4f),
              cone = color(k, "cone", {0.03f, 0.03f, 0.03f}, 0.7f);
    const std::array<int, 3> caps{color(k, "red cap", {0.5f, 0.05f, 0.04f}), color(k, "blue cap", {0.05f, 0.15f, 0.5f}),
                                  color(k, "yellow cap", {0.6f, 0.45f, 0.05f})};
    for (const float sx : {-1.f, 1.f})
        k.board(wood, {sx * (0.5f * s.x - 0.03f), 0, 0}, {0.06f, s.y - 0.08f, s.z - 0.05f}, 0.008f);
    k.board(wood, {0, s.y - 0.2f, 0}, {s.x - 0.1f, 0.06f, s.z - 0.06f}, 0.006f);
    Mesh slope = shapes::box({s.x - 0.14f, 0.05f, 0.6f}, 0.008f);
    shapes::turn(slope, {1, 0, 0}, 8);
    k.add(std::move(slope), dark, {0, s.y - 0.08f, 0.14f});
    for (int i = 0; i < 24; ++i) {
        const float x = -0.5f * s.x + 0.14f + (s.x - 0.28f) * static_cast<float>(i) / 23;
        block(k, fader, {x, s.y - 0.08f, 0.3f + k.rng.uniform(-0.05f, 0.05f)}, {0.016f, 0.022f, 0.03f});
        for (int j = 0; j < 4; ++j) {
            const float z = 0.15f - 0.07f * static_cast<float>(j);
            k.rod(caps[static_cast<std::size_t>(j) % 3], {x, s.y - 0.06f, z}, {x, s.y - 0.035f, z}, 0.009f, 0.007f, 6);
        }
    }
    k.board(wood, {0, s.y - 0.02f, -0.5f * s.z + 0.14f}, {s.x, 0.04f, 0.26f}, 0.005f);
    k.merge(k.small("monitor"), {0, s.y + 0.02f, -0.5f * s.z + 0.14f});
    for (const float sx : {-1.f, 1.f}) {
        k.board(cone, {sx * (0.5f * s.x - 0.2f), s.y + 0.02f, -0.5f * s.z + 0.14f}, {0.24f, 0.38f, 0.24f}, 0.01f);
        for (const auto& [y, r] : {std::pair{0.15f, 0.085f}, {0.32f, 0.035f}}) {
            const Vec3f at{sx * (0.5f * s.x - 0.2f), s.y + y, -0.5f * s.z + 0.262f};
            Mesh rim = shapes::ring(r, 0.012f, 20);
            shapes::turn(rim, {1, 0, 0}, 90);
            k.add(std::move(rim), fader, at);
        }
    }
    k.piece.clearance_front_m = 0.9f;
}

// Ridged foam in a frame, as studios have on their walls; with the pattern "slats", upright timber before felt, as
// halls have them.
void build_acoustic_panel(Kit& k) {
    if (k.request.pattern == "slats") {
        const Vec3f s = k.wanted({1.2f, 2.4f, 0.05f});
        const int timber = k.main(k.style.wood), felt = k.material(plain("felt", {0.03f, 0.03f, 0.032f}, 0.95f));
        k.board(felt, {0, 0, 0.006f}, {s.x, s.y, 0.012f}, 0.001f);
        constexpr float kPitch = 0.06f, kSlat = 0.042f;
        const int slats = std::max(2, static_cast<int>(s.x / kPitch));
        for (int i = 0; i < slats; ++i) {
            const float x = s.x * ((static_cast<float>(i) + 0.5f) / static_cast<float>(slats) - 0.5f);
            block(k, timber, {x, 0, 0.5f * (s.z + 0.012f)}, {kSlat, s.y, s.z - 0.012f});
        }
        k.piece.mount = Mount::wall;
        k.piece.hang_height_m = 1.1f;  // above the backs of seats and the floor of a stage
        return;
    }
    const Vec3f s = k.wanted({1.2f, 0.9f, 0.08f});
    const int foam = k.main(plain("acoustic foam", {0.05f, 0.05f, 0.055f}, 0.95f)), frame = k.material(k.style.wood);
    k.board(frame, {0, 0, 0.012f}, {s.x, s.y, 0.024f}, 0.003f);
    const int ridges = 12;
    for (int i = 0; i < ridges; ++i) {
        const float w = (s.x - 0.06f) / ridges;
        Mesh m = shapes::box({0.7f * w, s.y - 0.06f, 0.7f * w}, 0.002f);
        shapes::turn(m, {0, 1, 0}, 45);
        k.add(std::move(m), foam, {-0.5f * s.x + 0.03f + w * (static_cast<float>(i) + 0.5f), 0.5f * s.y, 0.03f});
    }
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.1f;
}

}  // namespace fastscene::furniture

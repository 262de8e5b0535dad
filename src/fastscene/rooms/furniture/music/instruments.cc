// Instruments of orchestras and bands, and a music stand.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {

void build_music_stand(Kit& k) {
    const int black = k.main(plain("stand lacquer", {0.03f, 0.03f, 0.032f}, 0.4f)),
              paper = color(k, "sheet music", {0.74f, 0.72f, 0.66f}, 0.9f),
              ink = color(k, "notes", {0.05f, 0.05f, 0.05f}, 0.9f);
    for (const float a : {0.5f, 2.6f, 4.7f})
        k.rod(black, {0, 0.28f, 0}, around(a) * 0.27f + Vec3f{0, 0.012f, 0}, 0.01f, -1, 8);
    k.rod(black, {0, 0.2f, 0}, {0, 0.72f, 0}, 0.014f, -1, 10),
        k.rod(black, {0, 0.7f, 0}, {0, 1.12f, 0}, 0.009f, -1, 10);
    const auto tilted = [&](Vec3f size, Vec3f at, int mat) {
        Mesh m = shapes::box(size, 0.002f);
        shapes::move(m, at), shapes::turn(m, {1, 0, 0}, -20);
        k.add(std::move(m), mat, {0, 1.18f, 0.02f});
    };
    tilted({0.5f, 0.34f, 0.006f}, {0, 0, 0}, black), tilted({0.5f, 0.006f, 0.06f}, {0, -0.17f, 0.03f}, black);
    for (const float sx : {-1.f, 1.f}) {
        tilted({0.215f, 0.29f, 0.002f}, {sx * 0.11f, -0.015f, 0.006f}, paper);
        for (int i = 0; i < 6; ++i)
            tilted({0.17f, 0.012f, 0.001f}, {sx * 0.11f, 0.09f - 0.042f * static_cast<float>(i), 0.0075f}, ink);
    }
}

namespace {

// The outline of a body with a waist, unit height, as (x, z) with the neck at -z.
std::vector<Vec2f> fiddle_outline(float wide, float high) {
    std::vector<Vec2f> half{{0, -0.5f},      {0.28f, -0.47f}, {0.4f, -0.36f}, {0.4f, -0.22f},
                            {0.33f, -0.12f}, {0.27f, -0.02f}, {0.32f, 0.09f}, {0.47f, 0.16f},
                            {0.5f, 0.28f},   {0.44f, 0.41f},  {0.26f, 0.48f}, {0, 0.5f}};
    std::vector<Vec2f> out;
    for (auto i = half.rbegin(); i != half.rend(); ++i) out.push_back({i->x * wide, i->y * high});
    for (std::size_t i = 1; i + 1 < half.size(); ++i) out.push_back({-half[i].x * wide, half[i].y * high});
    return out;
}
// A bowed instrument, upright, its back at z = 0 and the lower end of its body at y = 0: `s` of a violin's size.
std::vector<std::pair<Mesh, int>> fiddle(Kit& k, float s, bool bow) {
    const int wood = k.main(plain("varnished maple", {0.24f, 0.075f, 0.02f}, 0.15f)),
              pale = k.material(plain("spruce top", {0.42f, 0.17f, 0.05f}, 0.15f)),
              ebony = color(k, "ebony", {0.03f, 0.028f, 0.026f}, 0.35f), metal = k.material(steel());
    std::vector<std::pair<Mesh, int>> parts;
    const auto put = [&](Mesh m, int mat, Vec3f at) { shapes::move(m, at * s), parts.emplace_back(std::move(m), mat); };
    const auto outline = fiddle_outline(0.205f * s, 0.355f * s);
    Mesh body = shapes::prism(outline, 0, 0.035f * s, 0.005f * s),
         top = shapes::prism(outline, 0, 0.006f * s, 0.003f * s);
    for (Mesh* m : {&body, &top}) shapes::turn(*m, {1, 0, 0}, 90);
    put(std::move(body), wood, {0, 0.178f, 0}), put(std::move(top), pale, {0, 0.178f, 0.035f});
    const auto bar = [&](Vec3f size, Vec3f at, int mat) { put(shapes::box(size * s, 0.0015f * s), mat, at); };
    bar({0.024f, 0.14f, 0.02f}, {0, 0.42f, 0.032f}, wood), bar({0.026f, 0.27f, 0.006f}, {0, 0.36f, 0.05f}, ebony);
    bar({0.03f, 0.1f, 0.006f}, {0, 0.06f, 0.05f}, ebony), bar({0.042f, 0.006f, 0.028f}, {0, 0.15f, 0.052f}, pale);
    bar({0.018f, 0.07f, 0.02f}, {0, 0.525f, 0.028f}, wood);
    put(shapes::rod({-0.012f * s, 0, 0}, {0.012f * s, 0, 0}, 0.018f * s, 0.018f * s, 12), wood, {0, 0.57f, 0.024f});
    for (int i = 0; i < 4; ++i) {
        const float x = 0.006f * (static_cast<float>(i) - 1.5f), y = 0.5f + 0.016f * static_cast<float>(i);
        parts.emplace_back(
            shapes::rod(Vec3f{x, 0.1f, 0.056f} * s, Vec3f{0.7f * x, 0.49f, 0.052f} * s, 0.0008f * s, 0.0008f * s, 4),
            metal);
        bar({0.05f, 0.008f, 0.008f}, {(i % 2 ? 1.f : -1.f) * 0.02f, y, 0.026f}, ebony);
    }
    for (const float sx : {-1.f, 1.f}) {
        Mesh f = shapes::box(Vec3f{0.004f, 0.07f, 0.002f} * s, 0.0004f);
        shapes::turn(f, {0, 0, 1}, sx * 12);
        put(std::move(f), ebony, {sx * 0.045f, 0.155f, 0.0415f});
    }
    if (bow) {
        parts.emplace_back(
            shapes::rod(Vec3f{0.15f, -0.06f, 0.03f} * s, Vec3f{0.17f, 0.66f, 0.03f} * s, 0.004f * s, 0.003f * s, 8),
            wood);
        parts.emplace_back(
            shapes::rod(Vec3f{0.138f, -0.05f, 0.03f} * s, Vec3f{0.156f, 0.655f, 0.03f} * s, 0.003f * s, 0.003f * s, 4),
            ebony);
        bar({0.018f, 0.03f, 0.012f}, {0.146f, -0.03f, 0.03f}, ebony);
    }
    return parts;
}

}  // namespace

// On a wall, its bow beside it.
void build_violin(Kit& k) {
    for (auto& [m, mat] : fiddle(k, 1.f, true)) k.add(std::move(m), mat, {0, 0, 0.01f});
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 1.35f;
}

// Leaning in its stand.
void build_cello(Kit& k) {
    for (auto& [m, mat] : fiddle(k, 2.15f, false)) {
        shapes::turn(m, {1, 0, 0}, -13);
        k.add(std::move(m), mat, {0, 0.17f, 0.05f});
    }
    const int black = color(k, "stand", {0.025f, 0.025f, 0.025f}, 0.5f), metal = k.material(steel());
    k.rod(metal, {0, 0.02f, 0.13f}, {0, 0.2f, 0.08f}, 0.007f, -1, 8);
    for (const float sx : {-1.f, 1.f})
        k.rod(black, {0, 0.3f, -0.03f}, {sx * 0.3f, 0.012f, 0.22f}, 0.011f, -1, 8),
            k.rod(black, {sx * 0.02f, 0.26f, -0.03f}, {sx * 0.17f, 0.25f, 0.12f}, 0.011f, -1, 8);
    k.rod(black, {0, 0.3f, -0.03f}, {0, 0.012f, -0.3f}, 0.011f, -1, 8),
        k.rod(black, {0, 0.2f, -0.05f}, {0, 0.75f, -0.13f}, 0.011f, -1, 8);
    k.piece.clearance_front_m = 0.3f;
}

// A pedal harp: column, curved neck, soundboard and strings in the plane of its side.
void build_harp(Kit& k) {
    const int wood = k.main(k.style.wood2), gold = k.material(*material_named("gold")),
              cord = color(k, "strings", {0.66f, 0.62f, 0.55f}, 0.5f),
              board = k.material(materials::timber("natural", 0.4f));
    const std::array<Vec2f, 9> column{Vec2f{0.05f, 0.16f}, {0.06f, 0.22f}, {0.04f, 0.3f},
                                      {0.034f, 0.9f},      {0.038f, 1.5f}, {0.055f, 1.58f},
                                      {0.04f, 1.64f},      {0.06f, 1.72f}, {0.02f, 1.78f}};
    k.add(shapes::lathe(column, 16, true), gold, {-0.42f, 0, 0});
    k.board(wood, {-0.06f, 0, 0}, {0.9f, 0.09f, 0.42f}, 0.03f),
        k.board(wood, {-0.16f, 0.09f, 0}, {0.66f, 0.09f, 0.3f}, 0.03f);
    const std::vector<Vec3f> neck{{-0.42f, 1.66f, 0}, {-0.25f, 1.6f, 0}, {-0.08f, 1.42f, 0},
                                  {0.1f, 1.32f, 0},   {0.26f, 1.36f, 0}, {0.38f, 1.42f, 0}};
    k.add(shapes::tube(neck, 0.045f, 10), wood),
        k.add(shapes::ball({0.4f, 1.4f, 0}, {0.075f, 0.085f, 0.06f}, 12), wood);
    const Vec3f low{-0.28f, 0.2f, 0}, high{0.42f, 1.4f, 0};
    k.rod(wood, low, high, 0.15f, 0.055f, 14);
    slat(k, board, low + Vec3f{-0.12f, 0.09f, 0}, high + Vec3f{-0.05f, 0.02f, 0}, 0.03f, 0.13f);
    for (int i = 0; i < 26; ++i) {
        const float t = 0.06f + 0.88f * static_cast<float>(i) / 25, n = t * 5;
        const std::size_t j = std::min<std::size_t>(4, static_cast<std::size_t>(n));
        const Vec3f top = lerp(neck[j], neck[j + 1], n - static_cast<float>(j));
        const float f = std::clamp((top.x + 0.42f) / 0.84f, 0.f, 1.f);
        k.rod(i % 7 == 0 ? gold : cord, lerp(low, high, f) + Vec3f{-0.1f, 0.1f, 0}, top + Vec3f{0, 0, 0.03f}, 0.0022f,
              -1, 4);
    }
    for (int i = 0; i < 7; ++i)
        block(k, gold, {-0.3f + 0.07f * static_cast<float>(i), 0.04f, 0.22f}, {0.02f, 0.02f, 0.08f});
    k.piece.clearance_front_m = 0.4f;
}

// Upright in its stand.
void build_saxophone(Kit& k) {
    const int brass = k.main(plain("lacquered brass", {0.62f, 0.4f, 0.1f}, 0.18f)),
              pearl = color(k, "pearl", {0.7f, 0.68f, 0.62f}, 0.2f),
              black = color(k, "stand", {0.025f, 0.025f, 0.025f}, 0.5f);
    k.piece.materials[static_cast<std::size_t>(brass)].metal = 1;
    Piece& p = k.piece;
    const std::size_t first = p.meshes.size();
    const std::vector<Vec3f> bow{{0, 0.12f, 0}, {0, 0.03f, 0.02f}, {0, 0, 0.075f}, {0, 0.03f, 0.13f}, {0, 0.1f, 0.15f}};
    k.rod(brass, {0, 0.1f, 0}, {0, 0.6f, 0}, 0.034f, 0.016f, 16), k.add(shapes::tube(bow, 0.036f, 14), brass);
    const std::array<Vec2f, 5> bell{Vec2f{0.036f, 0}, {0.045f, 0.1f}, {0.06f, 0.17f}, {0.09f, 0.22f}, {0.098f, 0.225f}};
    Mesh flare = shapes::vessel(bell, 0.003f, 22);
    shapes::turn(flare, {1, 0, 0}, 12);
    k.add(std::move(flare), brass, {0, 0.09f, 0.148f});
    const std::vector<Vec3f> crook{
        {0, 0.59f, 0}, {0, 0.65f, 0}, {0, 0.68f, -0.03f}, {0, 0.68f, -0.1f}, {0, 0.66f, -0.16f}};
    k.add(shapes::tube(crook, 0.012f, 10), brass),
        k.rod(black, {0, 0.665f, -0.14f}, {0, 0.645f, -0.21f}, 0.013f, 0.008f, 10);
    for (int i = 0; i < 9; ++i) {
        const float y = 0.16f + 0.048f * static_cast<float>(i), r = 0.02f - 0.001f * static_cast<float>(i);
        k.rod(i % 2 ? pearl : brass, {0.0f, y, 0.028f}, {0, y, 0.045f}, r, -1, 10);
        k.rod(brass, {0.034f, y, 0}, {0.034f, y + 0.04f, 0.01f}, 0.004f, -1, 5);
    }
    k.rod(brass, {0.036f, 0.14f, 0.01f}, {0.03f, 0.58f, 0.01f}, 0.003f, -1, 5),
        k.rod(brass, {-0.036f, 0.14f, 0.01f}, {-0.03f, 0.58f, 0.01f}, 0.003f, -1, 5);
    for (std::size_t i = first; i < p.meshes.size(); ++i)
        shapes::turn(p.meshes[i], {1, 0, 0}, -14), shapes::move(p.meshes[i], {0, 0.12f, 0});
    for (const float a : {0.5f, 2.6f, 4.7f})
        k.rod(black, {0, 0.16f, -0.01f}, around(a) * 0.2f + Vec3f{0, 0.01f, 0}, 0.009f, -1, 8);
    k.rod(black, {0, 0.1f, -0.01f}, {0, 0.5f, -0.16f}, 0.009f, -1, 8),
        k.rod(black, {-0.05f, 0.5f, -0.14f}, {0.05f, 0.5f, -0.14f}, 0.009f, -1, 8);
}

// An electric keyboard on a stand of crossed bars.
void build_synthesizer(Kit& k) {
    const int body = k.main(plain("keyboard case", {0.03f, 0.03f, 0.033f}, 0.35f)),
              ivory = color(k, "white keys", {0.78f, 0.77f, 0.73f}, 0.25f),
              ebony = color(k, "black keys", {0.025f, 0.025f, 0.025f}, 0.3f),
              metal = color(k, "stand", {0.05f, 0.05f, 0.05f}, 0.4f),
              knob = color(k, "knob", {0.55f, 0.55f, 0.55f}, 0.4f), show = lit(k, "display", {0.15f, 0.5f, 0.7f}),
              red = color(k, "red pad", {0.55f, 0.05f, 0.03f}, 0.4f);
    const float y = 0.82f;
    k.board(body, {0, y, 0}, {1.25f, 0.06f, 0.34f}, 0.012f),
        k.board(body, {0, y + 0.06f, -0.1f}, {1.25f, 0.03f, 0.14f}, 0.008f);
    constexpr int kWhite = 43;
    const float w = 1.16f / kWhite;
    for (int i = 0; i < kWhite; ++i) {
        const float x = -0.58f + w * (static_cast<float>(i) + 0.5f);
        block(k, ivory, {x, y + 0.06f, 0.065f}, {w - 0.0015f, 0.014f, 0.17f});
        const int step = i % 7;
        if (step != 2 && step != 6 && i + 1 < kWhite)
            block(k, ebony, {x + 0.5f * w, y + 0.074f, 0.03f}, {0.013f, 0.01f, 0.1f});
    }
    for (int i = 0; i < 12; ++i)
        k.rod(knob, {-0.56f + 0.035f * static_cast<float>(i), y + 0.09f, -0.08f},
              {-0.56f + 0.035f * static_cast<float>(i), y + 0.105f, -0.08f}, 0.01f, 0.008f, 8);
    block(k, show, {0, y + 0.09f, -0.1f}, {0.2f, 0.002f, 0.07f});
    for (int i = 0; i < 8; ++i)
        block(k, i % 3 == 0 ? red : knob, {0.2f + 0.05f * static_cast<float>(i), y + 0.09f, -0.1f},
              {0.035f, 0.006f, 0.035f});
    for (const float sz : {-1.f, 1.f}) {
        k.rod(metal, {-0.38f, 0.02f, 0.07f * sz}, {0.38f, y - 0.01f, 0.07f * sz}, 0.017f, -1, 10);
        k.rod(metal, {0.38f, 0.02f, 0.03f * sz}, {-0.38f, y - 0.01f, 0.03f * sz}, 0.017f, -1, 10);
    }
    for (const float sx : {-1.f, 1.f})
        k.rod(metal, {sx * 0.38f, 0.02f, -0.2f}, {sx * 0.38f, 0.02f, 0.2f}, 0.019f, -1, 10),
            k.rod(metal, {sx * 0.38f, y - 0.012f, -0.16f}, {sx * 0.38f, y - 0.012f, 0.16f}, 0.015f, -1, 10);
    k.rod(metal, {0, 0.42f, -0.1f}, {0, 0.42f, 0.1f}, 0.03f, -1, 12);
    k.piece.clearance_front_m = 0.7f;
}

}  // namespace fastscene::furniture

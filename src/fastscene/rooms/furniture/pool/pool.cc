// Of swimming pools.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {

// A basin above the floor: tiled sides, a stone rim, lanes of floats, ladders, starting blocks at one end.
void build_swimming_pool(Kit& k) {
    const Vec3f s = k.wanted({4.6f, 0.95f, 8.f});
    Material tile = *material_named("tile");
    tile.color_a = {0.1f, 0.42f, 0.55f}, tile.color_b = {0.5f, 0.62f, 0.64f}, tile.scale_m = 0.1f,
    tile.roughness = 0.15f;
    Material deep = tile;
    deep.color_a = {0.04f, 0.3f, 0.46f};
    Material line = tile;
    line.color_a = {0.01f, 0.04f, 0.12f};
    Material water = glass();
    water.name = "water";
    water.color_a = {0.72f, 0.9f, 0.94f}, water.roughness = 0.03f;
    const int sides = k.main(tile), bottom = k.material(deep), lane = k.material(line), pane = k.material(water),
              stone = color(k, "rim", {0.6f, 0.58f, 0.53f}, 0.7f), metal = k.material(steel()),
              red = color(k, "red float", {0.6f, 0.04f, 0.03f}, 0.4f),
              white = color(k, "white float", {0.72f, 0.72f, 0.7f}, 0.4f),
              block_side = color(k, "starting block", {0.66f, 0.66f, 0.64f}, 0.4f),
              grip = color(k, "grip", {0.03f, 0.1f, 0.3f}, 0.8f);
    const float rim = 0.34f, high = 0.42f, level = high - 0.05f, ix = 0.5f * s.x - rim, iz = 0.5f * s.z - rim;
    k.board(bottom, {0, 0, 0}, {2 * ix, 0.02f, 2 * iz}, 0.001f);
    const int lanes = std::max(2, static_cast<int>(2 * ix / 1.3f));
    for (int i = 0; i < lanes; ++i) {
        const float x = -ix + 2 * ix * (static_cast<float>(i) + 0.5f) / static_cast<float>(lanes);
        k.board(lane, {x, 0.02f, 0}, {0.22f, 0.004f, 2 * iz - 1.2f}, 0.001f);
        for (const float end : {-1.f, 1.f}) k.board(lane, {x, 0.02f, end * (iz - 0.6f)}, {0.7f, 0.004f, 0.2f}, 0.001f);
    }
    for (const float e : {-1.f, 1.f}) {
        k.board(sides, {e * (0.5f * s.x - 0.5f * rim), 0, 0}, {rim - 0.04f, high - 0.04f, s.z}, 0.004f);
        k.board(sides, {0, 0, e * (0.5f * s.z - 0.5f * rim)}, {2 * ix + 0.04f, high - 0.04f, rim - 0.04f}, 0.004f);
        k.board(stone, {e * (0.5f * s.x - 0.5f * rim), high - 0.04f, 0}, {rim, 0.04f, s.z}, 0.012f);
        k.board(stone, {0, high - 0.04f, e * (0.5f * s.z - 0.5f * rim)}, {2 * ix, 0.04f, rim}, 0.012f);
    }
    // Slow waves.
    k.add(shapes::sheet(40, 60,
                        [&](float u, float v) {
                            const Vec3f p{2 * ix * (u - 0.5f), 0, 2 * iz * (0.5f - v)};
                            return p + Vec3f{0,
                                             level + 0.006f * shapes::wobble(p * 3.1f, 7) +
                                                 0.003f * shapes::wobble(p * 8.3f, 11),
                                             0};
                        }),
          pane);
    for (int i = 1; i < lanes; ++i) {
        const float x = -ix + 2 * ix * static_cast<float>(i) / static_cast<float>(lanes);
        const int floats = static_cast<int>(2 * iz / 0.16f);
        for (int j = 0; j < floats; ++j) {
            const std::array<Vec2f, 4> disc{Vec2f{0.02f, -0.06f}, {0.055f, -0.05f}, {0.055f, 0.05f}, {0.02f, 0.06f}};
            Mesh m = shapes::lathe(disc, 10);
            shapes::turn(m, {1, 0, 0}, 90);
            k.add(std::move(m), (j / 3) % 2 == 0 ? red : white,
                  {x, level + 0.01f, -iz + 0.16f * (static_cast<float>(j) + 0.5f)});
        }
    }
    for (int i = 0; i < lanes; ++i) {
        const float x = -ix + 2 * ix * (static_cast<float>(i) + 0.5f) / static_cast<float>(lanes),
                    z = -0.5f * s.z + 0.2f;
        k.board(block_side, {x, high, z}, {0.34f, s.y - high - 0.04f, 0.24f}, 0.02f);
        k.board(grip, {x, s.y - 0.05f, z + 0.03f}, {0.46f, 0.05f, 0.4f}, 0.015f);
    }
    // Ladders at the long sides.
    for (const float e : {-1.f, 1.f})
        for (const float dz : {-0.25f, 0.25f}) {
            const std::array<Vec3f, 6> rail{
                Vec3f{e * (ix + 0.28f), high, 0.6f * iz + dz},    {e * (ix + 0.26f), high + 0.45f, 0.6f * iz + dz},
                {e * (ix + 0.16f), high + 0.56f, 0.6f * iz + dz}, {e * (ix + 0.02f), high + 0.56f, 0.6f * iz + dz},
                {e * (ix - 0.08f), high + 0.42f, 0.6f * iz + dz}, {e * (ix - 0.08f), 0.05f, 0.6f * iz + dz}};
            k.add(shapes::tube(rail, 0.02f, 10), metal);
        }
    k.piece.clearance_front_m = 0.8f, k.piece.clearance_side_m = 0.6f;
}

// A reclining bed with a mattress, for the side of a pool.
void build_sun_lounger(Kit& k) {
    const Vec3f s = k.wanted({0.68f, 0.85f, 1.95f});
    const int frame = k.main(materials::timber("natural", 0.8f)),
              cloth = k.material(tinted(k.style.fabric, k.accent())),
              white = k.material(plain("towel", {0.74f, 0.73f, 0.7f}, 0.95f));
    const float seat = 0.3f, hinge = -0.22f * s.z, angle = 38.f;
    for (const float sx : {-1.f, 1.f}) {
        k.board(frame, {sx * (0.5f * s.x - 0.03f), seat - 0.08f, 0}, {0.05f, 0.08f, s.z}, 0.008f);
        for (const float sz : {-0.42f, 0.4f})
            k.board(frame, {sx * (0.5f * s.x - 0.04f), 0, sz * s.z}, {0.06f, seat - 0.08f, 0.06f}, 0.008f);
    }
    for (float z = hinge; z < 0.5f * s.z; z += 0.09f)
        k.board(frame, {0, seat - 0.02f, z + 0.03f}, {s.x - 0.1f, 0.02f, 0.07f}, 0.004f);
    k.soft(cloth, {0, seat, 0.5f * (hinge + 0.5f * s.z)}, {s.x - 0.08f, 0.08f, 0.5f * s.z - hinge},
           {0.03f, 0.012f, 0.001f, 10});
    Mesh back = shapes::soft_box({s.x - 0.08f, 0.08f, 0.7f}, {0.03f, 0.012f, 0.001f, 10, k.seed()});
    shapes::turn(back, {1, 0, 0}, angle);
    const float c = std::cos(angle / 57.29578f), sn = std::sin(angle / 57.29578f);
    k.add(std::move(back), cloth, {0, seat + 0.04f + 0.35f * sn, hinge - 0.35f * c});
    Mesh roll = shapes::rod({-0.2f, 0, 0}, {0.2f, 0, 0}, 0.065f, 0.065f, 16);
    k.add(std::move(roll), white, {0, seat + 0.14f, 0.32f * s.z});
    k.piece.clearance_front_m = 0.5f;
}

// A ring for rescue on its hook.
void build_lifebuoy(Kit& k) {
    const int red = k.main(plain("lifebuoy", {0.62f, 0.07f, 0.02f}, 0.5f)),
              white = color(k, "white band", {0.72f, 0.72f, 0.7f}, 0.5f),
              rope = color(k, "rope", {0.6f, 0.55f, 0.42f}, 0.9f);
    const float r = 0.3f, thick = 0.075f, cy = r + thick;
    Mesh ring = shapes::ring(r, thick, 40);
    shapes::turn(ring, {1, 0, 0}, 90);
    k.add(std::move(ring), red, {0, cy, thick});
    for (int i = 0; i < 4; ++i) {
        const float a = kTau * (static_cast<float>(i) + 0.5f) / 4;
        const Vec3f at{r * std::cos(a), cy + r * std::sin(a), thick}, tangent{-std::sin(a), std::cos(a), 0};
        k.rod(white, at - tangent * 0.06f, at + tangent * 0.06f, thick + 0.006f, -1, 18);
    }
    std::vector<Vec3f> loop;
    for (int i = 0; i <= 48; ++i) {
        const float a = kTau * static_cast<float>(i) / 48,
                    out = r + thick + 0.02f + 0.03f * std::abs(std::sin(2 * a + 0.5f * kPi));
        loop.push_back({out * std::cos(a), cy + out * std::sin(a), thick});
    }
    k.add(shapes::tube(loop, 0.01f, 6), rope);
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 1.2f;
}

}  // namespace fastscene::furniture

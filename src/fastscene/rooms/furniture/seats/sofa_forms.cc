// The forms that distinguish a sofa or an armchair of one style from that of another.
#include "fastscene/rooms/furniture/seats/sofa_forms.h"

#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/forms.h"

namespace fastscene::furniture {

// A wooden frame that shows, with loose cushions: northern, Japanese, southern and mid-century rooms.
void frame_sofa(Kit& k, float width, int seats) {
    // Of rattan: poles, arms and back of it, cushions of cloth.
    const bool woven = is_woven(k);
    const int main = woven ? woven_main(k) : k.main(k.style.fabric), cloth = woven ? k.material(k.style.fabric) : main,
              wood = woven ? main : k.material(k.style.wood), second = k.material(tinted(k.style.fabric2, k.accent()));
    const float depth = 0.84f, seat = 0.3f, arm = 0.58f;
    for (const float sx : {-1.f, 1.f}) {
        const float x = sx * (0.5f * width - 0.03f);
        if (woven) k.board(main, {x, 0.06f, 0}, {0.03f, arm - 0.06f, depth - 0.18f}, 0.01f);
        for (const float z : {-0.5f * depth + 0.06f, 0.5f * depth - 0.06f})
            k.board(wood, {x, 0, z}, {0.045f, arm, 0.06f}, 0.008f);
        k.board(wood, {x, arm - 0.001f, 0}, {0.085f, 0.03f, depth}, 0.01f);
        k.board(wood, {x, seat - 0.07f, 0}, {0.035f, 0.07f, depth - 0.16f}, 0.006f);
    }
    for (const float z : {-0.5f * depth + 0.06f, 0.5f * depth - 0.06f})
        k.board(wood, {0, seat - 0.07f, z}, {width - 0.1f, 0.07f, 0.035f}, 0.006f);
    for (int i = 0; i < 3; ++i)
        k.board(wood, {0, seat + 0.1f + 0.14f * static_cast<float>(i), -0.5f * depth + 0.05f},
                {width - 0.1f, 0.05f, 0.02f}, 0.005f);
    k.board(wood, {0, seat - 0.02f, 0}, {width - 0.12f, 0.02f, depth - 0.14f}, 0.004f);
    if (woven) {
        k.board(main, {0, seat + 0.05f, -0.5f * depth + 0.048f}, {width - 0.1f, 0.42f, 0.014f}, 0.004f);
        k.board(main, {0, 0.08f, 0.5f * depth - 0.085f}, {width - 0.1f, seat - 0.1f, 0.014f}, 0.004f);
    }
    const float inside = width - 0.14f, w = inside / static_cast<float>(seats);
    for (int i = 0; i < seats; ++i) {
        const float x = -0.5f * inside + (static_cast<float>(i) + 0.5f) * w;
        k.soft(cloth, {x, seat, 0.04f}, {w - 0.006f, 0.15f, depth - 0.14f}, {0.04f, 0.02f, 0.003f, 9});
        Mesh pad = shapes::soft_box({w - 0.02f, 0.44f, 0.15f}, {0.05f, 0.03f, 0.004f, 9, k.seed()});
        shapes::turn(pad, {1, 0, 0}, -14);
        k.add(std::move(pad), cloth, {x, seat + 0.33f, -0.5f * depth + 0.19f});
    }
    for (const float sx : {-1.f, 1.f}) {
        Mesh m = shapes::pillow({0.42f, 0.42f, 0.15f}, k.seed());
        shapes::turn(m, {1, 0, 0}, -24);
        shapes::turn(m, {0, 1, 0}, -sx * 20.f);
        k.add_soft(std::move(m), sx > 0 ? second : cloth, kPillowCrease,
                   {sx * (0.5f * inside - 0.24f), seat + 0.15f, -0.5f * depth + 0.4f});
    }
    k.piece.clearance_front_m = 0.5f;
    k.piece.against_wall = true;
    k.top(seat + 0.15f, 0, 0.12f, 0.4f * inside, 0.2f);
}

// Back and arms of one height, rolled outward and buttoned.
void chesterfield(Kit& k, float width, int seats) {
    const bool hide = k.style.sofa != SofaType::rolled || k.rng.chance(0.5f);
    const int cloth = k.main(hide ? k.style.leather : k.style.fabric), foot = k.material(k.style.wood2);
    const float depth = 0.92f, seat = 0.42f, top = 0.72f, arm = 0.18f, z0 = -0.5f * depth, inside = width - 2 * arm;
    feet(k, foot, width, depth, 0.1f, 0.f);
    k.soft(cloth, {0, 0.09f, 0}, {width - 0.03f, seat - 0.22f, depth - 0.03f}, {0.03f, 0.006f, 0.001f, 8});
    k.soft(cloth, {0, 0.2f, z0 + 0.12f}, {width - 0.1f, top - 0.22f, 0.16f}, {0.05f, 0.02f, 0.001f, 10});
    const auto roll = [&](Vec3f a, Vec3f b) { k.rod(cloth, a, b, 0.085f, -1, 20); };
    roll({-0.5f * width + 0.1f, top - 0.03f, z0 + 0.1f}, {0.5f * width - 0.1f, top - 0.03f, z0 + 0.1f});
    for (const float sx : {-1.f, 1.f}) {
        const float x = sx * (0.5f * width - 0.1f);
        k.soft(cloth, {x + sx * 0.01f, 0.1f, 0}, {arm - 0.05f, top - 0.14f, depth - 0.05f},
               {0.04f, 0.015f, 0.001f, 10});
        roll({x, top - 0.03f, z0 + 0.1f}, {x, top - 0.03f, -z0 - 0.08f});
        k.add(shapes::ball({x, top - 0.03f, -z0 - 0.04f}, {0.06f, 0.06f, 0.02f}, 14), cloth);
    }
    buttons(k, cloth, -0.5f * inside + 0.1f, 0.5f * inside - 0.1f, seat + 0.08f, top - 0.06f, z0 + 0.215f, 0.17f);
    const float w = inside / static_cast<float>(seats);
    for (int i = 0; i < seats; ++i)
        k.soft(cloth, {-0.5f * inside + (static_cast<float>(i) + 0.5f) * w, seat - 0.15f, 0.09f},
               {w - 0.004f, 0.17f, depth - 0.22f}, {0.05f, 0.03f, 0.002f, 9});
    k.piece.clearance_front_m = 0.5f;
    k.piece.against_wall = true;
    k.top(seat + 0.02f, 0, 0.12f, 0.4f * inside, 0.2f);
}

namespace {

// Points at equal distances along a curve over [0, 1], half a distance from its ends; and that distance.
std::pair<std::vector<Vec2f>, float> evenly_along(const std::function<Vec2f(float)>& curve, int count) {
    constexpr int kPieces = 4096;
    std::vector<float> way{0};
    for (int i = 0; i < kPieces; ++i)
        way.push_back(way.back() +
                      length(curve(static_cast<float>(i + 1) / kPieces) - curve(static_cast<float>(i) / kPieces)));
    const float apart = way.back() / static_cast<float>(count);
    std::vector<Vec2f> out;
    for (int i = 0, at = 0; i < count; ++i) {
        while (at < kPieces && way[static_cast<std::size_t>(at)] < (static_cast<float>(i) + 0.5f) * apart) ++at;
        out.push_back(curve(static_cast<float>(at) / kPieces));
    }
    return {out, apart};
}

}  // namespace

// A back of upright padded channels that bends round into the arms.
void channel_seat(Kit& k, float width, int channels) {
    const int cloth = k.main(k.style.fabric), foot = k.material(k.style.metal);
    const float depth = width > 1.3f ? 0.9f : 0.8f, seat = 0.43f, top = width > 1.3f ? 0.8f : 0.78f,
                rx = 0.5f * width - 0.08f, rz = depth - 0.2f, z0 = -0.5f * depth + 0.1f;
    // A plinth and the seat on it.
    k.soft(cloth, {0, 0.06f, 0.02f}, {width - 0.14f, seat - 0.2f, depth - 0.12f}, {0.05f, 0.006f, 0.001f, 10});
    k.board(foot, {0, 0, 0.02f}, {width - 0.3f, 0.07f, depth - 0.28f}, 0.01f);
    k.soft(cloth, {0, seat - 0.16f, 0.07f}, {width - 0.2f, 0.18f, depth - 0.2f}, {0.06f, 0.03f, 0.002f, 10});
    // Side by side along half a superellipse that is open to the front.
    const auto outline = [&](float t) {
        const float a = kPi * t;
        return Vec2f{rx * std::copysign(std::pow(std::fabs(std::cos(a)), 0.6f), -std::cos(a)),
                     rz * std::pow(std::max(0.f, std::sin(a)), 0.6f)};
    };
    const auto [places, far] = evenly_along(outline, channels);
    const float r = 0.54f * far;  // neighbours sink into each other a little
    for (const Vec2f place : places) {
        const float sz = place.y / rz;
        const Vec3f at{place.x, 0, z0 + rz - place.y};
        const float high = top - 0.14f * (1.f - sz);
        k.rod(cloth, at + Vec3f{0, 0.12f, 0}, at + Vec3f{0, high - r, 0}, r, -1, 16);
        k.add(shapes::ball(at + Vec3f{0, high - r, 0}, {r, 0.7f * r, r}, 14), cloth);
    }
    k.piece.clearance_front_m = 0.5f;
    k.piece.against_wall = width > 1.3f;
    k.top(seat + 0.02f, 0, 0.12f, 0.3f * width, 0.2f);
}

// A high back with ears.
void wing_chair(Kit& k) {
    const int cloth = k.main(k.style.fabric), foot = k.material(k.style.wood);
    const float width = 0.78f, depth = 0.84f, z0 = -0.5f * depth;
    feet(k, foot, width, depth, 0.17f, 0.f);
    k.soft(cloth, {0, 0.15f, 0}, {width - 0.04f, 0.16f, depth - 0.06f}, {0.03f, 0.006f, 0.001f, 8});
    k.soft(cloth, {0, 0.29f, 0.06f}, {width - 0.24f, 0.17f, depth - 0.2f}, {0.05f, 0.035f, 0.003f, 9});
    Mesh back = shapes::soft_box({width - 0.14f, 0.82f, 0.17f}, {0.06f, 0.03f, 0.002f, 10, k.seed()});
    shapes::turn(back, {1, 0, 0}, -9);
    k.add(std::move(back), cloth, {0, 0.69f, z0 + 0.16f});
    for (const float sx : {-1.f, 1.f}) {
        const float x = sx * (0.5f * width - 0.07f);
        k.soft(cloth, {x, 0.2f, 0.02f}, {0.12f, 0.38f, depth - 0.1f}, {0.05f, 0.02f, 0.001f, 9});
        k.rod(cloth, {x + sx * 0.012f, 0.57f, z0 + 0.12f}, {x + sx * 0.012f, 0.57f, -z0 - 0.06f}, 0.062f, -1, 16);
        Mesh wing = shapes::soft_box({0.09f, 0.52f, 0.28f}, {0.04f, 0.015f, 0.001f, 8, k.seed()});
        shapes::turn(wing, {1, 0, 0}, -8);
        k.add(std::move(wing), cloth, {x - sx * 0.01f, 0.82f, z0 + 0.25f});
    }
    Mesh cushion = shapes::pillow({0.42f, 0.3f, 0.13f}, k.seed());
    shapes::turn(cushion, {1, 0, 0}, -18);
    k.add_soft(std::move(cushion), k.material(tinted(k.style.fabric2, k.accent())), kPillowCrease,
               {0, 0.46f, z0 + 0.36f});
    k.top(0.465f, 0, 0.2f, 0.24f, 0.16f);
    k.piece.clearance_front_m = 0.5f;
}

// A hide slung in a frame of steel tube.
void sling_chair(Kit& k) {
    const int hide = k.main(k.style.leather), metal = k.material(k.style.metal);
    for (const float sx : {-1.f, 1.f}) {
        const float x = sx * 0.33f;
        const std::array<Vec3f, 7> side{Vec3f{x, 0.02f, 0.36f}, {x, 0.56f, 0.34f},  {x, 0.57f, 0.3f}, {x, 0.57f, -0.2f},
                                        {x, 0.56f, -0.3f},      {x, 0.02f, -0.34f}, {x, 0.02f, 0.36f}};
        k.add(shapes::tube(side, 0.013f, 8), metal);
        k.board(hide, {x, 0.575f, 0.04f}, {0.055f, 0.012f, 0.44f}, 0.004f);
        k.rod(metal, {x, 0.4f, 0.33f}, {x, 0.28f, -0.26f}, 0.012f);
        k.rod(metal, {x, 0.28f, -0.26f}, {x, 0.84f, -0.4f}, 0.012f);
    }
    for (const Vec3f at : {Vec3f{0, 0.4f, 0.33f}, Vec3f{0, 0.28f, -0.26f}, Vec3f{0, 0.84f, -0.4f}})
        k.rod(metal, {-0.33f, at.y, at.z}, {0.33f, at.y, at.z}, 0.012f);
    k.add(shapes::slab(8, 14, 0.03f,
                       [](float u, float v) {
                           const float x = (u - 0.5f) * 0.6f, t = v * 2.f;
                           if (t < 1.f)
                               return Vec3f{x, 0.415f - 0.13f * t - 0.035f * std::sin(kPi * t), 0.34f - 0.58f * t};
                           return Vec3f{x, 0.285f + 0.56f * (t - 1.f),
                                        -0.24f - 0.15f * (t - 1.f) - 0.03f * std::sin(kPi * (t - 1.f))};
                       }),
          hide);
    k.top(0.36f, 0, 0.1f, 0.24f, 0.16f);
    k.piece.clearance_front_m = 0.5f;
}

// Woven round a tall open back, with a cushion.
void rattan_chair(Kit& k) {
    const int cane = woven_main(k), cloth = k.material(k.style.fabric);
    const auto arc = [](float y, float r, float open) {
        std::vector<Vec3f> path;
        for (int i = 0; i <= 20; ++i) {
            const float a = open + (2 * kPi - 2 * open) * static_cast<float>(i) / 20.f;
            path.push_back({r * std::sin(a), y, r * std::cos(a)});
        }
        return path;
    };
    k.add(shapes::tube(arc(0.02f, 0.28f, 0.f), 0.015f, 8), cane);
    for (int i = 0; i < 10; ++i) {
        const float a = 2 * kPi * (static_cast<float>(i) + 0.5f) / 10.f;
        k.rod(cane, {0.28f * std::sin(a), 0.02f, 0.28f * std::cos(a)},
              {0.34f * std::sin(a), 0.37f, 0.34f * std::cos(a)}, 0.012f);
    }
    k.add(shapes::prism(shapes::circle(0.36f, 36), 0.35f, 0.39f, 0.01f), cane);
    // The back rises from the arms to the middle.
    k.add(shapes::slab(24, 8, 0.02f,
                       [](float u, float v) {
                           const float a = 0.62f + (2 * kPi - 1.24f) * u, back = 0.5f - 0.5f * std::cos(a),
                                       high = 0.2f + 0.42f * back * back, r = 0.36f + 0.07f * v * (0.4f + back);
                           return Vec3f{r * std::sin(a), 0.38f + high * v, r * std::cos(a)};
                       }),
          cane);
    k.soft(cloth, {0, 0.385f, 0.02f}, {0.54f, 0.12f, 0.54f}, {0.055f, 0.03f, 0.003f, 12});
    Mesh cushion = shapes::pillow({0.4f, 0.38f, 0.14f}, k.seed());
    shapes::turn(cushion, {1, 0, 0}, -20);
    k.add_soft(std::move(cushion), k.material(tinted(k.style.fabric2, k.accent())), kPillowCrease, {0, 0.5f, -0.16f});
    k.top(0.505f, 0, 0.12f, 0.22f, 0.14f);
    k.piece.clearance_front_m = 0.5f;
}

}  // namespace fastscene::furniture

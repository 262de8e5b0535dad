// Sofas, chairs and what is soft.
#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/rooms/furniture_forms.h"

namespace fastscene::furniture {

int accent_cloth(Kit& k) {
    Material m = tinted(k.style.fabric2, k.accent());
    const int kind = k.dice.index(4);
    if (kind == 1)
        m.pattern = Pattern::stripes, m.scale_m = 0.02f, m.color_b = Vec3f{0.7f, 0.67f, 0.6f}, m.color_c = m.color_a;
    if (kind == 2) m.pattern = Pattern::knit, m.scale_m = 0.012f, m.bump_m = 0.002f;
    return k.material(m);
}
void put_pillow(Kit& k, int mat, Vec3f at, Vec3f size, float lean_deg, float yaw_deg) {
    Mesh m = shapes::pillow(size, k.seed());
    shapes::turn(m, {1, 0, 0}, -lean_deg);
    shapes::turn(m, {0, 1, 0}, yaw_deg);
    k.add(std::move(m), mat, at);
}

namespace {

// Wool unless it was said otherwise; patchwork: squares of the room's own colors.
Material throw_cloth(Kit& k) {
    Material m = tinted(k.style.fabric2, k.accent());
    m.name = "wool";
    m.pattern = Pattern::knit, m.scale_m = 0.012f, m.bump_m = 0.002f;
    if (k.request.pattern == "patchwork") {
        m.name = "patchwork";
        m.pattern = Pattern::fabric, m.scale_m = 0.002f, m.bump_m = 0.f;
        m.color_a = k.style.palette[0], m.color_b = lerp(k.style.palette[1], {0.7f, 0.66f, 0.58f}, 0.5f),
        m.color_c = k.style.palette[2];
    }
    return m;
}

// Sofas of any width: seat cushions, back cushions, arms by the style's type.
void couch(Kit& k, float width, int seats, int pillows) {
    const SofaType type = k.style.sofa;
    const bool slim = type == SofaType::slim, rolled = type == SofaType::rolled;
    const int cloth = k.main(k.style.fabric), foot = k.material(slim ? k.style.wood : k.style.wood2);
    const float depth = slim ? 0.82f : 0.93f, seat_y = 0.43f,
                arm = slim     ? 0.07f
                      : rolled ? 0.17f
                               : 0.2f,
                back_y = slim     ? 0.8f
                         : rolled ? 0.9f
                                  : 0.84f;
    const float leg = slim ? 0.17f : rolled ? 0.09f : 0.05f, inside = width - 2 * arm, arm_y = slim ? 0.6f : 0.63f;
    const float z0 = -0.5f * depth;
    // Legs, base, back.
    for (const float sx : {-1.f, 1.f})
        for (const float z : {z0 + 0.1f, -z0 - 0.1f}) {
            const Vec3f top{sx * (0.5f * width - 0.12f), leg + 0.01f, z};
            k.rod(foot, {top.x + (slim ? sx * 0.03f : 0.f), 0, z * (slim ? 1.06f : 1.f)}, top, slim ? 0.013f : 0.022f,
                  slim ? 0.024f : 0.028f, 12);
        }
    k.soft(cloth, {0, leg, 0}, {width - (slim ? 0.02f : 0.04f), seat_y - 0.16f - leg, depth - 0.03f},
           {0.02f, 0.004f, 0.002f, 8});
    const float back_t = 0.2f;
    Mesh back = shapes::soft_box({inside + (slim ? 0.1f : 0.02f), back_y - leg - 0.04f, back_t},
                                 {0.05f, 0.01f, 0.002f, 6, k.seed()});
    k.add(std::move(back), cloth, {0, 0.5f * (back_y + leg) - 0.02f, z0 + 0.5f * back_t});
    // Arms.
    for (const float sx : {-1.f, 1.f}) {
        const float x = sx * 0.5f * (width - arm);
        if (slim) {
            k.soft(cloth, {x, seat_y - 0.2f, 0}, {arm, arm_y - seat_y + 0.2f, depth - 0.02f},
                   {0.03f, 0.006f, 0.001f, 8});
        } else if (rolled) {
            k.soft(cloth, {x - sx * 0.02f, leg, 0}, {arm - 0.04f, arm_y - 0.06f - leg, depth - 0.03f},
                   {0.03f, 0.01f, 0.001f, 8});
            const std::array<Vec2f, 6> p{Vec2f{0.055f, 0},        {0.085f, 0.012f},         {0.092f, 0.05f},
                                         {0.092f, depth - 0.05f}, {0.085f, depth - 0.012f}, {0.055f, depth}};
            Mesh roll = shapes::lathe(p, 24, true);
            shapes::turn(roll, {1, 0, 0}, 90);
            k.add(std::move(roll), cloth, {x, arm_y - 0.02f, z0});
        } else {
            k.soft(cloth, {x, leg, 0}, {arm, arm_y - leg, depth}, {0.05f, 0.015f, 0.002f, 8});
        }
    }
    // Cushions.
    const float w = inside / static_cast<float>(seats);
    for (int i = 0; i < seats; ++i) {
        const float x = -0.5f * inside + (static_cast<float>(i) + 0.5f) * w;
        k.soft(cloth, {x, seat_y - 0.17f, 0.5f * back_t - 0.02f}, {w - 0.004f, 0.19f, depth - back_t + 0.01f},
               {0.05f, 0.035f, 0.004f, 9});
        Mesh pad = shapes::soft_box({w - 0.01f, back_y - seat_y + 0.06f, 0.2f}, {0.07f, 0.05f, 0.006f, 9, k.seed()});
        shapes::turn(pad, {1, 0, 0}, -11);
        k.add(std::move(pad), cloth, {x, 0.5f * (back_y + seat_y) + 0.04f, z0 + back_t + 0.06f});
    }
    for (int i = 0; i < pillows; ++i) {
        const int mat = accent_cloth(k);
        const float s = k.dice.uniform(0.4f, 0.47f), sx = i % 2 == 0 ? -1.f : 1.f;
        put_pillow(k, mat,
                   {sx * (0.5f * inside - 0.24f - 0.22f * static_cast<float>(i / 2)), seat_y + 0.005f,
                    z0 + back_t + 0.27f + 0.05f * static_cast<float>(i / 2)},
                   {s, s, 0.16f}, 20, -sx * 18.f + k.dice.uniform(-8, 8));
    }
    if (rolled)
        k.rod(cloth, {-0.5f * inside, back_y - 0.05f, z0 + 0.09f}, {0.5f * inside, back_y - 0.05f, z0 + 0.09f}, 0.075f,
              -1, 20);
    k.piece.clearance_front_m = 0.5f;
    k.piece.against_wall = true;
    k.top(seat_y + 0.02f, 0, 0.12f, 0.4f * inside, 0.2f);
}
enum SofaForm { padded, framed, buttoned, channelled };
int sofa_form(Kit& k) {
    if (is_woven(k)) return framed;
    return form_for(k,
                    {{"modern", padded, channelled},
                     {"scandinavian", padded, framed},
                     {"japandi", framed, padded},
                     {"industrial", buttoned, padded},
                     {"classic", padded, buttoned},
                     {"boho", framed, padded},
                     {"rustic", padded, framed},
                     {"mid-century", padded, framed},
                     {"mediterranean", padded, framed},
                     {"art deco", channelled, buttoned}},
                    padded);
}
void sofa_of(Kit& k, float width, int seats, int pillows) {
    switch (sofa_form(k)) {
        case framed: return frame_sofa(k, width, seats);
        case buttoned: return chesterfield(k, width, seats);
        case channelled: return channel_seat(k, width, seats * 8);
        default: return couch(k, width, seats, pillows);
    }
}
void corner_of(Kit& k, float width, int seats);
void sofa(Kit& k) {
    const float w = k.request.size_m.x > 0 ? k.request.size_m.x : 2.2f * k.request.size_factor;
    k.sized = true;
    if (k.request.pattern == "corner") {
        const float wide = std::max(w, 2.f) + (k.request.size_m.x > 0 ? 0.f : 0.3f);
        couch(k, wide, 3, 2 + k.dice.index(3));
        return corner_of(k, wide, 3);
    }
    sofa_of(k, std::max(w, 1.2f), w > 1.9f ? 3 : 2, 2 + k.dice.index(3));
}
// The long seat of a corner sofa, at the right of a padded one: what reaches before the last of its cushions.
void corner_of(Kit& k, float width, int seats) {
    const SofaType type = k.style.sofa;
    const bool slim = type == SofaType::slim, rolled = type == SofaType::rolled;
    const int cloth = k.piece.main_material, foot = k.material(slim ? k.style.wood : k.style.wood2);
    const float arm = slim     ? 0.07f
                      : rolled ? 0.17f
                               : 0.2f,
                leg = slim     ? 0.17f
                      : rolled ? 0.09f
                               : 0.05f,
                seat_y = 0.43f, front = 0.5f * (slim ? 0.82f : 0.93f), reach = 0.7f, inside = width - 2 * arm,
                w = inside / static_cast<float>(seats) + (slim ? 0.f : 0.5f * arm),
                x = 0.5f * inside - inside / static_cast<float>(2 * seats) + (slim ? 0.f : 0.25f * arm);
    k.soft(cloth, {x, leg, front + 0.5f * reach - 0.03f}, {w - 0.01f, seat_y - 0.16f - leg, reach + 0.04f},
           {0.02f, 0.004f, 0.002f, 8});
    k.soft(cloth, {x, seat_y - 0.17f, front + 0.5f * reach - 0.035f}, {w - 0.004f, 0.19f, reach + 0.02f},
           {0.05f, 0.035f, 0.004f, 9});
    for (const float sx : {-1.f, 1.f})
        k.rod(foot, {x + sx * (0.5f * w - 0.09f), 0, front + reach - 0.12f},
              {x + sx * (0.5f * w - 0.09f), leg + 0.01f, front + reach - 0.12f}, 0.018f, 0.026f, 12);
}
void loveseat(Kit& k) { sofa_of(k, 1.55f, 2, 2); }
void shell_chair(Kit& k);
void armchair(Kit& k) {
    if (is_woven(k)) return rattan_chair(k);
    enum { shell, padded_chair, wing, tub, sling, rattan };
    const int form = form_for(k,
                              {{"modern", tub, padded_chair},
                               {"scandinavian", shell, wing},
                               {"japandi", shell, tub},
                               {"industrial", sling, padded_chair},
                               {"classic", wing, padded_chair},
                               {"boho", rattan, shell},
                               {"rustic", wing, padded_chair},
                               {"mid-century", shell, tub},
                               {"mediterranean", rattan, padded_chair},
                               {"art deco", tub, wing}},
                              shell);
    switch (form) {
        case padded_chair: return couch(k, 0.92f, 1, k.dice.index(2));
        case wing: return wing_chair(k);
        case tub: return channel_seat(k, 0.8f, 17);
        case sling: return sling_chair(k);
        case rattan: return rattan_chair(k);
        default: return shell_chair(k);
    }
}
void shell_chair(Kit& k) {
    // A shell chair: wooden frame, seat and back pads.
    const int cloth = k.main(k.style.fabric), wood = k.material(k.style.wood);
    for (const float sx : {-1.f, 1.f}) {
        const float x = sx * 0.34f;
        k.rod(wood, {x, 0, 0.33f}, {x, 0.6f, 0.27f}, 0.014f, 0.02f);
        k.rod(wood, {x, 0, -0.38f}, {x, 0.6f, -0.24f}, 0.014f, 0.02f);
        Mesh arm = shapes::box({0.06f, 0.028f, 0.68f}, 0.01f);
        shapes::turn(arm, {1, 0, 0}, -4);
        k.add(std::move(arm), wood, {x, 0.6f, 0});
        k.rod(wood, {x, 0.3f, 0.3f}, {x, 0.26f, -0.31f}, 0.015f);
    }
    k.rod(wood, {-0.34f, 0.29f, 0.29f}, {0.34f, 0.29f, 0.29f}, 0.016f);
    k.rod(wood, {-0.34f, 0.26f, -0.3f}, {0.34f, 0.26f, -0.3f}, 0.016f);
    Mesh seat = shapes::soft_box({0.62f, 0.15f, 0.64f}, {0.05f, 0.03f, 0.004f, 9, k.seed()});
    shapes::turn(seat, {1, 0, 0}, -5);
    k.add(std::move(seat), cloth, {0, 0.37f, 0.03f});
    Mesh back = shapes::soft_box({0.62f, 0.56f, 0.14f}, {0.05f, 0.03f, 0.004f, 9, k.seed()});
    shapes::turn(back, {1, 0, 0}, -17);
    k.add(std::move(back), cloth, {0, 0.64f, -0.3f});
    k.top(0.455f, 0, 0.08f, 0.24f, 0.18f);
    k.piece.clearance_front_m = 0.5f;
}

void ottoman(Kit& k) {
    const int cloth = k.main(k.style.fabric2), wood = k.material(k.style.wood);
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f})
            k.rod(wood, {sx * 0.24f, 0, sz * 0.18f}, {sx * 0.23f, 0.16f, sz * 0.17f}, 0.014f, 0.022f);
    k.soft(cloth, {0, 0.15f, 0}, {0.65f, 0.27f, 0.5f}, {0.05f, 0.03f, 0.003f, 14});
    k.top(0.41f, 0, 0, 0.22f, 0.15f);
}
void pouf(Kit& k) {
    Material m = k.style.fabric2;
    m.pattern = Pattern::knit;
    m.scale_m = 0.02f;
    m.bump_m = 0.004f;
    const int cloth = k.main(m);
    std::array<Vec2f, 9> p{};
    for (std::size_t i = 0; i < p.size(); ++i) {
        const float t = 3.14159f * static_cast<float>(i) / 8.f;
        p[i] = {i == 0 || i == 8 ? 0.f : 0.27f * std::pow(std::sin(t), 0.55f),
                0.2f - 0.2f * std::copysign(std::pow(std::fabs(std::cos(t)), 0.8f), std::cos(t))};
    }
    k.add(shapes::lathe(p, 32, true), cloth);
    k.top(0.4f, 0, 0, 0.12f, 0.12f);
}

// Poles of cane, a woven seat and a high woven back that hugs a little.
void woven_chair(Kit& k) {
    const int cane = woven_main(k);
    Material pole = plain("cane", k.piece.materials[static_cast<std::size_t>(cane)].color_a * 0.85f, 0.5f);
    const int poles = k.material(pole);
    const float y = 0.45f;
    for (const float sx : {-1.f, 1.f}) {
        k.rod(poles, {sx * 0.2f, 0, 0.19f}, {sx * 0.21f, y, 0.18f}, 0.016f, -1, 12);
        k.rod(poles, {sx * 0.2f, 0, -0.2f}, {sx * 0.19f, y, -0.18f}, 0.016f, -1, 12);
        k.rod(poles, {sx * 0.19f, y - 0.01f, -0.185f}, {sx * 0.2f, 0.9f, -0.27f}, 0.016f, -1, 12);
        k.rod(poles, {sx * 0.2f, 0.2f, 0.188f}, {sx * 0.195f, 0.2f, -0.19f}, 0.01f, -1, 10);
    }
    k.rod(poles, {-0.2f, 0.9f, -0.27f}, {0.2f, 0.9f, -0.27f}, 0.016f, -1, 12);
    k.rod(poles, {-0.2f, 0.25f, 0.188f}, {0.2f, 0.25f, 0.188f}, 0.01f, -1, 10);
    k.add(shapes::prism(shapes::rounded_rectangle(0.46f, 0.43f, 0.06f), y - 0.03f, y, 0.01f), cane);
    k.add(shapes::slab(
              12, 6, 0.012f,
              [&](float u, float v) {
                  const float x = (u - 0.5f) * 0.4f, t = 0.12f + 0.86f * v;
                  return Vec3f{x, y + 0.45f * t, -0.18f - 0.085f * t - 0.02f * (1.f - 4.f * (u - 0.5f) * (u - 0.5f))};
              }),
          cane);
    k.top(y, 0, 0.03f, 0.18f, 0.16f);
    k.piece.clearance_front_m = 0.3f;
}
// A padded seat and a padded back on legs of the style: chairs that were asked for in cloth or leather.
void upholstered_chair(Kit& k) {
    const int cloth = k.main(k.style.fabric),
              frame = k.material(k.style.legs == LegType::metal_frame ? k.style.metal : k.style.wood);
    const float y = 0.47f, rise = 0.5f, lean = -8.f;
    legs(k, frame, 0.19f, 0.19f, y - 0.08f, 0.034f);
    k.soft(cloth, {0, y - 0.1f, 0.005f}, {0.47f, 0.11f, 0.47f}, {0.03f, 0.018f, 0.002f, 10});
    Mesh back = shapes::soft_box({0.46f, rise, 0.07f}, {0.032f, 0.014f, 0.002f, 10, k.seed()});
    shapes::turn(back, {1, 0, 0}, lean);
    k.add(std::move(back), cloth, {0, y - 0.02f + 0.5f * rise, -0.235f});
    for (const float sx : {-1.f, 1.f})  // what bears the back
        k.rod(frame, {sx * 0.17f, y - 0.09f, -0.19f}, {sx * 0.17f, y + 0.06f, -0.215f}, 0.013f, -1, 10);
    k.top(y + 0.012f, 0, 0.03f, 0.18f, 0.16f);
    k.piece.clearance_front_m = 0.3f;
}
void chair(Kit& k) {
    if (is_woven(k)) return woven_chair(k);
    if (is_upholstery(k.request.material)) return upholstered_chair(k);
    const LegType type = k.style.legs;
    const bool metal = type == LegType::metal_frame, wooden = type == LegType::square || type == LegType::turned;
    const int body = k.main(wooden || !metal ? k.style.wood : k.style.leather), pad = k.material(k.style.fabric2),
              frame = metal ? k.material(k.style.metal) : body;
    const float y = 0.46f;
    legs(k, frame, 0.19f, 0.19f, y - 0.02f, 0.036f);
    if (metal) {
        k.soft(body, {0, y - 0.025f, 0.01f}, {0.46f, 0.07f, 0.46f}, {0.03f, 0.012f, 0.001f, 8});
        Mesh back = shapes::soft_box({0.44f, 0.34f, 0.05f}, {0.02f, 0.01f, 0.001f, 10, k.seed()});
        shapes::turn(back, {1, 0, 0}, -9);
        k.add(std::move(back), body, {0, 0.7f, -0.235f});
        for (const float sx : {-1.f, 1.f})
            k.rod(frame, {sx * 0.19f, y - 0.03f, -0.19f}, {sx * 0.19f, 0.78f, -0.265f}, 0.011f);
    } else {
        k.add(shapes::prism(shapes::rounded_rectangle(0.45f, 0.43f, 0.06f), y - 0.025f, y, 0.006f), body);
        if (k.style.sofa == SofaType::rolled || type == LegType::turned)
            k.soft(pad, {0, y - 0.006f, 0.01f}, {0.41f, 0.05f, 0.39f}, {0.02f, 0.012f, 0.001f, 10});
        for (const float sx : {-1.f, 1.f})
            k.rod(body, {sx * 0.19f, y - 0.01f, -0.185f}, {sx * 0.2f, 0.88f, -0.27f}, 0.018f, 0.013f, 12);
        const auto rail = [&](float yy, float h) {
            Mesh m = shapes::slab(10, 2, 0.016f, [&](float u, float v) {
                const float x = (u - 0.5f) * 0.4f, t = (yy + v * h - y) / 0.42f;
                return Vec3f{x, yy + v * h, -0.178f - 0.085f * t - 0.035f * (1.f - 4.f * (u - 0.5f) * (u - 0.5f))};
            });
            k.add(std::move(m), body);
        };
        if (type == LegType::square) {
            for (int i = 0; i < 3; ++i) rail(0.56f + 0.11f * static_cast<float>(i), 0.05f);
        } else if (type == LegType::turned) {
            rail(0.8f, 0.08f);
            for (int i = -2; i <= 2; ++i) {
                const float x = 0.065f * static_cast<float>(i), bow = 0.03f * (1.f - x * x / 0.04f);
                k.rod(body, {x, y - 0.01f, -0.185f}, {x, 0.815f, -0.262f - bow}, 0.008f, -1, 8);
            }
        } else {
            rail(0.7f, 0.17f);
        }
    }
    const bool padded = metal || k.style.sofa == SofaType::rolled || type == LegType::turned;
    k.top(padded ? y + 0.044f : y, 0, 0.03f, 0.18f, 0.16f);
    k.piece.clearance_front_m = 0.3f;
}
void round_seat(Kit& k, float y, float r) {
    const bool padded = is_upholstery(k.request.material);
    const int seat = k.main(padded ? k.style.fabric : k.style.wood);
    const int frame = k.style.legs == LegType::metal_frame ? k.material(k.style.metal)
                      : padded                             ? k.material(k.style.wood)
                                                           : seat;
    if (padded) {
        const float d = 0.014f;
        const std::array<Vec2f, 7> p{Vec2f{0, y - 0.075f}, {r - d, y - 0.075f}, {r, y - 0.06f}, {r, y - 0.02f},
                                     {r - d, y - 0.004f},  {0.5f * r, y},       {0, y}};
        k.add(shapes::lathe(p, 36, true), seat);
    } else {
        k.add(shapes::prism(shapes::circle(r), y - 0.035f, y, 0.008f), seat);
    }
    for (int i = 0; i < 4; ++i) {
        const float a = 0.7854f + 1.5708f * static_cast<float>(i), c = std::cos(a), s = std::sin(a);
        k.rod(frame, {1.12f * r * c, 0, 1.12f * r * s}, {0.7f * r * c, y - 0.03f, 0.7f * r * s}, 0.012f, 0.016f);
    }
    Mesh foot = shapes::ring(0.98f * r, 0.014f);
    k.add(std::move(foot), frame, {0, 0.35f * y, 0});
    k.top(y, 0, 0, 0.6f * r, 0.6f * r);
}
void stool(Kit& k) { round_seat(k, 0.46f, 0.17f); }
void bar_stool(Kit& k) { round_seat(k, 0.68f, 0.18f); }
void bench(Kit& k) {
    const Vec3f s = k.wanted({1.2f, 0.46f, 0.38f});
    const bool padded = is_upholstery(k.request.material);
    const int seat = k.main(padded ? k.style.fabric : k.style.wood);
    const int metal = k.style.legs == LegType::metal_frame ? k.material(k.style.metal)
                      : padded                             ? k.material(k.style.wood)
                                                           : seat;
    legs(k, metal, 0.5f * s.x - 0.1f, 0.5f * s.z - 0.06f, s.y - 0.04f, 0.05f);
    if (padded) k.soft(seat, {0, s.y - 0.1f, 0}, {s.x, 0.1f, s.z}, {0.03f, 0.016f, 0.002f, 20});
    else k.board(seat, {0, s.y - 0.045f, 0}, {s.x, 0.045f, s.z}, 0.006f);
    k.top(s.y, 0, 0, 0.45f * s.x, 0.4f * s.z);
    k.piece.clearance_front_m = 0.4f;
}
void office_chair(Kit& k) {
    const int cloth = k.main(k.style.leather),
              dark = k.material(plain("black plastic", {0.035f, 0.035f, 0.037f}, 0.4f)), chrome = k.material(steel());
    for (int i = 0; i < 5; ++i) {
        const float a = 1.2566f * static_cast<float>(i), c = std::cos(a), s = std::sin(a);
        k.rod(chrome, {0.03f * c, 0.11f, 0.03f * s}, {0.29f * c, 0.075f, 0.29f * s}, 0.022f, 0.014f);
        k.add(shapes::ball({0.29f * c, 0.03f, 0.29f * s}, {0.03f, 0.03f, 0.03f}, 10), dark);
    }
    k.rod(chrome, {0, 0.09f, 0}, {0, 0.4f, 0}, 0.026f, 0.02f);
    k.board(dark, {0, 0.39f, 0}, {0.24f, 0.04f, 0.24f}, 0.01f);
    k.soft(cloth, {0, 0.42f, 0.02f}, {0.5f, 0.09f, 0.48f}, {0.04f, 0.02f, 0.002f, 8});
    Mesh back = shapes::slab(10, 14, 0.055f, [](float u, float v) {
        const float x = u - 0.5f;
        return Vec3f{x * (0.46f - 0.12f * v * v), 0.56f + 0.58f * v,
                     -0.2f - 0.1f * v + 0.16f * x * x + 0.03f * std::sin(3.1f * v)};
    });
    k.add(std::move(back), cloth);
    k.board(dark, {0, 0.42f, -0.24f}, {0.06f, 0.34f, 0.025f}, 0.008f);
    for (const float sx : {-1.f, 1.f}) {
        k.rod(dark, {sx * 0.22f, 0.43f, 0}, {sx * 0.29f, 0.66f, 0}, 0.014f);
        k.board(dark, {sx * 0.29f, 0.655f, 0.02f}, {0.06f, 0.03f, 0.26f}, 0.012f);
    }
    k.piece.clearance_front_m = 0.4f;
}

void cushion(Kit& k) {
    const int cloth = k.main(tinted(k.style.fabric2, k.accent()));
    put_pillow(k, cloth, {0, 0, 0}, {0.45f, 0.45f, 0.17f}, 12);
    k.piece.mount = Mount::surface;
}
// One long cloth folded to and fro, lying flat: it turns over at the front and at the back, and no layer lies quite
// like the last.
void throw_blanket(Kit& k) {
    const int cloth = k.main(throw_cloth(k));
    constexpr int kLayers = 4;
    constexpr float kThick = 0.022f, kRise = 0.03f;  // of a layer; from one to the next
    const Vec3f size = k.wanted({0.5f, 0, 0.36f});
    const float straight = size.z - kRise, turn = 0.5f * kPi * kRise, lap = straight + turn,
                length = kLayers * lap - turn;
    const std::uint32_t seed = k.seed();
    const auto point = [=](float u, float v) {
        const float layer = std::min(std::floor(v * length / lap), kLayers - 1.f), along = v * length - layer * lap;
        const float way = static_cast<int>(layer) % 2 == 0 ? 1.f : -1.f,
                    bend = std::clamp((along - straight) / turn, 0.f, 1.f) * kPi;
        const float x = (u - 0.5f) * size.x * (0.98f + 0.02f * shapes::wobble({layer, 4.f, 2.f}, seed)) +
                        0.01f * shapes::wobble({layer * 3.7f, 1.f, 0.f}, seed);
        const float z = way * (std::min(along, straight) - 0.5f * straight + 0.5f * kRise * std::sin(bend));
        const float sag = 0.006f * shapes::wobble({x * 6.f, 3.f, z * 6.f}, seed + 1) +
                          0.003f * shapes::wobble({x * 19.f, layer, z * 19.f}, seed + 2);
        return Vec3f{
            x, kThick + kRise * (layer + 0.5f * (1.f - std::cos(bend))) + std::max(0.f, sag) * (0.3f + 0.25f * layer),
            z};
    };
    // From front to back, so that the sheet's outer side looks up.
    k.add(shapes::slab(20, 120, kThick, [&](float u, float v) { return point(1.f - u, v); }), cloth);
    k.piece.mount = Mount::surface;
}

constexpr Entry kSeats[] = {{"sofa", sofa},         {"loveseat", loveseat},
                            {"armchair", armchair}, {"ottoman", ottoman},
                            {"pouf", pouf},         {"chair", chair},
                            {"stool", stool},       {"bar_stool", bar_stool},
                            {"bench", bench},       {"office_chair", office_chair},
                            {"cushion", cushion},   {"throw", throw_blanket}};

}  // namespace

std::span<const Entry> seats() { return kSeats; }

}  // namespace fastscene::furniture

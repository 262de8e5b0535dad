// Lounge chair.
#include <array>
#include <cmath>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/seats/upholstery.h"

namespace fastscene::furniture {

// Shells of bent wood with buttoned cushions, on a star of metal.
void build_lounge_chair(Kit& k) {
    const int hide = k.main(k.request.material.empty() ? k.style.of(k.style.made_of.lounge_chair) : k.style.leather);
    if (k.request.color_name.empty() && !k.request.color && k.request.material.empty() && k.rng.chance(0.6f)) {
        Material& m = k.piece.materials[static_cast<std::size_t>(hide)];
        m.color_a = m.color_c = {0.04f, 0.038f, 0.036f}, m.color_b = {0.025f, 0.024f, 0.023f};
    }
    const int wood = k.material(*material_named("walnut")),
              dark = k.material(plain("black metal", {0.03f, 0.03f, 0.032f}, 0.35f)), chrome = k.material(steel());
    struct Shell {
        Vec3f low, high;     // the middle of its lower and upper edge
        float wide, hollow;  // how deep it is bent along and across
    };
    const std::array<Shell, 3> shells{Shell{{0, 0.36f, 0.36f}, {0, 0.3f, -0.25f}, 0.62f, 0.035f},
                                      Shell{{0, 0.36f, -0.25f}, {0, 0.66f, -0.42f}, 0.64f, 0.03f},
                                      Shell{{0, 0.68f, -0.43f}, {0, 0.96f, -0.56f}, 0.6f, 0.03f}};
    for (const Shell& s : shells) {
        const Vec3f along = normalize(s.high - s.low),
                    out = normalize(cross(Vec3f{1, 0, 0}, along)) *
                          (cross(Vec3f{1, 0, 0}, along).y + cross(Vec3f{1, 0, 0}, along).z > 0 ? 1.f : -1.f);
        // The sides come up around who sits there.
        const auto bend = [=](float u, float v) {
            const float across = 2 * u - 1, a4 = across * across * across * across;
            return s.low + (s.high - s.low) * v + Vec3f{0.5f * s.wide * (across - 0.1f * across * a4), 0, 0} +
                   out * (0.13f * a4 * (1.f - 0.25f * std::pow(2 * v - 1, 2.f)) - s.hollow * std::sin(kPi * v));
        };
        const bool flip = dot(cross(Vec3f{1, 0, 0}, along), out) < 0;
        k.add(shapes::slab(22, 10, 0.014f, [=](float u, float v) { return bend(flip ? 1.f - u : u, v); }), wood);
        const float far = length(s.high - s.low);
        k.add_soft(padded_body({[=](float t) {
                                    return s.low + (s.high - s.low) * (0.03f + 0.94f * t) +
                                           out * (0.052f - 0.7f * s.hollow * std::sin(kPi * t));
                                },
                                {1, 0, 0},
                                [=](float) {
                                    return Vec2f{s.wide - 0.13f, 0.1f};
                                },
                                0.045f,
                                0.002f,
                                14,
                                k.seed()}),
                   hide, kUpholsteryCrease);
        for (const float x : {-0.13f, 0.13f})
            k.add(shapes::ball(s.low + (s.high - s.low) * 0.5f + out * (0.1f - 0.7f * s.hollow) + Vec3f{x, 0, 0},
                               {0.012f, 0.01f, 0.012f}, 8),
                  hide);
        if (far < 0.5f) k.rod(dark, s.low + out * -0.03f, s.high + out * -0.03f, 0.012f, -1, 8);
    }
    for (const float sx : {-1.f, 1.f}) {
        k.soft(hide, {sx * 0.33f, 0.49f, -0.03f}, {0.085f, 0.06f, 0.34f}, {0.028f, 0.01f, 0.001f, 10});
        k.rod(dark, {sx * 0.33f, 0.5f, -0.1f}, {sx * 0.28f, 0.4f, -0.26f}, 0.012f, -1, 8);
        k.rod(dark, {sx * 0.325f, 0.5f, 0.06f}, {sx * 0.27f, 0.36f, 0.06f}, 0.012f, -1, 8);
    }
    k.rod(chrome, {0, 0.07f, 0.02f}, {0, 0.3f, 0.02f}, 0.026f, -1, 16);
    k.board(dark, {0, 0.27f, 0.02f}, {0.3f, 0.03f, 0.2f}, 0.008f);
    for (int i = 0; i < 5; ++i) {
        const float a = kTau * static_cast<float>(i) / 5.f + 0.3f, c = std::cos(a), s = std::sin(a);
        k.rod(dark, {0.02f * c, 0.075f, 0.02f + 0.02f * s}, {0.32f * c, 0.022f, 0.02f + 0.32f * s}, 0.02f, 0.012f, 10);
        k.add(shapes::ball({0.32f * c, 0.012f, 0.02f + 0.32f * s}, {0.018f, 0.012f, 0.018f}, 8), dark);
    }
    k.top(0.44f, 0, 0.12f, 0.2f, 0.16f);
    k.piece.clearance_front_m = 0.5f;
}

}  // namespace fastscene::furniture

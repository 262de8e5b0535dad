// Chaises longues.
#include <array>
#include <cmath>
#include <vector>

#include "fastscene/rooms/furniture/forms.h"
#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/openings/blind_parts.h"
#include "fastscene/rooms/furniture/seats/upholstery.h"

namespace fastscene::furniture {
namespace {

// One long pad that rises to a back, on a light frame.
void swept_chaise(Kit& k) {
    const int cloth = k.main(k.style.of(k.style.made_of.chaise_longue)),
              foot = k.material(k.style.legs == LegType::metal_frame ? k.style.metal : k.style.wood),
              second = accent_cloth(k);
    const float wide = 0.7f, under = 0.27f;
    const auto path = curve_through({{0.84f, 0.345f},
                                     {0.5f, 0.36f},
                                     {0.1f, 0.35f},
                                     {-0.24f, 0.37f},
                                     {-0.46f, 0.5f},
                                     {-0.64f, 0.69f},
                                     {-0.8f, 0.86f}},
                                    [](Vec2f p) {
                                        return Vec3f{p.x, p.y, 0};
                                    });
    k.add_soft(padded_body({path,
                            {0, 0, 1},
                            [=](float t) {
                                return Vec2f{wide, 0.16f - 0.035f * eased(0.55f, 1.f, t)};
                            },
                            0.055f,
                            0.0025f,
                            34,
                            k.seed()}),
               cloth, kUpholsteryCrease);
    // Seams across, where the cloth is drawn in.
    for (const float t : {0.3f, 0.55f, 0.78f}) {
        const Vec3f p = path(t), along = normalize(path(t + 0.01f) - path(t - 0.01f)),
                    up = cross(along, Vec3f{0, 0, 1}) * (cross(along, Vec3f{0, 0, 1}).y < 0 ? -1.f : 1.f);
        const Vec3f at = p + up * (0.078f - 0.017f * eased(0.55f, 1.f, t));
        k.rod(cloth, at + Vec3f{0, 0, -0.5f * wide + 0.05f}, at + Vec3f{0, 0, 0.5f * wide - 0.05f}, 0.0055f, -1, 8);
    }
    for (const float sz : {-1.f, 1.f}) {
        const float z = sz * (0.5f * wide - 0.07f);
        k.board(foot, {0.18f, under - 0.035f, z}, {1.2f, 0.035f, 0.035f}, 0.006f);
        k.rod(foot, {-0.42f, under - 0.02f, z}, {-0.7f, 0.69f, z}, 0.014f, -1, 10);
        for (const float x : {0.68f, -0.34f})
            k.rod(foot, {x + (x > 0 ? 0.05f : -0.07f), 0, z + sz * 0.02f}, {x, under - 0.01f, z}, 0.012f, 0.019f, 12);
    }
    for (const float x : {0.6f, -0.28f}) k.board(foot, {x, under - 0.035f, 0}, {0.035f, 0.03f, wide - 0.14f}, 0.006f);
    // A roll for the neck, a cushion.
    const Vec3f neck = path(0.93f);
    bolster(k, cloth, neck + Vec3f{0.105f, 0.1f, -0.24f}, 0.48f, 0.07f);
    put_pillow(k, second, path(0.66f) + Vec3f{0.17f, 0.075f, k.rng.uniform(-0.06f, 0.06f)}, {0.42f, 0.34f, 0.14f}, 40.f,
               90.f + k.rng.uniform(-8, 8));
    k.top(0.44f, 0.4f, 0, 0.34f, 0.26f);
}

// A scroll at the head, from which a back falls along the wall.
void scrolled_chaise(Kit& k) {
    const int cloth = k.main(k.style.fabric), foot = k.material(k.style.wood), second = accent_cloth(k);
    const bool turned = k.style.legs == LegType::turned;
    const float long_side = 1.74f, deep = 0.76f, hx = 0.5f * long_side, hz = 0.5f * deep, seat = 0.44f, leg = 0.16f;
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f}) {
            const Vec3f at{sx * (hx - 0.14f), 0, sz * (hz - 0.07f)};
            if (turned) {
                const std::array<Vec2f, 7> p{Vec2f{0.014f, 0}, {0.022f, 0.012f}, {0.016f, 0.04f},      {0.024f, 0.08f},
                                             {0.034f, 0.12f},  {0.026f, 0.14f},  {0.034f, leg + 0.01f}};
                k.add(shapes::lathe(p, 16, true), foot, at);
            } else {
                k.rod(foot, at + Vec3f{sx * 0.02f, 0, sz * 0.01f}, at + Vec3f{0, leg + 0.01f, 0}, 0.014f, 0.026f, 12);
            }
        }
    k.board(foot, {0.02f, leg - 0.02f, 0}, {long_side - 0.2f, 0.05f, deep - 0.05f}, 0.012f);
    k.soft(cloth, {0.02f, leg + 0.025f, 0}, {long_side - 0.14f, seat - leg - 0.16f, deep - 0.02f},
           {0.03f, 0.008f, 0.001f, 12});
    k.soft(cloth, {0.07f, seat - 0.155f, 0.05f}, {long_side - 0.3f, 0.18f, deep - 0.1f}, {0.06f, 0.03f, 0.003f, 20});
    // The head: it leans out and rolls over.
    const auto head = curve_through(
        {{-hx + 0.24f, leg + 0.06f}, {-hx + 0.2f, 0.4f}, {-hx + 0.16f, 0.62f}, {-hx + 0.08f, 0.78f}}, [](Vec2f p) {
            return Vec3f{p.x, p.y, 0};
        });
    k.add_soft(padded_body({head,
                            {0, 0, 1},
                            [=](float) {
                                return Vec2f{deep - 0.03f, 0.13f};
                            },
                            0.05f,
                            0.001f,
                            14,
                            k.seed()}),
               cloth, kUpholsteryCrease);
    bolster(k, cloth, {-hx + 0.085f, 0.77f, -hz + 0.01f}, deep - 0.02f, 0.092f);
    for (const float sz : {-1.f, 1.f})
        k.add(shapes::ball({-hx + 0.085f, 0.77f, sz * (hz - 0.012f)}, {0.03f, 0.03f, 0.012f}, 12), foot);
    // The back falls in a wave towards the feet.
    const float from = -hx + 0.12f, to = 0.44f;
    const auto crest = [=](float t) { return 0.8f - 0.36f * eased(0.1f, 1.f, t) + 0.02f * std::sin(kTau * t); };
    k.add_soft(padded_body({[=](float t) {
                                return Vec3f{from + (to - from) * t, 0.5f * (crest(t) + leg + 0.06f), -hz + 0.075f};
                            },
                            {0, 0, 1},
                            [=](float t) {
                                return Vec2f{0.13f, crest(t) - leg - 0.06f};
                            },
                            0.05f,
                            0.001f,
                            22,
                            k.seed()}),
               cloth, kUpholsteryCrease);
    std::vector<Vec3f> rim;
    for (int i = 0; i <= 20; ++i) {
        const float t = 0.04f + 0.93f * static_cast<float>(i) / 20.f;
        rim.push_back({from + (to - from) * t, crest(t) - 0.004f, -hz + 0.075f});
    }
    k.add(shapes::tube(rim, 0.017f, 8), foot);
    bolster(k, cloth, {-hx + 0.35f, seat + 0.11f, -0.24f}, 0.5f, 0.09f);
    put_pillow(k, second, {-hx + 0.56f, seat + 0.02f, -0.05f}, {0.42f, 0.36f, 0.14f}, 34.f, 84.f);
    k.top(seat + 0.03f, 0.26f, 0.06f, 0.4f, 0.24f);
}

}  // namespace

void build_chaise_longue(Kit& k) {
    if (form_for(k, k.style.forms.chaise_longue) == ChaiseForm::scrolled) scrolled_chaise(k);
    else swept_chaise(k);
    k.piece.clearance_front_m = 0.5f;
    k.piece.against_wall = true;
}

}  // namespace fastscene::furniture

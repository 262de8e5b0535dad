// Rugs: woven ones and hides.
#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {
namespace {

// A hide: the outline of what wore it, with its own color; a cow's has blots.
void hide_rug(Kit& k) {
    const bool cow = k.request.pattern == "cowhide";
    const Vec3f s = k.wanted(cow ? Vec3f{2.f, 0.01f, 1.75f} : Vec3f{1.5f, 0.02f, 1.05f});
    Material m = *material_named("carpet");
    m.name = cow ? "cowhide" : "fur";
    m.color_a = cow ? Vec3f{0.7f, 0.66f, 0.58f} : Vec3f{0.66f, 0.6f, 0.5f};
    m.color_b = m.color_a * 0.7f;
    m.bump_m = cow ? 0.002f : 0.01f;
    const auto color = k.request.color_name.empty() ? std::nullopt : color_named(k.request.color_name);
    if (color && !cow) m.color_a = *color, m.color_b = *color * 0.6f;
    if (cow) {
        m.pattern = Pattern::camouflage, m.scale_m = 0.75f, m.seed = k.seed();
        m.color_b = color.value_or(k.rng.chance(0.5f) ? Vec3f{0.19f, 0.085f, 0.04f} : Vec3f{0.035f, 0.03f, 0.027f}),
        m.color_c = m.color_a;
    }
    const int fur = k.piece.main_material = k.material(m);
    // Half of it, from the neck (z < 0) to the tail: the rest is its mirror image.
    static constexpr std::array<Vec2f, 13> kHalf{{{0.f, -0.5f},
                                                  {0.13f, -0.49f},
                                                  {0.2f, -0.4f},
                                                  {0.36f, -0.43f},
                                                  {0.5f, -0.38f},
                                                  {0.47f, -0.29f},
                                                  {0.36f, -0.2f},
                                                  {0.335f, 0.f},
                                                  {0.37f, 0.18f},
                                                  {0.5f, 0.29f},
                                                  {0.47f, 0.4f},
                                                  {0.27f, 0.4f},
                                                  {0.f, 0.5f}}};
    std::vector<Vec2f> ring;
    for (const Vec2f& p : kHalf) ring.push_back({p.x, p.y});
    for (std::size_t i = kHalf.size() - 1; i-- > 1;) ring.push_back({-kHalf[i].x, kHalf[i].y});
    std::vector<Vec2f> closed{ring.back()};
    closed.insert(closed.end(), ring.begin(), ring.end());
    closed.push_back(ring[0]), closed.push_back(ring[1]);
    const std::uint32_t seed = k.seed();
    std::vector<Vec2f> outline;
    const std::vector<Vec2f> smooth = shapes::curve(closed, 6);
    for (std::size_t i = 6; i + 12 < smooth.size() + 5; ++i) outline.push_back(smooth[i]);
    // The long side of the rug's box is its spine.
    const auto place = [&](Vec2f p, float x, float z) {
        const float n = 1.f + 0.025f * shapes::wobble({7 * p.x, 7 * p.y, 0}, seed);
        return Vec2f{x * p.y * n, z * p.x * n};
    };
    std::vector<Vec2f> rim;
    for (const Vec2f& p : outline) rim.push_back(place(p, s.x, s.z));
    Mesh hide = shapes::prism(rim, 0.f, s.y, 0.002f);
    for (std::size_t i = 0; i < hide.coords.size(); ++i) hide.coords[i] = {hide.positions[i].x, hide.positions[i].z, 0};
    k.add(std::move(hide), fur);
}

}  // namespace

void build_rug(Kit& k) {
    if (k.request.pattern == "cowhide" || k.request.pattern == "hide") return hide_rug(k);
    const Vec3f s = k.wanted({2.3f, 0.012f, 1.6f});
    Material m = k.style.rug;
    // The seed picks what is woven: lozenges, medallions, bands of zigzag (see Pattern::rug). The fourth, large blots,
    // looks like a hide and is left out.
    static constexpr std::array<std::uint32_t, 12> kWoven{8, 9, 19, 20, 4, 6, 7, 11, 2, 3, 5, 10};
    const int first = k.style.rug_weave == RugWeave::medallions ? 4
                      : k.style.rug_weave == RugWeave::zigzag   ? 8
                                                                : 0,
              range = first == 0 ? 12 : 4;
    m.seed = kWoven[static_cast<std::size_t>(first + static_cast<int>(k.seed() % static_cast<std::uint32_t>(range)))];
    // Round as asked, or where nothing else is, in some rooms that like it.
    const bool round = k.request.pattern == "round" ||
                       (!k.request.size_m.x && k.style.round_rugs && k.rng.chance(0.4f));
    const float d = std::min(s.x, s.z) * (k.request.size_m.x ? 1.f : 1.15f);
    m.scale_m = m.pattern == Pattern::rug ? 0.5f * (round ? d : s.x) : m.scale_m;
    // Who asks for wool or a fluffy rug means deep pile of one color.
    if (k.request.material == "wool" && (k.request.pattern.empty() || round)) {
        m = *material_named("carpet");
        m.name = "deep pile";
        m.color_a = *color_named("ivory");
        m.color_b = *color_named("linen");
        m.bump_m = 0.008f;
        if (k.request.color) m = tinted(m, *k.request.color);
        else if (const auto color = color_named(k.request.color_name); color && !k.request.color_name.empty())
            m = tinted(m, *color);
    }
    const bool plain_pile = m.name == "deep pile";
    const int pile = plain_pile ? k.piece.main_material = k.material(m) : k.main(m);
    Mesh r = round ? shapes::prism(shapes::circle(0.5f * d, 48), 0.f, 0.012f, 0.004f)
                   : shapes::prism(shapes::rounded_rectangle(s.x, s.z, 0.03f, 3), 0.f, 0.012f, 0.004f);
    // Metres from the rug's middle; y carries half its depth (negative: it is round), which the border follows.
    for (std::size_t i = 0; i < r.coords.size(); ++i)
        r.coords[i] = {r.positions[i].x, round ? -0.5f * d : 0.5f * s.z, r.positions[i].z};
    k.add(std::move(r), pile);
    if (!round && !plain_pile && (k.style.lamp == LampFamily::paper || k.style.mouldings == Mouldings::rich)) {
        Mesh fringe;
        const int count = static_cast<int>(s.z / 0.035f);
        for (int i = 0; i < count; ++i)
            for (const float sx : {-1.f, 1.f}) {
                const float z = (static_cast<float>(i) + 0.5f) / static_cast<float>(count) * s.z - 0.5f * s.z;
                Mesh f = shapes::box({0.06f, 0.004f, 0.008f}, 0.001f);
                shapes::append(fringe, shapes::move(f, {sx * (0.5f * s.x + 0.025f), 0.002f, z}));
            }
        k.add(std::move(fringe), k.material(plain("fringe", {0.66f, 0.6f, 0.48f}, 0.95f)));
    }
}

}  // namespace fastscene::furniture

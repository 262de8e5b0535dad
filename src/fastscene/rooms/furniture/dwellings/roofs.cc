// Roofs and vaults that hang below the ceiling over a whole room or a bay of it: timber, canvas, snow, rock, steel.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"
#include "fastscene/rooms/plan.h"

namespace fastscene::furniture {
namespace {

// Where the roof of a round room meets its wall; a hair inside it.
std::vector<Vec2f> eaves_of(Vec3f s, float inset = 0.01f) {
    std::vector<Vec2f> out = round_outline({s.x, s.z});
    for (Vec2f& p : out) p = p * (1.f - inset / length(p));
    return out;
}
// How far from there to the middle a point is, 0 to 1.
float inside(const std::vector<Vec2f>& eaves, Vec2f p) {
    const float far = length(p);
    return far > 0 ? std::max(0.f, 1.f - far / reach_of(eaves, p * (1.f / far))) : 1.f;
}
// Its underside rises from the eaves, where it is -s.y, to the top by `rise`, of 0 there and 1 in the middle.
template <class Rise>
Mesh round_roof(Vec3f s, int rings, const Rise& rise, float rough = 0, std::uint32_t seed = 0) {
    constexpr float kThick = 0.01f;
    std::vector<Vec2f> eaves = eaves_of(s);
    eaves.push_back(eaves.front());
    const int around = static_cast<int>(eaves.size()) - 1;
    return shapes::sheet(around, rings, [&](float u, float v) {
        const Vec2f foot = eaves[static_cast<std::size_t>(std::lround(u * static_cast<float>(around)))];
        Vec3f p{foot.x * v, -s.y + (s.y - kThick) * rise(1 - v), foot.y * v};
        if (rough > 0) {
            const float n = 0.7f * shapes::wobble(p * 1.4f, seed) + 0.3f * shapes::wobble(p * 4.f, seed + 1);
            p.y = std::clamp(p.y + rough * n * std::min(1.f, 6.f * (1 - v)), -s.y, -kThick);
        }
        return p;
    });
}
// Over a square with rounded corners, level outside it.
constexpr float kSquareness = 3.2f;  // 2: a circle
float inside_square(float a, float b) {
    const float d = std::pow(std::pow(std::fabs(a), kSquareness) + std::pow(std::fabs(b), kSquareness),
                             1.f / kSquareness);
    return std::max(0.f, 1.f - d);
}
float dome(float in) { return std::sqrt(std::max(0.f, 1.f - (1.f - in) * (1.f - in))); }

// Courses that run around: the pattern's x follows the angle, its y the way from the edge to the top.
void lay_around(Mesh& m, Vec3f s) {
    for (std::size_t i = 0; i < m.coords.size(); ++i) {
        const Vec3f p = m.positions[i];
        m.coords[i] = {std::atan2(p.z, p.x) * 0.3f * (s.x + s.z), 0.5f * std::min(s.x, s.z) - std::hypot(p.x, p.z), 0};
    }
}

// Both slopes of a roof whose ridge runs along z, boards along it.
void slopes(Kit& k, Vec3f s, int boards) {
    constexpr float kThick = 0.01f;
    for (const float side : {-1.f, 1.f}) {
        Mesh m = shapes::sheet(1, 1, [&](float u, float v) {
            const float t = side > 0 ? v : 1 - v;
            return Vec3f{side * s.x / 2 * (1 - t), -s.y + (s.y - kThick) * t, s.z * (u - 0.5f)};
        });
        k.add(std::move(m), boards);
    }
}

// Trusses: tie beam, rafters, king post, struts; purlins from truss to truss.
void trusses(Kit& k, Vec3f s, int timber, float every_m, bool round_timber) {
    const float r = round_timber ? 0.085f : 0.075f;
    const auto beam = [&](Vec3f a, Vec3f b, float radius) {
        if (round_timber) k.rod(timber, a, b, radius, -1, 12);
        else k.rod(timber, a, b, 1.25f * radius, -1, 4);
    };
    const int count = std::max(2, static_cast<int>(std::lround(s.z / every_m)));
    const float low = -s.y + 1.3f * r, rise = s.y - 2.8f * r;
    for (int i = 0; i < count; ++i) {
        const float z = s.z * ((static_cast<float>(i) + 0.5f) / static_cast<float>(count) - 0.5f), hx = s.x / 2 - r;
        beam({-hx, low, z}, {hx, low, z}, r);
        beam({0, low, z}, {0, low + rise, z}, 0.9f * r);
        for (const float side : {-1.f, 1.f}) {
            beam({side * (hx - 0.05f), low + 0.02f, z}, {0, low + rise, z}, 0.9f * r);
            beam({0, low + 0.1f * rise, z}, {side * 0.46f * hx, low + 0.5f * rise, z}, 0.65f * r);
        }
    }
    for (const float t : {0.33f, 0.68f})
        for (const float side : {-1.f, 1.f})
            k.rod(timber, {side * (s.x / 2) * (1 - t), -s.y + s.y * t - 0.09f, -s.z / 2},
                  {side * (s.x / 2) * (1 - t), -s.y + s.y * t - 0.09f, s.z / 2}, 0.06f, -1, round_timber ? 10 : 4);
    k.rod(timber, {0, -0.11f, -s.z / 2}, {0, -0.11f, s.z / 2}, 0.08f, -1, round_timber ? 10 : 4);
}

Material old_timber(Vec3f a, Vec3f b, float scale) {
    Material m = plain("old timber", a, 0.75f);
    m.pattern = Pattern::wood, m.color_b = b, m.color_c = a * 0.8f, m.scale_m = scale, m.bump_m = 0.002f;
    return m;
}

}  // namespace

// Of a log cabin: boards over trusses of round timber, with a lantern that hangs from one.
void build_log_roof(Kit& k) {
    const Vec3f s = k.wanted({4.5f, 1.3f, 5.5f});
    Material boards = k.style.wood;
    boards.pattern = Pattern::planks, boards.scale_m = 0.14f, boards.bump_m = 0.002f;
    const int deck = k.main(tinted(boards, {0.36f, 0.2f, 0.09f})),
              log = k.material(old_timber({0.3f, 0.16f, 0.07f}, {0.19f, 0.095f, 0.04f}, 0.06f)),
              iron = k.material(*material_named("iron")), lamp = k.material(glow("lantern", {11, 7.2f, 3.2f}));
    slopes(k, s, deck);
    trusses(k, s, log, 1.7f, true);
    const int count = std::max(2, static_cast<int>(std::lround(s.z / 1.7f)));
    for (int i = 0; i < count; i += 2) {
        const float z = s.z * ((static_cast<float>(i) + 0.5f) / static_cast<float>(count) - 0.5f), y = -s.y + 0.02f;
        for (const float x : {-0.9f, 0.9f}) {
            k.add(shapes::ball({x, y + 0.31f, z}, {0.06f, 0.08f, 0.06f}, 14), lamp);
            k.rod(iron, {x, y + 0.38f, z}, {x, y + 0.5f, z}, 0.008f, -1, 6);
            k.add(shapes::ring(0.07f, 0.014f, 16), iron, {x, y + 0.25f, z});
            k.add(shapes::ring(0.07f, 0.014f, 16), iron, {x, y + 0.37f, z});
        }
    }
    k.piece.mount = Mount::ceiling;
}

// Of a barn: weathered boards over sawn trusses.
void build_barn_roof(Kit& k) {
    const Vec3f s = k.wanted({7, 2.2f, 9});
    Material boards = plain("weathered boards", {0.2f, 0.15f, 0.1f}, 0.9f);
    boards.pattern = Pattern::planks, boards.color_b = {0.13f, 0.095f, 0.06f}, boards.color_c = {0.17f, 0.12f, 0.08f},
    boards.scale_m = 0.2f, boards.bump_m = 0.003f;
    const int deck = k.main(boards), beam = k.material(old_timber({0.24f, 0.15f, 0.08f}, {0.15f, 0.09f, 0.05f}, 0.06f)),
              iron = k.material(*material_named("iron")), lamp = k.material(glow("barn lamp", {15, 11, 6.5f}));
    slopes(k, s, deck);
    trusses(k, s, beam, 2.4f, false);
    const int count = std::max(2, static_cast<int>(std::lround(s.z / 2.4f)));
    for (int i = 0; i < count; ++i) {
        const float z = s.z * ((static_cast<float>(i) + 0.5f) / static_cast<float>(count) - 0.5f), y = -s.y;
        const std::array<Vec2f, 4> shade{Vec2f{0.2f, 0.0f}, {0.17f, 0.06f}, {0.05f, 0.12f}, {0.03f, 0.16f}};
        k.add(shapes::shade(shade, 20), iron, {0, y + 0.2f, z + 0.5f});
        k.rod(iron, {0, y + 0.36f, z + 0.5f}, {0, -0.15f, z + 0.5f}, 0.006f, -1, 6);
        k.add(shapes::ball({0, y + 0.24f, z + 0.5f}, {0.05f, 0.05f, 0.05f}, 12), lamp);
    }
    k.piece.mount = Mount::ceiling;
}

// Of a yurt: painted poles from the wall to a crown ring that lets the light in, felt above.
void build_yurt_roof(Kit& k) {
    const Vec3f s = k.wanted({5, 1.5f, 5});
    const int felt = k.main(plain("felt", {0.62f, 0.56f, 0.45f}, 0.95f)),
              pole = color(k, "painted pole", {0.42f, 0.1f, 0.03f}, 0.4f),
              ring = color(k, "crown ring", {0.34f, 0.07f, 0.03f}, 0.4f),
              blue = color(k, "blue paint", {0.05f, 0.16f, 0.35f}, 0.4f),
              sky = k.material(lit("sky", {5.5f, 6.0f, 6.8f}));
    constexpr float kCrown = 0.72f;  // radius
    const float outer = std::min(s.x, s.z) / 2, top = 1.f - kCrown / outer;
    k.add(round_roof(s, 16, [&](float in) { return std::min(1.f, in / top); }), felt);
    const std::vector<Vec2f> eaves = eaves_of(s, 0.05f);
    constexpr int kPoles = 56;
    for (int i = 0; i < kPoles; ++i) {
        const float a = kTau * (static_cast<float>(i) + 0.5f) / kPoles;
        const Vec3f out = around(a);
        const float reach = reach_of(eaves, {out.x, out.z});
        const Vec3f foot{out.x * reach, -s.y + 0.005f, out.z * reach};
        k.rod(pole, foot, {out.x * kCrown, -0.1f, out.z * kCrown}, 0.02f, 0.016f, 6);
    }
    k.add(shapes::ring(kCrown, 0.1f, 40), ring, {0, -0.1f, 0});
    k.add(shapes::ring(kCrown - 0.1f, 0.03f, 40), blue, {0, -0.15f, 0});
    k.add(shapes::prism(shapes::circle(kCrown - 0.04f, 40), -0.045f, -0.04f, 0.001f), sky);
    for (int i = 0; i < 4; ++i) {
        const Vec3f out = around(kTau * static_cast<float>(i) / 8);
        for (const float off : {-0.1f, 0.1f}) {
            const Vec3f aside{-out.z * off, 0, out.x * off};
            k.rod(pole, out * kCrown + aside + Vec3f{0, -0.09f, 0}, out * -kCrown + aside + Vec3f{0, -0.09f, 0}, 0.016f,
                  -1, 6);
        }
    }
    k.piece.mount = Mount::ceiling;
}

// Of an igloo: courses of snow blocks, through which some light comes.
void build_snow_dome(Kit& k) {
    const Vec3f s = k.wanted({4.4f, 1.4f, 4.4f});
    const int snow = k.main(k.style.wall), lamp = k.material(lit("daylight", {6.2f, 7.2f, 8.4f}));
    Mesh m = round_roof(s, 24, dome, 0.02f, k.seed());
    lay_around(m, s);
    k.add(std::move(m), snow);
    k.add(shapes::prism(shapes::circle(0.3f, 28), -0.045f, -0.04f, 0.001f), lamp);
    k.add(shapes::ring(0.31f, 0.09f, 28), snow, {0, -0.05f, 0});
    k.piece.mount = Mount::ceiling;
}

// Of a cave: rock that comes down between hollows, with stalactites.
void build_rock_vault(Kit& k) {
    const Vec3f s = k.wanted({5, 1.2f, 6});
    const int rock = k.main(k.style.wall);
    constexpr int kCells = 72;
    constexpr float kThick = 0.01f;
    const std::uint32_t seed = k.seed();
    k.add(shapes::sheet(kCells, kCells,
                        [&](float u, float v) {
                            const float a = 2 * u - 1, b = 1 - 2 * v, in = inside_square(a, b);
                            Vec3f p{a * s.x / 2, -s.y, b * s.z / 2};
                            p.y += (s.y - kThick) * std::min(1.f, 1.15f * dome(std::min(1.f, 1.6f * in)));
                            const float n = 0.7f * shapes::wobble(p * 1.4f, seed) +
                                            0.3f * shapes::wobble(p * 4.f, seed + 1);
                            p.y = std::clamp(p.y + 0.42f * s.y * n * std::min(1.f, 6.f * in), -s.y, -kThick);
                            return p;
                        }),
          rock);
    const int spikes = static_cast<int>(1.1f * s.x * s.z);
    for (int i = 0; i < spikes; ++i) {
        const float a = k.rng.uniform(-0.88f, 0.88f), b = k.rng.uniform(-0.88f, 0.88f), in = inside_square(a, b);
        if (in < 0.1f) continue;
        const float root = -0.02f, tip = -s.y + k.rng.uniform(0.05f, 0.55f) * s.y, r = k.rng.uniform(0.05f, 0.12f);
        const Vec3f at{a * s.x / 2, 0, b * s.z / 2};
        k.rod(rock, at + Vec3f{0, root, 0}, at + Vec3f{0, tip, 0}, r, 0.008f, 8);
    }
    k.piece.mount = Mount::ceiling;
}

// Of a round tower: a cone of boards on rafters that meet at a post.
void build_tower_roof(Kit& k) {
    const Vec3f s = k.wanted({5, 2, 5});
    Material boards = plain("roof boards", {0.17f, 0.095f, 0.045f}, 0.8f);
    boards.pattern = Pattern::planks, boards.color_b = {0.1f, 0.055f, 0.03f}, boards.scale_m = 0.16f;
    const int deck = k.main(boards), beam = k.material(old_timber({0.2f, 0.11f, 0.05f}, {0.12f, 0.065f, 0.03f}, 0.05f)),
              gold = k.material(*material_named("brass"));
    Mesh cone = round_roof(s, 12, [](float in) { return in; });
    lay_around(cone, s);
    k.add(std::move(cone), deck);
    const std::vector<Vec2f> eaves = eaves_of(s, 0.1f);
    constexpr int kRafters = 12;
    for (int i = 0; i < kRafters; ++i) {
        const Vec3f out = around(kTau * static_cast<float>(i) / kRafters);
        const float reach = reach_of(eaves, {out.x, out.z});
        k.rod(beam, {out.x * reach, -s.y + 0.08f, out.z * reach}, {out.x * 0.1f, -0.14f, out.z * 0.1f}, 0.065f, 0.05f,
              8);
    }
    // Planets that hang on threads.
    k.rod(beam, {0, -0.5f, 0}, {0, -0.02f, 0}, 0.11f, -1, 10);
    for (int i = 0; i < 6; ++i) {
        const Vec3f out = around(kTau * static_cast<float>(i) / 6 + 0.3f) * (0.35f + 0.12f * static_cast<float>(i % 3));
        const float y = -s.y + 0.12f + 0.14f * static_cast<float>(i % 4),
                    r = 0.05f + 0.018f * static_cast<float>(i % 3);
        k.rod(gold, {out.x, y + r, out.z}, {0.3f * out.x, -0.35f, 0.3f * out.z}, 0.002f, -1, 4);
        k.add(shapes::ball({out.x, y + r, out.z}, {r, r, r}, 14),
              i % 2 == 0 ? gold : color(k, "planet", k.accent(), 0.4f));
    }
    k.piece.mount = Mount::ceiling;
}

// A dome with points of light: of a planetarium, and of a bath with star-shaped openings.
void build_star_dome(Kit& k) {
    const Vec3f s = k.wanted({8, 1.8f, 8});
    const int shell = k.main(plain("dark dome", {0.012f, 0.016f, 0.04f}, 0.8f)),
              star = k.material(lit("star", {7, 7.5f, 9})), band = k.material(lit("horizon glow", {0.35f, 0.5f, 1.5f}));
    k.add(round_roof(s, 24, dome), shell);
    const std::vector<Vec2f> eaves = eaves_of(s, 0.06f);
    constexpr int kStars = 420;
    for (int i = 0; i < kStars; ++i) {
        // Half of them lie along a band, as the Milky Way does.
        const float a = k.rng.uniform(-0.94f, 0.94f);
        const float b = i % 2 == 0 ? k.rng.uniform(-0.94f, 0.94f)
                                   : 0.45f * a + 0.12f * (k.rng.uniform(-1, 1) + k.rng.uniform(-1, 1));
        const float in = inside(eaves, {a * s.x / 2, b * s.z / 2});
        if (in < 0.04f) continue;
        const float r = k.rng.chance(0.08f) ? 0.022f : k.rng.uniform(0.005f, 0.012f);
        block(k, star, {a * s.x / 2, -s.y + (s.y - 0.01f) * dome(in) - 1.4f * r - 0.01f, b * s.z / 2}, {r, r, r});
    }
    std::vector<Vec3f> rim;
    constexpr int kRim = 64;
    for (int i = 0; i <= kRim; ++i) {
        const Vec3f out = around(kTau * static_cast<float>(i) / kRim);
        const float reach = reach_of(eaves, {out.x, out.z});
        rim.push_back({out.x * reach, -s.y + 0.06f, out.z * reach});
    }
    k.add(shapes::tube(rim, 0.02f, 6), band);
    k.piece.mount = Mount::ceiling;
}

// A pressure hull from within: a steel barrel with frames, pipes, cables and lamps in cages.
void build_hull_vault(Kit& k) {
    const Vec3f s = k.wanted({3.2f, 0.7f, 8});
    const int steel_plate = k.main(plain("hull paint", {0.3f, 0.34f, 0.31f}, 0.45f)),
              frame = color(k, "hull frame", {0.2f, 0.235f, 0.215f}, 0.45f),
              pipe = color(k, "pipe", {0.42f, 0.4f, 0.33f}, 0.4f),
              red = color(k, "red pipe", {0.45f, 0.05f, 0.03f}, 0.4f), copper = k.material(*material_named("copper")),
              brass = k.material(*material_named("brass")), lamp = k.material(glow("bulkhead lamp", {16, 14, 10}));
    const float hx = s.x / 2, high = s.y - 0.01f;
    const auto at = [&](float a, float inset) {  // a from -1 to 1 across
        return Vec3f{a * (hx - inset), -s.y + (high - inset) * std::sqrt(std::max(0.f, 1 - a * a)), 0};
    };
    k.add(shapes::sheet(30, 2,
                        [&](float u, float v) {
                            return at(-std::cos(kPi * u), 0) + Vec3f{0, 0, s.z * (0.5f - v)};
                        }),
          steel_plate);
    const int frames = std::max(2, static_cast<int>(std::lround(s.z / 0.9f)));
    for (int i = 0; i <= frames; ++i) {
        const float z = (s.z - 0.08f) * (static_cast<float>(i) / static_cast<float>(frames) - 0.5f);
        std::vector<Vec3f> path;
        for (int j = 0; j <= 24; ++j)
            path.push_back(at(-std::cos(kPi * static_cast<float>(j) / 24), 0.06f) + Vec3f{0, 0, z});
        k.add(shapes::tube(path, 0.035f, 6), frame);
        if (i == frames) continue;
        const float mid = z + s.z / static_cast<float>(frames) / 2;
        if (i % 2 == 0) {
            k.add(shapes::ball(at(0, 0.07f) + Vec3f{0, 0, mid}, {0.1f, 0.06f, 0.07f}, 14), lamp);
            for (const float off : {-0.07f, 0.f, 0.07f})
                k.add(shapes::ring(0.09f, 0.008f, 16), brass, at(0, 0.06f) + Vec3f{0, -0.02f, mid + 0.3f * off});
        }
    }
    int n = 0;
    for (const auto& [a, r, material] : {std::tuple{-0.72f, 0.035f, pipe},
                                         {-0.6f, 0.022f, copper},
                                         {-0.5f, 0.022f, red},
                                         {-0.42f, 0.014f, pipe},
                                         {0.38f, 0.05f, pipe},
                                         {0.55f, 0.022f, copper},
                                         {0.66f, 0.03f, red},
                                         {0.78f, 0.022f, pipe}}) {
        const Vec3f p = at(a, 0.13f);
        k.rod(material, p + Vec3f{0, 0, -s.z / 2 + 0.02f}, p + Vec3f{0, 0, s.z / 2 - 0.02f}, r, -1, 10);
        for (float z = -s.z / 2 + 0.5f + 0.2f * static_cast<float>(n % 3); z < s.z / 2 - 0.1f; z += 1.4f)
            k.rod(brass, p + Vec3f{0, 0, z}, p + Vec3f{0, 0, z + 0.05f}, 1.35f * r, -1, 12);
        ++n;
    }
    k.piece.mount = Mount::ceiling;
}

// Of a spaceship: slanting panels with seams, strips of light along their edges.
void build_space_vault(Kit& k) {
    const Vec3f s = k.wanted({4, 0.6f, 6});
    const int panel = k.main(plain("hull panel", {0.5f, 0.52f, 0.54f}, 0.35f)),
              rib = color(k, "rib", {0.07f, 0.075f, 0.085f}, 0.4f),
              strip = k.material(lit("light strip", {5.2f, 6.4f, 7.6f})),
              cool = k.material(lit("edge light", {0.3f, 1.1f, 3.2f}));
    const float hx = s.x / 2, flat = 0.5f * hx, top = -0.012f;
    for (const float side : {-1.f, 1.f})
        k.add(shapes::sheet(1, 1,
                            [&](float u, float v) {
                                const float t = side > 0 ? v : 1 - v;
                                return Vec3f{side * std::lerp(hx, flat, t), std::lerp(-s.y, top, t), s.z * (u - 0.5f)};
                            }),
              panel);
    k.add(shapes::sheet(1, 1,
                        [&](float u, float v) {
                            return Vec3f{flat * (2 * u - 1), top, s.z * (0.5f - v)};
                        }),
          panel);
    const int ribs = std::max(2, static_cast<int>(std::lround(s.z / 1.1f)));
    for (int i = 0; i <= ribs; ++i) {
        const float z = (s.z - 0.12f) * (static_cast<float>(i) / static_cast<float>(ribs) - 0.5f);
        for (const float side : {-1.f, 1.f}) {
            slat(k, rib, {side * (hx - 0.02f), -s.y + 0.05f, z}, {side * flat, top - 0.05f, z}, 0.1f, 0.1f);
            if (i == ribs) continue;
            // A panel of its own in each bay, with an access plate.
            const float mid = z + 0.5f * s.z / static_cast<float>(ribs);
            slat(k, rib, {side * (0.78f * hx), -0.62f * s.y, mid}, {side * (0.7f * hx), -0.46f * s.y, mid}, 0.3f,
                 0.02f);
        }
        k.board(rib, {0, top - 0.06f, z}, {2 * flat, 0.05f, 0.1f}, 0.01f);
    }
    for (const float side : {-1.f, 1.f}) {
        k.board(strip, {side * (flat - 0.12f), top - 0.03f, 0}, {0.14f, 0.02f, s.z - 0.1f}, 0.003f);
        k.board(cool, {side * (hx - 0.05f), -s.y, 0}, {0.04f, 0.03f, s.z - 0.04f}, 0.004f);
    }
    k.board(rib, {0, top - 0.05f, 0}, {0.5f * flat, 0.04f, s.z - 0.08f}, 0.01f);
    k.piece.mount = Mount::ceiling;
}

}  // namespace fastscene::furniture

// Seats of a form of their own, whatever the style: chaise longue, bean bag, hanging chair, lounge chair of shells,
// butterfly and garden chair, throne.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "fastscene/rooms/furniture_forms.h"

namespace fastscene::furniture {
namespace {

float eased(float from, float to, float x) {
    const float t = std::clamp((x - from) / (to - from), 0.f, 1.f);
    return t * t * (3 - 2 * t);
}

// Where a padded body's middle runs, and how wide (along `across`) and thick (across both) it is there.
struct Padding {
    std::function<Vec3f(float)> path;  // t in [0, 1]
    Vec3f across;
    std::function<Vec2f(float)> section;  // metres: width, thickness
    float round_m = 0.05f, wrinkle_m = 0.002f;
    int steps = 28;
    std::uint32_t seed = 0;
};

// A body of upholstery along a curve, with rounded edges and ends.
Mesh padded_body(const Padding& how) {
    // Rings close together where the ends are rounded.
    std::vector<float> at;
    const float length_m = [&] {
        float sum = 0;
        for (int i = 0; i < 40; ++i)
            sum += length(how.path(static_cast<float>(i + 1) / 40.f) - how.path(static_cast<float>(i) / 40.f));
        return sum;
    }();
    const float cap = std::min(0.3f, how.round_m / length_m);
    constexpr int kCap = 4;
    for (int i = 0; i < kCap; ++i) at.push_back(cap * (1.f - std::cos(0.5f * kPi * static_cast<float>(i) / kCap)));
    for (int i = 0; i <= how.steps; ++i)
        at.push_back(cap + (1.f - 2.f * cap) * static_cast<float>(i) / static_cast<float>(how.steps));
    for (int i = kCap - 1; i >= 0; --i) at.push_back(1.f - at[static_cast<std::size_t>(i)]);
    Mesh m;
    std::vector<std::uint32_t> rings;
    std::size_t sides = 0;
    for (const float t : at) {
        const Vec3f middle = how.path(t),
                    along = normalize(how.path(std::min(1.f, t + 0.01f)) - how.path(std::max(0.f, t - 0.01f))),
                    up = normalize(cross(along, how.across));
        const float from_end = std::min(t, 1.f - t) / cap,
                    in = from_end >= 1.f
                             ? 0.f
                             : how.round_m *
                                   (1.f - std::sqrt(std::max(0.f, 1.f - (1.f - from_end) * (1.f - from_end))));
        const Vec2f s = how.section(t);
        const float wide = std::max(0.02f, s.x - 2 * in), thick = std::max(0.012f, s.y - 2 * in);
        std::vector<Vec2f> outline = shapes::rounded_rectangle(wide, thick, std::min(how.round_m, 0.48f * thick), 4);
        // The long sides need points between their corners.
        std::vector<Vec2f> ring;
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const Vec2f a = outline[i], b = outline[(i + 1) % outline.size()];
            ring.push_back(a);
            if (i % 5 == 4 && (i / 5) % 2 == 0)
                for (int j = 1; j < 6; ++j) ring.push_back(a + (b - a) * (static_cast<float>(j) / 6.f));
        }
        sides = ring.size();
        rings.push_back(static_cast<std::uint32_t>(m.positions.size()));
        for (const Vec2f q : ring) {
            const Vec3f p = middle + how.across * q.x + up * q.y;
            const float fold = shapes::wobble(p * 15.f, how.seed) + 0.5f * shapes::wobble(p * 34.f, how.seed + 7);
            m.positions.push_back(p + up * ((q.y > 0 ? 1.f : -1.f) * how.wrinkle_m * fold));
        }
    }
    const auto n = static_cast<std::uint32_t>(sides);
    for (std::size_t r = 0; r + 1 < rings.size(); ++r)
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t j = (i + 1) % n, a = rings[r], b = rings[r + 1];
            m.triangles.insert(m.triangles.end(), {a + i, b + i, b + j, a + i, b + j, a + j});
        }
    for (const bool end : {false, true}) {
        const std::uint32_t ring = end ? rings.back() : rings.front(),
                            hub = static_cast<std::uint32_t>(m.positions.size());
        m.positions.push_back(how.path(end ? 1.f : 0.f));
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t j = (i + 1) % n;
            if (end) m.triangles.insert(m.triangles.end(), {hub, ring + j, ring + i});
            else m.triangles.insert(m.triangles.end(), {hub, ring + i, ring + j});
        }
    }
    m.normals.assign(m.positions.size(), Vec3f{0, 1, 0});
    if (shapes::signed_volume(m) < 0)
        for (std::size_t t = 0; t < m.triangles.size(); t += 3) std::swap(m.triangles[t + 1], m.triangles[t + 2]);
    shapes::smooth_normals(m);
    shapes::lay_grain(m);
    return m;
}

// A curve through points, by its share.
std::function<Vec3f(float)> curve_through(std::vector<Vec2f> points, std::function<Vec3f(Vec2f)> place) {
    const std::vector<Vec2f> fine = shapes::curve(points, 12);
    std::vector<float> run{0.f};
    for (std::size_t i = 1; i < fine.size(); ++i) run.push_back(run.back() + length(fine[i] - fine[i - 1]));
    return [=](float t) {
        const float want = t * run.back();
        std::size_t i = 1;
        while (i + 1 < fine.size() && run[i] < want) ++i;
        return place(fine[i - 1] +
                     (fine[i] - fine[i - 1]) * std::clamp((want - run[i - 1]) / (run[i] - run[i - 1]), 0.f, 1.f));
    };
}

void bolster(Kit& k, int mat, Vec3f from, float far, float r) {
    const std::array<Vec2f, 8> p{
        Vec2f{0.2f * r, 0}, {0.74f * r, 0.006f},      {0.95f * r, 0.03f},        {r, 0.09f},
        {r, far - 0.09f},   {0.95f * r, far - 0.03f}, {0.74f * r, far - 0.006f}, {0.2f * r, far}};
    Mesh roll = shapes::lathe(p, 24, true);
    shapes::turn(roll, {1, 0, 0}, 90);
    k.add(std::move(roll), mat, from);
}

// One long pad that rises to a back, on a light frame.
void swept_chaise(Kit& k, bool hide) {
    const int cloth = k.main(hide ? k.style.leather : k.style.fabric),
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
    k.add(padded_body({path,
                       {0, 0, 1},
                       [=](float t) {
                           return Vec2f{wide, 0.16f - 0.035f * eased(0.55f, 1.f, t)};
                       },
                       0.055f,
                       0.0025f,
                       34,
                       k.seed()}),
          cloth);
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
    put_pillow(k, second, path(0.66f) + Vec3f{0.17f, 0.075f, k.dice.uniform(-0.06f, 0.06f)}, {0.42f, 0.34f, 0.14f},
               40.f, 90.f + k.dice.uniform(-8, 8));
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
    k.add(padded_body({head,
                       {0, 0, 1},
                       [=](float) {
                           return Vec2f{deep - 0.03f, 0.13f};
                       },
                       0.05f,
                       0.001f,
                       14,
                       k.seed()}),
          cloth);
    bolster(k, cloth, {-hx + 0.085f, 0.77f, -hz + 0.01f}, deep - 0.02f, 0.092f);
    for (const float sz : {-1.f, 1.f})
        k.add(shapes::ball({-hx + 0.085f, 0.77f, sz * (hz - 0.012f)}, {0.03f, 0.03f, 0.012f}, 12), foot);
    // The back falls in a wave towards the feet.
    const float from = -hx + 0.12f, to = 0.44f;
    const auto crest = [=](float t) { return 0.8f - 0.36f * eased(0.1f, 1.f, t) + 0.02f * std::sin(kTau * t); };
    k.add(padded_body({[=](float t) {
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
          cloth);
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

void chaise_longue(Kit& k) {
    enum { swept, scrolled };
    const int form = form_for(k,
                              {{"modern", swept, swept},
                               {"scandinavian", swept, swept},
                               {"japandi", swept, swept},
                               {"industrial", swept, swept},
                               {"classic", scrolled, scrolled},
                               {"boho", scrolled, swept},
                               {"rustic", scrolled, swept},
                               {"mid-century", swept, swept},
                               {"mediterranean", scrolled, swept},
                               {"art deco", scrolled, scrolled}},
                              swept);
    if (form == scrolled) scrolled_chaise(k);
    else swept_chaise(k, k.style.name == "industrial");
    k.piece.clearance_front_m = 0.5f;
    k.piece.against_wall = true;
}

// A sack that has given way under who sat in it: flat below, a hollow for the seat, a soft peak behind.
void bean_bag(Kit& k) {
    Material m = k.style.fabric2;
    m.name = "bean bag";
    const int cloth = k.main(m);
    const std::uint32_t seed = k.seed();
    Mesh bag = shapes::ball({0, 0, 0}, {1, 1, 1}, 64);
    for (Vec3f& p : bag.positions) {
        const Vec3f d = normalize(p);
        const float around = std::atan2(d.x, d.z), up = std::max(0.f, d.y),
                    behind = eased(0.35f, -0.75f, d.z / std::max(0.3f, std::sqrt(d.x * d.x + d.z * d.z) + 0.25f * up));
        // Wider near the floor, where the filling goes; six panels meet in seams.
        const float belly = 1.f + 0.13f * std::exp(-8.f * (d.y + 0.35f) * (d.y + 0.35f)),
                    seam = std::exp(-std::pow(std::sin(3.f * around + 0.5f) / 0.16f, 2.f)) *
                           (1.f - 0.7f * std::fabs(d.y));
        const float fold = shapes::wobble(d * 3.2f, seed) +
                           0.55f * shapes::wobble({around * 5.f, d.y * 2.f, 3.f}, seed + 1) +
                           0.3f * shapes::wobble(d * 13.f, seed + 2);
        const float r = belly * (1.f - 0.028f * seam) + 0.02f * fold;
        float x = 0.43f * d.x * r, z = 0.45f * d.z * r, y = d.y < 0 ? 0.25f + 0.25f * d.y : 0.25f + 0.27f * d.y;
        y = std::max(y, 0.012f + 0.004f * fold);   // it lies on the floor
        y += 0.36f * std::pow(up, 0.8f) * behind;  // the back
        z -= 0.12f * up * behind;
        const float hx = x / 0.26f, hz = (z - 0.07f) / 0.24f;
        y -= 0.15f * up * std::exp(-hx * hx - hz * hz);  // the hollow
        y += (0.012f * fold - 0.012f * seam) * (0.3f + up);
        p = {x, std::max(0.f, y), z};
    }
    shapes::smooth_normals(bag);
    shapes::lay_grain(bag);
    // A loop to carry it by, at the peak.
    float peak = 0;
    Vec3f at;
    for (const Vec3f& p : bag.positions)
        if (p.y > peak) peak = p.y, at = p;
    k.add(std::move(bag), cloth);
    std::vector<Vec3f> loop;
    for (int i = 0; i <= 12; ++i) {
        const float a = kPi * static_cast<float>(i) / 12.f;
        loop.push_back(at + Vec3f{0.045f * std::cos(a), -0.012f + 0.05f * std::sin(a), 0.01f});
    }
    k.add(shapes::tube(loop, 0.007f, 6), cloth);
    k.top(0.4f, 0, 0.08f, 0.15f, 0.13f);
    k.piece.clearance_front_m = 0.4f;
}

// A basket like an egg, open to the front, that hangs by a chain from its own stand.
void hanging_chair(Kit& k) {
    const int cane = woven_main(k);
    if (k.request.color_name.empty() && !k.request.color &&
        (k.style.name == "modern" || k.style.name == "industrial")) {
        Material& m = k.piece.materials[static_cast<std::size_t>(cane)];
        m.color_a = m.color_c = {0.075f, 0.07f, 0.066f}, m.color_b = {0.03f, 0.028f, 0.027f};
    }
    const int metal = k.material(plain("black metal", {0.035f, 0.035f, 0.037f}, 0.45f)),
              cloth = k.material(tinted(k.style.fabric, lerp(k.style.fabric.color_a, {0.72f, 0.69f, 0.63f}, 0.4f))),
              second = accent_cloth(k);
    const Vec3f middle{0, 1.04f, 0.06f};
    constexpr float kWide = 0.46f, kHigh = 0.62f, kDeep = 0.42f;
    // Closed below the seat and above the head.
    const auto gap = [](float v) { return 1.02f * eased(0.24f, 0.46f, v) * (1.f - eased(0.74f, 0.97f, v)); };
    const auto on_egg = [=](float a, float v) {
        const float polar = kPi * (0.02f + 0.96f * v), r = std::sin(polar) * (1.f - 0.13f * eased(0.4f, 1.f, v));
        return middle + Vec3f{kWide * r * std::sin(a), -kHigh * std::cos(polar), kDeep * r * std::cos(a)};
    };
    k.add(shapes::slab(48, 30, 0.016f,
                       [=](float u, float v) {
                           const float open = gap(v);
                           return on_egg(open + (kTau - 2 * open) * u, v);
                       }),
          cane);
    // Its rim, and hoops that bear the weave.
    std::vector<Vec3f> rim;
    constexpr int kRim = 26;
    for (int i = 0; i <= kRim; ++i)
        rim.push_back(
            on_egg(gap(0.25f + 0.71f * static_cast<float>(i) / kRim), 0.25f + 0.71f * static_cast<float>(i) / kRim));
    for (int i = kRim; i-- > 0;)
        rim.push_back(
            on_egg(-gap(0.25f + 0.71f * static_cast<float>(i) / kRim), 0.25f + 0.71f * static_cast<float>(i) / kRim));
    k.add(shapes::tube(rim, 0.02f, 8), cane);
    // Cushions: a round seat, a tall back, one more.
    const std::array<Vec2f, 8> seat{Vec2f{0.1f, 0.f}, {0.25f, 0.008f}, {0.305f, 0.04f}, {0.32f, 0.085f},
                                    {0.3f, 0.13f},    {0.22f, 0.155f}, {0.1f, 0.163f},  {0.f, 0.158f}};
    Mesh round = shapes::lathe(seat, 36, true);
    const std::uint32_t seed = k.seed();
    for (Vec3f& p : round.positions)
        p.y += 0.008f * shapes::wobble(p * 12.f, seed) * (p.y > 0.05f ? 1.f : 0.f), p.z *= 0.94f;
    shapes::smooth_normals(round);
    k.add(std::move(round), cloth, middle + Vec3f{0, -0.44f, 0.01f});
    put_pillow(k, cloth, middle + Vec3f{0, -0.34f, -0.19f}, {0.6f, 0.66f, 0.19f}, 5.f);
    put_pillow(k, second, middle + Vec3f{k.dice.uniform(-0.05f, 0.05f), -0.29f, -0.01f}, {0.42f, 0.3f, 0.14f}, 24.f,
               k.dice.uniform(-8, 8));
    // The stand: a ring on the floor, a mast that bends over the basket.
    const float r = 0.5f;
    k.add(shapes::ring(r, 0.045f, 48), metal, {0, 0.0225f, 0});
    for (const float turn : {-0.5f, 0.5f})
        k.rod(metal, {r * std::sin(turn), 0.024f, r * std::cos(turn)}, {0, 0.03f, -r}, 0.016f, -1, 10);
    const auto mast = curve_through({{-r, 0.03f},
                                     {-r - 0.09f, 0.5f},
                                     {-r - 0.11f, 1.1f},
                                     {-r - 0.02f, 1.65f},
                                     {-0.3f, 1.97f},
                                     {-0.05f, 2.02f},
                                     {0.06f, 1.98f}},
                                    [](Vec2f p) {
                                        return Vec3f{0, p.y, p.x};
                                    });
    std::vector<Vec3f> bent;
    for (int i = 0; i <= 36; ++i) bent.push_back(mast(static_cast<float>(i) / 36.f));
    k.add(shapes::tube(bent, 0.024f, 12), metal);
    const float top = middle.y + kHigh - 0.005f;
    for (int i = 0; top + 0.045f * static_cast<float>(i) < 1.95f; ++i) {
        Mesh link = shapes::ring(0.024f, 0.009f, 12);
        shapes::turn(link, i % 2 ? Vec3f{1, 0, 0} : Vec3f{0, 0, 1}, 90);
        k.add(std::move(link), metal, {0, top + 0.02f + 0.045f * static_cast<float>(i), 0.06f});
    }
    k.top(middle.y - 0.27f, 0, 0.14f, 0.16f, 0.1f);
    k.piece.clearance_front_m = 0.5f;
}

// Shells of bent wood with buttoned cushions, on a star of metal.
void lounge_chair(Kit& k) {
    const int hide = k.main(k.request.material.empty() && k.style.name != "mid-century" && k.style.name != "industrial"
                                ? *material_named("leather")
                                : k.style.leather);
    if (k.request.color_name.empty() && !k.request.color && k.request.material.empty() && k.dice.chance(0.6f)) {
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
        k.add(padded_body({[=](float t) {
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
              hide);
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

// A sheet of hide or canvas hung by its four corners in a frame of bent rod.
void butterfly_chair(Kit& k) {
    const bool canvas = k.style.name == "scandinavian" || k.style.name == "mediterranean" || k.style.name == "boho";
    const int hide = k.main(canvas ? k.style.fabric : k.style.leather),
              metal = k.material(plain("black metal", {0.035f, 0.035f, 0.037f}, 0.45f));
    const Vec3f back{0.37f, 0.93f, -0.4f}, front{0.4f, 0.63f, 0.34f};
    const auto mirrored = [](Vec3f p, float s) { return Vec3f{s * p.x, p.y, p.z}; };
    for (const float s : {-1.f, 1.f}) {
        // From the corner down to the other end, along the floor, and up to the other corner.
        std::vector<Vec3f> loop;
        const Vec3f b = mirrored(back, s), f = mirrored(front, -s);
        const auto bend = [&](Vec3f a, Vec3f corner, Vec3f c) {
            for (int i = 0; i <= 6; ++i) {
                const float t = static_cast<float>(i) / 6.f;
                loop.push_back(lerp(lerp(a, corner, t), lerp(corner, c, t), t));
            }
        };
        const Vec3f low_front{s * 0.31f, 0.011f, 0.33f}, low_back{-s * 0.31f, 0.011f, -0.33f};
        loop.push_back(b);
        bend(lerp(b, low_front, 0.93f), low_front, lerp(low_front, low_back, 0.08f));
        bend(lerp(low_front, low_back, 0.92f), low_back, lerp(low_back, f, 0.07f));
        loop.push_back(f);
        k.add(shapes::tube(loop, 0.0075f, 8), metal);
    }
    k.add(shapes::slab(26, 30, 0.007f,
                       [=](float u, float v) {
                           const float x = 2 * u - 1, hang = std::sin(kPi * v);
                           const Vec3f left = lerp(mirrored(back, -1), mirrored(front, -1), 1 - v),
                                       right = lerp(back, front, 1 - v);
                           Vec3f p = lerp(left, right, u);
                           p.x *= 1.f - 0.3f * hang * std::fabs(x);
                           // It sags into a seat, whose edges are drawn tight between the corners.
                           const float deep = std::max(0.f, std::sin(kPi * std::pow(1 - v, 0.8f)));
                           p.y -= 0.47f * std::pow(deep, 0.9f) * (1.f - 0.3f * x * x) +
                                  0.1f * (1.f - x * x) * (1.f - hang);
                           p.z += (0.1f * deep - 0.03f) * (1.f - x * x) * (1 - v);
                           return p;
                       }),
          hide);
    for (const float s : {-1.f, 1.f})
        for (const Vec3f c : {back, front}) k.add(shapes::ball(mirrored(c, s), {0.022f, 0.02f, 0.022f}, 10), hide);
    k.top(0.34f, 0, 0.06f, 0.14f, 0.12f);
    k.piece.clearance_front_m = 0.5f;
}

// Of boards: a seat that slopes back, a fan of slats, broad arms.
void adirondack_chair(Kit& k) {
    const int wood = k.main(k.style.wood2);
    const auto board_from = [&](Vec3f a, Vec3f b, float wide, float thick) {
        const Vec3f d = b - a;
        Mesh m = shapes::box({wide, length(d), thick}, 0.006f);
        shapes::turn(m, {0, 0, 1}, -std::asin(d.x / length(d)) * 180.f / kPi);
        shapes::turn(m, {1, 0, 0}, std::atan2(d.z, d.y) * 180.f / kPi);
        k.add(std::move(m), wood, (a + b) * 0.5f);
    };
    for (const float sx : {-1.f, 1.f}) {
        // A rail from before the knees to the floor behind; legs; an arm on both.
        board_from({sx * 0.27f, 0.05f, -0.48f}, {sx * 0.27f, 0.36f, 0.34f}, 0.025f, 0.1f);
        k.board(wood, {sx * 0.3f, 0, 0.29f}, {0.028f, 0.55f, 0.1f}, 0.006f);
        k.board(wood, {sx * 0.3f, 0.02f, -0.26f}, {0.028f, 0.53f, 0.08f}, 0.006f);
        k.board(wood, {sx * 0.335f, 0.55f, 0.02f}, {0.13f, 0.024f, 0.76f}, 0.01f);
    }
    for (int i = 0; i < 6; ++i) {
        const float t = static_cast<float>(i) / 5.f;
        k.board(wood, {0, 0.405f - 0.155f * t, 0.32f - 0.44f * t}, {0.56f, 0.022f, 0.078f}, 0.006f);
    }
    const Vec3f foot{0, 0.2f, -0.19f};
    for (int i = -3; i <= 3; ++i) {
        const float x = static_cast<float>(i), tall = 0.8f - 0.018f * x * x;
        board_from(foot + Vec3f{0.07f * x, 0, 0}, foot + Vec3f{0.092f * x, tall * 0.9f, -tall * 0.42f}, 0.072f, 0.02f);
    }
    k.board(wood, {0, 0.47f, -0.345f}, {0.66f, 0.07f, 0.024f}, 0.006f);
    k.board(wood, {0, 0.78f, -0.49f}, {0.52f, 0.055f, 0.022f}, 0.006f);
    put_pillow(k, accent_cloth(k), {0, 0.34f, -0.03f}, {0.42f, 0.4f, 0.13f}, 26.f);
    k.top(0.4f, 0, 0.2f, 0.2f, 0.08f);
    k.piece.clearance_front_m = 0.5f;
}

// High-backed, gilt, cushioned in velvet, with a crest.
void throne(Kit& k) {
    Material velvet = *material_named("velvet");
    velvet = tinted(velvet, *color_named("burgundy"));
    const int cloth = k.main(velvet), gold = k.material(*material_named("brass")),
              wood = k.material(k.style.name == "industrial" || k.style.name == "modern" ? *material_named("ebony")
                                                                                         : *material_named("mahogany"));
    const float hx = 0.36f, seat = 0.46f, back = -0.32f, high = 1.62f;
    for (const float sx : {-1.f, 1.f}) {
        const std::array<Vec2f, 9> p{Vec2f{0.03f, 0}, {0.042f, 0.02f}, {0.03f, 0.06f},
                                     {0.022f, 0.12f}, {0.036f, 0.24f}, {0.03f, 0.32f},
                                     {0.042f, 0.36f}, {0.042f, 0.56f}, {0.036f, 0.68f}};
        k.add(shapes::lathe(p, 18, true), wood, {sx * hx, 0, 0.3f});
        k.board(wood, {sx * hx, 0, back}, {0.075f, high - 0.12f, 0.07f}, 0.012f);
        // The arm ends in a gilt scroll.
        k.board(wood, {sx * hx, 0.68f, 0.0f}, {0.085f, 0.045f, 0.62f}, 0.014f);
        k.soft(cloth, {sx * hx, 0.72f, -0.03f}, {0.075f, 0.04f, 0.4f}, {0.018f, 0.008f, 0.001f, 8});
        k.add(shapes::ball({sx * hx, 0.7f, 0.32f}, {0.05f, 0.05f, 0.05f}, 18), gold);
        const std::array<Vec2f, 8> finial{Vec2f{0.036f, 0}, {0.046f, 0.016f}, {0.03f, 0.032f}, {0.044f, 0.07f},
                                          {0.05f, 0.095f},  {0.036f, 0.13f},  {0.016f, 0.16f}, {0.004f, 0.185f}};
        k.add(shapes::lathe(finial, 18, true), gold, {sx * hx, high - 0.12f, back});
        k.soft(cloth, {sx * hx, 0.5f, -0.02f}, {0.03f, 0.16f, 0.5f}, {0.01f, 0.004f, 0.001f, 8});
    }
    k.board(wood, {0, seat - 0.1f, 0}, {2 * hx, 0.1f, 0.66f}, 0.016f);
    k.board(gold, {0, seat - 0.095f, 0.33f}, {2 * hx - 0.06f, 0.022f, 0.012f}, 0.004f);
    k.soft(cloth, {0, seat - 0.01f, 0.02f}, {2 * hx - 0.06f, 0.12f, 0.6f}, {0.045f, 0.025f, 0.002f, 12});
    k.board(wood, {0, seat, back}, {2 * hx, high - seat - 0.2f, 0.04f}, 0.01f);
    k.soft(cloth, {0, seat + 0.1f, back + 0.04f}, {2 * hx - 0.16f, 0.86f, 0.08f}, {0.035f, 0.02f, 0.001f, 12});
    for (int row = 0; row < 4; ++row)
        for (int i = 0; i < (row % 2 ? 2 : 3); ++i)
            k.add(shapes::ball({0.16f * (static_cast<float>(i) - (row % 2 ? 0.5f : 1.f)),
                                seat + 0.24f + 0.18f * static_cast<float>(row), back + 0.078f},
                               {0.013f, 0.013f, 0.008f}, 8),
                  gold);
    // The crest: an arch with a crown of points.
    std::vector<Vec2f> arch;
    constexpr int kArch = 16;
    for (int i = 0; i <= kArch; ++i) {
        const float t = static_cast<float>(i) / kArch, x = (hx - 0.02f) * (2 * t - 1);
        arch.push_back({x, 0.06f + 0.15f * std::sin(kPi * t)});
    }
    arch.push_back({hx - 0.02f, -0.05f});
    arch.push_back({-hx + 0.02f, -0.05f});
    for (Vec2f& p : arch) p.y = -p.y;
    Mesh crest = shapes::prism(arch, -0.022f, 0.022f, 0.006f);
    shapes::turn(crest, {1, 0, 0}, 90);
    k.add(std::move(crest), wood, {0, high - 0.16f, back});
    std::vector<Vec3f> rim;
    for (int i = 0; i <= kArch; ++i) {
        const float t = static_cast<float>(i) / kArch;
        rim.push_back({(hx - 0.03f) * (2 * t - 1), high - 0.1f + 0.15f * std::sin(kPi * t), back + 0.012f});
    }
    k.add(shapes::tube(rim, 0.016f, 10), gold);
    for (int i = -1; i <= 1; ++i)
        k.add(shapes::ball({0.11f * static_cast<float>(i), high + 0.08f - 0.02f * std::fabs(static_cast<float>(i)),
                            back + 0.012f},
                           {0.024f, i == 0 ? 0.05f : 0.034f, 0.024f}, 14),
              gold);
    k.top(seat + 0.1f, 0, 0.06f, 0.22f, 0.18f);
    k.piece.clearance_front_m = 0.6f;
    k.piece.against_wall = true;
}

// A chest below a window with a cushion on it.
void window_seat(Kit& k) {
    const Vec3f s = k.wanted({1.5f, 0.5f, 0.5f});
    const int cloth = k.main(k.style.fabric),
              wood = k.material(k.style.name == "modern" || k.style.name == "scandinavian" ||
                                        k.style.mouldings == Mouldings::rich
                                    ? k.style.trim
                                    : k.style.wood),
              metal = k.material(k.style.metal);
    const float top = s.y - 0.09f;
    k.board(wood, {0, 0, -0.02f}, {s.x - 0.04f, 0.07f, s.z - 0.06f}, 0.004f);
    k.board(wood, {0, 0.07f, 0}, {s.x, top - 0.095f, s.z - 0.03f}, 0.004f);
    k.board(wood, {0, top - 0.025f, 0}, {s.x + 0.02f, 0.025f, s.z}, 0.006f);
    fronts(k, wood, metal, -0.5f * s.x + 0.02f, 0.5f * s.x - 0.02f, 0.09f, top - 0.04f, 0.5f * s.z - 0.015f,
           s.x > 1.2f ? 3 : 2, 1);
    k.soft(cloth, {0, top - 0.003f, 0.005f}, {s.x - 0.02f, 0.1f, s.z - 0.03f}, {0.04f, 0.014f, 0.003f, 22});
    for (const float sx : {-1.f, 1.f})
        put_pillow(k, sx < 0 ? accent_cloth(k) : k.material(tinted(k.style.fabric2, k.accent())),
                   {sx * (0.5f * s.x - 0.25f), s.y, -0.5f * s.z + 0.17f}, {0.42f, 0.38f, 0.14f}, 18.f, -sx * 14.f);
    k.top(s.y + 0.005f, 0, 0.06f, 0.2f * s.x, 0.3f * s.z);
    k.piece.clearance_front_m = 0.4f;
    k.piece.against_wall = true;
}

constexpr Entry kLounges[] = {{"chaise_longue", chaise_longue},
                              {"bean_bag", bean_bag},
                              {"hanging_chair", hanging_chair},
                              {"lounge_chair", lounge_chair},
                              {"butterfly_chair", butterfly_chair},
                              {"adirondack_chair", adirondack_chair},
                              {"throne", throne},
                              {"window_seat", window_seat}};

}  // namespace

std::span<const Entry> lounges() { return kLounges; }

}  // namespace fastscene::furniture

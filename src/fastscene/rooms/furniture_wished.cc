// Pieces that stand in a room only when somebody asks for them: a Christmas tree, a rocking chair, a hammock, a mobile
// over a cot, a rack of washing, pipes, gears or pans on a wall, a dressing table, cobwebs.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture_kit.h"

namespace fastscene::furniture {
namespace {

// A needle-like solid of four triangles from `base`, `wide` across, to a point.
void spike(Mesh& into, Vec3f base, Vec3f tip, float wide) {
    const Vec3f along = normalize(tip - base),
                side = normalize(cross(along, std::abs(along.y) < 0.9f ? Vec3f{0, 1, 0} : Vec3f{1, 0, 0})),
                up = cross(side, along);
    Mesh m;
    for (int i = 0; i < 3; ++i) {
        const float a = kTau * static_cast<float>(i) / 3.f;
        m.positions.push_back(base + (side * std::cos(a) + up * std::sin(a)) * wide);
    }
    m.positions.push_back(tip);
    m.triangles = {0, 1, 3, 1, 2, 3, 2, 0, 3, 0, 2, 1};
    m.normals.assign(4, Vec3f{0, 1, 0});
    if (shapes::signed_volume(m) < 0)
        for (std::size_t t = 0; t < m.triangles.size(); t += 3) std::swap(m.triangles[t + 1], m.triangles[t + 2]);
    shapes::smooth_normals(m);
    shapes::lay_grain(m);
    shapes::append(into, m);
}

// The outline of a star with five points, one of them up.
std::vector<Vec2f> star(float outer, float inner) {
    std::vector<Vec2f> outline;
    for (int i = 0; i < 10; ++i) {
        const float a = kTau * static_cast<float>(i) / 10.f, r = i % 2 == 0 ? outer : inner;
        outline.push_back({r * std::sin(a), -r * std::cos(a)});
    }
    return outline;
}

// A fir on a stand: tiers of twigs that hang outward, baubles, small lights, a star, presents below.
void christmas_tree(Kit& k) {
    const float high = (k.request.size_m.y > 0.6f ? k.request.size_m.y : 1.85f * k.request.size_factor),
                wide = 0.3f * high, bare = 0.14f * high;
    k.sized = true;
    Material needles = plain("fir needles", {0.03f, 0.095f, 0.045f}, 0.85f);
    const int green = k.main(needles), trunk = k.material(plain("trunk", {0.12f, 0.07f, 0.04f}, 0.9f)),
              metal = k.material(k.style.metal);
    k.rod(trunk, {0, 0.02f, 0}, {0, 0.92f * high, 0}, 0.03f, 0.008f, 10);
    for (int i = 0; i < 3; ++i) {
        const float a = 2.0944f * static_cast<float>(i);
        k.rod(metal, {0.22f * std::sin(a), 0.012f, 0.22f * std::cos(a)}, {0, 0.1f, 0}, 0.012f, -1, 8);
    }
    // Each tier: boughs all around, fuller and lower at their tips, that reach below the tier under it.
    constexpr int kTiers = 11;
    Mesh boughs;
    for (int tier = 0; tier < kTiers; ++tier) {
        const float t = static_cast<float>(tier) / (kTiers - 1), y = bare + (0.93f * high - bare) * (0.1f + 0.9f * t),
                    r = wide * (1.02f - 0.93f * t);
        const int around = 9 + static_cast<int>(14.f * (1.f - t));
        for (int i = 0; i < around; ++i) {
            const float a = kTau *
                            (static_cast<float>(i) + 0.5f * static_cast<float>(tier % 2) +
                             k.dice.uniform(-0.2f, 0.2f)) /
                            static_cast<float>(around),
                        reach = r * k.dice.uniform(0.86f, 1.08f), drop = 0.34f * reach + k.dice.uniform(0.f, 0.03f),
                        c = std::cos(a), s = std::sin(a);
            const Vec3f tip{reach * c, y - drop, reach * s}, root{0.06f * reach * c, y + 0.05f, 0.06f * reach * s},
                out = normalize(tip - root);
            const Vec3f side = normalize(cross(out, Vec3f{0, 1, 0}));
            spike(boughs, root, tip, 0.05f);
            // Twigs to both sides, a flat spray.
            for (int j = 0; j < 6; ++j) {
                const float at = 0.25f + 0.13f * static_cast<float>(j), twig = (0.3f - 0.18f * at) * reach + 0.03f;
                for (const float way : {-1.f, 1.f}) {
                    const Vec3f from = lerp(root, tip, at);
                    spike(boughs, from,
                          from + out * (0.7f * twig) + side * (way * 0.75f * twig) - Vec3f{0, 0.2f * twig, 0}, 0.024f);
                }
            }
        }
    }
    k.add(std::move(boughs), green);
    // Baubles at the tips in the colors of the feast, lights between them.
    static constexpr std::array<Vec3f, 3> kBaubles{Vec3f{0.5f, 0.02f, 0.03f}, {0.6f, 0.4f, 0.1f}, {0.62f, 0.6f, 0.56f}};
    std::array<int, 3> baubles{};
    for (std::size_t i = 0; i < 3; ++i) baubles[i] = k.material(plain("bauble", kBaubles[i], 0.12f));
    Material bulb = glow("tree light", Vec3f{13.f, 7.4f, 2.6f} * 1.5f);
    bulb.pattern = Pattern::screen;  // lit at any hour
    const int light = k.material(bulb);
    constexpr int kThings = 92;
    for (int i = 0; i < kThings; ++i) {
        // Evenly over the cone: more where it is wide.
        const float t = 1.f - std::sqrt((static_cast<float>(i) + 0.5f) / kThings), a = 2.39996f * static_cast<float>(i),
                    y = bare + (0.9f * high - bare) * t - 0.04f,
                    r = wide * (1.f - 0.93f * t) * k.dice.uniform(0.84f, 0.97f);
        const Vec3f at{r * std::cos(a), y - 0.2f * r, r * std::sin(a)};
        const float size = i % 3 == 0 ? 0.024f + 0.012f * k.dice.uniform() : 0.013f;
        k.add(shapes::ball(at, {size, size, size}, i % 3 == 0 ? 12 : 6),
              i % 3 == 0 ? baubles[static_cast<std::size_t>(i / 3) % 3] : light);
    }
    // The star: five points, front and back.
    const int gold = k.material(*material_named("brass"));
    Mesh points = shapes::prism(star(0.085f, 0.036f), -0.012f, 0.012f, 0.003f);
    shapes::turn(points, {1, 0, 0}, 90);
    k.add(std::move(points), gold, {0, high - 0.075f, 0});
    // Presents, tied with ribbons.
    static constexpr std::array<Vec3f, 4> kPaper{
        Vec3f{0.45f, 0.03f, 0.04f}, {0.05f, 0.2f, 0.1f}, {0.62f, 0.58f, 0.5f}, {0.12f, 0.16f, 0.36f}};
    for (int i = 0; i < 4; ++i) {
        const float a = 0.7f + 1.5f * static_cast<float>(i) + k.dice.uniform(-0.2f, 0.2f), far = 0.62f * wide;
        const Vec3f size{k.dice.uniform(0.16f, 0.26f), k.dice.uniform(0.08f, 0.18f), k.dice.uniform(0.13f, 0.2f)},
            at{far * std::sin(a), 0, far * std::cos(a)};
        const int paper = k.material(plain("wrapping paper", kPaper[static_cast<std::size_t>(i)], 0.35f)),
                  ribbon = k.material(plain("ribbon", i % 2 ? kBaubles[0] : kBaubles[1], 0.3f));
        k.board(paper, at, size, 0.003f);
        k.board(ribbon, at, {0.02f, size.y + 0.002f, size.z + 0.003f}, 0.001f);
        k.board(ribbon, at, {size.x + 0.003f, size.y + 0.002f, 0.02f}, 0.001f);
        for (const float s : {-1.f, 1.f})
            k.add(shapes::ball(at + Vec3f{s * 0.022f, size.y + 0.014f, 0}, {0.024f, 0.014f, 0.01f}, 8), ribbon);
    }
    k.piece.clearance_front_m = 0.3f;
}

// A chair of turned wood on two rockers, with a cushion.
void rocking_chair(Kit& k) {
    const int wood = k.main(k.style.wood2), cloth = k.material(tinted(k.style.fabric2, k.accent()));
    const float half = 0.27f, seat = 0.41f;
    for (const float sx : {-1.f, 1.f}) {
        const float x = sx * half;
        std::vector<Vec3f> rocker;
        for (int i = 0; i <= 18; ++i) {
            const float t = static_cast<float>(i) / 9.f - 1.f;
            rocker.push_back({x, 0.017f + 0.085f * t * t, 0.47f * t - 0.04f});
        }
        k.add(shapes::tube(rocker, 0.017f, 10), wood);
        k.rod(wood, {x, 0.045f, 0.21f}, {x, 0.655f, 0.235f}, 0.017f, 0.02f, 12);
        k.rod(wood, {x, 0.045f, -0.25f}, {x - sx * 0.015f, seat, -0.22f}, 0.018f, 0.02f, 12);
        k.rod(wood, {x - sx * 0.015f, seat, -0.22f}, {x - sx * 0.03f, 1.09f, -0.43f}, 0.02f, 0.014f, 12);
        k.add(shapes::ball({x - sx * 0.03f, 1.1f, -0.434f}, {0.02f, 0.026f, 0.02f}, 12), wood);
        Mesh arm = shapes::box({0.065f, 0.024f, 0.56f}, 0.008f);
        shapes::turn(arm, {1, 0, 0}, -2);
        k.add(std::move(arm), wood, {x, 0.665f, -0.01f});
        k.rod(wood, {x, 0.22f, 0.215f}, {x, 0.2f, -0.24f}, 0.011f, -1, 10);
    }
    for (const float z : {0.218f, -0.235f}) k.rod(wood, {-half, 0.24f, z}, {half, 0.24f, z}, 0.011f, -1, 10);
    k.board(wood, {0, seat - 0.02f, -0.005f}, {2 * half - 0.01f, 0.026f, 0.48f}, 0.01f);
    // The back: slats between two rails, leaning as its posts do.
    const auto back = [&](float x, float y) { return Vec3f{x, y, -0.22f - 0.309f * (y - seat)}; };
    for (int i = -3; i <= 3; ++i)
        k.rod(wood, back(0.066f * static_cast<float>(i), seat), back(0.062f * static_cast<float>(i), 1.0f), 0.009f, -1,
              8);
    for (const auto& [y, high] : {std::pair{1.0f, 0.1f}, std::pair{0.52f, 0.04f}}) {
        Mesh rail = shapes::box({2 * half - 0.06f, high, 0.022f}, 0.007f);
        shapes::turn(rail, {1, 0, 0}, -17.2f);
        k.add(std::move(rail), wood, back(0, y));
    }
    k.soft(cloth, {0, seat + 0.006f, 0.01f}, {0.44f, 0.055f, 0.42f}, {0.022f, 0.012f, 0.002f, 9});
    k.top(seat + 0.06f, 0, 0.05f, 0.18f, 0.15f);
    k.piece.clearance_front_m = 0.5f;
}

// Cloth between the ends of a wooden stand.
void hammock(Kit& k) {
    const Vec3f s = k.wanted({2.5f, 1.2f, 0.85f});
    Material m = tinted(k.style.fabric2, k.accent());
    m.pattern = Pattern::stripes;
    m.scale_m = 0.07f;
    m.color_b = {0.68f, 0.64f, 0.55f};
    m.color_c = m.color_a;
    const int cloth = k.main(m), wood = k.material(k.style.wood2),
              cord = k.material(plain("cord", {0.5f, 0.44f, 0.33f}, 0.9f));
    const float reach = 0.5f * s.x - 0.04f, high = s.y - 0.03f, width = 0.88f * s.z, sag = 0.5f * high;
    // A low bow of wood, feet across its ends.
    std::vector<Vec3f> bow;
    for (int i = 0; i <= 24; ++i) {
        const float t = static_cast<float>(i) / 12.f - 1.f, t4 = t * t * t * t;
        bow.push_back({reach * (t < 0 ? -1.f : 1.f) * std::pow(std::abs(t), 0.72f), 0.075f + (high - 0.075f) * t4, 0});
    }
    k.add(shapes::tube(bow, 0.036f, 12), wood);
    for (const float x : {-0.5f * reach, 0.5f * reach}) k.board(wood, {x, 0, 0}, {0.09f, 0.06f, s.z}, 0.01f);
    const auto hang = [&](float u, float v) {
        const float t = 2 * u - 1, across = 2 * v - 1, end = std::sqrt(std::max(0.f, 1.f - t * t));
        const float y = high - 0.06f - (sag * (1.f - t * t)) * (1.f - 0.22f * across * across);
        return Vec3f{0.74f * reach * t, y, 0.5f * width * across * (0.42f + 0.58f * end)};
    };
    k.add(shapes::slab(30, 12, 0.006f, [&](float u, float v) { return hang(u, 1 - v); }), cloth);
    for (const float end : {0.f, 1.f})
        for (int i = 0; i <= 8; ++i)
            k.rod(cord, hang(end, static_cast<float>(i) / 8.f), bow[end > 0.5f ? 24 : 0], 0.0035f, -1, 6);
    k.piece.clearance_front_m = 0.3f;
}

// Small shapes of felt on threads, under a cross of wood.
void cot_mobile(Kit& k) {
    const int wood = k.main(*material_named("birch")), thread = k.material(plain("thread", {0.6f, 0.58f, 0.54f}, 0.8f));
    const float drop = k.request.size_m.y > 0.4f ? k.request.size_m.y : 0.95f, cross_y = -drop + 0.34f;
    k.sized = true;
    k.add(shapes::prism(shapes::circle(0.03f, 20), -0.012f, 0.f, 0.003f), wood);
    k.rod(thread, {0, cross_y, 0}, {0, -0.008f, 0}, 0.002f, -1, 6);
    k.add(shapes::ball({0, cross_y, 0}, {0.02f, 0.02f, 0.02f}, 12), wood);
    std::array<int, 4> felts{};
    for (std::size_t i = 0; i < 4; ++i)
        felts[i] = k.material(plain("felt", lerp(k.style.palette[i], {0.66f, 0.62f, 0.58f}, 0.3f), 0.95f));
    for (int i = 0; i < 6; ++i) {
        const float a = 1.0472f * static_cast<float>(i), c = std::cos(a), s = std::sin(a),
                    down = cross_y - (i % 2 == 0 ? 0.17f : 0.25f);
        const Vec3f end{0.21f * c, cross_y, 0.21f * s}, at{end.x, down, end.z};
        k.rod(wood, {0, cross_y, 0}, end, 0.006f, -1, 8);
        k.rod(thread, at, end, 0.0015f, -1, 6);
        const int felt = felts[static_cast<std::size_t>(i) % 4];
        if (i % 3 == 0) {  // a star
            Mesh m = shapes::prism(star(0.062f, 0.03f), -0.012f, 0.012f, 0.005f);
            shapes::turn(m, {1, 0, 0}, 90);
            shapes::turn(m, {0, 1, 0}, 40.f * static_cast<float>(i));
            k.add(std::move(m), felt, at - Vec3f{0, 0.05f, 0});
        } else if (i % 3 == 1) {  // a cloud
            for (const Vec3f& p : {Vec3f{-0.042f, 0, 0.03f}, {0, 0.014f, 0.043f}, {0.044f, 0, 0.032f}})
                k.add(shapes::ball(at + Vec3f{p.x, p.y - 0.045f, 0}, {p.z, 0.85f * p.z, 0.6f * p.z}, 14), felt);
        } else {  // a ball
            k.add(shapes::ball(at - Vec3f{0, 0.045f, 0}, {0.045f, 0.045f, 0.045f}, 18), felt);
        }
    }
    k.piece.mount = Mount::ceiling;
}

// A folding rack with washing over its bars.
void clothes_horse(Kit& k) {
    const int frame = k.main(plain("white enamel", {0.72f, 0.72f, 0.7f}, 0.35f));
    const float half = 0.52f, high = 0.95f, reach = 0.3f;
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f})
            k.rod(frame, {sx * half, 0, sz * reach}, {sx * half, high, -sz * reach}, 0.011f, -1, 10);
    std::vector<Vec3f> bars;
    for (const float t : {1.f, 0.82f, 0.64f})
        for (const float sz : {-1.f, 1.f}) bars.push_back({0, high * t, sz * reach * (2 * t - 1)});
    for (const Vec3f& bar : bars) k.rod(frame, {-half, bar.y, bar.z}, {half, bar.y, bar.z}, 0.006f, -1, 8);
    for (std::size_t i = 0; i < 4; ++i) {
        // A towel, a shirt, a cloth: folded over the bar, one side longer.
        const Vec3f bar = bars[i < 2 ? i : i + 1 - (i % 2)];
        const float width = k.dice.uniform(0.3f, 0.46f),
                    x = (i % 2 == 0 ? -1.f : 1.f) * k.dice.uniform(0.02f, 0.06f) + (i < 2 ? 0.f : 0.02f),
                    down = (i < 2 ? 0.42f : 0.24f) * k.dice.uniform(0.8f, 1.f),
                    side = x + (i < 2 ? 0.f : (i == 2 ? -0.24f : 0.24f));
        Material m = tinted(k.style.fabric, lerp(k.accent(), {0.7f, 0.68f, 0.64f}, k.dice.uniform(0.2f, 0.7f)));
        const std::uint32_t seed = k.seed();
        k.add(shapes::slab(14, 20, 0.005f,
                           [=](float u, float v) {
                               const float across = (u - 0.5f) * (i < 2 ? width * 1.4f : width),
                                           run = (v - 0.42f) * 2.f * down, over = std::min(std::abs(run), 0.02f),
                                           way = run < 0 ? 1.f : -1.f, hang = std::max(0.f, std::abs(run) - 0.02f);
                               const float fold = 0.006f * std::min(1.f, 8.f * hang) *
                                                  (std::sin(across * 31.f) +
                                                   shapes::wobble({across * 9, v * 4, 0}, seed));
                               return Vec3f{side + across, bar.y + 0.012f - 0.25f * over - hang,
                                            bar.z + way * (0.55f * over + 0.008f) + fold};
                           }),
              k.material(m));
    }
    k.piece.clearance_front_m = 0.4f;
}

// Pipes along a wall, with elbows, flanges, a valve and a gauge.
void pipes(Kit& k) {
    const Vec3f s = k.wanted({1.7f, 1.5f, 0.2f});
    const int metal = k.main(*material_named("copper")), brass = k.material(*material_named("brass")),
              iron = k.material(plain("cast iron", {0.05f, 0.046f, 0.043f}, 0.6f)),
              red = k.material(plain("valve wheel", {0.4f, 0.04f, 0.03f}, 0.4f)),
              dial = k.material(plain("dial", {0.7f, 0.68f, 0.6f}, 0.4f));
    const auto run = [&](std::vector<Vec3f> corners, float r, int material) {
        // Elbows: each corner becomes a short bend.
        std::vector<Vec3f> path{corners.front()};
        for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
            const Vec3f in = normalize(corners[i] - corners[i - 1]), out = normalize(corners[i + 1] - corners[i]);
            const float bend = 2.2f * r;
            for (int j = 0; j <= 6; ++j) {
                const float t = static_cast<float>(j) / 6.f;
                path.push_back(corners[i] - in * (bend * (1 - t) * (1 - t)) + out * (bend * t * t));
            }
            for (const Vec3f& p : {corners[i] - in * bend, corners[i] + out * bend}) {
                const Vec3f along = p == corners[i] - in * bend ? in : out;
                k.rod(brass, p - along * (0.35f * r), p + along * (0.35f * r), 1.28f * r, -1, 16);
            }
        }
        path.push_back(corners.back());
        k.add(shapes::tube(path, r, 16), material);
        for (std::size_t i = 0; i + 1 < corners.size(); ++i)
            if (const Vec3f way = corners[i + 1] - corners[i]; length(way) > 0.7f) {
                const Vec3f p = corners[i] + way * 0.5f, along = normalize(way);
                k.rod(iron, p - along * 0.012f, p + along * 0.012f, 1.5f * r, -1, 18);
                k.rod(iron, {p.x, p.y, 0}, p, 0.4f * r, -1, 8);  // its bracket
            }
    };
    const float w = 0.5f * s.x, h = s.y;
    run({{-w, 0.2f * h, 0.09f}, {0.12f * w, 0.2f * h, 0.09f}, {0.12f * w, 0.86f * h, 0.09f}, {w, 0.86f * h, 0.09f}},
        0.042f, metal);
    run({{-0.62f * w, 0.f, 0.07f}, {-0.62f * w, 0.7f * h, 0.07f}, {-0.1f * w, 0.7f * h, 0.07f}, {-0.1f * w, h, 0.07f}},
        0.027f, metal);
    run({{0.6f * w, 0.f, 0.06f}, {0.6f * w, 0.55f * h, 0.06f}, {w, 0.55f * h, 0.06f}}, 0.02f, brass);
    // The valve's wheel and the gauge face the room.
    const Vec3f valve{-0.3f * w, 0.2f * h, 0.09f}, gauge{-0.62f * w, 0.46f * h, 0.07f};
    k.add(shapes::ball(valve, {0.06f, 0.06f, 0.06f}, 16), brass);
    k.rod(brass, valve, valve + Vec3f{0, 0, 0.1f}, 0.014f, -1, 10);
    Mesh wheel = shapes::ring(0.075f, 0.01f, 24);
    shapes::turn(wheel, {1, 0, 0}, 90);
    k.add(std::move(wheel), red, valve + Vec3f{0, 0, 0.095f});
    for (int i = 0; i < 2; ++i) {
        const float a = 0.4f + 1.5708f * static_cast<float>(i);
        const Vec3f d{0.07f * std::cos(a), 0.07f * std::sin(a), 0.095f};
        k.rod(red, valve + Vec3f{-d.x, -d.y, d.z}, valve + d, 0.006f, -1, 8);
    }
    k.rod(brass, gauge + Vec3f{0, 0, 0.02f}, gauge + Vec3f{0, 0, 0.07f}, 0.065f, -1, 24);
    k.rod(dial, gauge + Vec3f{0, 0, 0.07f}, gauge + Vec3f{0, 0, 0.0725f}, 0.055f, -1, 24);
    k.rod(iron, gauge + Vec3f{0, 0, 0.074f}, gauge + Vec3f{0.028f, 0.03f, 0.074f}, 0.003f, 0.0015f, 6);
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 0.9f;
}

// Toothed wheels that mesh, on a wall.
void gears(Kit& k) {
    const int metal = k.main(*material_named("brass")), copper = k.material(*material_named("copper")),
              iron = k.material(plain("cast iron", {0.06f, 0.055f, 0.05f}, 0.5f));
    constexpr float kTooth = 0.021f;  // of the radius for each tooth
    const auto wheel = [&](Vec3f at, int teeth, float phase, int material) {
        const float r = kTooth * static_cast<float>(teeth) / 2.f + 0.02f, tooth = 0.026f;
        std::vector<Vec2f> outline;
        for (int i = 0; i < teeth; ++i)
            for (const auto& [part, out] : {std::pair{0.f, 0.f}, std::pair{0.32f, 0.f}, std::pair{0.44f, 1.f},
                                            std::pair{0.8f, 1.f}, std::pair{0.92f, 0.f}}) {
                const float a = kTau * (static_cast<float>(i) + part + phase) / static_cast<float>(teeth),
                            d = r - 0.5f * tooth + tooth * out;
                outline.push_back({d * std::sin(a), -d * std::cos(a)});
            }
        // The rim, in pieces, so that one sees between the spokes.
        const float hole = 0.68f * r, thick = 0.018f;
        Mesh rim;
        const auto face = [&](std::array<Vec3f, 4> corner, Vec3f normal) {
            const auto first = static_cast<std::uint32_t>(rim.positions.size());
            for (const Vec3f& c : corner) rim.positions.push_back(c), rim.normals.push_back(normal);
            const bool turned = dot(cross(corner[1] - corner[0], corner[2] - corner[0]), normal) < 0;
            for (const std::array<std::uint32_t, 3> t : {std::array<std::uint32_t, 3>{0, 1, 2}, {0, 2, 3}})
                rim.triangles.insert(rim.triangles.end(),
                                     {first + t[0], first + t[turned ? 2 : 1], first + t[turned ? 1 : 2]});
        };
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const Vec2f p = outline[i], q = outline[(i + 1) % outline.size()];
            const Vec2f pi = p * (hole / std::hypot(p.x, p.y)), qi = q * (hole / std::hypot(q.x, q.y)),
                        middle = (p + q) * 0.5f;
            const auto on = [](Vec2f v, float z) { return Vec3f{v.x, v.y, z}; };
            for (const float z : {-thick, thick})
                face({on(p, z), on(q, z), on(qi, z), on(pi, z)}, {0, 0, z > 0 ? 1.f : -1.f});
            Vec3f out = normalize(Vec3f{q.y - p.y, p.x - q.x, 0});
            if (dot(out, on(middle, 0)) < 0) out = out * -1.f;
            face({on(p, -thick), on(q, -thick), on(q, thick), on(p, thick)}, out);
            face({on(pi, -thick), on(qi, -thick), on(qi, thick), on(pi, thick)}, normalize(on(middle, 0)) * -1.f);
        }
        shapes::lay_grain(rim);
        k.add(std::move(rim), material, at);
        const int spokes = teeth > 20 ? 6 : 4;
        for (int i = 0; i < spokes; ++i) {
            const float a = kTau * static_cast<float>(i) / static_cast<float>(spokes) + phase;
            k.rod(material, at, at + Vec3f{0.74f * r * std::sin(a), 0.74f * r * std::cos(a), 0}, 0.09f * r, 0.07f * r,
                  10);
        }
        k.rod(material, at - Vec3f{0, 0, 0.024f}, at + Vec3f{0, 0, 0.026f}, 0.24f * r, -1, 24);
        k.rod(iron, {at.x, at.y, 0}, at + Vec3f{0, 0, 0.04f}, 0.09f * r, -1, 14);
        return r;
    };
    const Vec3f middle{-0.1f, 0.42f, 0.05f};
    const float large = wheel(middle, 30, 0.f, metal);
    const auto beside = [&](int teeth, float angle, float z, float phase, int material) {
        const float r = kTooth * static_cast<float>(teeth) / 2.f + 0.02f, far = large + r;
        return wheel({middle.x + far * std::cos(angle), middle.y + far * std::sin(angle), z}, teeth, phase, material);
    };
    beside(18, 0.55f, 0.05f, 0.5f, copper);
    beside(12, 2.2f, 0.05f, 0.2f, iron);
    beside(14, -0.75f, 0.05f, 0.35f, metal);
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.25f;
}

// Threads across a corner under the ceiling: spokes from the corner, and arcs that sag between them. Its walls are at
// -x and -z.
void cobweb(Kit& k) {
    const int silk = k.main(plain("cobweb", {0.62f, 0.61f, 0.58f}, 0.95f));
    const float size = 0.62f;
    const Vec3f corner{0, 0, 0};
    // Where spokes end: along the wall's upper edges and down the corner.
    std::vector<Vec3f> ends;
    for (const float t : {0.f, 0.25f, 0.5f, 0.75f, 1.f})
        ends.push_back(
            Vec3f{size * (1 - t), -0.01f - 0.9f * size * t * (0.3f + 0.7f * t), 0.012f + 0.1f * t * (1 - t)});
    for (const float t : {0.25f, 0.5f, 0.75f, 1.f})
        ends.push_back(
            Vec3f{0.012f + 0.1f * t * (1 - t), -0.01f - 0.9f * size * (1 - t) * (0.3f + 0.7f * (1 - t)), size * t});
    for (const Vec3f& end : ends) k.rod(silk, corner - Vec3f{0, 0.004f, 0}, end, 0.0022f, -1, 5);
    Mesh arcs;
    for (int ring = 1; ring <= 9; ++ring) {
        const float far = 0.1f + 0.1f * static_cast<float>(ring);
        for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
            if (k.dice.chance(0.12f)) continue;  // torn
            const Vec3f a = ends[i] * far, b = ends[i + 1] * far, sag = (a + b) * 0.5f * 0.86f;
            const std::array<Vec3f, 4> path{a, lerp(a, sag, 0.75f), lerp(b, sag, 0.75f), b};
            shapes::append(arcs, shapes::tube(path, 0.0018f, 4));
        }
    }
    // Next to the corner it is so old that dust has made a film of it, torn at its edge.
    Material film = plain("dusty web", {0.5f, 0.49f, 0.46f}, 0.95f);
    film.transmission = 0.5f;
    const std::uint32_t seed = k.seed();
    k.add(shapes::slab(24, 4, 0.001f,
                       [&](float u, float v) {
                           const float at = u * static_cast<float>(ends.size() - 1),
                                       far = (0.66f + 0.14f * shapes::wobble({u * 11, 0, 0}, seed)) *
                                             (0.04f + 0.96f * v);
                           const auto i = std::min(static_cast<std::size_t>(at), ends.size() - 2);
                           return lerp(ends[i], ends[i + 1], at - static_cast<float>(i)) *
                                  (far * (1.f - 0.05f * std::sin(kPi * (at - std::floor(at)))));
                       }),
          k.material(film));
    // A few that hang down, with dust on them.
    for (int i = 0; i < 5; ++i) {
        const Vec3f from = ends[static_cast<std::size_t>(k.dice.index(static_cast<int>(ends.size())))] *
                           k.dice.uniform(0.5f, 0.95f);
        const std::array<Vec3f, 3> path{from, from + Vec3f{0.01f, -0.09f, 0.006f},
                                        from + Vec3f{0.004f, -k.dice.uniform(0.14f, 0.24f), 0.012f}};
        shapes::append(arcs, shapes::tube(path, 0.0018f, 4));
    }
    k.add(std::move(arcs), silk);
    k.piece.mount = Mount::ceiling;
}

// A rail on the wall with pots and pans on hooks.
void hung_pans(Kit& k) {
    const int metal = k.main(*material_named("copper")),
              iron = k.material(plain("wrought iron", {0.035f, 0.034f, 0.033f}, 0.5f));
    const float half = 0.48f, rail = 0.5f, off = 0.075f;
    k.rod(iron, {-half, rail, off}, {half, rail, off}, 0.009f, -1, 10);
    for (const float sx : {-0.8f, 0.8f}) k.rod(iron, {sx * half, rail, 0}, {sx * half, rail, off}, 0.009f, -1, 10);
    for (int i = 0; i < 5; ++i) {
        const float x = (static_cast<float>(i) - 2.f) * 0.19f,
                    r = std::array{0.082f, 0.07f, 0.09f, 0.062f, 0.078f}[static_cast<std::size_t>(i)] *
                        k.dice.uniform(0.94f, 1.05f),
                    deep = i % 2 == 0 ? 0.042f : 0.075f, down = rail - 0.035f, long_ = 0.16f + 0.05f * k.dice.uniform();
        k.rod(iron, {x, rail, off + 0.008f}, {x, down, off + 0.008f}, 0.004f, -1, 6);
        // Its open side to the wall: one sees the polished bottom.
        const Vec3f middle{x, down - long_ - r, 0};
        k.rod(metal, {x, down + 0.004f, off - 0.01f}, {middle.x, middle.y + 0.96f * r, off - 0.006f}, 0.008f, 0.011f,
              8);
        const std::array<Vec2f, 5> bowl{
            Vec2f{0.78f * r, 0.f}, {0.9f * r, 0.006f}, {0.97f * r, 0.02f}, {r, deep}, {r + 0.004f, deep + 0.004f}};
        Mesh pan = shapes::vessel(bowl, 0.004f, 28);
        shapes::turn(pan, {1, 0, 0}, -90);
        k.add(std::move(pan), metal, {middle.x, middle.y, deep + 0.012f});
    }
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.32f;
}

// A table with drawers to either side, a mirror on it, and what one needs before it.
void dressing_table(Kit& k) {
    const Vec3f s = k.wanted({1.1f, 0.76f, 0.45f});
    const int wood = k.main(k.style.wood), metal = k.material(k.style.metal),
              frame = k.material(k.style.mouldings == Mouldings::rich ? k.style.metal : k.style.wood);
    Material silvered = plain("mirror", {0.85f, 0.85f, 0.85f}, 0.05f);
    silvered.mirror = 1.f;
    const int silver = k.material(silvered);
    const float hx = 0.5f * s.x, hz = 0.5f * s.z, low = s.y - 0.2f;
    legs(k, wood, hx - 0.05f, hz - 0.05f, low + 0.01f, 0.045f);
    k.board(wood, {0, s.y - 0.028f, 0}, {s.x, 0.028f, s.z}, 0.006f);
    for (const float sx : {-1.f, 1.f}) {
        const float cx = sx * (hx - 0.19f);
        k.board(wood, {cx, low, -0.01f}, {0.34f, 0.172f, s.z - 0.06f}, 0.004f);
        fronts(k, wood, metal, cx - 0.165f, cx + 0.165f, low + 0.004f, s.y - 0.032f, hz - 0.04f, 1, 1);
    }
    k.board(wood, {0, s.y - 0.1f, -0.02f}, {s.x - 0.7f, 0.07f, s.z - 0.1f}, 0.003f);
    // An oval mirror between two posts.
    const float wide = 0.5f, high = 0.66f, foot = s.y + 0.03f, z = -hz + 0.05f;
    std::vector<Vec2f> oval;
    for (int i = 0; i < 48; ++i) {
        const float a = kTau * static_cast<float>(i) / 48.f;
        oval.push_back({0.5f * wide * std::cos(a), 0.5f * high * std::sin(a)});
    }
    Mesh pane = shapes::prism(oval, -0.004f, 0.004f, 0.001f);
    shapes::turn(pane, {1, 0, 0}, 90);
    k.add(std::move(pane), silver, {0, foot + 0.5f * high, z + 0.008f});
    std::vector<Vec3f> rim;
    for (const Vec2f p : oval) rim.push_back({p.x, foot + 0.5f * high + p.y, z + 0.006f});
    rim.push_back(rim.front());
    k.add(shapes::tube(rim, 0.016f, 10), frame);
    k.board(frame, {0, s.y, z}, {0.3f, 0.04f, 0.06f}, 0.008f);
    // Bottles and a jar beside it.
    for (int i = 0; i < 4; ++i) {
        const float x = (i % 2 ? 1.f : -1.f) * (0.3f + 0.07f * static_cast<float>(i / 2)),
                    h = k.dice.uniform(0.06f, 0.14f), r = k.dice.uniform(0.016f, 0.026f);
        const std::array<Vec2f, 5> bottle{
            Vec2f{r, 0}, {r, 0.7f * h}, {0.4f * r, 0.8f * h}, {0.4f * r, h}, {0.2f * r, h}};
        k.add(shapes::lathe(bottle, 20, false),
              k.material(plain("perfume", lerp(k.accent(), {0.7f, 0.6f, 0.55f}, 0.4f), 0.12f)),
              {x, s.y, -0.25f * hz + 0.04f * static_cast<float>(i % 3)});
    }
    k.piece.surfaces.push_back({{0, s.y, 0.35f * hz}, {0.8f * hx, 0.3f * hz}});
    k.piece.against_wall = true;
    k.piece.clearance_front_m = 0.75f;
}

constexpr Entry kWished[] = {{"christmas_tree", christmas_tree},
                             {"rocking_chair", rocking_chair},
                             {"hammock", hammock},
                             {"cot_mobile", cot_mobile},
                             {"clothes_horse", clothes_horse},
                             {"pipes", pipes},
                             {"gears", gears},
                             {"cobweb", cobweb},
                             {"hung_pans", hung_pans},
                             {"dressing_table", dressing_table}};

}  // namespace

std::span<const Entry> wished() { return kWished; }

}  // namespace fastscene::furniture

// An airfield, from the windows of a terminal: stands with airliners and jet bridges, a taxiway, a runway. Both sides
// of the building look out on the same, as those of a pier do.
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <vector>

#include "fastscene/trace/outdoors_buildings.h"
#include "fastscene/trace/outdoors_site_parts.h"

namespace fastscene::outdoors {
namespace {

// Metres ahead of the window.
constexpr float kServiceRoad_m = 16.f, kNose_m = 24.f, kTaxiway_m = 104.f, kTaxiwayHalf_m = 11.5f, kApronEnd_m = 88.f,
                kRunway_m = 236.f, kRunwayHalf_m = 22.5f, kWoods_m = 430.f;
constexpr float kStand_m = 42.f;      // from one stand to the next; the window is between two
constexpr float kHallFloor_m = 4.6f;  // of the hall above the apron, and of the bridges

float off_stand(float right) {
    const float t = right / kStand_m;
    return std::abs(t - std::floor(t) - 0.5f) * kStand_m;
}

Vec3f airfield_albedo(Vec2f q, float footprint, std::uint32_t seed, bool snow) {
    const float ahead = std::abs(q.y), grain = 0.86f + 0.28f * fbm2(q * 1.3f, 5, 1.3f * footprint, seed),
                stain = fbm2(q * 0.11f, 4, 0.11f * footprint, seed + 2);
    const Vec3f yellow{0.55f, 0.4f, 0.04f}, white{0.6f, 0.6f, 0.58f};
    const auto painted = [&](Vec3f ground, Vec3f paint, float off, float half) {
        return lerp(ground, paint, 0.85f * line_cover(std::abs(off), half, footprint));
    };
    const bool taxiway = std::abs(ahead - kTaxiway_m) < kTaxiwayHalf_m,
               runway = std::abs(ahead - kRunway_m) < kRunwayHalf_m;
    if (ahead > kApronEnd_m && !taxiway && !runway)
        return snow ? snow_albedo(q, footprint, seed) : lawn_albedo(q, footprint, seed) * Vec3f{1.15f, 1.05f, 1.f};
    if (taxiway || runway) {
        Vec3f ground = Vec3f{0.088f, 0.088f, 0.09f} * (grain * (0.8f + 0.4f * stain));
        if (taxiway) {
            ground = painted(ground, yellow, ahead - kTaxiway_m, 0.2f);
            return painted(ground, yellow, std::abs(ahead - kTaxiway_m) - kTaxiwayHalf_m + 0.8f, 0.15f);
        }
        // Rubber where wheels touch down, a dashed line in the middle, lines along the edges.
        ground = ground * (1 - 0.4f * std::exp(-std::abs(std::abs(ahead - kRunway_m) - 5.f) * 0.3f));
        if (std::abs(std::fmod(std::abs(q.x) + 15.f, 50.f)) < 30)
            ground = painted(ground, white, ahead - kRunway_m, 0.45f);
        return painted(ground, white, std::abs(ahead - kRunway_m) - kRunwayHalf_m + 1.2f, 0.45f);
    }
    // Slabs of concrete, oil below the engines and where wheels stand.
    const float x = q.x / 7.5f, y = q.y / 7.5f;
    const float tone = 0.93f + 0.14f * lattice_unit(floor_int(x), floor_int(y), 2, seed);
    Vec3f ground = Vec3f{0.33f, 0.325f, 0.31f} * (grain * tone * (0.84f + 0.3f * stain));
    const auto joint = [&](float v) { return std::abs(v - std::round(v)) * 7.5f; };
    ground = painted(ground, ground * 0.55f, std::min(joint(x), joint(y)), 0.025f);
    const float lane = off_stand(q.x);
    if (ahead > kNose_m - 6) {
        ground = ground * (1 - 0.45f * std::exp(-lane * lane * 0.12f) * fbm2(q * 0.5f, 4, 0.5f * footprint, seed + 7));
        ground = painted(ground, yellow, lane, 0.12f);
        if (lane < 3) ground = painted(ground, yellow, ahead - kNose_m - 5, 0.12f);
    }
    for (const float side : {-1.f, 1.f}) {
        const float off = ahead - kServiceRoad_m - 3.4f * side;
        ground = painted(ground, white, off, 0.08f);
    }
    if (std::fmod(std::abs(q.x), 5.f) < 2.5f) ground = painted(ground, white, ahead - kServiceRoad_m, 0.06f);
    return painted(ground, {0.45f, 0.04f, 0.03f}, ahead - kNose_m + 2.2f, 0.12f);
}

// ---- parts

// Between two points at one height.
void add_tunnel(QuadMesh& mesh, Vec3f from, Vec3f to, float half, float high, std::uint16_t wall, std::uint16_t pane) {
    const Vec3f along = normalize(to - from), across{along.z * half, 0, -along.x * half}, up{0, high, 0};
    mesh.quad(from - across, to - across, to + across, from + across, wall);
    mesh.quad(from - across + up, to - across + up, to + across + up, from + across + up, wall);
    for (const float hand : {-1.f, 1.f}) {
        const Vec3f a = from + across * hand, b = to + across * hand;
        mesh.quad(a, b, b + up * 0.38f, a + up * 0.38f, wall);
        mesh.quad(a + up * 0.38f, b + up * 0.38f, b + up * 0.76f, a + up * 0.76f, pane);
        mesh.quad(a + up * 0.76f, b + up * 0.76f, b + up, a + up, wall);
    }
    for (const Vec3f end : {from, to})
        mesh.quad(end - across, end + across, end + across + up, end - across + up, wall);
}

// A twin-engined airliner, 37.5 m long: its nose along +z, wheels on the ground.
struct Livery {
    Vec3f body, belly, tail, second;
};
constexpr float kAirliner_m = 37.5f, kWingSpan_m = 34.f;
constexpr int kFuselageSides = 40;

struct FuselageRib {
    float z, radius, middle;
};
constexpr std::array<FuselageRib, 14> kFuselage{{{18.7f, 0.06f, 3.25f},
                                                 {18.4f, 0.5f, 3.28f},
                                                 {17.7f, 0.98f, 3.4f},
                                                 {16.7f, 1.42f, 3.58f},
                                                 {15.5f, 1.74f, 3.76f},
                                                 {14.f, 1.93f, 3.9f},
                                                 {12.f, 1.975f, 3.95f},
                                                 {-7.f, 1.975f, 3.95f},
                                                 {-10.f, 1.86f, 4.06f},
                                                 {-12.5f, 1.6f, 4.28f},
                                                 {-15.f, 1.2f, 4.62f},
                                                 {-17.f, 0.78f, 4.96f},
                                                 {-18.3f, 0.42f, 5.2f},
                                                 {-18.8f, 0.2f, 5.28f}}};

void add_fuselage(QuadMesh& mesh, std::uint16_t body, std::uint16_t belly, std::uint16_t line, std::uint16_t dark) {
    const auto at = [](const FuselageRib& rib, int k, float out = 1.f) {
        const float a = 2 * kPi * static_cast<float>(k) / kFuselageSides;  // from the top
        return Vec3f{out * rib.radius * std::sin(a), rib.middle + out * rib.radius * std::cos(a), rib.z};
    };
    for (std::size_t i = 0; i + 1 < kFuselage.size(); ++i)
        for (int k = 0; k < kFuselageSides; ++k) {
            const float up = std::cos(2 * kPi * (static_cast<float>(k) + 0.5f) / kFuselageSides);
            const bool cockpit = i == 3 && up > 0.36f && up < 0.86f;
            mesh.quad(at(kFuselage[i], k), at(kFuselage[i], k + 1), at(kFuselage[i + 1], k + 1),
                      at(kFuselage[i + 1], k),
                      cockpit       ? dark
                      : up < -0.45f ? belly
                      : up < -0.3f  ? line
                                    : body);
        }
    // Windows and doors, a little outside of the skin.
    const auto patch = [&](float side, float z, float wide, float y0, float y1, std::uint16_t paint) {
        const auto on = [&](float y, float along) {
            const float up = (y - 3.95f) / 1.975f;
            return Vec3f{side * 1.985f * std::sqrt(std::max(0.f, 1 - up * up)), y, z + along};
        };
        mesh.quad(on(y0, 0), on(y0, wide), on(y1, wide), on(y1, 0), paint);
    };
    for (const float side : {-1.f, 1.f}) {
        for (float z = -8.5f; z < 11.6f; z += 0.53f) patch(side, z, 0.26f, 4.3f, 4.66f, dark);
        for (const float z : {12.4f, -9.9f}) {
            for (const float edge : {0.f, 0.85f}) patch(side, z + edge, 0.05f, 3.4f, 5.2f, line);
            for (const float y : {3.4f, 5.15f}) patch(side, z, 0.9f, y, y + 0.05f, line);
        }
    }
}

// A wing or a fin: between a section at its root and one at its tip; `across` is half the thickness.
struct WingSection {
    Vec3f front, back, across;
};
void add_wing(QuadMesh& mesh, const WingSection& root, const WingSection& tip, std::uint16_t paint) {
    const auto thick = [](const WingSection& s, float side) { return lerp(s.front, s.back, 0.3f) + s.across * side; };
    for (const float side : {-1.f, 1.f}) {
        mesh.quad(root.front, tip.front, thick(tip, side), thick(root, side), paint);
        mesh.quad(thick(root, side), thick(tip, side), tip.back, root.back, paint);
    }
    mesh.quad(tip.front, thick(tip, 1), tip.back, thick(tip, -1), paint);
}

void add_engine(QuadMesh& mesh, float x, std::uint16_t cowl, std::uint16_t metal, std::uint16_t dark) {
    constexpr float kHigh = 1.95f;
    constexpr int kSides = 26;
    constexpr std::array<std::array<float, 2>, 6> kProfile{
        // z, radius
        {{4.1f, 0.98f}, {3.9f, 1.1f}, {2.6f, 1.17f}, {1.2f, 1.08f}, {0.1f, 0.82f}, {-0.9f, 0.45f}}};
    const auto at = [&](std::size_t i, int k) {
        const float a = 2 * kPi * static_cast<float>(k) / kSides;
        return Vec3f{x + kProfile[i][1] * std::sin(a), kHigh + kProfile[i][1] * std::cos(a), kProfile[i][0]};
    };
    for (std::size_t i = 0; i + 1 < kProfile.size(); ++i)
        for (int k = 0; k < kSides; ++k)
            mesh.quad(at(i, k), at(i, k + 1), at(i + 1, k + 1), at(i + 1, k), i == 0 || i == 4 ? metal : cowl);
    const Vec3f fan{x, kHigh, 3.7f};
    for (int k = 0; k < kSides; ++k) {
        const Vec3f a = at(0, k), b = at(0, k + 1);
        mesh.quad(fan, {a.x, a.y, 3.7f}, {b.x, b.y, 3.7f}, {b.x, b.y, 3.7f}, dark);
    }
    add_tube(mesh, fan, {x, kHigh, 4.05f}, 0.28f, 0.04f, 12, metal);
    mesh.quad({x, 3.f, 2.6f}, {x, 3.3f, 0.2f}, {x, 2.5f, -0.6f}, {x, 2.9f, 2.6f}, cowl);
}

QuadMesh build_airliner(World& world, const Livery& livery) {
    QuadMesh mesh;
    const auto gloss = [&](Vec3f color) { return world.add({Finish::matt, color, {}, 0.04f, false, false}); };
    const std::uint16_t body = gloss(livery.body), belly = gloss(livery.belly), tail = gloss(livery.tail),
                        second = gloss(livery.second), wing = gloss({0.42f, 0.43f, 0.44f}),
                        metal = gloss({0.5f, 0.51f, 0.52f}), dark = gloss({0.015f, 0.016f, 0.02f}),
                        tyre = gloss({0.02f, 0.02f, 0.021f});
    add_fuselage(mesh, body, belly, tail, dark);
    for (const float side : {-1.f, 1.f}) {
        const auto p = [&](float x, float y, float z) { return Vec3f{side * x, y, z}; };
        const WingSection root{p(1.6f, 2.9f, 4.6f), p(1.6f, 2.8f, -2.6f), {0, 0.46f, 0}},
            kink{p(6.f, 3.35f, 1.4f), p(6.f, 3.3f, -2.5f), {0, 0.3f, 0}},
            tip{p(0.5f * kWingSpan_m, 4.5f, -4.2f), p(0.5f * kWingSpan_m, 4.45f, -5.8f), {0, 0.1f, 0}},
            end{p(0.5f * kWingSpan_m + 0.45f, 6.7f, -5.9f),
                p(0.5f * kWingSpan_m + 0.45f, 6.7f, -6.6f),
                {side * 0.05f, 0, 0}};
        add_wing(mesh, root, kink, wing), add_wing(mesh, kink, tip, wing), add_wing(mesh, tip, end, tail);
        add_wing(mesh, {p(0.8f, 4.9f, -14.2f), p(0.8f, 4.9f, -17.6f), {0, 0.2f, 0}},
                 {p(6.2f, 5.5f, -17.2f), p(6.2f, 5.5f, -18.7f), {0, 0.06f, 0}}, wing);
        add_engine(mesh, side * 5.75f, livery.second.x > 0.3f ? body : second, metal, dark);
        // Main wheels.
        add_tube(mesh, p(3.8f, 3.f, -1.6f), p(3.8f, 0.6f, -1.6f), 0.14f, 0.12f, 10, metal);
        for (const float off : {-0.5f, 0.25f}) {
            add_tube(mesh, p(3.8f + off, 0.58f, -1.6f), p(3.8f + off + 0.3f, 0.58f, -1.6f), 0.58f, 0.58f, 18, tyre);
            add_tube(mesh, p(3.8f + off - 0.01f, 0.58f, -1.6f), p(3.8f + off + 0.31f, 0.58f, -1.6f), 0.26f, 0.26f, 12,
                     metal);
        }
    }
    add_tube(mesh, {0, 2.6f, 13.6f}, {0, 0.4f, 13.9f}, 0.11f, 0.1f, 10, metal);
    for (const float off : {-0.42f, 0.18f})
        add_tube(mesh, {off, 0.4f, 13.9f}, {off + 0.24f, 0.4f, 13.9f}, 0.4f, 0.4f, 16, tyre);
    // The fin: its color, and a band of the second one.
    const WingSection fin_root{{0, 5.6f, -10.9f}, {0, 5.5f, -17.4f}, {0.22f, 0, 0}},
        fin_tip{{0, 11.9f, -16.9f}, {0, 11.9f, -19.2f}, {0.08f, 0, 0}};
    const auto fin = [&](float t) {
        return WingSection{lerp(fin_root.front, fin_tip.front, t), lerp(fin_root.back, fin_tip.back, t),
                           lerp(fin_root.across, fin_tip.across, t)};
    };
    add_wing(mesh, fin(0), fin(0.42f), tail), add_wing(mesh, fin(0.42f), fin(0.62f), second);
    add_wing(mesh, fin(0.62f), fin(1), tail);
    return mesh;
}

// From the terminal to the left forward door of an airliner that stands with its nose towards it. Metres to the right
// and ahead are x and z.
QuadMesh build_bridge(World& world, float stand, float paint_hue) {
    QuadMesh mesh;
    const std::uint16_t
        wall = world.add(
            {Finish::matt, lerp(Vec3f{0.46f, 0.47f, 0.48f}, {0.2f, 0.28f, 0.4f}, paint_hue), {}, 0.1f, false, false}),
        pane = world.add({Finish::matt, {0.06f, 0.08f, 0.1f}, {}, 0, false, false}),
        steel = world.add({Finish::matt, {0.3f, 0.3f, 0.29f}, {}, 0.1f});
    constexpr float kHigh = 2.6f, kSill = 3.3f;  // of the tunnel; of its floor at the door
    const float door_x = stand + 2.9f, door_z = kNose_m + 5.6f;
    const Vec3f hub{stand + 7.5f, kHallFloor_m - 0.6f, 14.f}, head{door_x, kSill, door_z};
    add_tube(mesh, {hub.x, 0, hub.z}, {hub.x, hub.y, hub.z}, 0.8f, 0.8f, 16, steel);
    for (const auto& [low, high, paint] : {std::tuple{0.f, 1.f, wall}, {1.f, 2.1f, pane}, {2.1f, kHigh + 0.3f, wall}})
        add_tube(mesh, hub + Vec3f{0, low, 0}, hub + Vec3f{0, high, 0}, 1.8f, 1.8f, 22, paint);
    add_tunnel(mesh, {hub.x + 2, hub.y, 8}, hub, 1.4f, kHigh, wall, pane);
    const Vec3f joint = lerp(hub, head, 0.55f);
    add_tunnel(mesh, hub, joint, 1.6f, kHigh + 0.25f, wall, pane);
    add_tunnel(mesh, joint, head, 1.35f, kHigh, wall, pane);
    add_tunnel(mesh, head + Vec3f{0.9f, -0.1f, 0.2f}, head + Vec3f{-0.9f, -0.1f, 0.2f}, 1.6f, kHigh + 0.2f, steel,
               pane);
    const Vec3f leg = lerp(hub, head, 0.8f);
    for (const float side : {-1.f, 1.f}) {
        add_tube(mesh, {leg.x + 1.6f * side, 0.5f, leg.z}, {leg.x + 1.6f * side, leg.y + 1.f, leg.z}, 0.16f, 0.16f, 10,
                 steel);
        add_tube(mesh, {leg.x + 1.4f * side - 0.2f, 0.5f, leg.z}, {leg.x + 1.4f * side + 0.2f, 0.5f, leg.z}, 0.5f, 0.5f,
                 16, pane);
    }
    add_box(mesh, {leg.x - 1.7f, 0.6f, leg.z - 0.3f}, {leg.x + 1.7f, 1.1f, leg.z + 0.3f}, steel);
    return mesh;
}

// A tractor with carts, 2 m each along x; a lorry.
QuadMesh build_baggage_train(World& world, Random& r) {
    QuadMesh mesh;
    const std::uint16_t cab = world.add({Finish::matt, {0.55f, 0.4f, 0.04f}}),
                        cart = world.add({Finish::matt, {0.2f, 0.21f, 0.22f}}),
                        tyre = world.add({Finish::matt, {0.02f, 0.02f, 0.02f}});
    const auto wheels = [&](float x) {
        for (const float off : {0.5f, 1.6f})
            for (const float z : {-0.75f, 0.6f})
                add_tube(mesh, {x + off, 0.28f, z}, {x + off, 0.28f, z + 0.15f}, 0.28f, 0.28f, 12, tyre);
    };
    add_box(mesh, {0, 0.3f, -0.7f}, {2.2f, 0.85f, 0.7f}, cab);
    add_box(mesh, {0.2f, 0.85f, -0.65f}, {0.9f, 1.8f, 0.65f}, cart);
    wheels(0);
    for (int i = 0; i < 3; ++i) {
        const float x = -2.7f - 2.7f * static_cast<float>(i);
        add_box(mesh, {x, 0.4f, -0.75f}, {x + 2.2f, 0.52f, 0.75f}, cart);
        wheels(x);
        for (int k = 0; k < 6; ++k) {
            const Vec3f at{x + 0.1f + 0.7f * static_cast<float>(k % 3), 0.52f, k < 3 ? -0.7f : 0.05f};
            const Vec3f hue{r.uniform(0.02f, 0.3f), r.uniform(0.02f, 0.2f), r.uniform(0.02f, 0.3f)};
            add_box(mesh, at, at + Vec3f{0.6f, r.uniform(0.35f, 0.8f), 0.62f}, world.add({Finish::matt, hue}));
        }
    }
    return mesh;
}
QuadMesh build_lorry(World& world, Vec3f color) {
    QuadMesh mesh;
    const std::uint16_t box = world.add({Finish::matt, color}), cab = world.add({Finish::matt, {0.55f, 0.55f, 0.54f}}),
                        dark = world.add({Finish::matt, {0.02f, 0.02f, 0.024f}});
    add_box(mesh, {-3.4f, 0.7f, -1.2f}, {1.8f, 3.2f, 1.2f}, box);
    add_box(mesh, {1.9f, 0.5f, -1.15f}, {3.6f, 1.5f, 1.15f}, cab);
    add_box(mesh, {1.95f, 1.5f, -1.1f}, {3.4f, 2.3f, 1.1f}, dark);
    add_box(mesh, {1.95f, 2.3f, -1.1f}, {3.3f, 2.4f, 1.1f}, cab);
    for (const float x : {-2.4f, 2.7f})
        for (const float z : {-1.2f, 0.85f}) add_tube(mesh, {x, 0.5f, z}, {x, 0.5f, z + 0.35f}, 0.5f, 0.5f, 16, dark);
    return mesh;
}

QuadMesh build_control_tower(World& world) {
    QuadMesh mesh;
    const std::uint16_t shaft = world.add({Finish::matt, {0.5f, 0.49f, 0.47f}, {}, 0.2f}),
                        pane = world.add({Finish::matt, {0.05f, 0.09f, 0.1f}, {}, 0, false, false});
    add_tube(mesh, {0, 0, 0}, {0, 34, 0}, 3.4f, 2.6f, 20, shaft);
    add_tube(mesh, {0, 34, 0}, {0, 37, 0}, 3.f, 6.f, 20, shaft);
    add_tube(mesh, {0, 37, 0}, {0, 41, 0}, 5.6f, 6.4f, 20, pane);
    add_tube(mesh, {0, 41, 0}, {0, 42, 0}, 6.8f, 6.2f, 20, shaft);
    add_tube(mesh, {0, 42, 0}, {0, 42.1f, 0}, 6.2f, 0.1f, 20, shaft);
    add_tube(mesh, {0, 42, 0}, {0, 49, 0}, 0.2f, 0.1f, 8, kIron);
    return mesh;
}
QuadMesh build_hangar(World& world) {
    QuadMesh mesh;
    const std::uint16_t wall = world.add({Finish::matt, {0.42f, 0.44f, 0.46f}, {}, 0.15f}),
                        door = world.add({Finish::matt, {0.1f, 0.14f, 0.2f}, {}, 0.1f});
    constexpr float kHalf = 32, kWall = 12, kRise = 6, kDeep = 50;
    add_box(mesh, {-kHalf, 0, 0}, {kHalf, kWall, kDeep}, wall);
    add_box(mesh, {-kHalf + 6, 0, -0.2f}, {kHalf - 6, kWall - 2, 0}, door);
    constexpr int kSteps = 12;
    const auto crest = [&](int k, float z) {
        const float x = -1 + 2 * static_cast<float>(k) / kSteps;
        return Vec3f{kHalf * x, kWall + kRise * (1 - x * x), z};
    };
    for (int k = 0; k < kSteps; ++k) {
        mesh.quad(crest(k, 0), crest(k + 1, 0), crest(k + 1, kDeep), crest(k, kDeep), wall);
        const Vec3f a = crest(k, 0), b = crest(k + 1, 0);
        mesh.quad({a.x, kWall, 0}, a, b, {b.x, kWall, 0}, wall);
    }
    return mesh;
}

}  // namespace

void lay_out_airfield(Site& site) {
    World& world = site.world;
    world.eye_m = kHallFloor_m + 1.6f;
    const std::uint32_t seed = site.sky.seed;
    const bool snow = site.sky.snow;
    world.height = [](Vec2f) { return 0.f; };
    world.ground = [seed, snow, layout = Layout(site.facing)](Vec3f at, float footprint) {
        return airfield_albedo(layout.laid_out({at.x, at.z}), footprint, seed, snow);
    };
    Random& r = site.random;
    constexpr std::array<Livery, 4> kLiveries{{
        {{0.7f, 0.7f, 0.7f}, {0.5f, 0.51f, 0.52f}, {0.02f, 0.05f, 0.24f}, {0.6f, 0.06f, 0.05f}},
        {{0.72f, 0.72f, 0.71f}, {0.55f, 0.55f, 0.55f}, {0.55f, 0.03f, 0.03f}, {0.7f, 0.7f, 0.68f}},
        {{0.66f, 0.68f, 0.69f}, {0.03f, 0.22f, 0.26f}, {0.02f, 0.26f, 0.3f}, {0.6f, 0.5f, 0.06f}},
        {{0.7f, 0.68f, 0.62f}, {0.62f, 0.36f, 0.03f}, {0.66f, 0.36f, 0.02f}, {0.03f, 0.04f, 0.09f}},
    }};
    std::vector<std::uint32_t> airliners;
    for (const Livery& livery : kLiveries) airliners.push_back(world.add(build_airliner(world, livery)));
    std::vector<std::uint32_t> lorries;
    for (const Vec3f color : {Vec3f{0.6f, 0.6f, 0.6f}, Vec3f{0.1f, 0.2f, 0.4f}, Vec3f{0.5f, 0.1f, 0.06f}})
        lorries.push_back(world.add(build_lorry(world, color)));
    const std::uint32_t baggage = world.add(build_baggage_train(world, r)),
                        tower = world.add(build_control_tower(world)), hangar = world.add(build_hangar(world));
    std::size_t next = static_cast<std::size_t>(r.index(4));
    const auto airliner = [&] { return airliners[next++ % airliners.size()]; };
    constexpr int kStands = 5;  // to either side
    for (const float side : {1.f, -1.f}) {
        const float facing = site.facing + (side > 0 ? 0 : kPi);
        const Layout here(facing);
        for (int k = -kStands; k < kStands; ++k) {
            const float stand = kStand_m * (static_cast<float>(k) + 0.5f);
            world.stand(world.add(build_bridge(world, stand, k % 2 == 0 ? 0.f : 0.5f)), {0, 0}, facing);
            // The stands beside the window are taken, one in four of the others is free.
            if (k < -1 || k > 0)
                if (r.chance(0.25f)) continue;
            world.stand(airliner(), here.place(stand, kNose_m + 0.5f * kAirliner_m), facing + kPi);
            world.stand(baggage, here.place(stand + r.uniform(8, 11), kNose_m + r.uniform(15, 24)),
                        facing + 0.5f * kPi + r.uniform(-0.2f, 0.2f));
            world.stand(lorries[static_cast<std::size_t>(r.index(3))],
                        here.place(stand - r.uniform(7, 10), kNose_m + r.uniform(2, 9)),
                        facing + r.uniform(-0.5f, 0.5f));
        }
        world.stand(lorries[static_cast<std::size_t>(r.index(3))], here.place(r.uniform(-14, 4), kServiceRoad_m + 1.7f),
                    facing);
        world.stand(airliner(), here.place(r.uniform(-70, 30), kTaxiway_m),
                    facing + (r.chance(0.5f) ? 0.5f : -0.5f) * kPi);
        world.stand(airliner(), here.place(r.uniform(-120, 120), kRunway_m), facing + 0.5f * kPi);
        // Floodlights stand between the stands, at the edge of the apron.
        for (int k = -kStands; k <= kStands; ++k) {
            const Vec2f at = here.place(kStand_m * static_cast<float>(k) + 6, kApronEnd_m + 2);
            QuadMesh mast;
            add_tube(mast, {0, 0, 0}, {0, 22, 0}, 0.3f, 0.16f, 10, kIron);
            add_box(mast, {-1.6f, 21.4f, -0.25f}, {1.6f, 22.2f, 0.25f}, kLampGlass);
            world.stand(world.add(std::move(mast)), at, facing);
            if (std::abs(k) < 3)
                world.lanterns.push_back({{at.x, 16, at.y}, Vec3f{260, 235, 190}}),
                    world.lanterns.push_back({[&] {
                                                  const Vec2f near = here.place(kStand_m * static_cast<float>(k), 30);
                                                  return Vec3f{near.x, 15, near.y};
                                              }(),
                                              Vec3f{220, 200, 160}});
        }
        world.stand(tower, here.place(side * 135, 185), facing);
        for (const float right : {-260.f, -185.f, 230.f}) world.stand(hangar, here.place(right, 320), facing);
    }
    // Woods beyond the fence.
    const std::vector<std::uint32_t> tall = tall_trees(site, 4), dark = spruces(site, 2, 13);
    for (int k = 0; k < 2600; ++k) {
        const float right = r.uniform(-1500, 1500),
                    ahead = (r.chance(0.5f) ? 1.f : -1.f) * (kWoods_m + 700 * r.uniform() * r.uniform());
        const Vec2f at = site.place(right, ahead);
        if (noise2(at * (1 / 120.f) + Vec2f{30, 30}, seed + 31) > 0.36f)
            plant(site, r.chance(0.25f) ? dark : tall, at, r.uniform(0.7f, 1.2f));
    }
    spread_ground(site, 4200, 60, 120);
}

}  // namespace fastscene::outdoors

// The garden court of a cloister: lawns between crossing paths and clipped hedges, a well in the middle, arcades on the
// other sides, a church behind them.
#include <array>
#include <cmath>
#include <vector>

#include "fastscene/trace/outdoors_buildings.h"
#include "fastscene/trace/outdoors_site_parts.h"

namespace fastscene::outdoors {
namespace {

// Metres ahead of the arcade that one looks out of, and to its right.
constexpr float kGarthNear_m = 1.6f, kGarthFar_m = 27.6f, kGarthAside_m = 13.f, kGarthBay_m = 1.6f;
constexpr float kGarthMiddle_m = 0.5f * (kGarthNear_m + kGarthFar_m), kGarthPathHalf_m = 1.1f, kGarthRim_m = 1.5f,
                kGarthRound_m = 3.6f;

float off_garth_paths(Vec2f q) {
    const float cross = std::min(std::abs(q.x), std::abs(q.y - kGarthMiddle_m)) - kGarthPathHalf_m,
                rim = std::min({kGarthAside_m - std::abs(q.x), q.y - kGarthNear_m, kGarthFar_m - q.y}) - kGarthRim_m,
                round = length(q - Vec2f{0, kGarthMiddle_m}) - kGarthRound_m;
    return std::min({cross, rim, round});
}
bool is_garth_lawn(Vec2f q) { return off_garth_paths(q) > 0.75f; }

Vec3f court_albedo(Vec2f q, Vec2f p, float footprint, std::uint32_t seed, bool snow) {
    if (snow) return snow_albedo(p, footprint, seed);
    const float grain = fbm2(q * 14.f, 4, 14 * footprint, seed + 5);
    const bool outside = std::abs(q.x) > kGarthAside_m || q.y < kGarthNear_m || q.y > kGarthFar_m;
    if (outside || off_garth_paths(q) < 0) {  // gravel, and flags in the walks
        const Vec3f gravel = Vec3f{0.34f, 0.3f, 0.23f} * (0.7f + 0.6f * grain);
        return outside ? gravel * 0.8f : gravel;
    }
    if (!is_garth_lawn(q)) return Vec3f{0.06f, 0.045f, 0.03f} * (0.6f + 0.8f * grain);
    return lawn_albedo(p, footprint, seed) * 0.75f;
}

// A walk along x, `bays` long: columns on a low wall, round arches, a roof that rises to the wall behind. It looks
// to -z.
QuadMesh build_walk(int bays, std::uint16_t stone, std::uint16_t wall, std::uint16_t shade, std::uint16_t tiles) {
    constexpr float kSill = 0.75f, kSpring = 2.25f, kTop = 3.6f, kDeep = 3.4f, kThick = 0.32f, kRidge = 5.7f;
    constexpr float kClear = 0.64f;  // half the width of an arch
    constexpr int kSteps = 9;
    QuadMesh mesh;
    const float half = 0.5f * kGarthBay_m * static_cast<float>(bays);
    const auto wall_at = [&](float x0, float x1, float y0, float y1, float z, std::uint16_t paint) {
        mesh.quad({x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}, paint);
    };
    wall_at(-half, half, 0, kSill, 0, wall), wall_at(-half, half, 0, kSill, kThick, wall);
    mesh.quad({-half, kSill, -0.06f}, {half, kSill, -0.06f}, {half, kSill, kThick + 0.06f},
              {-half, kSill, kThick + 0.06f}, stone);
    wall_at(-half, half, kSill - 0.1f, kSill, -0.06f, stone);
    for (int i = 0; i < bays; ++i) {
        const float x = -half + kGarthBay_m * (static_cast<float>(i) + 0.5f);
        const auto arch = [&](int k) {
            const float a = kPi * static_cast<float>(k) / kSteps;
            return Vec2f{x - kClear * std::cos(a), kSpring + kClear * std::sin(a)};
        };
        for (int k = 0; k < kSteps; ++k) {
            const Vec2f a = arch(k), b = arch(k + 1);
            for (const float z : {0.f, kThick})
                mesh.quad({a.x, a.y, z}, {b.x, b.y, z}, {b.x, kTop, z}, {a.x, kTop, z}, wall);
            mesh.quad({a.x, a.y, 0}, {b.x, b.y, 0}, {b.x, b.y, kThick}, {a.x, a.y, kThick}, stone);
            // The moulding.
            const auto out = [&](Vec2f p) {
                const Vec2f away = (p - Vec2f{x, kSpring}) * (0.09f / kClear);
                return Vec3f{p.x + away.x, p.y + away.y, -0.05f};
            };
            mesh.quad({a.x, a.y, -0.05f}, {b.x, b.y, -0.05f}, out(b), out(a), stone);
        }
        for (const float side : {-1.f, 1.f}) {
            const float edge = x + side * kClear, end = x + side * 0.5f * kGarthBay_m;
            for (const float z : {0.f, kThick})
                wall_at(std::min(edge, end), std::max(edge, end), kSpring, kTop, z, wall);
        }
        // A pair of columns between two arches.
        const float between = x - 0.5f * kGarthBay_m;
        for (const float z : {0.07f, kThick - 0.07f}) {
            add_tube(mesh, {between, kSill, z}, {between, kSill + 0.12f, z}, 0.13f, 0.1f, 10, stone);
            add_tube(mesh, {between, kSill + 0.12f, z}, {between, kSpring - 0.2f, z}, 0.075f, 0.068f, 12, stone);
            add_tube(mesh, {between, kSpring - 0.2f, z}, {between, kSpring, z}, 0.07f, 0.15f, 10, stone);
        }
    }
    // Within: floor, ceiling and the wall at the back, with a door and niches.
    wall_at(-half, half, 0, kTop, kDeep, shade);
    mesh.quad({-half, kTop - 0.1f, kThick}, {half, kTop - 0.1f, kThick}, {half, kTop - 0.1f, kDeep},
              {-half, kTop - 0.1f, kDeep}, shade);
    wall_at(-half, half, kTop, kTop + 0.16f, -0.12f, stone);
    mesh.quad({-half, kTop + 0.16f, -0.12f}, {half, kTop + 0.16f, -0.12f}, {half, kTop, 0}, {-half, kTop, 0}, stone);
    // Rows of tiles, each a step above the one below.
    constexpr int kRows = 14;
    for (int r = 0; r < kRows; ++r) {
        const auto at = [&](float t, float x, float lift) {
            return Vec3f{x, kTop + 0.1f + (kRidge - kTop) * t + lift, -0.35f + (kDeep + 0.35f) * t};
        };
        const float t0 = static_cast<float>(r) / kRows, t1 = static_cast<float>(r + 1) / kRows;
        mesh.quad(at(t0, -half, 0.05f), at(t0, half, 0.05f), at(t1, half, 0.02f), at(t1, -half, 0.02f), tiles);
        mesh.quad(at(t0, -half, -0.01f), at(t0, half, -0.01f), at(t0, half, 0.05f), at(t0, -half, 0.05f), tiles);
    }
    return mesh;
}

// A nave along x with tall windows and a pitched roof, and a tower at its end.
QuadMesh build_church(std::uint16_t wall, std::uint16_t stone, std::uint16_t tiles, std::uint16_t glass) {
    constexpr float kHalf = 17, kHigh = 11, kRidge = 17, kDeep = 11;
    QuadMesh mesh;
    const auto box = [&](Vec3f low, Vec3f high, std::uint16_t paint) { add_box(mesh, low, high, paint); };
    box({-kHalf, 0, 0}, {kHalf, kHigh, kDeep}, wall);
    for (const float side : {0.f, 1.f}) {
        const float eave = side > 0 ? kDeep + 0.5f : -0.5f;
        mesh.quad({-kHalf - 0.4f, kHigh - 0.2f, eave}, {kHalf + 0.4f, kHigh - 0.2f, eave},
                  {kHalf + 0.4f, kRidge, 0.5f * kDeep}, {-kHalf - 0.4f, kRidge, 0.5f * kDeep}, tiles);
    }
    for (const float x : {-kHalf, kHalf})
        mesh.quad({x, kHigh, 0}, {x, kHigh, kDeep}, {x, kRidge, 0.5f * kDeep}, {x, kRidge, 0.5f * kDeep}, wall);
    for (int i = -3; i <= 3; ++i) {
        const float x = 4.4f * static_cast<float>(i);
        constexpr int kSteps = 8;
        const auto tall = [&](float grow, float z, std::uint16_t paint) {
            mesh.quad({x - 0.6f - grow, 6 - grow, z}, {x + 0.6f + grow, 6 - grow, z}, {x + 0.6f + grow, 9, z},
                      {x - 0.6f - grow, 9, z}, paint);
            for (int k = 0; k < kSteps; ++k) {
                const float a = kPi * static_cast<float>(k) / kSteps, b = kPi * static_cast<float>(k + 1) / kSteps,
                            r = 0.6f + grow;
                mesh.quad({x, 9, z}, {x - r * std::cos(a), 9 + r * std::sin(a), z},
                          {x - r * std::cos(b), 9 + r * std::sin(b), z}, {x, 9, z}, paint);
            }
        };
        tall(0.16f, -0.03f, stone), tall(0, -0.06f, glass);
        box({x + 1.9f, 0, -0.7f}, {x + 2.5f, 9.4f, 0}, stone);  // a buttress
    }
    box({kHalf - 1, 0, 2}, {kHalf + 6, 24, 9}, wall);
    for (const float y : {11.5f, 18.f, 23.6f}) box({kHalf - 1.2f, y, 1.8f}, {kHalf + 6.2f, y + 0.4f, 9.2f}, stone);
    for (const float x : {kHalf + 0.9f, kHalf + 3.2f})
        mesh.quad({x, 19.4f, 1.95f}, {x + 1.1f, 19.4f, 1.95f}, {x + 1.1f, 22.6f, 1.95f}, {x, 22.6f, 1.95f}, glass);
    const Vec3f peak{kHalf + 2.5f, 31, 5.5f};
    const std::array<Vec3f, 4> eaves{
        Vec3f{kHalf - 1.4f, 24, 1.6f}, {kHalf + 6.4f, 24, 1.6f}, {kHalf + 6.4f, 24, 9.4f}, {kHalf - 1.4f, 24, 9.4f}};
    for (std::size_t k = 0; k < 4; ++k) mesh.quad(eaves[k], eaves[(k + 1) % 4], peak, peak, tiles);
    return mesh;
}

QuadMesh build_well(std::uint16_t stone, std::uint16_t timber, std::uint16_t tiles) {
    QuadMesh mesh;
    add_tube(mesh, {0, 0, 0}, {0, 0.18f, 0}, 1.35f, 1.35f, 28, stone);
    add_tube(mesh, {0, 0.18f, 0}, {0, 0.181f, 0}, 1.35f, 0.8f, 28, stone);
    add_tube(mesh, {0, 0.18f, 0}, {0, 0.92f, 0}, 0.82f, 0.78f, 28, stone);
    add_tube(mesh, {0, 0.92f, 0}, {0, 1.04f, 0}, 0.92f, 0.92f, 28, stone);
    add_tube(mesh, {0, 1.04f, 0}, {0, 1.041f, 0}, 0.92f, 0.6f, 28, stone);
    add_tube(mesh, {0, 1.04f, 0}, {0, 0.3f, 0}, 0.6f, 0.6f, 28, kDarkCore);
    for (const float x : {-0.8f, 0.8f}) add_tube(mesh, {x, 1.f, 0}, {x, 2.5f, 0}, 0.06f, 0.06f, 8, timber);
    add_tube(mesh, {-0.9f, 1.95f, 0}, {0.9f, 1.95f, 0}, 0.07f, 0.07f, 10, timber);
    add_tube(mesh, {0, 1.95f, 0}, {0, 1.2f, 0}, 0.012f, 0.012f, 6, timber);
    add_tube(mesh, {0, 1.2f, 0}, {0, 0.98f, 0}, 0.14f, 0.11f, 12, timber);
    for (const float z : {-0.8f, 0.8f})
        mesh.quad({-1.15f, 2.4f, z}, {1.15f, 2.4f, z}, {1.15f, 3.05f, 0}, {-1.15f, 3.05f, 0}, tiles);
    return mesh;
}

}  // namespace

void lay_out_court(Site& site) {
    World& world = site.world;
    world.eye_m = 1.75f;
    const std::uint32_t seed = site.sky.seed;
    const bool snow = site.sky.snow;
    world.height = [](Vec2f) { return 0.f; };
    world.ground = [seed, snow, layout = Layout(site.facing)](Vec3f at, float footprint) {
        const Vec2f p{at.x, at.z};
        return court_albedo(layout.laid_out(p), p, footprint, seed, snow);
    };
    const std::uint16_t stone = world.add({Finish::matt, {0.46f, 0.41f, 0.32f}, {}, 0.25f}),
                        wall = world.add({Finish::matt, {0.4f, 0.35f, 0.27f}, {}, 0.35f}),
                        shade = world.add({Finish::matt, {0.36f, 0.32f, 0.26f}, {}, 0.3f}),
                        tiles = world.add({Finish::matt, {0.26f, 0.11f, 0.06f}, {}, 0.5f}),
                        timber = world.add({Finish::matt, {0.09f, 0.06f, 0.04f}, {}, 0.3f});
    const auto bays = [](float length_m) { return static_cast<int>(length_m / kGarthBay_m) + 1; };
    const std::uint32_t across = world.add(build_walk(bays(2 * kGarthAside_m), stone, wall, shade, tiles)),
                        along = world.add(build_walk(bays(kGarthFar_m - kGarthNear_m + 6), stone, wall, shade, tiles));
    world.stand(across, site.place(0, kGarthFar_m), site.facing);
    for (const float side : {-1.f, 1.f})
        world.stand(along, site.place(side * kGarthAside_m, kGarthMiddle_m - 2), site.facing + side * 0.5f * kPi);
    world.stand(world.add(build_church(wall, stone, tiles, kGlass)), site.place(-2, kGarthFar_m + 3.4f), site.facing);
    world.stand(world.add(build_well(stone, timber, tiles)), site.place(0, kGarthMiddle_m), site.facing + 0.6f);

    // Low hedges along the lawns; lavender and roses before them.
    Random& r = site.random;
    constexpr float kPiece_m = 1.2f;
    std::array<std::uint32_t, 3> hedges{};
    for (std::uint32_t& h : hedges) h = world.add(grow_hedge(kPiece_m + 0.06f, 0.5f, 0.45f, r.next_u32()));
    const auto hedge = [&](Vec2f from, Vec2f to) {
        const Vec2f way = to - from;
        const int count = std::max(1, static_cast<int>(length(way) / kPiece_m));
        const float turn = std::atan2(way.x, way.y) - 0.5f * kPi;
        for (int i = 0; i < count; ++i) {
            const Vec2f at = from + way * ((static_cast<float>(i) + 0.5f) / static_cast<float>(count));
            if (off_garth_paths(at) < 0.2f) continue;
            world.stand(hedges[static_cast<std::size_t>(r.index(3))], site.place(at.x, at.y), site.facing + turn,
                        {length(way) / (kPiece_m * static_cast<float>(count)), r.uniform(0.95f, 1.05f), 1});
        }
    };
    constexpr float kIn = 0.4f;  // from the edge of a path
    const float x0 = kGarthPathHalf_m + kIn, x1 = kGarthAside_m - kGarthRim_m - kIn;
    for (const float side : {-1.f, 1.f})
        for (const float end : {-1.f, 1.f}) {
            const float y0 = kGarthMiddle_m + end * (kGarthPathHalf_m + kIn),
                        y1 = (end > 0 ? kGarthFar_m - kGarthRim_m - kIn : kGarthNear_m + kGarthRim_m + kIn);
            hedge({side * x0, y0}, {side * x1, y0}), hedge({side * x0, y1}, {side * x1, y1});
            hedge({side * x0, y0}, {side * x0, y1}), hedge({side * x1, y0}, {side * x1, y1});
        }
    std::array<std::uint32_t, 3> clumps{};
    for (std::uint32_t& c : clumps) c = world.add(grow_perennial(r.uniform(0.4f, 0.7f), 26, !snow, r.next_u32()));
    constexpr std::array<Vec3f, 4> kBlooms{
        Vec3f{0.5f, 0.36f, 0.85f}, {0.9f, 0.85f, 0.8f}, {0.8f, 0.2f, 0.28f}, {0.6f, 0.4f, 0.8f}};
    for (int k = 0; k < 260; ++k) {
        const Vec2f q{r.uniform(-kGarthAside_m, kGarthAside_m), r.uniform(kGarthNear_m, kGarthFar_m)};
        const float off = off_garth_paths(q);
        if (off < 0.75f || off > 1.25f) continue;
        world.stand(clumps[static_cast<std::size_t>(r.index(3))], site.place(q.x, q.y), site.turn(), {1, 1, 1},
                    kBlooms[static_cast<std::size_t>(r.index(4))]);
    }
    sow_grass(site, kGarthFar_m, 0.06f, [&](Vec2f p) {
        const Vec2f q = site.laid_out(p);
        return std::abs(q.x) < kGarthAside_m && q.y > kGarthNear_m && q.y < kGarthFar_m && is_garth_lawn(q);
    });
    // A tree on two of the lawns, cypresses at the corners; woods behind the roofs.
    const std::vector<std::uint32_t> small = small_trees(site, 2), tall = tall_trees(site, 3);
    plant(site, small, site.place(-6.5f, 8.5f), 0.8f), plant(site, small, site.place(7, 20.5f), 0.85f);
    const std::uint32_t cypress = world.add(grow_tree({8.5f, 0.4f, 0.8f, Crown::columnar, 0.05f, 60000}, r.next_u32()));
    for (const Vec2f at : {Vec2f{8.8f, 7.f}, {-8.8f, 22.f}})
        world.stand(cypress, site.place(at.x, at.y), site.turn(), {1, 1, 1}, {0.75f, 0.85f, 0.8f});
    for (int k = 0; k < 240; ++k) plant(site, tall, site.polar(site.turn(), r.uniform(58, 160)), r.uniform(0.7f, 1.1f));
    spread_ground(site, 1500, 60, 240);
}

}  // namespace fastscene::outdoors

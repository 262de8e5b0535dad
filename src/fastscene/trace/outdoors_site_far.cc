// City, mountains and sea.
#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/trace/outdoors_buildings.h"
#include "fastscene/trace/outdoors_site_parts.h"

namespace fastscene::outdoors {
namespace {

// Streets run along the front of the house, one behind the other; metres ahead of the window.
constexpr float kStreet_m = 14.f, kStreetHalf_m = 7.f, kRoadHalf_m = 3.8f, kDeep_m = 12.f, kCourt_m = 16.f;
constexpr float kPeriod_m = 2 * kStreetHalf_m + 2 * kDeep_m + kCourt_m;
constexpr float kCross_m = 84.f;  // between cross streets

float off_street(float ahead) {
    const float t = (ahead - kStreet_m) / kPeriod_m;
    return std::abs(t - std::round(t)) * kPeriod_m;
}
float off_cross_street(float right) {
    const float t = (right - 31.f) / kCross_m;
    return std::abs(t - std::round(t)) * kCross_m;
}

Vec3f street_albedo(Vec2f q, float footprint, std::uint32_t seed, bool snow) {
    const float off = off_street(q.y), aside = off_cross_street(q.x),
                grain = 0.85f + 0.3f * fbm2(q * 2.f, 5, 2 * footprint, seed);
    const bool road = off < kRoadHalf_m || aside < kRoadHalf_m;
    if (snow && !road) return snow_albedo(q, footprint, seed);
    if (road) {
        const bool crossing = off < kRoadHalf_m && aside < kRoadHalf_m;
        const float along = off < kRoadHalf_m ? q.x : q.y, from = off < kRoadHalf_m ? off : aside;
        const float dash = std::fmod(std::abs(along), 6.f) < 2.6f && !crossing ? line_cover(from, 0.07f, footprint)
                                                                               : 0.f;
        // Worn wheel tracks, patches of newer asphalt.
        const float patch = lattice_unit(floor_int(q.x / 7), floor_int(q.y / 4), 3, seed) < 0.12f ? 0.75f : 1.f;
        const Vec3f asphalt = Vec3f{0.085f, 0.086f, 0.09f} *
                              (grain * patch * (1.08f - 0.16f * std::exp(-std::abs(from - 1.9f))));
        return lerp(snow ? asphalt * 1.7f : asphalt, Vec3f{0.5f, 0.5f, 0.48f}, 0.8f * dash);
    }
    if (off < kStreetHalf_m + kDeep_m || aside < kStreetHalf_m) {
        const float kerb = std::min(off - kRoadHalf_m, aside < kStreetHalf_m ? aside - kRoadHalf_m : 9.f);
        const float x = q.x / 0.6f, y = q.y / 0.6f;
        const float joint = std::min({x - std::floor(x), y - std::floor(y)}) < 0.04f ? 0.75f : 1.f;
        const float tone = kerb < 0.16f ? 1.25f : 0.9f + 0.15f * lattice_unit(floor_int(x), floor_int(y), 2, seed);
        return Vec3f{0.235f, 0.228f, 0.215f} * (grain * tone * (footprint < 0.1f ? joint : 0.98f));
    }
    return lawn_albedo(q, footprint, seed) * 0.9f;
}

// A parked car, 4.3 m along x.
QuadMesh build_car(World& world, Vec3f paint) {
    QuadMesh mesh;
    const std::uint16_t body = world.add({Finish::matt, paint}),
                        tyre = world.add({Finish::matt, {0.02f, 0.02f, 0.022f}, {}, 0, false, false});
    // Cross-sections along the car: x, height, half width; the glasshouse narrows upward.
    const auto loft = [&](std::initializer_list<Vec3f> low, std::initializer_list<Vec3f> high, std::uint16_t side,
                          std::uint16_t top) {
        const std::vector<Vec3f> a(low), b(high);
        for (std::size_t k = 0; k + 1 < a.size(); ++k) {
            const auto at = [](Vec3f s, float hand) { return Vec3f{s.x, s.y, hand * s.z}; };
            for (const float hand : {-1.f, 1.f})
                mesh.quad(at(a[k], hand), at(a[k + 1], hand), at(b[k + 1], hand), at(b[k], hand), side);
            mesh.quad(at(b[k], -1), at(b[k + 1], -1), at(b[k + 1], 1), at(b[k], 1), top);
        }
    };
    loft({{-2.15f, 0.25f, 0.7f}, {-2.f, 0.2f, 0.86f}, {2.f, 0.2f, 0.86f}, {2.15f, 0.25f, 0.7f}},
         {{-2.15f, 0.78f, 0.66f}, {-2.f, 0.9f, 0.83f}, {1.95f, 0.82f, 0.83f}, {2.15f, 0.62f, 0.66f}}, body, body);
    loft({{-1.75f, 0.88f, 0.78f}, {-1.2f, 0.9f, 0.8f}, {0.35f, 0.9f, 0.8f}, {1.05f, 0.88f, 0.78f}},
         {{-1.75f, 0.9f, 0.78f}, {-1.15f, 1.42f, 0.58f}, {0.2f, 1.44f, 0.58f}, {1.05f, 0.9f, 0.78f}}, kGlass, body);
    mesh.quad({-2.15f, 0.25f, -0.7f}, {-2.15f, 0.25f, 0.7f}, {-2.15f, 0.78f, 0.66f}, {-2.15f, 0.78f, -0.66f}, body);
    mesh.quad({2.15f, 0.25f, -0.7f}, {2.15f, 0.25f, 0.7f}, {2.15f, 0.62f, 0.66f}, {2.15f, 0.62f, -0.66f}, body);
    for (const float x : {-1.3f, 1.35f})
        for (const float z : {-0.8f, 0.8f}) {
            constexpr int kSides = 10;
            const auto rim = [&](int k) {
                const float turn = 2 * kPi * static_cast<float>(k) / kSides;
                return Vec3f{x + 0.31f * std::cos(turn), 0.31f + 0.31f * std::sin(turn), z + (z > 0 ? 0.08f : -0.08f)};
            };
            for (int k = 0; k < kSides; ++k) mesh.quad({x, 0.31f, z * 1.1f}, rim(k), rim(k + 1), rim(k + 1), tyre);
            add_tube(mesh, {x, 0.31f, z - 0.1f}, {x, 0.31f, z + 0.1f}, 0.31f, 0.31f, kSides, tyre);
        }
    return mesh;
}

void build_rows(Site& site) {
    Random& r = site.random;
    struct Kind {
        std::uint32_t mesh;
        float wide;
    };
    std::vector<Kind> kinds;
    for (int k = 0; k < 11; ++k) {
        const float wide = r.uniform(10.5f, 17.5f);
        kinds.push_back({site.world.add(build_block(site.world, wide, kDeep_m, 4 + r.index(4), r.next_u32())), wide});
    }
    constexpr int kRows = 5;
    constexpr float kReach_m = 190.f, kClear_m = 24.f;  // free of buildings around the viewer's own
    for (int row = -kRows; row <= kRows; ++row)
        for (const float side : {-1.f, 1.f}) {
            const float ahead = kStreet_m + kPeriod_m * static_cast<float>(row) +
                                side * (kStreetHalf_m + 0.5f * kDeep_m);
            std::size_t k = static_cast<std::size_t>(r.index(11));
            for (float right = -kReach_m; right < kReach_m;) {
                const Kind& kind = kinds[k = (k + 1 + static_cast<std::size_t>(r.index(4))) % kinds.size()];
                const float middle = right + 0.5f * kind.wide;
                right += kind.wide + 0.02f;
                if (off_cross_street(middle) < kStreetHalf_m + 0.5f * kind.wide) continue;
                const Vec2f near{std::max(0.f, std::abs(middle) - 0.5f * kind.wide),
                                 std::max(0.f, std::abs(ahead - site.stands) - 0.5f * kDeep_m)};
                const bool inside = site.stands == 0;  // of a building, which is not seen
                if (inside && length(near) < kClear_m && side < 0 && row == 0) continue;
                if (inside && length(near) < 10) continue;
                site.world.stand(kind.mesh, site.place(middle, ahead), site.facing + (side > 0 ? 0 : kPi),
                                 {1, r.uniform(0.94f, 1.06f), 1});
            }
        }
    std::vector<std::uint32_t> towers;
    for (int k = 0; k < 7; ++k)
        towers.push_back(site.world.add(
            build_tower(site.world, r.uniform(18, 34), r.uniform(18, 30), r.uniform(38, 105), r.next_u32())));
    for (int k = 0; k < 130; ++k) {
        const Vec2f at = site.polar(site.turn(), r.uniform(260, 1500));
        site.world.stand(towers[static_cast<std::size_t>(r.index(7))], at,
                         site.facing + (r.chance(0.5f) ? 0.f : 0.5f * kPi), {1, r.uniform(0.6f, 1.3f), 1});
    }
}

void furnish_streets(Site& site) {
    Random& r = site.random;
    const std::vector<std::uint32_t> trees = small_trees(site, 4);
    const std::uint32_t lamp = site.world.add(build_lamp());
    std::vector<std::uint32_t> cars;
    for (const Vec3f paint : {Vec3f{0.03f, 0.03f, 0.035f}, Vec3f{0.4f, 0.4f, 0.41f}, Vec3f{0.55f, 0.55f, 0.53f},
                              Vec3f{0.05f, 0.08f, 0.16f}, Vec3f{0.25f, 0.03f, 0.025f}, Vec3f{0.16f, 0.17f, 0.18f}})
        cars.push_back(site.world.add(build_car(site.world, paint)));
    constexpr Vec3f kLamp{16.f, 10.5f, 5.4f};
    for (int row = -2; row <= 2; ++row) {
        const float street = kStreet_m + kPeriod_m * static_cast<float>(row);
        for (const float side : {-1.f, 1.f})
            for (int k = -16; k <= 16; ++k) {
                const float right = 8.6f * static_cast<float>(k) + r.uniform(-0.6f, 0.6f);
                if (off_cross_street(right) < kStreetHalf_m + 1.5f) continue;
                const Vec2f walk = site.place(right, street + side * (kRoadHalf_m + 0.8f));
                if (k % 3 == 0) {
                    site.world.stand(lamp, walk, 0);
                    if (std::abs(row) < 2) site.world.lanterns.push_back({{walk.x, kLampHeight_m, walk.y}, kLamp});
                } else if (r.chance(row == 0 && side < 0 ? 0.25f : 0.75f)) {
                    plant(site, trees, walk, r.uniform(0.75f, 1.05f));
                }
                if (r.chance(0.55f))
                    site.world.stand(cars[static_cast<std::size_t>(r.index(6))],
                                     site.place(right + 4, street + side * (kRoadHalf_m - 1.05f)),
                                     site.facing + r.uniform(-0.02f, 0.02f) + (r.chance(0.5f) ? kPi : 0.f));
            }
    }
    // Trees in the courtyards.
    for (int k = 0; k < 70; ++k) {
        const float right = r.uniform(-120, 120);
        const float ahead = kStreet_m + kPeriod_m * (static_cast<float>(r.index(5)) - 2.5f) + r.uniform(-6, 6);
        if (off_cross_street(right) > kStreetHalf_m + 2 && std::hypot(right, ahead) > 13)
            plant(site, trees, site.place(right, ahead), r.uniform(0.8f, 1.25f));
    }
}

float mountain_height(Vec2f p, std::uint32_t seed) {
    const float reach = length(p), rise = smooth_step(300, 4200, reach);
    if (!(rise > 0)) return 1.2f * smooth_step(12, 60, reach) * (fbm2(p * (1 / 40.f), 4, 0, seed + 2) - 0.5f);
    // Ridged noise: sharp crests, steeper above.
    float sum = 0, amplitude = 1, size = 1 / 2100.f, weight = 1;
    Vec2f q = p + Vec2f{9000, 9000};
    for (std::uint32_t k = 0; k < 8; ++k) {
        const float ridge = 1 - std::abs(2 * noise2(q * size, seed + 40 + k) - 1);
        sum += amplitude * ridge * ridge * weight;
        weight = unit_clamp(ridge * 1.6f);
        amplitude *= 0.47f, size *= 2.07f;
        q = {0.8f * q.x - 0.6f * q.y, 0.6f * q.x + 0.8f * q.y};
    }
    return rise * (930 * (sum - 0.55f) + 60) + 1.2f * (fbm2(p * (1 / 40.f), 4, 0, seed + 2) - 0.5f);
}

float coast_height(Vec2f p, std::uint32_t seed) {
    const float reach = length(p), azimuth = std::atan2(p.x, p.y);
    const float shore = 36 + 9 * noise2({1.3f * std::cos(azimuth) + 4, 1.3f * std::sin(azimuth) + 4}, seed + 8);
    const float dunes = smooth_step(4, 12, reach) * 1.5f *
                        (fbm2(p * (1 / 9.f) + Vec2f{30, 30}, 3, 0, seed + 9) - 0.38f);
    const float slope = 1.6f * smooth_step(shore - 22, shore, reach) + std::max(0.f, reach - shore) * 0.05f;
    float height = dunes * (1 - smooth_step(shore - 16, shore - 8, reach)) - std::min(slope, 6.f);
    // A cape, far away on one side.
    const float turn = azimuth - 2 * kPi * lattice_unit(1, 2, 3, seed);
    const float cape = smooth_step(0.55f, 0.9f, std::cos(turn)) * smooth_step(900, 2200, reach) *
                       (1 - smooth_step(4200, 5200, reach));
    height += cape * (150 * fbm2(p * (1 / 700.f) + Vec2f{30, 30}, 5, 0, seed + 11) - 30);
    return height;
}

constexpr float kSeaLevel_m = -1.55f;

void set_sail(Site& site) {
    Random& r = site.random;
    QuadMesh boat;
    const std::uint16_t hull = site.world.add({Finish::matt, {0.5f, 0.5f, 0.5f}, {}, 0, false, false}),
                        sail = site.world.add(
                            {Finish::leaf, {0.6f, 0.59f, 0.56f}, {0.2f, 0.2f, 0.19f}, 0, false, false});
    boat.quad({-3.2f, 0.9f, -0.9f}, {3.8f, 1.1f, 0}, {2.9f, 0, 0}, {-3, 0, -0.7f}, hull);
    boat.quad({-3.2f, 0.9f, 0.9f}, {3.8f, 1.1f, 0}, {2.9f, 0, 0}, {-3, 0, 0.7f}, hull);
    boat.quad({-3.2f, 0.9f, -0.9f}, {-3.2f, 0.9f, 0.9f}, {3.8f, 1.1f, 0}, {3.8f, 1.1f, 0}, hull);
    boat.quad({0.5f, 1.8f, 0}, {-2.9f, 1.9f, 0.7f}, {0.4f, 10, 0.1f}, {0.4f, 10, 0.1f}, sail);
    boat.quad({0.7f, 1.6f, 0}, {3.5f, 1.4f, 0}, {0.5f, 8.6f, 0.3f}, {0.5f, 8.6f, 0.3f}, sail);
    const std::uint32_t sailing = site.world.add(std::move(boat));
    for (int k = 0; k < 7; ++k) {
        const Vec2f at = site.polar(site.turn(), r.uniform(220, 1300));
        site.world.stand(sailing, at, site.turn());
        site.world.instances.back().at.y = kSeaLevel_m;
    }
}

}  // namespace

Layout street_layout(float azimuth) {
    constexpr float kLane_m = 0.6f;  // right of the middle of the road: clear of parked cars
    return Layout(azimuth - 0.5f * kPi, kStreet_m - kLane_m);
}

namespace {

void lay_out_streets(Site& site) {
    const std::uint32_t seed = site.sky.seed;
    const bool snow = site.sky.snow;
    site.world.height = [](Vec2f) { return 0.f; };
    site.world.ground = [seed, snow, layout = static_cast<const Layout&>(site)](Vec3f at, float footprint) {
        return street_albedo(layout.laid_out({at.x, at.z}), footprint, seed, snow);
    };
    build_rows(site);
    furnish_streets(site);
    spread_ground(site, 3000, 40, 90);
}

}  // namespace

void lay_out_city(Site& site) {
    site.world.eye_m = 11.f;
    lay_out_streets(site);
}

void lay_out_street(Site& site) {
    site.world.eye_m = 2.3f;  // of who stands in a bus
    lay_out_streets(site);
}

void lay_out_mountains(Site& site) {
    site.world.eye_m = 5.f;
    site.world.clear_m *= 7;  // thin air
    const std::uint32_t seed = site.sky.seed;
    const bool snow = site.sky.snow;
    site.world.height = [seed](Vec2f p) { return mountain_height(p, seed); };
    site.world.ground = [seed, snow](Vec3f at, float footprint) {
        const Vec2f p{at.x, at.z};
        if (snow) return snow_albedo(p, footprint, seed);
        const float reach = length(p), rough = fbm2(p * (1 / 90.f), 6, footprint / 90, seed + 5);
        const Vec3f rock = lerp(Vec3f{0.11f, 0.105f, 0.098f}, Vec3f{0.23f, 0.215f, 0.195f}, rough);
        const Vec3f wood = Vec3f{0.022f, 0.036f, 0.018f} *
                           (0.7f + 0.6f * fbm2(p * (1 / 14.f), 4, footprint / 14, seed + 6));
        // Meadow, then woods, then rock, then snow, by altitude with ragged borders; snow does not hold on walls.
        const float e = 25 + 0.03f * at.y;
        const float slope = length(Vec2f{
                                mountain_height(p + Vec2f{e, 0}, seed) - mountain_height(p - Vec2f{e, 0}, seed),
                                mountain_height(p + Vec2f{0, e}, seed) - mountain_height(p - Vec2f{0, e}, seed)}) /
                            (2 * e);
        const float ragged = 260 * (rough - 0.5f);
        Vec3f color = lerp(lawn_albedo(p, footprint, seed) * Vec3f{1.05f, 1.f, 0.9f}, wood,
                           smooth_step(0.46f, 0.56f, noise2(p * (1 / 130.f) + Vec2f{90, 90}, seed + 7)) *
                               smooth_step(180, 420, reach));
        color = lerp(color, rock, smooth_step(250, 420, at.y + ragged));
        color = lerp(color, rock, smooth_step(0.75f, 1.05f, slope));
        const float white = smooth_step(430, 620, at.y + ragged) *
                            (1 - smooth_step(0.75f, 1.25f, slope + 0.5f * (rough - 0.5f)));
        return lerp(color, Vec3f{0.76f, 0.79f, 0.84f}, white);
    };
    Random& r = site.random;
    const std::vector<std::uint32_t> dark = spruces(site, 6, 13), tall = tall_trees(site, 2);
    for (int k = 0; k < 900; ++k) {
        const Vec2f at = site.polar(site.turn(), 38 + 520 * r.uniform() * r.uniform());
        if (noise2(at * (1 / 42.f) + Vec2f{30, 30}, seed + 31) < 0.56f) continue;
        plant(site, r.chance(0.1f) ? tall : dark, at, r.uniform(0.6f, 1.15f));
    }
    for (int k = 0; k < 2; ++k)
        site.world.stand(site.world.add(build_house(site.world, r.next_u32())),
                         site.polar(site.facing + r.uniform(-0.9f, 0.9f), r.uniform(70, 150)), site.turn());
    sow_grass(site, 12, 0.13f, [](Vec2f p) { return length(p) > 3.2f; }, {1.1f, 1.f, 0.85f});
    spread_ground(site, 12000, 230, 720);
}

void lay_out_sea(Site& site) {
    site.world.eye_m = 7.f;
    site.world.clear_m *= 1.6f;
    const std::uint32_t seed = site.sky.seed;
    const bool snow = site.sky.snow;
    site.world.height = [seed](Vec2f p) { return coast_height(p, seed); };
    site.world.ground = [seed, snow](Vec3f at, float footprint) {
        const Vec2f p{at.x, at.z};
        if (length(p) > 400)
            return Vec3f{0.06f, 0.07f, 0.04f} * (0.6f + 0.8f * fbm2(p * (1 / 60.f), 4, footprint / 60, seed));
        if (snow && at.y > kSeaLevel_m + 0.35f) return snow_albedo(p, footprint, seed);
        const float ripples = fbm2({p.x * 1.1f, p.y * 4.f}, 5, footprint * 3, seed + 10),
                    grain = fbm2(p * 25.f, 3, footprint * 25, seed + 12);
        const Vec3f dry = Vec3f{0.29f, 0.25f, 0.185f} * (0.78f + 0.24f * ripples + 0.2f * grain);
        const float above = at.y - kSeaLevel_m + 0.12f * (noise2(p * 0.4f, seed + 13) - 0.5f);
        const Vec3f wet = lerp(dry * 0.45f, dry, smooth_step(0.1f, 0.45f, above));
        // Foam where waves run out.
        const float foam = smooth_step(0.62f, 0.7f, noise2(p * 1.3f, seed + 14)) *
                           (1 - smooth_step(0.f, 0.14f, std::abs(above - 0.02f)));
        return lerp(wet, Vec3f{0.7f, 0.72f, 0.73f}, foam);
    };
    Random& r = site.random;
    QuadMesh water;
    constexpr float kHorizon_m = 30000;
    water.quad({-kHorizon_m, kSeaLevel_m, -kHorizon_m}, {kHorizon_m, kSeaLevel_m, -kHorizon_m},
               {kHorizon_m, kSeaLevel_m, kHorizon_m}, {-kHorizon_m, kSeaLevel_m, kHorizon_m}, kWater);
    site.world.instances.push_back({site.world.add(std::move(water)), {}, {}});
    // Marram on the dunes, a few wind-bent pines and bushes.
    std::array<std::uint32_t, 3> tufts{};
    for (std::uint32_t& t : tufts) t = site.world.add(grow_grass(0.5f, 90, 0.6f, 0.012f, r.next_u32()));
    for (int k = 0; k < 1500; ++k) {
        const Vec2f at = site.polar(site.turn(), 5 + 22 * r.uniform());
        if (noise2(at * 0.22f + Vec2f{40, 40}, seed + 15) < 0.5f) continue;
        const float s = r.uniform(0.6f, 1.4f);
        site.world.stand(tufts[static_cast<std::size_t>(r.index(3))], at, site.turn(), {s, s, s},
                         Vec3f{1.7f, 1.35f, 1.5f} * r.uniform(0.8f, 1.1f));
    }
    std::vector<std::uint32_t> pines;
    for (int k = 0; k < 3; ++k)
        pines.push_back(site.world.add(grow_tree(
            {r.uniform(6, 8.5f), 3.2f, 2.6f, Crown::umbrella, 0.17f, 3800, kBark, true, 0.9f}, r.next_u32())));
    const std::uint32_t bush = site.world.add(grow_shrub(0.9f, 0.9f, 0.06f, 0, r.next_u32()));
    for (int k = 0; k < 22; ++k) {
        const Vec2f at = site.polar(site.turn(), r.uniform(9, 21));
        const float s = r.uniform(0.6f, 1.2f);
        if (k % 2) site.world.stand(bush, at, site.turn(), {s, s, s});
        else if (k < 12) plant(site, pines, at, r.uniform(0.8f, 1.1f));
    }
    set_sail(site);
    spread_ground(site, 6000, 120, 360);
}

}  // namespace fastscene::outdoors

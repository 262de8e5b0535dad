// Garden and forest.
#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/trace/outdoors_buildings.h"
#include "fastscene/trace/outdoors_site_parts.h"

namespace fastscene::outdoors {
namespace {

constexpr std::array<Vec3f, 8> kBlooms{Vec3f{1.15f, 1.12f, 1.05f}, {1.f, 0.36f, 0.58f}, {0.48f, 0.34f, 0.9f},
                                       {1.1f, 0.8f, 0.12f},        {0.9f, 0.1f, 0.09f}, {1.1f, 0.68f, 0.72f},
                                       {1.1f, 0.42f, 0.1f},        {0.62f, 0.3f, 0.75f}};

// The plot, in metres from the house: a paved terrace, lawn, a gravel path, beds along a hedge.
constexpr float kTerrace_m = 4.3f, kSide_m = 15.f, kEnd_m = 19.f, kBed_m = 2.4f, kPathHalf_m = 0.55f;

struct Plot {
    Layout layout;
    std::uint32_t seed;
    float bend;
    // Metres inside the hedge.
    float inside(Vec2f q) const { return std::min(kSide_m - std::abs(q.x), kEnd_m - std::abs(q.y)); }
    float off_terrace(Vec2f q) const {
        // Rounded corners.
        const Vec2f d{std::max(0.f, std::abs(q.x) - kTerrace_m + 1), std::max(0.f, std::abs(q.y) - kTerrace_m + 1)};
        return length(d) - 1;
    }
    float off_path(Vec2f q) const {
        const float along = std::abs(q.y) - kTerrace_m;
        if (along < -1) return 1e9f;
        return std::abs(q.x - (q.y > 0 ? 1.f : -1.f) * (1.6f + bend * (1 - std::cos(0.16f * along)))) - kPathHalf_m;
    }
    float edge(Vec2f q) const { return 0.5f * (noise2(q * 0.45f, seed + 6) - 0.5f) + 0.1f * noise2(q * 3.f, seed + 7); }
    bool is_border(Vec2f q) const { return inside(q) > 0 && inside(q) + edge(q) < kBed_m && off_path(q) > 0.25f; }
    bool is_terrace_bed(Vec2f q) const {
        const float off = off_terrace(q);
        return off > 0.08f && off + edge(q) < 0.95f && off_path(q) > 0.5f &&
               noise2({2.2f * std::atan2(q.x, q.y) + 20, 3}, seed + 8) > 0.42f;
    }
    bool is_lawn(Vec2f q) const {
        return inside(q) > 0 && off_terrace(q) > 0.1f && off_path(q) > 0.1f && !is_border(q) && !is_terrace_bed(q);
    }
};

Vec3f paving(Vec2f q, float footprint, std::uint32_t seed) {
    constexpr float kSlab_m = 0.8f;
    const Vec2f s{q.x / kSlab_m, q.y / kSlab_m};
    const int i = floor_int(s.x), j = floor_int(s.y);
    const float x = (s.x - static_cast<float>(i)) * kSlab_m, y = (s.y - static_cast<float>(j)) * kSlab_m;
    const float off = std::min(std::min(x, kSlab_m - x), std::min(y, kSlab_m - y));
    const float joint = line_cover(off, 0.006f, footprint);
    const float tone = 0.86f + 0.2f * lattice_unit(i, j, 2, seed) +
                       0.2f * (fbm2(q * 3.f, 5, footprint * 3, seed + 2) - 0.5f);
    return Vec3f{0.26f, 0.245f, 0.22f} * tone * (1 - 0.65f * joint);
}

// Country beyond the hedge: meadows, fields and woods.
Vec3f country(Vec2f p, float footprint, std::uint32_t seed) {
    const float reach = length(p);
    const Vec3f lawn = lawn_albedo(p, footprint, seed);
    const Voronoi field = voronoi2(p * (1 / 140.f), seed + 21);
    const float kind = static_cast<float>(field.id >> 8 & 0xff) / 255.f;
    const Vec3f crop = kind < 0.4f    ? Vec3f{0.055f, 0.085f, 0.03f}
                       : kind < 0.62f ? Vec3f{0.11f, 0.11f, 0.045f}
                       : kind < 0.75f ? Vec3f{0.17f, 0.14f, 0.075f}
                                      : Vec3f{0.03f, 0.045f, 0.022f};
    return lerp(lawn, crop * (0.75f + 0.5f * fbm2(p * 0.06f, 5, footprint * 0.06f, seed)), smooth_step(60, 160, reach));
}

float rolling(Vec2f p, std::uint32_t seed) {
    const float reach = length(p);
    return smooth_step(90, 1500, reach) * (105 * fbm2(p * (1 / 640.f) + Vec2f{40, 40}, 4, 0, seed + 9) - 22) +
           smooth_step(24, 90, reach) * 1.6f * (fbm2(p * (1 / 45.f) + Vec2f{9, 9}, 3, 0, seed + 10) - 0.5f);
}

void plant_borders(Site& site, const Plot& plot) {
    Random& r = site.random;
    std::array<std::uint32_t, 6> shrubs{};
    for (std::size_t k = 0; k < shrubs.size(); ++k)
        shrubs[k] = site.world.add(grow_shrub(r.uniform(0.55f, 1.f), r.uniform(0.8f, 1.6f), r.uniform(0.05f, 0.085f),
                                              k % 2 && !site.sky.snow ? 0.35f : 0.f, r.next_u32()));
    std::array<std::uint32_t, 4> clumps{};
    for (std::size_t k = 0; k < clumps.size(); ++k)
        clumps[k] = site.world.add(grow_perennial(r.uniform(0.3f, 0.65f), 16, !site.sky.snow, r.next_u32()));
    const auto any = [&](const auto& of) { return of[static_cast<std::size_t>(r.index(static_cast<int>(of.size())))]; };
    const auto bloom = [&](Vec2f q) {
        // Neighbours share a color: drifts, as gardeners plant.
        const Voronoi drift = voronoi2(q * 0.55f + Vec2f{60, 60}, plot.seed + 12);
        return kBlooms[drift.id >> 5 & 7] * r.uniform(0.85f, 1.1f);
    };
    for (float x = -kSide_m; x < kSide_m; x += 0.62f)
        for (float y = -kEnd_m; y < kEnd_m; y += 0.62f) {
            const Vec2f q{x + r.uniform(-0.25f, 0.25f), y + r.uniform(-0.25f, 0.25f)};
            const float deep = plot.inside(q);
            const bool border = plot.is_border(q), bed = plot.is_terrace_bed(q);
            if (!border && !bed) continue;
            const float s = r.uniform(0.75f, 1.2f);
            if (border && deep < 1.25f) {
                if (deep > 0.45f && r.chance(0.34f))
                    site.world.stand(any(shrubs), site.place(q.x, q.y), site.turn(), {s, s * r.uniform(0.8f, 1.2f), s},
                                     bloom(q));
            } else if (r.chance(0.9f)) {
                const float low = bed ? 0.72f : 1.f;
                site.world.stand(any(clumps), site.place(q.x, q.y), site.turn(), {s * low, s * low, s * low}, bloom(q));
            }
        }
}

void plant_hedge(Site& site) {
    constexpr float kPiece_m = 3.f, kHigh_m = 1.55f, kThick_m = 0.9f;
    std::array<std::uint32_t, 3> pieces{};
    for (std::uint32_t& p : pieces)
        p = site.world.add(grow_hedge(kPiece_m + 0.1f, kHigh_m, kThick_m, site.random.next_u32()));
    const auto run = [&](float half, const auto& put) {
        for (float at = -half + 0.5f * kPiece_m; at < half; at += kPiece_m)
            put(at, pieces[static_cast<std::size_t>(site.random.index(3))], site.random.chance(0.5f) ? kPi : 0.f);
    };
    const float far = kEnd_m + 0.5f * kThick_m, aside = kSide_m + 0.5f * kThick_m;
    for (const float hand : {-1.f, 1.f}) {
        run(kSide_m, [&](float at, std::uint32_t piece, float turn) {
            site.world.stand(piece, site.place(at, hand * far), site.facing + turn,
                             {1, site.random.uniform(0.97f, 1.03f), 1});
        });
        run(kEnd_m, [&](float at, std::uint32_t piece, float turn) {
            site.world.stand(piece, site.place(hand * aside, at), site.facing + 0.5f * kPi + turn,
                             {1, site.random.uniform(0.97f, 1.03f), 1});
        });
    }
}

// Distances so that no two of them touch.
bool is_free(std::vector<Vec3f>& taken, Vec2f at, float radius) {
    for (const Vec3f t : taken)
        if (length(Vec2f{t.x, t.y} - at) < t.z + radius) return false;
    taken.push_back({at.x, at.y, radius});
    return true;
}

void settle_neighbours(Site& site) {
    Random& r = site.random;
    std::vector<Vec3f> taken;
    std::array<std::uint32_t, 4> houses{};
    for (std::uint32_t& h : houses) h = site.world.add(build_house(site.world, r.next_u32()));
    const float first = site.turn();
    constexpr int kHouses = 11;
    for (int k = 0; k < kHouses; ++k) {
        if (r.chance(0.2f)) continue;
        const float azimuth = first + 2 * kPi * (static_cast<float>(k) + r.uniform(-0.2f, 0.2f)) / kHouses;
        const Vec2f at = site.polar(azimuth, r.uniform(34, 58));
        if (!is_free(taken, at, 8)) continue;
        site.world.stand(houses[static_cast<std::size_t>(k % 4)], at,
                         site.facing + 0.5f * kPi * static_cast<float>(r.index(4)) + r.uniform(-0.1f, 0.1f));
    }
    const std::vector<std::uint32_t> tall = tall_trees(site, 5), dark = spruces(site, 2, 12);
    for (int k = 0; k < 150; ++k) {
        const Vec2f at = site.polar(site.turn(), 25.5f + 80 * r.uniform());
        if (is_free(taken, at, 2.2f)) plant(site, r.chance(0.17f) ? dark : tall, at, r.uniform(0.6f, 1.05f));
    }
    // Copses and hedgerows, further off.
    for (int k = 0; k < 2400; ++k) {
        const float azimuth = site.turn(), far = 95 + 900 * std::pow(r.uniform(), 1.3f);
        const Vec2f at = site.polar(azimuth, far);
        if (noise2(at * (1 / 70.f) + Vec2f{30, 30}, site.sky.seed + 31) > 0.55f)
            plant(site, r.chance(0.25f) ? dark : tall, at, r.uniform(0.7f, 1.2f));
    }
}

}  // namespace

void lay_out_garden(Site& site) {
    site.world.eye_m = 2.1f;
    const std::uint32_t seed = site.sky.seed;
    site.world.height = [seed](Vec2f p) { return rolling(p, seed); };
    const Plot plot{site, seed, site.random.uniform(-2.5f, 2.5f)};
    const bool snow = site.sky.snow;
    site.world.ground = [seed, here = plot, snow](Vec3f at, float footprint) {
        const Vec2f p{at.x, at.z}, q = here.layout.laid_out(p);
        if (snow) return snow_albedo(p, footprint, seed);
        if (here.off_terrace(q) < 0) return paving(q, footprint, seed);
        if (here.inside(q) < 0) return country(p, footprint, seed);
        const float grain = fbm2(q * 18.f, 3, footprint * 18.f, seed + 5);
        if (here.off_path(q) < 0.1f * grain) return Vec3f{0.27f, 0.24f, 0.19f} * (0.6f + 0.8f * grain);
        if (here.is_border(q) || here.is_terrace_bed(q)) return Vec3f{0.055f, 0.04f, 0.028f} * (0.6f + 0.8f * grain);
        // Under its blades a lawn is darker.
        return lawn_albedo(p, footprint, seed) * (0.62f + 0.38f * smooth_step(13, 16.5f, length(p)));
    };
    sow_grass(site, 15.5f, 0.075f, [&](Vec2f p) { return plot.is_lawn(site.laid_out(p)); });
    plant_hedge(site);
    plant_borders(site, plot);
    settle_neighbours(site);
    std::vector<Vec3f> taken;
    const std::vector<std::uint32_t> trees = small_trees(site, 5);
    std::size_t next = 0;
    const float first = site.turn();
    constexpr int kTrees = 8;
    for (int k = 0; k < kTrees; ++k) {
        const float azimuth = first + 2 * kPi * (static_cast<float>(k) + site.random.uniform(-0.3f, 0.3f)) / kTrees;
        const Vec2f at = site.polar(azimuth, site.random.uniform(9.5f, 16.f));
        if (plot.inside(site.laid_out(at)) < 1.8f || plot.off_path(site.laid_out(at)) < 0.6f || !is_free(taken, at, 2))
            continue;
        plant(site, {trees[next++ % trees.size()]}, at);
    }
    spread_ground(site, 4200, 90, 360);
}

void lay_out_forest(Site& site) {
    site.world.eye_m = 2.3f;
    const std::uint32_t seed = site.sky.seed;
    const bool snow = site.sky.snow;
    site.world.height = [seed](Vec2f p) {
        return smooth_step(5, 40, length(p)) * 5.f * (fbm2(p * (1 / 38.f) + Vec2f{9, 9}, 4, 0, seed + 10) - 0.45f);
    };
    site.world.ground = [seed, snow](Vec3f at, float footprint) {
        const Vec2f p{at.x, at.z};
        if (snow) return snow_albedo(p, footprint, seed);
        const float moss = fbm2(p * 0.4f, 4, footprint * 0.4f, seed + 3),
                    litter = fbm2(p * 16.f, 4, footprint * 16.f, seed + 4);
        return lerp(Vec3f{0.125f, 0.09f, 0.06f}, Vec3f{0.06f, 0.078f, 0.03f}, smooth_step(0.42f, 0.62f, moss)) *
               (0.55f + 0.9f * litter);
    };
    Random& r = site.random;
    std::vector<std::uint32_t> woods;
    const std::array<TreeKind, 4> kinds{TreeKind{19.f, 5.5f, 4.2f, Crown::ovate, 0.15f, 42000},
                                        TreeKind{20.f, 10.f, 3.f, Crown::umbrella, 0.2f, 9000, kBark, true, 0.2f},
                                        TreeKind{16.f, 6.f, 2.4f, Crown::ovate, 0.11f, 36000, kBirchBark},
                                        TreeKind{17.f, 4.f, 3.8f, Crown::round, 0.14f, 42000}};
    for (const TreeKind& kind : kinds) woods.push_back(site.world.add(grow_tree(kind, r.next_u32(), snow)));
    const std::vector<std::uint32_t> dark = spruces(site, 3, 15), young = small_trees(site, 2);
    constexpr float kApart_m = 6.4f;
    for (int j = -15; j <= 15; ++j)
        for (int i = -15; i <= 15; ++i) {
            const Vec2f at{kApart_m * (static_cast<float>(i) + r.uniform(-0.42f, 0.42f)),
                           kApart_m * (static_cast<float>(j) + r.uniform(-0.42f, 0.42f))};
            if (length(at) < 13.f || length(at) > 95 || r.chance(length(at) < 34 ? 0.42f : 0.1f)) continue;
            plant(site,
                  r.chance(length(at) < 22 ? 0.08f : 0.26f) ? dark
                  : r.chance(0.15f)                         ? young
                                                            : woods,
                  at, r.uniform(0.62f, 0.92f));
        }
    if (!snow) {
        std::array<std::uint32_t, 3> ferns{};
        for (std::uint32_t& f : ferns) f = site.world.add(grow_fern(r.next_u32()));
        for (int k = 0; k < 900; ++k) {
            const Vec2f at = site.polar(site.turn(), 4.2f + 26 * r.uniform());
            if (noise2(at * 0.3f + Vec2f{50, 50}, seed + 15) < 0.46f) continue;
            const float s = r.uniform(0.7f, 1.35f);
            site.world.stand(ferns[static_cast<std::size_t>(r.index(3))], at, site.turn(), {s, s, s});
        }
        sow_grass(site, 12, 0.16f,
                  [&](Vec2f p) {
                      return length(p) > 3.5f && noise2(p * 0.5f + Vec2f{70, 70}, seed + 16) > 0.5f;
                  },
                  {0.9f, 0.85f, 0.8f});
    }
    spread_ground(site, 160, 60, 240);
}

}  // namespace fastscene::outdoors

#include "fastscene/trace/outdoors_site.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/trace/outdoors_site_parts.h"

namespace fastscene::outdoors {
namespace {

// Species, as a gardener would tell them apart: outline, density and size of leaf.
constexpr std::array<TreeKind, 5> kSmall{
    TreeKind{6.6f, 1.7f, 2.3f, Crown::round, 0.07f, 48000},                            // field maple
    TreeKind{9.f, 2.2f, 1.9f, Crown::ovate, 0.052f, 58000, kBirchBark, false, 0.35f},  // birch
    TreeKind{4.8f, 1.3f, 2.2f, Crown::umbrella, 0.065f, 36000, kBark, false, 0.6f},    // apple
    TreeKind{7.4f, 1.5f, 2.1f, Crown::ovate, 0.07f, 50000},                            // lime
    TreeKind{5.6f, 0.5f, 1.9f, Crown::round, 0.055f, 49000, kBark, false, 0.7f},       // serviceberry
};
constexpr std::array<TreeKind, 5> kTall{
    TreeKind{13.f, 2.4f, 4.6f, Crown::round, 0.115f, 96000},                        // oak
    TreeKind{15.f, 2.8f, 3.9f, Crown::ovate, 0.1f, 103000},                         // beech
    TreeKind{14.f, 3.2f, 2.6f, Crown::ovate, 0.075f, 86000, kBirchBark},            // birch
    TreeKind{17.f, 1.2f, 1.7f, Crown::columnar, 0.085f, 72000},                     // poplar
    TreeKind{14.f, 6.5f, 3.2f, Crown::umbrella, 0.15f, 16000, kBark, true, 0.35f},  // pine
};

template <std::size_t N>
std::vector<std::uint32_t> grown(Site& site, const std::array<TreeKind, N>& kinds, int count) {
    std::vector<std::uint32_t> meshes;
    const int first = site.random.index(static_cast<int>(N));
    for (int k = 0; k < count; ++k) {
        TreeKind kind = kinds[static_cast<std::size_t>(first + k) % N];
        kind.height_m *= site.random.uniform(0.88f, 1.12f), kind.radius_m *= site.random.uniform(0.85f, 1.15f);
        meshes.push_back(site.world.add(grow_tree(kind, site.random.next_u32(), site.sky.snow)));
    }
    return meshes;
}

}  // namespace

std::vector<std::uint32_t> small_trees(Site& site, int count) { return grown(site, kSmall, count); }
std::vector<std::uint32_t> tall_trees(Site& site, int count) { return grown(site, kTall, count); }
std::vector<std::uint32_t> spruces(Site& site, int count, float height) {
    std::vector<std::uint32_t> meshes;
    for (int k = 0; k < count; ++k) {
        const float tall = height * site.random.uniform(0.8f, 1.2f);
        meshes.push_back(
            site.world.add(grow_spruce(tall, tall * site.random.uniform(0.17f, 0.23f), site.random.next_u32())));
    }
    return meshes;
}

void plant(Site& site, const std::vector<std::uint32_t>& kinds, Vec2f at, float scale) {
    Random& r = site.random;
    const std::uint32_t mesh = kinds[static_cast<std::size_t>(r.index(static_cast<int>(kinds.size())))];
    const float wide = scale * r.uniform(0.88f, 1.14f), tall = scale * r.uniform(0.86f, 1.16f);
    // Warm or cool, light or dark green.
    const Vec3f tint = Vec3f{r.uniform(0.85f, 1.3f), 1.f, r.uniform(0.8f, 1.25f)} * r.uniform(0.72f, 1.15f);
    site.world.stand(mesh, at, site.turn(), {wide, tall, wide}, tint);
}

void sow_grass(Site& site, float reach, float high, const std::function<bool(Vec2f)>& grows, Vec3f tint) {
    if (site.sky.snow) return;
    constexpr float kPatch_m = 0.75f;
    constexpr float kWidth_m = 0.007f;
    constexpr int kKinds = 4, kBlades = 560;
    QuadMesh edge;
    std::array<std::uint32_t, kKinds> patches{};
    for (std::uint32_t& p : patches)
        p = site.world.add(grow_grass(kPatch_m * 1.1f, kBlades, high, kWidth_m, site.random.next_u32()));
    const int cells = static_cast<int>(reach / kPatch_m);
    for (int j = -cells; j <= cells; ++j)
        for (int i = -cells; i <= cells; ++i) {
            const Vec2f at{kPatch_m * static_cast<float>(i), kPatch_m * static_cast<float>(j)};
            Random r(site.sky.seed, "outdoors.lawn", static_cast<std::uint64_t>((i + 512) * 1024 + j + 512));
            if (length(at) > reach + 1.5f * (r.uniform() - 0.5f)) continue;
            // Where the lawn ends, blades are sown one by one.
            constexpr float kHalf_m = 0.5f * kPatch_m;
            int corners = 0;
            for (const Vec2f off :
                 {Vec2f{kHalf_m, kHalf_m}, {-kHalf_m, kHalf_m}, {kHalf_m, -kHalf_m}, {-kHalf_m, -kHalf_m}})
                corners += grows(at + off);
            if (corners == 0) continue;
            if (corners < 4) {
                for (int k = 0; k < kBlades * 3 / 4; ++k) {
                    const Vec2f p = at + Vec2f{r.uniform(-kHalf_m, kHalf_m), r.uniform(-kHalf_m, kHalf_m)};
                    if (grows(p)) add_blade(edge, {p.x, site.world.height(p), p.y}, high, kWidth_m, r);
                }
                continue;
            }
            site.world.stand(patches[static_cast<std::size_t>(r.index(kKinds))], at,
                             0.5f * kPi * static_cast<float>(r.index(4)), {1, r.uniform(0.8f, 1.25f), 1},
                             tint * Vec3f{r.uniform(0.92f, 1.14f), 1.f, 1.f} * r.uniform(0.9f, 1.08f));
        }
    site.world.instances.push_back({site.world.add(std::move(edge)), {}, {}, tint});
}

void spread_ground(Site& site, float reach, int rings, int around) {
    constexpr float kFirst_m = 0.8f;
    const float growth = std::pow(reach / kFirst_m, 1.f / static_cast<float>(rings));
    const World& world = site.world;
    const auto at = [&](int ring, int k) {
        const float far = kFirst_m * std::pow(growth, static_cast<float>(ring));
        const Vec2f p = site.polar(2 * kPi * static_cast<float>(k % around) / static_cast<float>(around), far);
        return Vec3f{p.x, world.height ? world.height(p) : 0.f, p.y};
    };
    QuadMesh mesh;
    std::vector<Vec3f> inner, outer;
    for (int k = 0; k < around; ++k) inner.push_back(at(0, k));
    for (int ring = 0; ring < rings; ++ring) {
        outer.clear();
        for (int k = 0; k < around; ++k) outer.push_back(at(ring + 1, k));
        for (int k = 0; k < around; ++k) {
            const auto a = static_cast<std::size_t>(k), b = static_cast<std::size_t>((k + 1) % around);
            mesh.quad(inner[a], inner[b], outer[b], outer[a], kGround);
        }
        inner.swap(outer);
    }
    // Below the viewer's feet.
    for (int k = 0; k < around; k += 2) mesh.quad({}, at(0, k), at(0, k + 1), at(0, k + 2), kGround);
    site.world.instances.push_back({site.world.add(std::move(mesh)), {}, {}});
}

Vec3f lawn_albedo(Vec2f p, float footprint, std::uint32_t seed) {
    const float mottle = fbm2(p * 0.35f, 4, footprint * 0.35f, seed + 3),
                fine = fbm2(p * 9.f, 3, footprint * 9.f, seed + 4);
    return lerp(Vec3f{0.056f, 0.076f, 0.03f}, Vec3f{0.095f, 0.107f, 0.048f}, mottle) * (0.7f + 0.6f * fine);
}

Vec3f snow_albedo(Vec2f p, float footprint, std::uint32_t seed) {
    return Vec3f{0.78f, 0.8f, 0.84f} * (0.92f + 0.12f * fbm2(p * 0.6f, 4, footprint * 0.6f, seed + 3));
}

World make_world(const Sky& sky, float facing) {
    Site site(sky, sky.view == Sky::View::street ? street_layout(facing) : Layout(facing));
    switch (sky.view) {
        case Sky::View::garden: lay_out_garden(site); break;
        case Sky::View::city: lay_out_city(site); break;
        case Sky::View::sea: lay_out_sea(site); break;
        case Sky::View::mountains: lay_out_mountains(site); break;
        case Sky::View::forest: lay_out_forest(site); break;
        case Sky::View::street: lay_out_street(site); break;
        case Sky::View::airfield: lay_out_airfield(site); break;
        case Sky::View::court: lay_out_court(site); break;
    }
    return std::move(site.world);
}

}  // namespace fastscene::outdoors

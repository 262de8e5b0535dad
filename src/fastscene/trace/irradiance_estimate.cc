// One-sample irradiance estimates: the cache stores their means, and pictures draw further ones where the cache is too
// coarse.
#include <algorithm>
#include <cmath>

#include "fastscene/base/parallel.h"
#include "fastscene/base/random.h"
#include "fastscene/trace/irradiance.h"
#include "fastscene/trace/irradiance_cells.h"
#include "fastscene/trace/response.h"
#include "fastscene/trace/surface.h"

namespace fastscene {

using namespace irradiance;

namespace {

// in cells: a sunlit cell closer than this is sampled too rarely and contributes too strongly (1/d2), so the bounce ray
// finds it instead
constexpr float kNearSun = 8;
constexpr float kShort = 0.9999f;  // shadow rays end just before their target, to not hit its own surface

// The material of the surface just ahead.
std::size_t material_at(const Room& room, const SceneBvh& bvh, Vec3f from, Vec3f direction) {
    const RayHit hit = bvh.first_lit(from, direction);
    return hit ? static_cast<std::size_t>(room.meshes[static_cast<std::size_t>(hit.mesh)].material) : 0;
}

}  // namespace

// Collects sunlit cells as light sources; curtains emit on both sides. Each is weighted by the share of sample points
// in the room that see it: the outer side of a curtain is bright but lights nothing.
void IrradianceCache::find_sun_patches(const Room& room, const SceneBvh& bvh, const std::vector<std::uint16_t>& sunny,
                                       std::uint64_t seed) {
    constexpr int kPlaces = 24;
    for (std::size_t c = 0; c < cells_.size(); ++c) {
        const Cell& cell = cells_[c];
        const Vec3f back = cell.sun * cell.albedo;
        if (!(luminance(back) * cell.area > 0)) continue;
        const auto add = [&](float side, Vec3f leaving) {
            const auto first = static_cast<std::uint32_t>(sun_places_.size());
            for (int s = 0; s < kSunSamples; ++s) {
                const Place& at = place(c, s);
                const Vec3f normal = at.normal * side;
                if (!(sunny[c] >> s & 1u)) continue;
                const Vec3f before = at.position + normal * distance_epsilon(at.position);
                sun_places_.push_back({{before, normal}, 0});
            }
            sun_patches_.push_back({first, static_cast<std::uint32_t>(sun_places_.size()) - first, cell.sun, leaving,
                                    cell.area, 0.f, side < 0});
        };
        add(1, back * (1.f - cell.transmission));
        if (cell.transmission > 0) add(-1, back * cell.transmission);
    }
    parallel_for(static_cast<std::int64_t>(sun_places_.size()), 1024, [&](std::int64_t begin, std::int64_t end) {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
            SunPlace& place = sun_places_[i];
            place.material = material_at(room, bvh, place.at.position, -place.at.normal);
        }
    });
    parallel_for(static_cast<std::int64_t>(sun_patches_.size()), 256, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            SunPatch& patch = sun_patches_[static_cast<std::size_t>(i)];
            Random random(seed, "usefulness", static_cast<std::uint64_t>(i));
            float seen = 0;
            for (int k = 0; k < kPlaces; ++k) {
                const Cell& place = cells_[static_cast<std::size_t>(random.index(static_cast<int>(cells_.size())))];
                const Place& shining = sun_places_[patch.first + static_cast<std::uint32_t>(k) % patch.count].at;
                const Vec3f from = place.center + place.normal * (0.05f * cell_m_), to = shining.position - from;
                const float far = length(to);
                if (!(dot(to, shining.normal) < 0 && dot(to, place.normal) > 0)) continue;
                seen += bvh.blocked(from, to / far, 0.f, far * kShort) ? 0.f : 1.f;
            }
            // Never zero: a point that was not tested may still see it.
            patch.useful = 0.02f + seen / kPlaces;
        }
    });
    add_sun_powers();
}

void IrradianceCache::add_sun_powers() {
    for (const SunPatch& patch : sun_patches_)
        sun_powers_.push_back((sun_powers_.empty() ? 0.f : sun_powers_.back()) +
                              luminance(patch.leaving) * patch.area * patch.useful);
}

// Uses the cache's own reflectance, with textures averaged out.
Vec3f IrradianceCache::reflected(const Room& room, std::size_t material, Vec3f normal, Vec3f direction,
                                 bool behind) const {
    return sun_reflected(room.sky, reflectances_[material], coats_[material], room.materials[material].transmission,
                         normal, direction, behind);
}

// Light from one sunlit patch, sampled by its power and visibility.
DirectedLight IrradianceCache::sunlit(const Room& room, const SceneBvh& bvh, const Place& at, float which) const {
    if (sun_powers_.empty() || !(sun_powers_.back() > 0)) return {};
    const float drawn = which * sun_powers_.back();
    const auto at_or_after = std::upper_bound(sun_powers_.begin(), sun_powers_.end(), drawn);
    const auto found = std::min(static_cast<std::size_t>(at_or_after - sun_powers_.begin()), sun_patches_.size() - 1);
    const SunPatch& patch = sun_patches_[found];
    // The remainder of the random number that chose the patch chooses the point on it.
    const float below = found > 0 ? sun_powers_[found - 1] : 0.f,
                share = (drawn - below) / std::max(1e-30f, sun_powers_[found] - below);
    const auto which_place = std::min(
        patch.count - 1, static_cast<std::uint32_t>(std::max(0.f, share) * static_cast<float>(patch.count)));
    const SunPlace& shining = sun_places_[patch.first + which_place];
    const Vec3f from = at.position + at.normal * distance_epsilon(at.position), to = shining.at.position - from;
    const float d2 = dot(to, to), far = std::sqrt(d2);
    if (!(far > kNearSun * cell_m_)) return {};
    const Vec3f direction = to / far;
    const float here = dot(at.normal, direction), there = -dot(shining.at.normal, direction);
    if (!(here > 0 && there > 0) || bvh.blocked(from, direction, 0.f, far * kShort)) return {};
    const float probability = luminance(patch.leaving) * patch.area * patch.useful / sun_powers_.back();
    return {patch.sun * reflected(room, shining.material, shining.at.normal, direction, patch.behind) *
                (here * there / d2 * patch.area / probability),
            direction};
}

IrradianceCache::Direct IrradianceCache::direct(const Room& room, const SceneBvh& bvh, const Lights& lights,
                                                const Place& at, float which, Vec2f uv) const {
    return {lights.sample(room, bvh, at.position, at.normal, which, uv), sunlit(room, bvh, at, which)};
}

IrradianceCache::Bounce IrradianceCache::bounced(const Room& room, const SceneBvh& bvh, const Lights& lights,
                                                 const Place& at, Vec2f uv) const {
    const Vec3f direction = cosine_direction(at.normal, uv);
    const Vec3f from = at.position + at.normal * distance_epsilon(at.position);
    const RayHit hit = bvh.first_lit(from, direction);
    if (!hit) return {};  // leaves through a window: counted with the windows
    const Mesh& mesh = room.meshes[static_cast<std::size_t>(hit.mesh)];
    if (hit.back && closed_[static_cast<std::size_t>(hit.mesh)]) return {{}, direction, hit.distance, true};
    const Vec3f p = from + direction * hit.distance;
    Vec3f normal = shading_normal(mesh, hit);
    if (hit.back) normal = -normal;
    const Material& m = room.materials[static_cast<std::size_t>(mesh.material)];
    const auto material = static_cast<std::size_t>(mesh.material);
    const Near front = near(p, normal), behind = m.transmission > 0 ? near(p, -normal) : Near{};
    Vec3f irradiance = reflectances_[material] * (front.light * (1.f - m.transmission) + behind.light * m.transmission);
    // The sun's first bounce was sampled directly, except close by.
    if (hit.distance <= kNearSun * cell_m_)
        irradiance += (front.sun * reflected(room, material, normal, direction, false) +
                       behind.sun * reflected(room, material, normal, direction, true)) *
                      kPi;
    if (lights.is_large(hit.mesh)) irradiance += mean_emission(m) * kPi;
    return {irradiance, direction, hit.distance, false};
}

}  // namespace fastscene

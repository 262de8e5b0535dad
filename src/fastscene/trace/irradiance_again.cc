// The light of a changed room: which entries keep what they have.
#include <algorithm>
#include <cmath>

#include "fastscene/base/parallel.h"
#include "fastscene/base/random.h"
#include "fastscene/image/color.h"
#include "fastscene/trace/irradiance.h"
#include "fastscene/trace/irradiance_cells.h"
#include "fastscene/trace/response.h"
#include "fastscene/trace/room_change.h"

namespace fastscene {

using namespace irradiance;

namespace {

// Of the irradiance. Two percent is visible side by side, not between two pictures.
constexpr float kMostChange = 0.03f, kMostChangeByLargeLamps = 0.01f;
// Below, gathering everything costs little more, and extrapolates the last bounces.
constexpr double kLeastKept = 0.2;
// Of the light in the room: how far the sun's first bounce may differ, which lights everything.
constexpr double kMostSunChange = 0.02;
constexpr float kNear = 2.f;  // in cells: closer to a changed surface everything is gathered again

}  // namespace

// The share of each entry's surroundings that changed: of the hemisphere above it, or of the light of lamps and windows
// that passes there, whichever is more. Neither knows what stands in between, so both are upper bounds. Averaged over
// neighbours, since a few rays miss a lot.
std::vector<float> IrradianceCache::share_of_change(const Room& room, const Lights& lights, const RoomChange& change,
                                                    std::uint64_t seed) const {
    constexpr int kRays = 16, kLightRays = 8;
    constexpr std::uint64_t kPass = 200;
    const SceneBvh changed(change.surfaces);
    std::vector<float> share(cells_.size());
    parallel_for(static_cast<std::int64_t>(cells_.size()), 1024, [&](std::int64_t begin, std::int64_t end) {
        for (auto c = static_cast<std::size_t>(begin); c < static_cast<std::size_t>(end); ++c) {
            Random random(random_key(c, kPass, seed));
            const Vec2f shift{random.uniform(), random.uniform()};
            int met = 0;
            for (int s = 0; s < kRays; ++s) {
                const Place& at = place(c, s);
                const Vec3f from = at.position + at.normal * distance_epsilon(at.position);
                met += changed.first_hit(from,
                                         cosine_direction(at.normal, r2_point(static_cast<std::uint32_t>(s), shift)))
                           ? 1
                           : 0;
            }
            float all = 0, lost = 0;
            for (int s = 0; s < kLightRays; ++s) {
                const Place& at = place(c, s);
                const Vec2f uv = r2_point(static_cast<std::uint32_t>(s), shift);
                const float which = (static_cast<float>(s) + random.uniform()) / kLightRays;
                const Lights::LightSample light = lights.draw(room, at.position, at.normal, which, uv);
                if (!(light.pdf > 0)) continue;
                const float bright = luminance(light.radiance) * std::max(0.f, dot(at.normal, light.direction)) /
                                     light.pdf;
                const Vec3f from = at.position + at.normal * distance_epsilon(at.position);
                all += bright;
                if (bright > 0 && changed.first_hit(from, light.direction, 0.f, light.far)) lost += bright;
            }
            share[c] = std::max(static_cast<float>(met) / kRays, all > 0 ? lost / all : 0.f);
            if (changed.nearest(cells_[c].center, kNear * cell_m_) < kNear * cell_m_) share[c] = 1;
        }
    });
    std::vector<float> mean(cells_.size());
    parallel_for(static_cast<std::int64_t>(cells_.size()), 1024, [&](std::int64_t begin, std::int64_t end) {
        for (auto c = static_cast<std::size_t>(begin); c < static_cast<std::size_t>(end); ++c) {
            const auto [x, y, z, facing] = place_of(keys_[c]);
            float sum = 0;
            int count = 0;
            for (int k = 0; k < 27; ++k) {
                const int n = find(x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1, facing);
                if (n >= 0) sum += share[static_cast<std::size_t>(n)], ++count;
            }
            mean[c] = count > 0 ? sum / static_cast<float>(count) : 1.f;
        }
    });
    return mean;
}

void IrradianceCache::keep_light(const Room& room, const Lights& lights, const Earlier& earlier, const Run& run) {
    const IrradianceCache& before = earlier.light;
    kept_.assign(cells_.size(), 0);
    std::vector<float> trust(cells_.size());
    for (std::size_t c = 0; c < cells_.size(); ++c) trust[c] = cells_[c].trust;
    if (earlier.change.lights || before.cell_m_ != cell_m_ || before.origin_ != origin_) return kept_.clear();
    const auto sun_of = [](const Cell& cell) { return luminance(cell.sun * cell.albedo) * cell.area; };
    double sun_change = 0, light = 0;
    std::vector<int> same(cells_.size());
    std::vector<bool> is_found(before.size());
    for (std::size_t c = 0; c < cells_.size(); ++c) {
        const auto [x, y, z, facing] = place_of(keys_[c]);
        same[c] = before.find(x, y, z, facing);
        if (same[c] < 0) {
            sun_change += sun_of(cells_[c]);
            continue;
        }
        is_found[static_cast<std::size_t>(same[c])] = true;
        const Cell& old = before.cells_[static_cast<std::size_t>(same[c])];
        sun_change += std::fabs(sun_of(cells_[c]) - sun_of(old));
        light += luminance(old.direct + old.indirect) * old.area;
    }
    for (std::size_t c = 0; c < before.size(); ++c)
        if (!is_found[c]) sun_change += sun_of(before.cells_[c]);
    if (sun_change > kMostSunChange * light) return kept_.clear();
    const std::vector<float> change = share_of_change(room, lights, earlier.change, run.seed);
    // Gathering rays find large lamps; what covers a little of the hemisphere may cover much of their light.
    bool has_large_lamp = false;
    for (std::size_t m = 0; m < room.meshes.size(); ++m) has_large_lamp |= lights.is_large(static_cast<int>(m));
    const float most = has_large_lamp ? kMostChangeByLargeLamps : kMostChange;
    std::size_t kept = 0;
    for (std::size_t c = 0; c < cells_.size(); ++c) {
        if (same[c] < 0) continue;
        const Cell& old = before.cells_[static_cast<std::size_t>(same[c])];
        cells_[c].indirect = old.indirect;  // where gathering begins: nearly all bounces are in it
        // What was not seen before was gathered with fewer paths.
        if (!(change[c] < most) || (cells_[c].seen && !old.seen)) continue;
        cells_[c].direct = old.direct;
        // As much as a gathered entry weighs where directions are smoothed.
        const float weight = luminance(old.direct + old.indirect);
        cells_[c].directed = {old.directed.gradient() * weight, weight};
        cells_[c].trust = old.trust;
        kept_[c] = 1, ++kept;
    }
    if (static_cast<double>(kept) >= kLeastKept * static_cast<double>(cells_.size())) return;
    for (std::size_t c = 0; c < cells_.size(); ++c) {
        cells_[c].indirect = {};
        if (is_kept(c)) cells_[c].direct = {}, cells_[c].directed = {}, cells_[c].trust = trust[c];
    }
    kept_.clear();
}

}  // namespace fastscene

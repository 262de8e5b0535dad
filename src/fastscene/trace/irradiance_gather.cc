// Filling the cache.
#include "fastscene/trace/irradiance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fastscene/base/parallel.h"
#include "fastscene/base/random.h"
#include "fastscene/trace/irradiance_cells.h"
#include "fastscene/trace/lights.h"
#include "fastscene/trace/response.h"
#include "fastscene/trace/surface.h"

namespace fastscene {

using namespace irradiance;

namespace {

constexpr float kPi = std::numbers::pi_v<float>;

// How well a mean is known by the numbers that it was made of.
struct Spread {
    float sum = 0, squares = 0, count = 0;
    void add(float v) { sum += v, squares += v * v, ++count; }
    float of_mean() const {
        if (!(count > 0)) return 0;
        const float mean = sum / count;
        return std::sqrt(std::max(0.f, squares / count - mean * mean) / count);
    }
};

// In a white room a tenth of the light has bounced more than eight times. After a few bounces each adds to the last in the same
// proportion, so the sum of all that follow is known: a geometric series.
class Rest {
  public:
    // The light of a room after one more pass -> what to multiply it by.
    Vec3f factor(Vec3f sum) {
        Vec3f out{1, 1, 1};
        const Vec3f step = sum - before_;
        for (std::size_t a = 0; a < 3; ++a) {
            // The ratio is seen while the passes are whole bounces; after that only small steps are left.
            if (passes_ == 1 || passes_ == 2) ratio_[a] = std::clamp(step[a] / std::max(1e-9f, step_[a]), 0.f, 0.9f);
            if (passes_ >= 2 && sum[a] > 0) out[a] = std::clamp(1 + step[a] * ratio_[a] / (1 - ratio_[a]) / sum[a], 0.5f, 3.f);
        }
        ++passes_;
        step_ = step;
        before_ = sum * out;
        return out;
    }

  private:
    int passes_ = 0;
    Vec3f before_{}, step_{}, ratio_{};
};

}  // namespace

// Cells that the sun reaches; curtains shine on both sides.
std::vector<IrradianceCache::SunPatch> IrradianceCache::sun_patches() const {
    std::vector<SunPatch> patches;
    for (const Cell& cell : cells_) {
        const Vec3f back = cell.sun * cell.albedo;
        if (!(luminance(back) * cell.area > 0)) continue;
        const float lift = 0.02f * cell_m_;
        patches.push_back({cell.center + cell.normal * lift, cell.normal, back * (1.f - cell.transmission), cell.area});
        if (cell.transmission > 0) patches.push_back({cell.center - cell.normal * lift, -cell.normal, back * cell.transmission, cell.area});
    }
    return patches;
}

// For each patch, the share of some places in the room that see it: the outer side of a curtain is bright and lights nothing.
std::vector<float> IrradianceCache::usefulness(const std::vector<SunPatch>& patches, const SceneBvh& bvh, std::uint64_t seed) const {
    constexpr int kPlaces = 24;
    std::vector<float> useful(patches.size());
    parallel_for(static_cast<std::int64_t>(patches.size()), 256, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const SunPatch& patch = patches[static_cast<std::size_t>(i)];
            Random random(seed, "usefulness", static_cast<std::uint64_t>(i));
            float seen = 0;
            for (int k = 0; k < kPlaces; ++k) {
                const Cell& place = cells_[static_cast<std::size_t>(random.index(static_cast<int>(cells_.size())))];
                const Vec3f from = place.center + place.normal * (0.05f * cell_m_), to = patch.position - from;
                const float far = length(to);
                if (!(dot(to, patch.normal) < 0 && dot(to, place.normal) > 0)) continue;
                seen += bvh.blocked(from, to / far, 0.f, far - 0.3f * cell_m_) ? 0.f : 1.f;
            }
            // Never quite zero: a few places may see it that were not asked.
            useful[static_cast<std::size_t>(i)] = 0.02f + seen / kPlaces;
        }
    });
    return useful;
}

IrradianceCache IrradianceCache::gather(const Room& room, const SceneBvh& bvh, const TraceParams& params, const Run& run) {
    IrradianceCache cache;
    cache.cell_m_ = params.cell_m;
    // An odd offset, so that walls do not lie on the borders of cells.
    cache.origin_ = room.min_corner + Vec3f{0.37f, 0.41f, 0.43f} * params.cell_m;
    std::vector<Vec3f> albedo;
    for (const Material& m : room.materials) albedo.push_back(mean_reflectance(m, mean_albedo(m)));
    cache.build(room, albedo);
    std::vector<bool> closed;
    for (const Mesh& mesh : room.meshes) closed.push_back(is_closed(mesh));
    cache.drop_unseen(bvh, closed);
    cache.index();
    const auto count = static_cast<std::int64_t>(cache.cells_.size());

    const Lights lights(room);
    const auto key = [&](std::size_t cell, std::uint64_t pass) { return run.seed ^ mix64(cache.keys_[cell] ^ mix64(pass)); };
    const auto sample_of = [&](std::size_t c, int i) -> const Sample& {
        const std::uint32_t first = cache.first_sample_[c], n = cache.first_sample_[c + 1] - first;
        return cache.samples_[first + static_cast<std::uint32_t>(i) % n];
    };
    // Gathering is three quarters of the work: progress counts cells over all passes.
    constexpr int kPasses = 6;
    Progress progress(run, "light", (count / 1024 + 1) * (kPasses + 1));

    // The sun first: what it lights is bright and small, and lights the rest of the room.
    parallel_for(count, 1024, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const auto c = static_cast<std::size_t>(i);
            Random random(key(c, 100));
            constexpr int kSunSamples = 16;
            Vec3f sun{};
            for (int s = 0; s < kSunSamples; ++s) sun += lights.sun(room, bvh, sample_of(c, s).position, sample_of(c, s).normal, {random.uniform(), random.uniform()});
            cache.cells_[c].sun = sun / static_cast<float>(kSunSamples);
        }
    });
    const std::vector<SunPatch> patches = cache.sun_patches();
    const std::vector<float> useful = cache.usefulness(patches, bvh, run.seed);
    std::vector<float> cumulative;
    for (std::size_t i = 0; i < patches.size(); ++i)
        cumulative.push_back((i ? cumulative.back() : 0.f) + luminance(patches[i].leaving) * patches[i].area * useful[i]);
    const bool sunny = !cumulative.empty() && cumulative.back() > 0;
    // A sunlit cell close by is asked too rarely and answers too loudly: within eight cells gathering finds it instead.
    const float near_sun = 8 * params.cell_m;

    // What arrives from one sunlit patch, drawn by its power and usefulness.
    const auto sunlit = [&](const Sample& at, float which) -> Vec3f {
        const auto found = static_cast<std::size_t>(std::upper_bound(cumulative.begin(), cumulative.end(), which * cumulative.back()) - cumulative.begin());
        const std::size_t picked = std::min(found, patches.size() - 1);
        const SunPatch& patch = patches[picked];
        const Vec3f from = at.position + at.normal * distance_epsilon(at.position), to = patch.position - from;
        const float d2 = dot(to, to), far = std::sqrt(d2);
        if (!(far > near_sun)) return {};
        const Vec3f direction = to / far;
        const float here = dot(at.normal, direction), there = -dot(patch.normal, direction);
        if (!(here > 0 && there > 0) || bvh.blocked(from, direction, 0.f, far - 0.3f * cache.cell_m_)) return {};
        const float chance = luminance(patch.leaving) * patch.area * useful[picked] / cumulative.back();
        return patch.leaving * (here * there / (kPi * d2) * patch.area / chance);
    };

    // Then lamps, windows and the first bounce of the sun, each asked directly.
    const int direct_samples = std::max(8, params.cell_samples / 2);
    std::vector<float> error(cache.cells_.size());   // standard errors of what was gathered
    parallel_for(count, 1024, [&](std::int64_t begin, std::int64_t end) {
        run.check_stop();
        for (std::int64_t i = begin; i < end; ++i) {
            const auto c = static_cast<std::size_t>(i);
            Cell& cell = cache.cells_[c];
            Random random(key(c, 0));
            const Lights::Choice choice = lights.choice_at(cell.center, cell.normal);
            const Vec2f shift{random.uniform(), random.uniform()};
            Vec3f direct{};
            Spread spread;
            for (int s = 0; s < direct_samples; ++s) {
                const Vec3f before = direct;
                const Sample& at = sample_of(c, s);
                const Vec2f uv = r2_point(static_cast<std::uint32_t>(s), shift);
                const float which = (static_cast<float>(s) + random.uniform()) / static_cast<float>(direct_samples);
                direct += lights.sample(room, bvh, choice, at.position, at.normal, {which, random.uniform()}, uv);
                if (sunny) direct += sunlit(at, which);
                spread.add(luminance(direct - before));
            }
            error[c] = spread.of_mean();
            cell.direct = direct / static_cast<float>(direct_samples);
        }
        progress.advance();
    });
    cache.despeckle(false);
    error = cache.pooled(error);
    for (const int step : {1, 2}) cache.smooth(false, step, error);

    // Everything else: what each entry sees of the others, pass by pass one bounce more. The first passes only bring the light
    // round the room, and what further bounces will add is foreseen (Rest); the mean of the last ones is kept.
    std::vector<Vec3f> gathered(cache.cells_.size());
    std::vector<Vec3f> kept(cache.cells_.size());
    std::vector<float> spoiled(cache.cells_.size());   // squared error of `kept`
    const int total = std::max(8, params.cell_samples);
    constexpr int kKept = 3;
    Rest rest;
    for (int pass = 0; pass < kPasses; ++pass) {
        const bool keep = pass >= kPasses - kKept;
        const int n = std::max(2, keep ? total / 4 : total / 12);
        parallel_for(count, 1024, [&](std::int64_t begin, std::int64_t end) {
            run.check_stop();
            for (std::int64_t i = begin; i < end; ++i) {
                const auto c = static_cast<std::size_t>(i);
                Random random(key(c, static_cast<std::uint64_t>(pass) + 1));
                const Vec2f shift{random.uniform(), random.uniform()};
                Vec3f sum{};
                Spread spread;
                int valid = 0;
                for (int s = 0; s < n; ++s) {
                    const Vec3f before = sum;
                    const Sample& at = sample_of(c, s);
                    const Vec2f uv = r2_point(static_cast<std::uint32_t>(s), shift);
                    const Vec3f direction = cosine_direction(at.normal, uv);
                    const Vec3f from = at.position + at.normal * distance_epsilon(at.position);
                    const RayHit hit = bvh.first_hit(from, direction);
                    if (!hit) {  // through a window: counted with the windows
                        spread.add(0);
                        ++valid;
                        continue;
                    }
                    const Mesh& mesh = room.meshes[static_cast<std::size_t>(hit.mesh)];
                    // A back face of a solid: this bit of surface is buried in it and nobody will see it.
                    if (hit.back && closed[static_cast<std::size_t>(hit.mesh)]) continue;
                    ++valid;
                    const Vec3f p = from + direction * hit.distance;
                    Vec3f normal = shading_normal(mesh, hit);
                    if (hit.back) normal = -normal;
                    const Material& m = room.materials[static_cast<std::size_t>(mesh.material)];
                    // The sun's first bounce has been asked directly, unless it is close by.
                    const bool with_sun = hit.distance <= near_sun;
                    Vec3f arriving = cache.near(p, normal, with_sun) * (1.f - m.transmission);
                    if (m.transmission > 0) arriving += cache.near(p, -normal, with_sun) * m.transmission;
                    sum += albedo[static_cast<std::size_t>(mesh.material)] * arriving;
                    if (lights.is_large(hit.mesh)) sum += m.emission * kPi;
                    spread.add(luminance(sum - before));
                }
                error[c] = spread.of_mean();
                if (keep) spoiled[c] += error[c] * error[c] * (1.f / (kKept * kKept));
                gathered[c] = valid ? sum / static_cast<float>(valid) : Vec3f{};
            }
            progress.advance();
        });
        for (std::size_t c = 0; c < cache.cells_.size(); ++c) {
            cache.cells_[c].indirect = gathered[c];
            if (keep) kept[c] += gathered[c] * (1.f / kKept);
        }
        if (!keep) {
            error = cache.pooled(error);
            for (const int step : {1, 2}) cache.smooth(true, step, error);
        }
        Vec3f sum{};
        for (const Cell& cell : cache.cells_) sum += cell.indirect * cell.area;
        const Vec3f more = rest.factor(sum);
        for (Cell& cell : cache.cells_) cell.indirect = cell.indirect * more;
    }
    for (std::size_t c = 0; c < cache.cells_.size(); ++c) cache.cells_[c].indirect = kept[c];
    cache.despeckle(true);
    // Entries are gathered one by one; what remains of their noise is spread over the neighbours, widely because bounced
    // light changes slowly.
    for (std::size_t c = 0; c < cache.cells_.size(); ++c) error[c] = std::sqrt(spoiled[c]);
    error = cache.pooled(error);
    for (const int step : {1, 2, 4, 1}) cache.smooth(true, step, error);
    cache.samples_ = {};
    return cache;
}

}  // namespace fastscene

// Filling the cache.
#include "fastscene/trace/irradiance.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "fastscene/base/parallel.h"
#include "fastscene/base/random.h"
#include "fastscene/trace/gatherer.h"
#include "fastscene/trace/irradiance_cells.h"
#include "fastscene/trace/noise.h"
#include "fastscene/trace/response.h"
#include "fastscene/trace/texture.h"

namespace fastscene {

using namespace irradiance;

namespace {

using Changed = Gatherer::Changed;
void tell(Gatherer* gatherer, const IrradianceCache::Tables& tables, std::initializer_list<Changed> changes) {
    if (!gatherer) return;
    for (const Changed what : changes) gatherer->update(tables, what);
}

constexpr int kPasses = 6;
constexpr int kUnseenShare = 3;                     // unseen cells get this fraction of the paths …
constexpr int kLeastDirect = 8, kLeastBounced = 2;  // … and at least these
// Harmonic mean distance to the surroundings, in cells: below the first an entry lies in a corner, above the second in
// the open.
constexpr float kNearCells = 4, kOpenCells = 9;
// Brighter than all neighbours but one by this factor is an unlikely path; once neighbours agree, a speck.
constexpr float kFirefly = 1.3f, kSpeck = 1.03f;

// Steps of the progress report.
std::int64_t blocks_of(std::size_t cells) { return static_cast<std::int64_t>(cells) / 1024 + 1; }

// Welford-style running variance of a mean.
struct Spread {
    float sum = 0, squares = 0, count = 0;
    void add(float v) { sum += v, squares += v * v, ++count; }
    float of_mean() const {
        if (!(count > 0)) return 0;
        const float mean = sum / count;
        return std::sqrt(std::max(0.f, squares / count - mean * mean) / count);
    }
};

// In a white room a tenth of the light has bounced more than eight times. After a few bounces each adds a constant
// fraction of the one before, so the remainder of the series is geometric and can be extrapolated.
class Rest {
  public:
    // Takes the total light after one more pass; returns the factor that extrapolates it.
    Vec3f factor(Vec3f sum) {
        Vec3f out{1, 1, 1};
        const Vec3f step = sum - before_;
        for (std::size_t a = 0; a < 3; ++a) {
            // The ratio is measurable while each pass is a full bounce; later only small increments are left.
            if (passes_ == 1 || passes_ == 2) ratio_[a] = std::clamp(step[a] / std::max(1e-9f, step_[a]), 0.f, 0.9f);
            if (passes_ >= 2 && sum[a] > 0)
                out[a] = std::clamp(1 + step[a] * ratio_[a] / (1 - ratio_[a]) / sum[a], 0.5f, 3.f);
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

const IrradianceCache::Place& IrradianceCache::place(std::size_t cell, int i) const {
    const std::uint32_t first = first_sample_[cell], n = first_sample_[cell + 1] - first;
    return samples_[first + static_cast<std::uint32_t>(i) % n];
}

std::uint64_t IrradianceCache::random_key(std::size_t cell, std::uint64_t pass, std::uint64_t seed) const {
    return seed ^ mix64(keys_[cell] ^ mix64(pass));
}

// Direct sun first: sunlit areas are small and bright, and light the rest of the room. Returns a bit mask per cell:
// which of its first kSunSamples points the sun reaches.
std::vector<std::uint16_t> IrradianceCache::light_by_sun(const Room& room, const SceneBvh& bvh, const Lights& lights,
                                                         Gatherer* gatherer, const Run& run) {
    constexpr std::uint64_t kSunPass = 100;
    std::vector<std::uint16_t> sunny(cells_.size());
    if (gatherer) {
        const auto found = gatherer->by_sun(run.seed, kSunPass, run);
        for (std::size_t c = 0; c < cells_.size(); ++c)
            cells_[c].sun = found[c].irradiance, sunny[c] = static_cast<std::uint16_t>(found[c].reached);
        return sunny;
    }
    parallel_for(static_cast<std::int64_t>(cells_.size()), 1024, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const auto c = static_cast<std::size_t>(i);
            Random random(random_key(c, kSunPass, run.seed));
            Vec3f sum{};
            for (int s = 0; s < kSunSamples; ++s) {
                const Vec3f sun = lights.sun(room, bvh, place(c, s).position, place(c, s).normal,
                                             {random.uniform(), random.uniform()});
                if (luminance(sun) > 0) sunny[c] = static_cast<std::uint16_t>(sunny[c] | 1u << s);
                sum += sun;
            }
            cells_[c].sun = sum / static_cast<float>(kSunSamples);
        }
    });
    return sunny;
}

// Then lamps, windows and the first bounce of the sun by next-event estimation.
void IrradianceCache::gather_direct(const Room& room, const SceneBvh& bvh, const Lights& lights, int samples,
                                    Gatherer* gatherer, const Run& run, Progress& progress) {
    std::vector<float> error(cells_.size());  // standard errors
    if (gatherer) {
        const auto found = gatherer->direct(samples, kLeastDirect, run.seed, 0, run);
        for (std::size_t c = 0; c < cells_.size(); ++c) {
            cells_[c].direct = found[c].irradiance, cells_[c].directed = found[c].directed;
            error[c] = found[c].error;
        }
        progress.advance(blocks_of(cells_.size()));
    } else
        parallel_for(static_cast<std::int64_t>(cells_.size()), 1024, [&](std::int64_t begin, std::int64_t end) {
            run.check_stop();
            for (std::int64_t i = begin; i < end; ++i) {
                const auto c = static_cast<std::size_t>(i);
                if (is_kept(c)) continue;
                Cell& cell = cells_[c];
                Random random(random_key(c, 0, run.seed));
                const Vec2f shift{random.uniform(), random.uniform()};
                const int asked = cell.seen ? samples : std::max(kLeastDirect, samples / kUnseenShare);
                Vec3f sum{};
                Spread spread;
                for (int s = 0; s < asked; ++s) {
                    const Vec2f uv = r2_point(static_cast<std::uint32_t>(s), shift);
                    const float which = (static_cast<float>(s) + random.uniform()) / static_cast<float>(asked);
                    const Place& at = place(c, s);
                    const Direct found = direct(room, bvh, lights, at, which, uv);
                    sum += found.irradiance();
                    spread.add(luminance(found.irradiance()));
                    const float share = 1 / static_cast<float>(asked);
                    for (const DirectedLight& light : {found.lights, found.sunlit})
                        cell.directed.add(light.irradiance * share, light.direction, at.normal);
                }
                error[c] = spread.of_mean();
                cell.direct = sum / static_cast<float>(asked);
            }
            progress.advance();
        });
    despeckle(false, kFirefly);
    error = pooled(error);
    for (const int step : {1, 2, 4}) smooth(false, step, error);
    despeckle(false, kSpeck);
}

// Accumulators of one pass over all cells.
struct IrradianceCache::Pass {
    int number = 0, rays = 0;
    std::vector<Vec3f> gathered;
    std::vector<float> error;              // standard errors
    std::vector<float> nearness;           // sum over passes of the mean inverse hit distance, 1/m
    std::vector<LightDirection> directed;  // of this pass
};

// One gathering pass: every entry reads the others, which adds one bounce.
void IrradianceCache::gather_pass(const Room& room, const SceneBvh& bvh, const Lights& lights, Gatherer* gatherer,
                                  const Run& run, Progress& progress, Pass& pass) {
    if (gatherer) {
        gatherer->update(tables(), Gatherer::Changed::light);
        const auto found = gatherer->bounced(pass.rays, kLeastBounced, run.seed,
                                             static_cast<std::uint64_t>(pass.number) + 1, run);
        for (std::size_t c = 0; c < cells_.size(); ++c) {
            pass.nearness[c] += found[c].nearness;
            pass.gathered[c] = found[c].irradiance, pass.directed[c] = found[c].directed;
            pass.error[c] = found[c].error;
        }
        progress.advance(blocks_of(cells_.size()));
        return;
    }
    parallel_for(static_cast<std::int64_t>(cells_.size()), 1024, [&](std::int64_t begin, std::int64_t end) {
        run.check_stop();
        for (std::int64_t i = begin; i < end; ++i) {
            const auto c = static_cast<std::size_t>(i);
            if (is_kept(c)) {
                pass.gathered[c] = cells_[c].indirect;
                continue;
            }
            Random random(random_key(c, static_cast<std::uint64_t>(pass.number) + 1, run.seed));
            const Vec2f shift{random.uniform(), random.uniform()};
            const int rays = cells_[c].seen ? pass.rays : std::max(kLeastBounced, pass.rays / kUnseenShare);
            Vec3f sum{};
            Spread spread;
            int valid = 0;
            for (int s = 0; s < rays; ++s) {
                const Bounce bounce = bounced(room, bvh, lights, place(c, s),
                                              r2_point(static_cast<std::uint32_t>(s), shift));
                pass.nearness[c] += 1 / ((bounce.distance + 1e-3f) * static_cast<float>(rays));
                // The point lies inside a solid; no camera will see it.
                if (bounce.buried) continue;
                ++valid;
                sum += bounce.irradiance;
                spread.add(luminance(bounce.irradiance));
                pass.directed[c].add(bounce.irradiance, bounce.direction, place(c, s).normal);
            }
            pass.error[c] = spread.of_mean();
            pass.gathered[c] = valid ? sum / static_cast<float>(valid) : Vec3f{};
        }
        progress.advance();
    });
}

// Indirect light, pass by pass. The first passes only distribute light around the room, with the remaining bounces
// extrapolated (Rest); the result is the mean of the later ones.
void IrradianceCache::gather_indirect(const Room& room, const SceneBvh& bvh, const Lights& lights, int samples,
                                      Gatherer* gatherer, const Run& run, Progress& progress) {
    constexpr int kKept = 3;
    const std::size_t count = cells_.size();
    Pass pass{0, 0, std::vector<Vec3f>(count), std::vector<float>(count), std::vector<float>(count), {}};
    std::vector<Vec3f> kept(count);
    std::vector<float> spoiled(count);  // squared error of `kept`
    Rest rest;
    // Of a changed room nearly all light is there: the first passes, with few rays, would only disturb it.
    const int first = kept_.empty() ? 0 : kPasses - kKept;
    for (pass.number = first; pass.number < kPasses; ++pass.number) {
        const bool keep = pass.number >= kPasses - kKept;
        pass.rays = std::max(2, keep ? samples / 4 : samples / 12);
        pass.directed.assign(count, {});
        gather_pass(room, bvh, lights, gatherer, run, progress, pass);
        for (std::size_t c = 0; c < count; ++c) {
            cells_[c].indirect = pass.gathered[c];
            if (!keep || is_kept(c)) continue;
            kept[c] += pass.gathered[c] * (1.f / kKept);
            cells_[c].directed.add(pass.directed[c], 1.f / static_cast<float>(kKept * pass.rays));
            spoiled[c] += pass.error[c] * pass.error[c] * (1.f / (kKept * kKept));
        }
        if (!keep) {
            std::vector<float> error = pooled(pass.error);
            for (const int step : {1, 2}) smooth(true, step, error);
        }
        if (!kept_.empty()) continue;  // what was kept holds all bounces
        Vec3f sum{};
        for (const Cell& cell : cells_) sum += cell.indirect * cell.area;
        const Vec3f more = rest.factor(sum);
        for (Cell& cell : cells_) cell.indirect = cell.indirect * more;
    }
    for (std::size_t c = 0; c < count; ++c) {
        if (is_kept(c)) continue;
        cells_[c].indirect = kept[c];
        const float around = static_cast<float>(kPasses - first) / std::max(1e-6f, pass.nearness[c]) /
                             cell_m_;  // harmonic mean distance, in cells
        cells_[c].trust *= smooth_step(kNearCells, kOpenCells, around);
    }
    despeckle(true, kFirefly);
    // Entries are independent estimates; their remaining noise is filtered over neighbours, with a wide kernel since
    // indirect light varies slowly.
    std::vector<float> error(count);
    for (std::size_t c = 0; c < count; ++c) error[c] = std::sqrt(spoiled[c]);
    error = pooled(error);
    for (const int step : {1, 2, 4, 8, 16, 1}) smooth(true, step, error);
    despeckle(true, kSpeck);
}

// Halls have larger cells, so that their light costs about as much as that of a home: one sees them from farther away.
float IrradianceCache::coarseness(const Room& room) {
    constexpr float kHome_m2 = 160.f, kMost = 2.f;  // floor, ceiling and walls of a large living room; factor
    const Vec3f size = room.max_corner - room.min_corner;
    const float surface = 2.f * (size.x * size.y + size.y * size.z + size.z * size.x);
    return std::clamp(std::sqrt(surface / kHome_m2), 1.f, kMost);
}

void IrradianceCache::place_cells(const Room& room, const SceneBvh& bvh, const TraceParams& params,
                                  const std::vector<Vec3f>& viewpoints, Gatherer* gatherer, const Run& run) {
    cell_m_ = params.cell_m * coarseness(room);
    // An odd offset keeps walls off the cell boundaries.
    origin_ = room.min_corner + Vec3f{0.37f, 0.41f, 0.43f} * cell_m_;
    know_surfaces(room);
    build(room);
    tell(gatherer, tables(), {Changed::places});
    drop_hidden(gatherer ? gatherer->visibility(run) : visibility(bvh));
    tell(gatherer, tables(), {Changed::places, Changed::light});
    find_seen(bvh, viewpoints, gatherer, run);
    index();
    tell(gatherer, tables(), {Changed::places, Changed::index});  // seen cells get more paths
}

void IrradianceCache::gather_sun(const Room& room, const SceneBvh& bvh, const Lights& lights, Gatherer* gatherer,
                                 const Run& run) {
    find_sun_patches(room, bvh, light_by_sun(room, bvh, lights, gatherer, run), run.seed);
    tell(gatherer, tables(), {Changed::sun});
}

void IrradianceCache::gather_rest(const Room& room, const SceneBvh& bvh, const Lights& lights,
                                  const TraceParams& params, Gatherer* gatherer, const Run& run) {
    // Gathering is three quarters of the work: progress counts cells over all passes.
    Progress progress(run, "light", blocks_of(cells_.size()) * (kPasses + 1));
    gather_direct(room, bvh, lights, std::max(kLeastDirect, params.cell_samples / 2), gatherer, run, progress);
    gather_indirect(room, bvh, lights, std::max(8, params.cell_samples), gatherer, run, progress);
    smooth_directions();
    distrust_edges();
}

IrradianceCache IrradianceCache::gather(const Room& room, const SceneBvh& bvh, const Lights& lights,
                                        const TraceParams& params, const Run& run, const std::vector<Vec3f>& viewpoints,
                                        Gatherer* gatherer) {
    IrradianceCache cache;
    cache.place_cells(room, bvh, params, viewpoints, gatherer, run);
    cache.gather_sun(room, bvh, lights, gatherer, run);
    cache.gather_rest(room, bvh, lights, params, gatherer, run);
    cache = cache.rounded(room);
    tell(gatherer, cache.tables(), {Changed::light, Changed::sun});
    return cache;
}

IrradianceCache IrradianceCache::gather_again(const Room& room, const SceneBvh& bvh, const Lights& lights,
                                              const TraceParams& params, const Run& run,
                                              const std::vector<Vec3f>& viewpoints, const Earlier& earlier) {
    IrradianceCache cache;
    cache.place_cells(room, bvh, params, viewpoints, nullptr, run);
    cache.gather_sun(room, bvh, lights, nullptr, run);
    cache.keep_light(room, lights, earlier, run);
    const auto kept = std::count(cache.kept_.begin(), cache.kept_.end(), 1);
    cache.gather_rest(room, bvh, lights, params, nullptr, run);
    cache = cache.rounded(room);
    cache.kept_share_ = static_cast<double>(kept) / static_cast<double>(std::max<std::size_t>(1, cache.size()));
    return cache;
}

}  // namespace fastscene

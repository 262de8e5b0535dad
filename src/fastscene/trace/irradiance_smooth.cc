// Noise filtering over neighbouring entries.
#include "fastscene/trace/irradiance.h"

#include <algorithm>
#include <cmath>

#include "fastscene/base/parallel.h"
#include "fastscene/trace/irradiance_cells.h"
#include "fastscene/trace/noise.h"

namespace fastscene {

using namespace irradiance;

// An entry far brighter than all but one of its neighbours on the same surface is a firefly and is clamped to them.
// Genuinely small and bright areas, such as the wall behind a candle, cover more than one cell.
void IrradianceCache::despeckle(bool indirect) {
    std::vector<Vec3f> out(cells_.size());
    parallel_for(static_cast<std::int64_t>(cells_.size()), 1024, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const auto c = static_cast<std::size_t>(i);
            const Vec3f here = out[c] = indirect ? cells_[c].indirect : cells_[c].direct;
            if (is_kept(c)) continue;
            const auto [x, y, z, facing] = place_of(keys_[c]);
            float first = 0, second = 0;
            int neighbours = 0;
            for (int k = 0; k < 27; ++k) {
                const int n = k == 13 ? -1 : find(x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1, facing);
                if (n < 0) continue;
                const Cell& other = cells_[static_cast<std::size_t>(n)];
                if (!(dot(other.normal, cells_[c].normal) > 0.7f)) continue;
                const float bright = luminance(indirect ? other.indirect : other.direct);
                ++neighbours;
                if (bright > first) second = first, first = bright;
                else second = std::max(second, bright);
            }
            constexpr float kTolerated = 1.3f;
            const float bright = luminance(here);
            if (neighbours >= 4 && bright > kTolerated * second) out[c] = here * (kTolerated * second / bright);
        }
    });
    for (std::size_t c = 0; c < cells_.size(); ++c) (indirect ? cells_[c].indirect : cells_[c].direct) = out[c];
}

// A few samples cannot estimate their own error: if none of them hit the lamp, they all agree. The error is pooled over
// neighbours.
std::vector<float> IrradianceCache::pooled(const std::vector<float>& error) const {
    std::vector<float> out(cells_.size());
    parallel_for(static_cast<std::int64_t>(cells_.size()), 1024, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const auto c = static_cast<std::size_t>(i);
            const auto [x, y, z, facing] = place_of(keys_[c]);
            float sum = 0;
            int count = 0;
            for (int k = 0; k < 27; ++k) {
                const int n = find(x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1, facing);
                if (n < 0) continue;
                sum += error[static_cast<std::size_t>(n)] * error[static_cast<std::size_t>(n)];
                ++count;
            }
            out[c] = std::sqrt(sum / static_cast<float>(count));
        }
    });
    return out;
}

// One à-trous level (Dammertz et al. 2010): averages each entry with its neighbours on the same surface, `step` cells
// apart. Differences larger than the noise reduce the weight (Schied et al. 2017); the standard errors in `error` are
// reduced accordingly. Steps of 1, 2, 4 … give a wide filter at few taps.
void IrradianceCache::smooth(bool indirect, int step, std::vector<float>& error) {
    constexpr float kDeviations = 2.f, kAlways = 0.02f;
    std::vector<Vec3f> out(cells_.size());
    std::vector<float> left(cells_.size());
    parallel_for(static_cast<std::int64_t>(cells_.size()), 1024, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const auto c = static_cast<std::size_t>(i);
            const Cell& cell = cells_[c];
            const Vec3f here = indirect ? cell.indirect : cell.direct;
            if (is_kept(c)) {
                out[c] = here;
                continue;
            }
            const auto [x, y, z, facing] = place_of(keys_[c]);
            const float base = luminance(here), always = kAlways * base + 1e-6f;
            Vec3f sum{};
            float weight = 0, squares = 0;
            for (int k = 0; k < 27; ++k) {
                const int dx = k % 3 - 1, dy = k / 3 % 3 - 1, dz = k / 9 - 1;
                const int n = k == 13 ? static_cast<int>(c) : find(x + dx * step, y + dy * step, z + dz * step, facing);
                if (n < 0) continue;
                const auto j = static_cast<std::size_t>(n);
                const Cell& other = cells_[j];
                const float agree = dot(other.normal, cell.normal);
                if (!(agree > 0.7f)) continue;
                // A neighbour on another level (table top and floor) does not count.
                const float off = std::abs(dot(other.center - cell.center, cell.normal)) / cell_m_;
                const Vec3f value = indirect ? other.indirect : other.direct;
                const float difference = luminance(value) - base;
                const float tolerance = kDeviations * kDeviations * (error[c] * error[c] + error[j] * error[j]) +
                                        always * always;
                const float w = std::exp(-0.55f * static_cast<float>(dx * dx + dy * dy + dz * dz) -
                                         difference * difference / tolerance - 2.f * off * off) *
                                agree * agree;
                sum += value * w;
                weight += w;
                squares += w * w * error[j] * error[j];
            }
            out[c] = sum / weight;
            left[c] = std::sqrt(squares) / weight;
        }
    });
    error = std::move(left);
    for (std::size_t c = 0; c < cells_.size(); ++c) (indirect ? cells_[c].indirect : cells_[c].direct) = out[c];
}

// Directions are means over few paths; relief shading would show their noise as blotches a cell wide.
void IrradianceCache::smooth_directions() {
    constexpr int kRounds = 2;
    std::vector<LightDirection> out(cells_.size());
    for (int round = 0; round < kRounds; ++round) {
        parallel_for(static_cast<std::int64_t>(cells_.size()), 1024, [&](std::int64_t begin, std::int64_t end) {
            for (auto c = static_cast<std::size_t>(begin); c < static_cast<std::size_t>(end); ++c) {
                if (is_kept(c)) {
                    out[c] = cells_[c].directed;
                    continue;
                }
                const auto [x, y, z, facing] = place_of(keys_[c]);
                LightDirection sum;
                for (int k = 0; k < 27; ++k) {
                    const int n = k == 13 ? static_cast<int>(c)
                                          : find(x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1, facing);
                    if (n < 0) continue;
                    const Cell& other = cells_[static_cast<std::size_t>(n)];
                    if (dot(other.normal, cells_[c].normal) > 0.7f) sum.add(other.directed, 1.f);
                }
                out[c] = sum;
            }
        });
        for (std::size_t c = 0; c < cells_.size(); ++c) cells_[c].directed = out[c];
    }
}

// Where light varies from cell to cell (shadow edges, the foot of a lamp), the cells are too coarse and smoothing has
// leaked across the edge. Trust is lowered there, so that pictures sample the light themselves.
void IrradianceCache::distrust_edges() {
    constexpr float kSteady = 1.6f, kEdge = 2.4f;  // ratio of two neighbours, brighter to darker
    std::vector<float> trust(cells_.size());
    parallel_for(static_cast<std::int64_t>(cells_.size()), 1024, [&](std::int64_t begin, std::int64_t end) {
        for (auto c = static_cast<std::size_t>(begin); c < static_cast<std::size_t>(end); ++c) {
            const Cell& cell = cells_[c];
            trust[c] = cell.trust;
            if (!(cell.trust > 0) || is_kept(c)) continue;
            const auto [x, y, z, facing] = place_of(keys_[c]);
            const float here = luminance(cell.direct + cell.indirect) + 1e-6f;
            float most = 1;
            for (int k = 0; k < 27; ++k) {
                const int n = k == 13 ? -1 : find(x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1, facing);
                if (n < 0) continue;
                const Cell& other = cells_[static_cast<std::size_t>(n)];
                if (!(dot(other.normal, cell.normal) > 0.7f) ||
                    std::abs(dot(other.center - cell.center, cell.normal)) > 0.3f * cell_m_)
                    continue;
                const float there = luminance(other.direct + other.indirect) + 1e-6f;
                most = std::max({most, here / there, there / here});
            }
            trust[c] *= 1 - smooth_step(kSteady, kEdge, most);
        }
    });
    for (std::size_t c = 0; c < cells_.size(); ++c) cells_[c].trust = trust[c];
}

}  // namespace fastscene

// What is left of the noise, spread over neighbours.
#include "fastscene/trace/irradiance.h"

#include <algorithm>
#include <cmath>

#include "fastscene/base/parallel.h"
#include "fastscene/trace/irradiance_cells.h"
#include "fastscene/trace/noise.h"

namespace fastscene {

using namespace irradiance;

// An entry far brighter than all but one of its neighbours on the same surface caught a lucky path: it is held to them.
// What is really that bright and that small (a candle's own wall) covers more than one cell.
void IrradianceCache::despeckle(bool indirect) {
    std::vector<Vec3f> out(cells_.size());
    parallel_for(static_cast<std::int64_t>(cells_.size()), 1024, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const auto c = static_cast<std::size_t>(i);
            const Vec3f here = out[c] = indirect ? cells_[c].indirect : cells_[c].direct;
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

// A few samples know little of their own error: where none of them met the lamp they seem to agree. Neighbours know
// together.
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

// Averages each entry with its neighbours on the same surface, `step` cells apart; those that differ by more than noise
// explains count less. Steps of 1, 2, 4 … one after the other make a wide filter of few taps (Dammertz et al. 2010),
// guided by the standard error of each entry's luminance (Schied et al. 2017), which falls by what averaging gains.
void IrradianceCache::smooth(bool indirect, int step, std::vector<float>& error) {
    constexpr float kDeviations = 2.f, kAlways = 0.02f;
    std::vector<Vec3f> out(cells_.size());
    std::vector<float> left(cells_.size());
    parallel_for(static_cast<std::int64_t>(cells_.size()), 1024, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const auto c = static_cast<std::size_t>(i);
            const Cell& cell = cells_[c];
            const Vec3f here = indirect ? cell.indirect : cell.direct;
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
                // A step between two levels (table top and floor) is no neighbour.
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

// Where light changes from cell to cell (the edge of a shadow, the foot of a lamp) the cells are too coarse for it, and
// smoothing carried it across; what is left of noise looks the same. Pictures ask again there.
void IrradianceCache::distrust_edges() {
    constexpr float kSteady = 1.6f, kEdge = 2.4f;  // of two neighbours, the brighter by the darker
    std::vector<float> trust(cells_.size());
    parallel_for(static_cast<std::int64_t>(cells_.size()), 1024, [&](std::int64_t begin, std::int64_t end) {
        for (auto c = static_cast<std::size_t>(begin); c < static_cast<std::size_t>(end); ++c) {
            const Cell& cell = cells_[c];
            trust[c] = cell.trust;
            if (!(cell.trust > 0)) continue;
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

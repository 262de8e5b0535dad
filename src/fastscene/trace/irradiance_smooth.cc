// Noise filtering over neighbouring entries.
#include "fastscene/trace/irradiance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fastscene/base/parallel.h"
#include "fastscene/trace/irradiance_cells.h"
#include "fastscene/trace/noise.h"

namespace fastscene {

using namespace irradiance;

// An entry far brighter or darker than all but one of its neighbours on the same surface is a speck and is clamped to
// them. Genuinely small and bright areas, such as the wall behind a candle, cover more than one cell. `tolerated`:
// ratio of its light to that of the neighbour.
void IrradianceCache::despeckle(bool indirect, float tolerated) {
    constexpr float kOffSurface = 0.3f;  // in cells
    constexpr int kLeastNeighbours = 4;
    std::vector<Vec3f> out(cells_.size());
    parallel_for(static_cast<std::int64_t>(cells_.size()), 1024, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const auto c = static_cast<std::size_t>(i);
            const Vec3f here = out[c] = indirect ? cells_[c].indirect : cells_[c].direct;
            if (is_kept(c)) continue;
            const auto [x, y, z, facing] = place_of(keys_[c]);
            std::array<float, 26> around;
            int neighbours = 0;
            for (int k = 0; k < 27; ++k) {
                const int n = k == 13 ? -1 : find(x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1, facing);
                if (n < 0) continue;
                const Cell& other = cells_[static_cast<std::size_t>(n)];
                if (!(dot(other.normal, cells_[c].normal) > 0.7f) ||
                    std::abs(dot(other.center - cells_[c].center, cells_[c].normal)) > kOffSurface * cell_m_)
                    continue;
                around[static_cast<std::size_t>(neighbours++)] = luminance(indirect ? other.indirect : other.direct);
            }
            if (neighbours < kLeastNeighbours) continue;
            std::sort(around.begin(), around.begin() + neighbours);
            const float bright = luminance(here), least = around[1] / tolerated,
                        most = around[static_cast<std::size_t>(neighbours) - 2] * tolerated;
            if (bright > most) out[c] = here * (most / bright);
            else if (bright < least) out[c] = here * (least / std::max(bright, 1e-9f));
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

namespace {

// A neighbour in smooth(): its light, its squared standard error, and how far its surface is the same, in [0, 1].
struct Neighbour {
    Vec3f light{};
    float error2 = 0, same = 0;
};

// Edge-stopping weight for a difference in luminance of the given squared standard error.
float within_noise(float difference, float error2, float base) {
    constexpr float kDeviations = 2.f, kAlways = 0.02f;
    const float always = kAlways * base + 1e-6f;
    return std::exp(-difference * difference / (kDeviations * kDeviations * error2 + always * always));
}

// Two directions in the plane of a surface, at right angles, each as long as it takes to reach the next cell.
std::pair<Vec3f, Vec3f> surface_axes(Vec3f normal) {
    std::size_t least = 0;
    for (const std::size_t a : {1, 2})
        if (std::abs(normal[a]) < std::abs(normal[least])) least = a;
    Vec3f axis{};
    axis[least] = 1;
    const auto to_next_cell = [](Vec3f v) {
        return v / std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z), 1e-6f});
    };
    const Vec3f across = cross(normal, axis);
    return {to_next_cell(across), to_next_cell(cross(normal, across))};
}

}  // namespace

// The entry of a point in the plane of a surface that faces this way: of the cell around the point, or of the one
// before or behind it, where the surface hardly touches that cell.
int IrradianceCache::near_plane(Vec3f point, int facing) const {
    const Vec3f q = (point - origin_) / cell_m_;
    const std::array<std::int32_t, 3> at{cell_index(q.x), cell_index(q.y), cell_index(q.z)};
    for (const int off : {0, -1, 1}) {
        std::array<std::int32_t, 3> cell = at;
        cell[static_cast<std::size_t>(facing) / 2] += off;
        if (const int n = find(cell[0], cell[1], cell[2], facing); n >= 0) return n;
    }
    return -1;
}

// One à-trous level (Dammertz et al. 2010): averages each entry with its neighbours on the same surface, `step` cells
// apart. Differences larger than the noise reduce the weight (Schied et al. 2017); the standard errors in `error` are
// reduced accordingly. Opposite neighbours are compared as a pair, by their mean: light that changes evenly across a
// wall is no edge. Steps of 1, 2, 4 … give a wide filter at few taps.
void IrradianceCache::smooth(bool indirect, int step, std::vector<float>& error) {
    constexpr float kSameSurface = 0.5f;
    constexpr float kBeside = 0.577f;  // a Gaussian of 0.95 steps, one step away; for diagonals, its square
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
            const auto [across, along] = surface_axes(cell.normal);
            const int facing = place_of(keys_[c]).facing;
            const auto neighbour = [&](Vec3f way) -> Neighbour {
                const int n = near_plane(cell.center + way * (static_cast<float>(step) * cell_m_), facing);
                if (n < 0) return {};
                const auto j = static_cast<std::size_t>(n);
                const Cell& other = cells_[j];
                const float agree = dot(other.normal, cell.normal);
                if (!(agree > 0.7f)) return {};
                // A neighbour on another level (table top and floor) does not count.
                const float off = std::abs(dot(other.center - cell.center, cell.normal)) / cell_m_;
                return {indirect ? other.indirect : other.direct, error[j] * error[j],
                        agree * agree * std::exp(-2.f * off * off)};
            };
            const float base = luminance(here), own2 = error[c] * error[c];
            Vec3f sum = here;
            float weight = 1, squares = own2;
            const auto add = [&](const Neighbour& other, float w) {
                sum += other.light * w;
                weight += w;
                squares += w * w * other.error2;
            };
            const auto add_pair = [&](Vec3f way, float near) {
                const Neighbour a = neighbour(way), b = neighbour(-way);
                if (std::min(a.same, b.same) > kSameSurface) {
                    const float difference = 0.5f * luminance(a.light + b.light) - base;
                    const float w = near * std::min(a.same, b.same) *
                                    within_noise(difference, 0.25f * (a.error2 + b.error2) + own2, base);
                    add(a, w), add(b, w);
                    return;
                }
                for (const Neighbour& one : {a, b})
                    if (one.same > 0)
                        add(one, near * one.same * within_noise(luminance(one.light) - base, one.error2 + own2, base));
            };
            for (const Vec3f way : {across, along}) add_pair(way, kBeside);
            for (const Vec3f way : {across + along, across - along}) add_pair(way, kBeside * kBeside);
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

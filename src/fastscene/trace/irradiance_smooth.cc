// What is left of the noise, spread over neighbours.
#include "fastscene/trace/irradiance.h"

#include <algorithm>
#include <cmath>

#include "fastscene/base/parallel.h"
#include "fastscene/trace/irradiance_cells.h"

namespace fastscene {

using namespace irradiance;

// An entry far brighter than all but one of its neighbours on the same surface caught a lucky path: it is held to them. What
// is really that bright and that small (a candle's own wall) covers more than one cell.
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

// Averages each entry with its neighbours on the same surface; those that differ by much more than noise does count less.
void IrradianceCache::smooth(bool indirect, int radius, float tolerance) {
    std::vector<Vec3f> out(cells_.size());
    parallel_for(static_cast<std::int64_t>(cells_.size()), 1024, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const auto c = static_cast<std::size_t>(i);
            const Cell& cell = cells_[c];
            const Vec3f here = indirect ? cell.indirect : cell.direct;
            const auto [x, y, z, facing] = place_of(keys_[c]);
            const float base = luminance(here);
            Vec3f sum{};
            float weight = 0;
            for (int dz = -radius; dz <= radius; ++dz)
                for (int dy = -radius; dy <= radius; ++dy)
                    for (int dx = -radius; dx <= radius; ++dx) {
                        const int n = find(x + dx, y + dy, z + dz, facing);
                        if (n < 0) continue;
                        const Cell& other = cells_[static_cast<std::size_t>(n)];
                        const float agree = dot(other.normal, cell.normal);
                        if (!(agree > 0.7f)) continue;
                        // A step between two levels (table top and floor) is no neighbour.
                        const float off = std::abs(dot(other.center - cell.center, cell.normal)) / cell_m_;
                        const Vec3f value = indirect ? other.indirect : other.direct;
                        const float difference = (luminance(value) - base) / (tolerance * (base + 0.02f));
                        const float r2 = static_cast<float>(dx * dx + dy * dy + dz * dz) / static_cast<float>(radius * radius);
                        const float w = std::exp(-1.2f * r2 - difference * difference - 2.f * off * off) * agree * agree;
                        sum += value * w;
                        weight += w;
                    }
            out[c] = weight > 0 ? sum / weight : here;
        }
    });
    for (std::size_t c = 0; c < cells_.size(); ++c) (indirect ? cells_[c].indirect : cells_[c].direct) = out[c];
}

}  // namespace fastscene

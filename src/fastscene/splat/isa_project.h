// Projection of 16 splats at a time into Records.
#pragma once

#include "fastscene/splat/kernel.h"
#include "fastscene/splat/lanes.h"
#include "fastscene/splat/sh_color.h"

namespace fastscene::splat::FASTSCENE_ISA {

inline Gaussian<Lanes> load_gaussians(const float* block) {
    const auto at = [&](int i) { return Lanes::load(block + i * kBlock); };
    return {
        {at(0), at(1), at(2)}, {at(3), at(4), at(5)}, {at(6), at(7), at(8), at(9)}, at(10), {at(11), at(12), at(13)}};
}
inline Vec3<Lanes> spread(Vec3f a) { return {a.x, a.y, a.z}; }
inline Lens<Lanes> spread(const Lens<float>& l) {
    return {{spread(l.rotation.row0), spread(l.rotation.row1), spread(l.rotation.row2)},
            spread(l.translation),
            l.fx,
            l.fy,
            l.cx,
            l.cy,
            l.min_u,
            l.max_u,
            l.min_v,
            l.max_v,
            l.model,
            l.antialias,
            l.low_pass_px2};
}

// Contribution of SH degrees >= 1 to the color of the block starting at splat `first`.
inline Vec3<Lanes> more_color_of(const float* rest, int degree, std::int64_t first, const Vec3<Lanes>& mean,
                                 const Lens<Lanes>& lens) {
    if (!rest) return {};
    const float* block = rest + first * 3 * rest_functions(degree);
    return more_color(degree, sight_of(mean, lens.camera_center()),
                      [&](int i) { return Lanes::load(block + i * kBlock); });
}

// The copy of a splat on the other side of an equirectangular picture's seam. Splats wider than the whole picture are
// clipped.
inline Record across_seam(Record r, bool to_right, const Lanes& half_x, int lane, const ProjectJob& job) {
    alignas(64) float half[kBlock];
    half_x.store(half);
    const float width = static_cast<float>(job.width);
    r.x += to_right ? width : -width;
    const float low = r.x - half[lane] - 0.5f, high = r.x + half[lane] - 0.5f;
    const int left = low > 0.f ? static_cast<int>(low < width - 1 ? low : width - 1) / kTile : 0;
    const int right = high < width - 1 ? static_cast<int>(high > 0.f ? high : 0.f) / kTile : (job.width - 1) / kTile;
    r.tile_x = static_cast<std::uint16_t>(left), r.tiles_wide = static_cast<std::uint16_t>(right - left + 1);
    return r;
}

inline PieceCount project_piece(const ProjectJob& job, std::int64_t begin, std::int64_t end) {
    const FlushDenormals flush;
    const Lens<Lanes> lens = spread(job.lens);
    const bool equirect = job.lens.equirect();
    const std::int64_t start = begin * records_a_splat(job.lens.model);
    PieceCount count;
    const auto add = [&](const Record& record) {
        const std::int64_t at = start + count.records++;
        Record& r = job.records[at] = record;
        r.first_slot = count.slots;
        count.slots += static_cast<std::uint32_t>(r.tiles_wide) * r.tiles_high;
        job.keys[at] = static_cast<std::uint64_t>(__builtin_bit_cast(std::uint32_t, r.depth_z)) << 32 |
                       static_cast<std::uint64_t>(at);
        job.boxes[at] = {r.tile_x, r.tile_y, r.tiles_wide, r.tiles_high};
    };
    for (std::int64_t first = begin; first < end; first += kBlock) {
        const Gaussian<Lanes> g = load_gaussians(job.parameters + first * kParameters);
        // Most splats are behind the camera: skip whole blocks early.
        const Lanes z = dot(lens.rotation.row2, g.mean) + lens.translation.z;
        if (!equirect && !(z > Lanes(kNearM)).bits()) continue;
        const Projection<Lanes> p = project(g, lens, more_color_of(job.rest, job.degree, first, g.mean, lens));
        const Footprint<Lanes> f = footprint_of(p, lens);
        // Half sizes of the bounding box of the ellipse on which alpha is kMinAlpha.
        const Lanes reach2 = max(reach2_of(p), Lanes(0.f));
        const Lanes half_x = sqrt(reach2 * p.cov_xx), half_y = sqrt(reach2 * p.cov_yy);
        const Lanes left = f.x - half_x - Lanes(0.5f), right = f.x + half_x - Lanes(0.5f);
        const Lanes top = f.y - half_y - Lanes(0.5f), bottom = f.y + half_y - Lanes(0.5f);
        const Lanes last_x(static_cast<float>(job.width - 1)), last_y(static_cast<float>(job.height - 1));
        const Mask in_height = is_drawable(g, p) & (bottom >= Lanes(0.f)) & (top <= last_y);
        const Mask shown = equirect ? in_height : in_height & (right >= Lanes(0.f)) & (left <= last_x);
        std::uint32_t bits = shown.bits();
        if (end - first < kBlock) bits &= (1u << (end - first)) - 1;
        if (!bits) continue;
        std::uint32_t to_right = 0, to_left = 0;  // splats with a copy one picture width to the right, to the left
        if (equirect) to_right = (left < Lanes(0.f)).bits(), to_left = (right > last_x).bits();
        static_assert(kTile == 16);
        const Lanes corner = sixteenths(max(left, Lanes(0.f)), max(top, Lanes(0.f))),
                    far_corner = sixteenths(min(right, last_x), min(bottom, last_y));
        const Lanes half_b = f.b * Lanes(-0.5f);
        // One field of Record per row; transposed, one record per row.
        Lanes rows[16] = {f.x,
                          f.y,
                          f.a,
                          f.b,
                          f.c,
                          f.log2_opacity,
                          f.color.x,
                          f.color.y,
                          f.color.z,
                          f.depth_z,
                          half_b / f.c,
                          half_b / f.a,
                          lane_numbers(static_cast<std::int32_t>(first)),
                          Lanes(0.f),
                          corner,
                          spans(corner, far_corner)};
        transpose16(rows);
        Record record[kBlock];
        __builtin_memcpy(record, rows, sizeof record);
        for (; bits; bits &= bits - 1) {
            const int lane = __builtin_ctz(bits);
            add(record[lane]);
            if ((to_right | to_left) >> lane & 1)
                add(across_seam(record[lane], to_right >> lane & 1, half_x, lane, job));
        }
    }
    return count;
}

}  // namespace fastscene::splat::FASTSCENE_ISA

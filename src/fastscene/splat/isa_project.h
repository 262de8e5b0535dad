// Projection of 16 splats at a time into Records.
#pragma once

#include "fastscene/splat/kernel.h"
#include "fastscene/splat/lanes.h"
#include "fastscene/splat/sh_color.h"

namespace fastscene::splat::FASTSCENE_ISA {

inline Gaussian<Lanes> load_gaussians(const float* block) {
    const auto at = [&](int i) { return Lanes::load(block + i * kBlock); };
    return {{at(0), at(1), at(2)}, {at(3), at(4), at(5)}, {at(6), at(7), at(8), at(9)}, at(10), {at(11), at(12), at(13)}};
}
inline Vec3<Lanes> spread(Vec3f a) { return {a.x, a.y, a.z}; }
inline Lens<Lanes> spread(const Lens<float>& l) {
    return {{spread(l.rotation.row0), spread(l.rotation.row1), spread(l.rotation.row2)},
            spread(l.translation), l.fx, l.fy, l.cx, l.cy, l.min_u, l.max_u, l.min_v, l.max_v, l.model, l.antialias};
}

// What the higher bands add to the color of the block that starts at splat `first`.
inline Vec3<Lanes> more_color_of(const float* rest, int degree, std::int64_t first, const Vec3<Lanes>& mean, const Lens<Lanes>& lens) {
    if (!rest) return {};
    const float* block = rest + first * 3 * rest_functions(degree);
    return more_color(degree, sight_of(mean, lens.camera_center()), [&](int i) { return Lanes::load(block + i * kBlock); });
}

// What is written out of the vectors, one row of 16 floats each.
struct Spill {
    enum { kX, kY, kA, kB, kC, kOpacity, kR, kG, kBlue, kZ, kLeft, kRight, kTop, kBottom, kRows };
    alignas(64) float at[kRows][kBlock];
};

inline Record record_of(const Spill& s, int lane, std::uint32_t splat) {
    const auto get = [&](int row) { return s.at[row][lane]; };
    Record r{};
    r.x = get(Spill::kX), r.y = get(Spill::kY);
    r.a = get(Spill::kA), r.b = get(Spill::kB), r.c = get(Spill::kC);
    r.log2_opacity = get(Spill::kOpacity);
    r.color[0] = get(Spill::kR), r.color[1] = get(Spill::kG), r.color[2] = get(Spill::kBlue);
    r.depth_z = get(Spill::kZ);
    r.dy_per_dx = -0.5f * r.b / r.c;
    r.dx_per_dy = -0.5f * r.b / r.a;
    r.splat = splat;
    const int left = static_cast<int>(get(Spill::kLeft)) / kTile, right = static_cast<int>(get(Spill::kRight)) / kTile;
    const int top = static_cast<int>(get(Spill::kTop)) / kTile, bottom = static_cast<int>(get(Spill::kBottom)) / kTile;
    r.tile_x = static_cast<std::uint16_t>(left), r.tile_y = static_cast<std::uint16_t>(top);
    r.tiles_wide = static_cast<std::uint16_t>(right - left + 1), r.tiles_high = static_cast<std::uint16_t>(bottom - top + 1);
    return r;
}

// The other half of a splat that the seam cuts. One that reaches around more than the whole picture is cut there.
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

inline std::int64_t project_piece(const ProjectJob& job, std::int64_t begin, std::int64_t end) {
    const FlushDenormals flush;
    const Lens<Lanes> lens = spread(job.lens);
    const bool equirect = job.lens.equirect();
    Record* const start = job.records + begin * records_a_splat(job.lens.model);
    Record* out = start;
    Spill spill;
    for (std::int64_t first = begin; first < end; first += kBlock) {
        const Gaussian<Lanes> g = load_gaussians(job.parameters + first * kParameters);
        // Most splats lie behind the camera: skip the rest of the work when a whole block does.
        const Lanes z = dot(lens.rotation.row2, g.mean) + lens.translation.z;
        if (!equirect && !(z > Lanes(kNearM)).bits()) continue;
        const Projection<Lanes> p = project(g, lens, more_color_of(job.rest, job.degree, first, g.mean, lens));
        const Footprint<Lanes> f = footprint_of(p, lens);
        // Half sizes of the box around the ellipse on which alpha is kMinAlpha.
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
        std::uint32_t to_right = 0, to_left = 0;  // splats that also show a picture's width to the right, to the left
        if (equirect) to_right = (left < Lanes(0.f)).bits(), to_left = (right > last_x).bits();
        const Lanes rows[Spill::kRows] = {f.x, f.y, f.a, f.b, f.c, f.log2_opacity, f.color.x, f.color.y, f.color.z, f.depth_z,
                                          max(left, Lanes(0.f)), min(right, last_x), max(top, Lanes(0.f)), min(bottom, last_y)};
        for (int i = 0; i < Spill::kRows; ++i) rows[i].store(spill.at[i]);
        for (; bits; bits &= bits - 1) {
            const int lane = __builtin_ctz(bits);
            *out++ = record_of(spill, lane, static_cast<std::uint32_t>(first + lane));
            if ((to_right | to_left) >> lane & 1) *out = across_seam(out[-1], to_right >> lane & 1, half_x, lane, job), ++out;
        }
    }
    return out - start;
}

}  // namespace fastscene::splat::FASTSCENE_ISA

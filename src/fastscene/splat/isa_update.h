// The last part of a step for 16 splats: sum their gradient slots, go back through the projection, and
// let Adam (Kingma and Ba 2015) move the parameters. All splats move every step, seen or not: for short
// runs the momentum of the unseen ones pays.
#pragma once

#include "fastscene/splat/isa_project.h"
#include "fastscene/splat/project_grad.h"

namespace fastscene::splat::FASTSCENE_ISA {

inline constexpr float kBeta1 = 0.9f, kBeta2 = 0.999f, kEpsilon = 1e-15f;

// Adds the slots of the block's records to `sums` (one row a splat); returns which splats were seen.
inline std::uint32_t sum_slots(const UpdateJob& job, std::int64_t block_end, std::int64_t& record, std::int64_t record_end,
                               Lanes* sums) {
    std::uint32_t seen = 0;
    for (; record < record_end && job.records[record].splat < block_end; ++record) {
        const Record& r = job.records[record];
        const int lane = static_cast<int>(r.splat % kBlock);
        const int slots = r.tiles_wide * r.tiles_high;
        const float* in = job.slots + static_cast<std::size_t>(r.first_slot) * kSlotFloats;
        Lanes sum;
        // The four floats read past a slot belong to the next one (or to the padding at the end) and end in unused columns.
        for (int i = 0; i < slots; ++i) sum += Lanes::load(in + i * kSlotFloats);
        sums[lane] = sum;
        seen |= 1u << lane;
    }
    return seen;
}

inline void adam(const UpdateJob& job, std::int64_t at, int parameter, Lanes gradient) {
    float *m = job.first_moment + at, *v = job.second_moment + at, *x = job.parameters + at;
    const Lanes m1 = Lanes::load(m) * Lanes(kBeta1) + gradient * Lanes(1.f - kBeta1);
    const Lanes v1 = Lanes::load(v) * Lanes(kBeta2) + gradient * gradient * Lanes(1.f - kBeta2);
    m1.store(m);
    v1.store(v);
    const Lanes root = sqrt(v1) * Lanes(job.inv_sqrt_bias2) + Lanes(kEpsilon);
    (Lanes::load(x) - Lanes(job.rate[parameter]) * m1 * reciprocal(root)).store(x);
}

inline void update_piece(const UpdateJob& job, std::int64_t begin, std::int64_t end, std::int64_t record, std::int64_t record_end) {
    const FlushDenormals flush;
    const Lens<Lanes> lens = spread(job.lens);
    for (std::int64_t first = begin; first < end; first += kBlock) {
        Lanes sums[16];
        Lanes gradient[kParameters];
        const std::int64_t base = first * kParameters;
        if (const std::uint32_t seen = sum_slots(job, first + kBlock, record, record_end, sums)) {
            transpose16(sums);
            const Gaussian<Lanes> g = load_gaussians(job.parameters + base);
            const Projection<Lanes> p = project(g, lens);
            const PixelSums<Lanes> s{sums[0], sums[1], sums[2], sums[3], sums[4], sums[5], {sums[6], sums[7], sums[8]}};
            const Gaussian<Lanes> d = project_grad(g, lens, p, s);
            const Lanes all[kParameters] = {d.mean.x,     d.mean.y,     d.mean.z,     d.log_scale.x, d.log_scale.y, d.log_scale.z, d.rotation.w,
                                            d.rotation.x, d.rotation.y, d.rotation.z, d.logit,       d.sh0.x,       d.sh0.y,       d.sh0.z};
            alignas(64) float lane_seen[kBlock];
            for (int i = 0; i < kBlock; ++i) lane_seen[i] = seen >> i & 1 ? 1.f : 0.f;
            const Lanes was_seen = Lanes::load(lane_seen);
            // Unseen lanes may hold anything, also NaN; so may splats at the edge of what floats can do.
            for (int i = 0; i < kParameters; ++i)
                gradient[i] = select((was_seen > Lanes(0.f)) & (abs(all[i]) < Lanes(1e15f)), all[i], Lanes(0.f));
            if (job.seen_weight) (Lanes::load(job.seen_weight + first) + sums[9]).store(job.seen_weight + first);
            if (job.seen_error) (Lanes::load(job.seen_error + first) + sums[10]).store(job.seen_error + first);
        }
        for (int i = 0; i < kParameters; ++i) {
            if (job.gradients)
                gradient[i].store(job.gradients + base + i * kBlock);
            else
                adam(job, base + i * kBlock, i, gradient[i]);
        }
    }
}

}  // namespace fastscene::splat::FASTSCENE_ISA

// The last part of a step, for 16 splats: sums their gradient slots, backpropagates through the projection and applies
// Adam (Kingma and Ba 2015). All splats are updated in every step, visible or not: in short runs the momentum of
// invisible ones helps.
#pragma once

#include "fastscene/splat/isa_project.h"
#include "fastscene/splat/project_grad.h"

namespace fastscene::splat::FASTSCENE_ISA {

inline constexpr float kBeta1 = 0.9f, kBeta2 = 0.999f;

// Adds the slots of the block's records to `sums` (one row per splat); returns a mask of visible splats.
inline std::uint32_t sum_slots(const UpdateJob& job, std::int64_t block_end, std::int64_t& record,
                               std::int64_t record_end, const float* piece_slots, Lanes* sums) {
    std::uint32_t seen = 0;
    for (; record < record_end && job.records[record].splat < block_end; ++record) {
        const Record& r = job.records[record];
        const int lane = static_cast<int>(r.splat % kBlock);
        const int slots = r.tiles_wide * r.tiles_high;
        const float* in = piece_slots + static_cast<std::size_t>(r.first_slot) * kSlotFloats;
        Lanes sum;
        // The loads read four floats past a slot, from the next one (or padding); they end in unused columns.
        for (int i = 0; i < slots; ++i) sum += Lanes::load(in + i * kSlotFloats);
        // two records of one splat, one on each side of the seam
        sums[lane] = seen >> lane & 1 ? sums[lane] + sum : sum;
        seen |= 1u << lane;
    }
    return seen;
}

// Step size factors for positions beyond the reach.
inline Lanes stride(const UpdateJob& job, std::int64_t base) {
    const auto off = [&](int axis, float middle) {
        return Lanes::load(job.parameters + base + axis * kBlock) - Lanes(middle);
    };
    const Vec3<Lanes> d{off(0, job.middle.x), off(1, job.middle.y), off(2, job.middle.z)};
    return max(Lanes(1.f), sqrt(dot(d, d)) * Lanes(1.f / job.reach_m));
}

inline void adam(const UpdateJob& job, std::int64_t at, Lanes rate, Lanes gradient) {
    float *m = job.first_moment + at, *v = job.second_moment + at, *x = job.parameters + at;
    const Lanes m1 = Lanes::load(m) * Lanes(kBeta1) + gradient * Lanes(1.f - kBeta1);
    const Lanes v1 = Lanes::load(v) * Lanes(kBeta2) + gradient * gradient * Lanes(1.f - kBeta2);
    m1.store(m);
    v1.store(v);
    const Lanes root = sqrt(v1) * Lanes(job.inv_sqrt_bias2) + Lanes(kAdamEpsilon);
    (Lanes::load(x) - rate * m1 * reciprocal(root)).store(x);
}

// SH degrees >= 1, for splats visible in this step only: updating all moments would dominate memory traffic.
inline void update_rest(const UpdateJob& job, std::int64_t first, const Lanes* gradient, Mask seen) {
    const int n = 3 * rest_functions(job.degree);
    const std::int64_t base = first * n;
    for (int i = 0; i < n; ++i) {
        const std::int64_t at = base + i * kBlock;
        const Lanes g = select(seen & (abs(gradient[i]) < Lanes(1e15f)), gradient[i], Lanes(0.f));
        if (job.rest_gradients) {
            g.store(job.rest_gradients + at);
            continue;
        }
        const Lanes m0 = Lanes::load(job.rest_first_moment + at), v0 = Lanes::load(job.rest_second_moment + at),
                    x0 = Lanes::load(job.rest + at);
        const Lanes m1 = m0 * Lanes(kBeta1) + g * Lanes(1.f - kBeta1),
                    v1 = v0 * Lanes(kBeta2) + g * g * Lanes(1.f - kBeta2);
        const Lanes root = sqrt(v1) * Lanes(job.rest_inv_sqrt_bias2) + Lanes(kAdamEpsilon);
        select(seen, m1, m0).store(job.rest_first_moment + at);
        select(seen, v1, v0).store(job.rest_second_moment + at);
        select(seen, x0 - Lanes(job.rest_rate) * m1 * reciprocal(root), x0).store(job.rest + at);
    }
}

// Gradient of the regularizers on opacity and size, the same for all splats.
inline void pull(const UpdateJob& job, const Gaussian<Lanes>& g, Lanes* gradient) {
    const Lanes one(1.f), opacity = one / (one + exp(-g.logit)),
                          slope = opacity * (one - opacity) * Lanes(job.opacity_reg);
    const auto add = [&](int i, Lanes x) { gradient[i] += select(abs(x) < Lanes(1e15f), x, Lanes(0.f)); };
    add(10, slope);
    for (int a = 0; a < 3; ++a) add(3 + a, exp(g.log_scale[static_cast<std::size_t>(a)]) * Lanes(job.scale_reg));
}

inline void update_piece(const UpdateJob& job, std::int64_t begin, std::int64_t end, std::int64_t record,
                         std::int64_t record_end, const float* slots) {
    const FlushDenormals flush;
    const Lens<Lanes> lens = spread(job.lens);
    for (std::int64_t first = begin; first < end; first += kBlock) {
        Lanes sums[16];
        Lanes gradient[kParameters];
        const std::int64_t base = first * kParameters;
        // Prefetches the three memory streams two blocks ahead.
        if (constexpr std::int64_t kAhead = 2 * kBlock; !job.gradients && first + kAhead < end)
            for (std::int64_t i = base + kAhead * kParameters; i < base + (kAhead + kBlock) * kParameters; i += kBlock)
                for (const float* stream : {job.parameters, job.first_moment, job.second_moment})
                    __builtin_prefetch(stream + i, 1);
        if (const std::uint32_t seen = sum_slots(job, first + kBlock, record, record_end, slots, sums)) {
            transpose16(sums);
            const Gaussian<Lanes> g = load_gaussians(job.parameters + base);
            const Projection<Lanes> p = project(g, lens, more_color_of(job.rest, job.degree, first, g.mean, lens));
            const PixelSums<Lanes> s{sums[0], sums[1], sums[2], sums[3], sums[4], sums[5], {sums[6], sums[7], sums[8]},
                                     sums[11]};
            Gaussian<Lanes> d = project_grad(g, lens, p, s);
            Lanes rest_gradient[kMostRest];
            if (job.rest) {
                const float* block = job.rest + first * 3 * rest_functions(job.degree);
                d.mean += more_color_grad(
                    job.degree, sight_of(g.mean, lens.camera_center()), d.sh0 * Lanes(1.f / kSh0),
                    [&](int i) { return Lanes::load(block + i * kBlock); }, rest_gradient);
            }
            const Lanes all[kParameters] = {d.mean.x,      d.mean.y,     d.mean.z,     d.log_scale.x, d.log_scale.y,
                                            d.log_scale.z, d.rotation.w, d.rotation.x, d.rotation.y,  d.rotation.z,
                                            d.logit,       d.sh0.x,      d.sh0.y,      d.sh0.z};
            alignas(64) float lane_seen[kBlock];
            for (int i = 0; i < kBlock; ++i) lane_seen[i] = seen >> i & 1 ? 1.f : 0.f;
            const Lanes was_seen = Lanes::load(lane_seen);
            if (job.rest && (job.rest_rate > 0 || job.rest_gradients))
                update_rest(job, first, rest_gradient, was_seen > Lanes(0.f));
            if (job.seen_move) {
                const Vec2<Lanes> move = screen_grad(p, s);
                const Lanes size = select(was_seen > Lanes(0.f), sqrt(dot(move, move)) * Lanes(job.half_picture),
                                          Lanes(0.f));
                (Lanes::load(job.seen_move + first) + select(size < Lanes(1e15f), size, Lanes(0.f)))
                    .store(job.seen_move + first);
                (Lanes::load(job.seen_steps + first) + was_seen).store(job.seen_steps + first);
            }
            // Lanes of invisible splats may hold anything, including NaN, and so may splats at the limits of float.
            for (int i = 0; i < kParameters; ++i)
                gradient[i] = select((was_seen > Lanes(0.f)) & (abs(all[i]) < Lanes(1e15f)), all[i], Lanes(0.f));
            const auto note = [&](float* at, Lanes x) {
                (Lanes::load(at) + select((was_seen > Lanes(0.f)) & (abs(x) < Lanes(1e15f)), x, Lanes(0.f))).store(at);
            };
            if (job.seen_weight) note(job.seen_weight + first, sums[9]);
            if (job.seen_error) note(job.seen_error + first, sums[10]);
        }
        if (job.opacity_reg > 0 || job.scale_reg > 0) pull(job, load_gaussians(job.parameters + base), gradient);
        const Lanes far = stride(job, base);
        for (int i = 0; i < kParameters; ++i) {
            if (job.gradients) gradient[i].store(job.gradients + base + i * kBlock);
            else adam(job, base + i * kBlock, i < 3 ? Lanes(job.rate[i]) * far : Lanes(job.rate[i]), gradient[i]);
        }
    }
}

}  // namespace fastscene::splat::FASTSCENE_ISA

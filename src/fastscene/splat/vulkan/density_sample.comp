// Samples splats by their error: the nth sample takes a splat unless an earlier one did. Lists the dead splats, too.
#version 460
#include "tables.glsl"
#include "density.glsl"

shared uint flags[256];  // 1: dead

// A hash of the seed, the step and the sample (PCG, O'Neill 2014), uniform in [0, 1).
float uniform_of(uint sample_index) {
    uint x = plan.degree;  // the seed of this step
    for (uint round = 0; round < 2; ++round) {
        x = (x ^ sample_index) * 747796405u + 2891336453u;
        x = ((x >> ((x >> 28) + 4)) ^ x) * 277803737u;
        x = x >> 22 ^ x;
    }
    return float(x >> 8) / 16777216.0;
}

uint sampled(float target) {
    uint low = 0, high = groups();  // the last group whose sum before does not exceed the target
    while (high - low > 1) {
        const uint middle = (low + high) / 2;
        if (t.density_errors.at[middle] <= target) low = middle;
        else high = middle;
    }
    float sum = t.density_errors.at[low];
    uint last = kNoKey;
    const uint begin = low * kGroupSplats, end = min(begin + kGroupSplats, t.counters.count);
    for (uint i = begin; i < end; ++i) {
        const float error = error_of(i);
        if (error <= 0.0) continue;
        last = i;
        sum += error;
        if (sum > target) break;
    }
    return last;
}

void main() {
    if (has_failed()) return;
    const uint i = gl_GlobalInvocationID.x;
    if (i < wanted()) {
        const uint from = t.density.error > 0.0 ? sampled(uniform_of(i) * t.density.error) : kNoKey;
        t.density_choices.at[i] = from;
        if (from != kNoKey) atomicMin(t.density_claims.at[from], i);
    }
    if (grows()) return;
    const bool dead = i < t.counters.count && is_dead(i);
    flags[gl_LocalInvocationID.x] = dead ? 1 : 0;
    barrier();
    if (!dead) return;
    uint place = t.density_dead.at[gl_WorkGroupID.x];  // dead splats of the groups before; then of this one
    for (uint k = 0; k < gl_LocalInvocationID.x; ++k) place += flags[k];
    t.density_free.at[place] = i;
}

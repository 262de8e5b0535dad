// Errors and dead splats of each group.
#version 460
#include "tables.glsl"
#include "density.glsl"

shared float errors[256];
shared uint dead[256];

void main() {
    const uint i = gl_GlobalInvocationID.x, lane = gl_LocalInvocationID.x;
    const bool there = i < t.counters.count && !has_failed();
    errors[lane] = there ? error_of(i) : 0.0;
    dead[lane] = there && !grows() && is_dead(i) ? 1 : 0;
    if (i < t.capacity) t.density_claims.at[i] = kNoKey;
    barrier();
    for (uint half_size = 128; half_size > 0; half_size /= 2) {
        if (lane < half_size) errors[lane] += errors[lane + half_size], dead[lane] += dead[lane + half_size];
        barrier();
    }
    if (lane == 0) t.density_errors.at[gl_WorkGroupID.x] = errors[0], t.density_dead.at[gl_WorkGroupID.x] = dead[0];
}

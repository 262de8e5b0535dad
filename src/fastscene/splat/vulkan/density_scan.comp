// One workgroup: sums over all groups before each, and over all.
#version 460
#include "tables.glsl"
#include "density.glsl"

shared float errors[256];
shared uint dead[256];

void main() {
    if (has_failed()) return;
    // Each invocation takes consecutive groups.
    const uint lane = gl_LocalInvocationID.x, all = groups(), each = (all + 255) / 256;
    const uint begin = min(lane * each, all), end = min(begin + each, all);
    float error = 0.0;
    uint count = 0;
    for (uint g = begin; g < end; ++g) error += t.density_errors.at[g], count += t.density_dead.at[g];
    errors[lane] = error, dead[lane] = count;
    barrier();
    if (lane == 0) {  // in order: float sums depend on it
        float error_sum = 0.0;
        uint dead_sum = 0;
        for (uint k = 0; k < 256; ++k) {
            const float e = errors[k];
            const uint d = dead[k];
            errors[k] = error_sum, dead[k] = dead_sum;
            error_sum += e, dead_sum += d;
        }
        t.density.error = error_sum, t.density.dead = dead_sum;
    }
    barrier();
    error = errors[lane], count = dead[lane];
    for (uint g = begin; g < end; ++g) {
        const float e = t.density_errors.at[g];
        const uint d = t.density_dead.at[g];
        t.density_errors.at[g] = error, t.density_dead.at[g] = count;
        error += e, count += d;
    }
}

// One workgroup: numbers the samples that took a splat.
#version 460
#include "tables.glsl"
#include "density.glsl"

shared uint counts[256];

bool took(uint sample_index) {
    const uint from = t.density_choices.at[sample_index];
    return from != kNoKey && t.density_claims.at[from] == sample_index;
}

void main() {
    if (has_failed()) return;
    const uint lane = gl_LocalInvocationID.x, all = wanted(), each = (all + 255) / 256;
    const uint begin = min(lane * each, all), end = min(begin + each, all);
    uint count = 0;
    for (uint k = begin; k < end; ++k) count += took(k) ? 1 : 0;
    counts[lane] = count;
    barrier();
    if (lane == 0) {
        uint sum = 0;
        for (uint k = 0; k < 256; ++k) {
            const uint c = counts[k];
            counts[k] = sum;
            sum += c;
        }
        t.density.taken = sum;
    }
    barrier();
    uint rank = counts[lane];
    for (uint k = begin; k < end; ++k) t.density_ranks.at[k] = took(k) ? rank++ : kNoKey;
}

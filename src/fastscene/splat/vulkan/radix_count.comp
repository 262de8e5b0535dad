// How often each digit occurs in each workgroup's piece.
#version 460
#include "tables.glsl"
#include "radix.glsl"

shared uint counts[kBins];

void main() {
    const uint lane = gl_LocalInvocationID.x;
    for (uint d = lane; d < kBins; d += kLocal) counts[d] = 0;
    barrier();
    if (!has_failed()) {
        const uint begin = segment_begin(), end = min(begin + segment_size(), list_size());
        for (uint i = begin + gl_SubgroupInvocationID; i < end; i += kSubgroup) {
            const uint key = key_at(i);
            if (is_kept(key)) atomicAdd(counts[digit_of(key)], 1);
        }
    }
    barrier();
    for (uint d = lane; d < kBins; d += kLocal) t.histogram.at[gl_WorkGroupID.x * kBins + d] = counts[d];
}

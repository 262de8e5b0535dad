// After growth: the new count. After relocation: clears the statistics.
#version 460
#include "tables.glsl"
#include "density.glsl"

void main() {
    if (has_failed()) return;
    const uint i = gl_GlobalInvocationID.x;
    if (grows()) {
        if (i == 0) t.counters.count += t.density.taken;
    } else if (i < t.capacity) t.seen_weight.at[i] = t.seen_error.at[i] = 0.0;
}

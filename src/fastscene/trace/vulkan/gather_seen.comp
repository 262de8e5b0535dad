// Which cells are seen from one of some points (IrradianceCache::find_seen).
#version 460
#include "gather.glsl"

void main() {
    if (gl_GlobalInvocationID.x >= count) return;
    const uint cell = first + gl_GlobalInvocationID.x;
    const Entry e = cache_entry(w, int(cell));
    const vec3 from = e.center + e.normal * (0.1f * world_cache(w).w);
    uint seen = 0;
    for (uint i = 0; i < rays && seen == 0; ++i) {
        const vec3 to = points.at[i].xyz - from;
        const float far = length(to);
        if (dot(to, e.normal) > -0.2f * far && !is_blocked(w, from, to / far, far)) seen = 1;
    }
    found.at[3 * cell] = vec4(uintBitsToFloat(seen), 0, 0, 0);
}

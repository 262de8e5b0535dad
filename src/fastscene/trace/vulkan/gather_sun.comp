// Direct sun, and which of the first sample points it reaches (IrradianceCache::light_by_sun).
#version 460
#include "gather.glsl"

void main() {
    if (gl_GlobalInvocationID.x >= count) return;
    const uint cell = first + gl_GlobalInvocationID.x;
    const uvec4 entry = entries.at[cell];
    Random random = random_of_cell(entry);
    vec3 sum = vec3(0);
    uint reached = 0;
    for (uint s = 0; s < rays; ++s) {
        const Place at = place_of(entry, s);
        vec2 disc;
        disc.x = uniform_of(random);
        disc.y = uniform_of(random);
        const vec3 sun = sun_unblocked(w, at.normal);
        if (!(luminance(sun) > 0) ||
            is_blocked(w, at.position + at.normal * kSurfaceOffset, sun_direction(w, disc), kFar))
            continue;
        reached |= 1u << s;
        sum += sun;
    }
    store(cell, sum / float(rays), 0, vec4(0), 0, reached);
}

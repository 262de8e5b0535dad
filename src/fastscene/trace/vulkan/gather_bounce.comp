// One bounce more: each cell reads the others (IrradianceCache::gather_pass).
#version 460
#include "gather.glsl"

void main() {
    if (gl_GlobalInvocationID.x >= count) return;
    const uint cell = first + gl_GlobalInvocationID.x;
    const uvec4 entry = entries.at[cell];
    Random random = random_of_cell(entry);
    vec2 shift;
    shift.x = uniform_of(random);
    shift.y = uniform_of(random);
    const uint asked = rays_of(entry);
    vec3 sum = vec3(0);
    vec4 directed = vec4(0);
    Spread spread = Spread(0, 0, 0);
    float nearness = 0, valid = 0;
    for (uint s = 0; s < asked; ++s) {
        const Place at = place_of(entry, s);
        const vec3 direction = cosine_direction(at.normal, r2_point(s, shift)),
                   from = at.position + at.normal * distance_epsilon(at.position);
        const Bounce bounce = bounce_of(w, trace_ray(w, from, direction, kFar, kLit), from, direction);
        nearness += 1 / ((bounce.distance + 1e-3f) * float(asked));
        if (bounce.buried) continue;  // no camera will see it
        valid += 1;
        sum += bounce.irradiance;
        add_to(spread, luminance(bounce.irradiance));
        add_direction(directed, bounce.irradiance, bounce.direction, at.normal);
    }
    store(cell, valid > 0 ? sum / valid : vec3(0), error_of(spread), directed, nearness, 0);
}

// Lamps, windows and the first bounce of the sun by next-event estimation (IrradianceCache::gather_direct).
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
    const float share = 1 / float(asked);
    vec3 sum = vec3(0);
    vec4 directed = vec4(0);
    Spread spread = Spread(0, 0, 0);
    for (uint s = 0; s < asked; ++s) {
        const vec2 uv = r2_point(s, shift);
        const float which = (float(s) + uniform_of(random)) / float(asked);
        const Place at = place_of(entry, s);
        vec3 all = vec3(0);
        for (int k = 0; k < 2; ++k) {
            ShadowRay ray;
            if (k == 0) ray = ask_lamps(w, at.position, at.normal, which, uv);
            else ray = ask_sunlit(w, at.position, at.normal, which);
            if (!(max_component(ray.irradiance) > 0) || is_blocked(w, ray.origin, ray.direction, ray.far)) continue;
            all += ray.irradiance;
            add_direction(directed, ray.irradiance * share, ray.direction, at.normal);
        }
        sum += all;
        add_to(spread, luminance(all));
    }
    store(cell, sum / float(asked), error_of(spread), directed, 0, 0);
}

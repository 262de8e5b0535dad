// How openly sample points lie (IrradianceCache::visibility): four bits of each of a cell's up to 12 points: 0: buried;
// else 1, and how many of eight rays travel further than half a cell.
#version 460
#include "gather.glsl"

void main() {
    if (gl_GlobalInvocationID.x >= count) return;
    const uint cell = first + gl_GlobalInvocationID.x;
    const uvec4 entry = entries.at[cell];
    const float open_m = 0.5f * world_cache(w).w;
    const uint points_here = entry.w & 0x7fffffffu;
    uint words[2] = uint[2](0x99999999u, 0x99999999u);
    bool all_open = true;
    for (uint s = 0; s < points_here; ++s) {
        if (s == 4 && all_open) break;
        const Place at = place_of(entry, s);
        const vec3 from = at.position + at.normal * distance_epsilon(at.position);
        uint seen = 0, open = 0;
        for (uint k = 0; k < 8; ++k) {
            if (k == 4 && open == 4) {
                open = 8;
                break;
            }
            const vec3 toward = cosine_direction(at.normal, r2_point(k, vec2(0.5f)));
            const Hit hit = trace_ray(w, from, toward, kFar, 0);
            if (hit.place == kNone) continue;
            const HitSurface on = hit_surface(w, hit, toward);
            if (on.back && (w.meshes.at[on.mesh].y & kClosed) != 0) continue;
            seen = 1;
            if (hit.distance > open_m) ++open;
        }
        const uint value = seen == 0 ? 0 : 1 + open;
        words[s / 8] = (words[s / 8] & ~(15u << (4 * (s % 8)))) | value << (4 * (s % 8));
        if (value != 9) all_open = false;
    }
    found.at[3 * cell] = vec4(uintBitsToFloat(words[0]), uintBitsToFloat(words[1]), 0, 0);
}

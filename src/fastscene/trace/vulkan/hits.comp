// The first hits of rays: for tests. Two vectors a ray in: origin and far end, direction and kind; two out: distance
// and barycentric weights, then triangle, mesh, and whether from behind.
#version 460
#include "tables.glsl"
#include "traverse.glsl"
#include "surface.glsl"

layout(local_size_x = 64) in;
layout(push_constant) uniform Push {
    World w;
    Vec4s rays;
    OutVec4s hits;
    uint count;
};

void main() {
    const uint i = gl_GlobalInvocationID.x;
    if (i >= count) return;
    const vec4 from = rays.at[2 * i], way = rays.at[2 * i + 1];
    const Hit hit = trace_ray(w, from.xyz, way.xyz, from.w, floatBitsToUint(way.w));
    HitSurface on = HitSurface(kNone, kNone, vec3(0), false);
    if (hit.place != kNone) on = hit_surface(w, hit, way.xyz);
    hits.at[2 * i] = vec4(hit.distance, hit.u, hit.v, 0);
    hits.at[2 * i + 1] = vec4(uintBitsToFloat(on.triangle), uintBitsToFloat(on.mesh), on.back ? 1 : 0, 0);
}

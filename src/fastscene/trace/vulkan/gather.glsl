// What the kernels of gathering share: an invocation a cell of the irradiance cache, with its sums in the processor's
// order.
#include "tables.glsl"
#include "random.glsl"
#include "traverse.glsl"
#include "surface.glsl"
#include "outdoors.glsl"
#include "lights.glsl"
#include "cache.glsl"

layout(local_size_x = 64) in;
layout(push_constant) uniform Push {
    World w;
    Uvec4s entries;     // by cell: key; first sample point; their number | whether seen << 31
    Vec4s points;       // two a sample point: position, normal
    OutVec4s found;     // three a cell: irradiance, error; direction's sum and weight; nearness, and a word of bits
    uvec2 seed, pass;   // pass: mixed
    uint count, first;  // cells of this submission
    uint rays;          // of a cell that cameras see
    uint least;         // of any cell
};

struct Place {
    vec3 position, normal;
};
Place place_of(uvec4 entry, uint i) {
    const uint at = entry.z + i % (entry.w & 0x7fffffffu);
    return Place(points.at[2 * at].xyz, points.at[2 * at + 1].xyz);
}
Random random_of_cell(uvec4 entry) { return random_of(seed ^ mix64(entry.xy ^ pass)); }
uint rays_of(uvec4 entry) { return (entry.w >> 31) != 0 ? rays : max(least, rays / 3); }

// irradiance_gather.cc's Spread.
struct Spread {
    float sum, squares, count;
};
void add_to(inout Spread s, float v) { s.sum += v, s.squares += v * v, s.count += 1; }
float error_of(Spread s) {
    if (!(s.count > 0)) return 0;
    const float mean = s.sum / s.count;
    return sqrt(max(0, s.squares / s.count - mean * mean) / s.count);
}
// LightDirection::add; xyz: sum, w: weight.
void add_direction(inout vec4 to, vec3 irradiance, vec3 direction, vec3 normal) {
    const float v = luminance(irradiance);
    to += vec4(direction * (v / max(0.12f, dot(direction, normal))), v);
}
void store(uint cell, vec3 irradiance, float error, vec4 directed, float nearness, uint word) {
    found.at[3 * cell] = vec4(irradiance, error);
    found.at[3 * cell + 1] = directed;
    found.at[3 * cell + 2] = vec4(nearness, uintBitsToFloat(word), 0, 0);
}

// For kernel_test.cc: the textures of many materials at many points.
#version 460
#include "fastscene/trace/kernel/texture.h"

layout(local_size_x = 64) in;

struct Query {
    vec3 coords;
    float footprint_m;
    vec2 plane;
    int axis;
    uint material;
};
layout(buffer_reference, std430, buffer_reference_align = 16) readonly buffer Queries { Query at[]; };
layout(buffer_reference, std430, buffer_reference_align = 16) writeonly buffer Answers { vec4 at[]; };
layout(push_constant) uniform Push {
    Materials materials;
    Queries queries;
    Answers answers;
    uint count;
};

void main() {
    const uint i = gl_GlobalInvocationID.x;
    if (i >= count) return;
    const Query q = queries.at[i];
    TexturePoint p;
    p.coords = q.coords;
    p.plane = q.plane;
    p.footprint_m = q.footprint_m;
    const SurfaceTexture t = texture_with_slope(materials.at[q.material], p, q.axis, true);
    answers.at[3 * i] = vec4(t.value.albedo, t.value.roughness);
    answers.at[3 * i + 1] = vec4(t.value.height, t.slope, t.value.metal);
    answers.at[3 * i + 2] = vec4(t.value.shown, 0);
}

// Splits each sampled splat in two along its longest axis: the pair looks much like the original.
#version 460
#include "tables.glsl"
#include "density.glsl"

// SH coefficients of degrees >= 1 of a splat.
uint rest_values() {
    const uint degree = plan.flags >> 16;
    return 3 * ((degree + 1) * (degree + 1) - 1);
}

void set(int p, uint i, float x) { t.parameters.at[uint(p) * t.capacity + i] = x; }

// The longest axis in the world, as long as its standard deviation.
vec3 long_axis(uint i, int axis) {
    const vec4 q = vec4(value(6, i), value(7, i), value(8, i), value(9, i));
    const float s = 2.0 / dot(q, q), w = q.x, x = q.y, y = q.z, z = q.w;
    vec3 column = vec3(1.0 - (y * y + z * z) * s, (x * y + w * z) * s, (x * z - w * y) * s);
    if (axis == 1) column = vec3((x * y - w * z) * s, 1.0 - (x * x + z * z) * s, (y * z + w * x) * s);
    if (axis == 2) column = vec3((x * z + w * y) * s, (y * z - w * x) * s, 1.0 - (x * x + y * y) * s);
    return column * exp(value(3 + axis, i));
}

void clear_moments(uint i) {
    for (uint p = 0; p < uint(kParameters); ++p)
        t.first_moment.at[p * t.capacity + i] = t.second_moment.at[p * t.capacity + i] = 0.0;
    for (uint k = 0; k < rest_values(); ++k)
        t.rest_first_moment.at[k * t.capacity + i] = t.rest_second_moment.at[k * t.capacity + i] = 0.0;
}

void split(uint from, uint to) {
    int axis = 0;
    for (int a = 1; a < 3; ++a)
        if (value(3 + a, from) > value(3 + axis, from)) axis = a;
    const vec3 offset = long_axis(from, axis) * kHalfOffset;
    const float opacity = 1.0 - pow(1.0 - min(opacity_of(from), 0.995), kHalfDensity);
    set(3 + axis, from, value(3 + axis, from) + log(kHalfSize));
    set(10, from, log(opacity / (1.0 - opacity)));
    for (int p = 0; p < kParameters; ++p) set(p, to, value(p, from));
    for (int a = 0; a < 3; ++a) {
        set(a, from, value(a, from) - offset[a]);
        set(a, to, value(a, to) + offset[a]);
    }
    for (uint k = 0; k < rest_values(); ++k)
        t.rest.at[k * t.capacity + to] = t.rest.at[k * t.capacity + from];
    clear_moments(from), clear_moments(to);
    t.seen_weight.at[to] = t.seen_error.at[to] = 0.0;
}

void main() {
    if (has_failed()) return;
    const uint i = gl_GlobalInvocationID.x;
    if (i >= wanted()) return;
    const uint rank = t.density_ranks.at[i];
    if (rank == kNoKey) return;
    split(t.density_choices.at[i], grows() ? t.counters.count + rank : t.density_free.at[rank]);
}

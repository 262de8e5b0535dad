// Lattice noise: smooth pseudo-random functions of position, without state.
#ifndef FASTSCENE_TRACE_KERNEL_NOISE_H
#define FASTSCENE_TRACE_KERNEL_NOISE_H

#include "fastscene/trace/kernel/language.h"

KERNEL_BEGIN

// A well-mixed 32-bit hash of a lattice point.
inline uint lattice_hash(int x, int y, int z, uint seed) {
    uint h = uint(x) * 0x8da6b343u ^ uint(y) * 0xd8163841u ^ uint(z) * 0xcb1ab31fu ^ seed * 0x9e3779b9u;
    h ^= h >> 15;
    h *= 0x2c1b3c6du;
    h ^= h >> 12;
    h *= 0x297a2d39u;
    return h ^ (h >> 15);
}
// Uniform in [0, 1).
inline float lattice_unit(int x, int y, int z, uint seed) {
    return float(lattice_hash(x, y, z, seed) >> 8) * 5.9604644775390625e-8f;
}

inline float unit_clamp(float v) { return v > 0.f ? (v < 1.f ? v : 1.f) : 0.f; }
inline float smooth_step(float low, float high, float v) {
    const float t = unit_clamp((v - low) / (high - low));
    return t * t * (3.f - 2.f * t);
}
inline int floor_int(float v) {
    const int i = int(v);
    return float(i) > v ? i - 1 : i;
}
inline float fraction(float v) { return v - float(floor_int(v)); }
// i modulo n in [0, n).
inline int wrapped(int i, int n) {
    const int rest = abs(i) % n;
    return i < 0 && rest != 0 ? n - rest : rest;
}
inline float positive(float scale_m) { return scale_m > 1e-3f ? scale_m : 1e-3f; }

// Value noise in [0, 1]; features have unit size.
inline float noise2(Vec2f p, uint seed) {
    const int x = floor_int(p.x), y = floor_int(p.y);
    float u = p.x - float(x), v = p.y - float(y);
    u = u * u * (3.f - 2.f * u);
    v = v * v * (3.f - 2.f * v);
    return mix(mix(lattice_unit(x, y, 0, seed), lattice_unit(x + 1, y, 0, seed), u),
               mix(lattice_unit(x, y + 1, 0, seed), lattice_unit(x + 1, y + 1, 0, seed), u), v);
}
// References in C++: with values, GCC would inline and so round some patterns otherwise, in the last bit.
struct LatticeCell {
    REF(int) x;
    REF(int) y;
    REF(float) u;
    REF(float) v;
    REF(uint) seed;
};
inline float noise_layer(IN(LatticeCell) c, int z) {
    return mix(mix(lattice_unit(c.x, c.y, z, c.seed), lattice_unit(c.x + 1, c.y, z, c.seed), c.u),
               mix(lattice_unit(c.x, c.y + 1, z, c.seed), lattice_unit(c.x + 1, c.y + 1, z, c.seed), c.u), c.v);
}
inline float noise3(Vec3f p, uint seed) {
    const int x = floor_int(p.x), y = floor_int(p.y), z = floor_int(p.z);
    float u = p.x - float(x), v = p.y - float(y), w = p.z - float(z);
    u = u * u * (3.f - 2.f * u);
    v = v * v * (3.f - 2.f * v);
    w = w * w * (3.f - 2.f * w);
    const LatticeCell c = {x, y, u, v, seed};
    return mix(noise_layer(c, z), noise_layer(c, z + 1), w);
}

// Band limiting: 1 while a detail of `size` is wider than two footprints, falling to 0 at one footprint.
inline float detail_fade(float footprint, float size) { return unit_clamp(2.f - 2.f * footprint / size); }

// Fractal noise in [0, 1]; octaves finer than the footprint (in units of p) are left out.
inline float fbm2(Vec2f p, int octaves, float footprint, uint seed) {
    float sum = 0.5f, amplitude = 0.5f, size = 1.f;
    KEEP_LOOP for (int i = 0; i < octaves; ++i) {
        const float fade = detail_fade(footprint, size);
        if (!(fade > 0.f)) break;
        sum += amplitude * fade * (noise2(p, seed + uint(i)) - 0.5f);
        // scaled by 2 and rotated, which hides the lattice
        p = vec2(p.x * 1.6f - p.y * 1.2f, p.x * 1.2f + p.y * 1.6f);
        amplitude *= 0.5f;
        size *= 0.5f;
    }
    return unit_clamp(sum);
}
inline float fbm3(Vec3f p, int octaves, float footprint, uint seed) {
    float sum = 0.5f, amplitude = 0.5f, size = 1.f;
    KEEP_LOOP for (int i = 0; i < octaves; ++i) {
        const float fade = detail_fade(footprint, size);
        if (!(fade > 0.f)) break;
        sum += amplitude * fade * (noise3(p, seed + uint(i)) - 0.5f);
        p = vec3(p.x * 1.6f - p.y * 1.2f, p.x * 1.2f + p.y * 1.6f, p.z * 2.f + 0.37f);
        amplitude *= 0.5f;
        size *= 0.5f;
    }
    return unit_clamp(sum);
}

// Share of a footprint covered by a line, for a footprint centered `distance` from the line's center.
inline float line_cover(float distance, float half_width, float footprint) {
    const float f = footprint > 1e-5f ? footprint : 1e-5f;
    const float low = max(distance - 0.5f * f, -half_width), high = min(distance + 0.5f * f, half_width);
    return unit_clamp((high - low) / f);
}
// Antialiased step at 0, as wide as the footprint.
inline float edge_cover(float signed_distance, float footprint) {
    return unit_clamp(signed_distance / (footprint > 1e-5f ? footprint : 1e-5f) + 0.5f);
}

// The nearest points of a jittered lattice: distances to the first two, and the hash of the first.
struct Voronoi {
    float nearest, second;
    uint id;
    Vec2f offset;  // from the nearest point
};
inline Voronoi voronoi2(Vec2f p, uint seed) {
    const int x = floor_int(p.x), y = floor_int(p.y);
    Voronoi v;
    v.nearest = v.second = 1e9f;
    v.id = 0;
    v.offset = vec2(0, 0);
    KEEP_LOOP for (int j = y - 1; j <= y + 1; ++j) {
        KEEP_LOOP for (int i = x - 1; i <= x + 1; ++i) {
            const uint h = lattice_hash(i, j, 7, seed);
            const Vec2f q = vec2(float(i) + float(h & 0xffff) / 65536.f, float(j) + float(h >> 16) / 65536.f);
            const float d = length(p - q);
            if (d < v.nearest) {
                v.second = v.nearest;
                v.nearest = d;
                v.id = h;
                v.offset = p - q;
            } else if (d < v.second) {
                v.second = d;
            }
        }
    }
    return v;
}

KERNEL_END

#endif

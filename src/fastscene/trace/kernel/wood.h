// Wood, wooden floors, bark.
#ifndef FASTSCENE_TRACE_KERNEL_WOOD_H
#define FASTSCENE_TRACE_KERNEL_WOOD_H

#include "fastscene/trace/kernel/noise.h"
#include "fastscene/trace/kernel/material.h"

KERNEL_BEGIN

const float kMeanRing = 0.3f, kMeanPores = 0.14f;  // for distant views

// Grain of one board: `along` and `across` the fibres, metres. 0 = early wood, 1 = late wood.
static float grain(float across, float along, float footprint, uint seed) {
    // A board is cut slightly off the trunk's axis, so the rings appear as long, wavering arches, some wide, some
    // narrow.
    const float kRing_m = 0.012f;
    const float drift = 0.085f * (fbm2(vec2(across * 4.f, along * 0.55f), 3, footprint * 4.f, seed) - 0.5f);
    const float ring = (across + drift + 0.02f * along) / kRing_m;
    const float t = fraction(ring + 1.3f * noise2(vec2(ring * 0.22f, along * 0.4f), seed + 5));
    // Late wood darkens slowly over the year and ends at once.
    const float rings = mix(kMeanRing, t * t * (1.f - smooth_step(0.9f, 1.f, t)), detail_fade(footprint, kRing_m));
    const float streaks = fbm2(vec2(across * 75.f, along * 1.3f), 3, footprint * 75.f, seed + 2);
    const float fibres = fbm2(vec2(across * 420.f, along * 14.f), 2, footprint * 420.f, seed + 9);
    const float broad = fbm2(vec2(across * 11.f, along * 1.1f), 2, footprint * 11.f, seed + 3);
    return unit_clamp(0.42f * rings + 0.34f * streaks + 0.16f * fibres + 0.26f * broad - 0.02f);
}

// Pores: dark strokes a few tenths of a millimetre wide, dense in early wood; seen from a hand's breadth. Blended out
// early: strokes are finer than the noise that they are cut from.
static float pores(float across, float along, float footprint, uint seed) {
    const float kPitch_m = 0.0011f, kLong_m = 0.012f;
    const float fade = detail_fade(footprint, kPitch_m);
    if (!(fade > 0.f)) return kMeanPores;
    const float n = noise2(vec2(across / kPitch_m, along / kLong_m), seed + 13);
    return mix(kMeanPores, smooth_step(0.66f, 0.8f, n), fade);
}

const float kTilt = 0.004f;  // slope of a board against its floor

// One floorboard, with its own tone and its own part of the trunk.
static TextureValue board(IN(Material) m, float across, float along, float footprint, uint id) {
    const float tone = float(id & 255) / 255.f, warmth = float((id >> 8) & 255) / 255.f;
    const float g = grain(across + float(id >> 24) * 0.37f, along + float((id >> 16) & 255) * 0.53f, footprint,
                          m.seed + (id & 31));
    TextureValue v;
    const float pore = pores(across, along, footprint, m.seed + (id & 31));
    v.albedo = lerp(m.color_a, m.color_b, unit_clamp(1.35f * (g - 0.3f) + 0.36f * (tone - 0.5f) + 0.12f));
    v.albedo = v.albedo * ((0.9f + 0.2f * warmth) * (1.f - 0.4f * (pore - kMeanPores)));
    v.roughness = m.roughness * (0.82f + 0.5f * g);
    // No two boards lie in quite one plane, which breaks up what they reflect; each is a little hollow.
    const float lie = (float((id >> 4) & 63) / 63.f - 0.5f) * 2.f * kTilt * across,
                end = (float((id >> 10) & 63) / 63.f - 0.5f) * kTilt * along;
    v.height = 1.f - 0.25f * g - 0.3f * pore + (lie + end) / max(m.bump_m, 1e-5f);
    return v;
}

// Darkens the gap between boards; `gap` = covered share.
static void cut_gap(INOUT(TextureValue) v, float gap) {
    v.albedo = v.albedo * (1.f - 0.72f * gap);
    v.height -= gap;
    v.roughness = mix(v.roughness, 0.9f, gap);
}

const float kGapHalf = 0.0011f;  // boards touch, except for a bevel of about two millimetres

TextureValue wood(IN(Material) m, IN(TexturePoint) p) {
    // By convention the fibres run along the mesh's longest texture axis, the second flat coordinate.
    return board(m, p.plane.x, p.plane.y, p.footprint_m, lattice_hash(1, 2, 3, m.seed) & 0xffffff7f);
}

TextureValue planks(IN(Material) m, IN(TexturePoint) p) {
    const float width = positive(m.scale_m), long_side = width * 9.f;
    const int row = floor_int(p.plane.x / width);
    const float shift = lattice_unit(row, 0, 1, m.seed) * long_side;
    const int column = floor_int((p.plane.y + shift) / long_side);
    const float across = p.plane.x - float(row) * width;
    const float along = p.plane.y + shift - float(column) * long_side;
    TextureValue v = board(m, across, along, p.footprint_m, lattice_hash(row, column, 2, m.seed));
    const float side = min(across, width - across), end = min(along, long_side - along);
    cut_gap(v, max(line_cover(side, kGapHalf, p.footprint_m), line_cover(end, kGapHalf, p.footprint_m)));
    return v;
}

TextureValue herringbone(IN(Material) m, IN(TexturePoint) p) {
    // In units of the block's width, rotated by 45 degrees; blocks are n x 1. Row y holds a horizontal block where (x -
    // y) mod 2n < n; the remaining cells form vertical blocks.
    const int n = 5;
    const float width = positive(m.scale_m), r = 0.70710678f / width;
    const float x = (p.plane.x + p.plane.y) * r, y = (p.plane.y - p.plane.x) * r;
    const int ix = floor_int(x), iy = floor_int(y);
    const int k = wrapped(ix - iy, 2 * n);
    const bool lying = k < n;
    const float along = lying ? float(k) + x - float(ix) : float(2 * n - 1 - k) + y - float(iy);
    const float across = lying ? y - float(iy) : x - float(ix);
    const uint id = lying ? lattice_hash(ix - k, iy, 3, m.seed) : lattice_hash(ix, iy - (2 * n - 1 - k), 4, m.seed);
    TextureValue v = board(m, across * width, along * width, p.footprint_m, id);
    const float edge = min(min(across, 1.f - across), min(along, float(n) - along)) * width;
    cut_gap(v, line_cover(edge, kGapHalf * 0.8f, p.footprint_m));
    return v;
}

TextureValue parquet(IN(Material) m, IN(TexturePoint) p) {
    const int n = 5;  // strips per square
    const float width = positive(m.scale_m), square = width * n;
    const int ix = floor_int(p.plane.x / square), iy = floor_int(p.plane.y / square);
    const bool turned_square = ((ix + iy) & 1) != 0;
    const float x = p.plane.x - float(ix) * square, y = p.plane.y - float(iy) * square;
    const float across = turned_square ? y : x, along = turned_square ? x : y;
    const int strip = clamp(floor_int(across / width), 0, n - 1);
    const float local = across - float(strip) * width;
    TextureValue v = board(m, local, along, p.footprint_m, lattice_hash(ix * n + strip, iy, 5, m.seed));
    const float edge = min(min(local, width - local), min(along, square - along));
    cut_gap(v, line_cover(edge, kGapHalf * 0.7f, p.footprint_m));
    return v;
}

TextureValue bark(IN(Material) m, IN(TexturePoint) p) {
    const float s = positive(m.scale_m);
    const float angle = atan2(p.coords.z, p.coords.x);
    const float ridge = fbm3(vec3(angle * 3.f, p.coords.y / s * 0.35f, 0.f), 4, p.footprint_m / s, m.seed);
    const float t = abs(2.f * ridge - 1.f);
    TextureValue v;
    const float kRidges = 0.43f;  // mean share of ridges, for distant views
    v.albedo = lerp(m.color_b, m.color_a,
                    mix(kRidges, smooth_step(0.02f, 0.4f, t), detail_fade(p.footprint_m, 0.5f * s)));
    v.roughness = m.roughness;
    v.height = t;
    return v;
}

KERNEL_END

#endif

// Drawn ornaments.
#ifndef FASTSCENE_TRACE_KERNEL_ORNAMENT_H
#define FASTSCENE_TRACE_KERNEL_ORNAMENT_H

#include "fastscene/trace/kernel/noise.h"
#include "fastscene/trace/kernel/material.h"

KERNEL_BEGIN

// Signed distance, positive inside, to a rose curve with `petals` petals and radius r.
static float rose(Vec2f p, int petals, float r, float depth) {
    const float d = length(p), a = atan2(p.y, p.x);
    return r * (1.f - depth + depth * abs(cos(0.5f * float(petals) * a))) - d;
}
// Signed distance, positive inside, to a pointed leaf from the origin along +y; length l, half width w.
static float leaf_shape(Vec2f p, float l, float w) {
    const float t = p.y / l;
    if (t < 0.f || t > 1.f) return -0.01f - abs(t - 0.5f) * 0.1f;
    return w * sin(kPi * pow(t, 0.8f)) - abs(p.x);
}
static Vec2f turned(Vec2f p, float angle) {
    const float c = cos(angle), s = sin(angle);
    return vec2(c * p.x + s * p.y, c * p.y - s * p.x);
}

// The pile of a rug: short, slightly uneven.
static float pile(IN(Material) m, IN(TexturePoint) p) {
    return fbm2(p.plane * 330.f, 2, p.footprint_m * 330.f, m.seed + 77);
}

// Motif of the field: 0 ground, 1 second color, 2 third color. q: about [-1, 1]^2.
static int field_motif(IN(Material) m, Vec2f q, int style) {
    switch (style) {
        case 0: {  // a lattice of diamonds
            const float a = fraction(q.x + q.y), b = fraction(q.x - q.y);
            const float edge = min(min(a, 1.f - a), min(b, 1.f - b));
            return edge < 0.07f                                                                    ? 1
                   : min(abs(a - 0.5f), abs(b - 0.5f)) + max(abs(a - 0.5f), abs(b - 0.5f)) < 0.22f ? 2
                                                                                                   : 0;
        }
        case 1: {  // medallions
            const Vec2f c = vec2(fraction(q.x) - 0.5f, fraction(q.y) - 0.5f);
            if (rose(c, 8, 0.16f, 0.3f) > 0.f) return 2;
            if (abs(rose(c, 8, 0.36f, 0.22f)) < 0.03f) return 1;
            return rose(vec2(c.x - copysign(0.5f, c.x), c.y - copysign(0.5f, c.y)), 4, 0.2f, 0.5f) > 0.f ? 1 : 0;
        }
        case 2: {  // zigzag bands
            const int band = floor_int(q.y);
            const float zig = abs(fraction(q.x * 2.f) - 0.5f) * 0.8f, v = fraction(q.y);
            if (v < 0.08f) return 2;
            return (band & 1) != 0 ? (abs(v - 0.35f - zig) < 0.09f ? 1 : 0)
                                   : (v > 0.3f && v < 0.75f && fraction(q.x * 4.f) < 0.5f ? 2 : 0);
        }
        default: {  // scattered motifs
            const float f = fbm2(q * 0.7f, 4, 0.f, m.seed + 5);
            return f > 0.58f ? 1 : f < 0.4f ? 2 : 0;
        }
    }
}

TextureValue rug(IN(Material) m, IN(TexturePoint) p) {
    // coords are metres from the rug's center; scale_m is half its width, coords.y half its depth (negative: a round
    // rug).
    const float half_x = positive(m.scale_m), half_z = p.coords.y > 0.f ? p.coords.y : half_x,
                least_half = min(half_x, half_z), fp = p.footprint_m;
    const int style = int(lattice_hash(1, 1, 1, m.seed) % 4);
    const float inset_x = half_x - abs(p.plane.x), inset_z = half_z - abs(p.plane.y);
    const bool is_round = p.coords.y < 0.f;
    const float inset = is_round ? least_half - length(p.plane) : min(inset_x, inset_z);
    // An integer number of motifs across the width.
    const float unit = half_x / max(2.f, round(half_x / 0.3f));
    const Vec2f q = p.plane * (1.f / unit);
    const float fade = detail_fade(fp, 0.5f * unit);
    const Vec3f mean = (m.color_a * 0.62f + m.color_b * 0.2f + m.color_c * 0.18f);
    const int motif = field_motif(m, q, style);
    Vec3f c = lerp(mean, motif == 0 ? m.color_a : motif == 1 ? m.color_b : m.color_c, fade);
    // Border: a guard stripe, a band with beads, a guard stripe.
    const float band = 0.13f * least_half;
    if (style != 3 && inset < band) {
        const float t = inset / band;
        const float along = is_round ? atan2(p.plane.y, p.plane.x) * least_half / band
                                     : (inset_x < inset_z ? p.plane.y : p.plane.x) / band;
        const bool guard = (t > 0.12f && t < 0.22f) || (t > 0.82f && t < 0.92f);
        const bool bead = t > 0.34f && t < 0.7f && abs(fraction(along) - 0.5f) + abs(t - 0.52f) < 0.24f;
        c = guard ? m.color_c : bead ? m.color_a : m.color_b;
    }
    const float h = pile(m, p);
    TextureValue v;
    v.albedo = c * (0.82f + 0.36f * h) * (0.95f + 0.1f * fbm2(p.plane * 5.f, 3, fp * 5.f, m.seed + 2));
    v.roughness = 1.f;
    v.height = h;
    return v;
}

TextureValue stripes(IN(Material) m, IN(TexturePoint) p) {
    const float s = positive(m.scale_m), t = fraction(p.plane.x / (2.f * s)) * 2.f * s;
    // Distance to the center of the b stripe, filtered analytically.
    const float fade = detail_fade(p.footprint_m, s);
    const float b = mix(0.5f, line_cover(t - 1.5f * s, 0.5f * s, p.footprint_m), fade);
    const float pin = mix(0.03f, line_cover(t - 0.5f * s, 0.03f * s, p.footprint_m), fade);
    const float weave = fbm2(p.plane * 300.f, 2, p.footprint_m * 300.f, m.seed) - 0.5f;
    TextureValue v;
    v.albedo = lerp(lerp(m.color_a, m.color_b, b), m.color_c, 0.5f * pin) * (1.f + 0.06f * weave);
    v.roughness = m.roughness;
    v.height = 0.5f + 0.5f * weave;
    return v;
}

TextureValue damask(IN(Material) m, IN(TexturePoint) p) {
    // One mirror-symmetric motif per cell, in half drop.
    const float kShare = 0.31f;  // mean share of the motif
    const float s = positive(m.scale_m), fp = p.footprint_m / s;
    const int column = floor_int(p.plane.x / s);
    const float x = abs(p.plane.x / s - float(column) - 0.5f);
    const float y = fraction(p.plane.y / (1.5f * s) + 0.5f * float(column & 1)) - 0.5f;
    const Vec2f q = vec2(x, y * 1.5f);
    // A palmette above a flower with scrolls below, all framed by an ogee shared with the neighbours. x is mirrored.
    float inside = abs(rose(q - vec2(0.f, -0.1f), 10, 0.15f, 0.3f)) - 0.01f;
    inside = min(rose(q - vec2(0.f, -0.1f), 10, 0.15f, 0.3f), inside);
    for (int i = 0; i < 4; ++i)
        inside = max(inside,
                     leaf_shape(turned(q - vec2(0.f, 0.03f), -0.42f * float(i)), 0.46f - 0.055f * float(i), 0.055f));
    inside = max(inside, leaf_shape(turned(q - vec2(0.04f, -0.18f), -2.05f), 0.32f, 0.05f));
    inside = max(inside, leaf_shape(turned(q - vec2(0.02f, -0.22f), -2.7f), 0.34f, 0.05f));
    const float wave = 0.5f * (0.5f + 0.5f * cos(2.f * kPi * q.y / 1.5f)),
                steep = 0.5f * kPi / 1.5f * sin(2.f * kPi * q.y / 1.5f),
                apart = abs(x - wave) / sqrt(1.f + steep * steep);
    inside = max(inside, 0.019f - apart);
    inside = max(inside, 0.007f - abs(apart - 0.045f));
    const float cover = mix(kShare, edge_cover(inside, max(fp, 0.004f)), detail_fade(fp, 0.5f));
    TextureValue v;
    v.albedo = lerp(m.color_a, m.color_b, cover);
    v.roughness = mix(m.roughness, m.roughness * 0.75f, cover);
    v.height = cover;
    return v;
}

TextureValue floral(IN(Material) m, IN(TexturePoint) p) {
    const float s = positive(m.scale_m), fp = p.footprint_m / s;
    const Vec2f q = p.plane * (1.f / s);
    const Voronoi cell = voronoi2(q, m.seed);
    const float r = 0.2f + 0.12f * float(cell.id & 255) / 255.f, angle = float((cell.id >> 8) & 255) * 0.0246f;
    const Vec2f o = turned(cell.offset, angle);
    const float soft = max(fp, 0.01f), fade = detail_fade(fp, 0.6f);
    const float leaves = edge_cover(
        max(leaf_shape(turned(o, 0.7f), r * 2.2f, 0.07f), leaf_shape(turned(o, 3.6f), r * 2.2f, 0.07f)), soft);
    const float bloom = edge_cover(rose(o, 5, r, 0.35f), soft), eye = edge_cover(0.28f * r - length(o), soft);
    const Vec3f leaf_tone = lerp(m.color_c, m.color_a, 0.25f);
    Vec3f c = lerp(m.color_a, leaf_tone, leaves * fade);
    c = lerp(c, m.color_b * (1.f - 0.35f * unit_clamp(1.f - length(o) / r)), bloom * fade);
    c = lerp(c, lerp(m.color_a, m.color_c, 0.4f), eye * fade);
    TextureValue v;
    v.albedo = c;
    v.roughness = m.roughness;
    v.height = 0.5f;
    return v;
}

KERNEL_END

#endif

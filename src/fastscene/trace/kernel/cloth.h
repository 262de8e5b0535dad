// Cloth, leather, wicker; the creases of soft things.
#ifndef FASTSCENE_TRACE_KERNEL_CLOTH_H
#define FASTSCENE_TRACE_KERNEL_CLOTH_H

#include "fastscene/trace/kernel/noise.h"
#include "fastscene/trace/kernel/material.h"

KERNEL_BEGIN

const float kTwoPi = 6.2831853f;

// Plain weave with threads of width `s`: relief in 0..1, and whether the warp is on top.
struct Weave {
    float height, warp;
};
static Weave plain_weave(Vec2f p, float s, float footprint) {
    const float fade = detail_fade(footprint, s);
    Weave w;
    w.height = w.warp = 0.5f;
    if (!(fade > 0.f)) return w;
    const float x = p.x / s, y = p.y / s;
    const int ix = floor_int(x), iy = floor_int(y);
    const float fx = x - float(ix) - 0.5f, fy = y - float(iy) - 0.5f;
    const bool warp_on_top = ((ix + iy) & 1) != 0;
    const float round_across = 1.f - 4.f * (warp_on_top ? fx * fx : fy * fy);
    const float arch = 1.f - 2.f * (warp_on_top ? fy * fy : fx * fx);
    w.height = mix(0.5f, unit_clamp(round_across * arch), fade);
    w.warp = mix(0.5f, warp_on_top ? 1.f : 0.f, fade);
    return w;
}

inline float folds(Vec3f q, float frequency, float footprint, uint seed) {
    const float n = abs(2.f * noise3(q * frequency, seed) - 1.f);
    return mix(0.5f, smooth_step(0.f, 0.45f, n), detail_fade(footprint, 0.35f / frequency));
}
// Creases of soft things, about a decimetre long: 0 in the valleys, 1 between them.
float crease(Vec3f p, float footprint, uint seed) {
    // Folds run along the zero lines of warped noise; where cloth is stretched there are none.
    const Vec3f warp = vec3(fbm3(p * 4.f, 2, footprint * 4.f, seed + 51) - 0.5f,
                            fbm3(p * 4.f, 2, footprint * 4.f, seed + 52) - 0.5f,
                            fbm3(p * 4.f, 2, footprint * 4.f, seed + 53) - 0.5f);
    const Vec3f q = p + warp * 0.11f;
    const float slack = smooth_step(0.4f, 0.75f, fbm3(p * 5.f, 2, footprint * 5.f, seed + 54));
    return 1.f -
           slack *
               (1.f - (0.65f * folds(q, 7.f, footprint, seed + 55) + 0.35f * folds(q, 16.f, footprint, seed + 56))) +
           1.2f * (fbm3(p * 6.f, 2, footprint * 6.f, seed + 57) - 0.5f);
}

TextureValue fabric(IN(Material) m, IN(TexturePoint) p) {
    // Threads are at most 2.5 mm wide whatever the scale, so that a sofa does not look like a basket.
    const float thread = clamp(m.scale_m, 0.0008f, 0.0025f);
    const Weave w = plain_weave(p.plane, thread, p.footprint_m);
    const float slub = fbm2(vec2(p.plane.x * 60.f, p.plane.y * 380.f), 2, p.footprint_m * 200.f, m.seed) - 0.5f;
    const float broad = fbm3(p.coords * 9.f, 3, p.footprint_m * 9.f, m.seed + 3) - 0.5f;
    TextureValue v;
    v.albedo = lerp(m.color_a, m.color_b, 0.3f * w.warp) *
               (1.f + 0.22f * (w.height - 0.5f) + 0.2f * slub + 0.1f * broad);
    v.roughness = max(m.roughness, 0.6f);
    v.height = w.height + 0.6f * slub;
    return v;
}

TextureValue knit(IN(Material) m, IN(TexturePoint) p) {
    // Columns of V-shaped stitches.
    const float s = positive(m.scale_m), fade = detail_fade(p.footprint_m, s);
    const float x = p.plane.x / s, column = x - float(floor_int(x)) - 0.5f;
    const float leg = fraction(p.plane.y / (0.8f * s) + 1.1f * abs(column));
    const float yarn = 1.f - 4.f * (leg - 0.5f) * (leg - 0.5f),
                groove = smooth_step(0.f, 0.14f, abs(column)) * smooth_step(0.f, 0.12f, 0.5f - abs(column));
    const float h = mix(0.6f, unit_clamp(yarn) * (0.4f + 0.6f * groove), fade);
    const float fuzz = fbm3(p.coords * 300.f, 2, p.footprint_m * 300.f, m.seed) - 0.5f;
    TextureValue v;
    v.albedo = lerp(m.color_b, m.color_a, 0.35f + 0.65f * h) * (0.8f + 0.3f * h + 0.15f * fuzz);
    v.roughness = max(m.roughness, 0.75f);
    v.height = h;
    return v;
}

TextureValue carpet(IN(Material) m, IN(TexturePoint) p) {
    const float tuft = fbm2(p.plane * 260.f, 3, p.footprint_m * 260.f, m.seed),
                shade = fbm2(p.plane * 3.f, 4, p.footprint_m * 3.f, m.seed + 5);
    const float fleck = fbm2(p.plane * 90.f, 2, p.footprint_m * 90.f, m.seed + 8);
    TextureValue v;
    v.albedo = lerp(m.color_a, m.color_b, unit_clamp(0.35f * shade + 0.8f * (fleck - 0.5f))) * (0.8f + 0.4f * tuft) *
               (0.93f + 0.14f * shade);
    v.roughness = 1.f;
    v.height = tuft;
    return v;
}

TextureValue leather(IN(Material) m, IN(TexturePoint) p) {
    const float fade = detail_fade(p.footprint_m, 0.005f);
    const float wear = fbm3(p.coords * 5.f, 4, p.footprint_m * 5.f, m.seed);
    const float kCreases = 0.25f;  // their mean
    float crease = 0.f;
    if (fade > 0.f) {
        const Voronoi c = voronoi2(p.plane * 260.f, m.seed + 2);
        crease = fade * (1.f - smooth_step(0.f, 0.22f, c.second - c.nearest));
    }
    TextureValue v;
    v.albedo = lerp(m.color_a, m.color_b, 0.6f * smooth_step(0.35f, 0.8f, wear)) *
               (1.f - 0.3f * (crease + kCreases * (1.f - fade)));
    v.roughness = m.roughness * (0.85f + 0.3f * wear) + 0.15f * crease;
    v.height = 1.f - crease;
    return v;
}

TextureValue wicker(IN(Material) m, IN(TexturePoint) p) {
    // Flat strands weave over and under round ribs.
    const float s = positive(m.scale_m), fade = detail_fade(p.footprint_m, 0.5f * s);
    const float row_v = p.plane.y / (0.5f * s);
    const int row = floor_int(row_v);
    const float across = row_v - float(row) - 0.5f;
    const float wave = 0.5f + 0.5f * sin(kTwoPi * (p.plane.x / (2.f * s) + 0.5f * float(row & 1)));
    const float h = mix(0.55f, unit_clamp((1.f - 4.f * across * across) * (0.25f + 0.75f * wave)), fade);
    const float tone = lattice_unit(row, floor_int(p.plane.x / (2.f * s)), 1, m.seed) - 0.5f;
    TextureValue v;
    const float kStrands = 0.54f;  // mean share of strands, for distant views
    v.albedo = lerp(m.color_b * 0.5f, m.color_a, mix(kStrands, smooth_step(0.f, 0.7f, h), fade)) *
               (1.f + 0.2f * fade * tone);
    v.roughness = m.roughness;
    v.height = h;
    return v;
}

KERNEL_END

#endif

// Other materials: metal, pictures, books, leaves, grass.
#ifndef FASTSCENE_TRACE_KERNEL_THINGS_H
#define FASTSCENE_TRACE_KERNEL_THINGS_H

#include "fastscene/trace/kernel/noise.h"
#include "fastscene/trace/kernel/material.h"

KERNEL_BEGIN

// A picture's palette: the material's three colors, paper and a dark tone.
static Vec3f paint(IN(Material) m, uint i) {
    switch (int(i % 5)) {
        case 0: return m.color_a;
        case 1: return m.color_b;
        case 2: return m.color_c;
        case 3: return vec3(0.8f, 0.77f, 0.7f);
        default: return lerp(m.color_b, vec3(0.03f, 0.035f, 0.05f), 0.8f);
    }
}

// Soft color fields, stacked vertically.
static Vec3f color_fields(IN(Material) m, Vec2f q, float soft) {
    Vec3f c = paint(m, 3);
    float y = 0.06f;
    for (uint i = 0; i < 3; ++i) {
        const float h = 0.18f + 0.17f * lattice_unit(int(i), 0, 1, m.seed);
        const float wobble = 0.02f * (fbm2(q * 9.f, 3, 0.f, m.seed + i) - 0.5f);
        const float inside = min(min(q.y - y, y + h - q.y), min(q.x - 0.07f, 0.93f - q.x)) + wobble;
        c = lerp(c, paint(m, i + m.seed % 3) * (0.85f + 0.3f * fbm2(q * 5.f, 4, 0.f, m.seed + 9)),
                 edge_cover(inside, 0.03f + soft));
        y += h + 0.04f;
    }
    return c;
}
// Overlapping discs and half discs.
static Vec3f discs(IN(Material) m, Vec2f q, float soft) {
    Vec3f c = paint(m, 3);
    for (int i = 0; i < 6; ++i) {
        const Vec2f center = vec2(0.15f + 0.7f * lattice_unit(i, 0, 2, m.seed),
                                  0.15f + 0.7f * lattice_unit(i, 1, 2, m.seed));
        const float r = 0.09f + 0.2f * lattice_unit(i, 2, 2, m.seed);
        float inside = r - length(q - center);
        if ((i & 1) != 0)
            inside = min(inside, (lattice_unit(i, 3, 2, m.seed) < 0.5f ? q.y - center.y : center.x - q.x));
        c = lerp(c, paint(m, uint(i)), edge_cover(inside, soft));
    }
    return c;
}
// Layered hills under a sky with a sun.
static Vec3f landscape(IN(Material) m, Vec2f q, float soft) {
    Vec3f c = lerp(paint(m, 3), m.color_a, 0.7f * unit_clamp(1.f - q.y));
    c = lerp(c, m.color_c,
             edge_cover(0.09f - length(q - vec2(0.3f + 0.4f * lattice_unit(0, 0, 3, m.seed), 0.28f)), soft));
    for (int i = 0; i < 4; ++i) {
        const float line = 0.42f + 0.14f * float(i) +
                           0.22f * (fbm2(vec2(q.x * (2.f + float(i)), float(i)), 3, 0.f, m.seed) - 0.5f);
        c = lerp(c, lerp(m.color_b, paint(m, 4), 0.28f * float(i)) * 1.05f, edge_cover(q.y - line, soft));
    }
    return c;
}
// Brush strokes that follow a swirling field.
static Vec3f strokes(IN(Material) m, Vec2f q, float soft) {
    const Vec2f warp = vec2(fbm2(q * 2.2f, 4, 0.f, m.seed) - 0.5f, fbm2(q * 2.2f, 4, 0.f, m.seed + 7) - 0.5f);
    const float t = fbm2(q * 1.6f + warp * 2.4f, 5, soft, m.seed + 3),
                u = fbm2(q * 2.6f + warp * 3.f, 4, soft, m.seed + 5);
    Vec3f c = lerp(paint(m, 3), m.color_a, smooth_step(0.35f, 0.6f, t));
    c = lerp(c, m.color_b, smooth_step(0.5f, 0.62f, u));
    return lerp(c, m.color_c, smooth_step(0.58f, 0.66f, t));
}
// A grid of rectangles with dark lines.
static Vec3f grid_picture(IN(Material) m, Vec2f q, float soft) {
    Vec2f low = vec2(0, 0), high = vec2(1, 1);
    uint id = 1;
    for (int depth = 0; depth < 5; ++depth) {
        const uint h = lattice_hash(int(id), depth, 4, m.seed);
        if (depth > 2 && (h & 3) == 0) break;
        const float cut = 0.3f + 0.4f * float(h >> 16) / 65536.f;
        const bool vertical = (high.x - low.x) > (high.y - low.y);
        const float at = vertical ? mix(low.x, high.x, cut) : mix(low.y, high.y, cut);
        const bool upper = (vertical ? q.x : q.y) > at;
        if (vertical && upper) low.x = at;
        else if (vertical) high.x = at;
        else if (upper) low.y = at;
        else high.y = at;
        id = id * 2 + (upper ? 1 : 0);
    }
    const float edge = min(min(q.x - low.x, high.x - q.x), min(q.y - low.y, high.y - q.y));
    const uint h = lattice_hash(int(id), 9, 4, m.seed);
    const Vec3f c = (h & 7) < 4 ? paint(m, 3) : paint(m, h >> 8);
    return lerp(c, vec3(0.03f, 0.03f, 0.035f), edge_cover(0.011f - edge, soft));
}

// Nested arches, as on a poster.
static Vec3f arches(IN(Material) m, Vec2f q, float soft) {
    Vec3f c = paint(m, 3);
    const Vec2f center = vec2(0.36f + 0.28f * lattice_unit(0, 0, 6, m.seed),
                              0.5f + 0.12f * lattice_unit(1, 0, 6, m.seed));
    for (int i = 0; i < 5; ++i) {
        const float r = 0.34f - 0.068f * float(i), dx = q.x - center.x, dy = q.y - center.y;
        const float inside = min(dy < 0 ? r - hypot(dx, dy) : r - abs(dx), 0.9f - q.y);
        c = lerp(c, i % 2 == 1 ? paint(m, 3) : paint(m, uint(i / 2)), edge_cover(inside, soft));
    }
    return lerp(c, m.color_c,
                edge_cover(0.075f - length(q - vec2(0.82f - 0.6f * lattice_unit(2, 0, 6, m.seed), 0.16f)), soft));
}
// A twig with leaves in ink.
static Vec3f twig(IN(Material) m, Vec2f q, float soft) {
    const Vec3f ink = lerp(m.color_a, paint(m, 4), 0.45f);
    const float sway = 0.16f * (lattice_unit(0, 0, 7, m.seed) - 0.5f), up = (0.93f - q.y) / 0.8f,
                stem = 0.5f + sway * sin(3.f * up);
    Vec3f c = paint(m, 3);
    if (up > 0.f && up < 1.f) c = lerp(c, ink, edge_cover(0.006f - abs(q.x - stem), soft));
    for (int i = 0; i < 11; ++i) {
        const float at = 0.14f + 0.08f * float(i), l = 0.27f * (1.1f - at);
        const float turn = (i % 2 != 0 ? 1.f : -1.f) * (0.75f + 0.3f * lattice_unit(i, 1, 7, m.seed));
        const Vec2f d = vec2(q.x - 0.5f - sway * sin(3.f * at), 0.93f - 0.8f * at - q.y);
        const float along = d.x * sin(turn) + d.y * cos(turn), across = d.x * cos(turn) - d.y * sin(turn),
                    t = along / l;
        if (!(t > 0.f && t < 1.f)) continue;
        const float width = 0.24f * l * sin(3.14159f * pow(t, 0.75f));
        c = lerp(c, ink * (0.8f + 0.4f * lattice_unit(i, 2, 7, m.seed)), edge_cover(width - abs(across), soft));
    }
    return c;
}
// The sea under an evening sky, in soft bands.
static Vec3f seascape(IN(Material) m, Vec2f q, float soft) {
    const float horizon = 0.5f + 0.15f * lattice_unit(0, 0, 8, m.seed);
    const Vec3f glow = lerp(paint(m, 3), m.color_a, 0.35f), deep = lerp(m.color_b, paint(m, 4), 0.35f);
    const float clouds = fbm2(vec2(q.x * 2.f, q.y * 9.f), 4, 0.f, m.seed),
                waves = fbm2(vec2(q.x * 5.f, q.y * q.y * 60.f), 3, soft * 30.f, m.seed + 3);
    const Vec3f sky = lerp(lerp(m.color_c, glow, smooth_step(0.f, horizon, q.y)), paint(m, 3),
                           0.5f * smooth_step(0.45f, 0.7f, clouds));
    const Vec3f sea = lerp(deep, glow, 0.55f * smooth_step(0.5f, 0.75f, waves) * (1.3f - q.y));
    return lerp(sky, sea, edge_cover(q.y - horizon, soft));
}

TextureValue metal(IN(Material) m, IN(TexturePoint) p) {
    const float brushed = fbm2(vec2(p.plane.x * 25.f, p.plane.y * 900.f), 2, p.footprint_m * 400.f, m.seed) - 0.5f;
    const float haze = fbm3(p.coords * 12.f, 3, p.footprint_m * 12.f, m.seed + 3) - 0.5f;
    TextureValue v;
    v.albedo = m.color_a * (1.f + 0.06f * brushed + 0.04f * haze);
    v.roughness = m.roughness * (1.f + 0.3f * haze + 0.15f * brushed);
    v.height = 0.5f + 0.5f * brushed;
    return v;
}

TextureValue art(IN(Material) m, IN(TexturePoint) p) {
    const float width = positive(m.scale_m);
    const Vec2f q = p.plane * (1.f / width);
    const float soft = max(p.footprint_m / width, 0.002f);
    TextureValue v;
    switch (int(m.variant) % kArtDesigns) {
        case 0: v.albedo = color_fields(m, q, soft); break;
        case 1: v.albedo = discs(m, q, soft); break;
        case 2: v.albedo = landscape(m, q, soft); break;
        case 3: v.albedo = strokes(m, q, soft); break;
        case 4: v.albedo = arches(m, q, soft); break;
        case 5: v.albedo = twig(m, q, soft); break;
        case 6: v.albedo = seascape(m, q, soft); break;
        default: v.albedo = grid_picture(m, q, soft); break;
    }
    const float canvas = fbm2(p.plane * 500.f, 2, p.footprint_m * 500.f, m.seed + 8);
    v.albedo = v.albedo * (0.96f + 0.08f * canvas);
    v.roughness = max(m.roughness, 0.5f);
    v.height = canvas;
    return v;
}

TextureValue book(IN(Material) m, IN(TexturePoint) p) {
    // The spine runs along y; gilt bands and a title of bars.
    const float s = positive(m.scale_m), y = p.coords.y / s, fp = p.footprint_m / s;
    const float tone = lattice_unit(1, 2, 3, m.seed);
    Vec3f c = m.color_a * (0.94f + 0.12f * fbm3(p.coords * 80.f, 2, p.footprint_m * 80.f, m.seed));
    const float band = line_cover(y - 0.12f - 0.05f * tone, 0.012f, fp) +
                       line_cover(y - 0.86f + 0.05f * tone, 0.012f, fp);
    float title = 0.f;
    if (y > 0.35f && y < 0.68f && abs(p.coords.x) < 0.25f * 0.04f)
        title = lattice_unit(floor_int(y * 60.f), 0, 5, m.seed) < 0.7f ? detail_fade(fp, 0.03f)
                                                                       : 0.3f * (1.f - detail_fade(fp, 0.03f));
    c = lerp(c, m.color_b, unit_clamp(band + title));
    TextureValue v;
    v.albedo = c;
    v.roughness = m.roughness;
    v.height = 0.5f;
    return v;
}

TextureValue leaf(IN(Material) m, IN(TexturePoint) p) {
    const float s = positive(m.scale_m), fp = p.footprint_m;
    const float rib = line_cover(p.plane.x, 0.012f * s + 0.0006f, fp);
    const float side = fraction((p.plane.y + abs(p.plane.x) * 0.9f) / (0.13f * s));
    const float vein = detail_fade(fp, 0.06f * s) * (1.f - smooth_step(0.f, 0.12f, min(side, 1.f - side)));
    const float cloud = fbm3(p.coords * (4.f / s), 3, fp * 4.f / s, m.seed);
    TextureValue v;
    v.albedo = lerp(m.color_a, m.color_b, unit_clamp(0.6f * (cloud - 0.25f) + 0.5f * rib + 0.3f * vein));
    v.roughness = m.roughness;
    v.height = 1.f - 0.7f * rib - 0.3f * vein;
    return v;
}

TextureValue grass(IN(Material) m, IN(TexturePoint) p) {
    const float blade = fbm2(vec2(p.plane.x * 240.f, p.plane.y * 90.f), 3, p.footprint_m * 200.f, m.seed),
                broad = fbm2(p.plane * 2.f, 4, p.footprint_m * 2.f, m.seed + 3);
    TextureValue v;
    v.albedo = lerp(m.color_a, m.color_b, broad) * (0.6f + 0.8f * blade);
    v.roughness = 0.95f;
    v.height = blade;
    return v;
}

KERNEL_END

#endif

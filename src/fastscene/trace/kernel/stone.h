// Stone, plaster and ceramics.
#ifndef FASTSCENE_TRACE_KERNEL_STONE_H
#define FASTSCENE_TRACE_KERNEL_STONE_H

#include "fastscene/trace/kernel/noise.h"
#include "fastscene/trace/kernel/material.h"

KERNEL_BEGIN

// A grid cell with joints: cell index, position within it, and the footprint's share of the joint.
struct Joint {
    int column, row;
    Vec2f local;
    float cover, edge_m;
};
static Joint grid(Vec2f p, float width, float height, float stagger, float half_joint, float footprint) {
    Joint j;
    j.row = floor_int(p.y / height);
    const float x = p.x + stagger * width * float(j.row & 1);
    j.column = floor_int(x / width);
    j.local = vec2(x - float(j.column) * width, p.y - float(j.row) * height);
    const float dx = min(j.local.x, width - j.local.x), dy = min(j.local.y, height - j.local.y);
    // A footprint as wide as a cell sees the mean share of joint.
    const float cx = mix(min(1.f, 2 * half_joint / width), line_cover(dx, half_joint, footprint),
                         detail_fade(footprint, width)),
                cy = mix(min(1.f, 2 * half_joint / height), line_cover(dy, half_joint, footprint),
                         detail_fade(footprint, height));
    j.cover = cx + cy - cx * cy;
    j.edge_m = min(dx, dy);
    return j;
}

// A glazed tile of the given color with its joint.
static TextureValue glazed(IN(Material) m, IN(Joint) j, Vec3f tone, float footprint) {
    const float shade = lattice_unit(j.column, j.row, 1, m.seed) - 0.5f;
    TextureValue v;
    v.albedo = lerp(tone * (1.f + 0.07f * shade), m.color_b, j.cover);
    v.roughness = mix(m.roughness, 0.85f, j.cover);
    // Laid by hand and glazed: each tile lies a little askew and its glaze is wavy, so each mirrors something else.
    const float kTilt = 0.006f, kGlaze_m = 0.00025f;
    const Vec2f lie = vec2(lattice_unit(j.column, j.row, 5, m.seed) - 0.5f,
                           lattice_unit(j.column, j.row, 6, m.seed) - 0.5f);
    const float glaze = fbm2(j.local * 32.f + vec2(7.f * float(j.column), 3.f * float(j.row)), 2, footprint * 32.f,
                             m.seed + 9);
    const float uneven_m = 2.f * kTilt * dot(lie, j.local) + kGlaze_m * glaze;
    v.height = (1.f - j.cover) * smooth_step(0.f, 0.006f + footprint, j.edge_m) + uneven_m / max(m.bump_m, 1e-4f);
    return v;
}

// Thin, wandering veins in [0, 1].
static float veins(Vec3f p, float footprint, uint seed) {
    const Vec3f warp = vec3(fbm3(p * 1.3f, 4, footprint * 1.3f, seed + 1) - 0.5f,
                            fbm3(p * 1.3f, 4, footprint * 1.3f, seed + 2) - 0.5f, 0.f);
    const float t = fbm3(p + warp * 1.6f, 4, footprint, seed);
    // From a distance veins get wider and paler, then fade to their mean.
    const float kWide = 0.055f, kMean = 0.2f, kGone = 0.5f;
    const float vein = (1.f - smooth_step(0.f, kWide + footprint, abs(t - 0.5f))) * kWide / (kWide + footprint);
    return mix(kMean, vein, detail_fade(footprint, kGone));
}

struct Marble {
    Vec3f color_a, color_b, color_c;
    float scale_m;
    uint seed;
};
static Vec3f marble_color(IN(Marble) m, Vec3f p, float footprint) {
    const float scale = 1.f / positive(m.scale_m);
    const float broad = veins(p * scale, footprint * scale, m.seed),
                fine = veins(p * (2.7f * scale), footprint * 2.7f * scale, m.seed + 31);
    const float cloud = fbm3(p * (0.8f * scale), 3, footprint * scale, m.seed + 17);
    Vec3f c = lerp(m.color_a, m.color_b, 0.28f * smooth_step(0.4f, 0.8f, cloud));
    const float mask = smooth_step(0.35f, 0.65f, fbm3(p * (0.5f * scale), 2, footprint * scale, m.seed + 41));
    c = lerp(c, m.color_b, 0.75f * broad * mask);
    return lerp(c, m.color_c, 0.22f * fine * (1.f - mask));
}

TextureValue plaster(IN(Material) m, IN(TexturePoint) p) {
    // The stipple of the roller, the plasterer's strokes beneath it, and a wall that is nowhere quite flat.
    const float cloud = fbm3(p.coords * 1.7f, 3, p.footprint_m * 1.7f, m.seed);
    const float stipple = fbm3(p.coords * 160.f, 2, p.footprint_m * 160.f, m.seed + 7);
    const float strokes = fbm3(p.coords * 19.f, 3, p.footprint_m * 19.f, m.seed + 3);
    const float uneven = fbm3(p.coords * 3.3f, 2, p.footprint_m * 3.3f, m.seed + 11);
    TextureValue v;
    v.albedo = m.color_a * (1.f + 0.07f * (cloud - 0.5f) + 0.05f * (strokes - 0.5f) + 0.06f * (stipple - 0.5f));
    v.roughness = m.roughness;
    v.height = stipple + 1.8f * strokes + 3.f * uneven;
    return v;
}

TextureValue tile(IN(Material) m, IN(TexturePoint) p) {
    const float s = positive(m.scale_m);
    const Joint j = grid(p.plane, s, s, 0.f, 0.0015f, p.footprint_m);
    const float cloud = fbm2(p.plane * (2.5f / s), 4, p.footprint_m * 2.5f / s, m.seed + 3);
    return glazed(m, j, m.color_a * (1.f + 0.1f * (cloud - 0.5f)), p.footprint_m);
}

TextureValue checker(IN(Material) m, IN(TexturePoint) p) {
    const float s = positive(m.scale_m);
    const Joint j = grid(p.plane, s, s, 0.f, 0.001f, p.footprint_m);
    // Beyond the tile size both colors merge.
    const float fade = detail_fade(p.footprint_m, s);
    const float side = ((j.column + j.row) & 1) != 0 ? 1.f : 0.f;
    Marble veined;
    veined.color_a = vec3(1, 1, 1);
    veined.color_b = vec3(0.8f, 0.8f, 0.8f);
    veined.color_c = vec3(0.75f, 0.75f, 0.75f);
    veined.scale_m = 0.5f;
    veined.seed = m.seed;
    const Vec3f vein = marble_color(
        veined, vec3(p.plane.x + 3.1f * side, p.plane.y, float(lattice_hash(j.column, j.row, 2, m.seed) & 63)),
        p.footprint_m);
    TextureValue v;
    v.albedo = lerp(m.color_a, m.color_b, mix(0.5f, side, fade)) * vein;
    v.albedo = lerp(v.albedo, vec3(0.25f, 0.24f, 0.22f), 0.6f * j.cover);
    v.roughness = mix(m.roughness, 0.7f, j.cover);
    v.height = 1.f - j.cover;
    return v;
}

TextureValue subway(IN(Material) m, IN(TexturePoint) p) {
    const float s = positive(m.scale_m);
    return glazed(m, grid(p.plane, 2.f * s, s, 0.5f, 0.0013f, p.footprint_m), m.color_a, p.footprint_m);
}

TextureValue brick(IN(Material) m, IN(TexturePoint) p) {
    const float course = positive(m.scale_m), stretch = course * 3.3f;
    // Hand-made edges: the joint wanders by one or two millimetres.
    const Vec2f wander = vec2(0.004f * (fbm2(p.plane * 40.f, 2, p.footprint_m * 40.f, m.seed + 1) - 0.5f),
                              0.004f * (fbm2(p.plane * 40.f, 2, p.footprint_m * 40.f, m.seed + 2) - 0.5f));
    const Joint j = grid(p.plane + wander, stretch, course, 0.5f, 0.005f, max(p.footprint_m, 0.0015f));
    const float tone = lattice_unit(j.column, j.row, 1, m.seed), shade = lattice_unit(j.column, j.row, 2, m.seed);
    const float grit = fbm2(p.plane * 90.f, 3, p.footprint_m * 90.f, m.seed + 3),
                stain = fbm2(p.plane * 9.f, 3, p.footprint_m * 9.f, m.seed + 4);
    Vec3f c = lerp(m.color_a, m.color_c, 0.55f * tone * tone) * (0.8f + 0.35f * shade);
    c = c * (0.82f + 0.36f * grit) * (0.88f + 0.24f * stain);
    const Vec3f mortar = m.color_b * (0.85f + 0.3f * grit);
    TextureValue v;
    v.albedo = lerp(c, mortar, j.cover);
    v.roughness = m.roughness;
    v.height = (1.f - j.cover) * (0.75f + 0.25f * grit) * smooth_step(0.f, 0.012f, j.edge_m);
    return v;
}

TextureValue concrete(IN(Material) m, IN(TexturePoint) p) {
    const float s = positive(m.scale_m);
    const float cloud = fbm3(p.coords * (1.f / s), 5, p.footprint_m / s, m.seed);
    const float grit = fbm3(p.coords * 120.f, 3, p.footprint_m * 120.f, m.seed + 3);
    TextureValue v;
    v.albedo = lerp(m.color_a, m.color_b, smooth_step(0.25f, 0.75f, cloud)) * (0.94f + 0.12f * grit);
    v.height = 0.8f + 0.2f * grit;
    const float fade = detail_fade(p.footprint_m, 0.008f);
    if (fade > 0.f) {  // a few air pores
        const Voronoi cell = voronoi2(p.plane * 22.f, m.seed + 5);
        const float pore = (cell.id & 7) == 0 ? fade * (1.f - smooth_step(0.05f, 0.09f, cell.nearest)) : 0.f;
        v.albedo = v.albedo * (1.f - 0.45f * pore);
        v.height *= 1.f - pore;
    }
    v.roughness = m.roughness * (0.85f + 0.3f * cloud);
    return v;
}

TextureValue marble(IN(Material) m, IN(TexturePoint) p) {
    TextureValue v;
    Marble stone;
    stone.color_a = m.color_a;
    stone.color_b = m.color_b;
    stone.color_c = m.color_c;
    stone.scale_m = m.scale_m;
    stone.seed = m.seed;
    v.albedo = marble_color(stone, p.coords, p.footprint_m);
    v.roughness = m.roughness;
    v.height = 1.f;
    return v;
}

TextureValue terrazzo(IN(Material) m, IN(TexturePoint) p) {
    // Two sizes of chips in the ground color.
    const float s = positive(m.scale_m);
    Vec3f c = m.color_a * (0.97f + 0.06f * fbm2(p.plane * (3.f / s), 3, p.footprint_m * 3.f / s, m.seed));
    for (int layer = 0; layer < 2; ++layer) {
        const float scale = (layer == 0 ? 2.2f : 1.f) / s;
        const Voronoi cell = voronoi2(p.plane * scale, m.seed + 11u + uint(layer));
        const float chip = edge_cover(
            (cell.second - cell.nearest - 0.16f - 0.25f * float(cell.id >> 24) / 255.f) / scale,
            p.footprint_m + 0.0006f);
        const uint kind = cell.id & 7;
        const Vec3f tone = kind < 2    ? m.color_b
                           : kind < 4  ? m.color_c
                           : kind == 4 ? lerp(m.color_b, m.color_c, 0.5f)
                                       : c;
        // From a distance: the mean of all chip colors, weighted by the area that chips cover.
        const float kChips = 0.42f;
        const Vec3f chipped = lerp(c, tone * (0.8f + 0.4f * float((cell.id >> 8) & 255) / 255.f), chip),
                    even = lerp(c, m.color_b * 0.3125f + m.color_c * 0.3125f + c * 0.375f, kChips);
        c = lerp(even, chipped, detail_fade(p.footprint_m, 1.5f / scale));
    }
    TextureValue v;
    v.albedo = c;
    v.roughness = m.roughness;
    v.height = 1.f;
    return v;
}

KERNEL_END

#endif

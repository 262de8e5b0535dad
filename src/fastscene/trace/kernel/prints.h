// Printed, woven or tiled repeats of one motif. color_a is the ground; color_b and color_c are drawn on it.
#ifndef FASTSCENE_TRACE_KERNEL_PRINTS_H
#define FASTSCENE_TRACE_KERNEL_PRINTS_H

#include "fastscene/trace/kernel/noise.h"
#include "fastscene/trace/kernel/material.h"

KERNEL_BEGIN

// The point in motif units, and the footprint in the same units.
struct Cell {
    Vec2f q;
    float fp;
};
static Cell cell_of(IN(Material) m, IN(TexturePoint) p) {
    const float s = positive(m.scale_m);
    Cell c;
    c.q = p.plane * (1.f / s);
    c.fp = p.footprint_m / s;
    return c;
}

// Coverage of a shape where `inside` > 0 (in motif units), fading to its mean `share` at a distance. `size`: its finest
// detail.
static float drawn(float inside, float fp, float share, float size) {
    return mix(share, edge_cover(inside, max(fp, 0.003f)), detail_fade(fp, size));
}

// Used for paper, cloth and enamel: the ground's own grain is too fine to resolve.
static TextureValue print_of(IN(Material) m, IN(TexturePoint) p, Vec3f color) {
    const float grain = fbm2(p.plane * 300.f, 2, p.footprint_m * 300.f, m.seed) - 0.5f;
    return texture_value(color * (1.f + 0.05f * grain), m.roughness, 0.5f + 0.5f * grain);
}

// Distance to the nearest integer, and to the nearest half-integer.
static float off_whole(float v) { return abs(v - round(v)); }
static float off_half(float v) { return abs(fraction(v) - 0.5f); }
// A band around every half-integer, filtered.
static float band_cover(float v, float reach, float fp) { return drawn(reach - off_half(v), fp, 2 * reach, 2 * reach); }

// Signed distance, positive inside, to a five-pointed star with outer radius r.
static float star_inside(Vec2f p, float r, float turn) {
    const float kFifth = 2.f * kPi / 5.f, kInner = 0.42f;
    float a = atan2(p.y, p.x) + turn;
    a -= kFifth * round(a / kFifth);
    const float l = length(p);
    const Vec2f q = vec2(l * cos(a), l * abs(sin(a))), tip = vec2(r, 0),
                notch = vec2(kInner * r * cos(0.5f * kFifth), kInner * r * sin(0.5f * kFifth));
    const Vec2f d = notch - tip, n = vec2(-d.y, d.x) * (1.f / length(d));
    return -((q.x - tip.x) * n.x + (q.y - tip.y) * n.y) * (n.x > 0.f ? 1.f : -1.f);
}

// Signed distance, positive inside, to a petal or leaf along +y.
static float petal_inside(Vec2f p, float l, float w) {
    const float t = p.y / l;
    return t < 0.f || t > 1.f ? -0.02f : w * sin(kPi * t) - abs(p.x);
}
static Vec2f spun(Vec2f p, float angle) {
    const float c = cos(angle), s = sin(angle);
    return vec2(c * p.x + s * p.y, c * p.y - s * p.x);
}

TextureValue dots(IN(Material) m, IN(TexturePoint) p) {
    // In half drop: one at each corner, one at the center.
    const float kRadius = 0.19f;
    const Cell cell = cell_of(m, p);
    const Vec2f q = cell.q;
    const float fp = cell.fp;
    const float first = length(vec2(off_whole(q.x), off_whole(q.y))),
                second = length(vec2(off_half(q.x), off_half(q.y)));
    return print_of(
        m, p,
        lerp(m.color_a, m.color_b, drawn(kRadius - min(first, second), fp, 2 * kPi * kRadius * kRadius, 2 * kRadius)));
}

TextureValue zigzag(IN(Material) m, IN(TexturePoint) p) {
    const Cell cell = cell_of(m, p);
    const Vec2f q = cell.q;
    const float fp = cell.fp;
    const float kRise = 0.5f;  // length of a zigzag leg, in units
    const float v = q.y + 2 * kRise * off_half(q.x);
    const float slant = 1.f / sqrt(1.f + 4 * kRise * kRise);
    return print_of(m, p, lerp(m.color_a, m.color_b, drawn((0.25f - off_half(v)) * slant, fp, 0.5f, 0.5f * slant)));
}

TextureValue twill(IN(Material) m, IN(TexturePoint) p) {
    // Herringbone weave: columns of alternately slanted lines.
    const Cell cell = cell_of(m, p);
    const Vec2f q = cell.q;
    const float fp = cell.fp;
    const float kLines = 3.f;
    const int column = floor_int(q.x);
    const float v = kLines * (q.y + ((column & 1) != 0 ? 1.f : -1.f) * fraction(q.x));
    const float inside = (0.22f - off_half(v)) / (kLines * 1.4142f);
    return print_of(m, p, lerp(m.color_a, m.color_b, drawn(inside, fp, 0.44f, 0.44f / (kLines * 1.4142f))));
}

TextureValue geometric(IN(Material) m, IN(TexturePoint) p) {
    // Quarter circles around one corner of each cell, occasionally a triangle instead.
    const Cell cell = cell_of(m, p);
    const Vec2f q = cell.q;
    const float fp = cell.fp;
    const int ix = floor_int(q.x), iy = floor_int(q.y);
    const uint id = lattice_hash(ix, iy, 6, m.seed);
    Vec2f o = vec2(q.x - float(ix), q.y - float(iy));
    if ((id & 1) != 0) o.x = 1.f - o.x;
    if ((id & 2) != 0) o.y = 1.f - o.y;
    const float kOuter = 0.92f, kInner = 0.44f, kQuarter = 0.25f * kPi;
    const bool triangle = ((id >> 2) & 3) == 0;
    const float outer = triangle ? (1.f - o.x - o.y) * 0.7071f : kOuter - length(o),
                inner = triangle ? -0.05f : kInner - length(o);
    const Vec3f first = (id & 16) != 0 ? m.color_c : m.color_b, second = (id & 16) != 0 ? m.color_b : m.color_c;
    const Vec3f near = lerp(lerp(m.color_a, first, edge_cover(outer, max(fp, 0.003f))), second,
                            edge_cover(inner, max(fp, 0.003f)));
    // Three cells in four have circles.
    const float large = 0.75f * kQuarter * (kOuter * kOuter - kInner * kInner) + 0.125f,
                small = 0.75f * kQuarter * kInner * kInner, both = large + small;
    const Vec3f far = m.color_a * (1.f - both) + (m.color_b + m.color_c) * (0.5f * both);
    return print_of(m, p, lerp(far, near, detail_fade(fp, 0.6f)));
}

inline float diamond_side(float t, float wide) {
    return 2.f * edge_cover(0.5f - abs(2.f * fraction(0.5f * t) - 1.f), max(wide, 0.003f)) - 1.f;
}
TextureValue diamonds(IN(Material) m, IN(TexturePoint) p) {
    // Harlequin diamonds with a fine line through their centers.
    const Cell cell = cell_of(m, p);
    const Vec2f q = cell.q;
    const float fp = cell.fp;
    const float a = q.x + 0.6f * q.y, b = q.x - 0.6f * q.y, wide = 1.17f * fp;
    const float cover = mix(0.5f, 0.5f + 0.5f * diamond_side(a, wide) * diamond_side(b, wide), detail_fade(fp, 0.7f));
    const float line = drawn(0.016f - min(off_half(a), off_half(b)), wide, 0.063f, 0.1f);
    return print_of(m, p, lerp(lerp(m.color_a, m.color_b, cover), m.color_c, 0.8f * line));
}

TextureValue lattice(IN(Material) m, IN(TexturePoint) p) {
    // Ogees: wavy lines that meet and part, with a small flower in each opening.
    const Cell cell = cell_of(m, p);
    const Vec2f q = cell.q;
    const float fp = cell.fp;
    const float y = q.y * 0.8f, wave = 0.25f + 0.19f * cos(2 * kPi * y),
                steep = 0.8f * 0.19f * 2 * kPi * sin(2 * kPi * y);
    const float apart = abs(off_half(q.x) - wave) / sqrt(1.f + steep * steep);
    const float line = max(drawn(0.026f - apart, fp, 0.13f, 0.06f),
                           0.5f * drawn(0.008f - abs(apart - 0.055f), fp, 0.06f, 0.04f));
    // The openings: around the half-integers where the wave is widest, around the integers where it is narrowest.
    const Vec2f first = vec2(fraction(q.x) - 0.5f, off_whole(y) / 0.8f),
                second = vec2(q.x - round(q.x), off_half(y) / 0.8f);
    const Vec2f o = length(first) < length(second) ? first : second;
    const float flower = drawn(0.1f * (0.72f + 0.28f * cos(4.f * atan2(o.y, o.x))) - length(o), fp, 0.035f, 0.1f);
    return print_of(m, p, lerp(lerp(m.color_a, m.color_b, line), m.color_c, flower));
}

inline float star_at(Vec2f at, int layer, uint seed) {
    const int ix = floor_int(at.x), iy = floor_int(at.y);
    const float turn = lattice_unit(ix, iy, layer, seed) * 2 * kPi;
    return star_inside(vec2(at.x - float(ix) - 0.5f, at.y - float(iy) - 0.5f), layer == 8 ? 0.24f : 0.15f, turn);
}
TextureValue stars(IN(Material) m, IN(TexturePoint) p) {
    const Cell cell = cell_of(m, p);
    const Vec2f q = cell.q;
    const float fp = cell.fp;
    const float inside = max(star_at(q, 8, m.seed), star_at(q + vec2(0.5f, 0.5f), 9, m.seed));
    return print_of(m, p, lerp(m.color_a, m.color_b, drawn(inside, fp, 0.099f, 0.15f)));
}

TextureValue gingham(IN(Material) m, IN(TexturePoint) p) {
    const Cell cell = cell_of(m, p);
    const Vec2f q = cell.q;
    const float fp = cell.fp;
    const float across = band_cover(q.x, 0.25f, fp), down = band_cover(q.y, 0.25f, fp);
    return print_of(m, p, lerp(m.color_a, m.color_b, 0.5f * (across + down)));
}

inline float plaid_band(float v, float fp) {
    return min(1.f, band_cover(v, 0.2f, fp) + drawn(0.03f - off_whole(v), fp, 0.06f, 0.06f));
}
inline float plaid_line(float v, float fp) { return drawn(0.012f - abs(off_half(v) - 0.36f), fp, 0.048f, 0.05f); }
TextureValue plaid(IN(Material) m, IN(TexturePoint) p) {
    // A broad and a narrow band in each direction, crossed by fine lines.
    const Cell cell = cell_of(m, p);
    const Vec2f q = cell.q;
    const float fp = cell.fp;
    const Vec3f c = lerp(m.color_a, m.color_b, 0.5f * (plaid_band(q.x, fp) + plaid_band(q.y, fp)));
    return print_of(m, p, lerp(c, m.color_c, 0.4f * (plaid_line(q.x, fp) + plaid_line(q.y, fp))));
}

TextureValue houndstooth(IN(Material) m, IN(TexturePoint) p) {
    // Four dark and four light threads in each direction, in a 2/2 twill: that alone produces the teeth.
    const Cell cell = cell_of(m, p);
    const Vec2f q = cell.q;
    const float fp = cell.fp;
    const int i = floor_int(q.x * 8.f), j = floor_int(q.y * 8.f);
    const bool dark = ((((i + j) & 3) < 2 ? i >> 2 : j >> 2) & 1) != 0;
    return print_of(m, p, lerp(m.color_a, m.color_b, mix(0.5f, dark ? 1.f : 0.f, detail_fade(fp, 0.25f))));
}

static Vec3f cloth_color(IN(Material) m, int which) {
    return which == 0 ? m.color_a : which == 1 ? m.color_b : which == 2 ? m.color_c : lerp(m.color_b, m.color_c, 0.5f);
}
TextureValue patchwork(IN(Material) m, IN(TexturePoint) p) {
    // Squares of cloth with a print each, and seams around them.
    const Cell cell = cell_of(m, p);
    const Vec2f q = cell.q;
    const float fp = cell.fp;
    const int ix = floor_int(q.x), iy = floor_int(q.y);
    const uint id = lattice_hash(ix, iy, 11, m.seed);
    const Vec2f o = vec2(q.x - float(ix) - 0.5f, q.y - float(iy) - 0.5f);
    const int which = int(id & 3), other = (which + 1 + int((id >> 2) % 3)) & 3;
    const Vec3f ground = cloth_color(m, which), ink = lerp(ground, cloth_color(m, other), 0.75f);
    float on = 0;
    switch (int((id >> 5) % 5)) {
        case 0: on = drawn(0.28f - off_half(o.x * 7.f) * 1.f, fp * 7.f, 0.56f, 0.56f); break;
        case 1:
            on = drawn(0.24f - length(vec2(off_half(o.x * 5.f), off_half(o.y * 5.f))), fp * 5.f, 0.181f, 0.48f);
            break;
        case 2: on = 0.5f * (band_cover(o.x * 4.f, 0.25f, fp * 4.f) + band_cover(o.y * 4.f, 0.25f, fp * 4.f)); break;
        case 3: {
            const float a = atan2(o.y, o.x);
            on = drawn(0.34f * (0.68f + 0.32f * cos(6.f * a)) - length(o), fp, 0.19f, 0.4f);
            break;
        }
        default: break;
    }
    const float edge = 0.5f - max(abs(o.x), abs(o.y));
    const float seam = line_cover(edge, 0.012f, max(fp, 0.003f)) * detail_fade(fp, 0.5f);
    TextureValue v = print_of(m, p, lerp(ground, ink, on) * (1.f - 0.35f * seam));
    v.height = smooth_step(0.f, 0.16f, edge);
    return v;
}

TextureValue leopard(IN(Material) m, IN(TexturePoint) p) {
    // Broken rings around a darker center.
    const Cell cell = cell_of(m, p);
    const Vec2f q = cell.q;
    const float fp = cell.fp;
    const Vec2f warp = vec2(fbm2(q * 2.3f, 2, fp * 2.3f, m.seed + 1) - 0.5f,
                            fbm2(q * 2.3f, 2, fp * 2.3f, m.seed + 2) - 0.5f);
    const Voronoi spot_cell = voronoi2((q + warp * 0.22f) * 2.6f, m.seed);
    const float d = length(spot_cell.offset), room = min(0.42f, 0.5f * (spot_cell.second + spot_cell.nearest) * 0.72f),
                a = atan2(spot_cell.offset.y, spot_cell.offset.x);
    const float gap = noise2(vec2(1.1f * a + float(spot_cell.id & 63), float((spot_cell.id >> 6) & 63)), m.seed + 3);
    const float ring = min(0.1f - abs(d - 0.74f * room), (gap - 0.36f) * 0.35f);
    const float fade = detail_fade(fp, 0.2f), soft = max(2.6f * fp, 0.02f);
    const float spot = mix(0.205f, edge_cover(ring, soft), fade),
                middle = mix(0.165f, edge_cover(0.74f * room - d, soft), fade);
    return print_of(m, p, lerp(lerp(m.color_a, m.color_c, 0.7f * middle), m.color_b, spot));
}

TextureValue zebra(IN(Material) m, IN(TexturePoint) p) {
    const Cell cell = cell_of(m, p);
    const Vec2f q = cell.q;
    const float fp = cell.fp;
    const float bend = fbm2(q * 0.55f, 2, fp, m.seed) * 3.2f,
                fork = fbm2(vec2(q.x * 0.8f, q.y * 1.9f), 2, fp, m.seed + 4) - 0.5f;
    const float v = 2.4f * q.y + bend + 1.2f * fork;
    return print_of(m, p, lerp(m.color_a, m.color_b, drawn((0.25f - off_half(v)) / 2.8f, fp, 0.5f, 0.18f)));
}

TextureValue camouflage(IN(Material) m, IN(TexturePoint) p) {
    const Cell cell = cell_of(m, p);
    const Vec2f q = cell.q;
    const float fp = cell.fp;
    const float first = fbm2(q * 1.6f, 3, fp, m.seed) - 0.54f,
                second = fbm2(q * 1.9f + vec2(17.f, 5.f), 3, fp, m.seed + 9) - 0.57f, soft = max(fp, 0.02f);
    const Vec3f c = lerp(m.color_a, m.color_b, mix(0.37f, edge_cover(first, soft), detail_fade(fp, 0.4f)));
    return print_of(m, p, lerp(c, m.color_c, mix(0.29f, edge_cover(second, soft), detail_fade(fp, 0.4f))));
}

TextureValue paisley(IN(Material) m, IN(TexturePoint) p) {
    // Drops with a bent tip, each with a rim and an eye; half drop, alternately rotated.
    const Cell cell = cell_of(m, p);
    const Vec2f q = cell.q;
    const float fp = cell.fp;
    float inside = -1.f;
    Vec2f eye = vec2(1.f, 1.f);
    for (int layer = 0; layer < 2; ++layer) {
        const float drop = layer == 0 ? 0.f : 0.5f;
        const Vec2f at = q + vec2(drop, drop);
        const Vec2f o = vec2(fraction(at.x) - 0.5f, fraction(at.y) - 0.5f),
                    t = spun(drop > 0.f ? vec2(-o.x, -o.y) : o, 0.45f);
        for (int i = 0; i < 9; ++i) {
            const float s = float(i) / 8.f;
            const float here = 0.155f * pow(1.f - s, 0.85f) - length(t - vec2(0.11f * s * s, -0.09f + 0.33f * s));
            if (here > inside) {
                inside = here;
                eye = t - vec2(0.f, -0.09f);
            }
        }
    }
    const float body = drawn(inside, fp, 0.256f, 0.2f), rim = drawn(0.012f - abs(inside + 0.028f), fp, 0.11f, 0.05f),
                speck = drawn(0.055f - length(eye), fp, 0.019f, 0.1f);
    return print_of(m, p, lerp(lerp(lerp(m.color_a, m.color_b, body), m.color_c, rim), m.color_a, speck));
}

TextureValue encaustic(IN(Material) m, IN(TexturePoint) p) {
    // Cement tiles: an eight-petalled flower, with quarter rings in the corners that meet those of the neighbours.
    const Cell cell = cell_of(m, p);
    const Vec2f q = cell.q;
    const float fp = cell.fp;
    const int ix = floor_int(q.x), iy = floor_int(q.y);
    const Vec2f o = vec2(q.x - float(ix) - 0.5f, q.y - float(iy) - 0.5f), fold = vec2(abs(o.x), abs(o.y));
    const float corner = length(vec2(0.5f - fold.x, 0.5f - fold.y));
    float petals = -1.f;
    for (int i = 0; i < 8; ++i)
        petals = max(petals, petal_inside(spun(o, float(i) * 0.25f * kPi), (i & 1) != 0 ? 0.3f : 0.4f,
                                          (i & 1) != 0 ? 0.045f : 0.075f));
    const float ring = 0.032f - abs(corner - 0.3f), disc = 0.17f - corner;
    const float first = drawn(max(petals, ring), fp, 0.35f, 0.08f),
                second = drawn(max(disc, 0.055f - length(o)), fp, 0.1f, 0.1f);
    const float edge = 0.5f - max(fold.x, fold.y),
                joint = mix(0.012f, line_cover(edge, 0.004f, max(fp, 0.001f)), detail_fade(fp, 0.1f));
    const float shade = lattice_unit(ix, iy, 1, m.seed) - 0.5f;
    TextureValue v;
    v.albedo = lerp(lerp(lerp(m.color_a, m.color_b, first), m.color_c, second) * (1.f + 0.06f * shade),
                    vec3(0.42f, 0.4f, 0.37f), joint);
    v.roughness = mix(m.roughness, 0.85f, joint);
    v.height = 1.f - joint;
    return v;
}

TextureValue laid_tiles(IN(Material) m, IN(TexturePoint) p) {
    // Glazed 3 x 1 tiles in a herringbone at 45 degrees; color_b is the grout. Cells as in the parquet
    // (wood.h).
    const int n = 3;
    const float kJoint = 0.02f;
    const float r = 0.70710678f / positive(m.scale_m), fp = p.footprint_m / positive(m.scale_m);
    const float x = (p.plane.x + p.plane.y) * r, y = (p.plane.y - p.plane.x) * r;
    const int ix = floor_int(x), iy = floor_int(y), k = wrapped(ix - iy, 2 * n);
    const bool lying = k < n;
    const float along = lying ? float(k) + x - float(ix) : float(2 * n - 1 - k) + y - float(iy);
    const float across = lying ? y - float(iy) : x - float(ix);
    const uint id = lying ? lattice_hash(ix - k, iy, 3, m.seed) : lattice_hash(ix, iy - (2 * n - 1 - k), 4, m.seed);
    const float edge = min(min(across, 1.f - across), min(along, float(n) - along));
    const float joint = mix(2 * kJoint * (1.f + 1.f / n), line_cover(edge, kJoint, max(fp, 0.003f)),
                            detail_fade(fp, 0.5f));
    const float shade = float(id & 255) / 255.f - 0.5f;
    TextureValue v;
    v.albedo = lerp(m.color_a * (1.f + 0.16f * shade), m.color_b, joint);
    v.roughness = mix(m.roughness, 0.85f, joint);
    v.height = (1.f - joint) * smooth_step(0.f, 0.08f, edge);
    return v;
}

TextureValue peeling(IN(Material) m, IN(TexturePoint) p) {
    // Stained old paint (color_a) that has peeled off in patches: color_b is the plaster below. Patch edges curl up.
    const Cell cell = cell_of(m, p);
    const Vec2f q = cell.q;
    const float fp = cell.fp;
    const float broad = fbm2(q, 5, fp, m.seed) - 0.5f, fine = fbm2(q * 6.f, 3, fp * 6.f, m.seed + 5) - 0.5f,
                lost = broad + 0.18f * fine - 0.085f;
    const float bare = mix(0.3f, edge_cover(lost, max(fp, 0.006f)), detail_fade(fp, 0.5f)),
                rim = unit_clamp(1.f - abs(lost) / 0.014f) * detail_fade(fp, 0.05f);
    const float stain = smooth_step(0.5f, 0.8f, fbm2(vec2(q.x * 1.9f, q.y * 0.45f), 4, fp, m.seed + 13)),
                grime = fbm2(q * 0.5f, 3, fp, m.seed + 21);
    const Vec3f paint = m.color_a * (1.f - 0.35f * stain) * (0.82f + 0.3f * grime),
                plaster_tone = m.color_b * (0.85f + 0.3f * fine);
    TextureValue v;
    v.albedo = lerp(paint, plaster_tone, bare) * (1.f - 0.35f * rim * (1.f - bare));
    v.roughness = max(m.roughness, 0.75f);
    v.height = unit_clamp(0.5f * (1.f - bare) + 0.35f * rim);
    return v;
}

KERNEL_END

#endif

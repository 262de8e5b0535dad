// Printed, woven or tiled repeats of one motif. color_a is the ground; color_b and color_c are drawn on it.
#include "fastscene/trace/patterns.h"

namespace fastscene::patterns {
namespace {

// The point in motif units, and the footprint in the same units.
struct Cell {
    Vec2f q;
    float fp;
};
Cell cell_of(const Material& m, const TexturePoint& p) {
    const float s = positive(m.scale_m);
    return {p.flat * (1.f / s), p.footprint_m / s};
}

// Coverage of a shape where `inside` > 0 (in motif units), fading to its mean `share` at a distance. `size`: its finest
// detail.
float drawn(float inside, float fp, float share, float size) {
    return mix(share, edge_cover(inside, std::max(fp, 0.003f)), detail_fade(fp, size));
}

// Used for paper, cloth and enamel: the ground's own grain is too fine to resolve.
TextureValue print_of(const Material& m, const TexturePoint& p, Vec3f color) {
    const float grain = fbm2(p.flat * 300.f, 2, p.footprint_m * 300.f, m.seed) - 0.5f;
    return {color * (1.f + 0.05f * grain), m.roughness, 0.5f + 0.5f * grain};
}

// Distance to the nearest integer, and to the nearest half-integer.
float off_whole(float v) { return std::fabs(v - std::round(v)); }
float off_half(float v) { return std::fabs(fraction(v) - 0.5f); }
// A band around every half-integer, filtered.
float band_cover(float v, float half, float fp) { return drawn(half - off_half(v), fp, 2 * half, 2 * half); }

// Signed distance, positive inside, to a five-pointed star with outer radius r.
float star_inside(Vec2f p, float r, float turn) {
    constexpr float kFifth = 2.f * kPi / 5.f, kInner = 0.42f;
    float a = std::atan2(p.y, p.x) + turn;
    a -= kFifth * std::round(a / kFifth);
    const float l = length(p);
    const Vec2f q{l * std::cos(a), l * std::fabs(std::sin(a))}, tip{r, 0},
        notch{kInner * r * std::cos(0.5f * kFifth), kInner * r * std::sin(0.5f * kFifth)};
    const Vec2f d = notch - tip, n = Vec2f{-d.y, d.x} * (1.f / length(d));
    return -((q.x - tip.x) * n.x + (q.y - tip.y) * n.y) * (n.x > 0.f ? 1.f : -1.f);
}

// Signed distance, positive inside, to a petal or leaf along +y.
float petal_inside(Vec2f p, float l, float w) {
    const float t = p.y / l;
    return t < 0.f || t > 1.f ? -0.02f : w * std::sin(kPi * t) - std::fabs(p.x);
}
Vec2f spun(Vec2f p, float angle) {
    const float c = std::cos(angle), s = std::sin(angle);
    return {c * p.x + s * p.y, c * p.y - s * p.x};
}

}  // namespace

TextureValue dots(const Material& m, const TexturePoint& p) {
    // In half drop: one at each corner, one at the center.
    constexpr float kRadius = 0.19f;
    const auto [q, fp] = cell_of(m, p);
    const float first = length(Vec2f{off_whole(q.x), off_whole(q.y)}),
                second = length(Vec2f{off_half(q.x), off_half(q.y)});
    return print_of(m, p,
                    lerp(m.color_a, m.color_b,
                         drawn(kRadius - std::min(first, second), fp, 2 * kPi * kRadius * kRadius, 2 * kRadius)));
}

TextureValue zigzag(const Material& m, const TexturePoint& p) {
    const auto [q, fp] = cell_of(m, p);
    constexpr float kRise = 0.5f;  // length of a zigzag leg, in units
    const float v = q.y + 2 * kRise * off_half(q.x);
    const float slant = 1.f / std::sqrt(1.f + 4 * kRise * kRise);
    return print_of(m, p, lerp(m.color_a, m.color_b, drawn((0.25f - off_half(v)) * slant, fp, 0.5f, 0.5f * slant)));
}

TextureValue twill(const Material& m, const TexturePoint& p) {
    // Herringbone weave: columns of alternately slanted lines.
    const auto [q, fp] = cell_of(m, p);
    constexpr float kLines = 3.f;
    const int column = floor_int(q.x);
    const float v = kLines * (q.y + ((column & 1) ? 1.f : -1.f) * fraction(q.x));
    const float in = (0.22f - off_half(v)) / (kLines * 1.4142f);
    return print_of(m, p, lerp(m.color_a, m.color_b, drawn(in, fp, 0.44f, 0.44f / (kLines * 1.4142f))));
}

TextureValue geometric(const Material& m, const TexturePoint& p) {
    // Quarter circles around one corner of each cell, occasionally a triangle instead.
    const auto [q, fp] = cell_of(m, p);
    const int ix = floor_int(q.x), iy = floor_int(q.y);
    const std::uint32_t id = lattice_hash(ix, iy, 6, m.seed);
    Vec2f o{q.x - static_cast<float>(ix), q.y - static_cast<float>(iy)};
    if (id & 1) o.x = 1.f - o.x;
    if (id & 2) o.y = 1.f - o.y;
    constexpr float kOuter = 0.92f, kInner = 0.44f, kQuarter = 0.25f * kPi;
    const bool triangle = ((id >> 2) & 3) == 0;
    const float outer = triangle ? (1.f - o.x - o.y) * 0.7071f : kOuter - length(o),
                inner = triangle ? -0.05f : kInner - length(o);
    const Vec3f first = (id & 16) ? m.color_c : m.color_b, second = (id & 16) ? m.color_b : m.color_c;
    const Vec3f near = lerp(lerp(m.color_a, first, edge_cover(outer, std::max(fp, 0.003f))), second,
                            edge_cover(inner, std::max(fp, 0.003f)));
    // Three cells in four have circles.
    const float large = 0.75f * kQuarter * (kOuter * kOuter - kInner * kInner) + 0.125f,
                small = 0.75f * kQuarter * kInner * kInner, both = large + small;
    const Vec3f far = m.color_a * (1.f - both) + (m.color_b + m.color_c) * (0.5f * both);
    return print_of(m, p, lerp(far, near, detail_fade(fp, 0.6f)));
}

TextureValue diamonds(const Material& m, const TexturePoint& p) {
    // Harlequin diamonds with a fine line through their centers.
    const auto [q, fp] = cell_of(m, p);
    const float a = q.x + 0.6f * q.y, b = q.x - 0.6f * q.y, wide = 1.17f * fp;
    const auto side = [&](float t) {
        return 2.f * edge_cover(0.5f - std::fabs(2.f * fraction(0.5f * t) - 1.f), std::max(wide, 0.003f)) - 1.f;
    };
    const float cover = mix(0.5f, 0.5f + 0.5f * side(a) * side(b), detail_fade(fp, 0.7f));
    const float line = drawn(0.016f - std::min(off_half(a), off_half(b)), wide, 0.063f, 0.1f);
    return print_of(m, p, lerp(lerp(m.color_a, m.color_b, cover), m.color_c, 0.8f * line));
}

TextureValue lattice(const Material& m, const TexturePoint& p) {
    // Ogees: wavy lines that meet and part, with a small flower in each opening.
    const auto [q, fp] = cell_of(m, p);
    const float y = q.y * 0.8f, wave = 0.25f + 0.19f * std::cos(2 * kPi * y),
                steep = 0.8f * 0.19f * 2 * kPi * std::sin(2 * kPi * y);
    const float apart = std::fabs(off_half(q.x) - wave) / std::sqrt(1.f + steep * steep);
    const float line = std::max(drawn(0.026f - apart, fp, 0.13f, 0.06f),
                                0.5f * drawn(0.008f - std::fabs(apart - 0.055f), fp, 0.06f, 0.04f));
    // The openings: around the half-integers where the wave is widest, around the integers where it is narrowest.
    const Vec2f first{fraction(q.x) - 0.5f, off_whole(y) / 0.8f}, second{q.x - std::round(q.x), off_half(y) / 0.8f};
    const Vec2f o = length(first) < length(second) ? first : second;
    const float flower = drawn(0.1f * (0.72f + 0.28f * std::cos(4.f * std::atan2(o.y, o.x))) - length(o), fp, 0.035f,
                               0.1f);
    return print_of(m, p, lerp(lerp(m.color_a, m.color_b, line), m.color_c, flower));
}

TextureValue stars(const Material& m, const TexturePoint& p) {
    const auto [q, fp] = cell_of(m, p);
    const auto star_at = [&](Vec2f at, int layer) {
        const int ix = floor_int(at.x), iy = floor_int(at.y);
        const float turn = lattice_unit(ix, iy, layer, m.seed) * 2 * kPi;
        return star_inside({at.x - static_cast<float>(ix) - 0.5f, at.y - static_cast<float>(iy) - 0.5f},
                           layer == 8 ? 0.24f : 0.15f, turn);
    };
    const float in = std::max(star_at(q, 8), star_at(q + Vec2f{0.5f, 0.5f}, 9));
    return print_of(m, p, lerp(m.color_a, m.color_b, drawn(in, fp, 0.099f, 0.15f)));
}

TextureValue gingham(const Material& m, const TexturePoint& p) {
    const auto [q, fp] = cell_of(m, p);
    const float across = band_cover(q.x, 0.25f, fp), down = band_cover(q.y, 0.25f, fp);
    return print_of(m, p, lerp(m.color_a, m.color_b, 0.5f * (across + down)));
}

TextureValue plaid(const Material& m, const TexturePoint& p) {
    // A broad and a narrow band in each direction, crossed by fine lines.
    const auto [q, fp] = cell_of(m, p);
    const auto bands = [&](float v) {
        return std::min(1.f, band_cover(v, 0.2f, fp) + drawn(0.03f - off_whole(v), fp, 0.06f, 0.06f));
    };
    const auto lines = [&](float v) { return drawn(0.012f - std::fabs(off_half(v) - 0.36f), fp, 0.048f, 0.05f); };
    const Vec3f c = lerp(m.color_a, m.color_b, 0.5f * (bands(q.x) + bands(q.y)));
    return print_of(m, p, lerp(c, m.color_c, 0.4f * (lines(q.x) + lines(q.y))));
}

TextureValue houndstooth(const Material& m, const TexturePoint& p) {
    // Four dark and four light threads in each direction, in a 2/2 twill: that alone produces the teeth.
    const auto [q, fp] = cell_of(m, p);
    const int i = floor_int(q.x * 8.f), j = floor_int(q.y * 8.f);
    const bool dark = (((i + j) & 3) < 2 ? i >> 2 : j >> 2) & 1;
    return print_of(m, p, lerp(m.color_a, m.color_b, mix(0.5f, dark ? 1.f : 0.f, detail_fade(fp, 0.25f))));
}

TextureValue patchwork(const Material& m, const TexturePoint& p) {
    // Squares of cloth with a print each, and seams around them.
    const auto [q, fp] = cell_of(m, p);
    const int ix = floor_int(q.x), iy = floor_int(q.y);
    const std::uint32_t id = lattice_hash(ix, iy, 11, m.seed);
    const Vec2f o{q.x - static_cast<float>(ix) - 0.5f, q.y - static_cast<float>(iy) - 0.5f};
    const Vec3f cloths[4] = {m.color_a, m.color_b, m.color_c, lerp(m.color_b, m.color_c, 0.5f)};
    const auto which = static_cast<std::size_t>(id & 3), other = (which + 1 + ((id >> 2) % 3)) & 3;
    const Vec3f ground = cloths[which], ink = lerp(ground, cloths[other], 0.75f);
    float on = 0;
    switch ((id >> 5) % 5) {
        case 0: on = drawn(0.28f - off_half(o.x * 7.f) * 1.f, fp * 7.f, 0.56f, 0.56f); break;
        case 1:
            on = drawn(0.24f - length(Vec2f{off_half(o.x * 5.f), off_half(o.y * 5.f)}), fp * 5.f, 0.181f, 0.48f);
            break;
        case 2: on = 0.5f * (band_cover(o.x * 4.f, 0.25f, fp * 4.f) + band_cover(o.y * 4.f, 0.25f, fp * 4.f)); break;
        case 3: {
            const float a = std::atan2(o.y, o.x);
            on = drawn(0.34f * (0.68f + 0.32f * std::cos(6.f * a)) - length(o), fp, 0.19f, 0.4f);
            break;
        }
        default: break;
    }
    const float edge = 0.5f - std::max(std::fabs(o.x), std::fabs(o.y));
    const float seam = line_cover(edge, 0.012f, std::max(fp, 0.003f)) * detail_fade(fp, 0.5f);
    TextureValue v = print_of(m, p, lerp(ground, ink, on) * (1.f - 0.35f * seam));
    v.height = smooth_step(0.f, 0.16f, edge);
    return v;
}

TextureValue leopard(const Material& m, const TexturePoint& p) {
    // Broken rings around a darker center.
    const auto [q, fp] = cell_of(m, p);
    const Vec2f warp{fbm2(q * 2.3f, 2, fp * 2.3f, m.seed + 1) - 0.5f, fbm2(q * 2.3f, 2, fp * 2.3f, m.seed + 2) - 0.5f};
    const Voronoi cell = voronoi2((q + warp * 0.22f) * 2.6f, m.seed);
    const float d = length(cell.offset), room = std::min(0.42f, 0.5f * (cell.second + cell.nearest) * 0.72f),
                a = std::atan2(cell.offset.y, cell.offset.x);
    const float gap = noise2({1.1f * a + static_cast<float>(cell.id & 63), static_cast<float>((cell.id >> 6) & 63)},
                             m.seed + 3);
    const float ring = std::min(0.1f - std::fabs(d - 0.74f * room), (gap - 0.36f) * 0.35f);
    const float fade = detail_fade(fp, 0.2f), soft = std::max(2.6f * fp, 0.02f);
    const float spot = mix(0.205f, edge_cover(ring, soft), fade),
                middle = mix(0.165f, edge_cover(0.74f * room - d, soft), fade);
    return print_of(m, p, lerp(lerp(m.color_a, m.color_c, 0.7f * middle), m.color_b, spot));
}

TextureValue zebra(const Material& m, const TexturePoint& p) {
    const auto [q, fp] = cell_of(m, p);
    const float bend = fbm2(q * 0.55f, 2, fp, m.seed) * 3.2f,
                fork = fbm2(Vec2f{q.x * 0.8f, q.y * 1.9f}, 2, fp, m.seed + 4) - 0.5f;
    const float v = 2.4f * q.y + bend + 1.2f * fork;
    return print_of(m, p, lerp(m.color_a, m.color_b, drawn((0.25f - off_half(v)) / 2.8f, fp, 0.5f, 0.18f)));
}

TextureValue camouflage(const Material& m, const TexturePoint& p) {
    const auto [q, fp] = cell_of(m, p);
    const float first = fbm2(q * 1.6f, 3, fp, m.seed) - 0.54f,
                second = fbm2(q * 1.9f + Vec2f{17.f, 5.f}, 3, fp, m.seed + 9) - 0.57f, soft = std::max(fp, 0.02f);
    const Vec3f c = lerp(m.color_a, m.color_b, mix(0.37f, edge_cover(first, soft), detail_fade(fp, 0.4f)));
    return print_of(m, p, lerp(c, m.color_c, mix(0.29f, edge_cover(second, soft), detail_fade(fp, 0.4f))));
}

TextureValue paisley(const Material& m, const TexturePoint& p) {
    // Drops with a bent tip, each with a rim and an eye; half drop, alternately rotated.
    const auto [q, fp] = cell_of(m, p);
    float in = -1.f;
    Vec2f eye{1.f, 1.f};
    for (const float half : {0.f, 0.5f}) {
        const Vec2f at = q + Vec2f{half, half};
        const Vec2f o{fraction(at.x) - 0.5f, fraction(at.y) - 0.5f},
            t = spun(half > 0.f ? Vec2f{-o.x, -o.y} : o, 0.45f);
        for (int i = 0; i < 9; ++i) {
            const float s = static_cast<float>(i) / 8.f;
            const float here = 0.155f * std::pow(1.f - s, 0.85f) - length(t - Vec2f{0.11f * s * s, -0.09f + 0.33f * s});
            if (here > in) in = here, eye = t - Vec2f{0.f, -0.09f};
        }
    }
    const float body = drawn(in, fp, 0.256f, 0.2f), rim = drawn(0.012f - std::fabs(in + 0.028f), fp, 0.11f, 0.05f),
                dot = drawn(0.055f - length(eye), fp, 0.019f, 0.1f);
    return print_of(m, p, lerp(lerp(lerp(m.color_a, m.color_b, body), m.color_c, rim), m.color_a, dot));
}

TextureValue encaustic(const Material& m, const TexturePoint& p) {
    // Cement tiles: an eight-petalled flower, with quarter rings in the corners that meet those of the neighbours.
    const auto [q, fp] = cell_of(m, p);
    const int ix = floor_int(q.x), iy = floor_int(q.y);
    const Vec2f o{q.x - static_cast<float>(ix) - 0.5f, q.y - static_cast<float>(iy) - 0.5f},
        fold{std::fabs(o.x), std::fabs(o.y)};
    const float corner = length(Vec2f{0.5f - fold.x, 0.5f - fold.y});
    float petals = -1.f;
    for (int i = 0; i < 8; ++i)
        petals = std::max(petals, petal_inside(spun(o, static_cast<float>(i) * 0.25f * kPi), (i & 1) ? 0.3f : 0.4f,
                                               (i & 1) ? 0.045f : 0.075f));
    const float ring = 0.032f - std::fabs(corner - 0.3f), disc = 0.17f - corner;
    const float first = drawn(std::max(petals, ring), fp, 0.35f, 0.08f),
                second = drawn(std::max(disc, 0.055f - length(o)), fp, 0.1f, 0.1f);
    const float edge = 0.5f - std::max(fold.x, fold.y),
                joint = mix(0.012f, line_cover(edge, 0.004f, std::max(fp, 0.001f)), detail_fade(fp, 0.1f));
    const float shade = lattice_unit(ix, iy, 1, m.seed) - 0.5f;
    TextureValue v;
    v.albedo = lerp(lerp(lerp(m.color_a, m.color_b, first), m.color_c, second) * (1.f + 0.06f * shade),
                    Vec3f{0.42f, 0.4f, 0.37f}, joint);
    v.roughness = mix(m.roughness, 0.85f, joint);
    v.height = 1.f - joint;
    return v;
}

TextureValue laid_tiles(const Material& m, const TexturePoint& p) {
    // Glazed 3 x 1 tiles in a herringbone at 45 degrees; color_b is the grout. Cells as in the parquet
    // (patterns_wood.cc).
    constexpr int n = 3;
    constexpr float kJoint = 0.02f;
    const float r = 0.70710678f / positive(m.scale_m), fp = p.footprint_m / positive(m.scale_m);
    const float x = (p.flat.x + p.flat.y) * r, y = (p.flat.y - p.flat.x) * r;
    const int ix = floor_int(x), iy = floor_int(y), k = ((ix - iy) % (2 * n) + 2 * n) % (2 * n);
    const bool lying = k < n;
    const float along = lying ? static_cast<float>(k) + x - static_cast<float>(ix)
                              : static_cast<float>(2 * n - 1 - k) + y - static_cast<float>(iy);
    const float across = lying ? y - static_cast<float>(iy) : x - static_cast<float>(ix);
    const std::uint32_t id = lying ? lattice_hash(ix - k, iy, 3, m.seed)
                                   : lattice_hash(ix, iy - (2 * n - 1 - k), 4, m.seed);
    const float edge = std::min(std::min(across, 1.f - across), std::min(along, static_cast<float>(n) - along));
    const float joint = mix(2 * kJoint * (1.f + 1.f / n), line_cover(edge, kJoint, std::max(fp, 0.003f)),
                            detail_fade(fp, 0.5f));
    const float shade = static_cast<float>(id & 255) / 255.f - 0.5f;
    TextureValue v;
    v.albedo = lerp(m.color_a * (1.f + 0.16f * shade), m.color_b, joint);
    v.roughness = mix(m.roughness, 0.85f, joint);
    v.height = (1.f - joint) * smooth_step(0.f, 0.08f, edge);
    return v;
}

TextureValue peeling(const Material& m, const TexturePoint& p) {
    // Stained old paint (color_a) that has peeled off in patches: color_b is the plaster below. Patch edges curl up.
    const auto [q, fp] = cell_of(m, p);
    const float broad = fbm2(q, 5, fp, m.seed) - 0.5f, fine = fbm2(q * 6.f, 3, fp * 6.f, m.seed + 5) - 0.5f,
                lost = broad + 0.18f * fine - 0.085f;
    const float bare = mix(0.3f, edge_cover(lost, std::max(fp, 0.006f)), detail_fade(fp, 0.5f)),
                rim = unit_clamp(1.f - std::fabs(lost) / 0.014f) * detail_fade(fp, 0.05f);
    const float stain = smooth_step(0.5f, 0.8f, fbm2(Vec2f{q.x * 1.9f, q.y * 0.45f}, 4, fp, m.seed + 13)),
                grime = fbm2(q * 0.5f, 3, fp, m.seed + 21);
    const Vec3f paint = m.color_a * (1.f - 0.35f * stain) * (0.82f + 0.3f * grime),
                plaster_tone = m.color_b * (0.85f + 0.3f * fine);
    TextureValue v;
    v.albedo = lerp(paint, plaster_tone, bare) * (1.f - 0.35f * rim * (1.f - bare));
    v.roughness = std::max(m.roughness, 0.75f);
    v.height = unit_clamp(0.5f * (1.f - bare) + 0.35f * rim);
    return v;
}

}  // namespace fastscene::patterns

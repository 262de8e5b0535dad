#include "fastscene/trace/patterns.h"

namespace fastscene::patterns {
namespace {

constexpr float kMeanRing = 0.3f, kMeanPores = 0.14f;  // for distant views

// Grain of one board: `along` and `across` the fibres, metres. 0 = early wood, 1 = late wood.
float grain(float across, float along, float footprint, std::uint32_t seed) {
    // A board is cut slightly off the trunk's axis, so the rings appear as long, wavering arches, some wide, some
    // narrow.
    constexpr float kRing_m = 0.012f;
    const float drift = 0.085f * (fbm2({across * 4.f, along * 0.55f}, 3, footprint * 4.f, seed) - 0.5f);
    const float ring = (across + drift + 0.02f * along) / kRing_m;
    const float t = fraction(ring + 1.3f * noise2({ring * 0.22f, along * 0.4f}, seed + 5));
    // Late wood darkens slowly over the year and ends at once.
    const float rings = mix(kMeanRing, t * t * (1.f - smooth_step(0.9f, 1.f, t)), detail_fade(footprint, kRing_m));
    const float streaks = fbm2({across * 75.f, along * 1.3f}, 3, footprint * 75.f, seed + 2);
    const float fibres = fbm2({across * 420.f, along * 14.f}, 2, footprint * 420.f, seed + 9);
    const float broad = fbm2({across * 11.f, along * 1.1f}, 2, footprint * 11.f, seed + 3);
    return unit_clamp(0.42f * rings + 0.34f * streaks + 0.16f * fibres + 0.26f * broad - 0.02f);
}

// Pores: dark strokes a few tenths of a millimetre wide, dense in early wood; seen from close by.
float pores(float across, float along, float footprint, std::uint32_t seed) {
    constexpr float kPitch_m = 0.0011f, kLong_m = 0.012f;
    const float fade = detail_fade(footprint, 2.f * kPitch_m);
    if (!(fade > 0.f)) return kMeanPores;
    const float n = noise2({across / kPitch_m, along / kLong_m}, seed + 13);
    return mix(kMeanPores, smooth_step(0.66f, 0.8f, n), fade);
}

constexpr float kTilt = 0.004f;  // slope of a board against its floor

// One floorboard, with its own tone and its own part of the trunk.
TextureValue board(const Material& m, float across, float along, float footprint, std::uint32_t id) {
    const float tone = static_cast<float>(id & 255) / 255.f, warmth = static_cast<float>((id >> 8) & 255) / 255.f;
    const float g = grain(across + static_cast<float>(id >> 24) * 0.37f,
                          along + static_cast<float>((id >> 16) & 255) * 0.53f, footprint, m.seed + (id & 31));
    TextureValue v;
    const float pore = pores(across, along, footprint, m.seed + (id & 31));
    v.albedo = lerp(m.color_a, m.color_b, unit_clamp(1.35f * (g - 0.3f) + 0.36f * (tone - 0.5f) + 0.12f));
    v.albedo = v.albedo * ((0.9f + 0.2f * warmth) * (1.f - 0.4f * (pore - kMeanPores)));
    v.roughness = m.roughness * (0.82f + 0.5f * g);
    // No two boards lie in quite one plane, which breaks up what they reflect; each is a little hollow.
    const float lie = (static_cast<float>((id >> 4) & 63) / 63.f - 0.5f) * 2.f * kTilt * across,
                end = (static_cast<float>((id >> 10) & 63) / 63.f - 0.5f) * kTilt * along;
    v.height = 1.f - 0.25f * g - 0.3f * pore + (lie + end) / std::max(m.bump_m, 1e-5f);
    return v;
}

// Darkens the gap between boards; `gap` = covered share.
void cut_gap(TextureValue& v, float gap) {
    v.albedo = v.albedo * (1.f - 0.72f * gap);
    v.height -= gap;
    v.roughness = mix(v.roughness, 0.9f, gap);
}

constexpr float kGapHalf = 0.0011f;  // boards touch, except for a bevel of about two millimetres

}  // namespace

TextureValue wood(const Material& m, const TexturePoint& p) {
    // By convention the fibres run along the mesh's longest texture axis, the second flat coordinate.
    return board(m, p.flat.x, p.flat.y, p.footprint_m, lattice_hash(1, 2, 3, m.seed) & 0xffffff7f);
}

TextureValue planks(const Material& m, const TexturePoint& p) {
    const float width = positive(m.scale_m), long_side = width * 9.f;
    const int row = floor_int(p.flat.x / width);
    const float shift = lattice_unit(row, 0, 1, m.seed) * long_side;
    const int column = floor_int((p.flat.y + shift) / long_side);
    const float across = p.flat.x - static_cast<float>(row) * width;
    const float along = p.flat.y + shift - static_cast<float>(column) * long_side;
    TextureValue v = board(m, across, along, p.footprint_m, lattice_hash(row, column, 2, m.seed));
    const float side = std::min(across, width - across), end = std::min(along, long_side - along);
    cut_gap(v, std::max(line_cover(side, kGapHalf, p.footprint_m), line_cover(end, kGapHalf, p.footprint_m)));
    return v;
}

TextureValue herringbone(const Material& m, const TexturePoint& p) {
    // In units of the block's width, rotated by 45 degrees; blocks are n x 1. Row y holds a horizontal block where (x -
    // y) mod 2n < n; the remaining cells form vertical blocks.
    constexpr int n = 5;
    const float width = positive(m.scale_m), r = 0.70710678f / width;
    const float x = (p.flat.x + p.flat.y) * r, y = (p.flat.y - p.flat.x) * r;
    const int ix = floor_int(x), iy = floor_int(y);
    const int k = ((ix - iy) % (2 * n) + 2 * n) % (2 * n);
    const bool lying = k < n;
    const float along = lying ? static_cast<float>(k) + x - static_cast<float>(ix)
                              : static_cast<float>(2 * n - 1 - k) + y - static_cast<float>(iy);
    const float across = lying ? y - static_cast<float>(iy) : x - static_cast<float>(ix);
    const std::uint32_t id = lying ? lattice_hash(ix - k, iy, 3, m.seed)
                                   : lattice_hash(ix, iy - (2 * n - 1 - k), 4, m.seed);
    TextureValue v = board(m, across * width, along * width, p.footprint_m, id);
    const float edge = std::min(std::min(across, 1.f - across), std::min(along, static_cast<float>(n) - along)) * width;
    cut_gap(v, line_cover(edge, kGapHalf * 0.8f, p.footprint_m));
    return v;
}

TextureValue parquet(const Material& m, const TexturePoint& p) {
    constexpr int n = 5;  // strips per square
    const float width = positive(m.scale_m), square = width * n;
    const int ix = floor_int(p.flat.x / square), iy = floor_int(p.flat.y / square);
    float across = p.flat.x - static_cast<float>(ix) * square, along = p.flat.y - static_cast<float>(iy) * square;
    if ((ix + iy) & 1) std::swap(across, along);
    const int strip = std::clamp(floor_int(across / width), 0, n - 1);
    const float local = across - static_cast<float>(strip) * width;
    TextureValue v = board(m, local, along, p.footprint_m, lattice_hash(ix * n + strip, iy, 5, m.seed));
    const float edge = std::min(std::min(local, width - local), std::min(along, square - along));
    cut_gap(v, line_cover(edge, kGapHalf * 0.7f, p.footprint_m));
    return v;
}

TextureValue bark(const Material& m, const TexturePoint& p) {
    const float s = positive(m.scale_m);
    const float angle = std::atan2(p.coords.z, p.coords.x);
    const float ridge = fbm3({angle * 3.f, p.coords.y / s * 0.35f, 0.f}, 4, p.footprint_m / s, m.seed);
    const float t = std::fabs(2.f * ridge - 1.f);
    TextureValue v;
    constexpr float kRidges = 0.43f;  // mean share of ridges, for distant views
    v.albedo = lerp(m.color_b, m.color_a,
                    mix(kRidges, smooth_step(0.02f, 0.4f, t), detail_fade(p.footprint_m, 0.5f * s)));
    v.roughness = m.roughness;
    v.height = t;
    return v;
}

}  // namespace fastscene::patterns

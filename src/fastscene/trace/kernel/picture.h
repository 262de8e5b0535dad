// Pattern::image: a picture and its mip levels.
#ifndef FASTSCENE_TRACE_KERNEL_PICTURE_H
#define FASTSCENE_TRACE_KERNEL_PICTURE_H

#include "fastscene/trace/kernel/material.h"
#include "fastscene/trace/kernel/noise.h"

#ifdef __cplusplus
#include "fastscene/image/color.h"
#endif

KERNEL_BEGIN

// Where the texels are differs between the languages; the rest does not.
#ifdef __cplusplus
static int level_count(const Material& m) { return static_cast<int>(m.image->levels.size()); }
static const ImageRgb8& level_at(const Material& m, int level) {
    return m.image->levels[static_cast<std::size_t>(level)];
}
static int level_width(const Material& m, int level) { return level_at(m, level).width; }
static int level_height(const Material& m, int level) { return level_at(m, level).height; }
static Vec3f texel(const Material& m, int level, int x, int y) {
    return linear_from_srgb8(level_at(m, level).at(x, y));
}
#else
int level_count(Material m) { return int(m.image.at[0]); }
int level_width(Material m, int level) { return int(m.image.at[2 + 3 * level]); }
int level_height(Material m, int level) { return int(m.image.at[3 + 3 * level]); }
float linear_from_srgb(float v) { return v <= 0.04045f ? v / 12.92f : pow((v + 0.055f) / 1.055f, 2.4f); }
vec3 texel(Material m, int level, int x, int y) {
    const vec3 c = unpackUnorm4x8(m.image.at[m.image.at[1 + 3 * level] + y * level_width(m, level) + x]).rgb;
    return vec3(linear_from_srgb(c.r), linear_from_srgb(c.g), linear_from_srgb(c.b));
}
#endif

// Bilinear lookup in one mip level; (u, v) in [0, 1) repeated, v upward.
static Vec3f sampled(IN(Material) m, int level, Vec2f uv) {
    const int width = level_width(m, level), height = level_height(m, level);
    const float x = (uv.x - floor(uv.x)) * float(width) - 0.5f, y = (1.f - (uv.y - floor(uv.y))) * float(height) - 0.5f;
    const int x0 = int(floor(x)), y0 = int(floor(y));
    const float fx = x - float(x0), fy = y - float(y0);
    const int left = wrapped(x0, width), right = wrapped(x0 + 1, width), above = wrapped(y0, height),
              below = wrapped(y0 + 1, height);
    return lerp(lerp(texel(m, level, left, above), texel(m, level, right, above), fx),
                lerp(texel(m, level, left, below), texel(m, level, right, below), fx), fy);
}

TextureValue image(IN(Material) m, IN(TexturePoint) p) {
    // The mip level whose texels are as wide as the sample's footprint.
    const float texel_m = m.scale_m / float(level_width(m, 0));
    const float level = log2(max(p.footprint_m / max(texel_m, 1e-6f), 1.f));
    return texture_value(sampled(m, min(int(level + 0.5f), level_count(m) - 1), p.plane) * m.color_a, m.roughness,
                         0.5f);
}

KERNEL_END

#endif

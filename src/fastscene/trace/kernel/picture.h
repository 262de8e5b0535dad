// Pattern::image and Pattern::screen: pictures and their mip levels, of color, normals, roughness and metal.
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
using Picture = const TextureImage*;
static Picture color_picture(const Material& m) { return m.image.get(); }
static Picture normal_picture(const Material& m) { return m.normals.get(); }
static Picture gloss_picture(const Material& m) { return m.metallic_roughness.get(); }
static bool has_normals(const Material& m) { return m.pattern == Pattern::image && m.normals; }
static bool has_gloss(const Material& m) { return m.metallic_roughness != nullptr; }
static bool shows_picture(const Material& m) { return m.pattern == Pattern::screen && m.image; }
static int level_count(Picture t) { return static_cast<int>(t->levels.size()); }
static const ImageRgb8& level_at(Picture t, int level) { return t->levels[static_cast<std::size_t>(level)]; }
static int level_width(Picture t, int level) { return level_at(t, level).width; }
static int level_height(Picture t, int level) { return level_at(t, level).height; }
static Vec3f linear_texel(Picture t, int level, int x, int y) { return linear_from_srgb8(level_at(t, level).at(x, y)); }
static Vec3f plain_texel(Picture t, int level, int x, int y) {
    const Rgb8 c = level_at(t, level).at(x, y);
    return Vec3f{static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b)} * (1.f / 255);
}
#else
#define Picture TextureWords
Picture color_picture(Material m) { return m.image; }
Picture normal_picture(Material m) { return m.normals; }
Picture gloss_picture(Material m) { return m.metallic_roughness; }
bool has_normals(Material m) { return (m.maps & kHasNormals) != 0; }
bool has_gloss(Material m) { return (m.maps & kHasMetallicRoughness) != 0; }
bool shows_picture(Material m) { return (m.maps & kShowsPicture) != 0; }
int level_count(Picture t) { return int(t.at[0]); }
int level_width(Picture t, int level) { return int(t.at[2 + 3 * level]); }
int level_height(Picture t, int level) { return int(t.at[3 + 3 * level]); }
float linear_from_srgb(float v) { return v <= 0.04045f ? v / 12.92f : pow((v + 0.055f) / 1.055f, 2.4f); }
vec3 plain_texel(Picture t, int level, int x, int y) {
    return unpackUnorm4x8(t.at[t.at[1 + 3 * level] + y * level_width(t, level) + x]).rgb;
}
vec3 linear_texel(Picture t, int level, int x, int y) {
    const vec3 c = plain_texel(t, level, x, y);
    return vec3(linear_from_srgb(c.r), linear_from_srgb(c.g), linear_from_srgb(c.b));
}
#endif

// The mip level whose texels are as wide as the sample's footprint.
static int level_for(Picture t, IN(Material) m, float footprint_m) {
    const float texel_m = m.scale_m / float(level_width(t, 0));
    const float level = log2(max(footprint_m / max(texel_m, 1e-6f), 1.f));
    return min(int(level + 0.5f), level_count(t) - 1);
}

// The four texels of a bilinear lookup in one mip level, and their weights; (u, v) in [0, 1) repeated, v upward.
struct Texels {
    int left, right, above, below;
    float fx, fy;
};
static Texels texels_at(Picture t, int level, Vec2f uv) {
    const int width = level_width(t, level), height = level_height(t, level);
    const float x = (uv.x - floor(uv.x)) * float(width) - 0.5f, y = (1.f - (uv.y - floor(uv.y))) * float(height) - 0.5f;
    const int x0 = int(floor(x)), y0 = int(floor(y));
    Texels q;
    q.left = wrapped(x0, width), q.right = wrapped(x0 + 1, width);
    q.above = wrapped(y0, height), q.below = wrapped(y0 + 1, height);
    q.fx = x - float(x0), q.fy = y - float(y0);
    return q;
}
static Vec3f sampled_color(Picture t, int level, Vec2f uv) {
    const Texels q = texels_at(t, level, uv);
    return lerp(lerp(linear_texel(t, level, q.left, q.above), linear_texel(t, level, q.right, q.above), q.fx),
                lerp(linear_texel(t, level, q.left, q.below), linear_texel(t, level, q.right, q.below), q.fx), q.fy);
}
static Vec3f sampled_data(Picture t, int level, Vec2f uv) {
    const Texels q = texels_at(t, level, uv);
    return lerp(lerp(plain_texel(t, level, q.left, q.above), plain_texel(t, level, q.right, q.above), q.fx),
                lerp(plain_texel(t, level, q.left, q.below), plain_texel(t, level, q.right, q.below), q.fx), q.fy);
}

TextureValue image(IN(Material) m, IN(TexturePoint) p) {
    Picture colors = color_picture(m);
    TextureValue v = texture_value(sampled_color(colors, level_for(colors, m, p.footprint_m), p.plane) * m.color_a,
                                   m.roughness, 0.5f);
    if (has_gloss(m)) {
        Picture gloss = gloss_picture(m);
        const Vec3f factors = sampled_data(gloss, level_for(gloss, m, p.footprint_m), p.plane);
        v.roughness = m.roughness * factors.y;
        v.metal = factors.z;
    }
    return v;
}

// A screen: what it shows is light, its glass has one color.
TextureValue screen(IN(Material) m, IN(TexturePoint) p) {
    TextureValue v = texture_value(m.color_a, m.roughness, 1.f);
    if (shows_picture(m)) {
        Picture colors = color_picture(m);
        v.shown = sampled_color(colors, level_for(colors, m, p.footprint_m), p.plane);
    }
    return v;
}

// Radiance over the whole surface on average: what sampled light and bounced light have of it.
Vec3f mean_emission(IN(Material) m) {
    if (!shows_picture(m)) return m.emission;
    Picture colors = color_picture(m);
    return m.emission * linear_texel(colors, level_count(colors) - 1, 0, 0);
}

// Slope of the relief along u and v that a normal map stands for.
Vec2f normal_map_slope(IN(Material) m, IN(TexturePoint) p) {
    if (!has_normals(m)) return vec2(0, 0);
    Picture t = normal_picture(m);
    const Vec3f n = sampled_data(t, level_for(t, m, p.footprint_m), p.plane) * 2.f - vec3(1, 1, 1);
    const float up = max(n.z, 0.1f);
    return vec2(-n.x / up, -n.y / up);
}

KERNEL_END

#endif

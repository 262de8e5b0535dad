// What the rays of a pixel found, while a picture is made (picture.cc).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/trace/shade.h"
#include "fastscene/trace/trace.h"

namespace fastscene {

inline constexpr float kNoisy = 0.03f;  // relative standard error of a pixel's light above which it needs more rays
inline constexpr int kLeastRound =
    3;  // minimum rays before the variance estimate is used; with fewer, noise could pass for an exact value

// Standard error of the running mean. Stratification makes the true error smaller.
class MeanError {
  public:
    MeanError() = default;
    MeanError(float count, float sum, float squares) : count_(count), sum_(sum), squares_(squares) {}
    void add(float v) {
        ++count_;
        sum_ += v;
        squares_ += v * v;
    }
    float mean() const { return sum_ / count_; }
    float variance() const { return std::max(0.f, squares_ / count_ - mean() * mean()) / count_; }
    // In sRGB-encoded values, as perceived and as PSNR measures: the encoding's slope is roughly that of a square root.
    float of_srgb_mean() const { return std::sqrt(variance()) * 0.5f / std::sqrt(std::max(0.003f, mean())); }

  private:
    float count_ = 0, sum_ = 0, squares_ = 0;
};

inline float ratio(float a, float b) { return b > 1e-6f ? a / b : 0.f; }
inline Vec3f ratio(Vec3f a, Vec3f b) { return {ratio(a.x, b.x), ratio(a.y, b.y), ratio(a.z, b.z)}; }

// One light component of a pixel: the light that arrives, separate from the surface color it is multiplied by.
struct LightSum {
    Vec3f seen{};
    MeanError arriving;
    void add(Vec3f radiance, float through) {
        seen += radiance;
        arriving.add(ratio(luminance(radiance), through));
    }
};

// Whether another hit is on a different surface: off this one's plane, or facing elsewhere. The sky is a surface of its
// own.
inline bool another_surface(Vec3f position, Vec3f normal, Vec3f other, Vec3f other_normal) {
    const bool outside = dot(normal, normal) < 0.5f, there = dot(other_normal, other_normal) < 0.5f;
    if (outside || there) return outside != there;
    const Vec3f to = other - position;
    const float off = dot(to, normal);
    return !(dot(other_normal, normal) > 0.9f && off * off < 0.04f * dot(to, to) + 1e-6f);
}

// What some of a pixel's rays found on one surface, that of the first of them.
struct SurfaceSum {
    int count = 0;
    Vec3f color{}, radiance{}, diffuse{}, specular{}, position{}, normal{};
    std::array<LightSum, 3> lights;  // diffuse, sun, specular
    MeanError texture;

    bool shows(Vec3f there, Vec3f its_normal) const { return !another_surface(position, normal, there, its_normal); }
    bool takes(const Shaded& s) const { return count == 0 || shows(s.position, s.normal); }
    void add(const Shaded& s, Vec3f developed) {
        if (count++ == 0) position = s.position, normal = s.normal;
        color += developed;
        radiance += s.radiance;
        diffuse += s.diffuse;
        specular += s.specular;
        lights[0].add(s.light, luminance(s.diffuse));
        lights[1].add(s.sun, luminance(s.diffuse));
        lights[2].add(s.mirrored, luminance(s.specular));
        texture.add(luminance(s.diffuse + s.specular));
    }
    Vec3f through(std::size_t k) const { return (k < 2 ? diffuse : specular) / static_cast<float>(count); }
    Vec3f light(std::size_t k) const { return ratio(lights[k].seen, k < 2 ? diffuse : specular); }
    // Whether the light is noisy, not just the texture it falls on.
    bool noisy(float tolerated) const {
        float error = 0, level = 0;
        for (std::size_t k = 0; k < lights.size(); ++k) {
            const float by = luminance(through(k));
            error += lights[k].arriving.variance() * by * by;
            level += luminance(lights[k].seen) / static_cast<float>(count);
        }
        return error > tolerated * tolerated * level * level;
    }
};

// Everything that a pixel's rays returned. The surface hit by the first ray, and the first different one (at an
// outline), are kept apart from the rest, since their light can be compared with that of neighbours.
struct PixelSum {
    int taken = 0;
    SurfaceSum own, second;
    Vec3f rest_color{}, all_albedo{};
    MeanError shown;
    // Further rays that met each, which only measure how much of the pixel it covers: with few rays, thin joints and
    // outlines would be dashed lines.
    int met_own = 0, met_second = 0, met_rest = 0;

    void add(const Shaded& s, Vec3f developed) {
        ++taken;
        all_albedo += s.albedo;
        shown.add(luminance(developed));
        if (own.takes(s)) own.add(s, developed);
        else if (second.takes(s)) second.add(s, developed);
        else rest_color += developed;
    }
    // Of a pixel with several surfaces. A surface that no shaded ray has met has no color, and does not count.
    void cover(Vec3f position, Vec3f normal) {
        if (own.shows(position, normal)) ++met_own;
        else if (second.count > 0 && second.shows(position, normal)) ++met_second;
        else if (rest() > 0) ++met_rest;
    }
    bool mixed() const { return own.count < taken; }
    int rest() const { return taken - own.count - second.count; }
    float own_share() const { return share(own.count + met_own); }
    float second_share() const { return share(second.count + met_second); }
    Vec3f rest_part() const {
        return rest() > 0 ? rest_color * (share(rest() + met_rest) / static_cast<float>(rest())) : Vec3f{};
    }
    Vec3f color() const {
        Vec3f sum = own.color * (own_share() / static_cast<float>(own.count)) + rest_part();
        if (second.count > 0) sum += second.color * (second_share() / static_cast<float>(second.count));
        return sum;
    }
    Vec3f albedo() const { return all_albedo / static_cast<float>(taken); }

  private:
    float share(int met) const {
        return static_cast<float>(met) / static_cast<float>(taken + met_own + met_second + met_rest);
    }
};

// Whether a pixel needs another round of rays. When denoising, an even texture needs a few more, an outline some, and
// most go to pixels whose light itself is noisy, as in soft shadows: from too few rays the denoiser makes ragged edges.
inline bool needs_more(const PixelSum& pixel, const ShotParts& parts, int samples) {
    if (pixel.taken >= samples) return false;
    const float error = pixel.shown.of_srgb_mean();
    if (!parts.denoise) return error > parts.noise;
    if (!(error > parts.noise)) return false;
    if (pixel.own.noisy(kNoisy)) return pixel.taken < samples / 2;
    if (pixel.mixed()) return pixel.taken < samples / 4 || (pixel.taken < samples / 2 && error > 2 * parts.noise);
    return pixel.taken < samples / 4 && pixel.own.texture.of_srgb_mean() > parts.noise;
}

}  // namespace fastscene

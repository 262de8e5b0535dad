#include "fastscene/trace/picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "fastscene/base/parallel.h"
#include "fastscene/base/random.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/trace/denoise.h"
#include "fastscene/trace/film.h"

namespace fastscene {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

// How well the mean of the samples so far is known. Strata make the true error smaller.
class MeanError {
  public:
    void add(float v) {
        ++count_;
        sum_ += v;
        squares_ += v * v;
    }
    float mean() const { return sum_ / count_; }
    float variance() const { return std::max(0.f, squares_ / count_ - mean() * mean()) / count_; }
    // In sRGB-encoded values, what the eye and PSNR see: the slope of the encoding is about half a power.
    float of_srgb_mean() const { return std::sqrt(variance()) * 0.5f / std::sqrt(std::max(0.003f, mean())); }

  private:
    float count_ = 0, sum_ = 0, squares_ = 0;
};

float ratio(float a, float b) { return b > 1e-6f ? a / b : 0.f; }
Vec3f ratio(Vec3f a, Vec3f b) { return {ratio(a.x, b.x), ratio(a.y, b.y), ratio(a.z, b.z)}; }

// The light of one kind in a pixel: what arrives, apart from the color it is seen through.
struct LightSum {
    Vec3f seen{};
    MeanError arriving;
    void add(Vec3f radiance, float through) {
        seen += radiance;
        arriving.add(ratio(luminance(radiance), through));
    }
};

// Everything that the rays of a pixel brought back.
struct PixelSum {
    int taken = 0;
    Vec3f color{}, radiance{}, albedo{}, diffuse{}, shine{}, position{}, normal{};
    std::array<LightSum, 3> lights;   // diffuse, sun, mirrored
    MeanError shown, texture;
    bool mixed = false;               // more than one surface

    void add(const Shaded& s, Vec3f developed) {
        if (taken == 0) position = s.position, normal = s.normal;
        // Off the first ray's plane, or turned away from it: another surface.
        const Vec3f to = s.position - position;
        const float off = dot(to, normal);
        mixed |= !(dot(s.normal, normal) > 0.9f) || off * off > 0.04f * dot(to, to) + 1e-6f;
        ++taken;
        color += developed;
        radiance += s.radiance;
        albedo += s.albedo;
        diffuse += s.diffuse;
        shine += s.shine;
        lights[0].add(s.light, luminance(s.diffuse));
        lights[1].add(s.sun, luminance(s.diffuse));
        lights[2].add(s.mirrored, luminance(s.shine));
        shown.add(luminance(developed));
        texture.add(luminance(s.diffuse + s.shine));
    }
    // Whether light itself is noisy, not only what it falls on.
    bool noisy(float tolerated) const {
        float error = 0, level = 0;
        for (std::size_t k = 0; k < lights.size(); ++k) {
            const float through = luminance(k < 2 ? diffuse : shine) / static_cast<float>(taken);
            error += lights[k].arriving.variance() * through * through;
            level += luminance(lights[k].seen) / static_cast<float>(taken);
        }
        return error > tolerated * tolerated * level * level;
    }
};

// What is kept of all pixels until their noise is averaged.
struct NoisyPicture {
    ImageColor radiance, diffuse, shine;
    std::array<NoisyLight, 3> lights;
    Guides guides;

    explicit NoisyPicture(const Eye& eye) {
        const ImageColor black(eye.width, eye.height);
        radiance = diffuse = shine = guides.position = guides.normal = black;
        for (NoisyLight& light : lights) light = {black, ImageF(eye.width, eye.height)};
        guides.wraps = eye.panorama;
        for (int y = 0; y < eye.height; ++y) {
            const float latitude = (0.5f - (static_cast<float>(y) + 0.5f) / static_cast<float>(eye.height)) * kPi;
            guides.column_step.push_back(eye.panorama ? std::clamp(static_cast<int>(std::lround(1 / std::cos(latitude))), 1, 8) : 1);
        }
    }
    void set(int x, int y, const PixelSum& p) {
        const float share = 1 / static_cast<float>(p.taken);
        radiance.at(x, y) = p.radiance * share;
        diffuse.at(x, y) = p.diffuse * share;
        shine.at(x, y) = p.shine * share;
        for (std::size_t k = 0; k < lights.size(); ++k) {
            lights[k].value.at(x, y) = ratio(p.lights[k].seen, k < 2 ? p.diffuse : p.shine);
            lights[k].variance.at(x, y) = p.lights[k].arriving.variance();
        }
        guides.position.at(x, y) = p.position;
        guides.normal.at(x, y) = p.mixed ? Vec3f{} : p.normal;
    }
    // What averaging changes of each light goes through the pixel's own color and curve: the picture's detail stays as sampled.
    void denoise_into(ImageColor& color, const Look* look) {
        constexpr std::array<int, 3> kLevels{4, 2, 3};
        ImageColor change(color.width, color.height);
        for (std::size_t k = 0; k < lights.size(); ++k) {
            const ImageColor before = lights[k].value;
            denoise(lights[k], guides, kLevels[k]);
            const ImageColor& through = k < 2 ? diffuse : shine;
            for (std::size_t i = 0; i < before.size(); ++i) change.pixels[i] += through.pixels[i] * (lights[k].value.pixels[i] - before.pixels[i]);
            lights[k] = {};
        }
        parallel_for(color.height, 16, [&](std::int64_t begin, std::int64_t end) {
            for (auto y = static_cast<int>(begin); y < end; ++y)
                for (int x = 0; x < color.width; ++x) {
                    const Vec3f was = radiance.at(x, y), is = was + change.at(x, y);
                    if (change.at(x, y) == Vec3f{}) continue;
                    Vec3f& out = color.at(x, y);
                    if (look) out += develop(*look, is) - develop(*look, was);
                    else out = is;
                    for (std::size_t a = 0; a < 3; ++a) out[a] = std::max(0.f, look ? std::min(1.f, out[a]) : out[a]);
                }
        });
    }
};

// Whether a pixel needs another round of rays. With a denoiser to come only outlines and textures do, and a few more where light is noisy.
bool needs_more(const PixelSum& pixel, const ShotParts& parts, int samples) {
    if (pixel.taken >= samples) return false;
    if (!parts.denoise) return pixel.shown.of_srgb_mean() > parts.noise;
    if (pixel.taken < samples / 4 && pixel.noisy(0.02f)) return true;
    if (pixel.taken >= samples / 2) return false;
    return (pixel.mixed || pixel.texture.of_srgb_mean() > parts.noise) && pixel.shown.of_srgb_mean() > parts.noise;
}

}  // namespace

Eye panorama_eye(const Rigid& world_from_pano, EquirectSize size) {
    return {world_from_pano, size.width, size.height, [size](Vec2f p) { return direction_at(p, size); }, kPi / static_cast<float>(size.height), true};
}
Eye perspective_eye(const Rigid& world_from_camera, const Pinhole& camera) {
    return {world_from_camera, camera.width, camera.height, [camera](Vec2f p) { return camera.direction_at(p); }, 1.f / camera.fx};
}
Vec3f world_direction(const Eye& eye, Vec2f pixel) { return normalize(eye.world_from_camera.rotation * eye.direction(pixel)); }

ImageColor cached_picture(const ShadeScene& scene, const Eye& eye, const ShotParts& parts, int samples, const Look* look, ImageColor* albedo, const Run& run) {
    const int round = parts.denoise ? std::max(1, samples / 8) : parts.noise > 0 ? std::min(16, samples) : samples;
    ImageColor out(eye.width, eye.height);
    if (albedo) *albedo = out;
    std::optional<NoisyPicture> noisy;
    if (parts.denoise) noisy.emplace(eye);
    Progress progress(run, "picture", eye.height);
    parallel_for(eye.height, 4, [&](std::int64_t begin, std::int64_t end) {
        run.check_stop();
        for (auto y = static_cast<int>(begin); y < end; ++y)
            for (int x = 0; x < eye.width; ++x) {
                const std::uint64_t key = mix64(run.seed ^ 0x9a7e1ull) ^ (static_cast<std::uint64_t>(y) << 32 | static_cast<std::uint64_t>(x));
                PixelSum pixel;
                do {
                    for (int s = 0; s < round; ++s) {
                        Sampler sampler(key, static_cast<std::uint32_t>(pixel.taken));
                        const Vec2f offset = sampler.next2();
                        const Vec3f direction = world_direction(eye, {static_cast<float>(x) + offset.x, static_cast<float>(y) + offset.y});
                        const Shaded shaded = shade_ray(scene, eye.world_from_camera.translation, direction, eye.pixel_angle, sampler);
                        // Samples are developed before they are averaged: edges against a bright window stay smooth.
                        pixel.add(shaded, look ? develop(*look, shaded.radiance) : shaded.radiance);
                    }
                } while (needs_more(pixel, parts, samples));
                const auto taken = static_cast<float>(pixel.taken);
                out.at(x, y) = pixel.color / taken;
                if (albedo) albedo->at(x, y) = pixel.albedo / taken;
                if (noisy) noisy->set(x, y, pixel);
            }
        progress.advance(end - begin);
    });
    if (noisy) noisy->denoise_into(out, look);
    return out;
}

ImageColor path_traced_picture(const PathScene& scene, const Eye& eye, int samples, const Look* look, const Run& run) {
    ImageColor out(eye.width, eye.height);
    Progress progress(run, "paths", eye.height);
    parallel_for(eye.height, 1, [&](std::int64_t begin, std::int64_t end) {
        run.check_stop();
        for (auto y = static_cast<int>(begin); y < end; ++y)
            for (int x = 0; x < eye.width; ++x) {
                const std::uint64_t key = mix64(run.seed ^ 0x70a7ull) ^ (static_cast<std::uint64_t>(y) << 32 | static_cast<std::uint64_t>(x));
                Vec3f sum{};
                for (int s = 0; s < samples; ++s) {
                    Sampler sampler(key, static_cast<std::uint32_t>(s));
                    const Vec2f offset = sampler.next2();
                    const Vec3f direction = world_direction(eye, {static_cast<float>(x) + offset.x, static_cast<float>(y) + offset.y});
                    sum += path_radiance(scene, eye.world_from_camera.translation, direction, eye.pixel_angle, sampler);
                }
                const Vec3f mean = sum / static_cast<float>(samples);
                out.at(x, y) = look ? develop(*look, mean) : mean;
            }
        progress.advance(end - begin);
    });
    return out;
}

}  // namespace fastscene

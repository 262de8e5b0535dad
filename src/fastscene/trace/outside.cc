#include "fastscene/trace/outside.h"

#include <algorithm>
#include <cmath>

#include "fastscene/trace/noise.h"
#include "fastscene/trace/outside_rows.h"

namespace fastscene {
namespace {

using namespace outside;

// Height of the skyline above the horizon, in [0, 1], by azimuth: periodic noise.
float outline(float azimuth, float frequency, std::uint32_t seed) {
    return fbm2({std::cos(azimuth) * frequency + 7.3f, std::sin(azimuth) * frequency + 2.9f}, 5, 0.f, seed);
}

// Sharp crests: ridged noise, folded at its mean.
float crests(float azimuth, float frequency, std::uint32_t seed) {
    float sum = 0, amplitude = 0.5f;
    for (std::uint32_t k = 0; k < 5; ++k, frequency *= 2.1f, amplitude *= 0.48f)
        sum += amplitude *
               (1 - std::abs(2 * noise2({std::cos(azimuth) * frequency + 11.f, std::sin(azimuth) * frequency + 5.f},
                                        seed + k) -
                             1));
    return sum;
}

Vec3f hills(const Light& light, float azimuth, float height, Vec3f color, const Sky& sky) {
    const Vec3f green = sky.snow ? Vec3f{0.55f, 0.58f, 0.62f} : Vec3f{0.09f, 0.115f, 0.06f};
    for (int k = 0; k < 2; ++k) {
        const float top = (k ? -0.01f : 0.02f) +
                          (k ? 0.06f : 0.085f) *
                              outline(azimuth, k ? 2.7f : 1.6f, sky.seed + static_cast<std::uint32_t>(k) * 9);
        if (height < top) color = light.far_off(green * (light.shade + light.sun * 0.45f), k ? 0.45f : 0.68f);
    }
    return color;
}

Vec3f mountains(const Light& light, float azimuth, float height, Vec3f color, const Sky& sky) {
    for (int k = 0; k < 2; ++k) {
        const std::uint32_t seed = sky.seed + 40 + static_cast<std::uint32_t>(k);
        const float scale = k ? 0.2f : 0.34f, frequency = k ? 1.9f : 1.3f,
                    top = scale * crests(azimuth, frequency, seed) - (k ? 0.05f : 0.06f);
        if (height >= top) continue;
        // Slopes that face the sun are bright.
        const float slope = (scale * crests(azimuth + 0.012f, frequency, seed) - 0.06f - top) / 0.012f;
        const float faces = 0.5f -
                            0.5f * std::tanh(1.5f * slope) * (std::sin(azimuth - light.azimuth) > 0 ? -1.f : 1.f);
        const float rough = fbm2({azimuth * 26.f, height * 34.f}, 4, 0.f, seed + 5);
        const float white = smooth_step(0.05f, 0.12f, height + 0.16f * (rough - 0.5f)) * (k && !sky.snow ? 0.f : 1.f);
        const Vec3f rock = lerp(lerp(Vec3f{0.1f, 0.105f, 0.08f}, Vec3f{0.2f, 0.185f, 0.17f}, rough),
                                Vec3f{0.75f, 0.77f, 0.8f}, white);
        color = light.far_off(rock * (light.shade + light.sun * (0.75f * faces * (0.6f + 0.8f * rough))),
                              k ? 0.3f : 0.5f);
    }
    return color;
}

// Water, with a beach in front.
Vec3f sea(const Light& light, Vec3f direction, float azimuth, Vec3f color, const Sky& sky, float eye_height_m) {
    const float down = direction.y;
    if (!(down > 0.f)) return color;
    const float far = eye_height_m / std::max(1e-3f, down);
    const float wave = noise2({azimuth * 40.f, std::log(far) * 26.f}, sky.seed + 3) * 0.6f +
                       noise2({azimuth * 150.f, std::log(far) * 70.f}, sky.seed + 4) * 0.4f;
    // Fresnel: at grazing angles water reflects, at steeper ones it shows its own color.
    const float mirror = std::clamp(0.15f + 0.85f * std::pow(1 - std::min(1.f, down * 2.2f), 4.f), 0.f, 1.f);
    const Vec3f mirrored = lerp(sky.horizon, sky.zenith, 0.35f + 0.5f * wave) * 0.62f;
    const Vec3f own = Vec3f{0.02f, 0.085f, 0.11f} * (light.shade + light.sun * 0.6f) * (0.8f + 0.4f * wave);
    color = lerp(own, mirrored, mirror * (0.55f + 0.3f * wave));
    const float towards = std::max(0.f, std::cos(azimuth - light.azimuth));
    color += light.sun * (0.9f * std::pow(towards, 60.f) * smooth_step(0.68f, 0.8f, wave));
    const float beach = 34.f + 6.f * noise2({azimuth * 3.f, 0.f}, sky.seed + 8);
    if (far > beach) return light.far_off(color, 0.25f * smooth_step(80, 900, far));
    const float foam = smooth_step(beach - 3.f, beach - 0.5f, far + 1.5f * noise2({azimuth * 30.f, 1.f}, sky.seed + 9));
    const float sand = 0.85f + 0.3f * noise2({azimuth * 60.f, far * 3.f}, sky.seed + 10);
    return lerp(sky.ground * Vec3f{1.f, 0.92f, 0.76f} * sand, (light.shade + light.sun * 0.6f) * 0.55f, foam);
}

// Garden layout in metres from the house: end of the terrace, distances of the beds, and the share of azimuth that beds
// cover.
constexpr float kTerrace = 4.3f, kNearBed = 5.3f, kMiddleBed = 12.f, kFarBed = 22.5f, kNearShare = 0.5f,
                kMiddleShare = 0.4f, kFarShare = 1.f;

// Plan of a garden: paths that lead away from the terrace, and flower beds between them.
struct Garden {
    explicit Garden(const Sky& sky) : seed(sky.seed) {
        for (int k = 0; k < kPaths; ++k)
            paths[k] = (static_cast<float>(k) + 0.7f * lattice_unit(k, 0, 21, seed)) *
                       (2 * kPi / static_cast<float>(kPaths));
    }
    // Metres to the center line of the nearest path.
    float off_path(Vec2f p) const {
        float least = 1e9f;
        for (const float turn : paths) {
            const float s = std::sin(turn), c = std::cos(turn), along = p.x * s + p.y * c, aside = p.x * c - p.y * s;
            if (along > 0)
                least = std::min(least, std::abs(aside + 0.09f * (along - kTerrace) * std::sin(0.35f * along + turn)));
        }
        return least;
    }
    // How far inside a bed an azimuth lies at this distance, as noise above its threshold; <= 0: outside.
    float within_bed(float azimuth, float distance, float share) const {
        const float free = off_path(Vec2f{std::sin(azimuth), std::cos(azimuth)} * distance) - 1.1f;
        return std::min(0.15f * free,
                        outline(azimuth, 3.4f, seed + static_cast<std::uint32_t>(distance)) - 0.66f + 0.36f * share);
    }
    static constexpr int kPaths = 5;
    std::uint32_t seed;
    float paths[kPaths];
};

// A paved terrace, then lawn; gravel paths and beds of dark earth where there is a garden.
Vec3f garden_floor(const Sky& sky, Vec3f direction, float eye_height_m, const Garden* garden = nullptr) {
    const float far = eye_height_m / std::max(1e-3f, direction.y);
    const Vec2f p{direction.x * far, direction.z * far};
    const float reach = std::hypot(p.x, p.y);
    const float footprint = 0.004f * far;
    if (sky.snow)
        return lerp(sky.ground * 2.4f, sky.horizon, 0.15f) *
               (0.9f + 0.16f * fbm2(p * 0.5f, 4, footprint, sky.seed + 3));
    const float mottle = fbm2(p * 1.2f, 5, footprint * 1.2f, sky.seed + 3),
                blade = fbm2(p * 14.f, 3, footprint * 14.f, sky.seed + 4);
    const Vec3f lawn = sky.ground * lerp(Vec3f{0.32f, 0.44f, 0.16f}, Vec3f{0.5f, 0.55f, 0.24f}, mottle) *
                       (0.55f + 0.7f * blade);
    const float terrace = garden ? kTerrace : 5.5f;
    if (reach > terrace + 0.1f) {
        if (!garden) return lawn;
        const float azimuth = std::atan2(p.x, p.y), ragged = 0.3f * noise2(p * 1.5f, sky.seed + 5);
        const float gravel = 1 - smooth_step(0.55f, 0.62f + 0.02f * reach, garden->off_path(p) + 0.1f * ragged);
        const auto is_earth = [&](float distance, float share, float half) {
            const float within = garden->within_bed(azimuth, distance, share);
            return within > 0 && std::abs(reach - distance) < half * std::min(1.f, 12.f * within) + 0.5f * ragged;
        };
        const bool earth = is_earth(kNearBed, kNearShare, 0.45f) || is_earth(kMiddleBed, kMiddleShare, 0.8f);
        const Vec3f ground = earth ? sky.ground * Vec3f{0.3f, 0.22f, 0.16f} * (0.7f + 0.6f * blade) : lawn;
        return lerp(ground, sky.ground * Vec3f{1.2f, 1.08f, 0.9f} * (0.8f + 0.4f * blade), gravel);
    }
    const Vec2f slab{p.x / 0.8f, p.y / 0.8f};
    const float joint = std::min({slab.x - std::floor(slab.x), slab.y - std::floor(slab.y)});
    const float tone = 0.92f + 0.16f * lattice_unit(floor_int(slab.x), floor_int(slab.y), 2, sky.seed) -
                       (joint < 0.03f ? 0.3f : 0.f);
    const Vec3f paving = sky.ground * Vec3f{1.15f, 1.1f, 1.02f} * tone;
    return lerp(paving, lawn, smooth_step(terrace - 0.1f, terrace + 0.1f, reach));
}

// A road between pavements, along the front of the house.
Vec3f street_floor(const Sky& sky, const Light& light, Vec3f direction, float eye_height_m) {
    const float far = eye_height_m / std::max(1e-3f, direction.y);
    const Vec2f p{direction.x * far, direction.z * far};
    const float reach = std::hypot(p.x, p.y), grain = 0.9f + 0.2f * fbm2(p * 2.f, 4, 0.008f * far, sky.seed + 3);
    const bool road = reach > 8.f && reach < 20.f;
    const float angle = std::atan2(p.x, p.y);
    const bool stripe = road && std::abs(reach - 14.f) < 0.12f && std::fmod(std::abs(angle) * 14.f, 4.f) < 2.2f;
    const Vec3f tone = sky.snow && !road ? Vec3f{2.f, 2.f, 2.1f}
                       : stripe          ? Vec3f{1.6f, 1.6f, 1.5f}
                       : road            ? Vec3f{0.42f, 0.43f, 0.46f}
                                         : Vec3f{0.95f, 0.93f, 0.9f};
    return sky.ground * tone * grain + light.street * (tone * 0.12f);
}

}  // namespace

Vec3f outside_radiance(const Sky& sky, Vec3f direction, Vec3f color) {
    const float azimuth = std::atan2(direction.x, direction.z), height = std::asin(std::clamp(-direction.y, -1.f, 1.f));
    const Light light(sky);
    const bool below = height < 0.f;
    const std::uint32_t s = sky.seed;
    switch (sky.view) {
        case Sky::View::garden: {
            constexpr float kEye = 2.1f;
            color = hills(light, azimuth, height, color, sky);
            const Garden garden(sky);
            const auto planted = [&](float distance, float share) {
                return [=, &garden](float at) { return garden.within_bed(at, distance, share) > 0; };
            };
            if (below)
                color = light.far_off(garden_floor(sky, direction, kEye, &garden),
                                      0.3f * smooth_step(15, 80, kEye / direction.y));
            buildings(light, {26, 75.f, 4.5f, 7.5f, kEye, 0.62f, true, 0.25f, s + 1}, azimuth, height, color);
            trees(light, {40, 46.f, 3.4f, kEye, 0.3f, false, sky.snow, 0.14f, s + 2}, azimuth, height, color);
            hedge(light, 24.f, 1.35f, kEye, sky.snow, s + 4, azimuth, height, color);
            beds(light, {130, kFarBed, 0.8f, 0.8f, kEye, 0.15f, 0.03f, s + 5}, azimuth, height,
                 planted(kFarBed, kFarShare), color);
            trees(light, {15, 19.f, 2.3f, kEye, 0.6f, false, sky.snow, 0.03f, s + 3}, azimuth, height, color);
            beds(light, {90, kMiddleBed, 0.6f, 0.62f, kEye, 0.1f, 0.01f, s + 6}, azimuth, height,
                 planted(kMiddleBed, kMiddleShare), color);
            beds(light, {74, kNearBed, 0.36f, 0.4f, kEye, 0.06f, 0.f, s + 7}, azimuth, height,
                 planted(kNearBed, kNearShare), color);
            return color;
        }
        case Sky::View::city: {
            constexpr float kEye = 11.f;
            if (below) color = street_floor(sky, light, direction, kEye);
            buildings(light, {70, 420.f, 40.f, 130.f, kEye, 0.35f, false, 0.55f, s + 1}, azimuth, height, color);
            buildings(light, {44, 130.f, 18.f, 46.f, kEye, 0.12f, false, 0.3f, s + 2}, azimuth, height, color);
            buildings(light, {17, 30.f, 8.f, 15.f, kEye, 0.1f, true, 0.06f, s + 3}, azimuth, height, color);
            trees(light, {22, 22.f, 2.2f, kEye, 0.45f, false, sky.snow, 0.03f, s + 4}, azimuth, height, color);
            return color;
        }
        case Sky::View::sea: {
            constexpr float kEye = 7.f;
            color = sea(light, direction, azimuth, color, sky, kEye);
            const float cape = -0.002f + 0.05f * smooth_step(0.52f, 0.75f, outline(azimuth, 1.1f, s + 6)) *
                                             outline(azimuth, 6.f, s + 7);
            if (height < cape && height > -0.006f)
                color = light.far_off(Vec3f{0.12f, 0.13f, 0.09f} * (light.shade + light.sun * 0.4f), 0.5f);
            trees(light, {16, 20.f, 1.9f, kEye, 0.72f, false, sky.snow, 0.02f, s + 3}, azimuth, height, color);
            return color;
        }
        case Sky::View::mountains: {
            constexpr float kEye = 5.f;
            color = mountains(light, azimuth, height, color, sky);
            if (below)
                color = light.far_off(garden_floor(sky, direction, kEye),
                                      0.35f * smooth_step(25, 200, kEye / direction.y));
            trees(light, {90, 130.f, 4.f, kEye, 0.2f, true, sky.snow, 0.2f, s + 2}, azimuth, height, color);
            trees(light, {26, 42.f, 3.f, kEye, 0.5f, true, sky.snow, 0.06f, s + 3}, azimuth, height, color);
            return color;
        }
        case Sky::View::forest: {
            constexpr float kEye = 2.3f;
            if (below) color = garden_floor(sky, direction, kEye) * Vec3f{0.75f, 0.72f, 0.7f};
            trees(light, {70, 60.f, 4.6f, kEye, 0.f, true, sky.snow, 0.3f, s + 2}, azimuth, height, color);
            trees(light, {46, 34.f, 3.6f, kEye, 0.15f, false, sky.snow, 0.14f, s + 3}, azimuth, height, color);
            trees(light, {20, 17.f, 2.8f, kEye, 0.3f, true, sky.snow, 0.03f, s + 4}, azimuth, height, color);
            return color;
        }
    }
    return color;
}

}  // namespace fastscene

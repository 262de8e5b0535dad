#include "fastscene/trace/sky.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fastscene/trace/noise.h"

namespace fastscene {
namespace {

// Height of an outline over the horizon, in radians, at an azimuth: noise that closes after a full turn.
float outline(float azimuth, float frequency, std::uint32_t seed) {
    const Vec2f on_circle{std::cos(azimuth) * frequency, std::sin(azimuth) * frequency};
    return fbm2(on_circle, 4, 0.f, seed);
}

// Houses: a step function of the azimuth.
float skyline(float azimuth, std::uint32_t seed, std::uint32_t& house) {
    const float position = azimuth * 18.f;
    const int block = floor_int(position);
    house = lattice_hash(block, 3, 1, seed);
    const float gap = lattice_unit(block, 5, 2, seed);
    return gap < 0.25f ? 0.f : 0.03f + 0.085f * lattice_unit(block, 1, 9, seed);
}

Vec3f clouds_over(const Sky& sky, Vec3f direction, Vec3f color) {
    const float up = -direction.y;
    if (!(up > 0.02f) || !(sky.clouds > 0.f)) return color;
    // A flat layer of clouds, thinner towards the horizon where it is far.
    const Vec2f plane{direction.x / (up + 0.15f), direction.z / (up + 0.15f)};
    const float density = fbm2(plane * 1.7f, 5, 0.02f, sky.seed + 11);
    const float cover = smooth_step(0.75f - 0.5f * sky.clouds, 1.02f - 0.4f * sky.clouds, density) * smooth_step(0.02f, 0.2f, up);
    const float white = 0.75f * luminance(sky.horizon) + 0.5f * luminance(sky.zenith);
    return lerp(color, Vec3f{white, white, white} * 1.05f, 0.75f * cover);
}

}  // namespace

Vec3f sky_radiance(const Sky& sky, Vec3f direction) {
    const float up = -direction.y, azimuth = std::atan2(direction.x, direction.z), height = std::asin(std::clamp(up, -1.f, 1.f));
    const bool night = sky.time == Sky::Time::night, dusk = sky.time == Sky::Time::dusk;
    Vec3f color = up >= 0.f ? lerp(sky.horizon, sky.zenith, std::pow(std::min(1.f, up), 0.45f)) : sky.ground;
    color = clouds_over(sky, direction, color);
    // A glow around the sun, or where it went down.
    const float towards = std::max(0.f, dot(direction, sky.sun_dir));
    if (!night && up > -0.05f) color += sky.horizon * (0.35f * std::pow(towards, 24.f));
    if (night && up > 0.05f && sky.clouds < 0.8f) {
        const Vec2f grid{azimuth * 160.f, height * 160.f};
        const float star = lattice_unit(floor_int(grid.x), floor_int(grid.y), 4, sky.seed);
        if (star > 0.993f) color += Vec3f{0.25f, 0.26f, 0.3f};
    }

    // From far to near: hills, houses, trees. Air between makes the far ones paler.
    const float hills = 0.02f + 0.075f * outline(azimuth, 1.6f, sky.seed);
    if (height < hills) color = lerp(Vec3f{0.16f, 0.21f, 0.17f} * luminance(sky.horizon), sky.horizon * 0.75f, night ? 0.1f : 0.5f);
    std::uint32_t house = 0;
    const float roof = skyline(azimuth, sky.seed, house);
    if (height < roof) {
        const float tone = 0.28f + 0.25f * static_cast<float>(house & 255) / 255.f;
        color = Vec3f{tone * 1.05f, tone, tone * 0.92f} * (0.5f * luminance(sky.horizon));
        const int column = floor_int(azimuth * 18.f * 7.f), row = floor_int(height * 90.f);
        const float fx = azimuth * 126.f - static_cast<float>(column), fy = height * 90.f - static_cast<float>(row);
        const bool pane = fx > 0.25f && fx < 0.75f && fy > 0.3f && fy < 0.8f && height > 0.005f;
        const float lit = lattice_unit(column, row, 8, sky.seed);
        if (pane && (night || dusk) && lit > 0.62f) color = Vec3f{1.1f, 0.75f, 0.38f} * (night ? 0.5f : 0.7f);
        else if (pane) color = color * 0.62f;
    }
    const float trees = -0.03f + 0.16f * outline(azimuth, 5.5f, sky.seed + 31) * smooth_step(0.35f, 0.62f, outline(azimuth, 1.3f, sky.seed + 57));
    if (height < trees) {
        const float leaves = 0.55f + 0.75f * noise2({azimuth * 90.f, height * 110.f}, sky.seed + 5);
        color = Vec3f{0.075f, 0.12f, 0.05f} * (leaves * luminance(sky.horizon) * 1.25f);
    }
    if (up < 0.f && height < trees - 0.02f) {
        const float lawn = 0.85f + 0.3f * noise2({direction.x / -up * 3.f, direction.z / -up * 3.f}, sky.seed + 3);
        color = sky.ground * Vec3f{0.85f, 1.05f, 0.65f} * lawn;
    }
    return color;
}

}  // namespace fastscene

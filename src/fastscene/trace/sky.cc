#include "fastscene/trace/sky.h"

#include <algorithm>
#include <cmath>

#include "fastscene/base/parallel.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/trace/noise.h"
#include "fastscene/trace/outside.h"

namespace fastscene {
namespace {

Vec3f clouds_over(const Sky& sky, Vec3f direction, Vec3f color) {
    const float up = -direction.y;
    if (!(up > 0.02f) || !(sky.clouds > 0.f)) return color;
    // A flat cloud layer, thinner towards the horizon.
    const Vec2f plane{direction.x / (up + 0.15f), direction.z / (up + 0.15f)};
    const float density = fbm2(plane * 1.7f, 5, 0.02f, sky.seed + 11);
    const float cover = smooth_step(0.7f - 0.45f * sky.clouds, 0.95f - 0.4f * sky.clouds, density) *
                        smooth_step(0.02f, 0.2f, up);
    // Clouds towards the sun shadow this one.
    const Vec2f sunward{sky.sun_dir.x, sky.sun_dir.z};
    const float shadow = unit_clamp(2.2f * (fbm2((plane + sunward * 0.22f) * 1.7f, 4, 0.04f, sky.seed + 11) - 0.45f));
    const float white = (0.85f * luminance(sky.horizon) + 0.5f * luminance(sky.zenith)) * (1.1f - 0.42f * shadow);
    return lerp(color, Vec3f{white, white, white * 1.02f}, 0.85f * cover);
}

}  // namespace

Vec3f sky_radiance(const Sky& sky, Vec3f direction) {
    const float up = -direction.y, azimuth = std::atan2(direction.x, direction.z),
                height = std::asin(std::clamp(up, -1.f, 1.f));
    const bool night = sky.time == Sky::Time::night;
    Vec3f color = up >= 0.f ? lerp(sky.horizon, sky.zenith, std::pow(std::min(1.f, up), 0.45f)) : sky.ground;
    color = clouds_over(sky, direction, color);
    // A glow around the sun, or around where it set.
    const float towards = std::max(0.f, dot(direction, sky.sun_dir));
    if (!night && up > -0.05f) color += sky.horizon * (0.35f * std::pow(towards, 24.f));
    if (night && up > 0.05f && sky.clouds < 0.8f) {
        const Vec2f grid{azimuth * 160.f, height * 160.f};
        const float star = lattice_unit(floor_int(grid.x), floor_int(grid.y), 4, sky.seed);
        if (star > 0.993f) color += Vec3f{0.25f, 0.26f, 0.3f};
    }

    return outside_radiance(sky, direction, color);
}

namespace {

constexpr EquirectSize kTable{512, 256};

}  // namespace

SkyTable::SkyTable(const Sky& sky) : radiance_(kTable.width, kTable.height) {
    parallel_for(kTable.height, 8, [&](std::int64_t begin, std::int64_t end) {
        for (auto y = static_cast<int>(begin); y < end; ++y)
            for (int x = 0; x < kTable.width; ++x) {
                // Jittered within the pixel, since the outlines at the horizon follow pixel rows.
                const Vec2f p{static_cast<float>(x) + lattice_unit(x, y, 0, sky.seed),
                              static_cast<float>(y) + lattice_unit(x, y, 1, sky.seed)};
                radiance_.at(x, y) = sky_radiance(sky, direction_at(p, kTable));
            }
    });
}

Vec3f SkyTable::at(Vec3f direction) const {
    const Vec2f p = pixel_of_direction(direction, kTable);
    return radiance_.at(std::clamp(static_cast<int>(p.x), 0, kTable.width - 1),
                        std::clamp(static_cast<int>(p.y), 0, kTable.height - 1));
}

}  // namespace fastscene

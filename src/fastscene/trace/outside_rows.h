// Rows of scenery around the house: buildings, trees, a hedge. Private to trace/outside*.cc.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>

#include "fastscene/scene/room.h"

namespace fastscene::outside {

// Illumination outside, as the radiance of a white wall.
struct Light {
    Vec3f shade;   // from the sky
    Vec3f sun;     // from the sun on a surface that faces it
    Vec3f street;  // from street lamps, after sunset
    Vec3f haze;    // aerial perspective: the color of distant air
    Vec3f to_sun;
    float azimuth = 0, haziness = 1;
    bool dark = false, snow = false;

    explicit Light(const Sky& sky) {
        shade = lerp(sky.zenith, sky.horizon, 0.6f) * 0.5f;
        sun = sky.sun_irradiance * (1.f / 3.14159265f);
        dark = sky.time == Sky::Time::night || sky.time == Sky::Time::dusk;
        if (dark) street = Vec3f{0.5f, 0.34f, 0.18f} * (sky.time == Sky::Time::night ? 0.012f : 0.05f);
        haze = sky.horizon * 0.62f;
        haziness = sky.clouds > 0.9f ? 1.2f : 0.75f;
        to_sun = sky.sun_dir;
        azimuth = std::atan2(sky.sun_dir.x, sky.sun_dir.z);
        snow = sky.snow;
    }
    Vec3f far_off(Vec3f color, float share) const { return lerp(color, haze, std::min(0.9f, share * haziness)); }
    // Sun on a surface with normal `n` at azimuth `at`. `n` is relative to the viewer: x right, y up, z towards the
    // viewer.
    float sunlit(Vec3f n, float at) const {
        const float c = std::cos(at), s = std::sin(at);
        const Vec3f world{n.x * c - n.z * s, -n.y, -n.x * s - n.z * c};
        return std::max(0.f, dot(world, to_sun));
    }
};

struct Row {
    int cells;  // in 360 degrees
    float distance_m;
    float low_m, high_m;  // heights of the eaves above the ground
    float eye_height_m;   // height of the viewer above the ground
    float gap;            // share of cells that stay empty
    bool pitched;         // pitched roofs
    float haze;
    std::uint32_t seed;
};
void buildings(const Light& light, const Row& row, float azimuth, float height, Vec3f& color);

struct TreeRow {
    int cells;
    float distance_m;
    float radius_m;  // of a crown
    float eye_height_m;
    float gap;
    bool conifers;
    bool snow;
    float haze;
    std::uint32_t seed;
};
void trees(const Light& light, const TreeRow& row, float azimuth, float height, Vec3f& color);

void hedge(const Light& light, float distance_m, float high_m, float eye_height_m, bool snow, std::uint32_t seed,
           float azimuth, float height, Vec3f& color);

// Clumps of leaves and flowers along a bed; `planted` tells whether an azimuth is planted.
struct BedRow {
    int cells;  // in 360 degrees
    float distance_m;
    float radius_m, high_m;  // of a clump
    float eye_height_m;
    float bloom_m;  // size of a flower, or of a bunch of them in distant rows
    float haze;
    std::uint32_t seed;
};
void beds(const Light& light, const BedRow& row, float azimuth, float height, const std::function<bool(float)>& planted,
          Vec3f& color);

}  // namespace fastscene::outside

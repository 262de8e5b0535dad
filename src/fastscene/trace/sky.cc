#include "fastscene/trace/sky.h"

#include <algorithm>
#include <cmath>

#include "fastscene/trace/noise.h"

namespace fastscene {
namespace {

// The atmosphere of clear days. Scattering coefficients at sea level per metre, scale heights in metres.
constexpr Vec3f kRayleigh{5.8e-6f, 13.5e-6f, 33.1e-6f};
constexpr float kMie = 5e-6f, kMieForward = 0.74f, kRayleighHeight = 8000, kMieHeight = 1200, kEarth = 6.36e6f,
                kTop = 6.0e4f;

float way_to_top(Vec3f from, Vec3f direction) {
    const float b = dot(from, direction), outer = kEarth + kTop;
    return -b + std::sqrt(std::max(0.f, b * b - dot(from, from) + outer * outer));
}
struct Depth {
    float rayleigh = 0, mie = 0;
};
Depth optical_depth(Vec3f from, Vec3f direction) {
    constexpr int kSteps = 8;
    const float step = way_to_top(from, direction) / kSteps;
    Depth sum;
    for (int k = 0; k < kSteps; ++k) {
        const float height = std::max(0.f, length(from + direction * (step * (static_cast<float>(k) + 0.5f))) - kEarth);
        sum.rayleigh += step * std::exp(-height / kRayleighHeight), sum.mie += step * std::exp(-height / kMieHeight);
    }
    return sum;
}
Vec3f transmittance(Depth d) {
    const Vec3f tau = kRayleigh * d.rayleigh + Vec3f{1, 1, 1} * (1.1f * kMie * d.mie);
    return {std::exp(-tau.x), std::exp(-tau.y), std::exp(-tau.z)};
}

// Single scattering along a ray from the ground; frame: y up.
Vec3f scattered(Vec3f direction, Vec3f to_sun) {
    constexpr int kSteps = 14;
    const Vec3f eye{0, kEarth + 100, 0};
    const float far = way_to_top(eye, direction);
    Depth before;
    Vec3f rayleigh{}, mie{};
    float near = 0;
    for (int k = 0; k < kSteps; ++k) {
        // Steps grow with distance: the lowest air is the densest.
        const float u = static_cast<float>(k + 1) / kSteps, next = far * u * u, step = next - near;
        const Vec3f at = eye + direction * (0.5f * (near + next));
        near = next;
        const float height = std::max(0.f, length(at) - kEarth);
        const Depth here{step * std::exp(-height / kRayleighHeight), step * std::exp(-height / kMieHeight)};
        const Depth sun = optical_depth(at, to_sun);
        const Vec3f arriving = transmittance(
            {before.rayleigh + 0.5f * here.rayleigh + sun.rayleigh, before.mie + 0.5f * here.mie + sun.mie});
        before.rayleigh += here.rayleigh, before.mie += here.mie;
        rayleigh += arriving * here.rayleigh, mie += arriving * here.mie;
    }
    const float c = dot(direction, to_sun), g = kMieForward;
    const float phase_rayleigh = 0.75f * (1 + c * c), phase_mie = (1 - g * g) / std::pow(1 + g * g - 2 * g * c, 1.5f);
    return kRayleigh * rayleigh * phase_rayleigh + mie * (kMie * phase_mie);
}

}  // namespace

SkyDome::SkyDome(const Sky& sky) : sky_(sky) {
    for (auto& row : course_) row.fill({1, 1, 1});
    const Vec3f up_sun{sky.sun_dir.x, std::max(0.03f, -sky.sun_dir.y), sky.sun_dir.z};
    sunward_ = normalize(Vec3f{sky.sun_dir.x, 0, sky.sun_dir.z});
    if (sky.time == Sky::Time::night || sky.clouds > 0.9f || !(dot(sunward_, sunward_) > 0)) return;
    const float level = std::hypot(up_sun.x, up_sun.z);
    const Vec3f to_sun = normalize(Vec3f{0, up_sun.y, level});
    for (int j = 0; j <= kUp; ++j) {
        const float up = static_cast<float>(j) / kUp, out = std::sqrt(std::max(0.f, 1 - up * up));
        auto& row = course_[static_cast<std::size_t>(j)];
        Vec3f mean{};
        for (int i = 0; i <= kAround; ++i) {
            const float turn = kPi * static_cast<float>(i) / kAround;
            const Vec3f light = scattered(normalize(Vec3f{out * std::sin(turn), up + 0.01f, out * std::cos(turn)}),
                                          to_sun);
            row[static_cast<std::size_t>(i)] = light;
            mean += light * ((i == 0 || i == kAround ? 0.5f : 1.f) / kAround);
        }
        // Light scattered more than once evens this out.
        constexpr float kOnce = 0.55f, kMost = 2.6f;
        Vec3f mean_after{};
        for (std::size_t i = 0; i < row.size(); ++i) {
            for (std::size_t a = 0; a < 3; ++a)
                row[i][a] = 1 - kOnce + kOnce * std::min(kMost, row[i][a] / std::max(1e-12f, mean[a]));
            mean_after += row[i] * ((i == 0 || i == row.size() - 1 ? 0.5f : 1.f) / kAround);
        }
        for (Vec3f& c : row)
            for (std::size_t a = 0; a < 3; ++a) c[a] /= mean_after[a];
    }
}

Vec3f SkyDome::air(Vec3f direction) const {
    const float up = std::clamp(-direction.y, 0.f, 1.f);
    const Vec3f even = lerp(sky_.horizon, sky_.zenith, std::pow(up, 0.45f));
    const float level = std::hypot(direction.x, direction.z);
    const float cosine = level > 1e-5f ? (direction.x * sunward_.x + direction.z * sunward_.z) / level : 1.f;
    const float u = std::acos(std::clamp(cosine, -1.f, 1.f)) / kPi * kAround, v = up * kUp;
    const auto i = static_cast<std::size_t>(std::min(kAround - 1.f, u)),
               j = static_cast<std::size_t>(std::min(kUp - 1.f, v));
    const float a = u - static_cast<float>(i), b = v - static_cast<float>(j);
    return even * lerp(lerp(course_[j][i], course_[j][i + 1], a), lerp(course_[j + 1][i], course_[j + 1][i + 1], a), b);
}

// A flat layer of cumulus, seen thinner towards the horizon; overcast: gray folds.
Vec3f SkyDome::clouded(Vec3f direction, Vec3f behind) const {
    const float up = -direction.y;
    if (!(up > 0.015f) || !(sky_.clouds > 0.f)) return behind;
    const std::uint32_t seed = sky_.seed + 11;
    const Vec2f plane{direction.x / (up + 0.12f), direction.z / (up + 0.12f)};
    const float footprint = 0.006f / (up + 0.12f);
    if (sky_.clouds > 0.9f) {
        const Vec2f p = plane * 0.9f;
        const Vec2f warp{fbm2(p + Vec2f{5, 1}, 3, footprint, seed + 5), fbm2(p + Vec2f{2, 8}, 3, footprint, seed + 6)};
        const float fold = fbm2(p + warp * 1.1f, 6, footprint, seed);
        return behind * mix(1.f, 0.72f + 0.56f * fold, smooth_step(0.02f, 0.25f, up));
    }
    const auto density = [&](Vec2f p) {
        const Vec2f q = p * 1.25f;
        const Vec2f warp{noise2(q * 2.f, seed + 7) - 0.5f, noise2(q * 2.f + Vec2f{9, 4}, seed + 8) - 0.5f};
        const float broad = fbm2(q + warp * 0.35f, 7, footprint, seed);
        return broad - (0.66f - 0.3f * sky_.clouds);
    };
    const float here = density(plane);
    if (!(here > 0)) return behind;
    const float thick = std::min(1.f, here * 6.f), cover = (1 - std::exp(-9.f * here)) * smooth_step(0.015f, 0.16f, up);
    // What lies between here and the sun darkens it; thin edges towards the sun shine.
    const Vec2f sunward{sky_.sun_dir.x, sky_.sun_dir.z};
    float between = 0;
    for (const float far : {0.05f, 0.13f, 0.26f}) between += std::max(0.f, density(plane + sunward * far));
    const float lit = std::exp(-3.2f * between), towards = std::max(0.f, dot(direction, sky_.sun_dir));
    const float shine = std::pow(towards, 12.f) * (1 - thick);
    const Vec3f white = Vec3f{1, 1, 1} * (0.85f * luminance(sky_.horizon) + 0.5f * luminance(sky_.zenith));
    const Vec3f shaded = lerp(sky_.horizon, sky_.zenith, 0.5f) * 0.72f;
    // The low sun colors the clouds.
    const float sun = luminance(sky_.sun_irradiance);
    const Vec3f hue = sun > 0 ? lerp(Vec3f{1, 1, 1}, sky_.sun_irradiance / sun, 0.8f) : Vec3f{1, 1, 1};
    return lerp(behind, lerp(shaded, white * hue * (1.02f + 0.5f * shine), 0.3f + 0.7f * lit) * (1.05f - 0.2f * thick),
                0.9f * cover);
}

Vec3f SkyDome::at(Vec3f direction) const {
    const float up = -direction.y;
    Vec3f color = air(direction);
    if (sky_.time == Sky::Time::night && up > 0.05f && sky_.clouds < 0.8f) {
        const Vec2f grid{std::atan2(direction.x, direction.z) * 560.f, std::asin(std::clamp(up, -1.f, 1.f)) * 560.f};
        if (lattice_unit(floor_int(grid.x), floor_int(grid.y), 4, sky_.seed) > 0.9988f)
            color += Vec3f{0.1f, 0.104f, 0.12f};
    }
    return clouded(direction, color);
}

}  // namespace fastscene

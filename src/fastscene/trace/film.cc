#include "fastscene/trace/film.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fastscene/geometry/sphere.h"

namespace fastscene {
namespace {

// A shoulder that never quite reaches white: straight at first, then 1 - exp.
float shoulder(float x) {
    constexpr float kStraight = 0.45f;
    return x < kStraight ? x : kStraight + (1 - kStraight) * (1 - std::exp(-(x - kStraight) / (1 - kStraight)));
}

// A gentle S about middle gray, in the encoding the eye judges by.
float contrast_curve(float v, float contrast) {
    const float e = std::sqrt(std::max(0.f, v));  // close to sRGB's encoding
    constexpr float kPivot = 0.46f;
    const float s =
        e < kPivot ? kPivot * std::pow(e / kPivot, contrast) : 1 - (1 - kPivot) * std::pow((1 - std::min(1.f, e)) / (1 - kPivot), contrast);
    return s * s;
}

}  // namespace

Look automatic_look(const Look& wish, const Sky& sky, const ImageColor& panorama) {
    if (!wish.automatic) return wish;
    struct Weighted {
        float value, weight;
    };
    std::vector<Weighted> logs;
    Vec3f mean{};
    float weights = 0;
    for (int y = 0; y < panorama.height; ++y) {
        const auto w = static_cast<float>(pixel_solid_angle(y, {panorama.width, panorama.height}));
        for (int x = 0; x < panorama.width; ++x) {
            const Vec3f c = panorama.at(x, y);
            logs.push_back({std::log2(std::max(1e-5f, luminance(c))), w});
            const float l = std::max(1e-5f, luminance(c));
            mean += c * (w / l);  // hue only: a bright window does not decide
            weights += w;
        }
    }
    std::stable_sort(logs.begin(), logs.end(), [](const Weighted& a, const Weighted& b) { return a.value < b.value; });
    // The darkest and the brightest tenth say little about the room.
    float sum = 0, used = 0, passed = 0;
    for (const Weighted& l : logs) {
        passed += l.weight;
        if (passed < 0.1f * weights || passed > 0.9f * weights) continue;
        sum += l.value * l.weight;
        used += l.weight;
    }
    const float average = used > 0 ? sum / used : 0.f;
    Look look = wish;
    look.automatic = false;
    // Rooms are mostly bright walls: their mean belongs above middle gray. Night and dusk stay darker than day.
    const float key = sky.time == Sky::Time::night ? 0.15f : sky.time == Sky::Time::dusk ? 0.20f : 0.35f;
    look.exposure_ev = wish.exposure_ev + std::log2(key) - average;
    // White is pulled most of the way towards gray by day, less where warm light is the point.
    const float pull = sky.time == Sky::Time::day || sky.time == Sky::Time::morning ? 0.55f : 0.5f;
    const Vec3f tint = mean / std::max(1e-6f, luminance(mean));
    for (std::size_t a = 0; a < 3; ++a) look.white[a] = std::pow(std::clamp(tint[a], 0.4f, 2.5f), pull) / wish.white[a];
    const float l = luminance(look.white);
    look.white = look.white / l;
    look.contrast = wish.contrast * 1.12f;
    look.saturation = wish.saturation * 1.08f;
    return look;
}

Vec3f develop(const Look& look, Vec3f radiance) {
    const float gain = std::exp2(look.exposure_ev);
    Vec3f c{radiance.x * gain / look.white.x, radiance.y * gain / look.white.y, radiance.z * gain / look.white.z};
    // Half per channel (bright colors wash out to white, as film does), half by luminance (hues stay).
    const float l = luminance(c);
    const Vec3f kept = l > 0 ? c * (shoulder(l) / l) : c;
    c = {shoulder(c.x), shoulder(c.y), shoulder(c.z)};
    c = c * 0.7f + kept * 0.3f;
    const float gray = luminance(c);
    for (std::size_t a = 0; a < 3; ++a) c[a] = std::clamp(contrast_curve(gray + (c[a] - gray) * look.saturation, look.contrast), 0.f, 1.f);
    return c;
}

}  // namespace fastscene

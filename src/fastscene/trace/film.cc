#include "fastscene/trace/film.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fastscene/geometry/sphere.h"
#include "fastscene/trace/kernel/film.h"
#include "fastscene/trace/noise.h"

namespace fastscene {
namespace {

// A photograph's tone curve: over log2 of scene light, display values (gamma-encoded) rise as a straight line around
// middle gray, with a toe into black and a shoulder into white (the shape of AgX and of film's density curves).
class FilmCurve {
  public:
    FilmCurve(ViewTransform transform, float contrast)
        : linear_(transform == ViewTransform::linear),
          slope_((transform == ViewTransform::soft ? kSoftSlope : kSlope) * contrast) {}
    float slope() const { return linear_ ? 0 : slope_; }
    float operator()(float x) const {
        if (!(x > 0)) return 0;
        if (linear_) return std::min(1.f, x);
        const float up = slope_ * std::log2(x / kMiddle);
        const float value = up > 0 ? kMiddleShown + bent(up, 1 - kMiddleShown, kShoulder)
                                   : kMiddleShown - bent(-up, kMiddleShown, kToe);
        return std::pow(std::clamp(value, 0.f, 1.f), kGamma);
    }

  private:
    static constexpr float kMiddle = 0.18f, kGamma = 2.2f;
    static constexpr float kMiddleShown = 0.4587f;  // 0.18^(1 / 2.2): middle gray stays
    static constexpr float kSlope = 0.205f;         // display value a stop, at middle gray; a plain display has 0.145
    static constexpr float kSoftSlope = 0.15f;
    static constexpr float kToe = 2.f, kShoulder = 2.6f;
    // A line of slope 1 that bends towards `limit`; the larger `power`, the later.
    static float bent(float v, float limit, float power) {
        return v / std::pow(1 + std::pow(v / limit, power), 1 / power);
    }
    bool linear_;
    float slope_;
};

// The luminance to which an average surface is exposed; 0.18 is middle gray. By day pictures are then about as bright
// as photographs of rooms, whose mean display value is 0.5 (0.36 to 0.61 in 38 panoramas); a higher key washes out
// walls and sun patches.
constexpr float kDayKey = 0.22f, kFireKey = 0.2f, kDuskKey = 0.22f, kNightKey = 0.19f;

struct Weighted {
    float value, weight;
};
// Trimmed mean: the lowest and highest tenth are dropped as outliers.
float middle_mean(std::vector<Weighted>& values) {
    std::stable_sort(values.begin(), values.end(),
                     [](const Weighted& a, const Weighted& b) { return a.value < b.value; });
    float weights = 0, sum = 0, used = 0, passed = 0;
    for (const Weighted& v : values) weights += v.weight;
    for (const Weighted& v : values) {
        passed += v.weight;
        if (passed < 0.1f * weights || passed > 0.9f * weights) continue;
        sum += v.value * v.weight;
        used += v.weight;
    }
    return used > 0 ? sum / used : 0.f;
}

}  // namespace

Look automatic_look(const Look& wish, const Sky& sky, const ImageColor& panorama, const ImageColor& albedo,
                    std::optional<float> outside) {
    if (!wish.automatic) return wish;
    constexpr float kLeast = 1e-5f,
                    kLeastAlbedo = 0.02f;  // darker surfaces say nothing about the illumination: sky, lamps, mirrors
    std::vector<Weighted> seen, arriving;  // log2 of luminance
    Vec3f hue{};
    for (int y = 0; y < panorama.height; ++y) {
        const auto w = static_cast<float>(pixel_solid_angle(y, {panorama.width, panorama.height}));
        for (int x = 0; x < panorama.width; ++x) {
            Vec3f c = panorama.at(x, y);
            seen.push_back({std::log2(std::max(kLeast, luminance(c))), w});
            if (albedo.size() > 0) {
                const Vec3f a = albedo.at(x, y);
                if (std::min({a.x, a.y, a.z}) < kLeastAlbedo) continue;
                c = {c.x / a.x, c.y / a.y, c.z / a.z};
                arriving.push_back({std::log2(std::max(kLeast, luminance(c))), w});
            }
            // chromaticity only, so that a bright window does not dominate
            hue += c * (w / std::max(kLeast, luminance(c)));
        }
    }
    Look look = wish;
    look.automatic = false;
    // Night and dusk stay darker than day. Like an incident light meter, exposure follows the light that falls on
    // things more than the light they reflect.
    const bool night = sky.time == Sky::Time::night, dusk = sky.time == Sky::Time::dusk;
    // So do rooms that only a fire lights: bright as day, they look like an overexposed photograph. The light of flames
    // has 8 times as much red as blue; that of lamps at most 4 times.
    constexpr float kLamps = 2.f, kFire = 3.f;  // log2 of red over blue
    const float fire = smooth_step(kLamps, kFire, std::log2(std::max(kLeast, hue.x) / std::max(kLeast, hue.z)));
    const float key = night ? kNightKey : dusk ? kDuskKey : std::lerp(kDayKey, kFireKey, fire);
    float ev = std::log2(key) - middle_mean(seen);
    constexpr float kUsualAlbedo = 0.46f, kByLight = 0.65f;
    if (!arriving.empty()) ev = std::lerp(ev, std::log2(key / kUsualAlbedo) - middle_mean(arriving), kByLight);
    look.exposure_ev = wish.exposure_ev + ev;
    // White balance moves most of the way towards the illuminant, along the Planckian locus from candlelight to blue
    // sky. A deviation from that locus (a neon sign, pink walls lighting each other) is not something that eyes adapt
    // to, and stays.
    const float pull = night || dusk ? 0.6f : 0.88f;
    constexpr float kLineRed = 0.62f, kLineBlue = -0.785f,
                    kOffLine = 0.25f;  // log2(blue or red) per log2(green), for thermal light about 4000 K
    const auto octaves = [&](float c) {
        return std::clamp(std::log2(std::max(kLeast, c) / std::max(kLeast, hue.y)), -1.4f, 1.4f);
    };
    const float red = octaves(hue.x), blue = octaves(hue.z), on_line = red * kLineRed + blue * kLineBlue;
    look.white = {std::exp2(pull * std::lerp(on_line * kLineRed, red, kOffLine)) / wish.white.x, 1 / wish.white.y,
                  std::exp2(pull * std::lerp(on_line * kLineBlue, blue, kOffLine)) / wish.white.z};
    const float l = luminance(look.white);
    look.white = look.white / l;
    // Sun patches on dim walls can be a hundred times brighter than the rest; no tone curve holds both, and they would
    // burn out to white. All direct sun is therefore scaled by one factor for the whole room, so patches keep textures,
    // hues and edges.
    if (sky.sun_limit > 0) {
        constexpr float kSunDoubling = 0.12f;
        look.sun_seen = kernel::restrained(
            luminance(sky.sun_irradiance) * std::exp2(look.exposure_ev) / (kPi * sky.sun_limit), kSunDoubling);
    }
    // A bright room gets a short exposure, which would leave the sunny garden outside as dark as dusk: the outside is
    // lifted as a whole.
    constexpr float kMostLift = 7.f;        // sky.seen = 0.13 times that: nearly all of the light
    constexpr float kShadeOfGround = 0.5f;  // a view with trees and their shade may be darker than open ground
    const float level = outside ? *outside : luminance(sky.ground),
                least = sky.ground_least * (outside ? kShadeOfGround : 1.f);
    look.outside_seen = std::clamp(least / std::max(1e-4f, level * sky.seen * std::exp2(look.exposure_ev)), 1.f,
                                   kMostLift);
    // A room with few lamps gets a long exposure, which would turn the night outside into day: the outside is dimmed.
    constexpr float kNightMost = 0.09f, kDuskMost = 0.28f;  // of the sky at the horizon, 1 = white by the room's light
    if (night || dusk)
        look.outside_seen = std::min(
            1.f, (night ? kNightMost : kDuskMost) /
                     std::max(1e-6f, luminance(sky.horizon) * sky.seen * std::exp2(look.exposure_ev)));
    look.contrast = wish.contrast;
    look.saturation = wish.saturation;
    return look;
}

Vec3f outside_as_seen(const Sky& sky, const Look& look, Vec3f radiance) {
    return kernel::outside_as_seen(sky.seen, look.outside_seen, radiance);
}

Vec3f lamp_as_seen(const Look& look, Vec3f emission) { return kernel::lamp_as_seen(look.exposure_ev, emission); }

float film_slope(const Look& look) { return FilmCurve(look.transform, look.contrast).slope(); }

Vec3f develop(const Look& look, Vec3f radiance) {
    const float gain = std::exp2(look.exposure_ev);
    Vec3f c{radiance.x * gain / look.white.x, radiance.y * gain / look.white.y, radiance.z * gain / look.white.z};
    // Mostly per channel, so that bright colors desaturate as on film; partly by luminance, which keeps hues.
    const FilmCurve curve(look.transform, look.contrast);
    const float l = luminance(c);
    const Vec3f kept = l > 0 ? c * (curve(l) / l) : c;
    for (std::size_t a = 0; a < 3; ++a) c[a] = 0.65f * curve(c[a]) + 0.35f * kept[a];
    const float gray = luminance(c);
    for (std::size_t a = 0; a < 3; ++a) c[a] = std::clamp(gray + (c[a] - gray) * look.saturation, 0.f, 1.f);
    return c;
}

}  // namespace fastscene

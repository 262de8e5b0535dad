#include "fastscene/rooms/daylight.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/pack.h"
#include "fastscene/rooms/room_type.h"
#include "fastscene/rooms/user_model.h"

namespace fastscene {
namespace {

struct Daylight {
    const char* name;
    Sky::Time time;
    float sun_elevation_deg;
    Vec3f sun, zenith, horizon,
        ground;  // irradiance on a surface facing the sun; radiances. White paper in the shade is about 1.
};
constexpr Daylight kDaylight[] = {
    {"morning",
     Sky::Time::morning,
     20,
     {8.5f, 6.6f, 4.6f},
     {0.9f, 1.35f, 2.2f},
     {2.7f, 2.5f, 2.2f},
     {0.50f, 0.46f, 0.38f}},
    {"day", Sky::Time::day, 38, {11.f, 10.1f, 8.8f}, {1.1f, 1.8f, 3.1f}, {3.0f, 3.3f, 3.7f}, {0.75f, 0.70f, 0.58f}},
    {"evening",
     Sky::Time::evening,
     11,
     {8.f, 4.7f, 2.4f},
     {0.6f, 0.8f, 1.4f},
     {2.6f, 1.7f, 1.0f},
     {0.35f, 0.27f, 0.20f}},
    {"dusk", Sky::Time::dusk, 4, {}, {0.022f, 0.043f, 0.115f}, {0.085f, 0.078f, 0.115f}, {0.012f, 0.0125f, 0.017f}},
    {"night",
     Sky::Time::night,
     30,
     {},
     {0.0007f, 0.001f, 0.0022f},
     {0.003f, 0.0032f, 0.0045f},
     {0.0008f, 0.0008f, 0.001f}},
};

// What the windows show, when the prompt does not say it: it goes with the style.
Sky::View outlook_of(PromptSpec& spec, const Style& style, Random& rng) {
    const float draw = rng.uniform();
    if (spec.outlook.empty()) {
        const RoomWindows& windows = room_type(spec.room).windows;
        const Sky::View view = windows.outlook.value_or(style.outlook);
        const float probability = windows.outlook ? windows.outlook_probability : style.outlook_probability;
        spec.outlook = kNamesOf<Sky::View>[static_cast<std::size_t>(draw < probability ? view : Sky::View::garden)];
        spec.assumed.push_back("outlook: " + spec.outlook);
    }
    const auto& names = kNamesOf<Sky::View>;
    const auto at = std::find(names.begin(), names.end(), spec.outlook);
    return at == names.end() ? Sky::View::garden : static_cast<Sky::View>(at - names.begin());
}

// A photographed outside, its center where the main window looks to. It gives as much light as such an hour has.
void show(const UserSky& users, const PhotographedSky& read, const Daylight& hour, Vec3f outlook, Sky& sky) {
    constexpr float kStrongestSun = 2;  // times that of the hour, or 1 if that has none
    const float azimuth = std::atan2(outlook.x, outlook.z) + users.turn_deg * kPi / 180;
    const float level = users.brightness * 0.5f * (luminance(hour.zenith) + luminance(hour.horizon));
    auto picture = std::make_shared<ImageColor>(turned_to(read.picture, azimuth));
    for (Vec3f& c : picture->pixels) c = c * level;
    sky.picture = std::move(picture);
    sky.zenith = read.zenith * level, sky.horizon = read.horizon * level, sky.ground = read.ground * level;
    sky.clouds = 0;
    const Vec3f d = read.sun_dir;
    sky.sun_dir = {d.x * std::cos(azimuth) + d.z * std::sin(azimuth), d.y,
                   d.z * std::cos(azimuth) - d.x * std::sin(azimuth)};
    sky.sun_irradiance = read.sun_irradiance * level;
    const float most = kStrongestSun * std::max(0.5f, luminance(hour.sun)), found = luminance(sky.sun_irradiance);
    if (found > most) sky.sun_irradiance = sky.sun_irradiance * (most / found);
}

}  // namespace

Random light_draws(const PromptSpec& spec, std::uint64_t seed) { return Random(seed, "light:" + spec.text); }

Sky make_sky(PromptSpec& spec, const Plan& plan, const Mat3f& world_from_room, Random& rng) {
    const Daylight* light = &kDaylight[1];
    for (const Daylight& d : kDaylight)
        if (spec.time == d.name) light = &d;
    Sky sky;
    sky.time = light->time;
    sky.zenith = light->zenith;
    sky.horizon = light->horizon;
    sky.ground = light->ground;
    sky.sun_irradiance = light->sun;
    sky.clouds = spec.weather == "sunny"                                                            ? 0.1f
                 : spec.weather == "overcast" || spec.weather == "rainy" || spec.weather == "snowy" ? 1.f
                                                                                                    : 0.3f;
    sky.seed = rng.next_u32();
    sky.snow = spec.weather == "snowy";
    // At dusk the room is exposed for its lamps: what is outside is deep blue.
    sky.seen = light->time == Sky::Time::night ? 1.f : light->time == Sky::Time::dusk ? 0.22f : 0.13f;
    sky.sun_limit = 3.5f;
    if (light->time != Sky::Time::night && light->time != Sky::Time::dusk) sky.ground_least = 0.55f;
    sky.view = outlook_of(spec, plan.style, rng);
    if (sky.clouds > 0.9f) {
        // An overcast sky is gray and even, and hides the sun.
        const float gray = (luminance(light->zenith) + luminance(light->horizon)) / 2 *
                           (spec.weather == "rainy" ? 0.5f : 0.75f);
        const bool late = light->time == Sky::Time::dusk || light->time == Sky::Time::night;
        sky.zenith = sky.horizon = (late ? Vec3f{0.72f, 0.98f, 1.5f} : Vec3f{0.95f, 1.f, 1.06f}) * gray;
        sky.sun_irradiance = {};
    }
    Vec3f out{1, 0, 0};
    for (const Opening& o : plan.openings)
        if (o.kind == Opening::Kind::window) {
            out = -plan.wall(o.wall).inward;
            break;
        }
    const float elevation = (light->sun_elevation_deg + rng.uniform(-4, 4)) * kPi / 180,
                aside = rng.uniform(0.35f, 0.75f) * (rng.chance(0.5f) ? 1.f : -1.f);
    const Vec3f side = cross(Vec3f{0, 1, 0}, out);
    const Vec3f level = out * std::cos(aside) + side * std::sin(aside);
    sky.sun_dir = world_from_room * normalize(level * std::cos(elevation) + Vec3f{0, std::sin(elevation), 0});
    if (spec.pack)
        if (const UserSky* users = spec.pack->choose_sky(spec.time, sky.seed)) {
            show(*users, *spec.pack->sky(*users), *light, world_from_room * out, sky);
            spec.assumed.push_back(fmt::format("{}: {}", kSkyUsed, credit_of(users->attribution, users->file)));
        }
    return sky;
}

float lamp_level(const PromptSpec& spec, const Plan& plan) {
    const bool daylit = !plan.tunnel && (!plan.skylights.empty() ||
                                         std::any_of(plan.openings.begin(), plan.openings.end(),
                                                     [](const Opening& o) { return o.kind == Opening::Kind::window; }));
    if (!daylit && spec.light != "neon") return 1.f;
    if (spec.light == "neon") return 0.3f;  // beside it they only keep the dark from being black
    if (spec.light == "lamps on" || spec.time == "night" || spec.time == "dusk") return 1.f;
    if (spec.mood == "cozy" || spec.time == "evening") return 0.55f;
    // In shops, halls and offices they are lit by day too.
    constexpr float kPublicByDay = 0.4f;
    return room_type(spec.room).lived_in ? 0.f : kPublicByDay;
}

void assume_time(PromptSpec& spec, std::uint64_t seed) {
    if (spec.time == "evening" && is_one_of(spec.weather, {"overcast", "rainy", "snowy"})) {
        // Behind clouds the low sun gives no light.
        spec.time = "dusk";
        spec.assumed.push_back("time: dusk, as the evening is " + spec.weather);
    }
    if (!spec.time.empty()) return;
    const bool late = Random(seed, "time:" + spec.text).chance(0.5f);
    if (spec.light == "neon") spec.time = "night";
    else
        spec.time = spec.light == "lamps on" || spec.light == "dim" ? "dusk"
                    : spec.mood == "cozy"                           ? (late ? "evening" : "morning")
                                                                    : "day";
    spec.assumed.push_back("time: " + spec.time);
}

void assume_outlook(PromptSpec& spec, const Style& style, std::uint64_t seed) {
    Random rng = light_draws(spec, seed);
    rng.next_u32();  // the sky's own
    outlook_of(spec, style, rng);
}

}  // namespace fastscene

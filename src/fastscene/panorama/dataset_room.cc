#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "fastscene/panorama/dataset_parts.h"
#include "fastscene/rooms/furniture.h"
#include "fastscene/rooms/rooms.h"
#include "fastscene/rooms/style.h"

namespace fastscene::dataset {
namespace {

template <std::size_t N>
std::string_view one_of(const std::array<std::string_view, N>& words, Random& dice) {
    return words[static_cast<std::size_t>(dice.index(static_cast<int>(N)))];
}

constexpr std::array<std::string_view, 12> kRooms{"living room", "bedroom",      "kids room", "kitchen",
                                                  "dining room", "bathroom",     "study",     "hallway",
                                                  "studio loft", "laundry room", "sunroom",   "attic"};
constexpr std::array<std::string_view, 9> kMoods{"",      "",           "",          "cozy ",   "bright ",
                                                 "dark ", "cluttered ", "spacious ", "minimal "};
constexpr std::array<std::string_view, 10> kHours{
    "", "", "", "in the morning", "in the evening", "at dusk", "at night", "at noon", "at night", "with the lamps on"};
constexpr std::array<std::string_view, 5> kWeathers{"", "", "sunny", "overcast", "rainy"};
constexpr std::array<std::string_view, 24> kColors{
    "white", "black",  "gray",    "red",       "blue",     "green",    "yellow",   "orange",
    "pink",  "purple", "brown",   "beige",     "teal",     "navy",     "olive",    "terracotta",
    "cream", "sage",   "mustard", "turquoise", "burgundy", "charcoal", "lavender", "ivory"};
constexpr std::array<std::string_view, 8> kMaterials{"wooden", "leather", "velvet", "metal",
                                                     "marble", "oak",     "walnut", "wicker"};

std::string random_prompt(Random& dice) {
    const std::vector<std::string> all_styles = styles();
    std::string text = fmt::format(
        "a {}{} {}", one_of(kMoods, dice),
        all_styles[static_cast<std::size_t>(dice.index(static_cast<int>(all_styles.size())))], one_of(kRooms, dice));
    const int wishes = dice.index(5);
    const std::vector<std::string>& pieces = piece_classes();
    for (int i = 0; i < wishes; ++i) {
        std::string piece = pieces[static_cast<std::size_t>(dice.index(static_cast<int>(pieces.size())))];
        std::replace(piece.begin(), piece.end(), '_', ' ');
        const std::string_view color = dice.chance(0.6f) ? one_of(kColors, dice) : "",
                               material = dice.chance(0.3f) ? one_of(kMaterials, dice) : "";
        text += fmt::format("{}{}{}{}{}{}",
                            i == 0            ? " with a "
                            : i + 1 == wishes ? " and a "
                                              : ", a ",
                            color, color.empty() ? "" : " ", material, material.empty() ? "" : " ", piece);
    }
    if (dice.chance(0.5f)) text += fmt::format(", {} {}", one_of(kColors, dice), dice.chance(0.5f) ? "walls" : "floor");
    if (const auto hour = one_of(kHours, dice); !hour.empty()) text += fmt::format(", {}", hour);
    if (const auto weather = one_of(kWeathers, dice); !weather.empty()) text += fmt::format(", {}", weather);
    return text;
}

// Patterns that may stand for each other on any surface; pictures, leaves and screens stay what they are.
constexpr std::array kPlain{Pattern::plain,    Pattern::plaster, Pattern::wood,   Pattern::planks,   Pattern::parquet,
                            Pattern::tile,     Pattern::checker, Pattern::brick,  Pattern::concrete, Pattern::marble,
                            Pattern::terrazzo, Pattern::fabric,  Pattern::carpet, Pattern::leather,  Pattern::stripes,
                            Pattern::damask,   Pattern::floral};
bool may_change(Pattern p) { return std::find(kPlain.begin(), kPlain.end(), p) != kPlain.end(); }

Vec3f random_albedo(Random& dice) {
    // Gray level first, then a tint: saturated colors are rare in rooms.
    const float level = std::exp(dice.uniform(std::log(0.04f), std::log(0.85f))),
                tint = 0.9f * std::pow(dice.uniform(), 2.f);
    return {level * (1 - tint * dice.uniform()), level * (1 - tint * dice.uniform()),
            level * (1 - tint * dice.uniform())};
}

Vec3f shifted(Vec3f color, float strength, Vec3f by) {
    for (std::size_t a = 0; a < 3; ++a)
        color[a] = std::clamp(color[a] * std::exp(0.35f * strength * by[a]), 0.015f, 0.88f);
    return color;
}

void vary_material(Material& m, float strength, Random& dice) {
    const Vec3f by{dice.normal(), dice.normal(), dice.normal()};
    m.color_a = shifted(m.color_a, strength, by);
    m.color_b = shifted(m.color_b, strength, by);
    m.color_c = shifted(m.color_c, strength, by);
    const float roughness = 0.25f * strength * dice.normal(), scale = 0.3f * strength * dice.normal();
    const bool recolor = dice.chance(0.2f * strength), repattern = dice.chance(0.2f * strength);
    const Vec3f a = random_albedo(dice), b = random_albedo(dice);
    const Pattern pattern = kPlain[static_cast<std::size_t>(dice.index(static_cast<int>(kPlain.size())))];
    if (m.mirror > 0 || luminance(m.emission) > 0 || !may_change(m.pattern)) return;
    m.roughness = std::clamp(m.roughness + roughness, 0.08f, 1.f);
    m.scale_m *= std::exp(scale);
    if (recolor) m.color_a = a, m.color_b = b;
    if (repattern) {
        m.pattern = pattern;
        m.scale_m = std::clamp(m.scale_m, 0.04f, 0.4f);
    }
}

void vary_light(Room& room, Random& dice) {
    const float lamps = std::exp2(dice.uniform(-1.2f, 1.2f)), warmth = dice.uniform(-0.25f, 0.25f);
    for (Material& m : room.materials)
        m.emission = m.emission * Vec3f{lamps * (1 + warmth), lamps, lamps * (1 - warmth)};
    const float sky = std::exp2(dice.uniform(-0.8f, 0.8f)), sun = std::exp2(dice.uniform(-1.f, 0.6f));
    room.sky.zenith = room.sky.zenith * sky;
    room.sky.horizon = room.sky.horizon * sky;
    room.sky.ground = room.sky.ground * sky;
    room.sky.sun_irradiance = room.sky.sun_irradiance * sun;
    room.sky.seed = dice.next_u32();
}

// Exposure and white balance miss by what a camera's automatic misses.
void vary_look(Look& look, Random& dice) {
    look.exposure_ev += std::clamp(0.45f * dice.normal(), -1.2f, 1.2f);
    const float warm = 0.07f * dice.normal(), green = 0.025f * dice.normal();
    look.white = look.white * Vec3f{std::exp(warm - green), std::exp(green), std::exp(-warm - green)};
    look.contrast *= dice.uniform(0.88f, 1.15f);
    look.saturation *= dice.uniform(0.7f, 1.25f);
}

}  // namespace

RandomRoom random_room(std::uint64_t seed, int index) {
    Random dice(seed, "dataset room", static_cast<std::uint64_t>(index));
    RandomRoom made;
    made.prompt = random_prompt(dice);
    PromptSpec spec = understand_prompt(made.prompt, false);
    Run run;
    run.seed = dice.next_u64();
    made.room = make_room(spec, run);
    // A third of the rooms stay as their style has them; in the rest materials stray, in some wildly.
    const float strength = dice.chance(0.33f) ? 0.f : dice.uniform(0.2f, 1.5f);
    for (Material& m : made.room.materials) vary_material(m, strength, dice);
    vary_light(made.room, dice);
    vary_look(made.room.look, dice);
    return made;
}

}  // namespace fastscene::dataset

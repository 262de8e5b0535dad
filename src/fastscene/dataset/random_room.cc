#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "fastscene/dataset/parts.h"
#include "fastscene/rooms/document.h"
#include "fastscene/rooms/furniture.h"
#include "fastscene/rooms/layout.h"
#include "fastscene/rooms/style.h"

namespace fastscene::dataset {
namespace {

template <std::size_t N>
std::string_view one_of(const std::array<std::string_view, N>& words, Random& rng) {
    return words[static_cast<std::size_t>(rng.index(static_cast<int>(N)))];
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

std::string random_prompt(Random& rng) {
    const std::vector<std::string> all_styles = styles();
    std::string text = fmt::format("a {}{} {}", one_of(kMoods, rng),
                                   all_styles[static_cast<std::size_t>(rng.index(static_cast<int>(all_styles.size())))],
                                   one_of(kRooms, rng));
    const int wishes = rng.index(5);
    const std::vector<std::string>& pieces = piece_classes();
    for (int i = 0; i < wishes; ++i) {
        std::string piece = pieces[static_cast<std::size_t>(rng.index(static_cast<int>(pieces.size())))];
        std::replace(piece.begin(), piece.end(), '_', ' ');
        const std::string_view color = rng.chance(0.6f) ? one_of(kColors, rng) : "",
                               material = rng.chance(0.3f) ? one_of(kMaterials, rng) : "";
        text += fmt::format("{}{}{}{}{}{}",
                            i == 0            ? " with a "
                            : i + 1 == wishes ? " and a "
                                              : ", a ",
                            color, color.empty() ? "" : " ", material, material.empty() ? "" : " ", piece);
    }
    if (rng.chance(0.5f)) text += fmt::format(", {} {}", one_of(kColors, rng), rng.chance(0.5f) ? "walls" : "floor");
    if (const auto hour = one_of(kHours, rng); !hour.empty()) text += fmt::format(", {}", hour);
    if (const auto weather = one_of(kWeathers, rng); !weather.empty()) text += fmt::format(", {}", weather);
    return text;
}

// Patterns that may replace each other on any surface; pictures, leaves and screens are excluded.
constexpr std::array kPlain{Pattern::plain,    Pattern::plaster, Pattern::wood,   Pattern::planks,   Pattern::parquet,
                            Pattern::tile,     Pattern::checker, Pattern::brick,  Pattern::concrete, Pattern::marble,
                            Pattern::terrazzo, Pattern::fabric,  Pattern::carpet, Pattern::leather,  Pattern::stripes,
                            Pattern::damask,   Pattern::floral};
bool may_change(Pattern p) { return std::find(kPlain.begin(), kPlain.end(), p) != kPlain.end(); }

Vec3f random_albedo(Random& rng) {
    // Gray level first, then a tint: saturated colors are rare in rooms.
    const float level = std::exp(rng.uniform(std::log(0.04f), std::log(0.85f))),
                tint = 0.9f * std::pow(rng.uniform(), 2.f);
    return {level * (1 - tint * rng.uniform()), level * (1 - tint * rng.uniform()), level * (1 - tint * rng.uniform())};
}

Vec3f shifted(Vec3f color, float strength, Vec3f by) {
    for (std::size_t a = 0; a < 3; ++a)
        color[a] = std::clamp(color[a] * std::exp(0.35f * strength * by[a]), 0.015f, 0.88f);
    return color;
}

void vary_material(Material& m, float strength, Random& rng) {
    const Vec3f by{rng.normal(), rng.normal(), rng.normal()};
    m.color_a = shifted(m.color_a, strength, by);
    m.color_b = shifted(m.color_b, strength, by);
    m.color_c = shifted(m.color_c, strength, by);
    const float roughness = 0.25f * strength * rng.normal(), scale = 0.3f * strength * rng.normal();
    const bool recolor = rng.chance(0.2f * strength), repattern = rng.chance(0.2f * strength);
    const Vec3f a = random_albedo(rng), b = random_albedo(rng);
    const Pattern pattern = kPlain[static_cast<std::size_t>(rng.index(static_cast<int>(kPlain.size())))];
    if (m.mirror > 0 || luminance(m.emission) > 0 || !may_change(m.pattern)) return;
    m.roughness = std::clamp(m.roughness + roughness, 0.08f, 1.f);
    m.scale_m *= std::exp(scale);
    if (recolor) m.color_a = a, m.color_b = b;
    if (repattern) {
        m.pattern = pattern;
        m.scale_m = std::clamp(m.scale_m, 0.04f, 0.4f);
    }
}

void vary_light(Room& room, Random& rng) {
    const float lamps = std::exp2(rng.uniform(-1.2f, 1.2f)), warmth = rng.uniform(-0.25f, 0.25f);
    for (Material& m : room.materials)
        m.emission = m.emission * Vec3f{lamps * (1 + warmth), lamps, lamps * (1 - warmth)};
    const float sky = std::exp2(rng.uniform(-0.8f, 0.8f)), sun = std::exp2(rng.uniform(-1.f, 0.6f));
    room.sky.zenith = room.sky.zenith * sky;
    room.sky.horizon = room.sky.horizon * sky;
    room.sky.ground = room.sky.ground * sky;
    room.sky.sun_irradiance = room.sky.sun_irradiance * sun;
    room.sky.seed = rng.next_u32();
}

// Varies exposure and white balance by the typical errors of a camera's automatic.
void vary_look(Look& look, Random& rng) {
    look.exposure_ev += std::clamp(0.45f * rng.normal(), -1.2f, 1.2f);
    const float warm = 0.07f * rng.normal(), green = 0.025f * rng.normal();
    look.white = look.white * Vec3f{std::exp(warm - green), std::exp(green), std::exp(-warm - green)};
    look.contrast *= rng.uniform(0.88f, 1.15f);
    look.saturation *= rng.uniform(0.7f, 1.25f);
}

}  // namespace

RandomRoom random_room(std::uint64_t seed, int index) {
    Random rng(seed, "dataset room", static_cast<std::uint64_t>(index));
    RandomRoom made;
    made.prompt = random_prompt(rng);
    PromptSpec spec = understand_prompt(made.prompt, false);
    Run run;
    run.seed = rng.next_u64();
    const FurnishedRoom furnished = furnish_room(spec, run);
    made.room = room_of(spec, furnished, run);
    made.document = document_json(document_of(spec, furnished, run.seed));
    // A third of the rooms keep their style; in the rest materials vary, in some extremely.
    const float strength = rng.chance(0.33f) ? 0.f : rng.uniform(0.2f, 1.5f);
    for (Material& m : made.room.materials) vary_material(m, strength, rng);
    vary_light(made.room, rng);
    vary_look(made.room.look, rng);
    return made;
}

}  // namespace fastscene::dataset

#include "fastscene/rooms/style_file.h"

#include <fmt/ranges.h>

#include <array>
#include <utility>

#include "fastscene/rooms/file_fields.h"
#include "fastscene/rooms/prints.h"

namespace fastscene {
namespace {

using file_fields::choice;

constexpr std::size_t kPalette = 6, kKitchenPaints = 2;

// The style's own materials, as a part of a piece names them.
constexpr std::array<std::pair<std::string_view, Material Style::*>, 8> kOwn{{{"wood", &Style::wood},
                                                                              {"second wood", &Style::wood2},
                                                                              {"metal", &Style::metal},
                                                                              {"fabric", &Style::fabric},
                                                                              {"second fabric", &Style::fabric2},
                                                                              {"leather", &Style::leather},
                                                                              {"curtain", &Style::curtain},
                                                                              {"trim", &Style::trim}}};

// "wood": the style's own. { in_accent = …}: a material in the palette's first color. Else a material.
MadeOf made_of(const TomlTable& table, std::string_view key) {
    const toml::node* found = table.raw().get(key);
    if (!found) table.fail_missing(key, "a material of the style's (\"wood\") or another ({ timber = \"oak\" })");
    MadeOf part;
    if (!found->is_table()) {
        std::array<std::string_view, kOwn.size()> names;
        for (std::size_t i = 0; i < kOwn.size(); ++i) names[i] = kOwn[i].first;
        part.own = kOwn[table.needed_choice(key, names)].second;
        return part;
    }
    toml::table material = *found->as_table();
    if (const auto* accent = material.get("in_accent")) {
        if (!accent->value_exact<bool>()) table.fail(key, "in_accent: expected true or false, found " + shown(*accent));
        part.in_accent = *accent->value_exact<bool>();
        material.erase("in_accent");
        if (part.in_accent) material.insert("color", toml::array{0.5, 0.5, 0.5});  // the accent's, once it is made
    }
    part.other = file_fields::material(material, table.file(), std::string(key));
    return part;
}

template <class Form>
void read_forms(const TomlTable& table, std::string_view key, TwoForms<Form>& forms) {
    const std::vector<std::string> names = table.texts(key);
    if (names.size() != 2)
        table.fail(key, fmt::format("expected two of {}, found {}", fmt::join(kNamesOf<Form>, ", "), names.size()));
    forms.first = static_cast<Form>(table.choice_of(key, names[0], kNamesOf<Form>));
    forms.second = static_cast<Form>(table.choice_of(key, names[1], kNamesOf<Form>));
}

float probability(const TomlTable& table, std::string_view key) {
    return static_cast<float>(table.needed_number(key, 0, 1));
}

class StyleReader {
  public:
    StyleReader(const toml::table& document, const std::string& file)
        : top_(document, file, "",
               {"name", "rank", "words", "drawn_for", "surfaces", "ceiling", "wet_rooms", "colors", "materials",
                "windows", "light", "outlook", "density", "silhouettes", "forms", "made_of", "details"}) {}

    Style read() {
        s_.name = top_.needed_text("name");
        s_.rank = top_.needed_whole("rank", 1, 1000);
        s_.words = top_.texts("words");
        read_draws();
        read_surfaces();
        read_ceiling();
        read_colors();
        read_materials();
        read_light();
        read_silhouettes();
        read_forms_of_pieces();
        read_made_of();
        read_details();
        return std::move(s_);
    }

  private:
    TomlTable table(std::string_view key, const std::vector<std::string>& keys) const {
        return {top_.needed_table(key), top_.file(), fmt::format("[{}]", key), keys};
    }

    void read_draws() {
        const toml::table* found = top_.table("drawn_for");
        if (!found) return;
        const std::vector<std::string> moods(kNamesOf<StyleMood>.begin(), kNamesOf<StyleMood>.end());
        const TomlTable t(*found, top_.file(), "[drawn_for]", moods);
        for (std::size_t i = 0; i < moods.size(); ++i)
            if (t.has(moods[i])) s_.drawn_for[static_cast<StyleMood>(i)] = t.whole(moods[i], 0, 1, 1000);
    }

    void read_surfaces() {
        const TomlTable t = table("surfaces", {"floor", "wall", "accent_wall", "ceiling", "trim"});
        s_.floor = file_fields::material(t, "floor");
        s_.wall = file_fields::material(t, "wall");
        s_.accent_wall = file_fields::material(t, "accent_wall");
        s_.ceiling = file_fields::material(t, "ceiling");
        s_.trim = file_fields::material(t, "trim");
        const TomlTable wet = table("wet_rooms", {"wall", "floor"});
        s_.wet_wall = file_fields::material(wet, "wall");
        s_.wet_floor = file_fields::material(wet, "floor");
    }

    void read_ceiling() {
        const TomlTable t = table("ceiling", {"height_m", "beams", "boards", "boards_probability", "tray_probability",
                                              "recessed_lights_probability"});
        constexpr double kLowest = 2.2, kHighest = 6;
        s_.ceiling_m = static_cast<float>(t.needed_number("height_m", kLowest, kHighest));
        s_.beams = t.needed_flag("beams");
        s_.ceiling_boards_probability = probability(t, "boards_probability");
        s_.tray_probability = probability(t, "tray_probability");
        s_.recessed_lights_probability = probability(t, "recessed_lights_probability");
        if (s_.ceiling_boards_probability > 0 || t.has("boards"))
            s_.ceiling_boards = file_fields::material(t, "boards");
    }

    void read_colors() {
        const TomlTable t = table("colors", {"palette", "paints", "deep_paints", "kitchen_paints", "wallpaper"});
        s_.palette = file_fields::colors(t, "palette");
        if (s_.palette.size() != kPalette)
            t.fail("palette", fmt::format("expected {} colors, found {}", kPalette, s_.palette.size()));
        s_.paints = file_fields::colors(t, "paints");
        if (s_.paints.empty()) t.fail("paints", "expected one color or more, found none");
        s_.deep_paints = file_fields::colors(t, "deep_paints");
        s_.kitchen_paints = file_fields::colors(t, "kitchen_paints");
        if (!s_.kitchen_paints.empty() && s_.kitchen_paints.size() != kKitchenPaints)
            t.fail("kitchen_paints",
                   fmt::format("expected {} colors or none, found {}", kKitchenPaints, s_.kitchen_paints.size()));
        s_.wallpaper = t.needed_text("wallpaper", "the name of a print");
        if (!is_print(s_.wallpaper))
            t.fail("wallpaper", fmt::format("expected the name of a print, found \"{}\"", s_.wallpaper));
    }

    void read_materials() {
        const TomlTable t = table("materials", {"wood", "second_wood", "metal", "taps", "fabric", "second_fabric",
                                                "leather", "curtain", "rug"});
        s_.wood = file_fields::material(t, "wood");
        s_.wood2 = file_fields::material(t, "second_wood");
        s_.metal = file_fields::material(t, "metal");
        s_.tap = file_fields::material(t, "taps");
        s_.fabric = file_fields::material(t, "fabric");
        s_.fabric2 = file_fields::material(t, "second_fabric");
        s_.leather = file_fields::material(t, "leather");
        s_.curtain = file_fields::material(t, "curtain");
        s_.rug = file_fields::material(t, "rug");
        // Cloth hardly shines; the figures of a rug are woven in this size.
        constexpr float kClothSpecular = 0.02f, kFigures = 1.2f;
        s_.rug.scale_m = kFigures;
        for (Material* cloth : {&s_.rug, &s_.fabric, &s_.fabric2, &s_.curtain}) cloth->specular = kClothSpecular;
    }

    void read_light() {
        const TomlTable windows = table("windows", {"columns", "rows", "radiators"});
        constexpr int kMostPanes = 12;
        s_.window_columns = windows.needed_whole("columns", 1, kMostPanes);
        s_.window_rows = windows.needed_whole("rows", 1, kMostPanes);
        s_.radiators = windows.needed_flag("radiators");
        const TomlTable light = table("light", {"lamp", "radiance"});
        s_.lamp = choice<LampFamily>(light, "lamp");
        const std::vector<double> radiance = light.numbers("radiance");
        if (radiance.size() != 3) light.fail("radiance", fmt::format("expected [r, g, b], found {}", radiance.size()));
        for (std::size_t c = 0; c < 3; ++c) s_.lamp_light[c] = static_cast<float>(radiance[c]);
        const TomlTable outlook = table("outlook", {"view", "probability"});
        s_.outlook = choice<Sky::View>(outlook, "view");
        s_.outlook_probability = probability(outlook, "probability");
        const TomlTable density = table("density", {"plants", "clutter"});
        s_.plants = probability(density, "plants");
        s_.clutter = probability(density, "clutter");
    }

    void read_silhouettes() {
        const TomlTable t = table("silhouettes", {"legs", "sofa_arms", "mouldings", "bed_posts", "fan_blades",
                                                  "tapestry", "rug_weave", "sideboard_columns", "sideboard_most_rows"});
        s_.legs = choice<LegType>(t, "legs");
        s_.sofa = choice<SofaType>(t, "sofa_arms");
        s_.mouldings = choice<Mouldings>(t, "mouldings");
        s_.bed_posts = choice<PostForm>(t, "bed_posts");
        s_.fan_blades = choice<FanForm>(t, "fan_blades");
        s_.tapestry = choice<TapestryForm>(t, "tapestry");
        s_.rug_weave = choice<RugWeave>(t, "rug_weave");
        s_.sideboard_columns = t.needed_whole("sideboard_columns", 1, 8);
        s_.sideboard_most_rows = t.needed_whole("sideboard_most_rows", 1, 2);
    }

    void read_forms_of_pieces() {
        const TomlTable t = table("forms", {"sofa", "armchair", "chaise_longue", "bed", "daybed", "floor_bed", "bunk",
                                            "coffee_table", "dining_table", "sideboard", "floor_lamp"});
        read_forms(t, "sofa", s_.forms.sofa);
        read_forms(t, "armchair", s_.forms.armchair);
        read_forms(t, "chaise_longue", s_.forms.chaise_longue);
        read_forms(t, "bed", s_.forms.bed);
        read_forms(t, "daybed", s_.forms.daybed);
        read_forms(t, "floor_bed", s_.forms.floor_bed);
        read_forms(t, "bunk", s_.forms.bunk);
        read_forms(t, "coffee_table", s_.forms.coffee_table);
        read_forms(t, "dining_table", s_.forms.dining_table);
        read_forms(t, "sideboard", s_.forms.chest);
        read_forms(t, "floor_lamp", s_.forms.floor_lamp);
    }

    void read_made_of() {
        auto& m = s_.made_of;
        const std::vector<std::pair<std::string_view, MadeOf*>> parts{{"blind_slats", &m.blind_slats},
                                                                      {"shutters", &m.shutters},
                                                                      {"shoji", &m.shoji},
                                                                      {"bunk", &m.bunk},
                                                                      {"bunk_boxes", &m.bunk_boxes},
                                                                      {"chaise_longue", &m.chaise_longue},
                                                                      {"lounge_chair", &m.lounge_chair},
                                                                      {"butterfly_chair", &m.butterfly_chair},
                                                                      {"throne", &m.throne},
                                                                      {"window_seat", &m.window_seat},
                                                                      {"clock_case", &m.clock_case},
                                                                      {"cactus_pot", &m.cactus_pot},
                                                                      {"bar_cart", &m.bar_cart},
                                                                      {"bar_cart_shelves", &m.bar_cart_shelves},
                                                                      {"lantern", &m.lantern},
                                                                      {"fan_blades", &m.fan_blades}};
        std::vector<std::string> keys;
        for (const auto& part : parts) keys.emplace_back(part.first);
        const TomlTable t = table("made_of", keys);
        for (const auto& [key, part] : parts) *part = made_of(t, key);
    }

    void read_details() {
        const std::vector<std::pair<std::string_view, bool Style::*>> flags{
            {"fresh_flowers", &Style::fresh_flowers},
            {"round_rugs", &Style::round_rugs},
            {"old_maps", &Style::old_maps},
            {"yellowed_paper", &Style::yellowed_paper},
            {"lacquered_play", &Style::lacquered_play},
            {"black_cane", &Style::black_cane},
            {"formal_clocks", &Style::formal_clocks},
            {"aluminium_ladders", &Style::aluminium_ladders}};
        std::vector<std::string> keys;
        for (const auto& flag : flags) keys.emplace_back(flag.first);
        const TomlTable t = table("details", keys);
        for (const auto& [key, flag] : flags) s_.*flag = t.needed_flag(key);
    }

    TomlTable top_;
    Style s_;
};

}  // namespace

Style read_style(std::string_view text, const std::string& file) {
    const toml::table document = parse_toml(text, file);
    return StyleReader(document, file).read();
}

}  // namespace fastscene

#include "fastscene/rooms/file_fields.h"

#include <fmt/ranges.h>

#include <array>

#include "fastscene/rooms/materials.h"

namespace fastscene {
namespace file_fields {
namespace {

constexpr double kMostAlbedo = 1, kMostScale = 10, kMostBump = 0.1;

std::string known_color(const TomlTable& table, std::string_view key, const std::string& name) {
    if (!color_named(name)) table.fail(key, fmt::format("expected a color's name, found \"{}\"", name));
    return name;
}
std::string color_name(const TomlTable& table, std::string_view key) {
    return known_color(table, key, table.needed_text(key, "a color's name"));
}
std::vector<std::string> color_names(const TomlTable& table, std::string_view key, std::size_t count) {
    std::vector<std::string> names = table.texts(key);
    if (names.size() != count) table.fail(key, fmt::format("expected {} colors, found {}", count, names.size()));
    for (const std::string& name : names) known_color(table, key, name);
    return names;
}
float number(const TomlTable& table, std::string_view key, double low, double high) {
    return static_cast<float>(table.needed_number(key, low, high));
}

// A material of which everything is said.
Material plain_material(const TomlTable& t) {
    const Vec3f a = color(t, "color"), b = t.has("second_color") ? color(t, "second_color") : a;
    const float darker = static_cast<float>(t.number("second_color_share", 1, 0, kMostAlbedo));
    Material m = materials::make(t.needed_text("name"), t.has("pattern") ? pattern(t, "pattern") : Pattern::plain, a,
                                 b * darker, static_cast<float>(t.number("scale_m", 0.1, 0.0005, kMostScale)),
                                 number(t, "roughness", 0.02, 1),
                                 static_cast<float>(t.number("bump_m", 0, 0, kMostBump)));
    if (t.has("third_color")) m.color_c = color(t, "third_color");
    m.transmission = static_cast<float>(t.number("transmission", 0, 0, 1));
    return m;
}

Material named_material(const TomlTable& t) {
    const std::string name = t.text("material");
    const auto found = material_named(name);
    if (!found) t.fail("material", fmt::format("expected a material's name, found \"{}\"", name));
    return *found;
}

struct Kind {
    std::string_view key;  // that says which
    std::vector<std::string> others;
    Material (*read)(const TomlTable&);
};
const std::array<Kind, 10>& kinds() {
    static const std::array<Kind, 10> all{{
        {"paint", {}, [](const TomlTable& t) { return materials::paint(color_name(t, "paint")); }},
        {"timber",
         {"roughness"},
         [](const TomlTable& t) {
             return t.has("roughness") ? materials::timber(color_name(t, "timber"), number(t, "roughness", 0.02, 1))
                                       : materials::timber(color_name(t, "timber"));
         }},
        {"boards",
         {"pattern", "width_m"},
         [](const TomlTable& t) {
             return materials::boards(pattern(t, "pattern"), color_name(t, "boards"), number(t, "width_m", 0.02, 1));
         }},
        {"ceiling_boards",
         {"width_m"},
         [](const TomlTable& t) {
             const auto names = color_names(t, "ceiling_boards", 2);
             return materials::ceiling_boards(names[0], names[1], number(t, "width_m", 0.02, 1));
         }},
        {"tiles",
         {"pattern", "size_m"},
         [](const TomlTable& t) {
             const auto names = color_names(t, "tiles", 2);
             return materials::tiles(pattern(t, "pattern"), names[0], names[1], number(t, "size_m", 0.01, 2));
         }},
        {"cloth", {}, [](const TomlTable& t) { return materials::cloth(color_name(t, "cloth")); }},
        {"leather", {}, [](const TomlTable& t) { return materials::leather(color_name(t, "leather")); }},
        {"curtain",
         {"transmission"},
         [](const TomlTable& t) { return materials::veil(color_name(t, "curtain"), number(t, "transmission", 0, 1)); }},
        {"rug",
         {"pattern"},
         [](const TomlTable& t) {
             const auto names = color_names(t, "rug", 3);
             return materials::carpet(pattern(t, "pattern"), names[0], names[1], names[2]);
         }},
        {"material", {}, named_material},
    }};
    return all;
}

}  // namespace

Pattern pattern(const TomlTable& table, std::string_view key) {
    return static_cast<Pattern>(table.needed_choice(key, kNamesOf<Pattern>));
}

Vec3f color(const TomlTable& table, std::string_view key) {
    const toml::node* found = table.raw().get(key);
    if (!found) table.fail_missing(key, "a color's name or [r, g, b]");
    if (!found->is_array()) return *color_named(color_name(table, key));
    const std::vector<double> rgb = table.numbers(key);
    if (rgb.size() != 3) table.fail(key, fmt::format("expected a color's name or [r, g, b], found {}", shown(*found)));
    for (const double channel : rgb)
        if (!(channel >= 0 && channel <= kMostAlbedo))
            table.fail(key, fmt::format("expected channels from 0 to 1, found {}", channel));
    return {static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2])};
}

std::vector<Vec3f> colors(const TomlTable& table, std::string_view key) {
    std::vector<Vec3f> out;
    const std::vector<std::string> names = table.texts(key);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto found = color_named(names[i]);
        if (!found) table.fail_item(key, i, fmt::format("expected a color's name, found \"{}\"", names[i]));
        out.push_back(*found);
    }
    return out;
}

Material material(const toml::table& found, const std::string& file, const std::string& where) {
    for (const Kind& kind : kinds())
        if (found.contains(kind.key)) {
            std::vector<std::string> keys = kind.others;
            keys.emplace_back(kind.key);
            return kind.read(TomlTable(found, file, where, keys));
        }
    std::vector<std::string> keys{"name",        "pattern", "color",     "second_color", "second_color_share",
                                  "third_color", "scale_m", "roughness", "bump_m",       "transmission"};
    for (const Kind& kind : kinds()) keys.emplace_back(kind.key);
    return plain_material(TomlTable(found, file, where, keys));
}
Material material(const TomlTable& table, std::string_view key) {
    const toml::node* found = table.raw().get(key);
    if (!found || !found->is_table()) table.fail(key, "expected a material such as { paint = \"white\" }");
    return material(*found->as_table(), table.file(), std::string(key));
}

}  // namespace file_fields
}  // namespace fastscene

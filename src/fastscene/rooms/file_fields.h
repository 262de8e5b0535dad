// Fields of the files of styles and room types that are more than a number: choices by name, colors, materials.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fastscene/io/toml_table.h"
#include "fastscene/rooms/style_choices.h"
#include "fastscene/scene/room.h"

namespace fastscene::file_fields {

template <class Choice>
Choice choice(const TomlTable& table, std::string_view key) {
    static_assert(!kNamesOf<Choice>.empty());
    return static_cast<Choice>(table.needed_choice(key, kNamesOf<Choice>));
}

// The walls of a plan, by number.
inline constexpr std::string_view kWallNames[] = {"far", "right", "near", "left"};

// An embedded text and its file, as cmake/embed.cmake lists them: (stem, text).
using EmbeddedFile = std::pair<std::string_view, std::string_view>;

// A known color's name, or linear [r, g, b].
Vec3f color(const TomlTable& table, std::string_view key);
std::vector<Vec3f> colors(const TomlTable& table, std::string_view key);
// { paint = "white" }, { timber = "oak", roughness = 0.5 }, { material = "brass" } …: docs/extend/style.md lists them.
Material material(const TomlTable& table, std::string_view key);
Material material(const toml::table& found, const std::string& file, const std::string& where);
Pattern pattern(const TomlTable& table, std::string_view key);

}  // namespace fastscene::file_fields

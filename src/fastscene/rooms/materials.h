// Colors and materials by their common names.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "fastscene/scene/room.h"

namespace fastscene {

// Linear albedo, each channel in [0.012, 0.85] and at least 0.03 bright, of a CSS or common interior color name
// ("sage", "terracotta", "dark blue"); lower case, spaces or hyphens; nullopt when unknown. "light", "dark", "pale",
// "deep" may precede a known name.
std::optional<Vec3f> color_named(std::string_view name);

// A material by its common name ("oak", "marble", "brass", "leather", "velvet", "brick" …); nullopt when unknown.
std::optional<Material> material_named(std::string_view name);

// Lower case, spaces for hyphens and underscores, "gray" for "grey".
std::string plain_name(std::string_view name);

// Colors that these take by name must be known to color_named.
namespace materials {

// Its third color is the first.
Material make(std::string name, Pattern pattern, Vec3f a, Vec3f b, float scale_m, float roughness, float bump_m = 0.f);
Material paint(std::string_view color);
Material timber(std::string_view kind, float roughness = 0.45f);
Material boards(Pattern pattern, std::string_view kind, float width_m);
Material ceiling_boards(std::string_view color, std::string_view joint, float width_m);
// Tiles and what else covers the walls and floors of wet rooms: marble, terrazzo, concrete.
Material tiles(Pattern pattern, std::string_view color, std::string_view grout, float size_m);
Material cloth(std::string_view color);
Material leather(std::string_view color);
// `through`: the share of diffuse light that it lets through.
Material veil(std::string_view color, float through);
Material carpet(Pattern pattern, std::string_view a, std::string_view b, std::string_view c);

}  // namespace materials
}  // namespace fastscene

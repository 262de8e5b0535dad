// Styles: what an interior of a given taste is made of. Data only; no geometry.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/scene/room.h"

namespace fastscene {

enum class LampFamily : std::uint8_t {
    drum,
    globe,
    paper,
    cage,
    dome,
    candelabra
};  // the shade of floor, table and hanging lamps
enum class LegType : std::uint8_t { square, tapered, splayed, turned, metal_frame, hairpin };
enum class SofaType : std::uint8_t { block, slim, rolled };        // box arms; thin arms on legs; rolled arms
enum class Shelves : std::uint8_t { books, bath, kitchen, toys };  // what stands on them
enum class Mouldings : std::uint8_t { none, plain, rich };

// Materials are complete (color, pattern, roughness); rooms/ may copy and recolor them.
struct Style {
    std::string name;
    Material floor, wall, accent_wall, ceiling, trim;
    Material wood, wood2, metal, fabric, fabric2, leather, curtain, rug;
    std::vector<Vec3f> palette;  // 6 linear albedos for cushions, books, art, vases; the first is the accent
    LampFamily lamp = LampFamily::drum;
    LegType legs = LegType::square;
    SofaType sofa = SofaType::block;
    Mouldings mouldings = Mouldings::none;
    int window_columns = 1, window_rows = 1;  // panes
    float plants = 0.5f;                      // 0 none … 1 many
    float clutter = 0.5f;                     // 0 bare … 1 full
    float ceiling_m = 2.7f;
    bool beams = false;                 // visible ceiling beams
    Vec3f lamp_light{9.f, 6.6f, 4.2f};  // radiance of a lit shade, relative to daylight of about 1
    Shelves shelves = Shelves::books;   // set by the room, not by taste
    Material tap{};                     // of basins, tubs and showers
};

// One of styles(); throws Error for another name.
const Style& style_named(std::string_view name);
// modern scandinavian japandi industrial classic boho rustic mid-century mediterranean art deco
std::vector<std::string> styles();

// Linear albedo, each channel in [0.012, 0.85] and at least 0.03 bright, of a CSS or common interior color name
// ("sage", "terracotta", "dark blue"); lower case, spaces or hyphens; nullopt when unknown. "light", "dark", "pale",
// "deep" may precede a known name.
std::optional<Vec3f> color_named(std::string_view name);

// A material by its common name ("oak", "marble", "brass", "leather", "velvet", "brick" …); nullopt when unknown.
std::optional<Material> material_named(std::string_view name);

}  // namespace fastscene

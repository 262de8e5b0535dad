// Prints: patterns of paper, cloth and tiles by their names ("polka dots", "damask"), put onto a material.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "fastscene/scene/room.h"

namespace fastscene {

// Where a print lies: its motif is larger on a wall than on a cushion.
enum class PrintGround : std::uint8_t { paper, cloth, curtain, rug };

// Whether a pattern of this name can be drawn: "striped", "floral", "dots" …; "plain" is none.
bool is_print(std::string_view name);

// Draws it on the material's main color. Its second color is `second` where one was said, else it is taken from
// `palette` (may be empty) or is a shade of the ground. Tiles stay tiles: laid in a herringbone, or with an ornament on
// each. Does nothing for other names.
void print_on(Material& m, std::string_view name, PrintGround ground, std::optional<Vec3f> second,
              std::span<const Vec3f> palette);

}  // namespace fastscene

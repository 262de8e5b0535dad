// Labels on contact sheets: a small fixed font, so that pictures can be named without a font library.
#pragma once

#include <string_view>

#include "fastscene/image/image.h"

namespace fastscene {

// Glyphs are 5 x 7 dots with one dot between them; a dot is `scale` pixels wide.
inline constexpr int kGlyphWidth = 6, kGlyphHeight = 7;

// Writes at (x, y), the text's top left corner. Letters, digits and -._, are known, others leave a gap; what lies
// outside of the picture is cut off.
void draw_label(ImageRgb8& image, std::string_view text, int x, int y, Rgb8 color, int scale = 1);

// Copies `part` into `image` with its top left corner at (x, y); what lies outside is cut off.
void paste(ImageRgb8& image, const ImageRgb8& part, int x, int y);

}  // namespace fastscene

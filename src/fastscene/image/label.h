// Text labels for contact sheets in a small built-in font.
#pragma once

#include <string_view>

#include "fastscene/image/image.h"

namespace fastscene {

// Glyphs are 5 x 7 dots, spaced by one dot; a dot is `scale` pixels wide.
inline constexpr int kGlyphWidth = 6, kGlyphHeight = 7;

// Draws text with its top left corner at (x, y). Supports letters, digits and -._, ; others leave a gap. Clipped at the
// picture's border.
void draw_label(ImageRgb8& image, std::string_view text, int x, int y, Rgb8 color, int scale = 1);

// Copies `part` into `image` with its top left corner at (x, y), clipped.
void paste(ImageRgb8& image, const ImageRgb8& part, int x, int y);

}  // namespace fastscene

#include "fastscene/image/label.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace fastscene {
namespace {

// Seven rows from top to bottom, five dots each; the highest of the five bits is the leftmost dot.
struct Glyph {
    char letter;
    std::array<std::uint8_t, kGlyphHeight> rows;
};
constexpr Glyph kGlyphs[] = {
    {'A', {14, 17, 17, 31, 17, 17, 17}}, {'B', {30, 17, 17, 30, 17, 17, 30}}, {'C', {14, 17, 16, 16, 16, 17, 14}},
    {'D', {30, 17, 17, 17, 17, 17, 30}}, {'E', {31, 16, 16, 30, 16, 16, 31}}, {'F', {31, 16, 16, 30, 16, 16, 16}},
    {'G', {14, 17, 16, 23, 17, 17, 14}}, {'H', {17, 17, 17, 31, 17, 17, 17}}, {'I', {14, 4, 4, 4, 4, 4, 14}},
    {'J', {7, 2, 2, 2, 2, 18, 12}},      {'K', {17, 18, 20, 24, 20, 18, 17}}, {'L', {16, 16, 16, 16, 16, 16, 31}},
    {'M', {17, 27, 21, 21, 17, 17, 17}}, {'N', {17, 25, 21, 19, 17, 17, 17}}, {'O', {14, 17, 17, 17, 17, 17, 14}},
    {'P', {30, 17, 17, 30, 16, 16, 16}}, {'Q', {14, 17, 17, 17, 21, 18, 13}}, {'R', {30, 17, 17, 30, 20, 18, 17}},
    {'S', {15, 16, 16, 14, 1, 1, 30}},   {'T', {31, 4, 4, 4, 4, 4, 4}},       {'U', {17, 17, 17, 17, 17, 17, 14}},
    {'V', {17, 17, 17, 17, 17, 10, 4}},  {'W', {17, 17, 17, 21, 21, 27, 17}}, {'X', {17, 17, 10, 4, 10, 17, 17}},
    {'Y', {17, 17, 10, 4, 4, 4, 4}},     {'Z', {31, 1, 2, 4, 8, 16, 31}},     {'0', {14, 17, 19, 21, 25, 17, 14}},
    {'1', {4, 12, 4, 4, 4, 4, 14}},      {'2', {14, 17, 1, 6, 8, 16, 31}},    {'3', {30, 1, 1, 14, 1, 1, 30}},
    {'4', {2, 6, 10, 18, 31, 2, 2}},     {'5', {31, 16, 30, 1, 1, 17, 14}},   {'6', {14, 16, 16, 30, 17, 17, 14}},
    {'7', {31, 1, 2, 4, 8, 8, 8}},       {'8', {14, 17, 17, 14, 17, 17, 14}}, {'9', {14, 17, 17, 15, 1, 1, 14}},
    {'-', {0, 0, 0, 31, 0, 0, 0}},       {'.', {0, 0, 0, 0, 0, 12, 12}},      {',', {0, 0, 0, 0, 12, 4, 8}},
    {'_', {0, 0, 0, 0, 0, 0, 31}},       {'\'', {4, 4, 8, 0, 0, 0, 0}},
};

const Glyph* glyph_of(char c) {
    const char upper = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    for (const Glyph& g : kGlyphs)
        if (g.letter == upper) return &g;
    return nullptr;
}

}  // namespace

void draw_label(ImageRgb8& image, std::string_view text, int x, int y, Rgb8 color, int scale) {
    FASTSCENE_CHECK(scale >= 1);
    for (const char c : text) {
        if (const Glyph* glyph = glyph_of(c))
            for (int row = 0; row < kGlyphHeight * scale; ++row)
                for (int column = 0; column < (kGlyphWidth - 1) * scale; ++column) {
                    const bool dot = (glyph->rows[static_cast<std::size_t>(row / scale)] >>
                                      (kGlyphWidth - 2 - column / scale)) &
                                     1;
                    const int px = x + column, py = y + row;
                    if (dot && px >= 0 && py >= 0 && px < image.width && py < image.height) image.at(px, py) = color;
                }
        x += kGlyphWidth * scale;
    }
}

void paste(ImageRgb8& image, const ImageRgb8& part, int x, int y) {
    const int x0 = std::max(0, -x), x1 = std::min(part.width, image.width - x);
    if (x1 <= x0) return;
    for (int row = std::max(0, -y); row < std::min(part.height, image.height - y); ++row)
        std::copy(part.row(row) + x0, part.row(row) + x1, image.row(y + row) + x + x0);
}

}  // namespace fastscene

#include "fastscene/rooms/furniture/lettering.h"

#include <array>
#include <cctype>
#include <utility>

namespace fastscene::furniture {
namespace {

// On a grid 4 wide and 6 high: "x y" of each corner as two digits; '|' lifts the pen.
constexpr std::array<std::pair<char, std::string_view>, 42> kLetters{
    {{'A', "00 26 40|12 32"},
     {'B', "00 06 36 45 44 33 03|33 42 41 30 00"},
     {'C', "45 36 16 05 01 10 30 41"},
     {'D', "00 06 26 44 42 20 00"},
     {'E', "46 06 00 40|03 33"},
     {'F', "46 06 00|03 33"},
     {'G', "45 36 16 05 01 10 30 41 43 23"},
     {'H', "00 06|40 46|03 43"},
     {'I', "20 26"},
     {'J', "46 41 30 10 01"},
     {'K', "00 06|46 03 40"},
     {'L', "06 00 40"},
     {'M', "00 06 23 46 40"},
     {'N', "00 06 40 46"},
     {'O', "16 05 01 10 30 41 45 36 16"},
     {'P', "00 06 36 45 44 33 03"},
     {'Q', "16 05 01 10 30 41 45 36 16|22 40"},
     {'R', "00 06 36 45 44 33 03|23 40"},
     {'S', "45 36 16 05 04 13 33 42 41 30 10 01"},
     {'T', "06 46|26 20"},
     {'U', "06 01 10 30 41 46"},
     {'V', "06 20 46"},
     {'W', "06 10 24 30 46"},
     {'X', "00 46|06 40"},
     {'Y', "06 23 46|23 20"},
     {'Z', "06 46 00 40"},
     {'0', "16 05 01 10 30 41 45 36 16"},
     {'1', "15 26 20"},
     {'2', "05 16 36 45 44 00 40"},
     {'3', "05 16 36 45 44 33 13|33 42 41 30 10 01"},
     {'4', "30 36 02 42"},
     {'5', "46 06 03 33 42 41 30 10 01"},
     {'6', "45 36 16 05 01 10 30 41 42 33 03"},
     {'7', "06 46 10"},
     {'8', "13 04 05 16 36 45 44 33 13 02 01 10 30 41 42 33"},
     {'9', "43 13 04 05 16 36 45 41 30 10 01"},
     {':', "21 22|24 25"},
     {'.', "20 21"},
     {'-', "13 33"},
     {'+', "13 33|22 24"},
     {'/', "00 46"},
     {'\'', "25 26"}}};

constexpr float kGrid = 1.f / 6, kAdvance = 5.6f;  // letters are 4 wide, with a space of 1.6

// Narrow signs take less room.
float advance_of(char c) { return c == 'I' || c == '.' || c == '\'' || c == ' ' || c == '1' ? 3.4f : kAdvance; }

std::string_view lines_of(char c) {
    const char capital = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    for (const auto& [letter, lines] : kLetters)
        if (letter == capital) return lines;
    return {};
}

}  // namespace

std::vector<std::vector<Vec2f>> letter_strokes(std::string_view text, float height) {
    std::vector<std::vector<Vec2f>> out;
    float x = 0;
    for (const char c : text) {
        const float advance = advance_of(c), shift = advance < kAdvance ? -1.1f : 0.f;
        const std::string_view lines = lines_of(c);
        if (!lines.empty()) out.emplace_back();
        for (std::size_t i = 0; i + 1 < lines.size(); i += 3) {
            out.back().push_back(
                Vec2f{x + shift + static_cast<float>(lines[i] - '0'), static_cast<float>(lines[i + 1] - '0')} *
                (kGrid * height));
            if (i + 2 < lines.size() && lines[i + 2] == '|') out.emplace_back();
        }
        x += advance;
    }
    return out;
}

float letters_width(std::string_view text, float height) {
    float x = 0;
    for (const char c : text) x += advance_of(c);
    return text.empty() ? 0.f : (x - 1.6f) * kGrid * height;
}

}  // namespace fastscene::furniture

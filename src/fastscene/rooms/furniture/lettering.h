// Letters as lines, for signs, menus, labels and titles.
#pragma once

#include <string_view>
#include <vector>

#include "fastscene/math/vec.h"

namespace fastscene::furniture {

// The lines of a text in capitals, digits and . : - + / ', which begins at the origin and stands on y = 0. Small
// letters are written as capitals; others are left blank.
std::vector<std::vector<Vec2f>> letter_strokes(std::string_view text, float height);
float letters_width(std::string_view text, float height);

}  // namespace fastscene::furniture

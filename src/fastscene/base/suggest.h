// "Did you mean …": the known word nearest to one that is not known.
#pragma once

#include <string>
#include <vector>

namespace fastscene {

// Empty when nothing known is near.
std::string nearest_word(const std::string& word, const std::vector<std::string>& known);

}  // namespace fastscene

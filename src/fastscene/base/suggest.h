// "Did you mean …": the known word nearest to an unknown one.
#pragma once

#include <string>
#include <vector>

namespace fastscene {

// Empty if no known word is near.
std::string nearest_word(const std::string& word, const std::vector<std::string>& known);

}  // namespace fastscene

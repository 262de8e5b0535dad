// The file of a style: styles/NAME.toml. docs/extend/style.md shows one.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fastscene/rooms/style.h"

namespace fastscene {

// Throws Error naming file, line and key for what is missing, unknown or out of range.
Style read_style(std::string_view text, const std::string& file);

// The words that name styles in a prompt, from `words` of their files: (word, style). The lexicon reads them before
// colors are known, so nothing else of the files is read here.
std::vector<std::pair<std::string, std::string>> style_words();

}  // namespace fastscene

// Sections of the page.
#pragma once

#include <filesystem>
#include <string>

#include "fastscene/base/json.h"

namespace fastscene {

std::string bars_html(const Json& results);
std::string curves_html(const Json& results);
// Every room once, with the results of all rows side by side. `out`: base of the pictures' paths.
std::string scenes_html(const Json& results, const std::filesystem::path& out);

std::string text_of(const Json& json, const char* key);
std::string label_of(const Json& column);  // with its unit

}  // namespace fastscene

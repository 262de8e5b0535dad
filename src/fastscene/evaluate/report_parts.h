// Parts of the page.
#pragma once

#include <filesystem>
#include <string>

#include "fastscene/base/json.h"

namespace fastscene {

std::string bars_html(const Json& results);
std::string curves_html(const Json& results);
// Every room once, with what each row made of it beside each other. `out`: where the pictures' paths start.
std::string scenes_html(const Json& results, const std::filesystem::path& out);

std::string text_of(const Json& json, const char* key);
std::string label_of(const Json& column);  // with its unit

}  // namespace fastscene

// Pictures inside the page.
#pragma once

#include <filesystem>
#include <string>

#include "fastscene/base/json.h"

namespace fastscene {

// A picture (relative to `out`, or absolute) at no more than `width` pixels, as a data address. Reduced once, kept in
// out/measured/thumbnails. Empty when it is not there or cannot be read.
std::string picture_data(const std::filesystem::path& out, const std::filesystem::path& picture, int width);
// The figures of a record (measures.h).
std::string figures_html(const Json& figures, const std::filesystem::path& out);

}  // namespace fastscene

// Pictures embedded in the page.
#pragma once

#include <filesystem>
#include <string>

#include "fastscene/base/json.h"

namespace fastscene {

// A picture (relative to `out`, or absolute) as a data URL, at most `width` pixels wide. Downsampled once, cached in
// out/measured/thumbnails. Empty if it is missing or unreadable.
std::string picture_data(const std::filesystem::path& out, const std::filesystem::path& picture, int width);
// The figures of a record (measures.h).
std::string figures_html(const Json& figures, const std::filesystem::path& out);

}  // namespace fastscene

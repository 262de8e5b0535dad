// Data packed by gzip or zlib.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace fastscene {

// Unpacks a whole stream of either kind. `path` names the data in errors. Throws Error when it is damaged, cut off or
// larger than 256 MiB.
std::string inflated(std::string_view packed, const std::filesystem::path& path);

}  // namespace fastscene

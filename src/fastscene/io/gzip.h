// Decompression of gzip and zlib data.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace fastscene {

// Decompresses a whole stream of either kind. `path` names it in errors. Throws Error if it is damaged, truncated or
// larger than 256 MiB.
std::string inflated(std::string_view packed, const std::filesystem::path& path);

}  // namespace fastscene

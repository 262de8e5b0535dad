#pragma once

#include <filesystem>

namespace fastscene {

// Where a file is written before it is renamed to `path`: beside it, hidden, of this process.
std::filesystem::path temporary_beside(const std::filesystem::path& path);

}  // namespace fastscene

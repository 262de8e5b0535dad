#pragma once

#include <filesystem>

namespace fastscene {

// Where a file is written before it is renamed to `path`: beside it, hidden. Each call gives another name, so that the
// last of several writers of one file wins, whole.
std::filesystem::path temporary_beside(const std::filesystem::path& path);

}  // namespace fastscene

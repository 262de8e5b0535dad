#pragma once

#include <filesystem>

namespace fastscene {

// Throws Error as write_file would if a file of this name cannot be created (no such folder, no permission), without
// side effects: to be called before long work.
void check_writable(const std::filesystem::path& path);

}  // namespace fastscene

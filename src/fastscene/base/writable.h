#pragma once

#include <filesystem>

namespace fastscene {

// Throws Error as write_file would where a file of this name cannot be (no such folder, no permission), and leaves
// nothing: before long work whose result goes there.
void check_writable(const std::filesystem::path& path);

}  // namespace fastscene

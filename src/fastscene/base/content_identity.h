// Files told apart by what they hold, also those too large to be read each time.
#pragma once

#include <filesystem>
#include <string>

namespace fastscene {

// Hash of a file's content, or of all files below a folder with their names. Up to 16 MiB every byte counts; of a
// larger file its size, both ends and 256 places between them, so that a network of gigabytes is told from another in
// milliseconds. Throws Error naming a file that cannot be read.
std::string content_identity(const std::filesystem::path& file_or_folder);

}  // namespace fastscene

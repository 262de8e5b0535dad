// Identity of files by content, also of files too large to be read completely each time.
#pragma once

#include <filesystem>
#include <string>

namespace fastscene {

// Hash of a file's content, or of all files in a folder with their names. Up to 16 MiB all bytes are hashed; of larger
// files the size, both ends and 256 samples in between, so that networks of gigabytes are distinguished in
// milliseconds. Throws Error naming a file that cannot be read.
std::string content_identity(const std::filesystem::path& file_or_folder);

}  // namespace fastscene

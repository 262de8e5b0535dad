// Whole-file I/O. Files are written under a temporary name and renamed, so readers and resumed runs never see partial
// files, and a full disk never destroys existing ones.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace fastscene {

// The whole file as bytes. Throws Error if it cannot be opened or read.
std::string read_file(const std::filesystem::path& path);

// Writes and renames. Throws Error naming the path and the reason (no permission, disk full …).
void write_file(const std::filesystem::path& path, std::string_view bytes);
inline void write_file(const std::filesystem::path& path, std::span<const std::byte> bytes) {
    write_file(path, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

// Streaming variant for large data: make(put) calls put(bytes) repeatedly. Throws as write_file does.
void write_pieces(const std::filesystem::path& path,
                  const std::function<void(const std::function<void(std::string_view bytes)>& put)>& make);

// For writers that need a path (OpenEXR): calls write(temporary path), then renames to `path`.
void write_renamed(const std::filesystem::path& path,
                   const std::function<void(const std::filesystem::path& temporary)>& write);

// Creates the directory and its parents. Throws Error if that is not possible.
void make_directories(const std::filesystem::path& path);

}  // namespace fastscene

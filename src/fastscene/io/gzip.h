// Compression as gzip; decompression of gzip and zlib streams. In pieces: memory grows only with actual data.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace fastscene {

std::string gzipped(std::string_view bytes);

// Decompresses a whole stream of either kind; bytes after it are ignored. `path` names it in errors. `check` sees what
// is decompressed so far, after each piece, and throws to refuse it; without one, more than 256 MiB are refused. Throws
// Error if the stream is damaged or truncated.
using CheckInflated = std::function<void(std::string_view so_far)>;
std::string inflated(std::string_view packed, const std::filesystem::path& path, const CheckInflated& check = {});

}  // namespace fastscene

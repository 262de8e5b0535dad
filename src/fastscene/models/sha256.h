// SHA-256 (FIPS 180-4), by OpenSSL.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace fastscene {

// 64 hexadecimal digits. `heard` receives the number of bytes read so far, and may throw. Throws Error if the file
// cannot be read.
std::string sha256_of_file(const std::filesystem::path& file, const std::function<void(std::size_t)>& heard = {});

}  // namespace fastscene

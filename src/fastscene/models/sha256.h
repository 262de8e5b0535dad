// SHA-256 (FIPS 180-4), by OpenSSL.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace fastscene {

// 64 hexadecimal digits of a file's bytes. `heard` is told how many were read so far, and may throw. Throws Error when
// it cannot be read.
std::string sha256_of_file(const std::filesystem::path& file, const std::function<void(std::size_t)>& heard = {});

}  // namespace fastscene

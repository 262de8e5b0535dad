// NumPy's .npy of whole numbers: one value per splat.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace fastscene {

// Version 1.0, one dimension, little endian 16 bits ("<u2").
std::string npy_bytes(std::span<const std::uint16_t> values);
// Reads that. Throws Error naming the file, what was expected and found.
std::vector<std::uint16_t> load_npy(const std::filesystem::path& path);

}  // namespace fastscene

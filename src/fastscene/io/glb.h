// Reads glTF binary with KHR_gaussian_splatting. Private to io/; the public interface is splat_io.h.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "fastscene/io/splat_format.h"

namespace fastscene {

inline constexpr std::uint32_t kGlbMagic = 0x46546c67, kJsonChunk = 0x4e4f534a, kBinaryChunk = 0x004e4942;

bool is_glb(std::string_view bytes);
ReadSplats splats_of_glb(const std::filesystem::path& path, std::string_view bytes);

}  // namespace fastscene

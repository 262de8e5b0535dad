// Reads Niantic's SPZ. Private to io/; the public interface is splat_io.h.
#pragma once

#include <filesystem>
#include <string_view>

#include "fastscene/scene/splats.h"

namespace fastscene {

inline constexpr std::uint32_t kSpzMagic = 0x5053474e;  // "NGSP" in the file
bool is_spz(std::string_view bytes);
Splats splats_of_spz(const std::filesystem::path& path, std::string_view bytes);

}  // namespace fastscene

// Reads Niantic's SPZ. Private to io/; the public interface is splat_io.h.
#pragma once

#include <filesystem>
#include <string_view>

#include "fastscene/io/splat_format.h"

namespace fastscene {

inline constexpr std::uint32_t kSpzMagic = 0x5053474e;  // "NGSP" in the file
bool is_spz(std::string_view bytes);
ReadSplats splats_of_spz(const std::filesystem::path& path, std::string_view bytes);
// The numbers as they are stored, in axes of the container's choice, as glTF files hold them.
ReadSplats stored_splats_of_spz(const std::filesystem::path& path, std::string_view bytes);

}  // namespace fastscene

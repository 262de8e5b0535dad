// glTF binary with KHR_gaussian_splatting, read. Private to io/; splat_io.h is the door.
#pragma once

#include <filesystem>
#include <string_view>

#include "fastscene/scene/splats.h"

namespace fastscene {

bool is_glb(std::string_view bytes);
Splats splats_of_glb(const std::filesystem::path& path, std::string_view bytes);

}  // namespace fastscene

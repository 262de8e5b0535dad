// COLMAP's sparse model, text and binary. Private to io/; the public interface is view_io.h.
#pragma once

#include <filesystem>
#include <vector>

#include "fastscene/scene/view.h"

namespace fastscene {

void save_colmap(const std::filesystem::path& dir, const ViewSet& set);
// Cameras, poses and names from cameras.bin and images.bin, without pictures.
std::vector<View> load_colmap_views(const std::filesystem::path& dir);

}  // namespace fastscene

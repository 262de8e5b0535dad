// COLMAP's sparse model, text and binary. Private to io/; view_io.h is the door.
#pragma once

#include <filesystem>
#include <vector>

#include "fastscene/scene/view.h"

namespace fastscene {

void save_colmap(const std::filesystem::path& dir, const ViewSet& set);
// Cameras, poses and names from cameras.bin and images.bin; no pictures.
std::vector<View> load_colmap_views(const std::filesystem::path& dir);

}  // namespace fastscene

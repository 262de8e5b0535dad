// View files: COLMAP's sparse model (text and binary), nerfstudio's transforms.json, points.
#pragma once

#include <filesystem>

#include "fastscene/scene/view.h"

namespace fastscene {

// Writes DIR/images/*.png, DIR/weights/*.png (only for views with weights),
// DIR/sparse/0/{cameras,images,points3D}.{txt,bin}, DIR/sparse/0/points3D.ply (with nx ny nz; radii in an additional
// element) and DIR/transforms.json. Deterministic.
void save_views(const std::filesystem::path& dir, const ViewSet& views);
// Only cameras and points, as DIR/{cameras,images,points3D}.{txt,bin}.
void save_views_model(const std::filesystem::path& dir, const ViewSet& views);
// Reads what save_views wrote (from the binary model and points3D.ply).
ViewSet load_views(const std::filesystem::path& dir);

}  // namespace fastscene

// viewer.html: one self-contained file that shows the splats in any browser, from disk, without a network.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "fastscene/image/image.h"
#include "fastscene/scene/splats.h"
#include "fastscene/scene/walkable.h"

namespace fastscene {

struct ViewerScene {
    std::string title;
    Vec3f camera_position_m;  // world frame; where the visitor stands first
    Vec3f camera_target_m;    // world frame; what he looks at
    float fov_deg = 75;
    // Where the visitor's eyes stay: he walks level and slides along the boundary. None: he flies freely.
    std::optional<WalkableArea> walkable = {};
};
// The settings JSON of @playcanvas/supersplat-viewer (schema 2), cameras turned into the viewer's frame (-x, -y, z).
std::string viewer_settings(const ViewerScene& scene);
// The page with the scene, the viewer and, with a walkable area, web/walk_bounds.mjs in it. `viewer_dir` holds the
// package's index.html, index.css and index.js.
void save_viewer_html(const std::filesystem::path& path, const Splats& splats, const ViewerScene& scene,
                      const std::filesystem::path& viewer_dir);

}  // namespace fastscene

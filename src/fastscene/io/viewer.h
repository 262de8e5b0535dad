// viewer.html: a self-contained page that shows the splats in any browser, from disk, without network.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "fastscene/image/image.h"
#include "fastscene/scene/camera_path.h"
#include "fastscene/scene/splats.h"
#include "fastscene/scene/walkable.h"

namespace fastscene {

struct ViewerScene {
    std::string title;
    Vec3f camera_position_m;  // world frame; initial position
    Vec3f camera_target_m;    // world frame; initial look-at point
    float fov_deg = 75;
    // Limits of the visitor's position: walks level and slides along the boundary. Empty: free flight.
    std::optional<WalkableArea> walkable = {};
    // What the play button shows. Empty: the viewer's own, a gentle sway.
    std::optional<CameraPath> tour = {};
};
// Settings JSON of @playcanvas/supersplat-viewer (schema 2), with cameras in the viewer's frame (-x, -y, z).
std::string viewer_settings(const ViewerScene& scene);
// Writes the page with the scene, the viewer and, with a walkable area, web/walk_bounds.mjs. `viewer_dir` holds the
// package's index.html, index.css and index.js.
void save_viewer_html(const std::filesystem::path& path, const Splats& splats, const ViewerScene& scene,
                      const std::filesystem::path& viewer_dir);

}  // namespace fastscene

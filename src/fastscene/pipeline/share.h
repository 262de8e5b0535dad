// The shareable results of a run: a web page to walk through the scene, a preview picture, and credits.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "fastscene/base/run.h"
#include "fastscene/geometry/pinhole.h"
#include "fastscene/image/image.h"
#include "fastscene/io/viewer.h"
#include "fastscene/pipeline/run_folder.h"
#include "fastscene/scene/camera_path.h"
#include "fastscene/scene/splats.h"
#include "fastscene/scene/walkable.h"

namespace fastscene {

// Renders the splats to an 8-bit picture on black.
ImageRgb8 picture_of(const Splats& splats, const Pinhole& camera, const Rigid& world_from_camera);

// The folder of the viewer page: $FASTSCENE_VIEWER_DIR, or supersplat-viewer/public among the data files
// (base/data_files.h). Empty if neither has one.
std::optional<std::filesystem::path> find_viewer_dir();
// How to install it, as a sentence for users.
std::string viewer_remedy();

// A camera and where it stands.
struct PictureCamera {
    Pinhole lens;
    Rigid world_from_camera;
};
// The view that preview.jpg shows, of the size given: the room at its best from panorama 0.
PictureCamera preview_camera(const RunFolder& folder, int width, int height);

// What the viewer shows of a run, with a tour where the room is known.
ViewerScene viewer_scene(const RunFolder& folder, const std::string& title, const Run& run);

// Writes credits.txt for the panorama's contents, if a run ends before there is a scene to share.
void write_credits(const RunFolder& folder);
// Writes viewer.html, preview.jpg and credits.txt. A missing viewer is only a warning.
void share_scene(const RunFolder& folder, const std::string& title, const Run& run);
// The same for splats of photographs, from splat/viewer.compressed.ply and viewer.json.
void share_capture(const RunFolder& folder, const std::string& title, const Run& run);

// The walkable area; empty if the walk recorded none.
std::optional<WalkableArea> walkable_in(const RunFolder& folder);

// A visitor's initial view of a capture; empty for other folders.
struct FirstGlance {
    Vec3f position_m, forward;
    float fov_deg = 75;
};
std::optional<FirstGlance> first_glance_of_capture(const RunFolder& folder);

}  // namespace fastscene

// What a run leaves for people: a page to walk through the scene, a picture of it, and who is to be thanked.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "fastscene/base/run.h"
#include "fastscene/geometry/pinhole.h"
#include "fastscene/image/image.h"
#include "fastscene/pipeline/run_folder.h"
#include "fastscene/scene/splats.h"
#include "fastscene/scene/walkable.h"

namespace fastscene {

// Yaw turns right about the world's down axis, pitch looks up; no roll.
Rigid world_from_camera_at(Vec3f position_m, float yaw_deg, float pitch_deg);
// The splats as an 8-bit picture on black.
ImageRgb8 picture_of(const Splats& splats, const Pinhole& camera, const Rigid& world_from_camera);

// The folder of the viewer's page: $FASTSCENE_VIEWER_DIR, or supersplat-viewer/public among the data files
// (base/data_files.h). Absent where neither holds one.
std::optional<std::filesystem::path> find_viewer_dir();
// How to get it, as a sentence for people.
std::string viewer_remedy();

// Writes credits.txt of what the panorama shows, for a stream that ends before there is a scene to share.
void write_credits(const RunFolder& folder);
// Writes viewer.html, preview.jpg and credits.txt. A missing viewer is a warning: the scene is not lost for it.
void share_scene(const RunFolder& folder, const std::string& title, const Run& run);
// The same for splats of photographs, from splat/viewer.compressed.ply and viewer.json.
void share_capture(const RunFolder& folder, const std::string& title, const Run& run);

// Where a visitor may walk; absent in a folder whose walk did not say.
std::optional<WalkableArea> walkable_in(const RunFolder& folder);

// Where a visitor of a capture stands first; absent in a folder that is none.
struct FirstGlance {
    Vec3f position_m, forward;
    float fov_deg = 75;
};
std::optional<FirstGlance> first_glance_of_capture(const RunFolder& folder);

}  // namespace fastscene

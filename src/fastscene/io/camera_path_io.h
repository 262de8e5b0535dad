// Camera paths as files: our own JSON, and those of nerfstudio, Blender and SuperSplat, with their axes.
//
// fastscene (.json): {"fps": 30, "fov_deg": 75, "size": [1280, 720], "keys": [{"time_s": 0, "position_m": [0, 0, 0],
//   "yaw_deg": 0, "pitch_deg": 0}, …]}; a key may have roll_deg and fov_deg. World axes.
// nerfstudio (.json): camera_path, a pose a frame, camera to world in OpenGL's axes, in the world of our
// transforms.json. blender (.chan): a line a frame: number, place, Euler angles XYZ in degrees, vertical angle; y up,
// in the frame of our
//   GLB files, so that path and room agree in Blender. Read by its add-on "Nuke Animation Format (.chan)".
// supersplat (.json): the viewer's settings with a camera track (animTracks), or an editor document's poseSets.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "fastscene/base/json.h"
#include "fastscene/scene/camera_path.h"

namespace fastscene {

enum class PathFormat { fastscene, nerfstudio, blender, supersplat };
inline constexpr std::string_view kPathFormats[] = {"fastscene", "nerfstudio", "blender", "supersplat"};

// The format is known by the content. `otherwise` gives fps, angle and size where a file has none. Throws Error naming
// the file and the problem.
CameraPath load_camera_path(const std::filesystem::path& path, const CameraPath& otherwise = {});
// The same of a file's text, for JSON formats or Blender's lines.
CameraPath read_camera_path(const std::string& text, const CameraPath& otherwise, const std::string& where);
// Our own format.
Json camera_path_json(const CameraPath& camera);
// Our own format keeps the keys; the others get a pose a frame.
void save_camera_path(const std::filesystem::path& path, const CameraPath& camera, PathFormat format);
// blender for .chan, else fastscene.
PathFormat path_format_of(const std::filesystem::path& path);

}  // namespace fastscene

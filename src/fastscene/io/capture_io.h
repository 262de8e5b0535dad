// Captures in files: COLMAP's sparse model, text or binary, and nerfstudio's transforms.json (also NeRF's and
// Blender's).
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "fastscene/scene/capture.h"

namespace fastscene {

struct CaptureFolders {
    std::filesystem::path images;  // empty: the format's own
    std::filesystem::path masks;   // empty: DIR/masks where there is one
    int downscale = 1;             // 2, 4, 8: takes images_2 … where there is such a folder
};

// DIR holds images/ and the model in sparse/0, sparse or itself. Throws Error naming the file, the byte or line, what
// was expected and found; pictures are not opened.
Capture load_colmap_capture(const std::filesystem::path& dir, const CaptureFolders& folders);
// A transforms.json, or the folder that holds one (or NeRF's transforms_train.json). Its cameras look along -z with y
// up; here they look along z with y down. Poses and points are taken as they are: nerfstudio has applied its
// applied_transform to both.
Capture load_nerfstudio_capture(const std::filesystem::path& file, const CaptureFolders& folders);

// Cameras, poses and names of a model alone: text or binary, in exactly this folder.
Capture load_colmap_model(const std::filesystem::path& model);
// Where a capture's folder keeps its model: sparse/0, sparse, colmap/sparse/0 or the folder itself. Absent: nowhere.
std::optional<std::filesystem::path> colmap_model_in(const std::filesystem::path& dir);
// cameras.json of INRIA's trainer, principal points in the middle. Reading throws Error naming the file and the camera.
void save_cameras_json(const std::filesystem::path& path, const std::vector<Photo>& photos);
Capture load_cameras_json(const std::filesystem::path& path);
// Whether the folder holds cameras and images, as .bin or .txt.
bool is_colmap_model(const std::filesystem::path& dir);

}  // namespace fastscene

// Capture files: photographs with cameras, as reconstruction programs write them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fastscene/scene/capture.h"

namespace fastscene {

struct CaptureFolders {
    std::filesystem::path images;  // empty: the format's default
    std::filesystem::path masks;   // empty: DIR/masks if it exists
    int downscale = 1;             // 2, 4, 8: uses images_2 … if such a folder exists
    std::filesystem::path points;  // a .ply of points, instead of the capture's own; empty: none
};

// DIR holds images/ and the model in sparse/0, sparse or DIR itself. Throws Error naming the file, the byte or line,
// expected and actual; does not open pictures.
Capture load_colmap_capture(const std::filesystem::path& dir, const CaptureFolders& folders);
// A transforms.json, or the folder that contains one (or NeRF's transforms_train.json). Its cameras look along -z with
// y up; converted to z forward, y down. Poses and points are used as stored: nerfstudio has applied its
// applied_transform to both.
Capture load_nerfstudio_capture(const std::filesystem::path& file, const CaptureFolders& folders);

// RealityScan's (RealityCapture's) CSV of cameras; pictures lie in images/ beside it, or beside it.
Capture load_realityscan_capture(const std::filesystem::path& file, const CaptureFolders& folders);
// Metashape's XML of cameras; pictures as above.
Capture load_metashape_capture(const std::filesystem::path& file, const CaptureFolders& folders);
// The folder of Polycam's raw data, with keyframes/.
Capture load_polycam_capture(const std::filesystem::path& dir, const CaptureFolders& folders);

// The kinds of captures. All of their readers throw Error naming the file, expected and actual; do not open pictures,
// except their headers; and take the offset out of georeferenced captures (Capture::offset).
struct CaptureKind {
    const char* name;      // its flag, without dashes
    const char* type;      // what the flag takes: FILE or DIR
    const char* sentence;  // of --help
    Capture (*load)(const std::filesystem::path& source, const CaptureFolders& folders);
};
const std::vector<CaptureKind>& capture_kinds();
// Throws Error if there is none of that name.
const CaptureKind& capture_kind(const std::string& name);

// Only cameras, poses and names of a model, text or binary, in exactly this folder.
Capture load_colmap_model(const std::filesystem::path& model);
// Where a capture's folder keeps its model: sparse/0, sparse, colmap/sparse/0 or the folder itself. Empty if there is
// none.
std::optional<std::filesystem::path> colmap_model_in(const std::filesystem::path& dir);
// cameras.json of INRIA's trainer, which has centered principal points. Reading throws Error naming the file and the
// camera.
void save_cameras_json(const std::filesystem::path& path, const std::vector<Photo>& photos);
Capture load_cameras_json(const std::filesystem::path& path);
// Whether the folder contains cameras and images, as .bin or .txt.
bool is_colmap_model(const std::filesystem::path& dir);

}  // namespace fastscene

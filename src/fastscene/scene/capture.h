// Capture: photographs of a place with their cameras, as exported by reconstruction programs. Pictures are not loaded
// yet, lenses may have distortion, and the world's units and axes are the program's.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fastscene/geometry/lens.h"
#include "fastscene/scene/view.h"

namespace fastscene {

struct Photo {
    std::string name;            // as in the model, including folders
    std::filesystem::path file;  // the picture
    std::filesystem::path mask;  // gray, white = use; empty: none
    Lens lens;
    Rigidd world_from_camera;  // double: such worlds may be far from their origin
};
struct CapturePoint {
    Vec3d position;
    Rgb8 color;
};
struct Capture {
    std::string source;         // for messages
    std::vector<Photo> photos;  // sorted by name
    std::vector<CapturePoint> points;
    std::filesystem::path missing_points;  // a points file that should exist but does not
    std::vector<std::string> warnings;     // to be shown to the user
    Vec3d offset;  // what was subtracted from all positions of a capture far from its origin (georeferenced)
};

}  // namespace fastscene

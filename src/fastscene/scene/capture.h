// Capture: photographs of a place with their cameras, as reconstruction programs leave them. Nothing is loaded yet:
// pictures are named, lenses may be bent, units and axes of the world are those of the program.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fastscene/geometry/lens.h"
#include "fastscene/scene/view.h"

namespace fastscene {

struct Photo {
    std::string name;            // as the model has it, with its folders
    std::filesystem::path file;  // the picture
    std::filesystem::path mask;  // gray, white = counts; empty: none
    Lens lens;
    Rigidd world_from_camera;  // double: such worlds may lie far from their origin
};
struct CapturePoint {
    Vec3d position;
    Rgb8 color;
};
struct Capture {
    std::string source;         // for messages
    std::vector<Photo> photos;  // sorted by name
    std::vector<CapturePoint> points;
    std::filesystem::path missing_points;  // a file that should have held them and is not there
    std::string warning;                   // what its user should hear; empty: nothing
};

}  // namespace fastscene

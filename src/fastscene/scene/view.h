// Views: perspective pictures with exactly known cameras, and the points the splats start from.
#pragma once

#include <string>
#include <vector>

#include "fastscene/geometry/pinhole.h"
#include "fastscene/image/image.h"
#include "fastscene/math/rigid.h"

namespace fastscene {

// What a picture's pixels mean: `pinhole` is geometry/pinhole.h; `equirectangular` (geometry/sphere.h) needs of
// `camera` only width and height.
enum class CameraModel { pinhole, equirectangular };

struct View {
    std::string name;  // file name in views/images/, without the folder
    Pinhole camera;
    Rigid world_from_camera;
    ImageRgb8 color;   // sRGB, as in the file
    ImageMask weight;  // how much each pixel counts in training, 255 = fully; empty = all fully
    CameraModel model = CameraModel::pinhole;
};

// One surface sample. `radius_m` is the spacing to its neighbours on the surface.
struct SurfacePoint {
    Vec3f position_m;  // world
    Vec3f normal;      // world, unit, towards the viewpoint that saw it; zero = unknown
    Rgb8 color;
    float radius_m = 0;
};

struct ViewSet {
    std::vector<View> views;
    std::vector<SurfacePoint> points;
};

}  // namespace fastscene

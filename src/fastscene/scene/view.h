// Views: perspective pictures with exactly known cameras, and the initial points of the splats.
#pragma once

#include <string>
#include <vector>

#include "fastscene/geometry/pinhole.h"
#include "fastscene/image/image.h"
#include "fastscene/math/rigid.h"

namespace fastscene {

// The projection of a view: `pinhole` (geometry/pinhole.h), or `equirectangular` (geometry/sphere.h), which uses only
// width and height of `camera`.
enum class CameraModel { pinhole, equirectangular };

struct View {
    std::string name;  // file name in views/images/, without the folder
    Pinhole camera;
    Rigid world_from_camera;
    ImageRgb8 color;   // sRGB, as in the file
    ImageMask weight;  // training weight of each pixel, 255 = full; empty = all full
    CameraModel model = CameraModel::pinhole;
};

// A surface sample. `radius_m` is its spacing to neighbouring samples.
struct SurfacePoint {
    Vec3f position_m;  // world
    Vec3f normal;      // world, unit, facing the viewpoint that saw it; zero = unknown
    Rgb8 color;
    float radius_m = 0;
    // world: a tangent along which the color changes least; its length, 0..1, tells how much less than across. Zero: no
    // preferred direction, or unknown
    Vec3f edge{};
};

struct ViewSet {
    std::vector<View> views;
    std::vector<SurfacePoint> points;
};

}  // namespace fastscene

#include "fastscene/dataset/range_points.h"

#include <algorithm>
#include <cmath>

#include "fastscene/image/encoded_maps.h"
#include "fastscene/io/image_io.h"

namespace fastscene::dataset {

Image<std::uint16_t> depth_millimetres(const DataSet& set, const SetPicture& picture) {
    ImageF range = load_float(set.file(picture, "range"), 0.001f);
    const Camera camera = set.camera(picture);
    if (!camera.panorama)
        for (int y = 0; y < range.height; ++y)
            for (int x = 0; x < range.width; ++x) range.at(x, y) *= camera.ray(x, y).z;
    return millimetres(range);
}

std::vector<SurfacePoint> range_points(const DataSet& set, const SetPicture& picture, int count) {
    const ImageF range = load_float(set.file(picture, "range"), 0.001f);
    const ImageRgb8 color = load_rgb8(set.file(picture, "color"));
    const Camera camera = set.camera(picture);
    const int step = std::max(
        1, static_cast<int>(std::sqrt(static_cast<double>(range.size()) / static_cast<double>(count))));
    std::vector<SurfacePoint> out;
    for (int y = step / 2; y < range.height; y += step)
        for (int x = step / 2; x < range.width; x += step)
            if (const float r = range.at(x, y); r > 0)
                out.push_back({camera.world_from_camera * (camera.ray(x, y) * r), {}, color.at(x, y), 0});
    return out;
}

}  // namespace fastscene::dataset

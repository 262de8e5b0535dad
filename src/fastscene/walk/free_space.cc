#include "fastscene/walk/free_space.h"

#include <algorithm>

namespace fastscene {

float free_distance(const ImageF& range, Vec3f direction, float cone_cosine) {
    const EquirectSize size{range.width, range.height};
    const int step = std::max(1, size.width / 512);
    // The pixel straight ahead always counts, however coarse the picture.
    const Vec2f at = pixel_of_direction(direction, size);
    float least = range.at(wrap_column(static_cast<int>(at.x), size.width),
                           std::min(static_cast<int>(at.y), size.height - 1));
    for (int y = 0; y < size.height; y += step)
        for (int x = 0; x < size.width; x += step)
            if (dot(direction_of_pixel(x, y, size), direction) > cone_cosine) least = std::min(least, range.at(x, y));
    return least;
}

}  // namespace fastscene

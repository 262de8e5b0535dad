#include "fastscene/splat/coarse.h"

#include <array>

namespace fastscene::splat {

View half_view(const View& view) {
    constexpr int kLeast = 16;
    const int width = view.color.width / 2, height = view.color.height / 2;
    const bool odd = view.color.width % 2 != 0 || view.color.height % 2 != 0;
    if (width < kLeast || height < kLeast || (odd && view.model == CameraModel::equirectangular)) return view;
    const Pinhole& c = view.camera;
    View out{view.name,
             {width, height, c.fx / 2, c.fy / 2, c.cx / 2, c.cy / 2},
             view.world_from_camera,
             ImageRgb8(width, height),
             {},
             view.model};
    if (!view.weight.empty()) out.weight = ImageMask(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            std::array<int, 3> sum{};
            int weights = 0;
            for (int k = 0; k < 4; ++k) {
                const int fx = 2 * x + k % 2, fy = 2 * y + k / 2,
                          weight = view.weight.empty() ? 255 : view.weight.at(fx, fy);
                const Rgb8 p = view.color.at(fx, fy);
                sum[0] += weight * p.r, sum[1] += weight * p.g, sum[2] += weight * p.b, weights += weight;
            }
            const auto mean = [&](int s) {
                return static_cast<std::uint8_t>(weights > 0 ? (s + weights / 2) / weights : 0);
            };
            out.color.at(x, y) = {mean(sum[0]), mean(sum[1]), mean(sum[2])};
            if (!out.weight.empty()) out.weight.at(x, y) = static_cast<std::uint8_t>((weights + 2) / 4);
        }
    return out;
}

}  // namespace fastscene::splat

// Supersampling: downscaled pictures must average all source pixels.
#pragma once

#include <algorithm>
#include <cmath>

#include "fastscene/base/parallel.h"
#include "fastscene/image/image.h"

namespace fastscene {

// Samples per pixel side such that they are no farther apart than the source's pixels (angles in radians).
inline int samples_a_side(double target_angle, double source_angle) {
    return std::clamp(static_cast<int>(std::ceil(target_angle / source_angle - 0.05)), 1, 64);
}

// Averages n x n samples per pixel: sample(picture point) -> color.
template <class Sample>
ImageColor averaged(int width, int height, int n, const Sample& sample) {
    ImageColor out(width, height);
    const float step = 1.f / static_cast<float>(n);
    parallel_for(height, 8, [&](std::int64_t begin, std::int64_t end) {
        for (int y = static_cast<int>(begin); y < end; ++y)
            for (int x = 0; x < width; ++x) {
                Vec3f sum;
                for (int j = 0; j < n; ++j)
                    for (int i = 0; i < n; ++i)
                        sum += sample(Vec2f{static_cast<float>(x) + (static_cast<float>(i) + 0.5f) * step,
                                            static_cast<float>(y) + (static_cast<float>(j) + 0.5f) * step});
                out.at(x, y) = sum * (step * step);
            }
    });
    return out;
}

}  // namespace fastscene

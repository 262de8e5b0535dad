#include "fastscene/splat/splat.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "fastscene/base/random.h"
#include "fastscene/geometry/sphere.h"

namespace fastscene {
namespace {

// A ball of small opaque splats of random colors around the camera, each about as wide as a pixel of a 256 column
// panorama.
Splats speckled_ball() {
    constexpr EquirectSize kGrid{256, 128};
    Splats out;
    out.resize(static_cast<std::size_t>(kGrid.width) * kGrid.height);
    for (int y = 0; y < kGrid.height; ++y)
        for (int x = 0; x < kGrid.width; ++x) {
            const auto i = static_cast<std::size_t>(y * kGrid.width + x);
            Random random(4, "speckled ball", i);
            out.mean_m[i] = direction_of_pixel(x, y, kGrid) * 2.f;
            const float sigma = std::log(0.5f * 2.f * 6.2832f / kGrid.width);
            out.log_scale[i] = {sigma, sigma, sigma};
            out.opacity_logit[i] = 4;
            const float gray = random.chance(0.5f) ? 0.9f : 0.1f;
            out.sh0[i] = (Vec3f{gray, gray, gray} - Vec3f{0.5f, 0.5f, 0.5f}) / kSh0;
        }
    return out;
}

// Splats are never drawn narrower than a pixel, so a coarse panorama must be supersampled: it equals the downsampled
// panorama of four times the width.
TEST(Still, ACoarseSphereIsTheMeanOfAFineOne) {
    const Splats splats = speckled_ball();
    constexpr int kWidth = 192, kTimes = 4;
    const ImageRgb8 coarse = sphere_of(splats, kWidth, {}).color, fine = sphere_of(splats, kTimes * kWidth, {}).color;
    double squares = 0;
    for (int y = 0; y < coarse.height; ++y)
        for (int x = 0; x < coarse.width; ++x) {
            double mean = 0;
            for (int j = 0; j < kTimes; ++j)
                for (int i = 0; i < kTimes; ++i)
                    mean += fine.at(kTimes * x + i, kTimes * y + j).g / static_cast<double>(kTimes * kTimes);
            squares += (coarse.at(x, y).g - mean) * (coarse.at(x, y).g - mean);
        }
    const double rms = std::sqrt(squares / static_cast<double>(coarse.size()));
    RecordProperty("rms", fmt::format("{:.2f}", rms));
    EXPECT_LT(rms, 12);
}

}  // namespace
}  // namespace fastscene

// Holes that no plane explains are filled however narrow they are.
#include "fastscene/walk/complete.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace fastscene {
namespace {

constexpr float kSky = std::numeric_limits<float>::infinity();

// A wall two metres away, with the outside to its right.
CoarseView half_outside(int width, int height) {
    CoarseView view{ImageColor(width, height, Vec3f{0.8f, 0.2f, 0.2f}), ImageF(width, height, 2.f),
                    Image<std::int16_t>(width, height, kNoPlane), Image<Cover>(width, height, Cover::front)};
    for (int y = 0; y < height; ++y)
        for (int x = width / 2; x < width - width / 8; ++x)
            view.color.at(x, y) = {0.1f, 0.2f, 0.9f}, view.range.at(x, y) = kSky;
    return view;
}

struct Filled {
    CoarseView view;
    ImageMask hole;
    WalkWorld world;
};
Filled filled(int width, int height, const std::vector<std::pair<int, int>>& columns) {
    Filled out{half_outside(width, height), ImageMask(width, height), {}};
    const std::unique_ptr<Inpainter> inpainter = make_inpainter("harmonic");
    out.world.first_range = ImageF(width, height, 2.f);
    out.world.outside = ImageColor(width, height, Vec3f{0.1f, 0.2f, 0.9f});
    out.world.inpainter = inpainter.get();
    for (const auto& [from, to] : columns)
        for (int y = height / 4; y < height * 3 / 4; ++y)
            for (int x = from; x < to; ++x) {
                out.hole.at(x, y) = 1;
                out.view.cover.at(x, y) = Cover::hole, out.view.color.at(x, y) = {}, out.view.range.at(x, y) = kSky;
            }
    complete_holes(out.view, out.hole, {0.1f, 0, 0}, out.world, {});
    return out;
}

TEST(Complete, HolesNarrowerThanAFacesPixelAreFilled) {
    for (int at = 3; at < 60; at += 4) {  // a single column: a face whose pixels miss it must still be processed
        const Filled f = filled(256, 128, {{at, at + 1}});
        for (std::size_t i = 0; i < f.hole.size(); ++i)
            if (f.hole.pixels[i]) {
                ASSERT_NEAR(f.view.color.pixels[i].x, 0.8f, 0.02f) << at;
                ASSERT_NEAR(f.view.range.pixels[i], 2.f, 0.02f) << at;
            }
    }
}

}  // namespace
}  // namespace fastscene

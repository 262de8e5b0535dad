// Edges of pictures on surfaces: physics first, a stripe's direction is known.
#include "fastscene/views/edge.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fastscene/base/random.h"

namespace fastscene {
namespace {

// A step from dark to bright across the line through the middle with the given normal, three pixels wide.
ImageColor step_picture(Vec2f normal) {
    ImageColor out(32, 32);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) {
            const float off = (static_cast<float>(x) - 16) * normal.x + (static_cast<float>(y) - 16) * normal.y;
            const float v = 0.2f + 0.5f * std::clamp(off / 3 + 0.5f, 0.f, 1.f);
            out.at(x, y) = {v, v, v};
        }
    return out;
}

TEST(Edge, RunsAlongAStepOnASurfaceSeenFromAnyDirection) {
    // Tangents of surfaces seen from in front, at a slant (a row covers three times as much), and sheared.
    const struct {
        Vec3f across, down;
    } surfaces[] = {{{0.01f, 0, 0}, {0, 0.01f, 0}}, {{0.01f, 0, 0}, {0, 0, 0.03f}}, {{0.01f, 0, 0}, {0.01f, 0.02f, 0}}};
    for (const auto& [across, down] : surfaces)
        for (const float angle : {0.f, 0.4f, 1.1f, 1.5708f, 2.4f}) {
            const Vec2f normal{std::cos(angle), std::sin(angle)};
            const Vec3f edge = edge_at(step_picture(normal), 16, 16, normalize(cross(across, down)), across, down);
            const Vec3f expected = normalize(across * -normal.y + down * normal.x);
            EXPECT_GT(std::fabs(dot(normalize(edge), expected)), 0.99f) << angle;
            EXPECT_GT(length(edge), 0.8f) << angle;
            EXPECT_LE(length(edge), 1.f);
        }
}

TEST(Edge, OfAnEvenSurfaceAndOfFaintNoiseIsShort) {
    ImageColor even(32, 32, {0.5f, 0.5f, 0.5f}), noisy = even;
    for (std::size_t i = 0; i < noisy.size(); ++i)
        noisy.pixels[i] = noisy.pixels[i] * (1 + 0.003f * Random(1, "noise", i).normal());
    const Vec3f across{0.01f, 0, 0}, down{0, 0.01f, 0}, normal{0, 0, 1};
    EXPECT_EQ(edge_at(even, 16, 16, normal, across, down), Vec3f{});
    for (int x = 4; x < 28; ++x) EXPECT_LT(length(edge_at(noisy, x, 16, normal, across, down)), 0.1f);
    // Nothing is known of a surface that is seen from its side.
    EXPECT_EQ(edge_at(step_picture({1, 0}), 16, 16, normal, across, {}), Vec3f{});
}

}  // namespace
}  // namespace fastscene

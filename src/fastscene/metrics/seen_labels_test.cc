#include "fastscene/metrics/seen_labels.h"

#include <gtest/gtest.h>

namespace fastscene {
namespace {

// Opaque flat splats side by side, 2 m ahead: the left ones have one label, the right ones another; the sky a third.
TEST(SeenLabels, AreThoseInFront) {
    Splats splats;
    std::vector<std::uint16_t> labels;
    const auto add = [&](Vec3f p, std::uint16_t label) {
        splats.mean_m.push_back(p);
        splats.log_scale.push_back({-3, -3, -5});
        splats.rotation.push_back({1, 0, 0, 0});
        splats.opacity_logit.push_back(6);
        splats.sh0.push_back({});
        labels.push_back(label);
    };
    for (int j = -20; j < 20; ++j)
        for (int i = -20; i < 20; ++i) {
            const float x = 0.1f * (static_cast<float>(i) + 0.5f), y = 0.1f * static_cast<float>(j);
            if (y < 1.05f) add({x, y, 2}, x < 0 ? 7 : 4);
            add({1.5f * x, 1.5f * y, 3}, 9);  // behind
        }
    splats.sh_degree = 0;
    const Pinhole camera = Pinhole::with_fov(32, 32, 70);
    const auto seen = seen_labels(splats, labels, {{camera, {}}}, {}, {});
    ASSERT_EQ(seen.size(), 1u);
    EXPECT_EQ(seen[0].at(4, 8), 7);
    EXPECT_EQ(seen[0].at(27, 8), 4);
    EXPECT_EQ(seen[0].at(4, 30), 9) << "below the front";
    EXPECT_EQ(seen_labels(splats, labels, {{camera, {rotation_about(Vec3f{0, 1, 0}, kPi), {}}}}, {}, {})[0].at(9, 9), 0)
        << "nothing is there";
    Image<std::uint16_t> other = seen[0];
    other.at(0, 0) = 2;
    const std::vector<int> all_one(10, 1), own{0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
    EXPECT_EQ(agreement(seen[0], other, all_one), 1);
    EXPECT_NEAR(agreement(seen[0], other, own), 1 - 1. / (32 * 32), 1e-9);
}

}  // namespace
}  // namespace fastscene

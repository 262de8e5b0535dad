#include "fastscene/pipeline/best_view.h"

#include <gtest/gtest.h>

namespace fastscene {
namespace {

// A gray room with walls 2 m away, striped at the given yaw.
Panorama room_with_stripes_at(float yaw_deg) {
    Panorama room;
    room.color = ImageColor(360, 180, {0.5f, 0.5f, 0.5f});
    room.range = ImageF(360, 180, 2.f);
    const int center = 180 + static_cast<int>(yaw_deg);
    for (int y = 0; y < 180; ++y)
        for (int d = -20; d <= 20; ++d)
            room.color.at(wrap_column(center + d, 360), y) = d % 2 == 0 ? Vec3f{1, 1, 1} : Vec3f{};
    return room;
}

TEST(BestView, LooksWhereThereIsSomethingToSee) {
    for (const float yaw : {0.f, 60.f, 180.f, 300.f}) {
        const float found = best_yaw_deg(room_with_stripes_at(yaw), {});
        EXPECT_LE(std::abs(std::remainder(found - yaw, 360.f)), 30.f) << yaw;
    }
}

TEST(BestView, WhatWasAskedForWins) {
    const std::vector<Vec3f> requested{
        {-1, 0.5f, 0}, {-1, 0.3f, 0.2f}, {-1, 0.3f, -0.2f}};  // three objects on the left
    const float found = best_yaw_deg(room_with_stripes_at(90), requested);
    EXPECT_LE(std::abs(std::remainder(found - 270.f, 360.f)), 36.f) << found;
}

TEST(BestView, AnEmptyRoomHasAViewToo) {
    Panorama room;
    room.color = ImageColor(64, 32);
    room.range = ImageF(64, 32);
    EXPECT_EQ(best_yaw_deg(room, {}), 0.f);
}

}  // namespace
}  // namespace fastscene

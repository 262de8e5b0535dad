#include "fastscene/trace/standable.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "fastscene/scene/box.h"
#include "fastscene/trace/test_room.h"

namespace fastscene {
namespace {

// 4 x 5 m, the floor at y = 1.5, centered at the world's origin.
Room plain_room() {
    Room room;
    room.min_corner = kLow;
    room.max_corner = kHigh;
    room.materials = {diffuse({0.7f, 0.7f, 0.7f})};
    room.meshes = {box_mesh(kLow, kHigh, 0, -1, true)};
    return room;
}
void put(Room& room, Vec3f low, Vec3f high) { room.meshes.push_back(box_mesh(low, high, 0)); }

bool stands_at(const StandableFloor& floor, float x, float z) {
    const auto cell = [&](float v, float corner) { return static_cast<int>(std::floor((v - corner) / floor.cell_m)); };
    return floor.at(cell(x, floor.corner_m.x), cell(z, floor.corner_m.y));
}

TEST(Standable, AnEmptyRoomButForABodysWidthAlongItsWalls) {
    const StandableFloor floor = standable_floor(TracedRoom(plain_room()));
    EXPECT_NEAR(floor.floor_y, 1.5f, 1e-6);
    EXPECT_NEAR(standable_area_m2(floor), 3.5 * 4.5, 0.9);
    EXPECT_TRUE(stands_at(floor, 1.65f, 2.15f));
    EXPECT_FALSE(stands_at(floor, 1.85f, 0.f));
    EXPECT_FALSE(stands_at(floor, 2.5f, 0.f)) << "outside the walls there is no floor";
}

TEST(Standable, RugsAreSteppedOnTablesAreNotAndLampsAboveTheHeadDoNotCount) {
    Room room = plain_room();
    put(room, {-1.5f, 1.47f, -2.f}, {-0.5f, 1.5f, -1.f});  // a rug, 3 cm
    put(room, {0.5f, 0.75f, -2.f}, {1.5f, 0.8f, -1.f});    // a table's top
    put(room, {-1.5f, -1.1f, 1.f}, {-0.5f, -0.5f, 2.f});   // a lamp: 2 m above the floor
    put(room, {0.6f, -0.1f, 1.1f}, {1.4f, 0.f, 1.9f});     // a shelf at 1.5 m: no one can stand under its front
    const StandableFloor floor = standable_floor(TracedRoom(room));
    EXPECT_TRUE(stands_at(floor, -1.f, -1.5f));
    EXPECT_FALSE(stands_at(floor, 1.f, -1.5f));
    EXPECT_TRUE(stands_at(floor, -1.f, 1.5f));
    EXPECT_FALSE(stands_at(floor, 1.f, 1.5f));
}

// A wall across the room with a gap of 0.48 m: wide enough to pass, too narrow to stand in.
TEST(Standable, WhatCanBeReachedThroughAGap) {
    const auto with_gap = [](float half_m) {
        Room room = plain_room();
        put(room, {-2.f, -1.1f, 0.9f}, {-half_m, 1.5f, 1.f});
        put(room, {half_m, -1.1f, 0.9f}, {2.f, 1.5f, 1.f});
        return TracedRoom(std::move(room));
    };
    const StandableFloor wide = standable_floor(with_gap(0.24f)), narrow = standable_floor(with_gap(0.1f));
    EXPECT_TRUE(stands_at(wide, 0.05f, 2.f));
    EXPECT_FALSE(stands_at(wide, 0.05f, 0.95f));
    EXPECT_TRUE(stands_at(passable_floor(with_gap(0.24f)), 0.05f, 0.95f));
    EXPECT_FALSE(stands_at(narrow, 0.05f, 2.f));
    EXPECT_TRUE(stands_at(narrow, 0.05f, -1.f));
}

TEST(Standable, BedsFromWallToWallLeaveNothing) {
    Room room = plain_room();
    put(room, {-2.f, 1.f, -2.5f}, {2.f, 1.5f, 2.5f});
    EXPECT_TRUE(standable_cells(standable_floor(TracedRoom(room))).empty());
}

// Two tiers of 0.36 m across the room, from z = 0.5 and z = 1.5 on, with steps in the middle that lead up to them.
Room tiered_room(bool steps) {
    Room room = plain_room();
    raise_floor(room, {-2, 0.5f}, {2, 1.5f}, 0.36f);
    raise_floor(room, {-2, 1.5f}, {2, 2.5f}, 0.72f);
    if (steps) raise_floor(room, {-0.5f, 0}, {0.5f, 0.5f}, 0.18f, kTierStep);
    if (steps) raise_floor(room, {-0.5f, 1}, {0.5f, 1.5f}, 0.54f, kTierStep);
    return room;
}
float level_at(const StandableFloor& floor, float x, float z) {
    const auto cell = [&](float v, float corner) { return static_cast<int>(std::floor((v - corner) / floor.cell_m)); };
    return floor.level_at(cell(x, floor.corner_m.x), cell(z, floor.corner_m.y));
}

TEST(Standable, StepsLeadUpAndRisersDoNot) {
    const TracedRoom room(tiered_room(true));
    for (const StandableFloor& floor : {standable_floor(room), passable_floor(room)}) {
        EXPECT_TRUE(stands_at(floor, 1.f, -1.5f) && stands_at(floor, 1.f, 0.9f) && stands_at(floor, 1.f, 2.f));
        EXPECT_NEAR(level_at(floor, 1.f, -1.5f), 1.5f, 1e-5f);
        EXPECT_NEAR(level_at(floor, 1.f, 0.9f), 1.14f, 1e-5f);
        EXPECT_NEAR(level_at(floor, 1.f, 2.f), 0.78f, 1e-5f);
        EXPECT_EQ(levels_of(floor).size(), 5u);
        // Up the steps there is no gap; before a riser there is one.
        for (float z = -2.f; z < 2.f; z += 0.05f) EXPECT_TRUE(stands_at(floor, 0.05f, z)) << z;
        EXPECT_FALSE(stands_at(floor, 1.f, 0.44f));
    }
    const StandableFloor below = standable_floor(TracedRoom(tiered_room(false)));
    EXPECT_TRUE(stands_at(below, 1.f, -1.5f));
    EXPECT_FALSE(stands_at(below, 1.f, 0.9f) || stands_at(below, 1.f, 2.f));
}

TEST(Standable, NobodyStandsInsideOfAHighTier) {
    Room room = plain_room();
    raise_floor(room, {-2, 0}, {2, 2.5f}, 2.f);  // as high as a body
    const StandableFloor floor = standable_floor(TracedRoom(room));
    EXPECT_TRUE(stands_at(floor, 0, -1.f));
    EXPECT_FALSE(stands_at(floor, 0, 1.2f));
}

TEST(Standable, LevelsPartTheFloor) {
    const StandableFloor floor = passable_floor(TracedRoom(tiered_room(true)));
    double area = 0;
    for (const float y : levels_of(floor)) area += standable_area_m2(at_level(floor, y));
    EXPECT_NEAR(area, standable_area_m2(floor), 1e-6);
    EXPECT_EQ(levels_of(floor).front(), floor.floor_y);
    EXPECT_EQ(levels_of(passable_floor(TracedRoom(plain_room()))), std::vector<float>{1.5f});
    EXPECT_TRUE(passable_floor(TracedRoom(plain_room())).level_y.empty());
}

TEST(Trace, SeesThroughNothingButAirAndGlass) {
    Room room = plain_room();
    put(room, {-0.5f, -0.5f, 1.f}, {0.5f, 0.5f, 1.1f});
    const TracedRoom traced(std::move(room));
    EXPECT_TRUE(traced.sees({}, {0, 0, 0.9f}));
    EXPECT_TRUE(traced.sees({}, {0, 0, 1.f})) << "a point on a surface";
    EXPECT_FALSE(traced.sees({}, {0, 0, 1.05f}));
    EXPECT_FALSE(traced.sees({}, {0, 0, 2.f}));
    const TracedRoom::Surface met = traced.surface({0, 0, 2}, {0, 0, -1});
    EXPECT_NEAR(met.distance, 0.9f, 1e-5);
    EXPECT_NEAR(met.normal.z, 1.f, 1e-5) << "turned towards who looks";
}

// Russian roulette does not change the mean brightness.
TEST(Trace, FrugalReflectionsHaveTheSameMean) {
    Room room = plain_room();
    room.materials[0].specular = 0.04f;
    room.materials[0].roughness = 0.4f;
    Material lamp = diffuse({0.8f, 0.8f, 0.8f}, {9, 9, 9});
    room.materials.push_back(lamp);
    room.meshes.push_back(box_mesh({-0.4f, -1.09f, -0.4f}, {0.4f, -1.05f, 0.4f}, 1));
    TracedRoom traced(std::move(room));
    traced.gather_light({.cell_m = 0.2f, .cell_samples = 32}, {});
    const auto mean = [&](bool frugal) {
        const ImageColor color =
            traced.panorama({}, {128, 64}, {.pixel_samples = 64, .radiance = true, .frugal = frugal}, {}).color;
        double sum = 0;
        for (int y = 20; y < 64; ++y)  // below the lamp
            for (int x = 0; x < 128; ++x) sum += static_cast<double>(luminance(color.at(x, y)));
        return sum;
    };
    const double all = mean(false), few = mean(true);
    EXPECT_NEAR(few / all, 1.0, 0.003);
    EXPECT_NE(few, all);
}

}  // namespace
}  // namespace fastscene

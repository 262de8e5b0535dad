#include "fastscene/walk/room_viewpoints.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "fastscene/scene/box.h"
#include "fastscene/trace/test_room.h"
#include "fastscene/walk/room_walk.h"
#include "fastscene/walk/walkable_walk.h"

namespace fastscene {
namespace {

// A room divided by a wall with a doorway at its right end.
Room two_rooms() {
    Room room;
    room.min_corner = kLow;
    room.max_corner = kHigh;
    room.materials = {diffuse({0.7f, 0.7f, 0.7f}), diffuse({0.8f, 0.8f, 0.8f}, {9, 9, 9})};
    room.meshes = {box_mesh(kLow, kHigh, 0, -1, true), box_mesh({-2.f, -1.1f, 0.9f}, {1.1f, 1.5f, 1.f}, 0),
                   box_mesh({-0.4f, -1.09f, -0.4f}, {0.4f, -1.05f, 0.4f}, 1)};
    return room;
}

TEST(RoomViewpoints, SeeBothRoomsAndAreWhereOneCanLook) {
    const TracedRoom room(two_rooms());
    const StandableFloor floor = passable_floor(room);
    const RoomViewpoints chosen = choose_room_viewpoints(room, floor, {}, {});
    ASSERT_GT(chosen.positions_m.size(), 3u);
    EXPECT_LT(chosen.unseen_share, 0.005);
    EXPECT_LT(chosen.one_sided_share, 0.05);
    EXPECT_TRUE(std::any_of(chosen.positions_m.begin(), chosen.positions_m.end(), [](Vec3f p) { return p.z > 1.f; }))
        << "none behind the wall";
    for (const Vec3f p : chosen.positions_m) EXPECT_GE(room.clearance(p, 0.15f), 0.149f);
    // Deterministic, and a smaller selection is a prefix of a larger one.
    const RoomViewpoints again = choose_room_viewpoints(room, floor, {}, {}),
                         few = choose_room_viewpoints(room, floor, {.most = 2}, {});
    EXPECT_EQ(again.positions_m, chosen.positions_m);
    ASSERT_EQ(few.positions_m.size(), 2u);
    EXPECT_EQ(few.positions_m[1], chosen.positions_m[1]);
    EXPECT_GE(few.unseen_share, chosen.unseen_share);
}

// The far half is a tier of 0.36 m with a step before it.
Room room_with_a_tier() {
    Room room = two_rooms();
    room.meshes.erase(room.meshes.begin() + 1);
    raise_floor(room, {-2, 0.8f}, {2, 2.5f}, 0.36f);
    raise_floor(room, {-0.5f, 0.3f}, {0.5f, 0.8f}, 0.18f, kTierStep);
    return room;
}

TEST(RoomViewpoints, OnATierTheyAreAboveItAndWithinTheWalkableArea) {
    const TracedRoom room(room_with_a_tier());
    const StandableFloor floor = passable_floor(room);
    const WalkableArea area = walkable_room(floor);
    ASSERT_EQ(area.levels.size(), 3u);
    const RoomViewpoints chosen = choose_room_viewpoints(room, floor, {}, {});
    int above = 0;
    for (const Vec3f p : chosen.positions_m) {
        const float eye = floor_at(area, {p.x, p.z}) - p.y;
        EXPECT_TRUE(eye > 0.6f && eye < 1.9f) << eye;
        above += floor_at(area, {p.x, p.z}) < kHigh.y - 0.3f;
        if (contains(area, Vec2f{p.x, p.z})) {
            EXPECT_TRUE(contains(area, p));
        }
    }
    EXPECT_GT(above, 1);
    EXPECT_TRUE(walkable_room(passable_floor(TracedRoom(two_rooms()))).levels.empty());
}

TEST(RoomViewpoints, NobodyStandsNobodyLooks) {
    Room room = two_rooms();
    room.meshes.push_back(box_mesh({-2.f, 1.f, -2.5f}, {2.f, 1.5f, 2.5f}, 0));
    const TracedRoom traced(std::move(room));
    EXPECT_TRUE(choose_room_viewpoints(traced, passable_floor(traced), {}, {}).positions_m.empty());
}

// Every panorama of the walk equals the room seen from its position.
TEST(RoomWalkAll, PanoramasAreTrueColorAndRange) {
    TracedRoom room(two_rooms());
    room.gather_light({.cell_m = 0.2f, .cell_samples = 32}, {});
    const EquirectSize size{128, 64};
    Shot shot = room.panorama({}, size, {.pixel_samples = 16}, {});
    const Panorama first{std::move(shot.color), std::move(shot.range), {}, {}};
    WalkParams params;
    params.room_viewpoints = 3;
    params.pixel_samples = 16;
    std::vector<Panorama> walked;
    const Json about = walk_through_room(first, room, passable_floor(room), params, {}, {},
                                         [&](Panorama p) { walked.push_back(std::move(p)); });
    ASSERT_EQ(walked.size(), 4u);
    EXPECT_EQ(about.at("viewpoints"), 3);
    for (const Panorama& p : walked) {
        const Shot truth = room.panorama(p.world_from_pano, size, {.pixel_samples = 64},
                                         fastscene::Run{99, nullptr, {}});
        double error = 0;
        int far_off = 0;
        for (std::size_t i = 0; i < truth.color.size(); ++i) {
            error += static_cast<double>(std::fabs(luminance(truth.color.pixels[i]) - luminance(p.color.pixels[i])));
            far_off += std::fabs(truth.range.pixels[i] - p.range.pixels[i]) > 0.02f;
        }
        EXPECT_LT(error / static_cast<double>(truth.color.size()), 0.02);
        EXPECT_LT(far_off, 40) << "of " << truth.color.size();
    }
}

TEST(Walkable, ARoomsIsItsFloorAndAPicturesIsWhereLittleIsPainted) {
    const TracedRoom room(two_rooms());
    const WalkableArea area = walkable_room(passable_floor(room));
    EXPECT_TRUE(contains(area, Vec3f{0, 0, 0}));
    EXPECT_TRUE(contains(area, Vec3f{0, 0, 2.f}));
    EXPECT_FALSE(contains(area, Vec3f{0, 0, 0.95f})) << "in the wall";
    EXPECT_FALSE(contains(area, Vec3f{0, -1.f, 0})) << "above heads";

    const std::vector<Invention> inventions{
        {{}, 0, 0}, {{1, 0, 0}, 0.05, 0.02}, {{-1, 0.2f, 0}, 0.02, 0}, {{0, 0, 1}, 0.1, 0}, {{0, 0, -1}, 0.3, 0}};
    const WalkableArea held = walkable_of(inventions, 1.5f);
    EXPECT_TRUE(contains(held, Vec3f{0.9f, 0, 0}));
    EXPECT_TRUE(contains(held, Vec3f{0, 0, 0.8f}));
    EXPECT_FALSE(contains(held, Vec3f{0, 0, -0.5f})) << "too much is painted there";
    EXPECT_NEAR(held.high_y, 0.3f, 1e-5);
}

TEST(Walkable, InventionIsAShareOfTheSphere) {
    Panorama p;
    p.color = ImageColor(8, 4);
    p.known = Image<Known>(8, 4, Known::original);
    for (int x = 0; x < 8; ++x) p.known.at(x, 0) = Known::invented, p.known.at(x, 1) = Known::carried;
    const Invention i = invention_of(p);
    EXPECT_NEAR(i.invented_share, (1 - std::sin(kPi / 4)) / 2, 1e-6);
    EXPECT_NEAR(i.invented_share + i.carried_share, 0.5, 1e-6);
}

}  // namespace
}  // namespace fastscene

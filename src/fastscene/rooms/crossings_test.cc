#include "fastscene/base/parallel.h"
#include "fastscene/rooms/crossings.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/rooms.h"
#include "fastscene/rooms/style.h"
#include "fastscene/scene/box.h"

namespace fastscene {
namespace {

// A table of 1 m x 0.8 m x 1 m on the ground, and a box at `low` with edges `size`. y is down.
Room with_box(Vec3f low, Vec3f size, const char* kind = "vase") {
    Room room;
    room.materials.resize(1);
    room.objects.resize(2);
    room.objects[0].kind = "table";
    room.objects[1].kind = kind;
    room.meshes.push_back(box_mesh({-0.5f, -0.8f, -0.5f}, {0.5f, 0, 0.5f}, 0, 0));
    room.meshes.push_back(box_mesh(low, low + size, 0, 1));
    return room;
}

TEST(Crossings, WhatReachesIntoASolidIsFoundHowDeepItIs) {
    EXPECT_TRUE(room_crossings(with_box({-0.1f, -1.f, -0.1f}, {0.2f, 0.2f, 0.2f})).empty()) << "stands on it";
    const auto sunk = room_crossings(with_box({-0.1f, -0.95f, -0.1f}, {0.2f, 0.2f, 0.2f}));
    const auto vase = std::find_if(sunk.begin(), sunk.end(),
                                   [](const Crossing& c) { return c.object == 1 && c.into == 0; });
    ASSERT_NE(vase, sunk.end());
    EXPECT_NEAR(vase->depth_m, 0.05f, 1e-3f);
    EXPECT_TRUE(room_crossings(with_box({-0.1f, -0.95f, -0.1f}, {0.2f, 0.2f, 0.2f}, "cushion")).empty())
        << "soft things may sink";
}

TEST(Crossings, APoleThroughATableHasItsEndsOutside) {
    const auto through = room_crossings(with_box({0.2f, -2.f, 0.1f}, {0.05f, 3.f, 0.05f}));
    ASSERT_FALSE(through.empty());
    EXPECT_GT(through[0].depth_m, 0.2f);
}

TEST(Crossings, ASheetHasNoInside) {
    Room room = with_box({-0.1f, -0.95f, -0.1f}, {0.2f, 0.2f, 0.2f});
    room.meshes[0].triangles.resize(6);  // one side of the table
    EXPECT_TRUE(room_crossings(room).empty());
}

// What boxes cannot tell.
TEST(Crossings, NothingReachesIntoAnotherOver60Rooms) {
    const std::vector<std::string> rooms = room_types(), all = styles();
    constexpr int kSeeds = 60;
    std::vector<std::string> lists(kSeeds);
    parallel_for(kSeeds, 1, [&](std::int64_t begin, std::int64_t) {
        const auto seed = static_cast<std::uint64_t>(begin);
        PromptSpec spec = understand_prompt(
            "a " + all[(seed + seed / 60) % all.size()] + " " + room_title(rooms[seed % rooms.size()]), false);
        const Room room = make_room(spec, {seed, nullptr, {}});
        const std::vector<Crossing> found = room_crossings(room);
        const auto name = [&](int object) {
            return object < 0 ? std::string("shell") : room.objects[static_cast<std::size_t>(object)].kind;
        };
        for (const Crossing& c : found)
            lists[seed] += "\n" + spec.text + ", seed " + std::to_string(seed) + ": " + name(c.object) + " in " +
                           name(c.into) + " " + std::to_string(c.depth_m);
    });
    for (const std::string& list : lists) EXPECT_EQ(list, "");
}

}  // namespace
}  // namespace fastscene

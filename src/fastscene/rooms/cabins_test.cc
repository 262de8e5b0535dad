// Buses, carriages, lifts, corridors and malls are told by what is in them, and by what is not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "fastscene/rooms/layout.h"
#include "fastscene/rooms/test_prompts.h"

namespace fastscene {
namespace {

constexpr std::uint64_t kCabinSeeds = 4;

struct Cabin {
    PromptSpec spec;
    FurnishedRoom room;
    std::vector<const Placed*> of(std::string_view kind) const {
        std::vector<const Placed*> out;
        for (const Placed& p : room.placed)
            if (p.piece.kind == kind) out.push_back(&p);
        return out;
    }
    std::size_t glazed(Glazing glazing) const {
        return static_cast<std::size_t>(
            std::count_if(room.plan.openings.begin(), room.plan.openings.end(),
                          [&](const Opening& o) { return o.kind == Opening::Kind::window && o.glazing == glazing; }));
    }
};

Cabin cabin(const std::string& text, std::uint64_t seed) {
    Cabin out{read(text), {}};
    Run run;
    run.seed = seed;
    out.room = furnish_room(out.spec, run);
    return out;
}

// Along z, the long axis.
bool faces_along(const Placed& p) { return std::abs(front_of(p.yaw).z) > 0.99f; }

TEST(Cabins, HaveNoDoorsOrCurtainsOfHouses) {
    for (const char* text : {"the inside of a bus", "a subway carriage", "a train carriage", "an elevator"})
        for (std::uint64_t seed = 0; seed < kCabinSeeds; ++seed) {
            const Cabin c = cabin(text, seed);
            EXPECT_TRUE(c.room.plan.cabin) << text;
            for (const Opening& o : c.room.plan.openings) EXPECT_EQ(o.kind, Opening::Kind::window) << text;
            for (const Placed& p : c.room.placed)
                EXPECT_TRUE(p.piece.kind != "curtain" && p.piece.kind != "radiator") << text;
        }
}

TEST(Cabins, ABusHasADriverAndSeatsThatLookAhead) {
    for (std::uint64_t seed = 0; seed < kCabinSeeds; ++seed) {
        const Cabin c = cabin("the inside of a bus", seed);
        EXPECT_EQ(c.spec.room, "bus");
        ASSERT_EQ(c.of("driver_cab").size(), 1u);
        EXPECT_GT(c.of("driver_cab")[0]->position.z, 0.25f * c.room.plan.depth);  // at the front
        EXPECT_EQ(c.glazed(Glazing::windscreen), 1u);
        EXPECT_EQ(c.glazed(Glazing::folding_doors), 2u);
        const auto seats = c.of("bus_seat");
        EXPECT_GE(seats.size(), 8u);
        int left = 0;
        for (const Placed* seat : seats) {
            EXPECT_GT(front_of(seat->yaw).z, 0.99f);
            left += seat->position.x > 0;
        }
        EXPECT_GT(left, 2);
        EXPECT_GT(static_cast<int>(seats.size()) - left, 2);
        EXPECT_FALSE(c.of("grab_pole").empty());
        EXPECT_FALSE(c.of("strap_rail").empty());
    }
}

TEST(Cabins, BenchesOfASubwayFaceEachOther) {
    for (std::uint64_t seed = 0; seed < kCabinSeeds; ++seed) {
        const Cabin c = cabin("the inside of a subway carriage", seed);
        EXPECT_EQ(c.spec.room, "subway_carriage");
        EXPECT_TRUE(c.room.plan.tunnel);
        EXPECT_EQ(c.glazed(Glazing::sliding_doors), 6u);
        int left = 0, right = 0;
        for (const Placed* bench : c.of("subway_bench")) {
            EXPECT_LT(front_of(bench->yaw).x * bench->position.x, 0.f);  // to the middle
            EXPECT_FALSE(faces_along(*bench));
            (bench->position.x > 0 ? left : right) += 1;
        }
        EXPECT_EQ(left, right);
        EXPECT_GE(left, 3);
        EXPECT_EQ(c.of("carriage_door").size(), 2u);
        for (const char* kind : {"subway_pole", "strap_rail", "ad_strip", "line_map"})
            EXPECT_GE(c.of(kind).size(), 4u) << kind;
    }
}

TEST(Cabins, ATrainHasSeatsInRowsAndRacksAbove) {
    for (std::uint64_t seed = 0; seed < kCabinSeeds; ++seed) {
        const Cabin c = cabin("a train carriage", seed);
        EXPECT_FALSE(c.room.plan.tunnel);
        EXPECT_GE(c.of("train_seat").size(), 10u);
        for (const Placed* seat : c.of("train_seat")) EXPECT_TRUE(faces_along(*seat));
        EXPECT_GE(c.of("luggage_rack").size(), 6u);
        EXPECT_EQ(c.of("carriage_door").size(), 2u);
    }
}

TEST(Cabins, ALiftHasDoorsButtonsAndARail) {
    for (std::uint64_t seed = 0; seed < kCabinSeeds; ++seed) {
        const Cabin c = cabin("an elevator", seed);
        for (const char* kind : {"elevator_doors", "elevator_panel", "lift_mirror", "handrail"})
            EXPECT_FALSE(c.of(kind).empty()) << kind << ' ' << seed;
        // The doors are before who looks, the mirror is behind.
        ASSERT_FALSE(c.of("elevator_doors").empty());
        EXPECT_GT(dot(c.of("elevator_doors")[0]->position - c.room.camera, c.room.looks), 0.5f);
    }
}

TEST(Corridors, AreLookedAlongWithDoorsOnBothSides) {
    for (const char* text : {"a corridor", "a hotel corridor", "an office corridor"})
        for (std::uint64_t seed = 0; seed < kCabinSeeds; ++seed) {
            const Cabin c = cabin(text, seed);
            EXPECT_EQ(c.spec.room, "corridor") << text;
            EXPECT_GT(c.room.plan.depth, 4 * c.room.plan.width);
            EXPECT_GT(std::abs(c.room.looks.z), 0.99f);
            EXPECT_LT(std::abs(c.room.camera.x), 0.25f * c.room.plan.width);
            int left = 0, right = 0;
            for (const Placed* door : c.of("room_door")) (door->position.x > 0 ? left : right) += 1;
            EXPECT_GE(left, 3) << text << ' ' << seed;
            EXPECT_GE(right, 3) << text << ' ' << seed;
        }
}

TEST(Malls, HaveShopsOnBothSidesOfTheMovingStairs) {
    for (std::uint64_t seed = 0; seed < kCabinSeeds; ++seed) {
        const Cabin c = cabin("a mall", seed);
        ASSERT_EQ(c.of("escalator_pair").size(), 1u);
        EXPECT_EQ(c.of("gallery_bridge").size(), 1u);
        // The stairs are before who looks, at some distance.
        const Placed& stairs = *c.of("escalator_pair")[0];
        EXPECT_GT(dot(stairs.position - c.room.camera, c.room.looks) - 0.5f * stairs.piece.size_m.z, 2.f);
        int left = 0, right = 0;
        for (const Placed* shop : c.of("shop_gallery")) (shop->position.x > 0 ? left : right) += 1;
        EXPECT_GE(left, 3);
        EXPECT_GE(right, 3);
    }
}

}  // namespace
}  // namespace fastscene

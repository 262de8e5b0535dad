// What is seen of a piece, and what the layout does about what is not.
#include "fastscene/rooms/layout_sight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "fastscene/rooms/validate.h"

namespace fastscene {
namespace {

Placed placed(const char* kind, Vec3f position, float yaw, Vec3f size = {}) {
    static const Style style = style_named("modern");
    PieceRequest request;
    request.kind = kind;
    request.style = &style;
    request.size_m = size;
    Placed p;
    p.piece = make_piece(request);
    p.position = position;
    p.yaw = yaw;
    return p;
}

TEST(Sight, AFlatThingHasThePixelsOfItsArea) {
    Plan plan;
    const std::vector<Placed> room{placed("picture", {0, 1.2f, 2.4f}, std::numbers::pi_v<float>, {0.3f, 0.4f, 0})};
    const Vec3f size = room[0].piece.size_m;
    const float far = 2.4f, pixel = 2 * std::numbers::pi_v<float> / 512;
    const float expected = size.x * size.y / (far * far * pixel * pixel);
    ASSERT_GT(expected, 30.f);
    EXPECT_NEAR(Sight(plan, room).look(0, {0, 1.4f, 0}).pixels, std::min(expected, Sight::kMany), 0.3f * expected);
}

TEST(Sight, WhatStandsBeforeAThingHidesItAndIsNamed) {
    Plan plan;
    const std::vector<Placed> room{placed("vase", {0, 0, 2.f}, 0), placed("wardrobe", {0, 0, 1.f}, 0)};
    const Sight sight(plan, room);
    EXPECT_EQ(sight.look(0, {0, 1.2f, -1.5f}).pixels, 0.f);
    EXPECT_EQ(sight.look(0, {0, 1.2f, -1.5f}).hiders, std::vector<int>{1});
    EXPECT_GT(sight.look(0, {2.4f, 1.2f, 1.8f}).pixels, 8.f);
}

// Below a shelf's board no box stands before it.
TEST(Sight, AWallsCornerHidesToo) {
    Plan plan;
    plan.blocks.push_back({Block::Kind::corner, {-0.5f, 0.8f}, {0.5f, 1.2f}});
    const std::vector<Placed> room{placed("plant", {0, 0, 2.f}, 0)};
    EXPECT_EQ(Sight(plan, room).look(0, {0, 1.5f, -1.f}).pixels, 0.f);
    EXPECT_TRUE(Sight(plan, room).look(0, {0, 1.5f, -1.f}).hiders.empty());
}

TEST(Reveal, SmallThingsThatWereAskedForAreSeen) {
    for (const char* text : {"a study with a globe, a cup and a pen", "a cozy kitchen with a kettle and a bowl",
                             "a cluttered bedroom with a book and a candle on the dresser"})
        for (std::uint64_t seed = 0; seed < 2; ++seed) {
            SCOPED_TRACE(text + std::string(", seed ") + std::to_string(seed));
            PromptSpec spec = understand_prompt(text, false);
            const FurnishedRoom room = furnish_room(spec, {seed, nullptr, {}});
            EXPECT_EQ(room.hidden_wishes, 0);
            EXPECT_TRUE(room_faults(room.plan, room.placed, room.camera).empty());
        }
}

bool has(const std::vector<Placed>& pieces, const char* kind) {
    return std::any_of(pieces.begin(), pieces.end(), [&](const Placed& p) { return p.piece.kind == kind; });
}

TEST(NextRoom, IsOfTheKindThatWasAskedFor) {
    struct Case {
        const char *text, *room, *next, *piece;
    };
    for (const Case& c : {Case{"a bedroom with an en-suite bathroom", "bedroom", "bathroom", "toilet"},
                          {"a modern ensuite bedroom", "bedroom", "bathroom", "washbasin"},
                          {"a living room opening to a kitchen", "living", "kitchen", "kitchen_counter"},
                          {"a hallway with an archway leading to a dining room", "hallway", "dining", "dining_table"},
                          {"a bedroom with an en-suite bathroom with a bathtub", "bedroom", "bathroom", "bathtub"}})
        for (std::uint64_t seed = 0; seed < 3; ++seed) {
            SCOPED_TRACE(c.text + std::string(", seed ") + std::to_string(seed));
            PromptSpec spec = understand_prompt(c.text, true);
            EXPECT_EQ(spec.room, c.room);
            const FurnishedRoom room = furnish_room(spec, {seed, nullptr, {}});
            ASSERT_TRUE(room.plan.next);
            EXPECT_EQ(room.plan.next->type, c.next);
            EXPECT_TRUE(has(room.placed_next, c.piece));
            EXPECT_FALSE(has(room.placed, c.piece));
            EXPECT_TRUE(room_faults(room.plan, room.placed, room.camera).empty());
        }
}

TEST(NextRoom, APartOfTheRoomIsNone) {
    const PromptSpec spec = understand_prompt("a kitchen with a dining area and an office corner", true);
    EXPECT_EQ(spec.room, "kitchen");
    EXPECT_TRUE(spec.next_room.empty());
    for (const char* kind : {"dining_table", "desk"})
        EXPECT_TRUE(std::any_of(spec.objects.begin(), spec.objects.end(), [&](const PromptObject& o) {
            return o.kind == kind;
        })) << kind;
}

}  // namespace
}  // namespace fastscene

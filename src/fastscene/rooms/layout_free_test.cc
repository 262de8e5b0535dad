// Free floor, free windows, and no form twice.
#include <gtest/gtest.h>

#include "fastscene/rooms/layout.h"
#include "fastscene/rooms/repeated_forms.h"

namespace fastscene {
namespace {

TEST(Ways, FloorIsCutOff) {
    Plan plan;  // 4 m wide, 5 m deep
    Ways ways(plan);
    EXPECT_EQ(ways.cut_off(), 0);
    Placed block;
    block.piece.kind = "bookshelf";
    block.piece.size_m = {3.7f, 2, 0.4f};
    block.position = {0.15f, 0, -1.3f};
    EXPECT_FALSE(ways.cuts_off(block)) << "0.3 m are left: who is slim slips through";
    block.piece.size_m.x = 4, block.position.x = 0;
    EXPECT_TRUE(ways.cuts_off(block));
    ways.add(block);
    EXPECT_NEAR(ways.cut_off(), 3.8f * 0.8f, 0.5f) << "the smaller part, less what nobody can stand on";
    Placed toy = block;
    toy.piece.size_m = {0.25f, 0.2f, 0.2f};
    Ways gap(plan);
    block.piece.size_m.x = 3.7f, block.position.x = 0.15f;
    gap.add(block);
    toy.position = {-1.85f, 0, -1.3f};
    EXPECT_TRUE(gap.cuts_off(toy)) << "in the only gap";
    toy.position = {0, 0, 1};
    EXPECT_FALSE(gap.cuts_off(toy));
}

TEST(Layout, WhatStandsOnALowTopHidesNoWindow) {
    Plan plan;
    Opening window;
    window.u0 = 1, window.u1 = 2.5f, window.y0 = 0.85f, window.y1 = 2.2f;  // in wall 0, at z = 2.5
    plan.openings.push_back(window);
    const Footprint screen{{-0.25f, 2.2f}, {0.5f, 0.1f}, 0, 0.5f, 1.2f};
    EXPECT_TRUE(shades_window(plan, screen)) << "1 m x 0.35 m of 1.5 m x 1.35 m";
    Footprint lamp = screen;
    lamp.half.x = 0.1f;
    EXPECT_FALSE(shades_window(plan, lamp));
    Footprint far = screen;
    far.center.y = 1.8f;
    EXPECT_FALSE(shades_window(plan, far));
    Footprint low = screen;
    low.y1 = 0.85f;
    EXPECT_FALSE(shades_window(plan, low));
}

TEST(Layout, WhatLooksLikeAnotherIsDrawnAgainForItsPlace) {
    PromptSpec spec = understand_prompt("a modern study", false);
    Random rng(1, "layout test");
    const Plan plan = make_plan(spec, rng);
    const auto made = [&](const char* kind, Vec3f at) {
        PieceRequest request;
        request.kind = kind, request.style = &plan.style, request.seed = 7;
        Placed p;
        p.piece = make_piece(request);
        p.position = at;
        return p;
    };
    Layout layout(plan, spec, rng);
    std::vector<Placed> room{made("dresser", {-1, 0, 0}), made("dresser", {1, 0, 0}), made("vase", {-1, 0.9f, 0}),
                             made("vase", {1, 0.9f, 0}), made("vase", {1.2f, 0.9f, 0})};
    room[2].on = 0, room[3].on = room[4].on = 1;
    room[4].with = 3;  // a pair
    layout.begin_with(room);
    ASSERT_FALSE(repeated_forms(layout.placed()).empty());
    layout.tell_apart();
    EXPECT_TRUE(repeated_forms(layout.placed()).empty());
    const std::vector<Placed>& now = layout.placed();
    for (std::size_t i = 0; i < now.size(); ++i)
        for (std::size_t a = 0; a < 3; ++a) EXPECT_LE(now[i].piece.size_m[a], room[i].piece.size_m[a] + 0.005f) << i;
    EXPECT_EQ(looks_of(now[0].piece), looks_of(room[0].piece)) << "the first stays as it is";
    EXPECT_EQ(looks_of(now[3].piece), looks_of(now[4].piece)) << "the pair remains one";
    ASSERT_EQ(now[1].piece.surfaces.size(), room[1].piece.surfaces.size());
    EXPECT_EQ(now[1].piece.surfaces[0].center.y, room[1].piece.surfaces[0].center.y) << "vases stand on it";
}

}  // namespace
}  // namespace fastscene

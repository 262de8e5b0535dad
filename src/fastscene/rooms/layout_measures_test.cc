// The measures of a layout, in rooms whose figures are known.
#include "fastscene/rooms/layout_measures.h"

#include <gtest/gtest.h>

#include <numbers>

#include "fastscene/rooms/repeated_forms.h"
#include "fastscene/rooms/shapes.h"

namespace fastscene {
namespace {

constexpr float kPi4 = std::numbers::pi_v<float> / 4;

// A box with its lower face at `base`.
Placed block(Vec3f base, Vec3f size, float yaw = 0, const char* kind = "bookshelf") {
    Placed p;
    p.piece.kind = kind;
    p.piece.materials.resize(1);
    p.piece.meshes.push_back(shapes::box(size, 0.f));
    shapes::move(p.piece.meshes[0], {0, size.y / 2, 0});
    p.piece.size_m = size;
    p.position = base;
    p.yaw = yaw;
    return p;
}

Placed made(const char* kind, std::uint64_t seed, float size_factor = 1) {
    static const Style style = style_named("modern");
    PieceRequest request;
    request.kind = kind;
    request.style = &style;
    request.seed = seed;
    request.size_factor = size_factor;
    Placed p;
    p.piece = make_piece(request);
    return p;
}

Opening opening(Opening::Kind kind, int wall, float u0, float u1, float y0, float y1) {
    Opening o;
    o.kind = kind, o.wall = wall, o.u0 = u0, o.u1 = u1, o.y0 = y0, o.y1 = y1;
    return o;
}

int colliding(const std::vector<Placed>& placed) { return measure_layout(Plan{}, placed).colliding; }

TEST(LayoutMeasures, PiecesThatReachIntoEachOtherCollide) {
    const Vec3f size{0.4f, 0.4f, 0.4f};
    const Placed a = block({}, size);
    EXPECT_EQ(colliding({a, block({0.4f, 0, 0}, size)}), 0) << "they touch";
    EXPECT_EQ(colliding({a, block({0, 0.4f, 0}, size)}), 0) << "one stands on the other";
    EXPECT_EQ(colliding({a, block({0.397f, 0.01f, 0.01f}, size)}), 0) << "3 mm";
    EXPECT_EQ(colliding({a, block({0.38f, 0.01f, 0.01f}, size)}), 2) << "2 cm";
    Placed rug = block({0.38f, 0.01f, 0.01f}, size);
    rug.flat = true;
    EXPECT_EQ(colliding({a, rug}), 0) << "in its pile";
    EXPECT_EQ(colliding({a, block({0, 0.1f, 0}, {0.1f, 0.1f, 0.1f})}), 2) << "one lies within the other";
    EXPECT_EQ(colliding({a, block({0.1f, -0.5f, 0.1f}, {0.02f, 2.f, 0.02f})}), 2) << "a pole through it";
}

// Their boxes do, for their rules; the pieces do not.
TEST(LayoutMeasures, CornersOfBoxesAreNotPieces) {
    Placed diamond = block({}, {0.4f, 0.4f, 0.4f});
    shapes::turn(diamond.piece.meshes[0], {0, 1, 0}, 45);
    diamond.piece.size_m = {0.566f, 0.4f, 0.566f};
    EXPECT_EQ(colliding({diamond, block({0.25f, 0, 0.25f}, {0.1f, 0.4f, 0.1f})}), 0);
    EXPECT_EQ(colliding({diamond, block({0.17f, 0.01f, 0.17f}, {0.1f, 0.4f, 0.1f})}), 2);
    // Placed.yaw turns what is measured.
    EXPECT_EQ(colliding({block({}, {0.4f, 0.4f, 0.4f}, kPi4), block({0.25f, 0, 0.25f}, {0.1f, 0.4f, 0.1f})}), 0);
}

TEST(LayoutMeasures, WhatIsNotOverTheFloorPlanIsOutside) {
    Plan plan;  // 4 m wide, 5 m deep
    const auto outside = [&](const Placed& p) { return measure_layout(plan, {p}).outside; };
    EXPECT_EQ(outside(block({1.8f, 0, 0}, {0.4f, 1, 0.4f})), 0) << "its back lies in the wall's plane";
    EXPECT_EQ(outside(block({1.85f, 0, 0}, {0.4f, 1, 0.4f})), 1) << "5 cm in the wall";
    plan.openings.push_back(opening(Opening::Kind::window, 1, 2, 3, 0.9f, 2));
    EXPECT_EQ(outside(block({1.98f, 0.9f, 0}, {0.1f, 0.2f, 0.1f})), 0) << "on the sill of a window";
    EXPECT_EQ(outside(block({1.98f, 0.9f, 1}, {0.1f, 0.2f, 0.1f})), 1) << "beside the window";
    EXPECT_EQ(outside(block({-1.7f, 0, 2.2f}, {0.4f, 1, 0.4f})), 0);
    plan.blocks.push_back({Block::Kind::corner, {-2, 1.5f}, {-1, 2.5f}});
    EXPECT_EQ(outside(block({-1.7f, 0, 2.2f}, {0.4f, 1, 0.4f})), 1) << "in the corner that an L leaves out";
}

TEST(LayoutMeasures, NavigabilityIsTheLargestPartOfTheFreeFloor) {
    const Plan plan;  // 4 m wide, 5 m deep
    const auto walked = [&](Vec3f base, Vec3f size) { return measure_layout(plan, {block(base, size)}).navigability; };
    EXPECT_DOUBLE_EQ(measure_layout(plan, {}).navigability, 1);
    // From wall to wall: parts of 2 m and 2.6 m, both less 0.1 m at each end for who stands there.
    constexpr double kParts = 2.4 / (2.4 + 1.8);
    EXPECT_NEAR(walked({0, 0, -0.3f}, {4, 1, 0.4f}), kParts, 0.01);
    EXPECT_NEAR(walked({0.075f, 0, -0.3f}, {3.85f, 1, 0.4f}), kParts, 0.01) << "0.15 m is too narrow";
    EXPECT_DOUBLE_EQ(walked({0.15f, 0, -0.3f}, {3.7f, 1, 0.4f}), 1) << "0.3 m is not";
    EXPECT_DOUBLE_EQ(walked({0, 2.05f, -0.3f}, {4, 0.3f, 0.4f}), 1) << "above one's head";
    EXPECT_DOUBLE_EQ(walked({0, 0, -0.3f}, {4, 0.03f, 0.4f}), 1) << "one steps over it";
    EXPECT_NEAR(walked({0, 0.5f, -0.3f}, {4, 0.03f, 0.4f}), kParts, 0.01) << "a board";
    Placed rug = block({0, 0, -0.3f}, {4, 0.1f, 0.4f});
    rug.flat = true;
    EXPECT_DOUBLE_EQ(measure_layout(plan, {rug}).navigability, 1);
    Plan full;
    full.width = full.depth = 0.5f;
    EXPECT_EQ(measure_layout(full, {block({}, {0.5f, 1, 0.5f})}).navigability, 0) << "nobody stands anywhere";
}

TEST(LayoutMeasures, LevelsAreConnectedBySteps) {
    Plan plan;
    plan.platforms.push_back({Platform::Kind::tier, {-2, 0}, {2, 2.5f}, 0.18f});
    EXPECT_DOUBLE_EQ(measure_layout(plan, {}).navigability, 1);
    plan.platforms[0].height = 0.36f;
    EXPECT_NEAR(measure_layout(plan, {}).navigability, 0.5, 0.01);
}

TEST(LayoutMeasures, AnOpeningIsClearWhenNothingIsBeforeIt) {
    Plan plan;
    plan.openings.push_back(opening(Opening::Kind::door, 2, 0.5f, 1.4f, 0, 2));  // x from 1.5 to 0.6, at z = -2.5
    const auto measured = [&](const Placed& p) { return measure_layout(plan, {p}); };
    EXPECT_EQ(measured(block({1, 0, -1.3f}, {0.4f, 1, 0.4f})).clear, 1) << "1 m away";
    EXPECT_EQ(measured(block({1, 0, -1.5f}, {0.4f, 1, 0.4f})).clear, 0) << "0.8 m: in its swing";
    EXPECT_EQ(measured(block({1, 2.01f, -1.5f}, {0.4f, 0.3f, 0.4f})).clear, 1) << "above it";
    EXPECT_EQ(measured(block({0.3f, 0, -2}, {0.4f, 1, 0.4f})).clear, 1) << "beside it";
    const LayoutMeasures half = measured(block({0.825f, 0, -1.7f}, {0.45f, 2, 0.4f}));
    EXPECT_NEAR(half.covered_m2 / half.opening_m2, 0.5, 0.04);

    plan.openings[0].kind = Opening::Kind::doorway;
    EXPECT_EQ(measured(block({1, 0, -1.5f}, {0.4f, 1, 0.4f})).clear, 1) << "no leaf swings";
    EXPECT_EQ(measured(block({1, 0, -1.6f}, {0.4f, 1, 0.4f})).clear, 0);

    plan.openings = {opening(Opening::Kind::window, 0, 1.5f, 2.5f, 1, 2)};  // x from -0.5 to 0.5, at z = 2.5
    EXPECT_EQ(measured(block({0, 0, 1.8f}, {1, 2, 0.3f})).untouched, 1) << "0.55 m away";
    EXPECT_EQ(measured(block({0, 0, 2.2f}, {1, 1, 0.4f})).untouched, 1) << "below its sill";
    const LayoutMeasures hidden = measured(block({0.25f, 0, 2.2f}, {0.5f, 2, 0.3f}));
    EXPECT_EQ(hidden.clear, 0);
    EXPECT_NEAR(hidden.covered_m2, 0.5, 0.05);
    const LayoutMeasures lamp = measured(block({0, 0, 2.2f}, {0.1f, 1.3f, 0.1f}));
    EXPECT_EQ(lamp.clear, 1) << "3 % of it";
    EXPECT_EQ(lamp.untouched, 0);
    EXPECT_EQ(measured(block({0, 0, 2.4f}, {1.4f, 2.2f, 0.1f}, 0, "curtain")).untouched, 1) << "it belongs to it";
}

int repeats(const std::vector<Placed>& placed) { return static_cast<int>(repeated_forms(placed).size()); }

TEST(RepeatedForms, TheSameThingTwiceIsARepetition) {
    EXPECT_EQ(repeats({made("vase", 1), made("vase", 1)}), 1);
    EXPECT_EQ(repeats({made("vase", 1), made("vase", 1), made("vase", 1)}), 2);
    EXPECT_EQ(repeats({made("vase", 1), made("vase", 1, 0.8f)}), 1) << "the same in two sizes";
    EXPECT_EQ(repeats({made("vase", 1), made("picture", 1)}), 0);
    EXPECT_EQ(repeats({made("picture", 1), made("picture", 1)}), 1);
    Placed red = made("sofa", 1), blue = red;
    EXPECT_EQ(repeats({red, blue}), 1);
    blue.piece.materials[static_cast<std::size_t>(blue.piece.main_material)].color_a = {0, 0, 0.5f};
    EXPECT_EQ(repeats({red, blue}), 0) << "in other colors";
    Placed tall = red;
    tall.piece.meshes[0].positions[0].y += 0.01f;
    EXPECT_EQ(repeats({red, tall}), 0) << "of another shape";
    Material& grain = blue.piece.materials[0];
    blue = red;
    grain.seed += 1;
    EXPECT_EQ(repeats({red, blue}), 1) << "the grain is random";
}

// A picture on a ledge, and the same by itself.
TEST(RepeatedForms, APictureIsTheSameOnWhateverShowsIt) {
    // The first of its kind that shows a design, or a photograph or painting.
    const auto showing = [](const char* kind, Pattern pattern) {
        for (std::uint64_t seed = 1;; ++seed)
            if (const Placed p = made(kind, seed); std::any_of(p.piece.materials.begin(), p.piece.materials.end(),
                                                               [&](const Material& m) { return m.pattern == pattern; }))
                return p;
    };
    const Placed ledge = showing("picture_ledge", Pattern::art);
    Placed picture = showing("picture", Pattern::art);
    for (const Material& m : ledge.piece.materials)
        if (m.pattern == Pattern::art)
            picture.piece.materials[static_cast<std::size_t>(picture.piece.main_material)] = m;
    EXPECT_EQ(repeats({ledge, picture}), 1);
    picture.piece.materials[static_cast<std::size_t>(picture.piece.main_material)].color_b = {0.123f, 0.4f, 0.1f};
    EXPECT_EQ(repeats({ledge, picture}), 0);
    const Placed photograph = showing("picture", Pattern::image);
    Placed cropped = photograph;
    for (Mesh& m : cropped.piece.meshes)
        for (Vec3f& c : m.coords) c = c * 0.9f;
    cropped.piece.form.clear();
    EXPECT_EQ(repeats({photograph, cropped}), 1);
}

TEST(RepeatedForms, SetsAreNone) {
    Placed chair = made("chair", 1);
    const Placed table = made("dining_table", 1);
    EXPECT_EQ(repeats({table, chair, chair}), 1);
    chair.with = 0;
    EXPECT_EQ(repeats({table, chair, chair}), 0) << "at one table";

    Placed asked = made("plant", 1);
    asked.wish.kind = "plant", asked.wish.id = 0, asked.wish.count = 2;
    EXPECT_EQ(repeats({asked, asked}), 0) << "\"two plants\"";
    asked.wish.count = 1;
    EXPECT_EQ(repeats({asked, asked}), 1);

    const Placed bed = made("bed", 1);
    Placed left = made("nightstand", 1), lamp = made("table_lamp", 1);
    left.with = 0;
    Placed right = left, other = lamp;
    lamp.on = 1, other.on = 2;
    EXPECT_EQ(repeats({bed, left, right, lamp, other}), 0) << "lamps on the nightstands of one bed";
    other.on = 0;
    EXPECT_EQ(repeats({bed, left, right, lamp, other}), 1);
    other.on = 1;
    EXPECT_EQ(repeats({bed, left, right, lamp, other}), 1) << "two lamps on one nightstand";

    Placed candle = made("candle", 1);
    EXPECT_EQ(repeats({table, candle, candle}), 1);
    candle.on = 0;
    EXPECT_EQ(repeats({table, candle, candle}), 0) << "candles come in groups";
    EXPECT_EQ(repeats({made("radiator", 1), made("radiator", 1)}), 0) << "the house is fitted with them";
    EXPECT_EQ(repeats({made("waiting_chairs", 1), made("waiting_chairs", 1)}), 0) << "bought alike";
}

}  // namespace
}  // namespace fastscene

#include <gtest/gtest.h>

#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/base/random.h"
#include "fastscene/scene/walkable_json.h"

namespace fastscene {
namespace {

std::vector<Vec2f> square(float x0, float z0, float x1, float z1) { return {{x0, z0}, {x1, z0}, {x1, z1}, {x0, z1}}; }

// A room of 4 m x 4 m with an island and a separate alcove.
WalkableArea room() {
    return {{square(-1, 0, 1, 1), square(-2, -2, 2, 2), square(3, 0, 3.5f, 0.5f)}, -0.5f, 0.7f, 1.5f};
}

float distance(Vec2f a, Vec2f b) { return std::hypot(a.x - b.x, a.y - b.y); }

TEST(Walkable, HolesAreNotFloor) {
    const WalkableArea area = room();
    EXPECT_TRUE(contains(area, Vec2f{0, -1}));
    EXPECT_TRUE(contains(area, Vec2f{3.2f, 0.2f}));
    EXPECT_FALSE(contains(area, Vec2f{0, 0.5f}));
    EXPECT_FALSE(contains(area, Vec2f{2.5f, 0.2f}));
    EXPECT_FALSE(contains(WalkableArea{}, Vec2f{0, 0}));
}

TEST(Walkable, EyesStayBetweenTheirHeights) {
    const WalkableArea area = room();
    EXPECT_TRUE(contains(area, Vec3f{0, 0.6f, -1}));
    EXPECT_FALSE(contains(area, Vec3f{0, 0.8f, -1}));
    EXPECT_FALSE(contains(area, Vec3f{0, -0.6f, -1}));
    const Vec3f held = nearest_inside(area, Vec3f{0, -2, -1});
    EXPECT_EQ(held, (Vec3f{0, -0.5f, -1}));
}

// … whose half at z > 0 is raised by 0.4 m.
WalkableArea raised_room() {
    WalkableArea area{{square(-2, -2, 2, 2)}, -0.5f, 0.7f, 1.5f};
    area.levels = {{{square(-2, -2, 2, 0)}, 1.5f}, {{square(-2, 0, 2, 2)}, 1.1f}};
    return area;
}

TEST(Walkable, OnTiersEyesAreAsMuchHigher) {
    const WalkableArea area = raised_room();
    EXPECT_EQ(floor_at(area, {0, -1}), 1.5f);
    EXPECT_EQ(floor_at(area, {0, 1}), 1.1f);
    EXPECT_EQ(floor_at(area, {0, 9}), 1.1f) << "the nearest part";
    EXPECT_EQ(floor_at(room(), {0, 1}), 1.5f);
    EXPECT_TRUE(contains(area, Vec3f{0, 0.6f, -1}) && !contains(area, Vec3f{0, 0.6f, 1}));
    EXPECT_TRUE(contains(area, Vec3f{0, -0.8f, 1}) && !contains(area, Vec3f{0, -0.8f, -1}));
    EXPECT_NEAR(nearest_inside(area, Vec3f{0, -2, 1}).y, -0.9f, 1e-6f);
    EXPECT_NEAR(nearest_inside(area, Vec3f{0, 2, 1}).y, 0.3f, 1e-6f);
}

TEST(Walkable, JsonKeepsLevelsAndALevelFloorHasNone) {
    EXPECT_FALSE(walkable_json(room()).contains("levels"));
    const Json json = walkable_json(raised_room());
    const WalkableArea again = walkable_from_json(json, "walkable.json");
    ASSERT_EQ(again.levels.size(), 2u);
    EXPECT_EQ(again.levels[1].floor_y, 1.1f);
    EXPECT_EQ(again.levels[1].rings_m, raised_room().levels[1].rings_m);
    EXPECT_EQ(walkable_json(again), json);
    for (const Json& wrong : {Json(3), Json{{{"floor_y_m", 1}}}, Json{{{"rings_m", Json::array()}}}}) {
        Json broken = json;
        broken["levels"] = wrong;
        EXPECT_THROW(walkable_from_json(broken, "walkable.json"), Error) << wrong.dump();
    }
}

TEST(Walkable, NearestInsideIsInsideAndNoNearerPlaceIs) {
    const WalkableArea area = room();
    Random random(3, "walkable");
    for (int k = 0; k < 300; ++k) {
        const Vec2f p{random.uniform(-4, 4), random.uniform(-4, 4)}, q = nearest_inside(area, p);
        ASSERT_TRUE(contains(area, q)) << p.x << ' ' << p.y;
        if (contains(area, p)) {
            ASSERT_EQ(p, q);
        }
        // No other position on the floor is nearer, except for the millimetre that keeps q off the boundary.
        for (int i = 0; i < 50; ++i) {
            const Vec2f other{random.uniform(-2, 3.5f), random.uniform(-2, 2)};
            if (contains(area, other)) {
                ASSERT_LE(distance(p, q), distance(p, other) + 2e-3f);
            }
        }
    }
}

TEST(Walkable, TheNearestPlaceOfAnAcuteCornerIsInside) {
    const WalkableArea needle{{{{0, 0}, {1, 0.02f}, {1, -0.02f}}}, 0, 0, 0};
    const Vec2f q = nearest_inside(needle, Vec2f{-1, 0});
    EXPECT_TRUE(contains(needle, q));
    EXPECT_LT(q.x, 0.2f);
}

TEST(Walkable, JsonHoldsTheLargestOutlineHeightsAboveTheFloorAndEverythingElse) {
    const Json json = walkable_json(room());
    EXPECT_EQ(json["polygon_m"], (Json{{-2.0, -2.0}, {2.0, -2.0}, {2.0, 2.0}, {-2.0, 2.0}}));
    EXPECT_EQ(json["eye_heights_m"], (Json{0.8, 2.0}));
    const WalkableArea back = walkable_from_json(Json::parse(json.dump()), "report.json");
    EXPECT_EQ(back.rings_m, room().rings_m);
    EXPECT_FLOAT_EQ(back.low_y, -0.5f);
    EXPECT_FLOAT_EQ(back.high_y, 0.7f);
    EXPECT_FLOAT_EQ(back.floor_y, 1.5f);
}

TEST(Walkable, WithoutRingsTheAreaIsThePolygon) {
    Json json = walkable_json(room());
    json.erase("rings_m");
    EXPECT_EQ(walkable_from_json(json, "report.json").rings_m, std::vector<std::vector<Vec2f>>{square(-2, -2, 2, 2)});
}

TEST(Walkable, WrongJsonIsNamed) {
    const auto message = [](const char* name, const Json& value) {
        Json json = walkable_json(room());
        if (value.is_null()) json.erase(name);
        else json[name] = value;
        try {
            walkable_from_json(json, "report.json");
        } catch (const Error& e) {
            return std::string(e.what());
        }
        return std::string("no error");
    };
    for (const auto& [name, value] :
         std::vector<std::pair<const char*, Json>>{{"floor_y_m", nullptr},
                                                   {"floor_y_m", "low"},
                                                   {"eye_heights_m", nullptr},
                                                   {"eye_heights_m", {2, 1}},
                                                   {"eye_heights_m", {1, 2, 3}},
                                                   {"rings_m", 4},
                                                   {"rings_m", Json::array({Json::array({1, 2})})},
                                                   {"rings_m", Json::array({Json::array({{1, 2}, {3, 4}, {5}})})}}) {
        const std::string said = message(name, value);
        EXPECT_NE(said.find("report.json"), std::string::npos) << said;
        EXPECT_NE(said.find(name), std::string::npos) << said;
        EXPECT_NE(said.find("expected"), std::string::npos) << said;
    }
    EXPECT_THROW(walkable_from_json(Json::array(), "report.json"), Error);
}

}  // namespace
}  // namespace fastscene

// Floors with levels: tiers that one can walk up, on which everything stands that belongs there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "fastscene/base/error.h"
#include "fastscene/rooms/document.h"
#include "fastscene/rooms/room_type.h"
#include "fastscene/rooms/test_prompts.h"
#include "fastscene/rooms/validate.h"
#include "fastscene/scene/raised_floor.h"

namespace fastscene {
namespace {

constexpr const char* kTieredHalls[] = {"a cinema", "a lecture hall", "an auditorium", "a concert hall",
                                        "a home cinema"};

struct Hall {
    PromptSpec spec;
    FurnishedRoom room;
    const Plan& plan() const { return room.plan; }
    float highest() const {
        float h = 0;
        for (const Platform& p : plan().platforms) h = std::max(h, p.height);
        return h;
    }
};
Hall hall(const std::string& prompt, std::uint64_t seed = 1) {
    Hall h;
    h.spec = read(prompt);
    h.room = furnish_room(h.spec, {seed, nullptr, {}});
    return h;
}

// The heights of the floor along a line of one x, from the far wall to the near one, in steps of a centimetre.
std::vector<float> floor_along(const Plan& plan, float x) {
    std::vector<float> out;
    for (float z = plan.depth / 2 - 0.01f; z > -plan.depth / 2; z -= 0.01f) out.push_back(plan.floor_at({x, z}));
    return out;
}
float steepest(const std::vector<float>& heights) {
    float most = 0;
    for (std::size_t i = 1; i < heights.size(); ++i) most = std::max(most, std::abs(heights[i] - heights[i - 1]));
    return most;
}

TEST(Levels, TheFloorIsTheHighestPlatformAtAPoint) {
    Plan plan;
    EXPECT_EQ(plan.floor_at({0, 0}), 0.f);
    plan.platforms = {{Platform::Kind::tier, {-2, -2.5f}, {2, -1}, 0.4f},
                      {Platform::Kind::step, {-0.5f, -1}, {0.5f, -0.6f}, 0.2f},
                      {Platform::Kind::tier, {-2, -2.5f}, {2, -2}, 0.8f}};
    EXPECT_EQ(plan.floor_at({0, 0}), 0.f);
    EXPECT_EQ(plan.floor_at({0, -0.8f}), 0.2f);
    EXPECT_EQ(plan.floor_at({1, -0.8f}), 0.f);
    EXPECT_EQ(plan.floor_at({1, -1.5f}), 0.4f);
    EXPECT_EQ(plan.floor_at({1, -2.2f}), 0.8f);
    const auto box = [](float z, float y0) { return Footprint{{1, z}, {0.3f, 0.3f}, 0, y0, y0 + 1}; };
    EXPECT_EQ(plan.floor_below(box(-1.f, 0)), 0.4f);
    EXPECT_FALSE(plan.is_level(box(-1.f, 0)));
    EXPECT_TRUE(plan.is_level(box(-1.5f, 0)) && plan.is_level(box(-0.5f, 0)));
    EXPECT_FALSE(plan.holds(box(-1.5f, 0)));
    EXPECT_TRUE(plan.holds(box(-1.5f, 0.4f)));
    EXPECT_NEAR(plan.air_around({1, 1.f, -1.5f}), 0.6f, 1e-4f);
    EXPECT_EQ(plan.floor_before(plan.wall(2), 0.1f, 1.f), 0.8f);
    EXPECT_EQ(plan.floor_before(plan.wall(0), 0.1f, 1.f), 0.f);
    // Beside the tiers there is no wall for a door; without them there is.
    EXPECT_EQ(plan.free_span(1, 2.f).second - plan.free_span(1, 2.f).first, plan.depth);
    EXPECT_NEAR(plan.free_span(1, 2.f, true).second - plan.free_span(1, 2.f, true).first, 3.5f, 1e-4f);
}

TEST(Levels, OneWalksUpFromTheDoorToTheHighestRow) {
    for (const char* prompt : kTieredHalls)
        for (std::uint64_t seed = 1; seed < 5; ++seed) {
            SCOPED_TRACE(fmt::format("{} {}", prompt, seed));
            const Hall h = hall(prompt, seed);
            ASSERT_GT(h.highest(), 0.f);
            const std::vector<float> aisle = floor_along(h.plan(), 0);
            EXPECT_EQ(aisle.front(), 0.f);
            EXPECT_EQ(aisle.back(), h.highest());
            EXPECT_TRUE(std::is_sorted(aisle.begin(), aisle.end()));
            EXPECT_LE(steepest(aisle), kMostStep + 1e-4f);
            EXPECT_GT(h.plan().height - h.highest(), 2.2f);
            for (const Opening& o : h.plan().openings) {
                const float floor = h.plan().floor_before(h.plan().wall(o.wall), o.u0, o.u1);
                if (o.kind == Opening::Kind::window) {
                    EXPECT_GT(o.y0, floor + 0.5f);
                } else {
                    EXPECT_EQ(floor, 0.f);
                }
            }
            Ways ways(h.plan());
            for (const Placed& p : h.room.placed) ways.add(p);
            EXPECT_TRUE(ways.open());
            EXPECT_TRUE(ways.reaches({0, -h.plan().depth / 2 + 0.5f}) || h.plan().depth < 8);
        }
}

TEST(Levels, SeatsStandOnTheirTiers) {
    for (const char* prompt : kTieredHalls) {
        SCOPED_TRACE(prompt);
        const Hall h = hall(prompt);
        std::set<float> levels;
        for (const Placed& p : h.room.placed) {
            if (p.piece.mount != Mount::floor || p.on >= 0) continue;
            EXPECT_NEAR(p.position.y, h.plan().floor_at(flat(p.position)), 1e-4f) << p.piece.kind;
            levels.insert(p.position.y);
        }
        std::set<float> tiers{0.f};
        for (const Platform& p : h.plan().platforms)
            if (p.kind == Platform::Kind::tier) tiers.insert(p.height);
        EXPECT_EQ(levels, tiers);
        EXPECT_TRUE(room_faults(h.plan(), h.room.placed, h.room.camera).empty());
        EXPECT_NEAR(h.room.camera.y, h.plan().floor_at(flat(h.room.camera)) + kEyeHeight, 1e-4f);
        EXPECT_GT(h.room.camera.y, kEyeHeight);  // it looks over the rows
    }
}

TEST(Levels, AllSeatsAreAsTheyWereAskedFor) {
    const auto colors = [](const Hall& h) {
        std::map<std::string, int> out;
        for (const Placed& p : h.room.placed)
            if (p.piece.kind == "cinema_seat") ++out[p.piece.made_from->color_name];
        return out;
    };
    const auto blue = colors(hall("a cinema with blue seats"));
    ASSERT_EQ(blue.size(), 1u);
    EXPECT_GT(blue.at("blue"), 30);
    EXPECT_EQ(colors(hall("a lecture hall with 20 blue seats")), (std::map<std::string, int>{{"blue", 20}}));
}

TEST(Levels, WhatHangsBesideATierHangsAboveIt) {
    const Hall h = hall("a cinema");
    int above = 0;
    for (const Placed& p : h.room.placed) {
        if (p.piece.mount != Mount::wall) continue;
        const float floor = h.plan().floor_below(footprint_of(p));
        EXPECT_GT(p.position.y, floor + 0.5f) << p.piece.kind;
        above += floor > 0;
    }
    EXPECT_GT(above, 4);
}

TEST(Levels, RoomsOfAnySizeAreSound) {
    for (const char* prompt : {"a cinema of 6 m²", "a cinema 4 m wide and 12 m deep", "a cinema with a low ceiling",
                               "a lecture hall of 30 m²", "a lecture hall with three windows", "an empty cinema",
                               "a lecture hall 2.4 m high", "an auditorium with a doorway to a lobby",
                               "a concert hall with an arched door", "a cinema with two sofas and a rug"})
        for (std::uint64_t seed = 1; seed < 4; ++seed) {
            SCOPED_TRACE(fmt::format("{} {}", prompt, seed));
            const Hall h = hall(prompt, seed);
            for (const Fault& fault : room_faults(h.plan(), h.room.placed, h.room.camera))
                ADD_FAILURE() << fault.kind << ": " << fault.text;
            EXPECT_GT(h.plan().height - h.highest(), 2.05f);
            EXPECT_LE(steepest(floor_along(h.plan(), 0)), kMostStep + 1e-4f);
        }
}

TEST(Levels, OtherRoomsAreLevel) {
    const auto rises = [](const std::vector<RecipeStep>& steps) {
        return std::any_of(steps.begin(), steps.end(), [](const RecipeStep& s) { return s.rise_m > 0; });
    };
    for (const RoomType& type : all_room_types()) {
        PromptSpec spec;
        spec.room = type.name;
        Random rng(1, "levels");
        const Plan plan = make_plan(spec, rng);
        EXPECT_EQ(plan.platforms.empty(), !rises(recipe_of(type.name))) << type.name;
    }
}

TEST(Levels, TheShellHasAClosedBoxForEach) {
    Hall h = hall("a cinema");
    const Room room = room_of(h.spec, h.room, {1, nullptr, {}});
    std::size_t boxes = 0;
    for (std::size_t i = 0; i < room.objects.size(); ++i) {
        if (!is_raised_floor(room.objects[i])) continue;
        ++boxes;
        float top = 1e9f;
        for (const Mesh& m : room.meshes)
            if (m.object == static_cast<int>(i))
                for (const Vec3f p : m.positions) top = std::min(top, p.y);
        EXPECT_NEAR(top, (room.objects[i].world_from_object * Vec3f{0, room.objects[i].size_m.y, 0}).y, 0.006f);
    }
    EXPECT_EQ(boxes, h.plan().platforms.size());
}

TEST(Levels, DocumentsKeepThem) {
    const Hall h = hall("a lecture hall");
    const RoomDocument document = document_of(h.spec, h.room, 1);
    const RoomDocument again = read_document(document_json(document).dump(), "room.json");
    ASSERT_EQ(again.plan.platforms.size(), h.plan().platforms.size());
    const DocumentRoom built = furnish_document(again, "room.json", nullptr, {});
    for (std::size_t i = 0; i < again.plan.platforms.size(); ++i) {
        const Platform &a = h.plan().platforms[i], &b = built.furnished.plan.platforms[i];
        EXPECT_TRUE(a.kind == b.kind && a.low == b.low && a.high == b.high && a.height == b.height);
    }
    EXPECT_TRUE(room_faults(built.furnished.plan, built.furnished.placed, built.furnished.camera).empty());
}

TEST(Levels, ADocumentWithoutAWordOfTheFloorStandsOnIt) {
    const RoomDocument document = read_document(
        R"({"format": "fastscene-room", "version": 1, "room": "cinema", "things": [
            {"id": "plant", "kind": "plant", "position": [3.8, 0, -5.2]}]})",
        "room.json");
    const DocumentRoom built = furnish_document(document, "room.json", nullptr, {});
    ASSERT_FALSE(built.furnished.plan.platforms.empty());
    const Placed& plant = built.furnished.placed.front();
    EXPECT_GT(plant.position.y, 0.5f);
    EXPECT_EQ(plant.position.y, built.furnished.plan.floor_at(flat(plant.position)));
}

TEST(Levels, BadPlatformsAreNamed) {
    const auto error = [](const std::string& platform) {
        try {
            const RoomDocument document = read_document(
                R"({"format": "fastscene-room", "version": 1, "room": "cinema", "plan": {"height_m": 4, "platforms": [)" +
                    platform + "]}}",
                "room.json");
            (void)furnish_document(document, "room.json", nullptr, {});
        } catch (const Error& e) {
            return std::string(e.what());
        }
        return std::string("no error");
    };
    EXPECT_NE(error(R"({"low": [0, 0], "high": [0, 1], "height_m": 0.4})").find("/plan/platforms/0: expected low"),
              std::string::npos);
    EXPECT_NE(error(R"({"low": [0, 0], "high": [1, 1], "height_m": 3})").find("/plan/platforms/0: height_m: expected"),
              std::string::npos);
    EXPECT_NE(error(R"({"low": [0, 0], "high": [1, 1]})").find("height_m"), std::string::npos);
}

}  // namespace
}  // namespace fastscene

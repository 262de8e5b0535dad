// What hangs on walls, how much of them is left bare, and what stands in line along them.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "fastscene/rooms/furniture/print.h"
#include "fastscene/rooms/furniture/wall/motifs.h"
#include "fastscene/rooms/furniture/wall/panels.h"
#include "fastscene/rooms/layout.h"
#include "fastscene/rooms/layout_relations.h"
#include "fastscene/rooms/room_type.h"
#include "fastscene/rooms/rooms.h"

namespace fastscene {
namespace {

struct WalledRoom {
    Plan plan;
    std::vector<Placed> placed;
};

WalledRoom walled(const std::string& text, std::uint64_t seed) {
    PromptSpec spec = understand_prompt(text, false);
    Random rng(seed, "wall test");
    WalledRoom out{make_plan(spec, rng), {}};
    Layout layout(out.plan, spec, rng);
    furnish(layout);
    out.placed = layout.placed();
    return out;
}

// The longest stretch of a wall without a door, a window, a thing that hangs or a tall one that stands at it, between
// the heights at which one looks.
float longest_bare_stretch(const WalledRoom& room, int wall) {
    constexpr float kLow = 1.0f, kHigh = 2.0f, kStep = 0.1f, kAtWall = 0.7f;
    const WallFace face = room.plan.wall(wall);
    float longest = 0, bare = 0;
    for (float u = 0; u < face.length; u += kStep) {
        const float floor = room.plan.floor_before(face, u, u + kStep);
        const Footprint column{flat(face.point(u, 0) + face.inward * (kAtWall / 2)),
                               {kStep / 2, kAtWall / 2},
                               yaw_of(face.inward),
                               floor + kLow,
                               floor + kHigh};
        const bool taken = !wall_is_free(room.plan, face, u, u + kStep, floor + kLow, floor + kHigh) ||
                           std::any_of(room.placed.begin(), room.placed.end(), [&](const Placed& p) {
                               return !p.overhead && overlap(column, footprint_of(p));
                           });
        bare = taken ? 0 : bare + kStep;
        longest = std::max(longest, bare);
    }
    return longest;
}

TEST(Walls, OfPublicRoomsAreNotLeftBare) {
    constexpr float kMostBare = 4.f;  // metres, between two groups of posters
    for (const std::string text : {"a bakery", "a casino", "a classroom", "a concert hall", "an auditorium", "a lobby",
                                   "a fast food restaurant", "a bowling alley", "a toy store"})
        for (const std::uint64_t seed : {1, 2, 3}) {
            const WalledRoom room = walled(text, seed);
            for (int wall = 0; wall < 4; ++wall)
                EXPECT_LT(longest_bare_stretch(room, wall), kMostBare)
                    << text << ", seed " << seed << ", wall " << wall;
        }
}

void expect_topics(const std::vector<RecipeStep>& steps, const std::string& room, int& count) {
    for (const RecipeStep& step : steps) {
        if (step.thing == "poster" || step.thing == "billboard") {
            ++count;
            EXPECT_TRUE(furniture::is_poster_topic(step.pattern) || furniture::is_motif(step.pattern))
                << room << ": \"" << step.pattern << "\"";
        }
        expect_topics(step.then, room, count);
    }
}

TEST(Walls, HaveOnlyPostersOnKnownTopics) {
    int count = 0;
    for (const RoomType& type : all_room_types()) expect_topics(type.recipe, type.name, count);
    EXPECT_GT(count, 50);
}

TEST(Walls, HaveNoPosterTwiceUntilAllAreUp) {
    for (const std::string text : {"a cinema", "a gym", "a video store", "a classroom", "a fast food restaurant"})
        for (const std::uint64_t seed : {1, 2, 3}) {
            std::set<std::string> forms;
            int posters = 0;
            for (const Placed& p : walled(text, seed).placed)
                if (p.piece.kind == "poster") ++posters, forms.insert(p.piece.form);
            EXPECT_GE(static_cast<int>(forms.size()), std::min(posters, 6)) << text << ", seed " << seed;
        }
}

TEST(Walls, SayInLettersWhatTheRecipeSays) {
    const WalledRoom room = walled("a bakery", 1);
    const auto letters = std::find_if(room.placed.begin(), room.placed.end(),
                                      [](const Placed& p) { return p.piece.kind == "wall_letters"; });
    ASSERT_NE(letters, room.placed.end());
    EXPECT_EQ(letters->piece.made_from->pattern, "BAKERY");
    EXPECT_GT(letters->position.y, 1.8f);
    // Wide, flat and as high as a letter of that width is.
    EXPECT_NEAR(letters->piece.size_m.x / letters->piece.size_m.y, 5.4f, 1.f);
}

// A picture over several frames: all of its panels hang side by side, in their order for who looks at the wall.
TEST(WallArt, PanelsAreOnePicture) {
    int groups = 0;
    for (const std::string text : {"a living room", "a modern bedroom", "a study", "a dining room"})
        for (std::uint64_t seed = 1; seed <= 12; ++seed) {
            SCOPED_TRACE(text + ", seed " + std::to_string(seed));
            const WalledRoom room = walled(text, seed);
            const Placed* before = nullptr;
            int expected = 0;
            for (const Placed& p : room.placed) {
                const auto panel = p.piece.made_from ? furniture::panel_of(p.piece.made_from->pattern) : std::nullopt;
                if (!panel) continue;
                EXPECT_EQ(panel->number, expected);
                if (expected > 0) {
                    const Vec3f step = p.position - before->position;
                    EXPECT_NEAR(dot(step, right_of(p.yaw)), p.piece.size_m.x + furniture::kPanelGap_m, 1e-3f);
                    EXPECT_NEAR(step.y, 0, 1e-4f);
                    EXPECT_EQ(p.yaw, before->yaw);
                    EXPECT_EQ(p.piece.made_from->seed, before->piece.made_from->seed);
                }
                groups += expected == 0;
                expected = panel->number + 1 == panel->of ? 0 : expected + 1;
                before = &p;
            }
            EXPECT_EQ(expected, 0) << "a panel is missing";
        }
    EXPECT_GT(groups, 2);
}

TEST(WallArt, HangsAtTheHeightOfEyes) {
    int looked = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed)
        for (const Placed& p : walled("a living room", seed).placed)
            if (p.piece.kind == "picture" && p.with < 0 && p.on < 0 && p.piece.mount == Mount::wall) {
                EXPECT_NEAR(p.position.y + p.piece.size_m.y / 2, 1.52f, 0.2f) << "seed " << seed;
                ++looked;
            }
    EXPECT_GT(looked, 12);
}

TEST(Kitchens, HaveOneFridgeAtAnEndOfTheUnits) {
    int rooms = 0, in_line = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const WalledRoom room = walled("a kitchen", seed);
        const Placed *units = nullptr, *fridge = nullptr;
        for (const Placed& p : room.placed) {
            if (p.piece.kind == "kitchen_counter" && !units) units = &p;
            if (p.piece.kind != "fridge") continue;
            EXPECT_EQ(fridge, nullptr) << "seed " << seed << " has two";
            fridge = &p;
        }
        if (!units || !fridge) continue;
        ++rooms;
        in_line += gap_between(footprint_of(*units), footprint_of(*fridge)) < 0.2f && units->yaw == fridge->yaw;
    }
    EXPECT_GE(rooms, 15);
    EXPECT_GE(in_line, 0.75 * rooms);
}

TEST(Tables, AreLaidForMostOrNotAtAll) {
    int laid_tables = 0;
    for (std::uint64_t seed = 1; seed <= 16; ++seed) {
        int chairs = 0, settings = 0;
        for (const Placed& p : walled("a dining room", seed).placed)
            chairs += p.piece.kind == "chair", settings += p.piece.kind == "place_setting";
        EXPECT_TRUE(settings == 0 || 2 * settings >= chairs)
            << "seed " << seed << ": " << settings << " for " << chairs;
        laid_tables += settings > 0;
    }
    EXPECT_GE(laid_tables, 5);
}

}  // namespace
}  // namespace fastscene

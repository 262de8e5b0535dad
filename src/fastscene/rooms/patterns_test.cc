// Patterns of public rooms under wishes: who names the seats, the tables or the windows of a room without a number
// means those that it has.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "fastscene/rooms/test_prompts.h"

namespace fastscene {
namespace {

struct PatternedRoom {
    PromptSpec spec;
    FurnishedRoom room;
    int count(const std::string& kind) const {
        return static_cast<int>(std::count_if(room.placed.begin(), room.placed.end(),
                                              [&](const Placed& p) { return p.piece.kind == kind; }));
    }
    // … made in this color.
    int count(const std::string& kind, const std::string& color) const {
        return static_cast<int>(std::count_if(room.placed.begin(), room.placed.end(), [&](const Placed& p) {
            return p.piece.kind == kind && p.piece.made_from->color_name == color;
        }));
    }
};
PatternedRoom patterned_room(const std::string& prompt, std::uint64_t seed = 1) {
    PatternedRoom out;
    out.spec = read(prompt);
    out.room = furnish_room(out.spec, {seed, nullptr, {}});
    return out;
}

TEST(Patterns, VagueNumbersKeepThem) {
    struct Case {
        const char *plain, *asked, *kind;
    };
    for (const Case& c : {Case{"a cinema", "a cinema with rows of red velvet seats", "cinema_seat"},
                          {"an auditorium", "an auditorium with many folding seats", "cinema_seat"},
                          {"a classroom", "a classroom with several desks", "school_desk"},
                          {"a church", "a church with rows of pews", "pew"},
                          {"a computer room", "a computer room with rows of computers", "computer_desk"},
                          {"a bus", "a bus with rows of green seats", "bus_seat"}}) {
        const int usual = patterned_room(c.plain).count(c.kind), asked = patterned_room(c.asked).count(c.kind);
        EXPECT_GT(usual, 3) << c.plain;
        // The room's size is drawn anew for another sentence.
        EXPECT_GE(asked, usual / 2) << c.asked;
    }
}

TEST(Patterns, ALookWithoutANumberIsThatOfAll) {
    const PatternedRoom school = patterned_room("a classroom with blue desks");
    EXPECT_EQ(school.count("school_desk", "blue"), school.count("school_desk"));
    const PatternedRoom restaurant = patterned_room("a restaurant with tables and red chairs");
    EXPECT_GE(restaurant.count("chair"), 2 * restaurant.count("dining_table"));
    EXPECT_EQ(restaurant.count("chair", "red"), restaurant.count("chair"));
    EXPECT_GT(restaurant.count("dining_table"), 2);
}

// A number of pallets says nothing of the racks, whose name begins alike.
TEST(Patterns, ANumberIsOfThatKindAlone) {
    EXPECT_GT(patterned_room("a warehouse with three pallets").count("pallet_rack"), 3);
    EXPECT_EQ(patterned_room("a living room with two plants").count("plant_tree"), 0);
}

TEST(Patterns, ANumberIsKept) {
    EXPECT_EQ(patterned_room("a restaurant with four tables").count("dining_table"), 4);
    EXPECT_EQ(patterned_room("a meeting room with a table and six chairs").count("chair"), 6);
}

TEST(Patterns, WindowsThatAreAskedForAreTheRoomsOwn) {
    const PatternedRoom plain = patterned_room("a train station"),
                        arched = patterned_room("a train station with arched windows");
    const auto windows = [](const PatternedRoom& r, bool only_arched) {
        return std::count_if(r.room.plan.openings.begin(), r.room.plan.openings.end(), [&](const Opening& o) {
            return o.kind == Opening::Kind::window && (!only_arched || o.shape == Opening::Shape::arched);
        });
    };
    EXPECT_GT(windows(plain, false), 2);
    EXPECT_GT(windows(arched, true), 2);
    EXPECT_EQ(windows(arched, true), windows(arched, false));
    EXPECT_EQ(arched.count("platform_train"), 1);  // no window stands where the train does
    EXPECT_EQ(windows(patterned_room("a classroom with two windows"), false), 2);
}

}  // namespace
}  // namespace fastscene

// Rooms that cannot be as they are asked for: made as far as it goes, the rest told.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "fastscene/rooms/layout.h"
#include "fastscene/rooms/test_prompts.h"

namespace fastscene {
namespace {

struct Made {
    PromptSpec spec;
    FurnishedRoom room;
};
Made made(const std::string& text) {
    Made out{read(text), {}};
    out.room = furnish_room(out.spec, {1, nullptr, {}});
    return out;
}
std::ptrdiff_t count(const Made& made, std::string_view kind) {
    return std::count_if(made.room.placed.begin(), made.room.placed.end(),
                         [&](const Placed& p) { return p.piece.kind == kind; });
}
bool is_told(const Made& made, std::string_view words, std::string_view part) {
    return std::any_of(made.spec.words.begin(), made.spec.words.end(), [&](const PromptWord& w) {
        return w.words == words && w.fate == PromptWord::Fate::approximated &&
               w.meaning.find(part) != std::string::npos;
    });
}

TEST(BadInput, ATinyCinemaHasItsScreenAndARow) {
    const Made m = made("a cinema of 6 m²");
    EXPECT_EQ(m.spec.room, "cinema");
    EXPECT_NEAR(m.room.plan.width * m.room.plan.depth, 6.f, 0.7f);
    EXPECT_GE(count(m, "projector_screen"), 1);
    EXPECT_GE(count(m, "cinema_seat"), 1);
}

TEST(BadInput, ABusFortyMetresWideIsAsWideAsRoomsGet) {
    const Made m = made("a bus 40 m wide");
    EXPECT_EQ(m.spec.room, "bus");
    EXPECT_GE(count(m, "bus_seat"), 4);
    EXPECT_LT(m.room.plan.width, 20.f);
    EXPECT_TRUE(is_told(m, "40 m", "the room is"));
}

TEST(BadInput, AChurchWithoutARoofHasOne) {
    const Made m = made("a church without a roof");
    EXPECT_EQ(m.spec.room, "church");
    EXPECT_GE(count(m, "pew"), 4);
    EXPECT_TRUE(is_told(m, "roof", "every room is built with one"));
}

TEST(BadInput, AStaircaseInALowRoomIsLeftOut) {
    const Made m = made("a staircase in a room 1.9 m high");
    EXPECT_EQ(count(m, "staircase"), 0);
    EXPECT_LT(m.room.plan.height, 2.2f);
    EXPECT_TRUE(is_told(m, "1.9 m", "m high"));
    EXPECT_TRUE(is_told(m, "staircase", "too small for its staircase"));
}

TEST(BadInput, APoolDoesNotFitIntoAnAttic) {
    const Made m = made("a pool in an attic");
    EXPECT_EQ(m.spec.room, "attic");
    EXPECT_TRUE(std::any_of(m.spec.not_placed.begin(), m.spec.not_placed.end(),
                            [](const std::string& line) { return line.starts_with("pool: "); }));
}

}  // namespace
}  // namespace fastscene

// Laws of edits that arrange several things at once: desks back to back, tables side by side, guests at one side.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "fastscene/base/error.h"
#include "fastscene/rooms/edit.h"

namespace fastscene {
namespace {

const fastscene::Run kTogetherRun{6, nullptr, {}};

RoomDocument planned(const std::string& prompt, std::uint64_t seed) {
    PromptSpec spec = understand_prompt(prompt, false);
    return plan_document(spec, {seed, nullptr, {}});
}

Footprint outline_of(const DocumentThing& t) {
    return {flat(t.position), {t.size_m.x / 2, t.size_m.z / 2}, t.yaw, t.position.y, t.position.y + t.size_m.y};
}

std::vector<const DocumentThing*> those_of(const RoomDocument& room, const std::string& kind) {
    std::vector<const DocumentThing*> out;
    for (const DocumentThing& t : room.things)
        if (t.kind == kind) out.push_back(&t);
    return out;
}

const DocumentThing& called(const RoomDocument& room, const std::string& id) {
    return *std::find_if(room.things.begin(), room.things.end(), [&](const DocumentThing& t) { return t.id == id; });
}

// Nothing: it is refused.
std::optional<EditResult> edited(const RoomDocument& room, const std::string& sentence) {
    try {
        return edit_by_sentence(room, sentence, nullptr, kTogetherRun);
    } catch (const Error&) {
        return {};
    }
}

bool tells(const EditResult& result, const std::string& words) {
    return std::any_of(result.changes.begin(), result.changes.end(),
                       [&](const EditChange& c) { return (c.id + ": " + c.what).find(words) != std::string::npos; });
}

// The backs of two desks touch, and each chair is before its own.
TEST(EditTogether, DesksFaceEachOtherBackToBack) {
    int joined = 0;
    for (const std::uint64_t seed : {7105u, 31u, 32u, 33u}) {
        const RoomDocument room = planned("a home office with two desks", seed);
        EditResult result;
        try {
            result = edit_by_sentence(room, "put the desks together in the middle of the room facing each other",
                                      nullptr, kTogetherRun);
        } catch (const Error& e) {
            EXPECT_NE(std::string(e.what()).find("no free floor"), std::string::npos) << e.what();
            continue;
        }
        const auto desks = those_of(result.document, "desk");
        ASSERT_EQ(desks.size(), 2u) << seed;
        ++joined;
        const Vec3f a = front_of(desks[0]->yaw), b = front_of(desks[1]->yaw);
        EXPECT_LT(dot(a, b), -0.99f) << seed;
        const Vec3f to = desks[1]->position - desks[0]->position;
        const float deep = (desks[0]->size_m.z + desks[1]->size_m.z) / 2;
        EXPECT_NEAR(dot(to, a), -deep, 0.05f) << seed;
        const Vec3f middle = (desks[0]->position + desks[1]->position) * 0.5f;
        EXPECT_LT(length(flat(middle)), 1.5f) << seed;
        for (const DocumentThing& t : result.document.things)
            for (const DocumentThing* desk : desks) {
                if (t.with != desk->id || t.kind.find("chair") == std::string::npos) continue;
                EXPECT_GT(dot(t.position - desk->position, front_of(desk->yaw)), desk->size_m.z / 2) << t.id;
            }
    }
    EXPECT_GT(joined, 1);
}

// Two tables touch, their chairs are at them still, and no other table moved.
TEST(EditTogether, TwoTablesOfACafeTouch) {
    int joined = 0;
    for (const std::uint64_t seed : {7108u, 41u, 42u}) {
        const RoomDocument room = planned("a cafe with six tables", seed);
        const auto result = edited(room, "push two of the tables together");
        if (!result) continue;
        std::vector<const DocumentThing*> moved;
        int touching = 0;
        const auto tables = those_of(result->document, "dining_table_round");
        for (const DocumentThing* t : tables) {
            if (length(t->position - called(room, t->id).position) > 0.01f) moved.push_back(t);
            for (const DocumentThing* other : tables)
                touching += t < other &&
                            length(flat(t->position - other->position)) < (t->size_m.x + other->size_m.x) / 2 + 0.05f;
        }
        EXPECT_GE(moved.size(), 1u);
        EXPECT_LE(moved.size(), 2u);
        EXPECT_EQ(touching, 1);
        for (const DocumentThing* chair : those_of(result->document, "chair"))
            for (const DocumentThing* table : moved) {
                if (chair->with != table->id) continue;
                EXPECT_LT(distance_to(outline_of(*table), flat(chair->position)), 0.7f) << chair->id;
            }
        ++joined;
    }
    EXPECT_GT(joined, 0);
}

// Guests sit before a counter, never on both sides of it without a word.
TEST(EditTogether, StoolsStandOnOneSideOfACounter) {
    int rooms = 0;
    for (const std::uint64_t seed : {7103u, 51u, 52u, 53u}) {
        const RoomDocument room = planned("a modern kitchen with an island", seed);
        const auto result = edited(room, "add three bar stools at the island");
        if (!result) continue;
        const auto islands = those_of(result->document, "kitchen_island");
        ASSERT_EQ(islands.size(), 1u);
        bool before = false, behind = false;
        for (const DocumentThing* stool : those_of(result->document, "bar_stool")) {
            const float ahead = dot(stool->position - islands.front()->position, front_of(islands.front()->yaw));
            if (std::abs(ahead) < islands.front()->size_m.z / 2) continue;  // at its ends
            (ahead > 0 ? before : behind) = true;
        }
        EXPECT_TRUE(!(before && behind) || tells(*result, "on both sides of it")) << seed;
        ++rooms;
    }
    EXPECT_GT(rooms, 1);
}

// Chairs of the room that come to a round table stand around it with the others, and none behind another.
TEST(EditTogether, ChairsThatMoveToARoundTableFaceItsMiddle) {
    const RoomDocument room = planned("a dining room with a round table for six", 9305);
    const EditResult result = edit_by_sentence(room, "put all the chairs around the table", nullptr, kTogetherRun);
    const auto tables = those_of(result.document, "dining_table_round");
    ASSERT_EQ(tables.size(), 1u);
    for (const DocumentThing* chair : those_of(result.document, "chair")) {
        const Vec3f to = tables.front()->position - chair->position;
        const float far = length(flat(to));
        EXPECT_LT(far - chair->size_m.z / 2 - tables.front()->size_m.x / 2, 0.3f) << chair->id;
        EXPECT_GT(dot(front_of(chair->yaw), to), 0.95f * far) << chair->id;
        EXPECT_EQ(chair->with, tables.front()->id);
    }
}

// What was turned before it was moved is turned so where it came to, or it is told that it is not.
TEST(EditTogether, ATurnOutlivesAMove) {
    int moved = 0, kept = 0;
    for (const auto& [sentence, turn] : {std::pair{"turn the armchair around and move it into the corner", kPi},
                                         {"turn the armchair by 90 degrees and move it next to the window", kPi / 2}})
        for (const std::uint64_t seed : {61u, 62u, 63u, 64u, 65u, 66u}) {
            const RoomDocument room = planned("a living room with an armchair and a coffee table", seed);
            const auto before = those_of(room, "armchair");
            const auto result = before.size() == 1 ? edited(room, sentence) : std::nullopt;
            if (!result) continue;
            const DocumentThing& now = called(result->document, before.front()->id);
            if (length(now.position - before.front()->position) < 0.1f) continue;
            const float turned = std::abs(std::remainder(now.yaw - before.front()->yaw, 2 * kPi)),
                        off = std::abs(turned - turn);
            EXPECT_TRUE(off < 0.05f || tells(*result, "it is not turned so"))
                << sentence << ", " << seed << ": " << off;
            ++moved, kept += off < 0.05f;
        }
    EXPECT_GT(moved, 4);
    EXPECT_GT(kept, 2);
}

// "The other desk" is the one without a chair, where no other one was spoken of.
TEST(EditTogether, TheOtherDeskIsTheOneThatLacksAChair) {
    const RoomDocument room = planned("a home office with two desks", 7106);
    const EditResult result = edit_by_sentence(room, "add an office chair to the other desk", nullptr, kTogetherRun);
    std::vector<std::string> at;
    for (const DocumentThing* chair : those_of(result.document, "office_chair")) at.push_back(chair->with);
    std::sort(at.begin(), at.end());
    EXPECT_EQ(at, (std::vector<std::string>{"desk-1", "desk-2"}));
}

}  // namespace
}  // namespace fastscene

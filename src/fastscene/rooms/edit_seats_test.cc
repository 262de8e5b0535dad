// Laws of edits: seats keep their leg room, tables their rows, tall things their height, and the camera gives way.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "fastscene/base/error.h"
#include "fastscene/rooms/edit.h"

namespace fastscene {
namespace {

const fastscene::Run kSeatsRun{5, nullptr, {}};

const RoomDocument& seats_room(const std::string& name) {
    static std::map<std::string, RoomDocument> read;
    const auto found = read.find(name);
    if (found != read.end()) return found->second;
    const auto folder = std::filesystem::path(FASTSCENE_SOURCE_DIR) / "tests/data/rooms";
    return read[name] = load_document(folder / (name + ".json"));
}

RoomDocument room_for(const std::string& prompt, std::uint64_t seed) {
    PromptSpec spec = understand_prompt(prompt, false);
    return plan_document(spec, {seed, nullptr, {}});
}

Footprint box_of(const DocumentThing& t) {
    return {flat(t.position), {t.size_m.x / 2, t.size_m.z / 2}, t.yaw, t.position.y, t.position.y + t.size_m.y};
}

const DocumentThing* first_of(const RoomDocument& room, const std::string& kind) {
    const auto found = std::find_if(room.things.begin(), room.things.end(),
                                    [&](const DocumentThing& t) { return t.kind == kind; });
    return found == room.things.end() ? nullptr : &*found;
}

std::vector<const DocumentThing*> all_of(const RoomDocument& room, const std::string& kind) {
    std::vector<const DocumentThing*> out;
    for (const DocumentThing& t : room.things)
        if (t.kind == kind) out.push_back(&t);
    return out;
}

bool told(const EditResult& result, const std::string& words) {
    return std::any_of(result.changes.begin(), result.changes.end(),
                       [&](const EditChange& c) { return (c.id + ": " + c.what).find(words) != std::string::npos; });
}

// What comes beside a seat leaves the floor before it to the legs, or it is told that there is no room.
TEST(EditSeats, NothingBesideASeatStandsBeforeIt) {
    int placed = 0;
    for (const auto& [prompt, seat] : {std::pair{"a living room with a sofa and an armchair", "armchair"},
                                       {"a bedroom with an armchair", "armchair"},
                                       {"a living room with a sofa and a rug", "sofa"},
                                       {"a small study with an armchair", "armchair"}})
        for (const std::uint64_t seed : {11u, 12u, 13u}) {
            const RoomDocument room = room_for(prompt, seed);
            for (const char* thing : {"plant", "floor lamp", "side table"}) {
                EditResult result;
                try {
                    result = edit_by_sentence(room, std::string("put a ") + thing + " next to the " + seat, nullptr,
                                              kSeatsRun);
                } catch (const Error&) {
                    continue;
                }
                for (std::size_t i = room.things.size(); i < result.document.things.size(); ++i) {
                    const DocumentThing& fresh = result.document.things[i];
                    if (!fresh.on.empty()) continue;
                    ++placed;
                    for (const DocumentThing* s : all_of(result.document, seat)) {
                        // Before an armrest nobody has legs.
                        constexpr float kLegs = 0.45f, kSlack = 0.01f, kArm = 0.06f;
                        Footprint legs = box_of(*s);
                        legs.half.x -= kArm * s->size_m.x;
                        legs.center = legs.center + flat(front_of(s->yaw)) * (s->size_m.z / 2 + kLegs / 2);
                        legs.half.y = kLegs / 2;
                        EXPECT_FALSE(overlap(shrunk(box_of(fresh), kSlack), shrunk(legs, kSlack)))
                            << prompt << ", seed " << seed << ": " << fresh.id << " stands before " << s->id;
                    }
                }
            }
        }
    EXPECT_GT(placed, 18);
}

// Chairs that come to a table are drawn up to it and turned to it, and the rest make room; or nothing comes.
TEST(EditSeats, ChairsAtATableFaceIt) {
    int more = 0;
    for (const std::uint64_t seed : {21u, 22u, 23u})
        for (const char* prompt : {"a dining room with a table for four people", "a dining room with a table for six",
                                   "a dining room with a round table and four chairs"}) {
            const RoomDocument room = room_for(prompt, seed);
            const std::size_t before = all_of(room, "chair").size();
            EditResult result;
            try {
                result = edit_by_sentence(room, "put two more chairs at the table", nullptr, kSeatsRun);
            } catch (const Error& e) {
                EXPECT_NE(std::string(e.what()).find("no room"), std::string::npos) << e.what();
                continue;
            }
            const auto chairs = all_of(result.document, "chair");
            if (chairs.size() < before + 2) {
                EXPECT_TRUE(told(result, "there is room for"));
                continue;
            }
            ++more;
            const DocumentThing* table = first_of(result.document, "dining_table");
            if (!table) table = first_of(result.document, "dining_table_round");
            ASSERT_TRUE(table);
            const bool round = table->kind == "dining_table_round";
            for (const DocumentThing* chair : chairs) {
                if (chair->with != table->id) continue;
                const Vec2f front = flat(front_of(chair->yaw)), at = flat(chair->position);
                const Vec2f to = flat(table->position) - at;
                constexpr float kDrawnUp = 0.3f;
                const Vec2f edge = at + front * (chair->size_m.z / 2 + kDrawnUp);
                if (round) {
                    EXPECT_GT(dot(front, to), 0.8f * length(to)) << chair->id;
                    EXPECT_LT(length(to) - chair->size_m.z / 2 - table->size_m.x / 2, kDrawnUp) << chair->id;
                } else {
                    EXPECT_EQ(distance_to(box_of(*table), edge), 0.f) << chair->id;
                }
                for (const DocumentThing* other : chairs)
                    EXPECT_TRUE(other == chair ||
                                !overlap(shrunk(box_of(*chair), 0.01f), shrunk(box_of(*other), 0.01f)))
                        << chair->id << " and " << other->id;
            }
        }
    EXPECT_GT(more, 4);
}

// A table that becomes round has its chairs at its edge and not at the corners of its box.
TEST(EditSeats, ChairsStandAtARoundEdge) {
    const EditResult result = edit_by_sentence(seats_room("dining"), "make the dining table round", nullptr, kSeatsRun);
    const DocumentThing* table = first_of(result.document, "dining_table_round");
    ASSERT_TRUE(table);
    for (const DocumentThing* chair : all_of(result.document, "chair"))
        if (chair->with == table->id) {
            const float gap = length(flat(chair->position) - flat(table->position)) - chair->size_m.z / 2 -
                              table->size_m.x / 2;
            EXPECT_LT(gap, 0.16f) << chair->id;
            EXPECT_GT(gap, -0.02f) << chair->id;
        }
}

// Wherever furniture goes, the camera stands in nothing's outline, and that it moved is told.
TEST(EditSeats, TheCameraGivesWay) {
    for (const char* name : {"bedroom", "living", "study"}) {
        const RoomDocument& room = seats_room(name);
        ASSERT_TRUE(room.camera);
        for (const DocumentThing& t : room.things) {
            if (!t.on.empty() || t.size_m.y < 0.3f || (t.kind != "armchair" && t.kind != "desk")) continue;
            EditStep step;
            step.kind = EditStep::Kind::move;
            step.ids = {t.id};
            step.position = flat(room.camera->position);
            try {
                const EditResult result = edit_document(room, {step}, nullptr, kSeatsRun);
                EXPECT_TRUE(told(result, "the camera moved to")) << name << " " << t.id;
                for (const DocumentThing& now : result.document.things) {
                    if (now.id != t.id) continue;
                    EXPECT_GT(distance_to(box_of(now), flat(result.document.camera->position)), 0.f) << t.id;
                }
            } catch (const Error&) {  // furniture stands there
            }
        }
    }
}

TEST(EditSeats, SurfacesAreReplacedByLooks) {
    const EditResult tiles = edit_by_sentence(seats_room("kitchen"), "replace the floor with black and white tiles",
                                              nullptr, kSeatsRun);
    ASSERT_TRUE(tiles.document.surfaces.floor);
    EXPECT_TRUE(told(tiles, "floor: color: black"));
    EXPECT_EQ(tiles.document.things.size(), seats_room("kitchen").things.size());
    const EditResult walls = edit_by_sentence(seats_room("living"), "swap the wallpaper for green stripes", nullptr,
                                              kSeatsRun);
    EXPECT_TRUE(told(walls, "wall: color: green"));
}

TEST(EditSeats, AdjectivesOfThePlaceAreNotOfWhatComes) {
    try {
        const EditResult result = edit_by_sentence(seats_room("cafe"), "put a chair at the round table", nullptr,
                                                   kSeatsRun);
        EXPECT_FALSE(told(result, "round chair"));
    } catch (const Error& e) {
        EXPECT_EQ(std::string(e.what()).find("round chair"), std::string::npos) << e.what();
    }
}

TEST(EditSeats, ALargerRugIsNoThicker) {
    const RoomDocument& room = seats_room("living");
    const EditResult result = edit_by_sentence(room, "make the rug bigger", nullptr, kSeatsRun);
    const DocumentThing *was = first_of(room, "rug"), *is = first_of(result.document, "rug");
    ASSERT_TRUE(was && is);
    EXPECT_FLOAT_EQ(was->size_m.y, is->size_m.y);
    EXPECT_GT(is->size_m.x, was->size_m.x);
}

}  // namespace
}  // namespace fastscene

#include "fastscene/rooms/edit.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>

#include "fastscene/base/error.h"

namespace fastscene {
namespace {

const fastscene::Run kEditRun{3, nullptr, {}};

// Documents that this version wrote: what is edited does not change with the furnishing of rooms.
const RoomDocument& kept_room(const std::string& name) {
    static std::map<std::string, RoomDocument> read;
    const auto found = read.find(name);
    if (found != read.end()) return found->second;
    const auto folder = std::filesystem::path(FASTSCENE_SOURCE_DIR) / "tests/data/rooms";
    return read[name] = load_document(folder / (name + ".json"));
}

EditResult edited(const std::string& room, const std::string& sentence) {
    return edit_by_sentence(kept_room(room), sentence, nullptr, kEditRun);
}
std::string edit_error(const std::string& room, const std::string& sentence) {
    try {
        edited(room, sentence);
    } catch (const Error& e) {
        return e.what();
    }
    return {};
}

std::map<std::string, const DocumentThing*> by_id(const RoomDocument& document) {
    std::map<std::string, const DocumentThing*> out;
    for (const DocumentThing& t : document.things) out[t.id] = &t;
    return out;
}

// Ids of the things that are gone, new, elsewhere or other.
struct Difference {
    std::set<std::string> gone, added, moved, other;
};
Difference difference(const RoomDocument& before, const RoomDocument& after) {
    Difference out;
    const auto old = by_id(before), now = by_id(after);
    for (const auto& [id, t] : old) {
        const auto found = now.find(id);
        if (found == now.end()) {
            out.gone.insert(id);
            continue;
        }
        const DocumentThing& n = *found->second;
        if (n.position != t->position || n.yaw != t->yaw) out.moved.insert(id);
        if (n.color != t->color || n.material != t->material || n.seed != t->seed || n.size_m != t->size_m)
            out.other.insert(id);
    }
    for (const auto& [id, t] : now)
        if (!old.contains(id)) out.added.insert(id);
    return out;
}

constexpr const char *kBedroom = "bedroom", *kLiving = "living", *kStudy = "study", *kKitchen = "kitchen";

TEST(Edit, MovesWhatIsNamedAndNothingElse) {
    const EditResult out = edited(kBedroom, "move the armchair to the window");
    const Difference d = difference(kept_room(kBedroom), out.document);
    EXPECT_EQ(d.moved, std::set<std::string>{"armchair-1"});
    EXPECT_TRUE(d.gone.empty() && d.added.empty() && d.other.empty());
    ASSERT_EQ(out.changes.size(), 1u);
    EXPECT_EQ(out.changes[0].id, "armchair-1");
}

TEST(Edit, DoesSeveralThingsInOneSentence) {
    const EditResult out = edited(kLiving, "make the sofa green, remove the rug, and add a floor lamp beside the sofa");
    const Difference d = difference(kept_room(kLiving), out.document);
    EXPECT_EQ(d.other, std::set<std::string>{"sofa-1"});
    EXPECT_EQ(d.gone, std::set<std::string>{"rug-1"});
    EXPECT_EQ(d.added.size(), 1u);
    EXPECT_TRUE(d.added.begin()->starts_with("floor_lamp"));
    EXPECT_TRUE(d.moved.empty());
    EXPECT_EQ(by_id(out.document).at("sofa-1")->color, "green");
}

TEST(Edit, ItIsWhatWasNamedBefore) {
    const EditResult out = edited(kBedroom, "turn the armchair around and make it blue, make it night");
    EXPECT_EQ(by_id(out.document).at("armchair-1")->color, "blue");
    EXPECT_EQ(out.document.light.hour, "night");
    EXPECT_NE(edit_error(kBedroom, "make it blue").find("nothing was named before"), std::string::npos);
}

TEST(Edit, AsksWhichOfSeveralIsMeant) {
    EXPECT_TRUE(edit_error(kLiving, "remove the armchair").starts_with("which armchair? armchair-1 "));
    EXPECT_NE(edit_error(kLiving, "remove the grand piano").find("there is no \"the grand piano\""), std::string::npos);
    EXPECT_NE(edit_error(kLiving, "the sofa is ugly").find("expected what to do"), std::string::npos);
    EXPECT_NE(edit_error(kLiving, "make the sofa qwzx").find("expected how to make it"), std::string::npos);
    const Difference one = difference(kept_room(kLiving), edited(kLiving, "remove armchair-2").document);
    EXPECT_EQ(one.gone, std::set<std::string>{"armchair-2"});
    const Difference both = difference(kept_room(kLiving), edited(kLiving, "remove both armchairs").document);
    EXPECT_EQ(both.gone, (std::set<std::string>{"armchair-1", "armchair-2"}));
}

TEST(Edit, TakesAwayWhatStandsOnIt) {
    const RoomDocument& room = kept_room(kLiving);
    const Difference d = difference(room, edited(kLiving, "remove the coffee table").document);
    for (const DocumentThing& t : room.things)
        EXPECT_EQ(d.gone.contains(t.id), t.id == "coffee_table-1" || t.on == "coffee_table-1") << t.id;
    EXPECT_GT(d.gone.size(), 1u);
}

TEST(Edit, MovesByPose) {
    EditStep step;
    step.kind = EditStep::Kind::move;
    step.ids = {"armchair-1"};
    step.position = Vec2f{50, 0};
    EXPECT_THROW(edit_document(kept_room(kBedroom), {step}, nullptr, kEditRun), Error);
    const DocumentThing& chair = *by_id(kept_room(kBedroom)).at("armchair-1");
    step.position = Vec2f{chair.position.x + 0.05f, chair.position.z};
    const EditResult out = edit_document(kept_room(kBedroom), {step}, nullptr, kEditRun);
    EXPECT_EQ(by_id(out.document).at("armchair-1")->position.x, chair.position.x + 0.05f);
    EXPECT_EQ(by_id(out.document).at("armchair-1")->yaw, chair.yaw);
}

TEST(Edit, ChangesStyleAndHourInPlace) {
    const EditResult out = edited(kStudy, "make it night and change the style to japandi");
    EXPECT_EQ(out.document.style, "japandi");
    EXPECT_EQ(out.document.light.hour, "night");
    const Difference d = difference(kept_room(kStudy), out.document);
    EXPECT_TRUE(d.moved.empty() && d.gone.empty() && d.added.empty());
    EXPECT_EQ(out.document.camera->position, kept_room(kStudy).camera->position);
}

// What a sentence is to change: ids that begin so, each with what becomes of it.
struct Sentence {
    const char *room, *text, *gone, *added, *moved, *other;
};
bool begin_with(const std::set<std::string>& ids, const std::string& name) {
    return name.empty() ? ids.empty() : !ids.empty() && std::all_of(ids.begin(), ids.end(), [&](const std::string& id) {
        return id.starts_with(name);
    });
}

TEST(Edit, ThirtySentences) {
    const std::array<Sentence, 30> sentences{{
        {kBedroom, "move the armchair to the window", "", "", "armchair-1", ""},
        {kBedroom, "remove the bench at the foot of the bed", "bench", "", "", ""},
        {kBedroom, "make the armchair blue", "", "", "", "armchair-1"},
        {kBedroom, "add a rug under the bed", "", "rug", "", ""},
        {kBedroom, "turn the armchair around", "", "", "armchair-1", ""},
        {kBedroom, "paint the walls sage green", "", "", "", ""},
        {kBedroom, "get rid of the mirror", "mirror", "", "", ""},
        {kBedroom, "put a plant in the corner", "", "plant", "", ""},
        {kBedroom, "make the bed linen", "", "", "", "bed-1"},
        {kBedroom, "hang a picture above the dresser", "", "picture", "", ""},
        {kLiving, "make the sofa green", "", "", "", "sofa-1"},
        {kLiving, "remove the rug", "rug", "", "", ""},
        {kLiving, "add a floor lamp beside the sofa", "", "floor_lamp", "", ""},
        {kLiving, "recolor both armchairs mustard", "", "", "", "armchair"},
        {kLiving, "move armchair-1 next to the window", "", "", "armchair-1", ""},
        {kLiving, "make the coffee table walnut", "", "", "", "coffee_table"},
        {kLiving, "remove the tv", "tv-1", "", "", ""},
        {kLiving, "add a vase on the coffee table", "", "vase", "", ""},
        {kLiving, "please add a bookshelf", "", "bookshelf", "", ""},
        {kLiving, "make it evening", "", "", "", ""},
        {kStudy, "remove the plant at the window", "plant", "", "", ""},
        {kStudy, "add an armchair in the corner", "", "armchair", "", ""},
        {kStudy, "make the desk black", "", "", "", "desk-1"},
        {kStudy, "replace the first bookshelf with a cabinet", "bookshelf", "cabinet", "", ""},
        {kStudy, "turn the lamps on", "", "", "", ""},
        {kStudy, "add a cat on the floor", "", "cat", "", ""},
        {kKitchen, "remove the second chair", "chair-2", "", "", ""},
        {kKitchen, "make all chairs red", "", "", "", "chair"},
        {kKitchen, "add a bowl on the dining table", "", "bowl", "", ""},
        {kKitchen, "move the dining table to the window", "", "", "dining_table", ""},
    }};
    int right = 0;
    std::string wrong;
    for (const Sentence& s : sentences) {
        std::string found = edit_error(s.room, s.text);
        if (found.empty()) {
            const Difference d = difference(kept_room(s.room), edited(s.room, s.text).document);
            const auto rest = [&](const std::set<std::string>& ids) {
                // What stands on a thing goes with it.
                std::set<std::string> out;
                const auto things = by_id(kept_room(s.room));
                for (const std::string& id : ids)
                    if (!things.contains(id) || !ids.contains(things.at(id)->on)) out.insert(id);
                return out;
            };
            if (begin_with(rest(d.gone), s.gone) && begin_with(d.added, s.added) &&
                begin_with(rest(d.moved), s.moved) && begin_with(d.other, s.other)) {
                ++right;
                continue;
            }
            found = fmt::format("gone {}, added {}, moved {}, other {}", d.gone.size(), d.added.size(), d.moved.size(),
                                d.other.size());
        }
        wrong += std::string(s.text) + ": " + found + "\n";
    }
    constexpr int kLeast = 27;
    EXPECT_GE(right, kLeast) << wrong;
    if (!wrong.empty()) std::cout << right << " of " << sentences.size() << " right\n" << wrong;
}

}  // namespace
}  // namespace fastscene

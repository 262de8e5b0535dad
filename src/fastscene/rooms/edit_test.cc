#include "fastscene/rooms/edit.h"

#include <gtest/gtest.h>

#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "fastscene/base/error.h"
#include "fastscene/rooms/layout_relations.h"

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
        if (n.color != t->color || n.material != t->material || n.holder_color != t->holder_color ||
            n.holder_material != t->holder_material || n.seed != t->seed || n.size_m != t->size_m || n.lit != t->lit)
            out.other.insert(id);
    }
    for (const auto& [id, t] : now)
        if (!old.contains(id)) out.added.insert(id);
    return out;
}

float volume(const DocumentThing& t) { return t.size_m.x * t.size_m.y * t.size_m.z; }

constexpr const char *kBedroom = "bedroom", *kLiving = "living", *kStudy = "study";

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

TEST(Edit, DoesWhatCanBeDoneAndTellsTheRest) {
    const auto not_done = [](const EditResult& result) {
        return std::count_if(result.changes.begin(), result.changes.end(),
                             [](const EditChange& c) { return c.id == kNotDone; });
    };
    const EditResult out = edited(kLiving, "make the sofa green, remove the grand piano and add a floor lamp");
    const Difference d = difference(kept_room(kLiving), out.document);
    EXPECT_EQ(d.other, std::set<std::string>{"sofa-1"});
    EXPECT_EQ(d.added.size(), 1u);
    EXPECT_TRUE(d.gone.empty() && d.moved.empty());
    EXPECT_EQ(not_done(out), 1);
    // What can be done is done of one verb as well.
    const EditResult some = edited(kLiving, "remove the rug and the grand piano");
    EXPECT_EQ(difference(kept_room(kLiving), some.document).gone, std::set<std::string>{"rug-1"});
    EXPECT_EQ(not_done(some), 1);
    EXPECT_THROW(edited(kLiving, "remove the grand piano and the harp"), UsageError);
    EXPECT_EQ(not_done(edited(kLiving, "make the sofa green and remove the rug")), 0);
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

// Radiance of what shines of a thing.
float light_of(const RoomDocument& document, const std::string& id) {
    DocumentRoom room = furnish_document(document, "room", nullptr, kEditRun);
    const Room built = room_of(room);
    float out = 0;
    for (const Mesh& m : built.meshes)
        if (m.object >= 0 && built.objects[static_cast<std::size_t>(m.object)].id == id)
            out = std::max(out, luminance(built.materials[static_cast<std::size_t>(m.material)].emission));
    return out;
}

TEST(Edit, OneLampShinesAsWasSaidOfIt) {
    const RoomDocument by_day = edited(kBedroom, "turn the lamps off").document;
    EXPECT_EQ(light_of(by_day, "floor_lamp-1"), 0.f);
    const RoomDocument one = edit_by_sentence(by_day, "turn on the floor lamp", nullptr, kEditRun).document;
    EXPECT_GT(light_of(one, "floor_lamp-1"), 0.f);
    EXPECT_EQ(light_of(one, "ceiling_lamp-1"), 0.f);
    const RoomDocument dimmed = edit_by_sentence(one, "make the floor lamp dimmer", nullptr, kEditRun).document;
    EXPECT_LT(light_of(dimmed, "floor_lamp-1"), 0.6f * light_of(one, "floor_lamp-1"));
    EXPECT_GT(light_of(dimmed, "floor_lamp-1"), 0.f);
    // All of them again.
    const RoomDocument all = edit_by_sentence(dimmed, "turn the lamps on", nullptr, kEditRun).document;
    EXPECT_EQ(light_of(all, "floor_lamp-1"), light_of(one, "floor_lamp-1"));
    EXPECT_GT(light_of(all, "ceiling_lamp-1"), 0.f);
    // Written and read again.
    EXPECT_EQ(light_of(read_document(document_json(dimmed).dump(), "room.json"), "floor_lamp-1"),
              light_of(dimmed, "floor_lamp-1"));
}

TEST(Edit, OneWallIsPaintedAndWrittenSo) {
    const RoomDocument painted = edited(kLiving, "paint the window wall dark green").document;
    const RoomDocument read = read_document(document_json(painted).dump(), "room.json");
    ASSERT_TRUE(read.surfaces.walls[1].has_value());
    EXPECT_FALSE(read.surfaces.walls[0].has_value() || read.surfaces.walls[2].has_value());
    DocumentRoom room = furnish_document(read, "room", nullptr, kEditRun);
    const Room built = room_of(room);
    std::set<int> shown;
    for (const Mesh& m : built.meshes) shown.insert(m.material);
    EXPECT_TRUE(std::any_of(shown.begin(), shown.end(), [&](int m) {
        return built.materials[static_cast<std::size_t>(m)].name == read.surfaces.walls[1]->name;
    }));
    // All walls are all of them again.
    const RoomDocument all = edit_by_sentence(read, "paint the walls white", nullptr, kEditRun).document;
    EXPECT_FALSE(all.surfaces.walls[1].has_value());
}

// ---- tests/data/edits.txt: sentences and what each is to do

std::string trimmed(const std::string& text) {
    const auto from = text.find_first_not_of(" \t"), to = text.find_last_not_of(" \t\r");
    return from == std::string::npos ? "" : text.substr(from, to - from + 1);
}
std::vector<std::string> split(const std::string& text, char at) {
    std::vector<std::string> out;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, at);)
        if (part = trimmed(part); !part.empty() || at == '|') out.push_back(part);
    return out;
}

// What was said of a thing, and what became of it.
std::string look_of(const DocumentThing& was, const DocumentThing& is) {
    std::string out;
    for (const std::string& part : {is.color, is.material, is.pattern}) out += part + " ";
    if (is.lit) out += *is.lit > 0.99f ? "on " : *is.lit > 0 ? "dimmed " : "off ";
    if (volume(is) > 1.01f * volume(was)) out += "larger";
    if (volume(is) < 0.99f * volume(was)) out += "smaller";
    return out;
}

// Ids without their numbers: what came.
std::multiset<std::string> kinds_of(const std::set<std::string>& ids) {
    std::multiset<std::string> out;
    for (const std::string& id : ids) out.insert(id.substr(0, id.rfind('-')));
    return out;
}

// What differs between two rooms, in the words of the table; what stands on a thing goes where that goes.
struct Seen {
    std::multiset<std::string> gone, comes, moves, looks;
};
Seen seen(const RoomDocument& before, const RoomDocument& after) {
    const Difference d = difference(before, after);
    const auto old = by_id(before), now = by_id(after);
    Seen out;
    for (const std::string& id : d.gone)
        if (!d.gone.contains(old.at(id)->on)) out.gone.insert(id);
    for (const std::string& id : d.moved)
        if (now.at(id)->on != old.at(id)->on ||
            (!d.moved.contains(old.at(id)->on) && !d.other.contains(old.at(id)->on)))
            out.moves.insert(id);
    out.comes = kinds_of(d.added);
    for (const std::string& id : d.other) out.looks.insert(id);
    const auto differs = [](const std::optional<Material>& a, const std::optional<Material>& b) {
        return a.has_value() != b.has_value() || (a && (a->color_a != b->color_a || a->name != b->name));
    };
    const DocumentSurfaces &s = before.surfaces, &t = after.surfaces;
    if (before.style == after.style) {
        if (differs(s.wall, t.wall)) out.looks.insert("wall");
        if (differs(s.floor, t.floor)) out.looks.insert("floor");
        if (differs(s.ceiling, t.ceiling)) out.looks.insert("ceiling");
        if (differs(s.trim, t.trim)) out.looks.insert("trim");
        for (std::size_t w = 0; w < s.walls.size(); ++w)
            if (differs(s.walls[w], t.walls[w])) out.looks.insert("wall_" + std::to_string(w));
    } else {
        out.looks.insert("style");
    }
    const DocumentLight &l = before.light, &m = after.light;
    if (l.hour != m.hour || l.weather != m.weather || l.lamps != m.lamps || l.outlook != m.outlook)
        out.looks.insert("light");
    return out;
}

// "armchair-1 next to window": whether it stands there.
bool stands(const RoomDocument& document, const std::string& said) {
    const std::vector<std::string> words = split(said, ' ');
    const DocumentRoom room = furnish_document(document, "room", nullptr, kEditRun);
    PromptObject wish;
    wish.id = -2;  // none of those that stand there
    for (std::size_t i = 1; i + 1 < words.size(); ++i) wish.relation += (i > 1 ? " " : "") + words[i];
    wish.relation_to = words.back() == "-" ? "" : words.back();
    const std::vector<Placed>& all = room.furnished.placed;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (document.things[i].id == words.front())
            return stands_as_asked(room.furnished.plan, all, all[i], wish).value_or(false);
    return false;
}

std::string listed(const std::multiset<std::string>& all) { return fmt::format("{}", fmt::join(all, " ")); }

// "sofa-1=green" is in the looks as "sofa-1".
std::string wrong_with(const std::vector<std::string>& row) {
    const std::string& room = row[0];
    if (row[2].starts_with("refused:")) {
        const std::string wanted = trimmed(row[2].substr(8)), found = edit_error(room, row[1]);
        if (found.empty()) return "it was not refused";
        return found.find(wanted) == std::string::npos ? found : "";
    }
    const RoomDocument& before = kept_room(room);
    EditResult result;
    try {
        result = edited(room, row[1]);
    } catch (const Error& e) {
        return e.what();
    }
    const RoomDocument& after = result.document;
    const auto field = [&](std::size_t i) { return i < row.size() ? row[i] : std::string(); };
    const auto words = [&](std::size_t i) {
        std::multiset<std::string> out;
        for (const std::string& word : split(field(i), ' ')) out.insert(word.substr(0, word.find('=')));
        return out;
    };
    const Seen is = seen(before, after);
    if (is.gone != words(2) || is.comes != words(3) || is.moves != words(4) || is.looks != words(5))
        return fmt::format("{} | {} | {} | {}", listed(is.gone), listed(is.comes), listed(is.moves), listed(is.looks));
    for (const std::string& word : split(field(5), ' ')) {
        const auto at = word.find('=');
        if (at == std::string::npos) continue;
        const std::string id = word.substr(0, at);
        std::string value = word.substr(at + 1);
        std::replace(value.begin(), value.end(), '_', ' ');
        const std::string look = look_of(*by_id(before).at(id), *by_id(after).at(id));
        if (look.find(value) == std::string::npos) return id + " is " + look;
    }
    std::string told;
    for (const EditChange& change : result.changes) told += change.id + ": " + change.what + "\n";
    for (const std::string& place : split(field(6), ';')) {
        const bool said = place.starts_with("told:");
        if (said ? told.find(trimmed(place.substr(5))) == std::string::npos : !stands(after, place))
            return "not " + place + "\n" + told;
    }
    return {};
}

TEST(Edit, DoesWhatTheSentencesOfTheTableSay) {
    std::ifstream in(std::filesystem::path(FASTSCENE_SOURCE_DIR) / "tests/data/edits.txt");
    ASSERT_TRUE(in) << "tests/data/edits.txt";
    int count = 0;
    std::string line;
    while (std::getline(in, line)) {
        if (line.empty() || line[0] == '#') continue;
        const std::vector<std::string> row = split(line, '|');
        ASSERT_GE(row.size(), 3u) << line;
        ++count;
        EXPECT_EQ(wrong_with(row), "") << line;
    }
    EXPECT_GT(count, 100);
}

}  // namespace
}  // namespace fastscene

#include "fastscene/rooms/catalogue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "fastscene/base/error.h"
#include "fastscene/base/parallel.h"
#include "fastscene/rooms/furniture.h"
#include "fastscene/rooms/layout.h"
#include "fastscene/rooms/layout_sight.h"
#include "fastscene/rooms/lexicon_table.h"
#include "fastscene/rooms/test_prompts.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;
const fs::path kRooms = fs::path(FASTSCENE_SOURCE_DIR) / "src/fastscene/rooms";

std::string text_of(const fs::path& path) {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string error_of(std::string_view text) {
    const std::array files{CatalogueFile{"seats", text}};
    try {
        read_things(files);
    } catch (const Error& e) {
        return e.what();
    }
    return "no error";
}

TEST(Catalogue, ErrorsNameFileLineAndRow) {
    EXPECT_EQ(error_of("[sofa]\nnyu40 = \"sofa\"\n"), "no error");
    EXPECT_EQ(error_of("[sofa]\nrole = [\"seat\"]\nnyu40 = \"sofa\"\n"),
              "seats.toml:2: unknown key \"role\" in [sofa]; did you mean roles?");
    EXPECT_TRUE(error_of("[sofa]\n").starts_with("seats.toml:1: [sofa]: nyu40: expected one of outside, wall"));
    EXPECT_NE(error_of("[sofa]\nnyu40 = \"sofa\"\nroles = [\"seta\"]\n").find("seats.toml:3: [sofa]: roles: expected"),
              std::string::npos);
    EXPECT_EQ(error_of("[sofa]\nnyu40 = \"sofa\"\nstand_in = \"couch\"\n"),
              "catalogue: [sofa]: stand_in: expected a kind that has a builder, found \"couch\"");
    EXPECT_NE(error_of("[sofa]\nnyu40 = \"sofa\"\non_top = [{ thing = \"cup\", probability = 2 }]\n")
                  .find("seats.toml:3: [sofa] on_top: probability: expected a number from 0 to 1, found 2"),
              std::string::npos);
}

TEST(Catalogue, KindsStandOnce) {
    const std::array files{CatalogueFile{"seats", "[sofa]\nnyu40 = \"sofa\"\n"},
                           CatalogueFile{"beds", "\n[sofa]\nnyu40 = \"sofa\"\n"}};
    EXPECT_THROW(read_things(files), Error);
    const std::vector<Thing> one = read_things(std::span(files).first(1));
    ASSERT_EQ(one.size(), 1u);
    EXPECT_EQ(one[0].kind, "sofa");
    EXPECT_EQ(one[0].nyu40, 6);
}

TEST(Catalogue, RolesOfAFewThings) {
    EXPECT_TRUE(has_role("bunk_bed", Role::bed) && has_role("bunk_bed", Role::along_wall));
    EXPECT_TRUE(has_role("window", Role::shell) && has_role("window", Role::opening));
    EXPECT_FALSE(has_role("sofa", Role::shell));
    EXPECT_EQ(find_thing("no_such_thing"), nullptr);
    EXPECT_FALSE(has_role("no_such_thing", Role::seat));
}

TEST(Catalogue, EveryKindThatTheLexiconNamesIsARow) {
    for (const auto& [term, word] : lexicon_table().words) {
        if (word.kind != WordKind::object && word.kind != WordKind::structure) continue;
        EXPECT_NE(find_thing(word.meaning), nullptr) << term << " means " << word.meaning;
    }
}

TEST(Catalogue, RoomsAndStylesOfRowsAreKnown) {
    const std::vector<std::string> rooms = room_types(), known = styles();
    for (const Thing& t : things()) {
        EXPECT_TRUE(t.room.empty() || std::find(rooms.begin(), rooms.end(), t.room) != rooms.end()) << t.kind;
        EXPECT_TRUE(t.style.empty() || std::find(known.begin(), known.end(), t.style) != known.end()) << t.kind;
    }
}

TEST(Catalogue, BuildersAndRowsAreTheSame) {
    std::set<std::string> rows, sources;
    for (const Thing& t : things())
        if (t.built) rows.insert(t.kind);
    const std::regex builder(R"(\nvoid build_(\w+)\(Kit& k\))");
    for (const auto& entry : fs::recursive_directory_iterator(kRooms / "furniture")) {
        if (entry.path().extension() != ".cc") continue;
        const std::string text = text_of(entry.path());
        for (std::sregex_iterator it(text.begin(), text.end(), builder), end; it != end; ++it) sources.insert((*it)[1]);
    }
    EXPECT_EQ(rows, sources);
    EXPECT_EQ(std::vector<std::string>(rows.begin(), rows.end()), piece_classes());
}

// What asks a room for one such thing, by some word of the lexicon; without it nothing names the kind.
std::optional<std::string> words_for(const std::string& kind, const std::string& room) {
    for (const auto& [term, word] : lexicon_table().words) {
        if (word.kind != WordKind::object || word.meaning != kind || term.find(':') != std::string::npos) continue;
        for (const char* article : {"a ", ""})
            if (object_of(read("a large " + room + " with " + (article + term)), kind)) return article + term;
    }
    return {};
}

// Those of the kinds that a living room shows which is asked for all of them.
std::set<std::string> shown_together(const std::vector<std::string>& kinds) {
    std::string text;
    for (const std::string& kind : kinds)
        if (const auto words = words_for(kind, "living room"))
            text += (text.empty() ? "a large living room with " : ", ") + *words;
    if (text.empty()) return {};
    PromptSpec spec = read(text);
    const FurnishedRoom room = furnish_room(spec, {1, nullptr, {}});
    const Sight sight(room.plan, room.placed);
    std::set<std::string> out;
    for (std::size_t k = 0; k < room.placed.size(); ++k) {
        const std::string& kind = room.placed[k].wish.kind;
        if (std::find(kinds.begin(), kinds.end(), kind) != kinds.end() && !out.contains(kind) &&
            sight.look(static_cast<int>(k), room.camera).pixels > 0)
            out.insert(kind);
    }
    return out;
}

// Why a room that is asked for such a thing does not show one; empty: it does.
std::string fault_in(const std::string& room_words, const std::string& kind) {
    const std::optional<std::string> words = words_for(kind, room_words);
    if (!words) return "no word of the lexicon asks for it";
    PromptSpec spec = read("a large " + room_words + " with " + *words);
    const FurnishedRoom room = furnish_room(spec, {1, nullptr, {}});
    const Sight sight(room.plan, room.placed);
    bool placed = false;
    for (std::size_t k = 0; k < room.placed.size(); ++k) {
        if (room.placed[k].wish.kind != kind) continue;
        placed = true;
        if (sight.look(static_cast<int>(k), room.camera).pixels > 0) return {};
    }
    return spec.text + (placed ? ": not seen" : ": not placed");
}

// A lane of 12 m fits no living room: such things are asked for where they belong.
std::string fault_of(const std::string& kind) {
    const std::string fault = fault_in("living room", kind);
    const std::string& home = find_thing(kind)->room;
    return fault.empty() || home.empty() ? fault : fault_in(room_title(home), kind);
}

TEST(Catalogue, EveryRowCanBeBuiltPlacedAndSeen) {
    std::vector<std::string> kinds;
    for (const Thing& t : things())
        if (t.built) kinds.push_back(t.kind);
    std::vector<std::string> faults(kinds.size());
    // Four at a time, of different files; what is not seen among others is asked for alone.
    const std::size_t rooms = (kinds.size() + 3) / 4;
    parallel_for(static_cast<std::int64_t>(rooms), 1, [&](std::int64_t begin, std::int64_t) {
        std::vector<std::string> some;
        for (auto i = static_cast<std::size_t>(begin); i < kinds.size(); i += rooms) some.push_back(kinds[i]);
        const std::set<std::string> shown = shown_together(some);
        for (auto i = static_cast<std::size_t>(begin); i < kinds.size(); i += rooms)
            if (!shown.contains(kinds[i])) faults[i] = fault_of(kinds[i]);
    });
    for (std::size_t i = 0; i < kinds.size(); ++i) EXPECT_EQ(faults[i], "") << kinds[i];
}

// The worked example of docs/extend/thing.md is the rocking horse that ships.
TEST(Catalogue, TheDocsShowTheBuilderAndTheRowThatShip) {
    const std::string page = text_of(fs::path(FASTSCENE_SOURCE_DIR) / "docs/extend/thing.md");
    const auto block = [&](const std::string& language) {
        const std::size_t fence = page.find("```" + language + "\n"), from = fence + language.size() + 4;
        return fence == std::string::npos ? "no block" : page.substr(from, page.find("```", from) - from);
    };
    EXPECT_NE(text_of(kRooms / "furniture/toys/rocking_horse.cc").find(block("cpp")), std::string::npos);
    EXPECT_NE(text_of(kRooms / "catalogue/toys.toml").find(block("toml")), std::string::npos);
}

// What is known of a kind stands in its row. Code that still names kinds is counted here, a file a row: the numbers may
// only sink. Parts of the shell are not counted: walls and windows are built by name.
const std::map<std::string, int> kStillNamed{
    {"layout.cc", 10},
    {"layout_anneal.cc", 4},
    {"layout_asked.cc", 14},
    {"layout_asked_places.cc", 67},
    {"layout_cost.cc", 2},
    {"layout_floor.cc", 1},
    {"layout_furnisher.cc", 23},
    // Keys and names of forms in documents and in the files of styles and room types, some of which kinds are called
    // too.
    {"document_fields.h", 5},
    {"document_room.cc", 2},
    {"document_schema.cc", 1},
    {"edit_layout.cc", 4},  // rugs lie under things; what the layout brings along to carry others
    {"edit_which.cc", 1},   // towards the camera: to who looks
    {"edit_places.cc", 1},  // a tv on a wall hangs there
    {"file_fields.cc", 5},
    {"room_type.cc", 3},
    {"style_choices.h", 6},
    {"style_file.cc", 36},
    {"layout_groups.cc", 92},
    {"layout_hung.cc", 2},
    {"layout_place.cc", 1},
    {"layout_recipe.cc", 2},
    {"layout_small.cc", 6},
    {"layout_touches.cc", 34},
    {"layout_ways.cc", 1},
    {"layout_wishes.cc", 4},
    {"pack_choice.cc", 3},
    {"pack_model.cc", 8},
    {"plan.cc", 2},
    {"plan_openings.cc", 3},
    {"plan_surfaces.cc", 1},
    {"prompt_bind.cc", 17},
    {"prompt_globals.cc", 1},
    {"prompt_measure.cc", 4},
    {"prompt_meanings.cc", 41},
    {"prompt_nouns.cc", 18},
    {"prompt_quantity.cc", 24},
    {"prompt_relate.cc", 20},
    {"prompt_rooms.cc", 2},
    {"prompt_themes.cc", 38},
    {"room_type.h", 3},
    {"rooms.cc", 22},
    {"validate.cc", 3},
};

TEST(Catalogue, CodeNamesNoKinds) {
    const std::regex literal(R"re("((?:[^"\\\n]|\\.)*)")re"), comment(R"(//[^\n]*|#include[^\n]*)");
    for (const auto& entry : fs::directory_iterator(kRooms)) {
        const std::string name = entry.path().filename().string();
        const bool code = entry.path().extension() == ".cc" || entry.path().extension() == ".h";
        if (!code || name.ends_with("_test.cc") || name == "catalogue.cc") continue;  // that has the labels of NYU40
        const std::string text = std::regex_replace(text_of(entry.path()), comment, "");
        int named = 0;
        std::string which;
        for (std::sregex_iterator it(text.begin(), text.end(), literal), end; it != end; ++it)
            if (const Thing* thing = find_thing((*it)[1].str()); thing && !thing->has(Role::shell))
                ++named, which += " " + thing->kind;
        const auto allowed = kStillNamed.find(name);
        EXPECT_LE(named, allowed == kStillNamed.end() ? 0 : allowed->second)
            << name << ": put what the code says of these kinds into their rows (catalogue/*.toml):" << which;
    }
}

}  // namespace
}  // namespace fastscene

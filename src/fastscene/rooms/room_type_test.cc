#include "fastscene/rooms/room_type.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "fastscene/base/error.h"
#include "fastscene/rooms/layout.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/test_prompts.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;
const fs::path kTypesFolder = fs::path(FASTSCENE_SOURCE_DIR) / "src/fastscene/rooms/room_types";

std::string type_text(const fs::path& path) {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string type_error(const std::string& from, const std::string& to) {
    std::string text = type_text(kTypesFolder / "living.toml");
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    if (at != std::string::npos) text.replace(at, from.size(), to);
    try {
        (void)read_room_type(text, "room_types/mine.toml");
    } catch (const Error& e) {
        return e.what();
    }
    return "no error";
}

TEST(RoomTypeFiles, EachIsAType) {
    std::set<std::string> names, known;
    for (const auto& entry : fs::directory_iterator(kTypesFolder))
        EXPECT_TRUE(names.insert(read_room_type(type_text(entry.path()), entry.path().string()).name).second);
    for (const RoomType& type : all_room_types()) known.insert(type.name);
    EXPECT_EQ(names, known);
}

TEST(RoomTypeFiles, ErrorsNameFileKeyAndWhatWasExpected) {
    const auto says = [](const std::string& error, const std::string& part) {
        EXPECT_NE(error.find(part), std::string::npos) << error;
        EXPECT_TRUE(error.starts_with("room_types/mine.toml:")) << error;
    };
    says(type_error("wet = ", "damp = "), "unknown key \"damp\"");
    says(type_error("wet = false\n", ""), "wet: expected true or false, found none");
    says(type_error("\"bookshelf\"", "\"spaceship\""), "expected a thing of the catalogue, found \"spaceship\"");
    says(type_error("shelves = \"books\"", "shelves = \"wine\""), "expected one of books, bath, kitchen, toys");
    says(type_error("wet = false\n", "wet = false\nown_things = [\"spaceship\"]\n"), "own_things: expected a thing");
    says(type_error("[touches]", "[windows]\ncount = 9\n[touches]"), "count: expected a number from 0 to 4, found 9");
    says(type_error("[touches]", "[windows]\nsize = \"tall\"\n[touches]"), "expected one of usual, small, large");
    says(type_error("wet = false\n", "wet = false\nfurnished_as = \"study\"\n"), "either [[recipe]] or furnished_as");
    says(type_error("width_m = [4.4, 5.6]", "width_m = [5.6, 4.4]"), "expected [low, high]");
}

// docs/extend/room-type.md: one file, and nothing else names the type.
TEST(RoomTypeFiles, AFileIsEnough) {
    for (const char* words : {"a walk-in closet", "a classic dressing room at night"}) {
        PromptSpec spec = read(words);
        EXPECT_EQ(spec.room, "walk_in_closet") << words;
        EXPECT_TRUE(spec.words_with(PromptWord::Fate::not_understood).empty()) << words;
        const FurnishedRoom room = furnish_room(spec, {1, nullptr, {}});
        const auto count = [&](std::string_view kind) {
            return std::count_if(room.placed.begin(), room.placed.end(),
                                 [&](const Placed& p) { return p.piece.kind == kind; });
        };
        EXPECT_GE(count("wardrobe"), 2) << words;
        EXPECT_GE(count("mirror"), 1) << words;
        EXPECT_EQ(count("sofa") + count("bed"), 0) << words;
        EXPECT_TRUE(spec.not_placed.empty()) << words;
    }
    EXPECT_EQ(read("a bedroom with a walk-in closet").next_room, "walk_in_closet");
}

TEST(RoomTypeFiles, TheDocsShowTheFileThatShips) {
    const std::string page = type_text(fs::path(FASTSCENE_SOURCE_DIR) / "docs/extend/room-type.md");
    const std::string file = type_text(kTypesFolder / "walk_in_closet.toml"), fence = "```toml\n";
    int blocks = 0;
    for (std::size_t at = page.find(fence); at != std::string::npos; at = page.find(fence, at + 1), ++blocks) {
        const std::size_t from = at + fence.size();
        const std::string part = page.substr(from, page.find("```", from) - from);
        EXPECT_NE(file.find(part), std::string::npos) << part;
    }
    EXPECT_EQ(blocks, 2);
}

// What is known of a type stands in its file.
TEST(RoomTypeFiles, CodeNamesNoTypes) {
    const std::regex literal(R"re("((?:[^"\\\n]|\\.)*)")re"), comment(R"(//[^\n]*|#include[^\n]*)");
    // What stands on shelves is called after the kitchen; and the words in which edits speak of the room as a whole.
    const std::set<std::string> exempt{"style_choices.h", "edit_place_words.cc"};
    for (const auto& entry : fs::directory_iterator(kTypesFolder.parent_path())) {
        const std::string name = entry.path().filename().string();
        const bool code = entry.path().extension() == ".cc" || entry.path().extension() == ".h";
        if (!code || name.ends_with("_test.cc") || exempt.contains(name)) continue;
        const std::string text = std::regex_replace(type_text(entry.path()), comment, "");
        for (std::sregex_iterator it(text.begin(), text.end(), literal), end; it != end; ++it)
            EXPECT_EQ(find_room_type((*it)[1].str()), nullptr)
                << name << ": put what the code says of \"" << (*it)[1] << "\" into room_types/" << (*it)[1] << ".toml";
    }
}

// What people call a room mostly has a kind of its own; the rest becomes the nearest one, and is told so.
TEST(RoomTypeFiles, FewWordsForRoomsAreApproximated) {
    int words = 0, approximated = 0;
    std::string list;
    for (const std::string& term : lexicon_terms()) {
        const auto word = look_up(term);
        if (!word || word->kind != WordKind::room) continue;
        ++words;
        if (!word->exact) ++approximated, list += "\n  " + term + ": " + word->meaning;
    }
    EXPECT_GE(words, 1500);
    EXPECT_LE(approximated, 60) << list;
}

// A word means one kind.
TEST(RoomTypeFiles, NoWordStandsTwice) {
    std::map<std::string, std::string> owner;
    for (const RoomType& type : all_room_types())
        for (const auto* words : {&type.words, &type.words_near})
            for (const std::string& word : *words) {
                const auto [at, added] = owner.emplace(word, type.name);
                EXPECT_TRUE(added) << word << ": " << at->second << " and " << type.name;
            }
}

}  // namespace
}  // namespace fastscene

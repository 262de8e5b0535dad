#include <gtest/gtest.h>

#include <algorithm>

#include "fastscene/base/error.h"
#include "fastscene/rooms/furniture.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/plan.h"
#include "fastscene/rooms/rooms.h"
#include "fastscene/rooms/test_prompts.h"

namespace fastscene {
namespace {

std::vector<std::string> words_of(const PromptSpec& spec, PromptWord::Fate fate) {
    std::vector<std::string> out;
    for (const PromptWord& w : spec.words_with(fate)) out.push_back(w.words);
    return out;
}
std::vector<std::string> not_understood(const PromptSpec& spec) {
    return words_of(spec, PromptWord::Fate::not_understood);
}
std::vector<std::string> approximated(const PromptSpec& spec) { return words_of(spec, PromptWord::Fate::approximated); }

TEST(Prompt, WallsAndFloorsTakeAdjectivesToo) {
    const PromptSpec spec = read("White walls and an oak floor");
    const PromptObject *wall = object_of(spec, "wall"), *floor = object_of(spec, "floor");
    ASSERT_TRUE(wall && floor);
    EXPECT_EQ(wall->color, "white");
    EXPECT_EQ(floor->material.empty() ? floor->color : floor->material, "oak");
}

TEST(Prompt, CountsAndPlurals) {
    const PromptSpec two = read("two blue armchairs");
    ASSERT_TRUE(object_of(two, "armchair"));
    EXPECT_EQ(object_of(two, "armchair")->count, 2);
    EXPECT_EQ(object_of(two, "armchair")->color, "blue");
    EXPECT_EQ(object_of(read("a dining table with six wooden chairs"), "chair")->count, 6);
    EXPECT_EQ(object_of(read("a table with a chair"), "chair")->count, 1);
    EXPECT_GE(object_of(read("a room with plants"), "plant")->count, 2);
    EXPECT_EQ(object_of(read("a pair of armchairs"), "armchair")->count, 2);
    EXPECT_EQ(object_of(read("3 stools"), "stool")->count, 3);
    EXPECT_EQ(object_of(read("four large windows"), "window")->count, 4);
    EXPECT_EQ(object_of(read("white walls"), "wall")->count, 1);
    for (const char* words : {"bookshelves", "benches", "candles", "vases", "couches", "wardrobes", "ottomans"})
        EXPECT_FALSE(read(words).objects.empty()) << words;
}

TEST(Prompt, Relations) {
    const PromptSpec spec = read("a lamp on the desk, a desk under the window and a plant in the corner");
    ASSERT_TRUE(object_of(spec, "table_lamp") && object_of(spec, "plant"));
    EXPECT_EQ(object_of(spec, "table_lamp")->relation, "on");
    EXPECT_EQ(object_of(spec, "table_lamp")->relation_to, "desk");
    EXPECT_EQ(object_of(spec, "plant")->relation, "in the corner");
    EXPECT_EQ(
        std::count_if(spec.objects.begin(), spec.objects.end(), [](const PromptObject& o) { return o.kind == "desk"; }),
        1)
        << "the desk is one desk";
    EXPECT_EQ(object_of(spec, "desk")->relation_to, "window");
    const PromptSpec under = read("a desk under the window");
    EXPECT_EQ(object_of(under, "desk")->relation, "under");
    EXPECT_EQ(object_of(under, "desk")->relation_to, "window");
}

TEST(Prompt, EveryStyleAndRoomIsSayable) {
    for (const std::string style : {"modern", "scandinavian", "japandi", "industrial", "classic", "boho", "rustic",
                                    "mid-century", "mediterranean", "art deco"})
        for (const std::string& room : room_types()) {
            const PromptSpec spec = understand_prompt("a " + style + " " + room_title(room), true);
            EXPECT_EQ(spec.style, style);
            EXPECT_EQ(spec.room, room);
        }
}

TEST(Prompt, TyposOfOneLetterAreReadAndReported) {
    for (const char* typo : {"a bedrom", "a bedroon", "a bedorom", "a bedrroom"}) {
        const PromptSpec spec = read(typo);
        EXPECT_EQ(spec.room, "bedroom") << typo;
        EXPECT_EQ(approximated(spec).size(), 1u) << typo;
    }
}

TEST(Prompt, UnknownWordsAreReportedAsWritten) {
    const PromptSpec spec = read("a bedroom with a flurbomat and a bed");
    EXPECT_EQ(not_understood(spec), std::vector<std::string>{"flurbomat"});
    EXPECT_TRUE(object_of(spec, "bed"));
    EXPECT_THROW(understand_prompt("a bedroom with a flurbomat", true), UsageError);
    EXPECT_NO_THROW(understand_prompt("a cozy bedroom with a red armchair, at night", true));
    EXPECT_THROW(understand_prompt("and with the", true), UsageError);
}

TEST(Prompt, ApproximationsAreReported) {
    const PromptSpec spec = read("a music room with a harpsichord");
    EXPECT_TRUE(object_of(spec, "piano"));
    EXPECT_EQ(approximated(spec).size(), 1u);
    EXPECT_EQ(spec.room, "music_room");
}

TEST(Prompt, BadTextIsRefused) {
    EXPECT_THROW(read(""), UsageError);
    EXPECT_THROW(read(" \t\n "), UsageError);
    EXPECT_THROW(read(std::string(10000, 'a')), UsageError);
    EXPECT_THROW(read("a caf\xe9 room"), UsageError);           // Latin-1
    EXPECT_THROW(read("a room \xc3"), UsageError);              // cut short
    EXPECT_THROW(read("a room \xed\xa0\x80"), UsageError);      // a surrogate
    EXPECT_THROW(read("a room \xe0\x80\x80"), UsageError);      // overlong
    EXPECT_THROW(read("a room \xf4\x90\x80\x80"), UsageError);  // beyond U+10FFFF
    EXPECT_NO_THROW(read("ein caf\xc3\xa9 \xe5\xae\xa4"));
    EXPECT_NO_THROW(read("!!! ??? ,,,"));
    EXPECT_NO_THROW(read(std::string("a bed\0room", 10)));
}

TEST(Lexicon, IsLargeAndEveryObjectCanBeBuilt) {
    EXPECT_GE(lexicon_size(), 1200u);
    const std::vector<std::string>& classes = piece_classes();
    std::size_t objects = 0;
    for (const std::string& term : lexicon_terms()) {
        const auto word = look_up(term);
        ASSERT_TRUE(word) << term;
        // What no builder knows comes from the furniture pack, or is said to be missing.
        if (word->kind == WordKind::object && std::binary_search(classes.begin(), classes.end(), word->meaning))
            ++objects;
        if (word->kind == WordKind::structure) {
            EXPECT_TRUE(is_shell(word->meaning)) << term;
        }
        if (word->kind == WordKind::style) {
            EXPECT_NO_THROW(style_named(word->meaning)) << term;
        }
        if (word->kind == WordKind::room) {
            const auto rooms = room_types();
            EXPECT_TRUE(std::find(rooms.begin(), rooms.end(), word->meaning) != rooms.end()) << term;
        }
        if (word->kind == WordKind::material) {
            EXPECT_TRUE(material_named(word->meaning)) << term << " means " << word->meaning;
        }
    }
    EXPECT_GE(objects, 600u);
    for (const std::string& kind : classes) {
        bool sayable = false;
        for (const std::string& term : lexicon_terms()) sayable = sayable || look_up(term)->meaning == kind;
        EXPECT_TRUE(sayable) << "no word for " << kind;
    }
}

TEST(Lexicon, LooksUpPlurals) {
    for (const auto& [term, meaning] : {std::pair{"shelves", "shelf"},
                                        {"benches", "bench"},
                                        {"bookshelves", "bookshelf"},
                                        {"night tables", "nightstand"},
                                        {"paintings", "picture"}}) {
        const auto word = look_up(term);
        ASSERT_TRUE(word) << term;
        EXPECT_EQ(word->meaning, meaning);
    }
    EXPECT_FALSE(look_up("zzz"));
    EXPECT_EQ(nearest_term("armchiar"), "armchair");
    EXPECT_FALSE(nearest_term("xylograph"));
}

}  // namespace
}  // namespace fastscene

// How a prompt is read beyond its plain words: typos in compounds, quantities, sizes, scope, negation, structure,
// languages.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "fastscene/rooms/layout.h"
#include "fastscene/rooms/layout_parts.h"
#include "fastscene/rooms/style.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/prints.h"
#include "fastscene/rooms/shapes.h"
#include "fastscene/rooms/rooms.h"
#include "fastscene/rooms/test_prompts.h"

namespace fastscene {
namespace {

// What became of a word: "understood: …", "" when it is in no list.
std::string told(const PromptSpec& spec, std::string_view words) {
    static constexpr const char* kFates[] = {"understood", "approximated", "not understood"};
    for (const PromptWord& w : spec.words)
        if (w.words == words) return std::string(kFates[static_cast<std::size_t>(w.fate)]) + ": " + w.meaning;
    return {};
}
bool is_told(const PromptSpec& spec, std::string_view words, std::string_view how) {
    return told(spec, words).starts_with(how);
}

struct Furnished {
    PromptSpec spec;
    FurnishedRoom room;
};
Furnished furnished(const std::string& text, std::uint64_t seed = 3) {
    Furnished out{read(text), {}};
    fastscene::Run run;
    run.seed = seed;
    out.room = furnish_room(out.spec, run);
    return out;
}

TEST(PromptWords, NothingOnTheWallsIsHeeded) {
    for (const char* text : {"a study with one desk, one lamp, nothing on the walls",
                             "one desk one lamp nothing on the walls", "a living room with bare walls"}) {
        const Furnished f = furnished(text);
        for (const Placed& p : f.room.placed)
            EXPECT_TRUE(p.piece.kind != "picture" && p.piece.kind != "mirror" && p.piece.kind != "clock")
                << text << ": " << p.piece.kind;
    }
    EXPECT_EQ(object_of(read("one lamp nothing on the walls"), "table_lamp")->relation, "");
    const PromptSpec clock = read("a kitchen with a clock and nothing else on the walls");
    EXPECT_TRUE(object_of(clock, "clock"));
}

TEST(PromptWords, WhatARoomIsForSaysWhatItLooksLikeAndWhatItHasNot) {
    for (const std::uint64_t seed : {0u, 1u})
        for (const char* text :
             {"an antique shop", "a meditation room", "a chapel with candles", "a white gallery space"}) {
            const Furnished f = furnished(text, seed);
            for (const Placed& p : f.room.placed) EXPECT_NE(p.piece.kind, "tv") << text;
        }
    EXPECT_EQ(read("a speakeasy").style, "art deco");
    EXPECT_EQ(read("a scandinavian speakeasy").style, "scandinavian");
    EXPECT_TRUE(object_of(read("a hat shop with a tv"), "tv"));
    EXPECT_EQ(object_of(read("a laboratory with three steel tables"), "steel_table")->count, 3);
    EXPECT_EQ(object_of(read("a restaurant with tables"), "dining_table")->count, 2);
}

TEST(PromptWords, AThrowOverAChairLiesOnIt) {
    for (const char* text :
         {"a throw over the armchair", "a knitted blanket thrown over an armchair", "a throw across the sofa"})
        EXPECT_EQ(object_of(read(text), "throw")->relation, "on") << text;
    const PromptSpec over = read("a lamp over the table");
    ASSERT_TRUE(object_of(over, "pendant_lamp"));
    EXPECT_EQ(object_of(over, "pendant_lamp")->relation, "above");
    const PromptSpec stacked = read("a washing machine under the dryer");
    EXPECT_TRUE(std::any_of(stacked.objects.begin(), stacked.objects.end(),
                            [](const PromptObject& o) { return o.words == "dryer" && o.relation == "on"; }));
    EXPECT_EQ(told(read("a sofa on a foggy morning"), "on"), "");
}

TEST(PromptWords, ASkylightGetsItsSlopeAndAnArchwayItsWall) {
    for (const std::uint64_t seed : {0u, 1u, 2u}) {
        for (const char* text : {"a cat on a grey sofa beneath a large skylight", "a bathroom with a skylight"}) {
            const Furnished sky = furnished(text, seed);
            EXPECT_FALSE(sky.room.plan.skylights.empty()) << text;
            for (const std::string& line : sky.spec.not_placed) EXPECT_FALSE(line.starts_with("skylight")) << line;
        }
        const Furnished arch = furnished("a loft apartment with an archway", seed);
        EXPECT_TRUE(std::any_of(arch.room.plan.openings.begin(), arch.room.plan.openings.end(),
                                [](const Opening& o) { return o.kind == Opening::Kind::doorway; }));
    }
}

TEST(PromptWords, WordsOfTheirOwnAreNoTypos) {
    for (const char* word : {"whale", "mouse", "chain", "lives"}) {
        const PromptSpec spec = read(std::string("a room with a ") + word);
        EXPECT_TRUE(told(spec, word).ends_with(": ") || is_told(spec, word, "approximated: nothing"))
            << word << " is " << told(spec, word);
        EXPECT_FALSE(told(spec, word).empty()) << word;
        EXPECT_TRUE(spec.objects.empty()) << word;
    }
}

TEST(PromptWords, OnlyWhatIsNamedStandsThere) {
    for (const char* text :
         {"a bedroom with only a bed", "a room with a bed and nothing else", "an empty bedroom except for a bed",
          "a bedroom with no furniture except a bed", "nothing but a bed in a bedroom"}) {
        const Furnished f = furnished(text);
        EXPECT_EQ(f.spec.clutter, "empty") << text;
        EXPECT_EQ(std::count_if(f.room.placed.begin(), f.room.placed.end(),
                                [](const Placed& p) { return p.wish.kind == "bed"; }),
                  1)
            << text;
        for (const Placed& p : f.room.placed)
            EXPECT_FALSE(p.wish.kind.empty()) << text << ": nobody asked for " << p.piece.kind;
    }
    EXPECT_EQ(read("just a simple bedroom with a bed").clutter, "bare");
    EXPECT_EQ(read("the only light comes from a lamp").clutter, "");
    EXPECT_EQ(read("a room with a table and only two chairs").clutter, "");
    EXPECT_EQ(read("a room with an empty vase").clutter, "");
}

TEST(PromptWords, EverythingMeansTheWholeRoom) {
    for (const char* text : {"a kitchen where everything is pink", "an all pink kitchen", "a kitchen, entirely pink",
                             "a kitchen all in pink", "pink everything in a kitchen"}) {
        const PromptSpec spec = read(text);
        EXPECT_EQ(spec.everything.color, "pink") << text;
        EXPECT_TRUE(spec.colors.empty()) << text;
    }
    const Furnished f = furnished("a kitchen where everything is pink");
    for (const Material* m :
         {&f.room.plan.style.wall, &f.room.plan.style.floor, &f.room.plan.style.wood, &f.room.plan.style.fabric})
        EXPECT_GT(m->color_a.x, 1.2f * m->color_a.y);
    const PromptSpec walls = read("a kitchen with all white walls");
    EXPECT_TRUE(walls.everything.kind.empty());
    EXPECT_EQ(object_of(walls, "wall")->color, "white");
}

TEST(PromptWords, NotBelongsToTheAdjective) {
    const PromptSpec sofa = read("a living room, the sofa is not brown but green");
    ASSERT_TRUE(object_of(sofa, "sofa"));
    EXPECT_EQ(object_of(sofa, "sofa")->color, "green");
    EXPECT_EQ(object_of(sofa, "sofa")->not_color, "brown");
    EXPECT_EQ(object_of(read("a sofa, not brown but green"), "sofa")->color, "green");
    const PromptSpec curtains = read("the curtains aren't white but navy");
    EXPECT_EQ(object_of(curtains, "curtain")->color, "navy");
    EXPECT_EQ(object_of(read("walls that aren't gray"), "wall")->not_color, "gray");
    const PromptSpec bathroom = read("a not too big bathroom");
    EXPECT_EQ(bathroom.room, "bathroom");
    EXPECT_EQ(bathroom.size, "");
    Furnished f = furnished("a living room with a sofa that is not brown");
    EXPECT_FALSE(object_of(f.spec, "sofa")->color.empty());
    EXPECT_NE(object_of(f.spec, "sofa")->color, "brown");
}

TEST(PromptWords, BoundsAndRangesOfCounts) {
    const auto chairs = [](const char* text) {
        const PromptSpec spec = read(text);
        return object_of(spec, "chair") ? object_of(spec, "chair")->count : 0;
    };
    EXPECT_EQ(chairs("fewer than five chairs"), 4);
    EXPECT_EQ(chairs("more than three chairs"), 4);
    EXPECT_EQ(chairs("at least two chairs"), 2);
    EXPECT_EQ(chairs("no more than three chairs"), 3);
    EXPECT_EQ(chairs("two or three chairs"), 3);
    EXPECT_EQ(chairs("between two and four chairs"), 4);
    EXPECT_EQ(chairs("4-5 chairs"), 5);
    EXPECT_TRUE(is_told(read("fewer than five chairs"), "fewer than five", "understood: count 4"));
}

TEST(PromptWords, TablesForSoMany) {
    for (const char* text : {"a dining room with a table for eight", "a dining table for eight people",
                             "a dining table that seats eight", "an eight-seater dining table"}) {
        const PromptSpec spec = read(text);
        ASSERT_TRUE(object_of(spec, "dining_table") && object_of(spec, "chair")) << text;
        EXPECT_EQ(object_of(spec, "chair")->count, 8) << text;
        EXPECT_EQ(object_of(spec, "dining_table")->count, 1) << text;
        EXPECT_FALSE(object_of(spec, "person")) << text;
    }
    const PromptSpec benches = read("a table for eight with benches");
    EXPECT_FALSE(object_of(benches, "chair"));
    EXPECT_EQ(object_of(benches, "bench")->count, 4);
    const Furnished f = furnished("a dining room with a table for eight");
    EXPECT_EQ(std::count_if(f.room.placed.begin(), f.room.placed.end(),
                            [](const Placed& p) { return p.piece.kind == "chair"; }),
              8);
}

TEST(PromptWords, SizesInMetresAndFeet) {
    for (const char* text : {"a 4 by 5 metre bedroom", "a 4x5m bedroom", "bedroom, 4 m x 5 m",
                             "a bedroom measuring 4 × 5 meters", "ein Schlafzimmer mit 4 mal 5 Metern"}) {
        const Furnished f = furnished(text);
        EXPECT_NEAR(f.room.plan.width, 4.f, 1e-3f) << text;
        EXPECT_NEAR(f.room.plan.depth, 5.f, 1e-3f) << text;
        EXPECT_EQ(f.spec.room, "bedroom") << text;
        EXPECT_TRUE(f.spec.words_with(PromptWord::Fate::not_understood).empty()) << text;
    }
    EXPECT_NEAR(furnished("a bedroom with a 3 m high ceiling").room.plan.height, 3.f, 1e-3f);
    EXPECT_NEAR(furnished("a bedroom with 10-foot ceilings").room.plan.height, 3.048f, 1e-3f);
    const Plan area = furnished("a 20 m² living room").room.plan;
    EXPECT_NEAR(area.width * area.depth, 20.f, 0.1f);
    for (const char* text :
         {"a two metre wide bed", "a bed two metres wide", "a 2.0 m wide bed", "a 200 cm wide bed"}) {
        const PromptSpec spec = read(text);
        ASSERT_TRUE(object_of(spec, "bed")) << text;
        EXPECT_NEAR(object_of(spec, "bed")->size_m.x, 2.f, 1e-3f) << text;
        EXPECT_EQ(object_of(spec, "bed")->count, 1) << text;
        EXPECT_EQ(object_of(spec, "bed")->size, "") << text;
    }
    const Furnished f = furnished("a bedroom with a two metre wide bed");
    for (const Placed& p : f.room.placed) {
        if (p.wish.kind == "bed") {
            EXPECT_NEAR(p.piece.size_m.x, 2.f, 0.02f);
        }
    }
    // Out of what rooms can be: nearest, and said so.
    const Furnished hall = furnished("a 40 by 50 metre living room");
    EXPECT_TRUE(is_told(hall.spec, "40 by 50 metre", "approximated: the room is 10.00 m by 10.00 m"));
}

TEST(PromptWords, TwoThingsOfOneClassAreTwo) {
    const PromptSpec spec = read("a laundry room with a dryer on top of the washing machine");
    const auto machines = std::count_if(spec.objects.begin(), spec.objects.end(),
                                        [](const PromptObject& o) { return o.kind == "washing_machine"; });
    EXPECT_EQ(machines, 2);
    EXPECT_EQ(spec.objects[0].relation, "on");
    EXPECT_EQ(spec.objects[0].relation_to, "washing_machine");
    EXPECT_EQ(read("a sofa, and a cat on the couch").objects.size(), 2u);
}

TEST(PromptWords, PronounsAndEachFindTheirPiece) {
    const PromptSpec clock = read("between the two windows stands a cabinet, above it hangs a clock");
    EXPECT_EQ(object_of(clock, "clock")->relation_to, "cabinet");
    const PromptSpec kettle = read("eight cushions around a low table and a kettle on it");
    EXPECT_EQ(object_of(kettle, "kettle")->relation_to, "coffee_table");
    const PromptSpec beds = read("twin beds with a picture above each bed");
    EXPECT_EQ(std::count_if(beds.objects.begin(), beds.objects.end(),
                            [](const PromptObject& o) { return o.kind.starts_with("bed"); }),
              1);
    EXPECT_EQ(object_of(beds, "picture")->count, 2);
    const PromptSpec coffee = read("a kitchen, coffee steaming on the counter, sun through the blinds");
    EXPECT_EQ(object_of(coffee, "venetian_blind")->relation, "");
    EXPECT_TRUE(coffee.colors.empty());
    const PromptSpec wardrobe = read("a bed under the window, a wardrobe on the opposite wall");
    EXPECT_EQ(object_of(wardrobe, "wardrobe")->relation_to, "bed");
}

// Who is joined by "and" to what stands there stands there too; not what another piece has with it.
TEST(PromptWords, JoinedThingsStandOnTheSamePlace) {
    const auto on = [](const PromptSpec& spec, const char* kind) {
        const PromptObject* o = object_of(spec, kind);
        return o ? o->relation + " " + o->relation_to : std::string("nothing");
    };
    const PromptSpec sill = read("a kitchen with herbs and a vase on the window sill");
    EXPECT_EQ(on(sill, "plant_small"), "on window");
    EXPECT_EQ(on(sill, "vase"), "on window");
    const PromptSpec desk = read("a study with a stack of books, a globe and a brass lamp on the desk");
    for (const char* kind : {"book_stack", "globe", "table_lamp"}) EXPECT_EQ(on(desk, kind), "on desk") << kind;
    const PromptSpec two = read("a study with a desk with a lamp and a vase on the shelf");
    EXPECT_EQ(on(two, "vase"), "on shelf");
    EXPECT_EQ(on(two, "table_lamp"), " ");
    EXPECT_EQ(on(read("a living room with a sofa and a vase on the table"), "sofa"), " ");
}

TEST(PromptWords, APartThatIsSaidAloneIsOfThePieceBefore) {
    for (const char* text : {"a bathroom with a freestanding tub, candles on the rim and a towel",
                             "a bathroom with candles on the rim of the bathtub"}) {
        const Furnished f = furnished(text);
        const PromptObject* candles = object_of(f.spec, "candle");
        ASSERT_TRUE(candles) << text;
        EXPECT_EQ(candles->relation_to, "bathtub") << text;
        for (const Placed& p : f.room.placed)
            if (p.wish.kind == "candle") {
                ASSERT_GE(p.on, 0) << text;
                EXPECT_EQ(f.room.placed[static_cast<std::size_t>(p.on)].piece.kind, "bathtub") << text;
            }
    }
}

// A theme brings things that stand in the room, or says that there is no place; who forbids them gets none.
TEST(PromptWords, ThemesBringTheirThings) {
    for (const auto& [text, classes] :
         {std::pair{"a pirate themed kids room", std::vector<const char*>{"trunk", "picture", "ship_model"}},
          {"a gamer's bedroom", std::vector<const char*>{"desk", "monitor", "pc_tower"}},
          {"a gaming room with three monitors", std::vector<const char*>{"desk", "monitor", "office_chair"}}}) {
        const Furnished f = furnished(text);
        for (const char* kind : classes) {
            const PromptObject* o = object_of(f.spec, kind);
            ASSERT_TRUE(o) << text << ": " << kind;
            const bool there = std::any_of(f.room.placed.begin(), f.room.placed.end(),
                                           [&](const Placed& p) { return p.wish.kind == kind; });
            const bool told_why = std::any_of(
                f.spec.not_placed.begin(), f.spec.not_placed.end(),
                [&](const std::string& line) { return line.starts_with(o->words + ": "); });
            EXPECT_TRUE(there || told_why) << text << ": " << kind;
        }
        EXPECT_TRUE(f.spec.words_with(PromptWord::Fate::not_understood).empty()) << text;
    }
    EXPECT_EQ(read("a gaming room with a sofa").light, "neon");
    EXPECT_EQ(read("a gaming room with a dim light").light, "dim");
    EXPECT_EQ(read("a gaming room in the morning").light, "");
    const PromptSpec bare = read("a pirate bedroom without pictures");
    EXPECT_TRUE(std::none_of(bare.objects.begin(), bare.objects.end(),
                             [](const PromptObject& o) { return o.kind == "picture" && !o.forbidden; }));
    const PromptSpec only = read("a pirate bedroom with only a bed");
    EXPECT_FALSE(object_of(only, "trunk"));
    // The picture that was named shows it; else one is hung.
    EXPECT_EQ(object_of(read("a bedroom with a painting of a lion"), "picture")->pattern, "lion");
    EXPECT_EQ(object_of(read("a nursery with elephants"), "picture")->pattern, "elephant");
}

TEST(PromptWords, TheEndFurnishesAndTheStructureShapes) {
    for (const char* text : {"an attic study", "a study in the attic", "an attic converted to a study"}) {
        const Furnished f = furnished(text);
        EXPECT_EQ(f.spec.room, "study") << text;
        EXPECT_EQ(f.spec.structure, "attic") << text;
        EXPECT_GT(f.room.plan.knee, 0.f) << text;
        EXPECT_TRUE(std::any_of(f.room.placed.begin(), f.room.placed.end(), [](const Placed& p) {
            return p.piece.kind == "desk";
        })) << text;
        EXPECT_FALSE(std::any_of(f.room.placed.begin(), f.room.placed.end(), [](const Placed& p) {
            return p.piece.kind == "bed";
        })) << text;
    }
    EXPECT_EQ(read("a loft kitchen").room, "kitchen");
    EXPECT_EQ(read("a loft kitchen").structure, "loft");
    EXPECT_EQ(read("an attic").room, "attic");
    EXPECT_EQ(read("an attic with a reading nook").room, "attic");
}

TEST(PromptWords, LanguagesThatAreNotReadAreNamed) {
    for (const auto& [text, language] :
         {std::pair{"een slaapkamer met een groot bed en een rode stoel bij het raam", "Dutch"},
          {"sypialnia z dużym łóżkiem i czerwonym krzesłem przy oknie", "Polish"},
          {"uma sala com um sofá vermelho e uma mesa de madeira", "Portuguese"},
          {"赤いソファのある居間", "Japanese"},
          {"спальня с большой кроватью", "a language in Cyrillic letters"},
          {"ett sovrum med en stor säng och en röd stol", "Swedish"}}) {
        const PromptSpec spec = read(text);
        EXPECT_EQ(spec.unread, language) << text;
        EXPECT_FALSE(spec.words_with(PromptWord::Fate::not_understood).empty()) << text;
        for (const PromptWord& w : spec.words)
            EXPECT_EQ(w.meaning.find("read as"), std::string::npos) << text << ": " << w.words << " " << w.meaning;
    }
    for (const char* text : {"a large bedroom, en suite", "a room under the stairs for me",
                             "ein gemütliches Wohnzimmer mit einem roten Sofa",
                             "una cocina grande con una mesa de madera y cuatro sillas azules",
                             "un soggiorno moderno con un divano verde e due poltrone di pelle",
                             "une chambre moderne avec un lit blanc et des rideaux verts", "sofa, bed, lamp"})
        EXPECT_EQ(read(text).unread, "") << text;
}

// "Gold taps", "black hardware": the metal of what the room has, of basins and handles alike.
TEST(PromptWords, FittingsAreOfTheMetalThatWasSaid) {
    const Furnished f = furnished("a bathroom with gold taps and a washbasin");
    EXPECT_TRUE(f.spec.not_placed.empty());
    const Vec3f tap = f.room.plan.style.tap.color_a;
    EXPECT_GT(f.room.plan.style.tap.metal, 0.5f);
    EXPECT_GT(tap.x, 1.5f * tap.z);
    EXPECT_LT(luminance(furnished("a kitchen with black hardware").room.plan.style.metal.color_a), 0.06f);
}

// In a kitchen cabinets are its units, whose fronts take the color; an island is like them.
TEST(PromptWords, KitchenCabinetsAreTheUnits) {
    const Furnished f = furnished("a kitchen with mint green cabinets and an island");
    EXPECT_FALSE(object_of(f.spec, "cabinet"));
    int fronts = 0;
    for (const Placed& p : f.room.placed)
        if (p.piece.kind == "kitchen_counter" || p.piece.kind == "kitchen_island") {
            const Vec3f c = p.piece.materials[static_cast<std::size_t>(p.piece.main_material)].color_a;
            EXPECT_GT(c.y, 1.1f * c.x) << p.piece.kind;
            ++fronts;
        }
    EXPECT_GE(fronts, 2);
    EXPECT_TRUE(object_of(read("a dining room with two cabinets"), "cabinet"));
}

TEST(PromptWords, RoundRugsAndMirrorsAreRound) {
    for (const char* text :
         {"a living room with a round rug", "a bedroom with a round blue rug", "a study with a circular wool rug"}) {
        const Furnished f = furnished(text);
        const auto rug = std::find_if(f.room.placed.begin(), f.room.placed.end(),
                                      [](const Placed& p) { return p.piece.kind == "rug"; });
        ASSERT_TRUE(rug != f.room.placed.end()) << text;
        EXPECT_NEAR(rug->piece.size_m.x, rug->piece.size_m.z, 0.02f) << text;
    }
    EXPECT_EQ(object_of(read("a bedroom with a round blue rug"), "rug")->color, "blue");
    for (const char* text : {"a modern bathroom with a round mirror", "a rustic bedroom with a round brass mirror"}) {
        const Furnished f = furnished(text);
        const auto mirror = std::find_if(f.room.placed.begin(), f.room.placed.end(),
                                         [](const Placed& p) { return p.piece.kind == "mirror"; });
        ASSERT_TRUE(mirror != f.room.placed.end()) << text;
        EXPECT_NEAR(mirror->piece.size_m.x, mirror->piece.size_m.y, 0.02f) << text;
    }
    EXPECT_TRUE(object_of(read("a bedroom with a blue rug"), "rug")->pattern.empty());
}

TEST(PromptWords, AVaseOfFlowersIsOneThing) {
    for (const char* text : {"a dining room with a vase of tulips", "a dining room with a vase with pink roses",
                             "a dining room with tulips"}) {
        const PromptSpec spec = read(text);
        EXPECT_TRUE(object_of(spec, "bouquet")) << text;
        EXPECT_FALSE(object_of(spec, "vase")) << text;
    }
    EXPECT_EQ(object_of(read("a kitchen with a vase with pink roses"), "bouquet")->color, "pink");
    // What is said of the vase is the vase's.
    const PromptSpec two = read("a kitchen with a blue glass vase of yellow tulips on the table");
    EXPECT_EQ(object_of(two, "bouquet")->color, "yellow");
    EXPECT_EQ(object_of(two, "bouquet")->holder_color, "blue");
    EXPECT_EQ(object_of(two, "bouquet")->holder_material, "glass");
    EXPECT_TRUE(object_of(two, "bouquet")->material.empty());
    const Furnished f = furnished("a kitchen with a blue vase of yellow tulips on the table");
    const auto p = std::find_if(f.room.placed.begin(), f.room.placed.end(),
                                [](const Placed& x) { return x.piece.kind == "bouquet"; });
    ASSERT_TRUE(p != f.room.placed.end());
    EXPECT_TRUE(std::any_of(p->piece.materials.begin(), p->piece.materials.end(),
                            [](const Material& m) { return m.color_a == *color_named("blue"); }));
    EXPECT_EQ(p->piece.materials[static_cast<std::size_t>(p->piece.main_material)].color_a, *color_named("yellow"));
    EXPECT_TRUE(object_of(read("a kitchen with a blue vase"), "vase"));
}

// Rain, snow and light are nowhere in the room; what was named before them is not there either.
TEST(PromptWords, WeatherOnTheWindowIsNoPlaceOfAPiece) {
    EXPECT_TRUE(object_of(read("a study with old books and rain on the window"), "book_stack")->relation.empty());
    EXPECT_EQ(object_of(read("a study with books on the window sill"), "book_stack")->relation, "on");
}

// Who asks for one single bed gets no double bed beside it.
TEST(PromptWords, ASingleBedIsTheBedOfItsRoom) {
    for (const char* text :
         {"a bedroom with a single bed", "a tiny attic bedroom with a single bed and a rocking chair"})
        for (const std::uint64_t seed : {1u, 2u, 3u}) {
            const Furnished f = furnished(text, seed);
            const auto beds = std::count_if(f.room.placed.begin(), f.room.placed.end(),
                                            [](const Placed& p) { return p.piece.kind.starts_with("bed"); });
            EXPECT_EQ(beds, 1) << text << ", seed " << seed;
        }
}

// Behind clouds the evening sun lights nothing; people who live there suggest a style.
TEST(PromptWords, WhatIsNotSaidFollowsFromWhatIs) {
    EXPECT_EQ(furnished("a living room on a rainy evening").spec.time, "dusk");
    EXPECT_EQ(furnished("a living room at sunset").spec.time, "evening");
    EXPECT_EQ(read("grandma's kitchen").style, "classic");
    EXPECT_EQ(furnished("a bedroom with a rocking chair").spec.style, "rustic");
    EXPECT_EQ(furnished("a modern bedroom with a rocking chair").spec.style, "modern");
    EXPECT_EQ(object_of(read("a sunroom with terracotta tiles"), "floor")->material, "tile");
    EXPECT_EQ(object_of(read("a bathroom with blue tiles"), "wall")->material, "tile");
}

// A material of no piece is that of the furniture: its seats, its wood, its metal.
TEST(PromptWords, AccentMaterialsShowInTheFurniture) {
    const Furnished rattan = furnished("a sunroom with rattan furniture and plants");
    EXPECT_TRUE(is_told(rattan.spec, "rattan", "understood"));
    int woven = 0;
    for (const Placed& p : rattan.room.placed)
        if (furnishing::is_seat(p.piece.kind))
            for (const Material& m : p.piece.materials) woven += m.pattern == Pattern::wicker;
    EXPECT_GT(woven, 0);
    const Furnished walnut = furnished("a modern living room with walnut furniture and brass accents");
    EXPECT_EQ(walnut.room.plan.style.wood.color_a, material_named("walnut")->color_a);
    EXPECT_GT(walnut.room.plan.style.metal.metal, 0.5f);
    // A floor stays a floor.
    EXPECT_EQ(object_of(read("a living room with an oak floor"), "floor")->material, "oak");
}

// What has a builder of ours only for those who ask stands where it belongs.
TEST(PromptWords, RareWishesStandOrHangWhereTheyBelong) {
    for (const auto& [text, kind, mount] :
         {std::tuple{"a living room with a christmas tree", "christmas_tree", Mount::floor},
          {"a bedroom with a rocking chair", "rocking_chair", Mount::floor},
          {"a sunroom with a hammock", "hammock", Mount::floor},
          {"a nursery with a crib and a mobile", "cot_mobile", Mount::ceiling},
          {"a laundry room with a drying rack", "clothes_horse", Mount::floor},
          {"a study with copper pipes", "pipes", Mount::wall},
          {"a study with gears", "gears", Mount::wall},
          {"a rustic dining room with cobwebs", "cobweb", Mount::ceiling},
          {"a kitchen with copper pots", "hung_pans", Mount::wall},
          {"a bedroom with a dressing table", "dressing_table", Mount::floor}}) {
        const Furnished f = furnished(text);
        const auto p = std::find_if(f.room.placed.begin(), f.room.placed.end(),
                                    [&](const Placed& x) { return x.piece.kind == kind; });
        ASSERT_TRUE(p != f.room.placed.end()) << text;
        EXPECT_EQ(p->piece.mount, mount) << text;
        if (std::string(kind) != "cobweb") continue;
        // In the corner: two walls and the ceiling touch it.
        const Footprint box = footprint_of(*p);
        EXPECT_NEAR(box.y1, f.room.plan.height, 0.01f);
        EXPECT_NEAR(std::abs(box.center.x) + extent(box, {1, 0}), f.room.plan.width / 2, 0.02f);
        EXPECT_NEAR(std::abs(box.center.y) + extent(box, {0, 1}), f.room.plan.depth / 2, 0.02f);
    }
}

// What is said of a bunk is its frame's, what is said of the bedding the duvets'; what is underneath is under what was
// named before.
TEST(PromptWords, BedsOfManyPartsTakeTheirWords) {
    const PromptSpec spec = read("a kids room with a red metal bunk bed with blue bedding");
    const PromptObject* bunk = object_of(spec, "bunk_bed");
    ASSERT_TRUE(bunk);
    EXPECT_EQ(bunk->color, "red");
    EXPECT_EQ(bunk->material, "metal");
    EXPECT_EQ(bunk->holder_color, "blue");
    const Furnished f = furnished("a kids room with a white bunk bed with blue bedding");
    const auto p = std::find_if(f.room.placed.begin(), f.room.placed.end(),
                                [](const Placed& x) { return x.piece.kind == "bunk_bed"; });
    ASSERT_TRUE(p != f.room.placed.end());
    int blue = 0;
    for (const Material& m : p->piece.materials) blue += m.name == "duvet" && m.color_a.z > 1.5f * m.color_a.x;
    EXPECT_EQ(blue, 2);
    const Vec3f frame = p->piece.materials[static_cast<std::size_t>(p->piece.main_material)].color_a;
    EXPECT_LT(frame.z, 1.1f * frame.x);
    for (const char* text : {"a room with a loft bed with a desk underneath",
                             "a loft bed with a desk underneath and a bean bag", "a loft bed with a desk below it"}) {
        const PromptSpec lofty = read(text);
        ASSERT_TRUE(object_of(lofty, "desk")) << text;
        EXPECT_EQ(object_of(lofty, "desk")->relation_to, "loft_bed") << text;
    }
    // One bed, whatever is said of its mattress.
    EXPECT_EQ(read("a bed with a soft mattress").objects.size(), 1u);
    EXPECT_TRUE(object_of(read("a mattress on the floor"), "floor_bed"));
    // Other languages.
    for (const char* text : {"ein kinderzimmer mit etagenbett", "une chambre d'enfant avec lits superposes",
                             "una cameretta con letto a castello", "un dormitorio con una litera"})
        EXPECT_TRUE(object_of(read(text), "bunk_bed")) << text;
}

// A blanket lies folded on what one sits or lies on, in its own cloth.
TEST(PromptWords, BlanketsLieOnSeats) {
    for (const auto& [text, on, pattern] :
         {std::tuple{"a living room with a gray sofa and a red knit throw on the sofa", "sofa", Pattern::knit},
          {"a rustic bedroom with a patchwork quilt on the bed", "bed", Pattern::patchwork},
          {"a reading nook with an armchair and a blue plaid blanket", "armchair", Pattern::plaid},
          {"a boho reading nook with a rattan armchair and a blanket", "armchair", Pattern::knit}}) {
        const Furnished f = furnished(text);
        const auto p = std::find_if(f.room.placed.begin(), f.room.placed.end(),
                                    [&](const Placed& x) { return x.piece.kind == "throw"; });
        ASSERT_TRUE(p != f.room.placed.end()) << text;
        ASSERT_GE(p->on, 0) << text;
        EXPECT_EQ(f.room.placed[static_cast<std::size_t>(p->on)].piece.kind, on) << text;
        const Material& cloth = p->piece.materials[static_cast<std::size_t>(p->piece.main_material)];
        EXPECT_EQ(cloth.pattern, pattern) << text;
        const auto red = [](Vec3f c) { return c.x / std::max(c.y, 1e-3f); };
        EXPECT_TRUE(std::string(on) != "sofa" || std::min(red(cloth.color_a), red(cloth.color_b)) > 2.f)
            << "red yarn, in its shade too";
    }
}

// "Velvet couch" is a term of its own and must not forget its velvet. What is made of that anyway need not say it.
TEST(PromptWords, TermsThatNameTheirMaterialKeepIt) {
    const std::vector<std::string> born_so{"barrel",  "basket",     "crate",    "trunk", "rug",
                                           "beams",   "chandelier", "moulding", "vase",  "shower",
                                           "lantern", "tapestry",   "curtain",  "throw"};
    const std::vector<std::string> not_of_it{"linen cupboard", "rubber plant", "rubber tree"};
    int kept = 0;
    for (const std::string& term : lexicon_terms()) {
        const auto space = term.find(' ');
        const auto word = look_up(term);
        if (space == std::string::npos || !word || !word->exact ||
            (word->kind != WordKind::object && word->kind != WordKind::structure))
            continue;
        const auto material = look_up(term.substr(0, space)), noun = look_up(term.substr(space + 1));
        if (!material || material->kind != WordKind::material || !noun || noun->meaning != word->meaning) continue;
        if (std::find(born_so.begin(), born_so.end(), word->meaning) != born_so.end() ||
            std::find(not_of_it.begin(), not_of_it.end(), term) != not_of_it.end())
            continue;
        EXPECT_TRUE(word->adds.starts_with("material=")) << term;
        ++kept;
    }
    EXPECT_GT(kept, 10);
    EXPECT_EQ(read("a study with a glass desk").objects.front().material, "glass");
    EXPECT_EQ(read("a modern hallway with a wooden door").objects.front().material, "wood");
}

// "It" and "them" are what may have such a thing there; where the words before were at a thing too, it is the same one.
TEST(PromptWords, PronounsBindToWhatCanBeMeant) {
    struct Case {
        const char *text, *thing, *relation, *to;
    };
    for (const auto& [text, thing, relation, to] :
         {Case{"a piano opposite the window with a stool in front of it and a painting above it", "picture", "above",
               "piano"},
          {"a piano opposite the window with a stool in front of it and a painting above it", "stool", "in front of",
           "piano"},
          {"two armchairs facing the fireplace, a small round table between them and a rug in front of it", "rug",
           "in front of", "fireplace"},
          {"a study where the desk faces the window and a lamp stands behind it", "floor_lamp", "behind", "desk"},
          {"a bed with a bench in front of it and a mirror above it", "mirror", "above", "bed"},
          {"a sofa with a side table next to it and a lamp on it", "table_lamp", "on", "side_table"},
          {"a fireplace with an armchair beside it and a clock above it", "clock", "above", "fireplace"},
          {"a desk under the window with a chair in front of it and a plant next to it", "plant", "next to", "desk"},
          {"two nightstands beside the bed and a lamp on each of them", "table_lamp", "on", "nightstand"}}) {
        const PromptSpec spec = read(text);
        const PromptObject* object = object_of(spec, thing);
        ASSERT_TRUE(object) << text;
        EXPECT_EQ(object->relation, relation) << text << ": " << thing;
        EXPECT_EQ(object->relation_to, to) << text << ": " << thing;
    }
    // Between those who sit face to face.
    const PromptSpec facing = read(
        "a living room with a sofa, two armchairs opposite it and a coffee table between them");
    EXPECT_EQ(object_of(facing, "coffee_table")->relation_to, "armchair");
    EXPECT_EQ(object_of(facing, "coffee_table")->relation_and, "sofa");
}

// Every pattern that is understood is drawn.
TEST(Prints, EveryPatternOfTheLexiconIsDrawn) {
    int patterns = 0;
    for (const std::string& term : lexicon_terms())
        if (const auto word = look_up(term); word && word->kind == WordKind::pattern) {
            EXPECT_TRUE(word->meaning == "plain" || is_print(word->meaning)) << term;
            ++patterns;
        }
    EXPECT_GT(patterns, 80);
    const float far = 0.06f;
    for (const char* print :
         {"striped", "floral", "damask", "checkered", "dots", "zigzag", "herringbone", "geometric", "diamonds",
          "lattice", "stars", "gingham", "plaid", "houndstooth", "paisley", "encaustic"})
        for (const std::string& style : styles())
            for (const PrintGround ground :
                 {PrintGround::paper, PrintGround::cloth, PrintGround::curtain, PrintGround::rug})
                for (const char* color : {"white", "black", "navy", "mustard", "sage"}) {
                    Material m = *material_named("linen");
                    m.color_a = *color_named(color);
                    print_on(m, print, ground, {}, style_named(style).palette);
                    EXPECT_NE(m.pattern, Pattern::fabric) << print;
                    const Vec3f d = m.color_b - m.color_a;
                    EXPECT_GT(std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)}),
                              far * (luminance(m.color_a) < 0.1f ? 0.5f : 1.f))
                        << print << " on " << color << ", " << style;
                }
}

TEST(Prints, WallsFloorsAndClothShowTheirs) {
    const auto main_of = [](const Furnished& f, const char* kind) {
        for (const Placed& p : f.room.placed)
            if (p.piece.kind == kind) return p.piece.materials[static_cast<std::size_t>(p.piece.main_material)].pattern;
        return Pattern::plain;
    };
    const Furnished kids = furnished("a child's bedroom with polka dot curtains and a chevron rug");
    EXPECT_EQ(main_of(kids, "curtain"), Pattern::dots);
    EXPECT_EQ(main_of(kids, "rug"), Pattern::zigzag);
    EXPECT_TRUE(is_told(kids.spec, "chevron", "understood: pattern zigzag"));
    const Furnished den = furnished("a living room with geometric wallpaper and a herringbone wood floor");
    EXPECT_EQ(den.room.plan.style.wall.pattern, Pattern::geometric);
    EXPECT_EQ(den.room.plan.style.floor.pattern, Pattern::herringbone);
    EXPECT_TRUE(is_told(den.spec, "geometric", "understood: pattern geometric of wall"));
    const Furnished bath = furnished("a bathroom with green herringbone tiles on the walls and a patterned floor");
    EXPECT_EQ(bath.room.plan.style.wall.pattern, Pattern::laid_tiles);
    EXPECT_EQ(bath.room.plan.style.floor.pattern, Pattern::encaustic);
    // Two colors that were said are both there.
    const Furnished sofa = furnished("a living room with a red and white gingham armchair");
    for (const Placed& p : sofa.room.placed)
        if (p.wish.kind == "armchair") {
            const Material& m = p.piece.materials[static_cast<std::size_t>(p.piece.main_material)];
            EXPECT_EQ(m.pattern, Pattern::gingham);
            EXPECT_GT(luminance(m.color_b), 0.5f);
            EXPECT_GT(m.color_a.x, 3.f * m.color_a.z);
        }
    // Paper of which nothing is said has what its style likes, and that is told.
    const Furnished paper = furnished("a classic dining room with wallpaper");
    EXPECT_EQ(paper.room.plan.style.wall.pattern, Pattern::damask);
}

TEST(Openings, ArchesAndPortholesAreBuiltAsAsked) {
    const auto shapes_of = [](const Furnished& f, Opening::Kind kind) {
        std::vector<Opening::Shape> out;
        for (const Opening& o : f.room.plan.openings)
            if (o.kind == kind) out.push_back(o.shape);
        return out;
    };
    const auto all_are = [](const std::vector<Opening::Shape>& shapes, Opening::Shape shape) {
        return !shapes.empty() &&
               std::all_of(shapes.begin(), shapes.end(), [&](Opening::Shape s) { return s == shape; });
    };
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
        EXPECT_TRUE(all_are(shapes_of(furnished("a bedroom with two arched windows", seed), Opening::Kind::window),
                            Opening::Shape::arched));
        EXPECT_TRUE(all_are(shapes_of(furnished("a study with a round window", seed), Opening::Kind::window),
                            Opening::Shape::round));
        EXPECT_TRUE(all_are(shapes_of(furnished("a living room with an arched wooden door", seed), Opening::Kind::door),
                            Opening::Shape::arched));
        EXPECT_TRUE(all_are(shapes_of(furnished("a living room with an arched doorway", seed), Opening::Kind::doorway),
                            Opening::Shape::arched));
        EXPECT_TRUE(all_are(shapes_of(furnished("a living room with a window and a door", seed), Opening::Kind::window),
                            Opening::Shape::square));
        const Furnished ship = furnished("a cabin with three portholes", seed);
        for (const Opening& o : ship.room.plan.openings)
            if (o.kind == Opening::Kind::window) {
                EXPECT_EQ(o.shape, Opening::Shape::round);
                EXPECT_NEAR(o.u1 - o.u0, o.y1 - o.y0, 1e-4f);
                EXPECT_LT(o.u1 - o.u0, 0.8f);
            }
        for (const Placed& p : ship.room.placed) EXPECT_TRUE(p.sill < 0 && p.piece.kind != "curtain");
    }
    // What is built about them is solid and faces outward.
    for (const char* text : {"a classic bedroom with two arched windows and an arched door",
                             "a study with a round window and a round door", "a living room with an arched doorway"}) {
        const Furnished f = furnished(text);
        Room room;
        build_shell(f.room.plan, room);
        std::size_t bent = 0;
        for (const Mesh& m : room.meshes) {
            EXPECT_GT(shapes::signed_volume(m), 0.f) << text;
            // No triangle is a line: its normal would be none, and the room dark.
            for (std::size_t t = 0; t < m.triangles.size(); t += 3) {
                const Vec3f a = m.positions[m.triangles[t]], b = m.positions[m.triangles[t + 1]],
                            c = m.positions[m.triangles[t + 2]];
                ASSERT_GT(length(cross(b - a, c - a)), 1e-9f) << text;
            }
            bent += m.triangles.size() > 100;
        }
        EXPECT_GT(bent, 1u) << text;
    }
}

// What state a room is in shows in what stands there, and is told.
TEST(States, AbandonedMessyRenovatedAndSparseRoomsDiffer) {
    const auto count = [](const Furnished& f, std::string_view kind) {
        return std::count_if(f.room.placed.begin(), f.room.placed.end(),
                             [&](const Placed& p) { return p.piece.kind == kind; });
    };
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        const Furnished usual = furnished("a modern living room", seed),
                        left = furnished("an abandoned modern living room", seed),
                        site = furnished("a modern living room under renovation", seed),
                        few = furnished("a minimalist living room", seed);
        EXPECT_LT(left.room.placed.size(), usual.room.placed.size());
        EXPECT_LT(static_cast<double>(few.room.placed.size()), 0.8 * static_cast<double>(usual.room.placed.size()));
        for (const char* kind : {"curtain", "plant", "picture", "cushion_set"}) EXPECT_EQ(count(left, kind), 0) << kind;
        for (const char* kind : {"cobweb", "rubble", "paper_litter"}) EXPECT_GT(count(left, kind), 0) << kind;
        EXPECT_EQ(left.room.plan.style.wall.pattern, Pattern::peeling);
        EXPECT_TRUE(is_told(left.spec, "abandoned", "understood: state"));
        EXPECT_EQ(left.spec.style, "modern");
        EXPECT_EQ(furnished("an abandoned living room", seed).spec.style, "classic");  // nobody left it last year
        for (const char* kind : {"step_ladder", "drop_cloth", "paint_buckets"}) EXPECT_GT(count(site, kind), 0) << kind;
        EXPECT_EQ(count(site, "sofa"), 0);
        EXPECT_TRUE(is_told(site.spec, "under renovation", "understood: state"));
        EXPECT_TRUE(is_told(few.spec, "minimalist", "understood: style: modern, with few things"));
        const Furnished messy = furnished("a messy bedroom", seed);
        EXPECT_GT(count(messy, "clothes_heap"), 0);
        EXPECT_EQ(count(furnished("a bedroom with a messy desk", seed), "clothes_heap"), 0);
    }
    const Furnished dropped = furnished("a bedroom with clothes on the floor and a pizza box on the desk");
    EXPECT_EQ(count(dropped, "clothes_heap"), 1);
    for (const Placed& p : dropped.room.placed) EXPECT_TRUE(p.piece.kind != "clothes_heap" || p.position.y < 0.05f);
}

TEST(Bunks, ThreeHighAndWithStairs) {
    const auto bunk = [](const std::string& text) {
        const Furnished f = furnished(text);
        for (const Placed& p : f.room.placed)
            if (p.piece.kind == "bunk_bed") return p.piece.size_m;
        return Vec3f{};
    };
    const Vec3f two = bunk("a kids room with a bunk bed"), three = bunk("a kids room with a triple bunk bed"),
                stairs = bunk("a kids room with a bunk bed with storage stairs");
    EXPECT_GT(three.y, two.y + 0.35f);
    EXPECT_GT(stairs.x, two.x + 0.35f);  // stairs stand at the feet
    EXPECT_LT(stairs.z, two.z);          // no ladder leans in front
    EXPECT_TRUE(is_told(read("a bunk bed with stairs"), "stairs", "understood") ||
                is_told(read("a bunk bed with stairs"), "stairs", "approximated"));
    EXPECT_FALSE(object_of(read("a kids room with a bunk bed and a ladder"), "ladder"));
}

}  // namespace
}  // namespace fastscene

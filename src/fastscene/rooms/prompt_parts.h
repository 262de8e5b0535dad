// The workbench of the prompt reader: what the prompt_*.cc files hand to each other.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/room_type.h"
#include "fastscene/rooms/rooms.h"

namespace fastscene::reading {

// Whether two room types name one room: a kids' room is a kind of bedroom ("a child's pirate bedroom").
inline bool is_same_room(std::string_view first, std::string_view other) {
    return first == other || (find_room_type(first) && room_type(first).kind_of == other);
}

// A matched piece of the prompt.
struct Match {
    std::string words;
    std::optional<Word> word{};  // nothing: not understood
    bool comma = false;          // a mark between phrases
    std::string note{};          // "read as …": a typo
    bool plural =
        false;        // more than one, though its own look-up does not say so: a typo, a word that stands for another
    int object = -1;  // nouns: index into PromptSpec::objects
    int noun = -1;    // adjectives: index of the match they were bound to
    bool negated = false;
    // The report.
    bool listed = false;  // function words that carried nothing are not
    PromptWord::Fate fate = PromptWord::Fate::understood;
    std::string meaning{};
    int about = -1;  // the object it speaks of
    bool relation = false;
    int target = -1;              // relations: the match that names the place
    bool measure = false;         // a size in metres
    bool settled = false;         // told already, and of no more use to what comes after
    std::vector<float> metres{};  // measures: one length, or width by depth (by height); an area in square metres
    bool area = false;

    bool is(WordKind kind) const { return word && word->kind == kind; }
    bool is_function(std::string_view w) const { return is(WordKind::function) && words == w; }
};
using Matches = std::vector<Match>;

// The prompt while it is read.
struct Reading {
    PromptSpec& spec;
    Matches m;
    Language language;

    PromptObject& object_of(std::size_t noun) { return spec.objects[static_cast<std::size_t>(m[noun].object)]; }
    PromptObject& add_object(std::string kind, std::string words) {
        PromptObject object;
        object.kind = std::move(kind);
        object.words = std::move(words);
        object.id = static_cast<int>(spec.objects.size());
        return spec.objects.emplace_back(std::move(object));
    }
    void tell(std::size_t i, std::string meaning, int about = -1) {
        list(i, PromptWord::Fate::understood, std::move(meaning), about);
    }
    void tell_near(std::size_t i, std::string meaning, int about = -1) {
        list(i, PromptWord::Fate::approximated, std::move(meaning), about);
    }

  private:
    void list(std::size_t i, PromptWord::Fate fate, std::string meaning, int about) {
        m[i].listed = true;
        m[i].fate = fate;
        m[i].meaning = std::move(meaning);
        m[i].about = about;
    }
};

inline bool is_adjective(const Match& m) {
    return m.is(WordKind::color) || m.is(WordKind::material) || m.is(WordKind::size) || m.is(WordKind::pattern);
}
inline bool is_noun(const Match& m) {
    return m.is(WordKind::object) || m.is(WordKind::structure) || m.is(WordKind::detail);
}
inline bool has_object(const Match& m) { return m.object >= 0; }

// "fr es it": adjectives stand behind their noun.
inline bool adjectives_follow(Language language) { return language == "fr" || language == "es" || language == "it"; }

// A sentence's language by its little words.
struct Tongue {
    Language language;        // that it is read in; English when in doubt
    std::string_view unread;  // "Dutch": a language that is not read; empty: it is
};
Tongue tongue_of(const std::vector<std::string>& tokens);
// Whether it is an article or the like of a language that is not read.
bool is_little_word_unread(const std::string& token, std::string_view unread);

// "4x5m" -> "4", "x", "5", "m": numbers apart from the letters behind them.
std::vector<std::string> with_numbers_apart(const std::vector<std::string>& tokens);
// "4 by 5 metre", "1.80 m", "20 square metres" at this token, with how many tokens it takes; nothing: no measure.
std::optional<std::pair<Match, std::size_t>> measure_at(const std::vector<std::string>& tokens, std::size_t begin,
                                                        Language language);

// Longest match first; then the furniture catalogue; then what was misspelt.
Matches match(const std::vector<std::string>& tokens, const Tongue& tongue, const FurniturePack* pack);

// Marks the words that are negated; called by settle_double_meanings.
void mark_negated(Matches& m);
// Which rooms the prompt speaks of, before its nouns; called by settle_double_meanings.
void settle_rooms(Reading& r);
// Pieces named behind the second room that belong there: "an en-suite bathroom with a freestanding tub".
void fill_next_room(Reading& r);
inline constexpr const char* kInNextRoom = "in the next room";

// Binds the adjective at `at` to its noun.
void bind_adjective(Reading& r, std::size_t at, std::size_t noun);
// Cloth takes color for its piece: "bedding in white"; both of bind_adjectives.
void pass_on_cloth(Reading& r);

// In this order:
void settle_quantities(Matches& m);       // "fewer than five", "two or three", "for eight": one count each
void settle_double_meanings(Reading& r);  // "the table" of a dining room; "fern" the color; "a light"; "an attic study"
void find_nouns(Reading& r);              // objects, negation, "the desk" again
void bind_measures(Reading& r);           // "a two metre wide bed", "3 m high ceiling"
void bind_adjectives(Reading& r);         // color, material, pattern, size, count of each noun
void seat_people(Reading& r);             // "a table for eight": its chairs
void read_scopes(Reading& r);             // "only a bed", "everything is pink"
void read_themes(Reading& r);             // "a pirate bedroom", "dinosaurs": what the room shows of them
void read_globals(Reading& r);            // room, style, time … and adjectives that no noun took
void read_state(Reading& r);              // "abandoned", "messy", "under renovation": what lies about
void relate(Reading& r);                  // "under the window"

// "style=art deco;without=tv": what a word adds under this name; "": nothing.
inline std::string added_by(const Word& word, std::string_view name) {
    std::string_view left = word.adds;
    while (!left.empty()) {
        const std::string_view part = left.substr(0, left.find(';'));
        if (part.size() > name.size() && part.starts_with(name) && part[name.size()] == '=')
            return std::string(part.substr(name.size() + 1));
        left.remove_prefix(std::min(left.size(), part.size() + 1));
    }
    return {};
}

// Words for the state a room was left in: they bring what lies about there (prompt_themes.cc).
inline bool is_state(std::string_view clutter) {
    return clutter == "abandoned" || clutter == "messy" || clutter == "renovation" || clutter == "moving";
}

// Whether an adjective or its like may stand between an article and its noun.
bool modifies(const Match& m);

}  // namespace fastscene::reading

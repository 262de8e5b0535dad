// The workbench of the prompt reader: what the prompt_*.cc files hand to each other.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/rooms.h"

namespace fastscene::reading {

// A matched piece of the prompt.
struct Match {
    std::string words;
    std::optional<Word> word{};  // nothing: not understood
    bool comma = false;        // a mark between phrases
    std::string note{};        // "read as …": a typo
    int object = -1;           // nouns: index into PromptSpec::objects
    int noun = -1;             // adjectives: index of the match they were bound to
    bool negated = false;
    // The report.
    bool listed = false;       // function words that carried nothing are not
    PromptWord::Fate fate = PromptWord::Fate::understood;
    std::string meaning{};
    int about = -1;            // the object it speaks of
    bool relation = false;
    int target = -1;           // relations: the match that names the place

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
    void tell(std::size_t i, std::string meaning, int about = -1) { list(i, PromptWord::Fate::understood, std::move(meaning), about); }
    void tell_near(std::size_t i, std::string meaning, int about = -1) { list(i, PromptWord::Fate::approximated, std::move(meaning), about); }

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
inline bool is_noun(const Match& m) { return m.is(WordKind::object) || m.is(WordKind::structure) || m.is(WordKind::detail); }
inline bool has_object(const Match& m) { return m.object >= 0; }

// "fr es it": adjectives stand behind their noun.
inline bool adjectives_follow(Language language) { return language == "fr" || language == "es" || language == "it"; }

// The language of most of its words; English when in doubt.
Language language_of(const std::vector<std::string>& tokens);
// Longest match first; then the furniture catalogue; then a typo of one letter.
Matches match(const std::vector<std::string>& tokens, Language language, const FurniturePack* pack);

// In this order:
void settle_double_meanings(Reading& r);  // "the table" of a dining room; "fern" the color; "a light"
void find_nouns(Reading& r);              // objects, negation, "the desk" again
void bind_adjectives(Reading& r);         // color, material, pattern, size, count of each noun
void read_globals(Reading& r);            // room, style, time … and adjectives that no noun took
void relate(Reading& r);                  // "under the window"

}  // namespace fastscene::reading

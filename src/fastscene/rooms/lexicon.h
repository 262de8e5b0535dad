// Lexicon: the words a prompt may use, and what they mean to the room maker.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fastscene {

enum class WordKind : unsigned char {
    room, style, object, structure, color, material, pattern, time, weather, light, size, mood, count, negation, relation, stop,
};

struct Word {
    WordKind kind;
    std::string meaning;   // canonical: "armchair", "living", "evening", "3" …
    bool exact = true;     // false: the nearest thing we have ("chesterfield" is a sofa)
};

// Looks up a term of one to four lower-case words ("coffee table"); singular and plural. Colors include all that
// style.h's color_named knows.
std::optional<Word> look_up(const std::string& term);

// A known single word of at least five letters at Damerau-Levenshtein distance 1, if there is exactly one meaning.
std::optional<std::string> nearest_term(const std::string& word);

// "living" -> "living room": what people call a canonical room.
std::string room_title(std::string_view room);
std::vector<std::string> room_types();
std::size_t lexicon_size();
// Every term, sorted; without the color names.
std::vector<std::string> lexicon_terms();

}  // namespace fastscene

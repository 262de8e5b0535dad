// Lexicon: the words a prompt may use, and what they mean to the room maker. The words are in lexicon.tsv.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fastscene {

enum class WordKind : unsigned char {
    room,
    style,
    object,
    structure,
    color,
    material,
    pattern,
    time,
    weather,
    light,
    size,
    mood,
    count,
    negation,
    relation,
    detail,    // a part of a piece ("legs", "bedding"): takes adjectives, is no piece of its own
    nuance,    // understood, but nothing in the room shows it ("dusty"), or only its windows do ("ocean view")
    filler,    // speaks of the picture or the room as such ("photo", "interior")
    function,  // articles, prepositions, forms of "to be"
    scope,     // "only": nothing else; "everything": what is said of it is said of all
    bound,     // "at most", "fewer than": what stands before a count; the meaning is what it adds to the count
    unit,      // of lengths and areas; the meaning is in metres
    other,     // a word that is no typo of another, of nothing that rooms have
};

struct Word {
    WordKind kind;
    std::string meaning;      // canonical: "armchair", "living", "evening", "3" …
    bool exact = true;        // false: the nearest thing we have ("chesterfield" is a sofa)
    std::string adds{};       // what else it says: "material=leather"
    bool far = false;         // … and quite another thing: a piano for a keyboard
    bool also_color = false;  // "fern", "midnight": a color when it stands before another word's noun
};

// "" = English; de fr es it.
using Language = std::string_view;

// Looks up a term of lower-case words without accents ("coffee table"); singular and plural, inflected in `language`.
// Words of that language come before English ones. Colors include all that style.h's color_named knows.
std::optional<Word> look_up(const std::string& term, Language language = {});
// Whether the language has this very word as one of its function words.
bool is_function_word(const std::string& term, Language language);
inline constexpr std::size_t kLongestTerm = 6;  // words

// A known single word at Damerau-Levenshtein distance 1 (of eight letters or more: 2), if there is exactly one meaning.
// A word with the same first letter comes before others, what can be shown before what cannot. Of four letters, two may
// have changed places.
std::optional<std::string> nearest_term(const std::string& word, Language language = {});
// A term of as many words, those that are not `known` misspelt so: "cofee table", "night stnad".
std::optional<std::string> nearest_phrase(const std::vector<std::string>& words, const std::vector<bool>& known,
                                          Language language = {});
// The term with the same letters and other spaces: "bed side lamp", "livingroom"; singular or plural.
std::optional<std::string> respelled(const std::string& words, Language language = {});

// sRGB 0xrrggbb of a color by its plain name, without composition ("dark …" is style.h's).
std::optional<std::uint32_t> lexicon_color(std::string_view name);

// Forms under which a term may stand in the lexicon: English plurals, German endings, Romance plurals.
std::vector<std::string> base_forms(const std::string& term, Language language = {});

// "living" -> "living room": what people call a canonical room.
std::string room_title(std::string_view room);
std::vector<std::string> room_types();
std::size_t lexicon_size();
// Every English term, sorted.
std::vector<std::string> lexicon_terms();

}  // namespace fastscene

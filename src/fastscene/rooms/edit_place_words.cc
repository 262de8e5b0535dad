// The words of places: where they begin, "next to", "the far left corner".
#include <algorithm>
#include <array>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/lexicon.h"

namespace fastscene::editing {
namespace {

// Beginnings of places that the lexicon does not have, or that an edit means in its own way. "to", "at" and "in" mean
// what suits the thing and the place.
constexpr std::array<std::pair<std::string_view, std::string_view>, 40> kRelations{{
    {"to", "to"},
    {"into", "to"},
    {"over to", "to"},
    {"back to", "to"},
    {"for", "at"},
    {"at", "at"},
    {"up to", "at"},
    {"in", "in"},
    {"inside", "in"},
    {"inside of", "in"},
    {"onto", "on"},
    {"on to", "on"},
    {"up on", "on"},
    {"over onto", "on"},
    {"against", "against"},
    {"towards", "next to"},
    {"toward", "next to"},
    {"closer to", "next to"},
    {"nearer to", "next to"},
    {"over by", "next to"},
    {"in front", "in front of"},
    {"round", "around"},
    {"from", "from"},
    {"along", "along"},
    {"to the foot of", "at the foot of"},
    {"to the side of", "next to"},
    {"by the side of", "next to"},
    {"either side of", "on both sides of"},
    {"on either side of", "on both sides of"},
    {"to either side of", "on both sides of"},
    {"to both sides of", "on both sides of"},
    {"to each side of", "on both sides of"},
    {"at either side of", "on both sides of"},
    {"both sides of", "on both sides of"},
    {"each side of", "on both sides of"},
    {"in between", "between"},
    {"on top of", "on"},
    {"parallel to", "next to"},
    {"in line with", "next to"},
    {"across from", "opposite"},
}};

}  // namespace

std::optional<Relation> relation_at(const Words& words, std::size_t at) {
    for (std::size_t length = std::min<std::size_t>(kLongestTerm, words.size() - at); length > 0; --length) {
        const std::string term = text_of(words, at, at + length);
        for (const auto& [phrase, name] : kRelations)
            if (term == phrase) return Relation{std::string(name), at + length};
        const auto word = look_up(term);
        if (!word || word->kind != WordKind::relation) continue;
        // "on the left nightstand", "in the right drawer": the side is the thing's.
        const bool side = is_one_of(words[at + length - 1], {"left", "right"}) && length > 1;
        if (side && at + length < words.size()) continue;
        return Relation{word->meaning == "both sides" ? "on both sides of" : word->meaning, at + length};
    }
    return {};
}

std::string noun_of(const std::string& word) {
    if (is_one_of(word, {"corner", "corners"})) return "corner";
    if (is_one_of(word, {"middle", "center", "centre"})) return "middle";
    if (is_one_of(word, {"side", "end", "sides", "ends"})) return "side";
    if (is_one_of(word, {"floor", "ground"})) return "floor";
    if (is_one_of(word, {"room", "bedroom", "kitchen", "office", "bathroom", "hallway", "corridor"})) return "room";
    if (word == "carpet") return {};
    if (word == "entrance") return "door";
    const auto known = look_up(word);
    if (!known || known->kind != WordKind::structure) return {};
    return is_one_of(known->meaning, {"wall", "ceiling", "window", "door", "doorway", "floor"}) ? known->meaning : "";
}

std::optional<Part> room_part(const Words& words, std::size_t at) {
    Part out;
    for (std::size_t i = at; i < words.size(); ++i) {
        const std::string& w = words[i];
        const bool wall_of = is_one_of(w, {"window", "door"}) && i + 1 < words.size() &&
                             is_one_of(words[i + 1], {"wall", "corner"});
        if (const std::string noun = wall_of ? "" : noun_of(w); !noun.empty()) {
            out.noun = noun, out.next = i + 1;
            if (w == "corners") out.modifiers.push_back("each");
            if (is_one_of(w, {"end", "ends"})) out.modifiers.push_back("end");
            if (is_one_of(w, {"sides", "ends"})) out.modifiers.push_back("sides");
            if (w.ends_with("sill")) out.modifiers.push_back("sill");
            return out;
        }
        if (!wall_of && !is_definite(w) &&
            !is_one_of(w, {"a",     "an",    "each",      "every", "all",    "four",     "other", "another", "left",
                           "right", "far",   "near",      "back",  "front",  "opposite", "one",   "any",     "two",
                           "free",  "empty", "different", "same",  "side",   "bare",     "big",   "large",   "hand",
                           "of",    "bay",   "some",      "both",  "either", "opposite"}) &&
            !(i + 1 < words.size() && words[i + 1] == "wall" && looks_of(w)))
            return {};
        out.modifiers.push_back(w);
    }
    return {};
}

std::size_t next_place(const Words& words, std::size_t from) {
    static constexpr std::array<std::string_view, 50> kPlaces{
        "to",      "into",      "onto",      "on",        "in",         "next",      "beside",  "near",    "under",
        "below",   "beneath",   "above",     "over",      "behind",     "by",        "between", "against", "opposite",
        "facing",  "around",    "along",     "at",        "before",     "left",      "right",   "towards", "toward",
        "across",  "close",     "closer",    "nearer",    "underneath", "alongside", "inside",  "off",     "away",
        "further", "farther",   "back",      "backwards", "forward",    "forwards",  "up",      "down",    "higher",
        "lower",   "somewhere", "elsewhere", "from",      "parallel"};
    for (std::size_t i = std::max<std::size_t>(1, from); i < words.size(); ++i) {
        // "the left nightstand", "the right one", "the back wall"
        const bool named = is_one_of(words[i], {"left", "right", "back"}) && is_definite(words[i - 1]) &&
                           i + 1 < words.size() && words[i + 1] != "of";
        if (!named && std::find(kPlaces.begin(), kPlaces.end(), words[i]) != kPlaces.end()) return i;
        if (words[i] == "together" || words[i] == "apart" ||
            (words[i] == "out" && (i + 1 == words.size() || is_one_of(words[i + 1], {"a", "slightly"}))))
            return i;
        // "a bit to the left", "50 cm to the left"
        if (i + 2 < words.size() && is_one_of(words[i], {"either", "both", "each"}) &&
            is_one_of(words[i + 1], {"side", "sides", "end", "ends"}) && words[i + 2] == "of")
            return i;
        const bool much = is_one_of(words[i], {"slightly", "upwards", "downwards"}) ||
                          (i + 2 < words.size() && words[i] == "a" && is_one_of(words[i + 1], {"bit", "little"}));
        const bool measure = i + 1 < words.size() && number_said(words[i]) &&
                             is_one_of(words[i + 1], {"cm", "m", "meter", "meters", "metre", "metres", "centimeters",
                                                      "centimetres", "feet", "foot", "inches", "half", "a"});
        if (much || measure) return i;
    }
    return words.size();
}

std::pair<Words, Words> place_and_view(const Words& part) {
    const std::size_t so = find_word(part, {"so"}, 2);
    const std::size_t sees = find_word(part, {"faces", "face", "looks", "look", "sees", "see", "facing"}, so);
    if (sees >= part.size() || next_place(part) >= so) return {};
    Words target = part_of(part, sees + 1);
    while (!target.empty() && is_one_of(target.front(), {"at", "to", "towards", "toward", "into", "through"}))
        target.erase(target.begin());
    if (target.empty() || is_one_of(target.front(), {"out", "outside"})) target = {"the", "window"};
    return {part_of(part, 0, so), target};
}

}  // namespace fastscene::editing

// Which of a clause's words name things, parts of the room, looks and places, and which no word of ours is.
#include <algorithm>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/edit_audit.h"
#include "fastscene/rooms/lexicon.h"

namespace fastscene::editing {
namespace {

bool is_relation_seen(const std::string& name) {
    return is_one_of(name, {"next to",
                            "on",
                            "under",
                            "above",
                            "in front of",
                            "behind",
                            "between",
                            "opposite",
                            "facing",
                            "around",
                            "left of",
                            "right of",
                            "in the corner",
                            "in the middle",
                            "on both sides of",
                            "at the foot of",
                            "against",
                            "to",
                            "at",
                            "in",
                            "along",
                            "from",
                            "far wall"});
}

// What edits say that no room is made of: "bigger", "swap", "every other one".
bool is_of_edits(const Words& words, std::size_t at) {
    const std::string& w = words[at];
    if (is_one_of(
            w,
            {"percent",   "second",     "third",    "fourth",    "fifth",     "sixth",     "last",        "next",
             "closest",   "nearest",    "farthest", "furthest",  "far",       "alternate", "alternately", "alternating",
             "circle",    "semicircle", "row",      "rows",      "whatever",  "whichever", "everything",  "anything",
             "something", "other",      "others",   "rest",      "remaining", "left",      "right",       "same",
             "match",     "matching",   "further",  "farther",   "apart",     "together",  "evenly",      "instead",
             "so",        "than",       "except",   "only",      "just",      "again",     "around",      "out",
             "up",        "down",       "off",      "away",      "place",     "places",    "spot",        "direction",
             "way",       "side",       "sides",    "facing",    "size",      "half",      "twice",       "able",
             "smallest",  "largest",    "biggest",  "tallest",   "sit",       "fit",       "seating",     "people",
             "guests",    "double",     "times",    "clockwise", "degrees",   "meter",     "meters",      "cm",
             "space",     "gap",        "gaps",     "want",      "who",       "whose"}))
        return true;
    if (beginning_at(words, at) || number_said(w) || !comparative_of(w).empty() || is_joint(w) || is_definite(w))
        return true;
    if (value_of({w}) || !stem_of_gerund(w).empty()) return true;
    return w.find_first_of("0123456789") != std::string::npos;
}

}  // namespace

std::vector<Mention> mentions_in(const Words& words) {
    std::vector<Mention> out;
    for (std::size_t i = 0; i < words.size();) {
        Mention best{Mention::Kind::unknown, i, i + 1, words[i], ""};
        bool known = false;
        if (is_one_of(words[i], {"it", "them", "they", "one", "ones", "each"}))
            best.kind = Mention::Kind::pronoun, known = true;
        auto relation = known ? std::nullopt : relation_at(words, i);
        // "A round table", "to face the door"
        const std::string next = relation && relation->next < words.size() ? words[relation->next] : "";
        if (words[i] == "round" && !is_definite(next)) relation.reset();
        if (words[i] == "to" && next == "face") relation->name = "facing", ++relation->next;
        if (is_one_of(words[i], {"face", "faces"}) && i > 0) relation = Relation{"facing", i + 1};
        if (is_one_of(words[i], {"nearest", "closest", "farthest", "furthest"}))
            relation = Relation{"from",
                                i + (is_one_of(i + 1 < words.size() ? words[i + 1] : "", {"to", "from"}) ? 2 : 1)};
        const std::size_t longest = known ? 0 : std::min<std::size_t>(kLongestTerm, words.size() - i);
        for (std::size_t length = longest; length > 0; --length) {
            const std::string term = text_of(words, i, i + length);
            if (relation && relation->next == i + length) {
                known = true;
                best = {Mention::Kind::relation, i, i + length, term, relation->name};
                break;
            }
            const auto word = look_up(term);
            if (!word) continue;
            known = true;
            best = {Mention::Kind::unknown, i, i + length, term, word->meaning};
            if (word->kind == WordKind::object) best.kind = Mention::Kind::thing;
            else if (word->kind == WordKind::structure) best.kind = Mention::Kind::part;
            else if (word->kind == WordKind::color || word->kind == WordKind::material ||
                     word->kind == WordKind::pattern)
                best.kind = Mention::Kind::look;
            else best.term.clear();  // known, and of nothing that is seen
            break;
        }
        if (!known && !noun_of(words[i]).empty())
            best.kind = Mention::Kind::part, best.meaning = noun_of(words[i]), known = true;
        // "The sofa's color"
        if (!known && words[i].ends_with("'s")) {
            if (const auto word = look_up(words[i].substr(0, words[i].size() - 2));
                word && word->kind == WordKind::object)
                best.kind = Mention::Kind::thing, best.meaning = word->meaning;
            best.term.resize(best.term.size() - 2), known = true;
        }
        i = best.to;
        if (best.kind == Mention::Kind::relation && !is_relation_seen(best.meaning)) continue;
        if (best.kind == Mention::Kind::unknown && best.term.empty()) continue;
        if (best.kind != Mention::Kind::unknown || (!known && !is_of_edits(words, best.from))) out.push_back(best);
    }
    return out;
}

bool is_called(const DocumentThing& thing, const Mention& mention) {
    if (mention.kind != Mention::Kind::thing) return false;
    const std::string noun = singular(mention.term.substr(mention.term.rfind(' ') + 1));
    const auto is = [&](const std::string& kind) {
        return kind == mention.meaning || kind.find(noun) != std::string::npos ||
               mention.meaning.find(kind) != std::string::npos || kind.find(mention.meaning) != std::string::npos;
    };
    if (is(thing.kind)) return true;
    return thing.asked && (is(thing.asked->kind) || thing.asked->words.find(noun) != std::string::npos);
}

}  // namespace fastscene::editing

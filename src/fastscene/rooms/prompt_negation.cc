// Which words of a prompt are negated: "without curtains, rugs or plants", "not brown but green".
#include <algorithm>
#include <array>

#include "fastscene/rooms/prompt_parts.h"

namespace fastscene::reading {
namespace {

// Commas do not end "without curtains, rugs or plants".
bool negation_goes_on(const Matches& m, std::size_t comma) {
    for (std::size_t k = comma + 1; k < m.size() && k < comma + 12; ++k) {
        if (m[k].is_function("or") || m[k].is_function("nor")) return true;
        if (m[k].is(WordKind::function) || m[k].is(WordKind::negation) || m[k].is(WordKind::relation) ||
            m[k].is(WordKind::count))
            return false;
    }
    return false;
}

// Words that take back what was said of all or of none: "no windows except one skylight", "all white except a red
// chair".
bool excepts(const Match& m) {
    static constexpr std::array<std::string_view, 9> kExcept{"except",     "except for", "excluding",
                                                             "apart from", "other than", "save for",
                                                             "aside from", "besides",    "but for"};
    return m.is(WordKind::negation) && std::find(kExcept.begin(), kExcept.end(), m.words) != kExcept.end();
}
bool is_described(const Match& m) {
    return is_adjective(m) || m.is(WordKind::style) || m.is(WordKind::mood) || m.is(WordKind::light) ||
           m.is(WordKind::nuance);
}
// "not too big", "not brown but green", "neither modern nor classic": of adjectives alone, up to the noun.
bool negates_adjectives(const Matches& m, std::size_t at) {
    static constexpr std::array<std::string_view, 8> kNot{"nothing", "not",     "isnt",  "arent",
                                                          "never",   "neither", "wasnt", "werent"};
    if (std::find(kNot.begin(), kNot.end(), m[at].words) == kNot.end()) return false;
    std::size_t k = at + 1;
    while (k < m.size() && m[k].is(WordKind::function)) ++k;
    return k < m.size() && is_described(m[k]);
}

}  // namespace

void mark_negated(Matches& m) {
    bool negated = false, adjectives = false, all = false;
    for (std::size_t i = 0; i < m.size(); ++i) {
        if (m[i].comma && negated) negated = negation_goes_on(m, i);
        all = all || m[i].is(WordKind::scope) || (m[i].is(WordKind::mood) && m[i].word->meaning == "empty");
        if (m[i].is(WordKind::negation)) {
            if (excepts(m[i]) && (negated || all)) {
                negated = false;
                m[i].word = Word{WordKind::scope, "exception"};
                continue;
            }
            // "nothing fancy" negates; "nothing on the walls" speaks of things.
            if (m[i].words == "nothing" && !negates_adjectives(m, i)) {
                m[i].word = Word{WordKind::nuance, "feel"};
                continue;
            }
            negated = true;
            adjectives = negates_adjectives(m, i);
            continue;
        }
        if (m[i].is_function("with") || m[i].is_function("but") || m[i].is_function("mit") ||
            m[i].is_function("avec") || m[i].is_function("con"))
            negated = false;
        // "no tv and a piano": what has its own article is wanted.
        if (negated && m[i].is_function("and") && i + 1 < m.size() && m[i + 1].is(WordKind::count)) negated = false;
        if (adjectives &&
            (is_noun(m[i]) || m[i].is(WordKind::room) || m[i].is(WordKind::relation) || m[i].is(WordKind::count)))
            negated = adjectives = false;
        m[i].negated = negated;
    }
}

}  // namespace fastscene::reading

// What is said of the whole room: "only a bed", "nothing else", "everything is pink", "all white".
#include <algorithm>
#include <array>

#include "fastscene/rooms/prompt_parts.h"

namespace fastscene::reading {
namespace {

bool means(const Match& m, std::string_view what) { return m.is(WordKind::scope) && m.word->meaning == what; }

// "only a bed", "just one old armchair"; not "just a simple bedroom", "only white walls".
bool names_pieces(const Reading& r, std::size_t at) {
    for (std::size_t k = at + 1; k < r.m.size(); ++k) {
        const Match& m = r.m[k];
        if (m.is(WordKind::object) && has_object(m)) return !m.negated;
        if (!modifies(m) && !m.is(WordKind::mood) && !m.is(WordKind::light) && !m.is_function("a") &&
            !m.is_function("the"))
            return false;
    }
    return false;
}

void read_only(Reading& r, std::size_t at) {
    const bool whole = r.m[at].word->adds == "whole";
    const bool the = at > 0 && r.m[at - 1].is_function("the");  // "the only light comes from …"
    if (!whole && (the || !names_pieces(r, at)))
        return r.tell_near(at, "that there is no other: heeded for pieces of furniture alone");
    // "a table and only two chairs": not more of them.
    const bool number = at + 1 < r.m.size() && r.m[at + 1].is(WordKind::count) && r.m[at + 1].word->meaning != "1";
    const bool later = std::any_of(r.m.begin(), r.m.begin() + static_cast<std::ptrdiff_t>(at),
                                   [](const Match& m) { return m.is(WordKind::object); });
    if (!whole && number && later) return r.tell(at, "not more of them");
    r.spec.clutter = "empty";
    r.tell(at, "nothing but what is named stands in the room");
}

bool is_link(const Match& m) {
    static constexpr std::array<std::string_view, 16> kLinks{
        "is",         "are",     "be",        "in",  "of", "should", "must",        "painted",
        "painted in", "made of", "made from", "has", "to", "was",    "made out of", "should be"};
    return m.is(WordKind::function) && std::find(kLinks.begin(), kLinks.end(), m.words) != kLinks.end();
}
bool colors_all(const Match& m) {
    return (m.is(WordKind::color) || m.is(WordKind::material) || m.is(WordKind::pattern)) && m.noun < 0 && !m.listed &&
           !m.negated;
}

// What "everything" or "all" is said to be: the adjectives behind it ("everything is pink"), unless a noun takes them
// ("all white walls"); else the one before it ("pink everything", "yellow everywhere").
std::vector<std::size_t> said_of_all(const Reading& r, std::size_t at) {
    std::vector<std::size_t> out;
    std::size_t k = at + 1;
    while (k < r.m.size() && (colors_all(r.m[k]) || is_link(r.m[k]) || r.m[k].is(WordKind::nuance) ||
                              (!out.empty() && r.m[k].is_function("and")))) {
        if (colors_all(r.m[k])) out.push_back(k);
        ++k;
    }
    if (out.empty() && at > 0 && colors_all(r.m[at - 1])) out.push_back(at - 1);
    return out;
}

void read_all(Reading& r, std::size_t at) {
    const std::vector<std::size_t> said = said_of_all(r, at);
    if (said.empty()) {
        // "all the walls are white": counts no pieces, says no color of the room.
        const bool pieces = at + 1 < r.m.size() &&
                            (is_noun(r.m[at + 1]) || r.m[at + 1].is_function("the") || modifies(r.m[at + 1]));
        return pieces ? r.tell(at, "every one of what follows")
                      : r.tell_near(at, "said of all, where nothing shows it");
    }
    PromptObject& all = r.spec.everything;
    all.kind = "everything";
    for (const std::size_t i : said) {
        const Match& m = r.m[i];
        std::string& field = m.is(WordKind::color)      ? (all.color.empty() ? all.color : all.color2)
                             : m.is(WordKind::material) ? all.material
                                                        : all.pattern;
        const bool first = field.empty();
        if (first) field = m.word->meaning;
        if (first && m.is(WordKind::color) && &field == &all.color)
            r.tell(i, "color of walls, floor, ceiling, wood and cloth: " + field);
        else if (first && m.is(WordKind::material))
            r.tell_near(i, "of walls, floor and ceiling; pieces stay of what they are made of");
        else r.tell_near(i, "of all there is: only the first color is");
        r.m[i].settled = true;
    }
    r.tell(at, "the whole room");
}

}  // namespace

void read_scopes(Reading& r) {
    for (std::size_t i = 0; i < r.m.size(); ++i) {
        if (means(r.m[i], "only")) read_only(r, i);
        if (means(r.m[i], "all")) read_all(r, i);
        if (means(r.m[i], "exception")) r.tell(i, "what follows is there all the same");
    }
}

}  // namespace fastscene::reading

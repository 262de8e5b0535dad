// What verbs say of themselves: "lower the lamp", "tidy up", "widen the rug", "tile the floor".
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_parts.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/prompt_text.h"

namespace fastscene::editing {

// "lower the lamp": down.
Words lowered(const Clause& clause) {
    Words out = clause.words;
    Words bare = out;
    const bool by_length = take_length(bare).has_value();  // "by 20 cm"
    if (by_length && !bare.empty() && bare.back() == "by") bare.pop_back();
    // "Raise it a bit"
    const std::size_t n = bare.size();
    if (n > 2 && bare[n - 2] == "a" && is_one_of(bare[n - 1], {"bit", "little"})) bare.resize(n - 2);
    if (is_one_of(clause.said, {"lower", "raise", "lift"}) && next_place(bare) == bare.size())
        out.push_back(clause.said == "lower" ? "down" : "up");
    return out;
}

// "Raise the desk by 20 cm": what stands on the floor is taller by that; false: no such words.
bool made_taller(Talk& talk, const Clause& clause) {
    Words bare = clause.words;
    const bool by_length = take_length(bare).has_value();
    if (by_length && !bare.empty() && bare.back() == "by") bare.pop_back();
    const std::size_t n = bare.size();
    if (n > 2 && bare[n - 2] == "a" && is_one_of(bare[n - 1], {"bit", "little"})) bare.resize(n - 2);
    if (!is_one_of(clause.said, {"lower", "raise", "lift"}) || bare.empty() || next_place(bare) < bare.size())
        return false;
    const std::vector<std::string> ids = talk.things_of_parts(bare);
    if (!std::all_of(ids.begin(), ids.end(),
                     [&](const std::string& id) { return talk.editor.placed(id).piece.mount == Mount::floor; }))
        return false;
    bare.push_back(clause.said == "lower" ? "lower" : "taller");
    const Words length = part_of(clause.words, bare.size() - 1);
    return make(talk, joined_words(bare, length)), true;
}

// What lies about on the floor, or of what is named that which does; a sentence does not guess what else is too much.
void tidy(Talk& talk, const Clause& clause) {
    Words bare = clause.words;
    std::erase_if(bare, [](const std::string& w) {
        return is_definite(w) || is_one_of(w, {"up", "a", "bit", "room"});
    });
    if (clause.said == "declutter" && made_vaguely(talk, joined_words({"less", "clutter"}, bare))) return;
    const bool named_some = !bare.empty() && bare != Words{"floor"};
    std::vector<std::string> litter;
    for (const int i : named_some ? all_named(talk.editor, "all " + text_of(bare)) : std::vector<int>{}) {
        const Placed& p = talk.editor.room().furnished.placed[static_cast<std::size_t>(i)];
        if (p.on < 0 && p.sill < 0 && furnishing::is_small(p.piece.kind)) litter.push_back(p.id);
    }
    for (const DocumentThing& t : talk.editor.document().things)
        if (!named_some && lies_about(talk.editor, t.id)) litter.push_back(t.id);
    if (litter.empty())
        throw UsageError(
            "\"{}\" takes away what lies about on the floor{}; \"clear the desk\" takes away what stands "
            "on it, \"remove the books\" what it names",
            clause.said, litter.empty() ? ", where nothing lies about" : "");
    remove_all(talk, litter);
}

// "Enlarge the rug by 20 percent": larger by that.
Words with_word(Words words, const std::string& word) {
    const std::size_t by = find_word(words, {"by"}, 1);
    words.insert(words.begin() + static_cast<std::ptrdiff_t>(by), word);
    return words;
}

// "Tile the walls", "tile the floor blue", "carpet the room": with that.
Words covered(const Clause& clause) {
    Words out = clause.words;
    if (!is_one_of(clause.said, {"tile", "carpet", "plaster"})) return out;
    if (noun_of(out.back()) == "room") out = clause.said == "plaster" ? Words{"the", "walls"} : Words{"the", "floor"};
    for (std::size_t i = 1; i < out.size(); ++i)
        if (const auto value = value_of(part_of(out, i)); value && !value->looks.material.empty()) return out;
    out.push_back(clause.said);
    return out;
}

// "widen the rug": wider.
std::string size_word(const Clause& clause) {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kWays{{{"widen", "wider"},
                                                                                         {"lengthen", "longer"},
                                                                                         {"extend", "longer"},
                                                                                         {"heighten", "taller"},
                                                                                         {"shorten", "shorter"},
                                                                                         {"narrow", "narrower"}}};
    for (const auto& [verb, word] : kWays)
        if (clause.said == verb) return std::string(word);
    return clause.verb == Verb::larger ? "larger" : "smaller";
}

}  // namespace fastscene::editing

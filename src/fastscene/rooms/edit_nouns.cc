// What comes new by the names of what is there: "facing the first one", "next to the others", "a fourth station".
#include <set>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/prompt_text.h"

namespace fastscene::editing {

Words with_noun(const Talk& talk, const Words& words) {
    const std::size_t place = next_place(words);
    if (words.size() > place + 1 && is_one_of(words.back(), {"first", "other", "existing"})) {
        Words all = words;
        all.push_back("one");
        return with_noun(talk, all);
    }
    // "… in line with the other two"
    if (const std::size_t n = words.size();
        place < n && n > 3 && words[n - 2] == "other" && number_said(words[n - 1]) && words[n - 3] == "the") {
        Words all = part_of(words, 0, n - 2);
        all.back() = "the", all.push_back("others");
        return with_noun(talk, all);
    }
    // "A third table next to the others": next to the tables
    if (is_one_of(words.back(), {"others", "rest"}) && place < words.size() && words[words.size() - 2] == "the") {
        const PromptSpec spec = read_in_room(talk.editor, text_of(counted_anew(part_of(words, 0, place))));
        if (spec.objects.empty()) return words;
        Words out = part_of(words, 0, words.size() - 1);
        const Words noun = tokens_of(spec.objects.front().words);
        out.insert(out.end(), noun.begin(), noun.end());
        return out;
    }
    // "Candles to the tables that don't have one": a candle
    const bool had = is_one_of(words.back(), {"one", "any"}) && words.size() > 2 &&
                     is_one_of(words[words.size() - 2], {"have", "has", "without", "no"});
    const std::size_t one = had ? words.size() - 1 : find_word(words, {"one"}, 2);
    if (had) {
        const PromptSpec spec = read_in_room(talk.editor, text_of(counted_anew(part_of(words, 0, place))));
        if (spec.objects.empty()) return words;
        Words out = words;
        out[one] = spec.objects.front().words;
        return out;
    }
    if (one >= words.size() || one < place || !is_one_of(words[one - 1], {"first", "other", "old", "existing"}))
        return words;
    const PromptSpec spec = read_in_room(talk.editor, text_of(counted_anew(part_of(words, 0, place))));
    if (spec.objects.empty()) return words;
    Words out = words;
    out[one] = spec.objects.front().words;
    if (!is_one_of(out[one - 1], {"first"})) out.erase(out.begin() + static_cast<std::ptrdiff_t>(one) - 1);
    return out;
}

// Things that people call so with a word before it: "the cushions", where only floor cushions lie.
std::vector<int> called_in_full(const Editor& editor, const Words& head, PromptObject& said) {
    static const std::vector<std::string> terms = lexicon_terms();
    std::vector<int> out;
    if (head.empty()) return out;
    const std::string ending = " " + singular(head.back());
    const auto& things = editor.document().things;
    const auto is_called = [&](const std::string& kind) {
        return std::any_of(terms.begin(), terms.end(), [&](const std::string& term) {
            const auto word = term.ends_with(ending) ? look_up(term) : std::nullopt;
            return word && word->kind == WordKind::object && word->exact && word->meaning == kind;
        });
    };
    std::string kind;
    for (std::size_t i = 0; i < things.size(); ++i) {
        if (!is_called(things[i].kind)) continue;
        if (!kind.empty() && kind != things[i].kind) return {};  // nobody could tell
        kind = things[i].kind;
        out.push_back(static_cast<int>(i));
    }
    if (!out.empty()) said.kind = kind, said.words = head.back();
    return out;
}

Words by_kind_there(const Editor& editor, const Words& said) {
    if (find_word(said, {"more", "another", "second", "third", "fourth", "fifth", "extra"}) >= next_place(said))
        return said;
    const std::size_t end = next_place(said);
    const std::string& last = said[end - 1];
    const std::string noun = last.ends_with("s") ? last.substr(0, last.size() - 1) : last;
    const auto word = look_up(last);
    if (end < 2 || (word && word->kind == WordKind::object)) return said;
    std::set<std::string> kinds;
    for (const DocumentThing& t : editor.document().things)
        if (t.kind.ends_with("_" + noun)) kinds.insert(t.kind);
    if (kinds.size() != 1) return said;
    Words out{said.front()};
    const Words name = tokens_of(in_words(*kinds.begin()));
    out.insert(out.end(), name.begin(), name.end());
    out.insert(out.end(), said.begin() + static_cast<std::ptrdiff_t>(end), said.end());
    return out;
}

std::string singular(const std::string& word) {
    for (const std::string& form : base_forms(word))
        if (form != word && look_up(form)) return form;
    return word;
}

}  // namespace fastscene::editing

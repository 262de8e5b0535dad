// "Make it red, no wait, make it blue", "add two, no, three chairs": what is said anew takes back what it corrects.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/prompt_text.h"

namespace fastscene::editing {
namespace {

// Said anywhere, and only after a comma or a full stop.
constexpr std::array<std::string_view, 14> kAnywhere{
    "no wait",   "wait no",  "scratch that", "i mean", "i meant",           "or rather", "actually no",
    "make that", "no sorry", "ok no",        "hmm no", "on second thought", "or no",     "no actually"};
constexpr std::array<std::string_view, 10> kAfterMark{"no",       "wait", "sorry", "oh no", "rather",
                                                      "actually", "nope", "nah",   "oops",  "correction"};

bool is_mark(const std::string& word) { return is_one_of(word, {",", ".", ";"}); }

// Where its last part begins: a value, else a place; the number of words: neither.
std::size_t value_at(const Words& words) {
    for (std::size_t i = 1; i < words.size(); ++i)
        if (value_of(part_of(words, i))) return i;
    return words.size();
}

bool is_number(const std::string& word) { return number_said(word) && !is_one_of(word, {"a", "an"}); }

// Thrown to undo what was tried.
class TakenBack : public Error {
  public:
    TakenBack() : Error("taken back") {}
};

}  // namespace

std::size_t correction_at(const Words& words, std::size_t at, bool begins_clause) {
    const bool after_mark = at > 0 && is_mark(words[at - 1]);
    std::size_t count = 0;
    const auto take = [&](std::string_view phrase) {
        const Words all = tokens_of(phrase);
        if (part_of(words, at, at + all.size()) == all) count = std::max(count, all.size());
    };
    for (const std::string_view phrase : kAnywhere) take(phrase);
    if (count == 0 && !after_mark) return 0;
    if (after_mark)
        for (const std::string_view phrase : kAfterMark) take(phrase);
    std::size_t next = at + count;
    if (count == 0 || next >= words.size()) return 0;
    const bool marked = is_mark(words[next]);
    while (next < words.size() && is_mark(words[next])) ++next;
    if (next >= words.size()) return 0;
    // "No plants" takes plants away; "actually, remove it" begins like any other wish.
    if (words[at] == "no" && count == 1 && !marked && !is_definite(words[next]) && !begins_clause) return 0;
    // "Actually, remove the pouf instead", but "actually, also remove the pouf".
    const auto end = std::find_if(words.begin() + static_cast<std::ptrdiff_t>(next), words.end(), is_mark);
    const bool instead = *std::prev(end) == "instead";
    if (is_one_of(words[at], {"actually", "rather"}) && count == 1 && begins_clause && !instead) return 0;
    return next - at;
}

Clause amended(const Clause& before, const Clause& anew) {
    Clause out = before;
    Words rest = anew.words;
    const std::size_t value = value_at(before.words), place = next_place(before.words);
    if (rest.empty()) return before;
    if (value_of(rest) && value < before.words.size()) out.words = joined_words(part_of(before.words, 0, value), rest);
    else if (relation_at(rest, 0) && !is_definite(rest.front()))
        out.words = joined_words(part_of(before.words, 0, place), rest);
    else if (rest.size() == 1 && is_number(rest.front())) {
        const auto number = std::find_if(out.words.begin(), out.words.end(), is_number);
        if (number == out.words.end() && !out.words.empty() && is_one_of(out.words.front(), {"a", "an"}))
            out.words.front() = rest.front();
        else if (number != out.words.end()) *number = rest.front();
    } else {
        // Another thing, in the same place or of the same look.
        const std::size_t end = std::min(value, place);
        if (is_one_of(rest.back(), {"one", "ones"}) && end > 0) rest.back() = before.words[end - 1];
        const bool complete = next_place(rest) < rest.size() || value_at(rest) < rest.size();
        out.words = complete ? rest : joined_words(rest, part_of(before.words, end));
    }
    out.there = anew.there;
    return out;
}

void take_back(Talk& talk, const Clause& clause) {
    const std::vector<std::string> spoken = talk.last;
    try {
        talk.editor.together([&] {
            talk.act(clause);
            throw TakenBack();
        });
    } catch (const Error&) {  // all of it is undone
    }
    // What it named is "it", unless it was to come new.
    const auto& things = talk.editor.document().things;
    std::erase_if(talk.last, [&](const std::string& id) {
        return std::none_of(things.begin(), things.end(), [&](const DocumentThing& t) { return t.id == id; });
    });
    if (talk.last.empty()) talk.last = spoken;
    talk.editor.note("room", fmt::format("\"{} {}\" is taken back", clause.said, text_of(clause.words)));
}

}  // namespace fastscene::editing

// "The chairs white and the table black": which things are to be so, and how.
#include <algorithm>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/prompt_text.h"

namespace fastscene::editing {

bool names_things(const Words& words) {
    if (is_one_of(words.front(), {"a", "an", "two", "three"})) return true;
    for (const std::string& form : base_forms(words.back()))
        if (const auto word = look_up(form); word && word->kind == WordKind::object) return true;
    return false;
}

Words bare_subject(Words words) {
    for (std::size_t i = 0; i + 1 < words.size(); ++i)
        if (is_one_of(words[i], {"color", "material", "size", "look", "fabric", "upholstery", "height", "width"}) &&
            words[i + 1] == "of") {
            words = part_of(words, i + 2);
            break;
        }
    while (words.size() > 2 && is_one_of(words.back(), {"color", "material", "size", "fabric", "upholstery", "look"}))
        words.pop_back();
    for (std::string& w : words)
        if (w.size() > 2 && w.ends_with("'s")) w.resize(w.size() - 2);
    return words;
}

namespace {

// Cuts "the sofa dark green", "the sofa to dark green"; no value: all of it is the subject.
void cut(const Words& part, Words& subject, Words& value, Words& by) {
    subject = part;
    // "The tiles black" are tiles, no look.
    const bool of_those = part.size() > 2 && is_definite(part.front()) && !is_one_of(part.front(), {"it", "them"});
    if (!of_those && value_of(part)) {
        value = part, subject.clear();
        return;
    }
    for (std::size_t i = part.size(); i-- > 1;) {
        if (!is_one_of(part[i], {"to", "into"})) continue;
        const Words rest = part_of(part, i + 1);
        if (value_of(rest)) {
            value = rest, subject = part_of(part, 0, i);
            return;
        }
        if (!rest.empty() && begins_anew(rest) && names_things(rest)) {
            by = rest, subject = part_of(part, 0, i);
            return;
        }
    }
    for (std::size_t i = of_those ? 2 : 1; i < part.size(); ++i)
        if (value_of(part_of(part, i))) {
            value = part_of(part, i), subject = part_of(part, 0, i);
            return;
        }
}

// "Black" and "white" are one look, "larger" and "black" are two values.
void join_value(std::vector<Words>& values, const Words& more) {
    Words all = values.empty() ? Words{} : values.back();
    if (!all.empty()) all.push_back("and");
    all.insert(all.end(), more.begin(), more.end());
    if (!values.empty() && value_of(all)) values.back() = all;
    else values.push_back(more);
}

// "The wardrobe to match", "the desk as well": where that begins; the number of words: nowhere.
std::size_t like_before(const Words& part) {
    for (const char* phrase : {"to match", "to match it", "as well", "the same", "likewise", "the same color"}) {
        const std::size_t count = tokens_of(phrase).size();
        if (part.size() > count && text_of(part, part.size() - count) == phrase) return part.size() - count;
    }
    return part.size();
}

}  // namespace

std::vector<Group> groups_of(const Words& words, std::vector<Words>& unshown) {
    std::vector<Group> out;
    Group open;
    for (const Words& part : parts_of(words)) {
        Words subject, value, by;
        // "The bed yellow and the wardrobe to match"
        if (const std::size_t end = like_before(part); !out.empty() && end < part.size()) {
            out.push_back({{bare_subject(part_of(part, 0, end))}, out.back().values, {}});
            continue;
        }
        cut(part, subject, value, by);
        if (const std::size_t with = find_word(part, {"with"}, 2); value.empty() && with < part.size()) {
            Words plain_by;
            cut(part_of(part, 0, with), subject, value, plain_by);
            if (!value.empty()) unshown.push_back(part_of(part, with)), by = plain_by;
        }
        if (subject.empty() && open.subjects.empty()) {
            if (out.empty()) throw UsageError("expected what to make \"{}\"", text_of(value));
            join_value(out.back().values, value);
            continue;
        }
        if (!subject.empty()) open.subjects.push_back(bare_subject(subject));
        if (value.empty() && by.empty()) continue;
        if (!value.empty()) open.values = {value};
        open.by = by;
        out.push_back(open);
        open = {};
    }
    if (!open.subjects.empty())
        throw UsageError("expected how to make it, for example \"green\" or \"larger\", after \"{}\"",
                         text_of(open.subjects.back()));
    return out;
}

namespace {

// "the walls from green to cream" -> "the walls to cream"
Words without_source(Words words) {
    const std::size_t from = find_word(words, {"from"}, 1), to = find_word(words, {"to", "into"}, from);
    if (to + 1 < words.size() && value_of(part_of(words, from + 1, to)))
        words.erase(words.begin() + static_cast<std::ptrdiff_t>(from), words.begin() + static_cast<std::ptrdiff_t>(to));
    return words;
}

// "all chairs blue except the last one" -> "all chairs except the last one blue"
Words with_exception_first(const Words& words) {
    const std::size_t except = find_word(words, {"except"}, 2);
    std::size_t value = 1;
    while (value < except && !value_of(part_of(words, value, except))) ++value;
    if (except + 1 >= words.size() || value >= except) return words;
    Words out = part_of(words, 0, value);
    const Words rest = part_of(words, except), look = part_of(words, value, except);
    out.insert(out.end(), rest.begin(), rest.end());
    out.insert(out.end(), look.begin(), look.end());
    return out;
}

}  // namespace

Words as_made(Words words) {
    words = with_exception_first(without_source(std::move(words)));
    if (words.size() > 3 && is_one_of(words.back(), {"color", "look", "finish", "cover", "coat", "paint", "tone",
                                                     "covers", "finishes", "upholstery"}))
        words.pop_back();
    return words;
}

}  // namespace fastscene::editing

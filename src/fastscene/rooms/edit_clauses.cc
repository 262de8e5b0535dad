// A sentence cut into clauses: each begins with what is to be done.
#include <algorithm>
#include <array>
#include <charconv>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/prompt_text.h"

namespace fastscene::editing {
namespace {

// "the sofa should be green", "the lamp needs to go to the corner"
bool is_statement(const Words& words, std::size_t at) {
    // "can the walls be white"
    if (is_one_of(words[at], {"can", "could", "may"}) && at + 1 < words.size() && is_definite(words[at + 1]))
        return find_word(words, {"be"}, at + 1) < words.size();
    // "it's too dark", "too dark"
    if (is_one_of(words[at], {"it's", "its"}) && at + 1 < words.size() && words[at + 1] == "too") return true;
    if (words[at] == "too" || is_one_of(words[at], {"brighter", "darker"})) return true;
    if (!is_definite(words[at]) && !is_one_of(words[at], {"all", "both", "every", "each"})) return false;
    for (std::size_t i = at + 1; i + 1 < words.size() && words[i] != ","; ++i)
        if (is_one_of(words[i], {"should", "must", "shall", "needs", "need", "has", "have", "ought"}) &&
            is_one_of(words[i + 1], {"be", "go", "stand", "face", "to", "hang", "move", "look", "become", "have", "get",
                                     "a", "an", "another", "more", "some", "two", "three"}))
            return true;
        // "it is too dark", "the sofa looks too big"
        else if (is_one_of(words[i], {"is", "are", "looks", "look", "feels", "seems", "stands", "stand", "hangs"}) &&
                 is_one_of(words[i + 1], {"too", "not"}))
            return true;
    return false;
}

// "White walls and a wooden floor", "lights off": what is wanted, and no verb.
bool says_what(const Words& words, std::size_t at) {
    if (is_definite(words[at]) && find_word(words, {"is", "are"}, at) < words.size()) return false;
    constexpr std::size_t kFirst = 3;  // words
    for (std::size_t i = at; i < std::min(words.size(), at + kFirst) && !is_joint(words[i]); ++i)
        if (const auto word = look_up(words[i]);
            word &&
            (word->kind == WordKind::object || word->kind == WordKind::structure || word->kind == WordKind::color ||
             word->kind == WordKind::material || word->kind == WordKind::time || word->kind == WordKind::weather))
            return true;
    return false;
}

// "the chairs don't match, make them black": a remark, and then what is to be done. Where the remark ends; nothing: it
// is none, or nothing follows.
std::optional<std::size_t> remark_ends(const Words& words, std::size_t at) {
    std::size_t end = at;
    while (end < words.size() && !is_joint(words[end])) ++end;
    const bool lacks = words[end - 1] == "missing";  // "a rug is missing, add a red one"
    if (!lacks && !is_definite(words[at]) &&
        !is_one_of(words[at], {"it's", "its", "there", "there's", "i", "we", "too"}))
        return {};
    const bool states = std::any_of(
        words.begin() + static_cast<std::ptrdiff_t>(at), words.begin() + static_cast<std::ptrdiff_t>(end),
        [](const std::string& w) {
            return is_one_of(w, {"is",      "isn't",   "isnt",   "are",   "aren't",  "arent", "don't", "dont",
                                 "doesn't", "doesnt",  "look",   "looks", "feel",    "feels", "seem",  "seems",
                                 "it's",    "there's", "blocks", "clash", "clashes", "hate",  "love",  "bored"});
        });
    std::size_t next = end;
    while (next < words.size() && is_joint(words[next])) ++next;
    next = next < words.size() ? past_polite(words, next) : next;
    if (!states || next >= words.size() || !beginning_at(words, next)) return {};
    // "The tv is too small, and put …": to be mended, where nothing that follows is about it.
    const std::size_t too = find_word(words, {"too"}, at);
    if (too < end && (too + 1 >= end || is_complaint(words[too + 1])) &&
        find_word(words, {"it", "its", "them", "they", "one", "ones"}, next) == words.size())
        return {};
    return end;
}

// "Remove the plants, there are too many": why, which changes nothing. Where that ends; nothing: it is no such remark.
std::optional<std::size_t> reason_ends(const Words& words, std::size_t at, Verb before) {
    std::size_t end = at;
    while (end < words.size() && !is_joint(words[end])) ++end;
    const bool many = is_one_of(words[at], {"there", "there's"}) && find_word(words, {"too"}, at) < end &&
                      find_word(words, {"many", "much"}, at) < end;
    const bool of_it = before == Verb::remove && is_one_of(words[at], {"it", "it's", "they", "they're"}) &&
                       find_word(words,
                                 {"is", "are", "it's", "they're", "looks", "look", "takes", "take", "blocks", "block"},
                                 at) < end;
    return many || of_it ? std::optional(end) : std::nullopt;
}

// Ends of a clause that say nothing: "from the room", "please", "for me".
void trim(Words& words, const Words& all_rooms) {
    const auto is_room = [&](const std::string& w) {
        return w == "room" || w == "scene" || std::find(all_rooms.begin(), all_rooms.end(), w) != all_rooms.end();
    };
    for (bool again = true; again && !words.empty();) {
        again = true;
        const std::size_t n = words.size();
        if (n > 2 && stands_at(words, n - 2, "in here")) words.resize(n - 2);
        else if (is_joint(words.back()) || is_one_of(words.back(), {"too", "now", "thanks", "there", "here", "again"}))
            words.pop_back();
        else if (n > 2 && (stands_at(words, n - 2, "as well") || stands_at(words, n - 2, "for me") ||
                           stands_at(words, n - 2, "thank you")))
            words.resize(n - 2);
        else if (n > 3 && is_room(words[n - 1]) && is_one_of(words[n - 2], {"the", "my", "this", "our"}) &&
                 is_one_of(words[n - 3], {"from", "in", "into", "to", "of", "inside"}) &&
                 !is_one_of(words[n - 4], {"middle", "center", "centre", "side", "end", "corner", "back", "front",
                                           "rest", "style", "size"}))
            words.resize(n - 3);
        else again = false;
    }
}

// Marks that stand for words: "20%", "w/ a lamp", "the rug & the pouf".
std::string spelled_out(const std::string& sentence) {
    std::string out;
    for (std::size_t i = 0; i < sentence.size(); ++i) {
        const bool alone = i == 0 || sentence[i - 1] == ' ';
        if (sentence[i] == '%') out += " percent ";
        else if (sentence[i] == '&' || (sentence[i] == '+' && alone)) out += " and ";
        else if (alone && (sentence.compare(i, 3, "w/o") == 0 || sentence.compare(i, 3, "W/o") == 0))
            out += "without", i += 2;
        else if (alone && (sentence.compare(i, 2, "w/") == 0 || sentence.compare(i, 2, "W/") == 0)) out += "with ", ++i;
        else out += sentence[i];
    }
    return out;
}

}  // namespace

bool is_joint(const std::string& word) {
    return is_one_of(word, {",", ".", ";", "and", "then", "please", "also", "but", "plus"});
}

bool is_definite(const std::string& word) {
    return is_one_of(word, {"the", "my", "this", "that", "its", "these", "those", "our", "your", "it", "them"});
}

std::optional<float> number_said(const std::string& word) {
    static constexpr std::array<std::pair<std::string_view, float>, 17> kNumbers{{{"one", 1},
                                                                                  {"two", 2},
                                                                                  {"three", 3},
                                                                                  {"four", 4},
                                                                                  {"five", 5},
                                                                                  {"six", 6},
                                                                                  {"seven", 7},
                                                                                  {"eight", 8},
                                                                                  {"nine", 9},
                                                                                  {"ten", 10},
                                                                                  {"eleven", 11},
                                                                                  {"twelve", 12},
                                                                                  {"half", 0.5f},
                                                                                  {"quarter", 0.25f},
                                                                                  {"a", 1},
                                                                                  {"an", 1},
                                                                                  {"couple", 2}}};
    for (const auto& [name, value] : kNumbers)
        if (word == name) return value;
    float value = 0;
    const auto read = std::from_chars(word.data(), word.data() + word.size(), value);
    if (read.ec != std::errc() || read.ptr != word.data() + word.size()) return {};
    return value;
}

bool begins_anew(const Words& words) {
    if (words.empty() || is_definite(words.front())) return false;
    if (words.size() > 2 && words[1] == "of" && number_said(words[0]) && is_definite(words[2])) return false;
    return !is_one_of(words.front(), {"all", "both", "every", "each", "everything", "this", "one"}) ||
           (words.front() == "one" && !(words.size() > 1 && words[1] == "of"));
}

std::string text_of(const Words& words, std::size_t from, std::size_t to) {
    std::string out;
    for (std::size_t i = from; i < std::min(to, words.size()); ++i) out += (out.empty() ? "" : " ") + words[i];
    return out;
}

Words part_of(const Words& words, std::size_t from, std::size_t to) {
    from = std::min(from, words.size()), to = std::min(to, words.size());
    return from < to ? Words(words.begin() + static_cast<std::ptrdiff_t>(from),
                             words.begin() + static_cast<std::ptrdiff_t>(to))
                     : Words{};
}

Words joined_words(Words first, const Words& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

namespace {

// "… and the pouf in front of the sofa": a place of its own before the next joint.
bool has_own_place(const Words& words, std::size_t from) {
    std::size_t end = from;
    while (end < words.size() && !is_joint(words[end])) ++end;
    const Words part = part_of(words, from, end);
    return next_place(part) < part.size();
}

}  // namespace

std::vector<Words> parts_of(const Words& words) {
    std::vector<Words> parts{{}};
    bool between = false;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& w = words[i];
        if (w == "between") between = true;
        // "between the beds and a poster": of two of a kind it is said already between what.
        const bool said = i > 0 && i + 1 < words.size() && (words[i - 1].ends_with("s") || words[i - 1] == "them") &&
                          (is_one_of(words[i + 1], {"a", "an", "another", "some", "two", "three"}) ||
                           (is_definite(words[i + 1]) && has_own_place(words, i + 1)));
        if (is_joint(w) && !(between && w == "and" && !said)) {
            if (!parts.back().empty()) parts.emplace_back();
            between = false;
            continue;
        }
        if (w == "and") between = false;
        parts.back().push_back(w);
    }
    if (parts.back().empty()) parts.pop_back();
    return parts;
}

std::vector<Clause> clauses_of(const std::string& sentence) {
    static const Words kRooms = [] {
        Words out;
        for (const std::string& type : room_types()) out.push_back(type);
        return out;
    }();
    Words words = in_plain_words(tokens_of(spelled_out(sentence)));
    std::erase_if(words, [](const std::string& w) {
        return is_one_of(w, {"maybe", "perhaps", "preferably", "ideally", "possibly"});
    });
    // "A bathtub in place of the shower"
    for (std::size_t i = 1; i + 2 < words.size(); ++i)
        if (words[i] == "in" && words[i + 1] == "place" && words[i + 2] == "of") {
            words[i] = "instead";
            words.erase(words.begin() + static_cast<std::ptrdiff_t>(i) + 1);
        }
    std::vector<Clause> out;
    bool begins = true;
    for (std::size_t i = 0; i < words.size();) {
        // "everything but the sofa" goes on.
        const bool except = words[i] == "but" && !out.empty() && i + 1 < words.size() && says_all(out.back().words) &&
                            !beginning_at(words, i + 1);
        if (const std::size_t next = taken_back_at(words, i); next > 0 && !out.empty()) {
            while (!out.back().words.empty() && is_joint(out.back().words.back())) out.back().words.pop_back();
            i += next;
            begins = true;
            const std::size_t from = past_polite(words, i);
            if (from < words.size() && beginning_at(words, from)) {
                out.back().taken_back = true;
            } else {
                Clause anew = out.back();
                anew.words.clear(), anew.amends = true;
                out.push_back(anew);
                begins = false;
            }
            continue;
        }
        // "… or replace the sofa": the other choice.
        if (words[i] == "or" && !out.empty() && i + 1 < words.size()) {
            const std::size_t from = past_polite(words, i + 1);
            if (const Beginning* other = from < words.size() ? beginning_at(words, from) : nullptr) {
                out.push_back({other->verb, text_of(other->words), {}});
                out.back().otherwise = true;
                i = from + other->words.size();
                continue;
            }
        }
        if (is_joint(words[i]) && !except) {
            begins = true;
            if (!out.empty()) out.back().words.push_back(words[i]);
            ++i;
            continue;
        }
        if (begins) {
            begins = false;
            const std::size_t from = past_polite(words, i);
            const Beginning* found = from < words.size() ? beginning_at(words, from) : nullptr;
            if (found) {
                out.push_back({found->verb, text_of(found->words), {}});
                i = from + found->words.size();
                continue;
            }
            if (const auto end = from < words.size() ? remark_ends(words, from) : std::nullopt) {
                out.push_back({Verb::remark, "", part_of(words, from, *end)});
                i = *end;
                continue;
            }
            if (const auto end = !out.empty() && from < words.size() ? reason_ends(words, from, out.back().verb)
                                                                     : std::nullopt) {
                out.push_back({Verb::remark, "", part_of(words, from, *end)});
                i = *end;
                continue;
            }
            // "The rug bigger and darker"
            const bool goes_on = !out.empty() && from < words.size() &&
                                 is_one_of(words[from], {"brighter", "darker"}) &&
                                 (out.back().verb == Verb::make || out.back().verb == Verb::want);
            const bool says = from < words.size() && !goes_on && is_statement(words, from);
            const bool also = i > 0 && is_one_of(words[i - 1], {"also", "plus"});
            const bool asks = (out.empty() || also) && from < words.size() &&
                              (number_said(words[from]) || is_one_of(words[from], {"another", "some", "more"}));
            if (says || (out.empty() && from < words.size() && says_what(words, from)))
                out.push_back({Verb::want, "want", {}});
            else if (asks) out.push_back({Verb::add, "add", {}});
            if (from > i && from < words.size() && (says || asks || out.empty())) {
                i = from;
                continue;
            }
        }
        if (out.empty())
            throw UsageError(
                "expected what to do (move, remove, add, make, turn, replace …) at the beginning of \"{}\", found "
                "\"{}\"",
                sentence, words[i]);
        out.back().words.push_back(except ? "except" : words[i]);
        ++i;
    }
    for (Clause& clause : out) {
        while (!clause.words.empty() && is_joint(clause.words.back())) clause.words.pop_back();
        const bool instead = clause.words.size() > 1 && clause.words.back() == "instead";
        if (instead) clause.words.pop_back();
        // "Remove the chandelier and hang a plain lamp instead": in its place.
        const bool goes = &clause != &out.front() && (&clause - 1)->verb == Verb::remove;
        if (instead && goes && (clause.verb == Verb::add || clause.verb == Verb::put) && begins_anew(clause.words) &&
            next_place(clause.words) == clause.words.size())
            clause.words.insert(clause.words.end(), {"in", "its", "place"});
        const std::size_t n = clause.words.size();
        clause.there = n > 1 && (clause.words.back() == "there" ||
                                 (n > 3 && (stands_at(clause.words, n - 3, "in its place") ||
                                            stands_at(clause.words, n - 3, "in their place"))));
        clause.its_place = clause.there && clause.words.back() == "place";
        if (clause.its_place) clause.words.resize(n - 3);
        // "The sofa olive and the armchairs as well"
        const std::size_t last = clause.words.size();
        const bool likewise = last > 3 && stands_at(clause.words, last - 2, "as well") &&
                              find_word(clause.words, {"and"}, 1) < last &&
                              (clause.verb == Verb::make || clause.verb == Verb::color);
        trim(clause.words, kRooms);
        if (likewise) clause.words.insert(clause.words.end(), {"as", "well"});
    }
    if (out.empty()) throw UsageError("expected what to change, found an empty sentence");
    join_clauses(out);
    return out;
}

}  // namespace fastscene::editing

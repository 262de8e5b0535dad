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

struct Beginning {
    std::string_view words;
    Verb verb;
};
// How a clause begins. The longest that fits counts; what is politely said before it is passed over.
constexpr std::array kBeginnings{
    Beginning{"remove", Verb::remove},
    {"delete", Verb::remove},
    {"erase", Verb::remove},
    {"take away", Verb::remove},
    {"take out", Verb::remove},
    {"take", Verb::remove},
    {"drop", Verb::remove},
    {"get rid of", Verb::remove},
    {"throw out", Verb::remove},
    {"throw away", Verb::remove},
    {"throw", Verb::remove},
    {"lose", Verb::remove},
    {"discard", Verb::remove},
    {"ditch", Verb::remove},
    {"kill", Verb::remove},
    {"hide", Verb::remove},
    {"clear away", Verb::remove},
    {"clear out", Verb::remove},
    {"without", Verb::remove},
    {"no more", Verb::remove},
    {"no", Verb::remove},
    {"i dont like", Verb::remove},
    {"i do not like", Verb::remove},
    {"i dont want", Verb::remove},
    {"i do not want", Verb::remove},
    {"i dont need", Verb::remove},
    {"we dont need", Verb::remove},
    {"there should be no", Verb::remove},
    {"clear", Verb::clear},
    {"empty", Verb::clear},
    {"move", Verb::move},
    {"shift", Verb::move},
    {"bring", Verb::move},
    {"push", Verb::move},
    {"pull", Verb::move},
    {"slide", Verb::move},
    {"drag", Verb::move},
    {"relocate", Verb::move},
    {"carry", Verb::move},
    {"put", Verb::put},
    {"place", Verb::put},
    {"set", Verb::put},
    {"stand", Verb::put},
    {"hang", Verb::put},
    {"lay", Verb::put},
    {"position", Verb::put},
    {"mount", Verb::put},
    {"lean", Verb::put},
    {"make", Verb::make},
    {"change", Verb::make},
    {"switch", Verb::make},
    {"give", Verb::make},
    {"turn up", Verb::refuse},
    {"turn down", Verb::refuse},
    {"dim", Verb::refuse},
    {"add", Verb::add},
    {"insert", Verb::add},
    {"include", Verb::add},
    {"get", Verb::add},
    {"create", Verb::add},
    {"bring in", Verb::add},
    {"have", Verb::add},
    {"give me", Verb::add},
    {"give us", Verb::add},
    {"can i have", Verb::add},
    {"can we have", Verb::add},
    {"could i have", Verb::add},
    {"could we have", Verb::add},
    {"can i get", Verb::add},
    {"there should be", Verb::add},
    {"there must be", Verb::add},
    {"there needs to be", Verb::add},
    {"let there be", Verb::add},
    {"i need", Verb::want},
    {"we need", Verb::want},
    {"it needs", Verb::add},
    {"the room needs", Verb::add},
    {"i want", Verb::want},
    {"we want", Verb::want},
    {"i wish", Verb::want},
    {"i would like", Verb::want},
    {"we would like", Verb::want},
    {"id like", Verb::want},
    {"id love", Verb::want},
    {"i would love", Verb::want},
    {"i prefer", Verb::want},
    {"id prefer", Verb::want},
    {"replace", Verb::replace},
    {"exchange", Verb::replace},
    {"substitute", Verb::replace},
    {"swap", Verb::swap},
    {"interchange", Verb::swap},
    {"turn", Verb::turn},
    {"rotate", Verb::turn},
    {"spin", Verb::turn},
    {"flip", Verb::turn},
    {"face", Verb::face},
    {"point", Verb::face},
    {"orient", Verb::face},
    {"aim", Verb::face},
    {"paint", Verb::color},
    {"color", Verb::color},
    {"recolor", Verb::color},
    {"dye", Verb::color},
    {"tint", Verb::color},
    {"repaint", Verb::color},
    {"reupholster", Verb::color},
    {"cover", Verb::color},
    {"enlarge", Verb::larger},
    {"scale up", Verb::larger},
    {"shrink", Verb::smaller},
    {"scale down", Verb::smaller},
    {"reduce", Verb::smaller},
    {"duplicate", Verb::copy},
    {"copy", Verb::copy},
    {"clone", Verb::copy},
    {"open", Verb::refuse},
    {"close", Verb::refuse},
    {"shut", Verb::refuse},
    {"rearrange", Verb::refuse},
    {"reorganize", Verb::refuse},
    {"arrange", Verb::refuse},
    {"redecorate", Verb::refuse},
    {"tidy", Verb::refuse},
    {"tidy up", Verb::refuse},
    {"clean", Verb::refuse},
    {"clean up", Verb::refuse},
    {"improve", Verb::refuse},
    {"fix", Verb::refuse},
    {"undo", Verb::refuse},
    {"redo", Verb::refuse},
    {"keep", Verb::refuse},
    {"leave", Verb::refuse},
};

// Said before what is to be done, and nothing by itself.
constexpr std::array<std::string_view, 41> kPolite{
    "please",        "can you",      "could you",        "would you",      "will you",     "can we",
    "could we",      "you should",   "we should",        "you can",        "i want to",    "i want you to",
    "i would like to", "i would like you to", "id like to", "id like you to", "we want to", "let's",
    "lets",          "let us",       "let me",           "try to",         "go ahead and", "just",
    "now",           "then",         "also",             "maybe",          "perhaps",      "next",
    "ok",            "okay",         "hey",              "hi",             "actually",     "first",
    "finally",       "kindly",       "afterwards",       "would you mind", "i need you to"};

std::size_t count_of(std::string_view phrase) {
    return static_cast<std::size_t>(std::count(phrase.begin(), phrase.end(), ' ')) + 1;
}

bool stands_at(const Words& words, std::size_t at, std::string_view phrase) {
    const std::size_t count = count_of(phrase);
    return at + count <= words.size() && text_of(words, at, at + count) == phrase;
}

std::size_t past_polite(const Words& words, std::size_t at) {
    for (bool again = true; again;) {
        again = false;
        std::size_t longest = 0;
        for (const std::string_view phrase : kPolite)
            if (stands_at(words, at, phrase)) longest = std::max(longest, count_of(phrase));
        if (longest > 0) at += longest, again = true;
    }
    return at;
}

const Beginning* beginning_at(const Words& words, std::size_t at) {
    const Beginning* best = nullptr;
    for (const Beginning& b : kBeginnings)
        if (stands_at(words, at, b.words) && (!best || count_of(b.words) > count_of(best->words))) best = &b;
    return best;
}

// "the sofa should be green", "the lamp needs to go to the corner"
bool is_statement(const Words& words, std::size_t at) {
    if (!is_definite(words[at]) && !is_one_of(words[at], {"all", "both", "every", "each"})) return false;
    for (std::size_t i = at + 1; i + 1 < words.size() && words[i] != ","; ++i)
        if (is_one_of(words[i], {"should", "must", "shall", "needs", "need", "has", "have", "ought"}) &&
            is_one_of(words[i + 1], {"be", "go", "stand", "face", "to", "hang", "move", "look", "become"}))
            return true;
    return false;
}

// Ends of a clause that say nothing: "from the room", "please", "for me".
void trim(Words& words, const Words& all_rooms) {
    const auto is_room = [&](const std::string& w) {
        return w == "room" || w == "scene" || std::find(all_rooms.begin(), all_rooms.end(), w) != all_rooms.end();
    };
    for (bool again = true; again && !words.empty();) {
        again = true;
        const std::size_t n = words.size();
        if (is_joint(words.back()) || is_one_of(words.back(), {"too", "instead", "now", "thanks", "there", "here"}))
            words.pop_back();
        else if (n > 2 && (stands_at(words, n - 2, "as well") || stands_at(words, n - 2, "for me") ||
                           stands_at(words, n - 2, "thank you") || stands_at(words, n - 2, "in here")))
            words.resize(n - 2);
        else if (n > 3 && is_room(words[n - 1]) && is_one_of(words[n - 2], {"the", "my", "this", "our"}) &&
                 is_one_of(words[n - 3], {"from", "in", "into", "to", "of", "inside"}) &&
                 !is_one_of(words[n - 4], {"middle", "center", "centre", "side", "end", "corner", "back", "front",
                                           "rest", "style", "size"}))
            words.resize(n - 3);
        else again = false;
    }
}

// "20%" as a word, so that no mark ends the clause there.
std::string with_percent(const std::string& sentence) {
    std::string out;
    for (const char c : sentence)
        if (c == '%') out += " percent ";
        else out += c;
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
    static constexpr std::array<std::pair<std::string_view, float>, 17> kNumbers{
        {{"one", 1},    {"two", 2},  {"three", 3},  {"four", 4},    {"five", 5},    {"six", 6},
         {"seven", 7},  {"eight", 8}, {"nine", 9},  {"ten", 10},    {"eleven", 11}, {"twelve", 12},
         {"half", 0.5f}, {"quarter", 0.25f}, {"a", 1}, {"an", 1},   {"couple", 2}}};
    for (const auto& [name, value] : kNumbers)
        if (word == name) return value;
    float value = 0;
    const auto read = std::from_chars(word.data(), word.data() + word.size(), value);
    if (read.ec != std::errc() || read.ptr != word.data() + word.size()) return {};
    return value;
}

bool begins_anew(const Words& words) {
    if (words.empty() || is_definite(words.front())) return false;
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

std::vector<Words> parts_of(const Words& words) {
    std::vector<Words> parts{{}};
    bool between = false;
    for (const std::string& w : words) {
        if (w == "between") between = true;
        if (is_joint(w) && !(between && w == "and")) {
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
    const Words words = tokens_of(with_percent(sentence));
    std::vector<Clause> out;
    bool begins = true;
    for (std::size_t i = 0; i < words.size();) {
        // "everything but the sofa" goes on.
        const bool except = words[i] == "but" && i > 0 &&
                            is_one_of(words[i - 1], {"everything", "all", "anything", "nothing", "things"});
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
                out.push_back({found->verb, std::string(found->words), {}});
                i = from + count_of(found->words);
                continue;
            }
            const bool says = from < words.size() && is_statement(words, from);
            const bool asks = out.empty() && from < words.size() &&
                              (number_said(words[from]) || is_one_of(words[from], {"another", "some", "more"}));
            if (says) out.push_back({Verb::want, "want", {}});
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
        out.back().words.push_back(words[i++]);
    }
    for (Clause& clause : out) trim(clause.words, kRooms);
    if (out.empty()) throw UsageError("expected what to change, found an empty sentence");
    return out;
}

}  // namespace fastscene::editing

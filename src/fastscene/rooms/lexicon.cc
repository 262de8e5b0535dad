#include "fastscene/rooms/lexicon.h"

#include <algorithm>
#include <charconv>
#include <map>

#include "fastscene/base/check.h"
#include "fastscene/rooms/style.h"

namespace fastscene {

extern const std::string_view kLexiconText;  // lexicon.tsv

namespace {

constexpr std::string_view kKinds[] = {"room", "style", "object", "structure", "color", "material", "pattern", "time", "weather", "light",
                                       "size", "mood", "count", "negation", "relation", "detail", "nuance", "filler", "function"};

struct Lexicon {
    std::map<std::string, Word, std::less<>> words;   // "armchair", "de:sessel"
    std::map<std::string, std::uint32_t, std::less<>> colors;
};

std::vector<std::string_view> split(std::string_view line, char mark) {
    std::vector<std::string_view> parts;
    for (;;) {
        const auto at = line.find(mark);
        parts.push_back(line.substr(0, at));
        if (at == std::string_view::npos) return parts;
        line = line.substr(at + 1);
    }
}

std::uint32_t number_from_hex(std::string_view hex) {
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(hex.data() + 1, hex.data() + hex.size(), value, 16);
    FASTSCENE_CHECK(error == std::errc() && end == hex.data() + 7);
    return value;
}

std::string key_of(std::string_view term, Language language) {
    return language.empty() ? std::string(term) : std::string(language) + ":" + std::string(term);
}

// term, kind, meaning, fit, what it adds, language; missing columns are empty.
void read_line(std::string_view line, Lexicon& lexicon) {
    if (line.empty() || line.front() == '#') return;
    std::vector<std::string_view> column = split(line, '\t');
    column.resize(6);
    const auto kind = std::find(std::begin(kKinds), std::end(kKinds), column[1]);
    FASTSCENE_CHECK(kind != std::end(kKinds));
    if (column[1] == "color" && column[5].empty()) {
        lexicon.colors.emplace(column[0], number_from_hex(column[4]));
        return;
    }
    lexicon.words.emplace(key_of(column[0], column[5]), Word{static_cast<WordKind>(kind - std::begin(kKinds)), std::string(column[2]), column[3] != "~", std::string(column[4])});
}

const Lexicon& table() {
    static const Lexicon read = [] {
        Lexicon out;
        for (const std::string_view line : split(kLexiconText, '\n')) read_line(line, out);
        for (auto& [term, word] : out.words) word.also_color = out.colors.contains(term);
        return out;
    }();
    return read;
}

void english_forms(const std::string& term, std::vector<std::string>& out) {
    const auto ends = [&](std::string_view e) { return term.size() > e.size() + 1 && term.ends_with(e); };
    if (ends("ves")) out.push_back(term.substr(0, term.size() - 3) + "f"), out.push_back(term.substr(0, term.size() - 3) + "fe");
    if (ends("ies")) out.push_back(term.substr(0, term.size() - 3) + "y");
    if (ends("es")) out.push_back(term.substr(0, term.size() - 2));
    if (ends("s") && !ends("ss")) out.push_back(term.substr(0, term.size() - 1));
}

void german_forms(const std::string& term, std::vector<std::string>& out) {
    for (const std::string_view e : {"ern", "em", "en", "er", "es", "e", "n", "s"})
        if (term.size() > e.size() + 2 && term.ends_with(e)) out.push_back(term.substr(0, term.size() - e.size()));
    // ae oe ue as they are written without umlauts: "gruener", "gemuetlich".
    std::string plain = term;
    for (const char* pair : {"ue", "ae", "oe"})
        for (auto at = plain.find(pair); at != std::string::npos; at = plain.find(pair, at + 1)) plain.erase(at + 1, 1);
    if (plain != term) out.push_back(plain), german_forms(plain, out);
}

void romance_forms(const std::string& term, std::vector<std::string>& out) {
    for (const std::string_view e : {"es", "s", "x"})
        if (term.size() > e.size() + 2 && term.ends_with(e)) out.push_back(term.substr(0, term.size() - e.size()));
}

void italian_forms(const std::string& term, std::vector<std::string>& out) {
    if (term.size() < 4) return;
    const std::string stem = term.substr(0, term.size() - 1);
    if (term.back() == 'i') out.push_back(stem + "o"), out.push_back(stem + "e");
    if (term.back() == 'e') out.push_back(stem + "a");
}

std::optional<Word> find(const std::string& term, Language language) {
    if (const auto at = table().words.find(key_of(term, language)); at != table().words.end()) return at->second;
    if (!language.empty()) return {};
    // Digits; more than 99 of a thing is no room.
    if (term.size() <= 2 && term[0] >= '1' && term[0] <= '9' && std::all_of(term.begin(), term.end(), [](char c) { return c >= '0' && c <= '9'; }))
        return Word{WordKind::count, term};
    if (color_named(term)) return Word{WordKind::color, term};
    return {};
}

// Damerau-Levenshtein distance of at most one.
bool within_one(std::string_view a, std::string_view b) {
    if (a.size() > b.size()) std::swap(a, b);
    if (b.size() - a.size() > 1) return false;
    std::size_t i = 0;
    while (i < a.size() && a[i] == b[i]) ++i;
    if (a.size() < b.size()) return a.substr(i) == b.substr(i + 1);
    if (i == a.size()) return true;
    if (a.substr(i + 1) == b.substr(i + 1)) return true;
    return i + 1 < a.size() && a[i] == b[i + 1] && a[i + 1] == b[i] && a.substr(i + 2) == b.substr(i + 2);
}

// How gladly a typo is read as this word; smaller is better.
int rank_of(const Word& word, char first_letter, const std::string& term) {
    const bool shown = word.kind != WordKind::nuance && word.kind != WordKind::filler && word.kind != WordKind::function && word.kind != WordKind::relation;
    return (shown ? 0 : 2) + (term[0] == first_letter ? 0 : 1);
}

}  // namespace

std::vector<std::string> base_forms(const std::string& term, Language language) {
    std::vector<std::string> out;
    if (language.empty()) english_forms(term, out);
    if (language == "de") german_forms(term, out);
    if (language == "fr" || language == "es") romance_forms(term, out);
    if (language == "it") italian_forms(term, out);
    return out;
}

std::optional<Word> look_up(const std::string& term, Language language) {
    if (!language.empty()) {
        if (auto word = find(term, language)) return word;
        for (const std::string& form : base_forms(term, language))
            if (auto word = find(form, language)) return word;
    }
    if (auto word = find(term, {})) return word;
    for (const std::string& form : base_forms(term))
        if (auto word = find(form, {}); word && word->kind != WordKind::function && word->kind != WordKind::count && word->kind != WordKind::relation) return word;
    return {};
}

bool is_function_word(const std::string& term, Language language) {
    const auto at = table().words.find(key_of(term, language));
    return at != table().words.end() && (at->second.kind == WordKind::function || at->second.kind == WordKind::relation || at->second.kind == WordKind::negation);
}

std::optional<std::string> nearest_term(const std::string& word, Language language) {
    if (word.size() < 5) return {};
    std::optional<std::string> best;
    Word best_word;
    int best_rank = 99;
    bool ambiguous = false;
    const auto consider = [&](const std::string& term, const Word& candidate) {
        if (term.size() < 4 || term.find(' ') != std::string::npos || !within_one(word, term)) return;
        const int rank = rank_of(candidate, word[0], term);
        if (rank > best_rank) return;
        const bool same = best && rank == best_rank && best_word.kind == candidate.kind && best_word.meaning == candidate.meaning;
        ambiguous = rank == best_rank && best && !same;
        if (rank < best_rank) best = term, best_word = candidate, best_rank = rank;
    };
    for (const auto& [key, candidate] : table().words) {
        const auto colon = key.find(':');
        const bool foreign = colon != std::string::npos;
        if (foreign ? key.substr(0, colon) != language : !language.empty()) continue;
        consider(foreign ? key.substr(colon + 1) : key, candidate);
    }
    if (language.empty())
        for (const auto& [name, rgb] : table().colors)
            if (!table().words.contains(name)) consider(name, Word{WordKind::color, name});
    return ambiguous ? std::nullopt : best;  // two meanings are as near: do not guess
}

std::optional<std::uint32_t> lexicon_color(std::string_view name) {
    const auto at = table().colors.find(name);
    return at == table().colors.end() ? std::nullopt : std::optional(at->second);
}

std::string room_title(std::string_view room) {
    if (room == "living") return "living room";
    if (room == "kids") return "kids' room";
    if (room == "dining") return "dining room";
    if (room == "laundry") return "laundry room";
    return std::string(room);
}

std::vector<std::string> room_types() {
    return {"living", "bedroom", "kids", "kitchen", "dining", "bathroom", "study", "hallway", "loft", "laundry", "sunroom", "attic"};
}

std::size_t lexicon_size() { return table().words.size() + table().colors.size(); }

std::vector<std::string> lexicon_terms() {
    std::vector<std::string> out;
    for (const auto& [term, word] : table().words)
        if (term.find(':') == std::string::npos) out.push_back(term);
    return out;
}

}  // namespace fastscene

// What was meant by words that are misspelt: a letter wrong, or spaces where others put none ("bed side lamp", "cofee
// table").
#include <algorithm>
#include <array>
#include <utility>

#include "fastscene/rooms/lexicon_table.h"

namespace fastscene {
namespace {

constexpr std::size_t kShortestWord = 4;  // letters of a word that may hold a typo
constexpr std::size_t kLong = 8;          // from here on two letters may be wrong
constexpr std::size_t kFewLetters = 6;    // of a term that may be spelt with other spaces

// Damerau-Levenshtein distance (optimal string alignment), or more than `most`.
std::size_t distance(std::string_view a, std::string_view b, std::size_t most) {
    if (a.size() > b.size() + most || b.size() > a.size() + most) return most + 1;
    std::vector<std::size_t> before(b.size() + 1), row(b.size() + 1), next(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        next[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            next[j] = std::min({row[j] + 1, next[j - 1] + 1, row[j - 1] + (a[i - 1] != b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                next[j] = std::min(next[j], before[j - 2] + 1);
        }
        before = std::exchange(row, next);
    }
    return row[b.size()];
}

// How far a typo may be from the word that is meant; two wrong letters only after a right first one.
std::size_t reach(std::string_view word, std::string_view meant) {
    if (word.size() < kShortestWord || meant.size() < kShortestWord) return 0;
    return word.size() >= kLong && meant.size() >= kLong && word[0] == meant[0] ? 2 : 1;
}

// Of four letters only two that changed places: "dekc"; else nearly every short word is near another.
bool is_near(std::string_view word, std::string_view meant, std::size_t& far) {
    const std::size_t most = reach(word, meant);
    if (most == 0) return false;
    if (word.size() == kShortestWord &&
        (meant.size() != kShortestWord || !std::is_permutation(word.begin(), word.end(), meant.begin())))
        return false;
    far = distance(word, meant, most);
    return far > 0 && far <= most;
}

// How gladly a typo is read as this word; smaller is better.
int rank_of(const Word& word, char first_letter, const std::string& term, std::size_t far) {
    const bool shown = word.kind != WordKind::nuance && word.kind != WordKind::filler &&
                       word.kind != WordKind::function && word.kind != WordKind::relation;
    return 4 * static_cast<int>(far) + (shown ? 0 : 2) + (term[0] == first_letter ? 0 : 1);
}

std::vector<std::string> words_of(std::string_view term) {
    std::vector<std::string> out;
    for (std::size_t at = 0; at <= term.size();) {
        const std::size_t end = std::min(term.find(' ', at), term.size());
        out.emplace_back(term.substr(at, end - at));
        at = end + 1;
    }
    return out;
}

// A term that may be meant.
struct Term {
    std::string term;
    std::vector<std::string> words;
    const Word* word;
};

// Those of a language, by how many words they have; made once: a prompt is compared with thousands.
const std::vector<Term>& terms_of(Language language, std::size_t words) {
    using ByLength = std::array<std::vector<Term>, kLongestTerm + 1>;
    static const std::map<std::string, ByLength, std::less<>> kAll = [] {
        std::map<std::string, ByLength, std::less<>> all;
        for (const auto& [key, word] : lexicon_table().words) {
            if (word.kind == WordKind::other) continue;
            const auto colon = key.find(':');
            const bool foreign = colon != std::string::npos;
            const std::string term = foreign ? key.substr(colon + 1) : key;
            std::vector<std::string> parts = words_of(term);
            const std::size_t count = std::min(parts.size(), kLongestTerm);
            all[foreign ? key.substr(0, colon) : std::string()][count].push_back({term, std::move(parts), &word});
        }
        return all;
    }();
    static const std::vector<Term> kNone;
    const auto at = kAll.find(language);
    return at == kAll.end() || words > kLongestTerm ? kNone : at->second[words];
}

// The last word of a term may stand in the plural.
bool fits(const std::vector<std::string>& words, const std::vector<bool>& known, const std::vector<std::string>& term,
          Language language) {
    std::size_t far = 0;
    const auto fit = [&](const std::string& word, std::size_t k) {
        return word == term[k] || (!known[k] && is_near(word, term[k], far));
    };
    const std::size_t last = words.size() - 1;
    for (std::size_t k = 0; k < last; ++k)
        if (!fit(words[k], k)) return false;
    if (fit(words[last], last)) return true;
    const std::vector<std::string> forms = base_forms(words[last], language);
    return std::any_of(forms.begin(), forms.end(), [&](const std::string& form) { return fit(form, last); });
}

}  // namespace

std::optional<std::string> nearest_term(const std::string& word, Language language) {
    std::optional<std::string> best;
    Word best_word{WordKind::other, ""};
    int best_rank = 99;
    bool ambiguous = false;
    const auto consider = [&](const std::string& term, const std::string& spelt, const Word& candidate,
                              std::size_t far) {
        const int rank = rank_of(candidate, word[0], spelt, far);
        if (rank > best_rank) return;
        const bool same = best && rank == best_rank && best_word.kind == candidate.kind &&
                          best_word.meaning == candidate.meaning;
        ambiguous = rank == best_rank && best && !same;
        if (rank < best_rank) best = term, best_word = candidate, best_rank = rank;
    };
    std::size_t far = 0;
    for (const Term& term : terms_of(language, 1))
        if (is_near(word, term.term, far)) consider(term.term, term.term, *term.word, far);
    if (language.empty())
        for (const auto& [name, rgb] : lexicon_table().colors)
            if (is_near(word, name, far) && !lexicon_table().words.contains(name))
                consider(name, name, Word{WordKind::color, name}, far);
    // "coffetable", without its space too.
    if (!best && word.size() >= kLong && language.empty())
        for (const auto& [key, term] : lexicon_table().letters)
            if (term.find(' ') != std::string::npos && key.find(':') == std::string::npos && is_near(word, key, far))
                consider(term, key, *look_up(term), far);
    return ambiguous ? std::nullopt : best;  // two meanings are as near: do not guess
}

std::optional<std::string> nearest_phrase(const std::vector<std::string>& words, const std::vector<bool>& known,
                                          Language language) {
    if (std::all_of(known.begin(), known.end(), [](bool k) { return k; })) return {};
    std::optional<std::string> found;
    std::string meaning;
    bool ambiguous = false;
    for (const Term& term : terms_of(language, words.size())) {
        if (term.word->kind == WordKind::function || !fits(words, known, term.words, language)) continue;
        ambiguous = ambiguous || (found && meaning != term.word->meaning);
        found = term.term;
        meaning = term.word->meaning;
    }
    return ambiguous ? std::nullopt : found;
}

std::optional<std::string> respelled(const std::string& words, Language language) {
    const auto with_letters = [&](std::string letters) -> std::optional<std::string> {
        std::erase(letters, ' ');
        if (letters.size() < kFewLetters) return {};
        const auto at = lexicon_table().letters.find(lexicon_key(letters, language));
        return at == lexicon_table().letters.end() || at->second == words ? std::nullopt : std::optional(at->second);
    };
    if (auto term = with_letters(words)) return term;
    for (const std::string& form : base_forms(words, language))
        if (auto term = with_letters(form)) return term;
    return {};
}

}  // namespace fastscene

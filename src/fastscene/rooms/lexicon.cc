#include "fastscene/rooms/lexicon.h"

#include <algorithm>
#include <charconv>

#include "fastscene/base/check.h"
#include "fastscene/rooms/lexicon_table.h"
#include "fastscene/rooms/room_type.h"
#include "fastscene/rooms/style.h"
#include "fastscene/rooms/style_file.h"

namespace fastscene {

extern const std::string_view kLexiconText;  // lexicon.tsv

namespace {

constexpr std::string_view kKinds[] = {"room",     "style",    "object",   "structure", "color",  "material",
                                       "pattern",  "time",     "weather",  "light",     "size",   "mood",
                                       "count",    "negation", "relation", "detail",    "nuance", "filler",
                                       "function", "scope",    "bound",    "unit",      "other"};

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

// term, kind, meaning, fit, what it adds, language; missing columns are empty.
void read_line(std::string_view line, LexiconTable& lexicon) {
    if (line.empty() || line.front() == '#') return;
    std::vector<std::string_view> column = split(line, '\t');
    column.resize(6);
    const auto kind = std::find(std::begin(kKinds), std::end(kKinds), column[1]);
    FASTSCENE_CHECK(kind != std::end(kKinds));
    if (column[1] == "color" && column[5].empty()) {
        lexicon.colors.emplace(column[0], number_from_hex(column[4]));
        return;
    }
    lexicon.words.emplace(lexicon_key(column[0], column[5]),
                          Word{static_cast<WordKind>(kind - std::begin(kKinds)), std::string(column[2]),
                               !column[3].starts_with("~"), std::string(column[4]), column[3] == "~~"});
}

// Whether people put spaces into such words as they like: "bed side table", "livingroom".
bool is_spelt_freely(const Word& word) {
    return word.kind == WordKind::object || word.kind == WordKind::room || word.kind == WordKind::structure ||
           word.kind == WordKind::material || word.kind == WordKind::style || word.kind == WordKind::detail;
}

void english_forms(const std::string& term, std::vector<std::string>& out) {
    const auto ends = [&](std::string_view e) { return term.size() > e.size() + 1 && term.ends_with(e); };
    if (ends("ves"))
        out.push_back(term.substr(0, term.size() - 3) + "f"), out.push_back(term.substr(0, term.size() - 3) + "fe");
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
    if (const auto at = lexicon_table().words.find(lexicon_key(term, language)); at != lexicon_table().words.end())
        return at->second;
    if (!language.empty()) return {};
    // Digits; more than 99 of a thing is no room.
    if (term.size() <= 2 && term[0] >= '1' && term[0] <= '9' &&
        std::all_of(term.begin(), term.end(), [](char c) { return c >= '0' && c <= '9'; }))
        return Word{WordKind::count, term};
    if (color_named(term)) return Word{WordKind::color, term};
    return {};
}

// What the lexicon's file alone says. Style and room type files may name its colors, so it is read before them.
const LexiconTable& lexicon_file() {
    static const LexiconTable read = [] {
        LexiconTable out;
        for (const std::string_view line : split(kLexiconText, '\n')) read_line(line, out);
        return out;
    }();
    return read;
}

}  // namespace

std::string lexicon_key(std::string_view term, Language language) {
    return language.empty() ? std::string(term) : std::string(language) + ":" + std::string(term);
}

const LexiconTable& lexicon_table() {
    static const LexiconTable read = [] {
        LexiconTable out = lexicon_file();
        // What a style's own file says goes before the nearest style that the lexicon knows.
        for (const auto& [word, style] : style_words()) out.words.insert_or_assign(word, Word{WordKind::style, style});
        // A room type's file likewise; what a word adds ("speakeasy": its style) it still adds.
        const auto names_room = [&](const std::string& word, const RoomType& type, bool exact) {
            const auto at = out.words.find(word);
            const bool keeps = at != out.words.end() && at->second.kind == WordKind::room && word != type.title;
            std::string adds = keeps ? at->second.adds : "";
            out.words.insert_or_assign(word, Word{WordKind::room, type.name, exact, std::move(adds)});
        };
        for (const RoomType& type : all_room_types()) {
            for (const std::string& word : type.words) names_room(word, type, true);
            for (const std::string& word : type.words_near) names_room(word, type, false);
        }
        for (auto& [term, word] : out.words) {
            word.also_color = out.colors.contains(term);
            std::string letters = term;
            std::erase(letters, ' ');
            if (is_spelt_freely(word)) out.letters.emplace(letters, term.substr(term.find(':') + 1));
        }
        return out;
    }();
    return read;
}

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
    const auto space = term.rfind(' ');
    const auto last = space == std::string::npos ? std::nullopt : find(term.substr(space + 1), {});
    const bool things = last && last->kind == WordKind::object;  // "white roses" are no shade of rose
    for (const std::string& form : base_forms(term))
        if (auto word = find(form, {}); word && !(things && word->kind == WordKind::color) &&
                                        word->kind != WordKind::function && word->kind != WordKind::count &&
                                        word->kind != WordKind::relation)
            return word;
    return {};
}

bool is_function_word(const std::string& term, Language language) {
    const auto at = lexicon_table().words.find(lexicon_key(term, language));
    return at != lexicon_table().words.end() &&
           (at->second.kind == WordKind::function || at->second.kind == WordKind::relation ||
            at->second.kind == WordKind::negation);
}

std::optional<std::uint32_t> lexicon_color(std::string_view name) {
    const auto at = lexicon_file().colors.find(name);
    return at == lexicon_file().colors.end() ? std::nullopt : std::optional(at->second);
}

std::string room_title(std::string_view room) {
    for (const RoomType& type : all_room_types())
        if (type.name == room) return type.title;
    return std::string(room);
}

std::vector<std::string> room_types() {
    std::vector<std::string> out;
    for (const RoomType& type : all_room_types()) out.push_back(type.name);
    return out;
}

std::size_t lexicon_size() { return lexicon_table().words.size() + lexicon_table().colors.size(); }

std::vector<std::string> lexicon_terms() {
    std::vector<std::string> out;
    for (const auto& [term, word] : lexicon_table().words)
        if (term.find(':') == std::string::npos) out.push_back(term);
    return out;
}

}  // namespace fastscene

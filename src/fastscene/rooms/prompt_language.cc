// Which language a prompt is in, and whether it is one that is read.
#include <algorithm>
#include <array>

#include "fastscene/rooms/prompt_parts.h"

namespace fastscene::reading {
namespace {

constexpr std::array<Language, 4> kRead{"de", "fr", "es", "it"};
// Of these the lexicon has the little words, to know them by.
constexpr std::array<std::pair<Language, std::string_view>, 10> kUnread{{{"nl", "Dutch"},
                                                                         {"pl", "Polish"},
                                                                         {"pt", "Portuguese"},
                                                                         {"sv", "Swedish"},
                                                                         {"da", "Danish or Norwegian"},
                                                                         {"fi", "Finnish"},
                                                                         {"cs", "Czech or Slovak"},
                                                                         {"tr", "Turkish"},
                                                                         {"ro", "Romanian"},
                                                                         {"hu", "Hungarian"}}};

// Ranges of letters that tell a language or a script, the telling ones first.
struct Script {
    std::string_view name;
    char32_t first, last;
};
constexpr Script kScripts[] = {
    {"Japanese", 0x3040, 0x30ff},
    {"Korean", 0x1100, 0x11ff},
    {"Korean", 0xac00, 0xd7af},
    {"Chinese", 0x3400, 0x9fff},
    {"a language in Cyrillic letters", 0x400, 0x52f},
    {"Greek", 0x370, 0x3ff},
    {"Hebrew", 0x590, 0x5ff},
    {"Arabic or Persian", 0x600, 0x77f},
    {"an Indian language", 0x900, 0xdff},
    {"Thai", 0xe00, 0xe7f},
    {"Georgian", 0x10a0, 0x10ff},
    {"Armenian", 0x530, 0x58f},
};

char32_t next_letter(const std::string& text, std::size_t& at) {
    const auto c = static_cast<unsigned char>(text[at]);
    const std::size_t length = c < 0x80 ? 1 : c < 0xe0 ? 2 : c < 0xf0 ? 3 : 4;
    char32_t code = length == 1 ? c : c & (0x7fu >> length);
    for (std::size_t k = 1; k < length && at + k < text.size(); ++k)
        code = (code << 6) | (static_cast<unsigned char>(text[at + k]) & 0x3f);
    at += length;
    return code;
}

// Of a prompt that is mostly in other letters than ours.
std::string_view script_of(const std::vector<std::string>& tokens) {
    std::size_t ours = 0, others = 0;
    const Script* best = nullptr;
    for (const std::string& token : tokens)
        for (std::size_t at = 0; at < token.size();) {
            const char32_t c = next_letter(token, at);
            ours += (c >= 'a' && c <= 'z');
            for (const Script& script : kScripts)
                if (c >= script.first && c <= script.last) {
                    ++others;
                    if (!best || &script < best) best = &script;
                }
        }
    return best && others >= ours ? best->name : std::string_view();
}

std::size_t little_words(const std::vector<std::string>& tokens, Language language) {
    return static_cast<std::size_t>(std::count_if(
        tokens.begin(), tokens.end(), [&](const std::string& t) { return t != "," && is_function_word(t, language); }));
}

// The read language of most of its words.
Language read_language(const std::vector<std::string>& tokens) {
    const auto known = [&](Language language) {
        return std::count_if(tokens.begin(), tokens.end(),
                             [&](const std::string& t) { return t != "," && look_up(t, language).has_value(); });
    };
    Language best;
    auto most = known({});
    const auto articles = std::count_if(tokens.begin(), tokens.end(),
                                        [](const std::string& t) { return t == "a" || t == "an"; });
    const std::size_t english = little_words(tokens, {}) + static_cast<std::size_t>(articles);
    for (const Language language : kRead) {
        // A borrowed word or two ("salon", "futon") make no foreign sentence: more must be understood than in English.
        // Nor do they where the little words are English: "a bedrom with a bleu duvet".
        const std::size_t little = little_words(tokens, language);
        if (const auto words = known(language); little > 0 && little >= english && words > most)
            most = words, best = language;
    }
    return best;
}

}  // namespace

Tongue tongue_of(const std::vector<std::string>& tokens) {
    if (const std::string_view script = script_of(tokens); !script.empty()) return {{}, script};
    const Language read = read_language(tokens);
    const auto words = std::count_if(tokens.begin(), tokens.end(), [](const std::string& t) { return t != ","; });
    const auto english = std::count_if(tokens.begin(), tokens.end(),
                                       [](const std::string& t) { return t != "," && look_up(t).has_value(); });
    if (3 * english > 2 * words) return {read, {}};
    // Little words tell languages of a family apart: Portuguese shares its nouns with Spanish, not "uma" and "com".
    std::size_t most = 0;
    for (const Language language : kRead) most = std::max(most, little_words(tokens, language));
    most = std::max(most, little_words(tokens, {}));
    constexpr std::size_t kFewest = 2;  // one may be a borrowed word ("en suite")
    std::string_view unread;
    for (const auto& [language, name] : kUnread)
        if (const std::size_t little = little_words(tokens, language); little > most && little >= kFewest)
            most = little, unread = name;
    return unread.empty() ? Tongue{read, {}} : Tongue{{}, unread};
}

bool is_little_word_unread(const std::string& token, std::string_view unread) {
    for (const auto& [language, name] : kUnread)
        if (name == unread) return is_function_word(token, language);
    return false;
}

}  // namespace fastscene::reading

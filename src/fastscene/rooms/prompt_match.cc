// From tokens to terms of the lexicon.
#include <algorithm>
#include <array>

#include "fastscene/rooms/pack.h"
#include "fastscene/rooms/prompt_parts.h"

namespace fastscene::reading {
namespace {

// The lexicon writes "kids room".
std::string joined(const std::vector<std::string>& tokens, std::size_t begin, std::size_t count) {
    std::string out;
    for (std::size_t i = begin; i < begin + count; ++i) out += (i > begin ? " " : "") + tokens[i];
    std::erase(out, '\'');
    return out;
}

// "a captain's desk": whose it is shows nowhere.
bool is_owner(const std::string& token) { return token.ends_with("'s"); }

// How many tokens in a row hold no mark.
std::size_t phrase_length(const std::vector<std::string>& tokens, std::size_t begin, std::size_t limit) {
    std::size_t n = 0;
    while (n < limit && begin + n < tokens.size() && tokens[begin + n] != ",") ++n;
    return n;
}

// German writes "Ledersofa" and "Holztisch" as one word.
bool split_compound(const std::string& token, Matches& matches) {
    for (std::size_t cut = token.size() - 3; cut >= 3; --cut) {
        std::string head = token.substr(0, cut), tail = token.substr(cut);
        if (head.back() == 'n' && !look_up(head, "de")) head.pop_back();  // "Eichenboden"
        const auto first = look_up(head, "de"), second = look_up(tail, "de");
        if (!first || !second || (first->kind != WordKind::material && first->kind != WordKind::color)) continue;
        if (second->kind != WordKind::object && second->kind != WordKind::structure) continue;
        matches.push_back({.words = head, .word = first});
        matches.push_back({.words = tail, .word = second});
        return true;
    }
    return false;
}

}  // namespace

Language language_of(const std::vector<std::string>& tokens) {
    constexpr std::array<Language, 4> kForeign{"de", "fr", "es", "it"};
    std::size_t english = 0;
    for (const std::string& t : tokens) english += t != "," && look_up(t).has_value();
    Language best;
    std::size_t most = english;
    for (const Language language : kForeign) {
        std::size_t known = 0, little = 0;
        for (const std::string& t : tokens) {
            if (t == ",") continue;
            known += look_up(t, language).has_value();
            little += is_function_word(t, language);
        }
        // A borrowed word or two ("salon", "futon") make no foreign sentence: more must be understood than in English.
        if (little > 0 && known > most) most = known, best = language;
    }
    return best;
}

Matches match(const std::vector<std::string>& tokens, Language language, const FurniturePack* pack) {
    Matches matches;
    for (std::size_t i = 0; i < tokens.size();) {
        if (tokens[i] == ",") {
            matches.push_back({.words = ",", .comma = true});
            ++i;
            continue;
        }
        bool found = false;
        for (std::size_t n = phrase_length(tokens, i, kLongestTerm); n > 0 && !found; --n) {
            const std::string term = joined(tokens, i, n);
            if (n == 1 && is_owner(tokens[i])) {
                // Some rooms are named by who lives there ("a student's den"), unless another room's name follows.
                const auto of_owner = look_up(tokens[i].substr(0, tokens[i].size() - 2) + " room");
                const bool room_follows = std::any_of(tokens.begin() + static_cast<std::ptrdiff_t>(i), tokens.end(), [&](const std::string& t) {
                    const auto word = look_up(t, language);
                    return word && word->kind == WordKind::room;
                });
                matches.push_back(
                    {.words = term,
                     .word = of_owner && of_owner->kind == WordKind::room && !room_follows ? *of_owner : Word{WordKind::nuance, "owner"}});
                ++i;
                found = true;
                break;
            }
            if (const auto word = look_up(term, language)) {
                matches.push_back({.words = term, .word = word});
                i += n;
                found = true;
            }
        }
        if (found) continue;
        for (std::size_t n = pack ? phrase_length(tokens, i, kLongestTerm) : 0; n > 0 && !found; --n) {
            const std::string term = joined(tokens, i, n);
            if (const auto klass = pack->class_named(term)) {
                matches.push_back({.words = term, .word = Word{WordKind::object, *klass}});
                i += n;
                found = true;
            }
        }
        if (found) continue;
        const std::string& token = tokens[i++];
        if (language == "de" && token.size() >= 7 && split_compound(token, matches)) continue;
        if (const auto term = nearest_term(token, language))
            matches.push_back({.words = token, .word = look_up(*term, language), .note = "read as \"" + *term + "\""});
        else
            matches.push_back({.words = token});
    }
    return matches;
}

}  // namespace fastscene::reading

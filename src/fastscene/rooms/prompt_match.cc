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

namespace {

// "a student's den": some rooms are named by who lives there, unless another room's name follows.
Match owner_at(const std::vector<std::string>& tokens, std::size_t i, Language language) {
    const std::string owner = tokens[i].substr(0, tokens[i].size() - 2);
    // "a gamer's den", "a pirate's cabin": who it is says what it shows.
    if (const auto who = look_up(owner, language);
        who && who->kind == WordKind::nuance && (who->adds.starts_with("theme=") || who->adds.starts_with("motif=")))
        return {.words = joined(tokens, i, 1), .word = who};
    const auto room = look_up(owner + " room");
    const bool room_follows = std::any_of(
        tokens.begin() + static_cast<std::ptrdiff_t>(i), tokens.end(), [&](const std::string& t) {
            const auto word = look_up(t, language);
            return word && word->kind == WordKind::room && !(room && is_same_room(room->meaning, word->meaning));
        });
    return {.words = joined(tokens, i, 1),
            .word = room && room->kind == WordKind::room && !room_follows ? *room : Word{WordKind::nuance, "owner"}};
}

// Reads a prompt from its first token to its last.
class Matcher {
  public:
    Matcher(const std::vector<std::string>& tokens, const Tongue& tongue, const FurniturePack* pack)
        : tokens_(tokens), tongue_(tongue), pack_(pack) {
        for (const std::string& t : tokens)
            known_.push_back(t == "," || is_owner(t) || look_up(t, tongue.language) || (pack && pack->class_named(t)));
    }
    Matches run() {
        while (at_ < tokens_.size()) step();
        return std::move(matches_);
    }

  private:
    void step() {
        if (tokens_[at_] == ",") return take({.words = ",", .comma = true}, 1);
        if (auto measure = measure_at(tokens_, at_, tongue_.language))
            return take(std::move(measure->first), measure->second);
        const std::size_t longest = phrase_length(tokens_, at_, kLongestTerm);
        for (std::size_t n = pack_ ? longest : 0; n > 0; --n)
            if (const std::string term = joined(tokens_, at_, n); pack_->names_users(term))
                return take({.words = term, .word = Word{WordKind::object, *pack_->class_named(term)}}, n);
            else if (const auto texture = n > 1 ? pack_->texture_named(term) : std::nullopt)
                return take({.words = term, .word = Word{WordKind::material, *texture}}, n);
        for (std::size_t n = longest; n > 0; --n)
            if (n == 1 && is_owner(tokens_[at_])) return take(owner_at(tokens_, at_, tongue_.language), 1);
            else if (take_term(n)) return;
        for (std::size_t n = pack_ ? longest : 0; n > 0; --n) {
            const std::string term = joined(tokens_, at_, n);
            if (const auto texture = n == 1 ? pack_->texture_named(term) : std::nullopt)
                return take({.words = term, .word = Word{WordKind::material, *texture}}, n);
            if (const auto kind = pack_->class_named(term))
                return take({.words = term, .word = Word{WordKind::object, *kind}}, n);
        }
        take_unknown();
    }

    // A term of n tokens, spelt as in the lexicon, or with other spaces or a typo.
    bool take_term(std::size_t n) {
        const std::string term = joined(tokens_, at_, n);
        if (leads_to_a_place(term, at_ + n) || stands_there(term, at_ + n) || takes_from_the_next(n)) return false;
        if (const auto word = look_up(term, tongue_.language)) return take({.words = term, .word = word}, n), true;
        if (!tongue_.unread.empty()) return false;
        if (n == 1 && known_[at_]) return false;
        if (const auto meant = respelled(term, tongue_.language);
            meant && (n > 1 || !pack_ || !pack_->class_named(term)))
            return take({.words = term, .word = look_up(*meant, tongue_.language)}, n), true;
        if (n == 1) return false;
        const auto begin = static_cast<std::ptrdiff_t>(at_), end = begin + static_cast<std::ptrdiff_t>(n);
        const auto meant = nearest_phrase({tokens_.begin() + begin, tokens_.begin() + end},
                                          {known_.begin() + begin, known_.begin() + end}, tongue_.language);
        if (!meant) return false;
        take({.words = term, .word = look_up(*meant, tongue_.language), .note = "read as \"" + *meant + "\""}, n);
        return true;
    }

    // "lamps on both sides", "lights on the tree": not lamps that are on.
    bool leads_to_a_place(const std::string& term, std::size_t next) const {
        static constexpr std::array<std::string_view, 9> kLeads{"a",      "an",    "the", "both", "each",
                                                                "either", "every", "top", "it"};
        return term.ends_with("s on") && next < tokens_.size() &&
               std::find(kLeads.begin(), kLeads.end(), tokens_[next]) != kLeads.end();
    }

    // "a lamp stands behind it": no lamp stands.
    bool stands_there(const std::string& term, std::size_t next) const {
        static constexpr std::array<std::string_view, 14> kWhere{"behind", "beside",  "next",   "in",      "on",
                                                                 "at",     "by",      "near",   "between", "opposite",
                                                                 "under",  "against", "before", "to"};
        return term.ends_with(" stands") && next < tokens_.size() &&
               std::find(kWhere.begin(), kWhere.end(), tokens_[next]) != kWhere.end();
    }

    // "hanging pendant lights", "dark wood floor lamp": the last word of these n belongs to the piece behind, whose
    // name is two words.
    bool takes_from_the_next(std::size_t n) const {
        if (n < 2 || phrase_length(tokens_, at_, n + 1) <= n) return false;
        const auto all = look_up(joined(tokens_, at_, n)), kind = look_up(joined(tokens_, at_, n - 1)),
                   piece = look_up(joined(tokens_, at_ + n - 1, 2));
        if (!all || !kind || !piece) return false;
        // "a classic wine cellar": no cellar in classic wine, a shade of red.
        if (piece->kind == WordKind::room) return all->kind == WordKind::color && kind->kind == WordKind::style;
        if (piece->kind != WordKind::object) return false;
        if (all->kind != WordKind::object && all->kind != WordKind::structure) return false;
        return kind->kind == WordKind::nuance || kind->kind == WordKind::material || kind->kind == WordKind::color ||
               kind->kind == WordKind::pattern || kind->kind == WordKind::size || kind->kind == WordKind::style;
    }

    void take_unknown() {
        const std::string& token = tokens_[at_];
        if (is_little_word_unread(token, tongue_.unread))
            return take({.words = token, .word = Word{WordKind::function, ""}}, 1);
        if (tongue_.language == "de" && token.size() >= 7 && split_compound(token, matches_)) return void(++at_);
        // "candels": the typo may be in a plural.
        std::vector<std::string> forms = base_forms(token, tongue_.language);
        forms.insert(forms.begin(), token);
        for (const std::string& form : forms)
            if (const auto term = tongue_.unread.empty() && !known_[at_] ? nearest_term(form, tongue_.language)
                                                                         : std::nullopt)
                return take({.words = token,
                             .word = look_up(*term, tongue_.language),
                             .note = "read as \"" + *term + "\"",
                             .plural = form != token},
                            1);
        take({.words = token}, 1);
    }

    void take(Match match, std::size_t tokens) {
        if (match.is(WordKind::other)) match.word.reset();
        matches_.push_back(std::move(match));
        at_ += tokens;
    }

    const std::vector<std::string>& tokens_;
    const Tongue& tongue_;
    const FurniturePack* pack_;
    std::vector<bool> known_;
    std::size_t at_ = 0;
    Matches matches_;
};

}  // namespace

Matches match(const std::vector<std::string>& tokens, const Tongue& tongue, const FurniturePack* pack) {
    return Matcher(tokens, tongue, pack).run();
}

}  // namespace fastscene::reading

// "I want a plant", "the sofa should be green", "it is too dark": the rest of the clause says what is to be done.
#include <algorithm>
#include <array>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/edit_parts.h"

namespace fastscene::editing {
namespace {

// What is to be done about what is too much so.
struct Complaint {
    std::string_view is, make, not_enough;  // "too big": smaller; "not big enough": larger
};
constexpr std::array<Complaint, 22> kComplaints{{
    {"big", "smaller", "larger"},     {"large", "smaller", "larger"},  {"huge", "smaller", "larger"},
    {"small", "larger", "smaller"},   {"tiny", "larger", "smaller"},   {"little", "larger", "smaller"},
    {"long", "shorter", "longer"},    {"short", "longer", "shorter"},  {"tall", "lower", "taller"},
    {"high", "lower", "higher"},      {"low", "higher", "lower"},      {"wide", "narrower", "wider"},
    {"narrow", "wider", "narrower"},  {"deep", "shallower", "deeper"}, {"shallow", "deeper", "shallower"},
    {"thick", "thinner", "thicker"},  {"thin", "thicker", "thinner"},  {"dark", "brighter", "darker"},
    {"bright", "darker", "brighter"}, {"light", "darker", "lighter"},  {"pale", "darker", "lighter"},
    {"gloomy", "brighter", "darker"},
}};

bool is_vague(const std::string& word) { return is_one_of(word, {"close", "near", "far", "much", "a", "so"}); }

bool hangs(Talk& talk, const Words& subject) {
    for (const std::string& id : talk.things(subject))
        if (talk.editor.placed(id).piece.mount != Mount::wall && talk.editor.placed(id).piece.mount != Mount::ceiling)
            return false;
    return true;
}

}  // namespace

bool is_complaint(const std::string& word) {
    return is_vague(word) ||
           std::any_of(kComplaints.begin(), kComplaints.end(), [&](const Complaint& c) { return c.is == word; });
}

namespace {

// "it is too dark", "the sofa is too big for the room", "the desk is not wide enough", "the bed is too close to the
// door"; false: the words are no such thing.
bool complained(Talk& talk, const Words& words) {
    const std::size_t too = find_word(words, {"too", "so", "very", "not"});
    if (too + 1 >= words.size()) return false;
    const auto is_verb = [](const std::string& w) {
        return is_one_of(w, {"is", "are", "looks", "look", "feels", "seems", "hangs", "hang", "stands", "stand", "it's",
                             "its", "a", "bit"});
    };
    Words subject = part_of(words, 0, too);
    if (!subject.empty() && !is_verb(subject.back())) return false;
    while (!subject.empty() && is_verb(subject.back())) subject.pop_back();
    if (subject.empty()) subject = {"it"};
    std::size_t at = too + 1;
    while (at + 1 < words.size() && is_one_of(words[at], {"much", "far", "way", "so", "very", "at", "all"}) &&
           words[at + 1] != "from")
        ++at;
    const bool reversed = words[too] == "not" && words[at] != "too";
    const Words rest = part_of(words, at + 1);
    if (is_one_of(words[at], {"close", "near"}) && !rest.empty()) {
        const Words to = rest.front() == "to" ? part_of(rest, 1) : rest;
        move(talk, joined_words(joined_words(subject, {reversed ? "closer" : "away", reversed ? "to" : "from"}), to));
        return true;
    }
    if (words[at] == "far" && !rest.empty()) {
        const std::size_t from = find_word(rest, {"from"});
        move(talk, joined_words(joined_words(subject, {"closer", "to"}), part_of(rest, from + 1)));
        return true;
    }
    const auto known = std::find_if(kComplaints.begin(), kComplaints.end(),
                                    [&](const Complaint& c) { return c.is == words[at]; });
    if (known == kComplaints.end())
        throw UsageError("expected what it is too (big, small, dark, high, close to the wall …), found \"{}\"",
                         text_of(words, at));
    const std::string value(reversed ? known->not_enough : known->make);
    const Words all = joined_words(subject, {value});
    if (is_one_of(words[at], {"high", "low"}) && hangs(talk, subject)) move(talk, all);
    else make(talk, all);
    return true;
}

}  // namespace

namespace {

Words without_articles(Words words) {
    std::erase_if(words, [](const std::string& w) {
        return is_definite(w) || is_one_of(w, {"a", "an", "new", "some", "down"});
    });
    return words;
}

// "Lay tiles", "carpet on the floor", "marble tiles on the walls": what is covered so; empty: the words are no such
// thing. "Lay a rug" is one.
std::string covered_so(const Talk& talk, const Words& words, Value& value) {
    const auto is_surface = [](const std::string& noun) { return is_one_of(noun, {"wall", "floor", "ceiling"}); };
    std::string surface;
    Words bare = words;
    if (const std::size_t on = find_word(words, {"on", "over", "across"}, 1); on < words.size()) {
        const auto part = room_part(words, on + 1);
        if (!part || part->next != words.size() || !is_surface(part->noun)) return {};
        surface = part->noun, bare.resize(on);
    }
    const bool anew = number_said(bare.front()).has_value();
    for (const std::string& w : bare)
        if (is_surface(noun_of(w))) surface = noun_of(w);
    if (surface.empty() && !anew && is_one_of(talk.said, {"lay", "put down", "lay down"})) surface = "floor";
    bare = without_articles(bare);
    std::erase_if(bare, [&](const std::string& w) { return is_surface(noun_of(w)); });
    const auto said = surface.empty() ? std::nullopt : value_of(bare);
    if (!said || said->looks.material.empty()) return {};
    value = *said;
    return surface;
}

}  // namespace

bool paint_wanted(Talk& talk, const Words& words) {
    Value value;
    if (const std::string surface = covered_so(talk, words, value); !surface.empty())
        return recolor(talk, surface, value), true;
    if (is_one_of(words.back(), {"worktop", "worktops", "countertop", "countertops"}) && words.size() > 1) {
        Words top{"the", words.back()};
        const Words look = without_articles(part_of(words, 0, words.size() - 1));
        if (!look.empty() && value_of(look)) {
            top.insert(top.end(), look.begin(), look.end());
            return make(talk, top), true;
        }
    }
    const PromptSpec spec = read_in_room(talk.editor, text_of(words));
    if (spec.objects.empty() || !is_one_of(spec.objects.front().kind, {"wall", "floor", "ceiling"})) return false;
    value.looks = spec.objects.front();
    if (value.looks.color.empty() && value.looks.material.empty() && value.looks.pattern.empty()) return false;
    // "A dark carpet"
    if (const auto said = value_of(without_articles(words))) value.brighter = said->brighter;
    return recolor(talk, spec.objects.front().kind, value), true;
}

namespace {

// "Each desk should have a book on it", "the sofa needs two cushions": what comes to those; false: no such words.
bool add_to_those(Talk& talk, const Words& words) {
    const std::size_t needs = find_word(words, {"needs", "need", "have", "get", "has"}, 1);
    if (needs + 1 >= words.size()) return false;
    Words thing = part_of(words, 0, needs), what = part_of(words, needs + 1);
    while (thing.size() > 1 && is_one_of(thing.back(), {"should", "must", "shall", "to", "could", "ought"}))
        thing.pop_back();
    if (!begins_anew(what) || is_one_of(what.front(), {"to", "be"}) || value_of(what)) return false;
    // "The girls need a second bed": they are no thing of the room.
    if (words[needs].starts_with("need") && all_named(talk.editor, text_of(thing)).empty() &&
        noun_of(thing.back()).empty())
        return add(talk, what), true;
    const std::size_t place = next_place(what);
    if (place == what.size()) what.push_back("to");
    else if (is_one_of(what.back(), {"it", "them", "top"}) && place + 2 >= what.size()) what.resize(place + 1);
    else return false;
    what.insert(what.end(), thing.begin(), thing.end());
    return add(talk, what), true;
}

}  // namespace

namespace {

// An hour or a weather, and no thing.
bool says_hour(const Words& words) {
    const PromptSpec spec = understand_prompt(text_of(words), false, nullptr);
    return spec.objects.empty() && (!spec.time.empty() || !spec.weather.empty()) && next_place(words) == words.size();
}

}  // namespace

void want(Talk& talk, const Words& words) {
    if (words.empty()) throw UsageError("expected what to change, found the end of the sentence");
    // "A rug is missing under the table"
    if (const std::size_t is = find_word(words, {"is", "are"}, 1);
        is + 1 < words.size() && words[is + 1] == "missing" && !is_definite(words.front()))
        return add(talk, joined_words(part_of(words, 0, is), part_of(words, is + 2)));
    if (made_vaguely(talk, words) || complained(talk, words)) return;
    if (!lamps_said(words).empty()) return make(talk, words);
    const bool of_those = is_definite(words.front()) || is_one_of(words.front(), {"all", "both", "every", "each"});
    if (is_one_of(words.front(), {"can", "could", "may"})) return want(talk, part_of(words, 1));
    // "Darker curtains and a bigger rug", where there are such: those are made so.
    if (const std::vector<Words> parts = parts_of(words); talk.said != "want" && !of_those) {
        const auto made = [&](const Words& part) {
            const std::size_t at = part.size() > 2 && is_one_of(part.front(), {"a", "an"}) ? 1 : 0;
            const bool comparative = part.size() == at + 2 && (part[at].ends_with("er") || part[at] == "more");
            if (!comparative || !value_of({part[at]}) || !noun_of(part.back()).empty()) return Words{};
            const std::size_t there = all_named(talk.editor, "all " + part.back()).size();
            if (there == 0 || (there > 1 && !part.back().ends_with("s"))) return Words{};
            return Words{"the", part.back(), part[at]};
        };
        if (parts.size() > 1 &&
            std::any_of(parts.begin(), parts.end(), [&](const Words& p) { return !made(p).empty(); }))
            return do_each(
                talk.editor, parts.size(),
                [&](std::size_t k) {
                    if (const Words so = made(parts[k]); !so.empty()) make(talk, so);
                    else want(talk, parts[k]);
                },
                [&](std::size_t k) { return text_of(parts[k]); });
        if (parts.size() == 1 && !made(words).empty()) return make(talk, made(words));
    }
    // "I need a bigger desk", where there is one: that is made larger.
    if (words.size() > 2 && is_one_of(words.front(), {"a", "an"}) && talk.said != "want" &&
        parts_of(words).front().size() > 2 && next_place(words) >= parts_of(words).front().size()) {
        const Words first = parts_of(words).front();
        const auto value = value_of({first[1]});
        const Words noun = part_of(first, 2);
        if (value && value->resizes() && value->shape.empty() && all_named(talk.editor, text_of(noun)).size() == 1) {
            Words rest = part_of(words, first.size());
            while (!rest.empty() && is_joint(rest.front())) rest.erase(rest.begin());
            return do_each(
                talk.editor, rest.empty() ? 1 : 2,
                [&](std::size_t k) {
                    if (k == 0) make(talk, joined_words(joined_words({"the"}, noun), {first[1]}));
                    else add(talk, rest);
                },
                [&](std::size_t k) { return text_of(k == 0 ? first : rest); });
        }
    }
    // "Late afternoon light", "a rainy evening"
    if (const std::vector<Words> parts = parts_of(words); !of_those && parts.size() > 1 && says_hour(parts.front()))
        return do_each(
            talk.editor, parts.size(), [&](std::size_t k) { want(talk, parts[k]); },
            [&](std::size_t k) { return text_of(parts[k]); });
    // "A darker floor"
    if (words.size() == 3 && is_one_of(noun_of(words.back()), {"floor", "wall", "ceiling"}) &&
        is_one_of(words[1], {"darker", "lighter", "brighter"}))
        return make(talk, {"the", words[2], words[1]});
    if (!of_those && says_hour(words)) return make(talk, joined_words({"it"}, words));
    if (!of_those) return add(talk, words);
    if (find_word(words, {"style", "time", "weather"}) < words.size() ||
        words[std::min<std::size_t>(1, words.size() - 1)] == "room")
        return make(talk, words);
    if (add_to_those(talk, words)) return;
    std::size_t mark = find_word(words, {"should", "must", "shall", "needs", "need", "has", "have", "ought", "be"}, 1);
    if (mark == words.size()) mark = std::min(find_word(words, {"to"}, 1), mark);
    std::size_t next = mark;
    while (next < words.size() &&
           is_one_of(words[next], {"should", "must", "shall", "needs", "need", "has", "have", "ought", "to", "be",
                                   "look", "become", "go", "stand", "move", "hang", "moved", "placed"}) &&
           !(words[next] == "to" && next + 1 < words.size() && is_definite(words[next + 1])))
        ++next;
    const Words thing = part_of(words, 0, mark), rest = part_of(words, next);
    Words all = thing;
    all.insert(all.end(), rest.begin(), rest.end());
    if (!rest.empty() && is_one_of(rest.front(), {"gone", "removed", "away", "deleted"})) return remove(talk, thing);
    if (!rest.empty() && is_one_of(rest.front(), {"face", "facing"})) return face(talk, all);
    // "The desk in the middle, facing the door"
    if (const std::size_t facing = find_word(all, {"facing"}, 2); facing < all.size() && next_place(all) < facing)
        return move(talk, all);
    for (std::size_t i = 1; i < all.size(); ++i)
        if (value_of(part_of(all, i))) return make(talk, all);
    if (next_place(all) < all.size()) return move(talk, all);
    make(talk, all);
}

}  // namespace fastscene::editing

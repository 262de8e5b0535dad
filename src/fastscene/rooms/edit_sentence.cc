// Edits in words: each clause by its verb.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_parts.h"
#include "fastscene/rooms/plan.h"
#include "fastscene/rooms/prompt_text.h"

namespace fastscene {
namespace editing {
namespace {

[[noreturn]] void refuse(const Clause& clause) {
    const std::string all = clause.said + (clause.words.empty() ? "" : " " + text_of(clause.words));
    if (is_one_of(clause.said, {"open", "close", "shut"}) &&
        find_word(clause.words, {"door", "window", "doors", "windows"}) < clause.words.size())
        refuse_shell();
    throw UsageError(
        "a sentence moves, adds, removes, replaces, turns, recolors or resizes the things that it names; \"{}\" says "
        "none of that",
        all);
}

}  // namespace

// ---- shared

std::string asked_kind(const Placed& p) { return p.wish.kind.empty() ? p.piece.kind : p.wish.kind; }

std::size_t find_word(const Words& words, std::initializer_list<std::string_view> any, std::size_t from) {
    for (std::size_t i = from; i < words.size(); ++i)
        if (std::find(any.begin(), any.end(), words[i]) != any.end()) return i;
    return words.size();
}

void add_new(std::vector<std::string>& to, const std::vector<std::string>& more) {
    for (const std::string& id : more)
        if (std::find(to.begin(), to.end(), id) == to.end()) to.push_back(id);
}

std::vector<std::string> Talk::things(const Words& said_words) {
    Words words = said_words;
    // "them all", "both of them", "all of those"
    if (words.size() > 1 && words.size() < 4 && find_word(words, {"them", "it", "those", "these"}) < words.size() &&
        std::all_of(words.begin(), words.end(), [](const std::string& w) {
            return is_one_of(w, {"them", "it", "those", "these", "all", "both", "of", "each"});
        }))
        words = {"them"};
    if (words.size() == 1 && is_one_of(words.front(), {"it", "them", "they", "that", "those", "these"})) {
        if (last.empty() && !unclear.empty()) throw UsageError("{}", unclear);
        if (last.empty()) throw UsageError("what is \"{}\"? nothing was named before", words.front());
        return last;
    }
    // "the shelf next to it"
    if (words.size() > 2 && is_one_of(words.back(), {"it", "them"}) && next_place(words) + 1 < words.size() &&
        last.size() == 1) {
        words.back() = last.front();
        return things(words);
    }
    // "its chairs": those that stand at it or on it.
    if (words.size() > 1 && is_one_of(words.front(), {"its", "their"})) {
        if (last.empty()) throw UsageError("whose is \"{}\"? nothing was named before", text_of(words));
        std::vector<std::string> ids;
        for (const int i : all_named(editor, "all " + text_of(words, 1))) {
            const DocumentThing& t = editor.document().things[static_cast<std::size_t>(i)];
            if (is_among(t.on, last) || is_among(t.with, last)) ids.push_back(t.id);
        }
        if (ids.empty()) throw UsageError("nothing at {} is \"{}\"", last.front(), text_of(words, 1));
        return last = ids;
    }
    // "the first one"
    const bool but_one = words.size() > 1 && is_one_of(words[words.size() - 2], {"except", "but"});
    if (words.size() > 1 && is_one_of(words.back(), {"one", "ones"}) && !noun.empty() && !but_one) {
        Words all = words;
        all.back() = noun;
        return things(all);
    }
    if (says_all_but_some(words)) {
        Words all{"all"};
        all.insert(all.end(), words.begin() + 3, words.end());
        return last = all_but(all, {words[2]});
    }
    if (const auto riders = all_that_stands_on(*this, words)) return last = *riders;
    if (const auto rest = the_rest(words)) return last = *rest;
    const std::size_t except = find_word(words, {"except", "but", "excluding", "besides"}, 1);
    if (except + 1 < words.size()) return last = all_but(part_of(words, 0, except), part_of(words, except + 1));
    // "the other lights": all that shine, but those that were spoken of.
    if (find_word(words, {"other"}) < words.size() && is_one_of(words.back(), {"lights", "lamps"})) {
        std::vector<std::string> ids;
        for (const Placed& p : editor.room().furnished.placed)
            if (has_role(p.piece.kind, Role::light) && can_shine(p) && !is_among(p.id, last)) ids.push_back(p.id);
        if (!ids.empty()) return last = ids;
    }
    // "the other armchair": not that one which was spoken of.
    if (const std::size_t other = find_word(words, {"other"}); other < words.size() && !last.empty()) {
        std::vector<std::string> ids;
        for (const int i : all_named(editor, text_of(words)))
            ids.push_back(editor.document().things[static_cast<std::size_t>(i)].id);
        std::erase_if(ids,
                      [&](const std::string& id) { return std::find(last.begin(), last.end(), id) != last.end(); });
        if (ids.size() == 1) return last = ids;
    }
    last = named(editor, text_of(words));
    noun = in_words(asked_kind(editor.placed(last.front())));
    return last;
}

// "The rest", "the other ones", "the remaining chairs": of what was last spoken of by name, those that were not meant.
std::optional<std::vector<std::string>> Talk::the_rest(const Words& words) const {
    const bool bare = is_one_of(text_of(words),
                                {"the rest", "the others", "the rest of them", "the other ones", "the remaining ones",
                                 "the ones left", "all the others", "the ones that are left", "the remaining"});
    const bool named_so = words.size() > 2 && words.front() == "the" && words[1] == "remaining";
    if (!named_so && (!bare || noun.empty())) return {};
    const Words of = named_so ? part_of(words, number_said(words[2]) ? 3 : 2) : tokens_of(noun);
    std::vector<std::string> ids;
    for (const int i : all_named(editor, "all " + text_of(of)))
        if (const std::string& id = editor.document().things[static_cast<std::size_t>(i)].id; !is_among(id, last))
            ids.push_back(id);
    if (ids.empty()) throw UsageError("nothing is left that \"{}\" could be", text_of(words));
    return ids;
}

// "all pictures except the largest one"
std::vector<std::string> Talk::all_but(const Words& words, Words others) {
    std::vector<std::string> ids = things(words);
    if (!others.empty() && is_one_of(others.front(), {"for", "not"})) others.erase(others.begin());
    // "all chairs but one", "… but two of them": "a chair" is the last one, and the first ones stay.
    if (const auto some = others.empty() ? std::nullopt : number_said(others.front());
        some && *some >= 1 && (others.size() == 1 || text_of(others, 1) == "of them")) {
        const auto left = static_cast<std::size_t>(*some);
        if (left >= ids.size()) throw AlreadySo(fmt::format("there are only {} of \"{}\"", ids.size(), text_of(words)));
        return {ids.begin() + static_cast<std::ptrdiff_t>(left), ids.end()};
    }
    // "the largest one", "the one above the bed"
    if (const std::size_t one = find_word(others, {"one", "ones"}, others.size() > 1 ? 1 : 0);
        one < others.size() && !(one + 1 < others.size() && others[one + 1] == "of"))
        others[one] = others[one] == "one" ? singular(words.back()) : words.back();
    const std::vector<std::string> left = things_of_parts(others);
    std::erase_if(ids, [&](const std::string& id) { return std::find(left.begin(), left.end(), id) != left.end(); });
    if (ids.empty()) throw UsageError("nothing but {} is meant by \"{}\"", left.front(), text_of(words));
    return ids;
}

std::vector<std::string> Talk::things_of_parts(const Words& words) {
    std::vector<std::string> ids;
    for (const Words& part : parts_of(with_its(words))) add_new(ids, things(part));
    if (ids.empty()) throw UsageError("expected a thing of the room, found the end of the sentence");
    return last = ids;
}

namespace {

// "lower the lamp": down.
Words lowered(const Clause& clause) {
    Words out = clause.words;
    Words bare = out;
    const bool by_length = take_length(bare).has_value();  // "by 20 cm"
    if (by_length && !bare.empty() && bare.back() == "by") bare.pop_back();
    if (is_one_of(clause.said, {"lower", "raise", "lift"}) && next_place(bare) == bare.size())
        out.push_back(clause.said == "lower" ? "down" : "up");
    return out;
}

// "Raise the desk by 20 cm": what stands on the floor is taller by that; false: no such words.
bool made_taller(Talk& talk, const Clause& clause) {
    Words bare = clause.words;
    const bool by_length = take_length(bare).has_value();
    if (by_length && !bare.empty() && bare.back() == "by") bare.pop_back();
    if (!is_one_of(clause.said, {"lower", "raise", "lift"}) || bare.empty() || next_place(bare) < bare.size())
        return false;
    const std::vector<std::string> ids = talk.things_of_parts(bare);
    if (!std::all_of(ids.begin(), ids.end(),
                     [&](const std::string& id) { return talk.editor.placed(id).piece.mount == Mount::floor; }))
        return false;
    bare.push_back(clause.said == "lower" ? "lower" : "taller");
    const Words length = part_of(clause.words, bare.size() - 1);
    return make(talk, joined_words(bare, length)), true;
}

// What lies about on the floor, or of what is named that which does; a sentence does not guess what else is too much.
void tidy(Talk& talk, const Clause& clause) {
    Words bare = clause.words;
    std::erase_if(bare, [](const std::string& w) {
        return is_definite(w) || is_one_of(w, {"up", "a", "bit", "room"});
    });
    const bool named_some = !bare.empty() && bare != Words{"floor"};
    std::vector<std::string> litter;
    for (const int i : named_some ? all_named(talk.editor, "all " + text_of(bare)) : std::vector<int>{}) {
        const Placed& p = talk.editor.room().furnished.placed[static_cast<std::size_t>(i)];
        if (p.on < 0 && p.sill < 0 && furnishing::is_small(p.piece.kind)) litter.push_back(p.id);
    }
    for (const DocumentThing& t : talk.editor.document().things)
        if (!named_some && has_role(t.kind, Role::litter) && t.on.empty()) litter.push_back(t.id);
    if (litter.empty())
        throw UsageError(
            "\"{}\" takes away what lies about on the floor{}; \"clear the desk\" takes away what stands "
            "on it, \"remove the books\" what it names",
            clause.said, litter.empty() ? ", where nothing lies about" : "");
    remove_all(talk, litter);
}

// "Enlarge the rug by 20 percent": larger by that.
Words with_word(Words words, const std::string& word) {
    const std::size_t by = find_word(words, {"by"}, 1);
    words.insert(words.begin() + static_cast<std::ptrdiff_t>(by), word);
    return words;
}

// "Tile the walls", "tile the floor blue", "carpet the room": with that.
Words covered(const Clause& clause) {
    Words out = clause.words;
    if (!is_one_of(clause.said, {"tile", "carpet", "plaster"})) return out;
    if (noun_of(out.back()) == "room") out = clause.said == "plaster" ? Words{"the", "walls"} : Words{"the", "floor"};
    for (std::size_t i = 1; i < out.size(); ++i)
        if (const auto value = value_of(part_of(out, i)); value && !value->looks.material.empty()) return out;
    out.push_back(clause.said);
    return out;
}

// "widen the rug": wider.
std::string size_word(const Clause& clause) {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kWays{{{"widen", "wider"},
                                                                                         {"lengthen", "longer"},
                                                                                         {"extend", "longer"},
                                                                                         {"heighten", "taller"},
                                                                                         {"shorten", "shorter"},
                                                                                         {"narrow", "narrower"}}};
    for (const auto& [verb, word] : kWays)
        if (clause.said == verb) return std::string(word);
    return clause.verb == Verb::larger ? "larger" : "smaller";
}

// "Arrange the chairs to face the piano"
bool to_face(const Words& words) {
    const std::size_t face = find_word(words, {"face"}, 2);
    return face < words.size() && words[face - 1] == "to" && is_definite(words.front()) &&
           next_place(words) == face - 1;
}

// "The lights", "the floor lamp"
bool has_lights(const Talk& talk, const Words& words) {
    const std::vector<int> found = all_named(talk.editor, text_of(words));
    return is_one_of(words.back(), {"lights", "lamps", "lighting"}) ||
           (!found.empty() && std::all_of(found.begin(), found.end(), [&](int i) {
               return has_role(talk.editor.room().furnished.placed[static_cast<std::size_t>(i)].piece.kind,
                               Role::light);
           }));
}

// "Throw a blanket over the sofa", "drop a rug by the bed": something new, put somewhere.
bool comes(const Clause& clause) {
    constexpr std::string_view kThrown = "|throw|drop|chuck|";
    const std::size_t place = next_place(clause.words);
    return kThrown.find("|" + clause.said + "|") != kThrown.npos && place < clause.words.size() &&
           begins_anew(clause.words) && !is_one_of(clause.words[place], {"from", "off", "away"});
}

bool says_value(const Words& words) {
    for (std::size_t i = 1; i < words.size(); ++i)
        if (value_of(part_of(words, i)) || is_one_of(words[i], {"to", "into"})) return true;
    return lamps_said(words) != "";
}

}  // namespace

namespace {

// "take the vase off the table and put it on the cabinet": nothing goes; false: no such words.
bool picked_up(Talk& talk, const Clause& clause, const Clause& next) {
    if (clause.said != "take" || (next.verb != Verb::put && next.verb != Verb::move) || next.words.empty() ||
        !is_one_of(next.words.front(), {"it", "them"}))
        return false;
    Words words = clause.words;
    for (std::size_t i = 1; i < words.size(); ++i)
        if (is_one_of(words[i], {"off", "from"})) words[i] = "on";
    talk.things_of_parts(words);
    return true;
}

}  // namespace

namespace {

// "Bigger so six people fit": why, which changes nothing. Where it begins.
std::size_t purpose_at(const Clause& clause) {
    const bool states = clause.verb == Verb::make || clause.verb == Verb::larger || clause.verb == Verb::smaller ||
                        clause.verb == Verb::add || clause.verb == Verb::replace || clause.verb == Verb::color ||
                        clause.verb == Verb::remove;
    const std::size_t so = find_word(clause.words, {"so", "because"}, 2);
    return states && so + 2 < clause.words.size() ? so : clause.words.size();
}

}  // namespace

void Talk::act(const Clause& whole) {
    Clause clause = whole;
    if (const std::size_t why = purpose_at(whole); why < whole.words.size()) {
        editor.note("room", fmt::format("\"{}\" is taken as a reason: it changes nothing", text_of(whole.words, why)));
        clause.words.resize(why);
    }
    const Words& words = clause.words;
    // "Rearrange the chairs in a circle" says how.
    if (clause.said == "rearrange" && (says_so_that(words) || next_place(words) < words.size()))
        clause.verb = Verb::put, clause.said = "arrange";
    if (clause.verb == Verb::refuse) refuse(clause);
    if (clause.verb == Verb::tidy) return tidy(*this, clause);
    if (clause.verb == Verb::remark) return remark(*this, clause.words);
    there = clause.there, its_place = clause.its_place, said = clause.said;
    more = find_word(words, {"more", "another", "additional", "extra"}) < words.size();
    if (words.empty())
        throw UsageError("expected what to change after \"{}\", found the end of the sentence", clause.said);
    const std::size_t end = next_place(words), instead = find_word(words, {"instead"}, 1);
    if (instead + 2 < words.size() && words[instead + 1] == "of") {
        // "… instead of the pendant, and two more chairs": those come as well.
        Words rest = part_of(words, instead + 2);
        const auto joint = std::find_if(rest.begin(), rest.end(), is_joint);
        std::size_t next = static_cast<std::size_t>(joint - rest.begin());
        while (next < rest.size() && is_joint(rest[next])) ++next;
        if (next < rest.size() && begins_anew(part_of(rest, next))) {
            Clause first = clause, second = clause;
            first.words = part_of(
                words, 0, static_cast<std::size_t>(instead + 2 + static_cast<std::size_t>(joint - rest.begin())));
            second.verb = Verb::add, second.said = "add", second.words = part_of(rest, next);
            return do_each(
                editor, 2, [&](std::size_t k) { act(k == 0 ? first : second); },
                [&](std::size_t k) { return text_of(k == 0 ? first.words : second.words); });
        }
        const Words old = instead_of(rest, words), by = part_of(words, 0, instead);
        if (next_place(by) == by.size()) return replace(*this, old, by);
        return editor.together([&] {
            remove(*this, old);
            add(*this, by);
        });
    }
    const bool stands = clause.verb == Verb::put || clause.verb == Verb::move || clause.verb == Verb::line;
    if (stands && arrange(*this, words)) return;
    if (put_where(*this, clause) || done_with(*this, clause)) return;
    switch (clause.verb) {
        case Verb::remove:
            if (comes(clause)) return put(*this, words);
            // "take the vase to the desk"
            if (clause.said == "take" && end < words.size() && is_one_of(words[end], {"to", "into", "onto"}))
                return move(*this, words);
            return remove(*this, words);
        case Verb::clear:
            if (remove_everything(*this, words)) return;
            return clear(*this, words.back() == "off" ? part_of(words, 0, words.size() - 1) : words);
        case Verb::move:
            if (says_so_that(words)) return turn(*this, words);
            if (to_face(words)) return face(*this, words);
            // "Move the bicycle out": it goes.
            if (words.size() > 1 && words.back() == "out" && is_one_of(said, {"move", "carry", "bring"}))
                return remove(*this, words);
            if (made_taller(*this, clause)) return;
            return move(*this, lowered(clause));
        case Verb::put:
            if (says_so_that(words)) return turn(*this, words);
            if (to_face(words)) return face(*this, words);
            return put(*this, words);
        case Verb::add:
            // "get the sofa out", "the plants to the window" stand already
            return add(*this, words);
        case Verb::want: return want(*this, words);
        case Verb::replace: {
            const std::size_t with = find_word(words, {"with", "for", "by"});
            if (with + 1 >= words.size())
                throw UsageError("expected \"replace … with …\", found \"{}\"", text_of(words));
            return replace(*this, part_of(words, 0, with), part_of(words, with + 1));
        }
        case Verb::swap: return swap(*this, words);
        case Verb::turn:
            if (const std::size_t down = find_word(words, {"down", "up"}, 1);
                down < words.size() && has_lights(*this, part_of(words, 0, down)))
                return make(*this, with_word(part_of(words, 0, down), words[down] == "down" ? "dimmer" : "brighter"));
            if (!lamps_said(words).empty() || each_on_or_off(words)) return make(*this, words);
            return turn(*this, words);
        case Verb::face: return face(*this, words);
        case Verb::make:
            // "switch the sofa and the armchair"
            if (clause.said == "switch" && !says_value(words) && !each_on_or_off(words) &&
                (parts_of(words).size() == 2 || find_word(words, {"with"}, 1) < words.size()))
                return swap(*this, words);
            return make(*this, words);
        case Verb::color: return make(*this, covered(clause));
        case Verb::larger:
        case Verb::smaller: return make(*this, with_word(words, size_word(clause)));
        case Verb::brighter: return make(*this, with_word(words, "brighter"));
        case Verb::darker: return make(*this, with_word(words, clause.said == "dim" ? "dimmer" : "darker"));
        case Verb::center: {
            if (editing::center(*this, words)) return;
            Words all = words;
            if (next_place(all) == all.size()) all.insert(all.end(), {"in", "the", "middle"});
            return put(*this, all);
        }
        case Verb::copy: return copy(*this, words);
        case Verb::keep: return keep(*this, words);
        case Verb::line: return line_up(*this, words);
        case Verb::kindle:
        case Verb::quench: {
            Words all = words;
            all.push_back(clause.verb == Verb::kindle ? "on" : "off");
            return make(*this, all);
        }
        case Verb::tidy:
        case Verb::refuse:
        case Verb::remark:
        case Verb::none: break;
    }
}

}  // namespace editing

EditResult edit_by_sentence(const RoomDocument& document, const std::string& sentence,
                            std::shared_ptr<const FurniturePack> pack, const Run& run) {
    check_prompt(sentence);
    editing::Editor editor(document, std::move(pack), run);
    editing::Talk talk{editor};
    const std::vector<editing::Clause> clauses = editing::clauses_of(sentence);
    editing::do_each(
        editor, clauses.size(),
        [&](std::size_t i) {
            if (i + 1 < clauses.size() && editing::picked_up(talk, clauses[i], clauses[i + 1])) return;
            if (clauses[i].taken_back) return editing::take_back(talk, clauses[i]);
            const std::vector<std::string> spoken = talk.last;
            try {
                talk.act(clauses[i]);
            } catch (const Error&) {
                // What should have come is not "it", unless it was to come at "it".
                const bool at_it = editing::find_word(clauses[i].words, {"it", "its", "them", "their"}) <
                                   clauses[i].words.size();
                if (editing::begins_anew(clauses[i].words)) talk.last = at_it ? spoken : std::vector<std::string>{};
                throw;
            }
        },
        [&](std::size_t i) {
            // "The lamp is too low" is said so.
            const bool bare = clauses[i].verb == editing::Verb::want && clauses[i].said == "want";
            return (bare ? "" : clauses[i].said + " ") + editing::text_of(clauses[i].words);
        });
    editing::check_kept(talk, document);
    for (const EditChange& change : editor.result().changes)
        if (change.id == kNotDone) run.warn(fmt::format("{}: {}", change.id, change.what));
    return editor.result();
}

}  // namespace fastscene

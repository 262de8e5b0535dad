// Edits in words: each clause by its verb.
#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <array>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_audit.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_parts.h"
#include "fastscene/rooms/lexicon.h"
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

namespace {

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

// "take the vase off the table and put it on the cabinet", "tidy up the toys and put …": nothing goes; false: not so.
bool picked_up(Talk& talk, const Clause& clause, const Clause& next) {
    const bool tidied = clause.verb == Verb::tidy && !clause.words.empty() && is_definite(clause.words.front());
    if ((clause.said != "take" && !tidied) || (next.verb != Verb::put && next.verb != Verb::move) ||
        next.words.empty() || !is_one_of(next.words.front(), {"it", "them"}))
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
    const std::size_t so = find_word(clause.words, {"so", "because"}, 1);
    return states && so + 2 < clause.words.size() ? so : clause.words.size();
}

}  // namespace

namespace {

// "The chairs around a new table": first the table; false: no such words.
bool at_what_comes(Talk& talk, const Clause& clause) {
    const Words& words = clause.words;
    if ((clause.verb != Verb::put && clause.verb != Verb::move) || begins_anew(words)) return false;
    std::size_t at = 2;
    const auto begins = [&](std::size_t i) {
        for (std::size_t r = 1; r < i; ++r)
            if (const auto relation = relation_at(words, r); relation && relation->next == i) return true;
        return false;
    };
    while (at + 2 < words.size() && !(is_one_of(words[at], {"a", "an"}) && words[at + 1] == "new" && begins(at))) ++at;
    if (at + 2 >= words.size()) return false;
    std::size_t end = at;
    while (end < words.size() && !is_joint(words[end])) ++end;
    talk.editor.together([&] {
        const std::vector<std::string> spoken = talk.last;
        add(talk, part_of(words, at, end));
        Clause there = clause;
        there.words = joined_words(joined_words(part_of(words, 0, at), {talk.last.back()}), part_of(words, end));
        talk.last = spoken;
        talk.act(there);
    });
    return true;
}

// "The armchair by the window with a small side table": that comes beside it; false: no such words.
bool moved_with_new(Talk& talk, const Clause& clause) {
    const Words& words = clause.words;
    const std::size_t with = find_word(words, {"with"}, 3);
    if ((clause.verb != Verb::put && clause.verb != Verb::move) || with + 2 >= words.size() ||
        !is_definite(words.front()) || !is_one_of(words[with + 1], {"a", "an"}) || parts_of(words).size() > 1 ||
        next_place(words) >= with || next_place(part_of(words, with + 1)) < words.size() - with - 1)
        return false;
    const auto noun = look_up(words.back());
    if (!noun || noun->kind != WordKind::object || noun->far || is_a_part(words.back())) return false;
    do_each(
        talk.editor, 2,
        [&](std::size_t k) {
            Clause first = clause;
            first.words = part_of(words, 0, with);
            if (k == 0) return talk.act(first);
            talk.said = "add";
            add(talk, joined_words(part_of(words, with + 1), {"next", "to", "it"}));
        },
        [&](std::size_t k) { return k == 0 ? text_of(words, 0, with) : text_of(words, with); });
    return true;
}

}  // namespace

void Talk::act(const Clause& whole) {
    if (at_what_comes(*this, whole)) return;
    Clause clause = whole;
    if (const std::size_t why = purpose_at(whole); why < whole.words.size()) {
        if (const int guests = guests_said(part_of(whole.words, why)); guests > 0) {
            const Words so = part_of(whole.words, why), rest = part_of(whole.words, 0, why);
            const auto seats = look_up(rest.back());
            // "Add chairs so that twelve people fit": as many as that takes.
            if (clause.verb == Verb::add && seats && has_role(seats->meaning, Role::seat) && !number_said(rest.front()))
                return seat_guests(*this, whole.words, guests);
            return do_each(
                editor, 2,
                [&](std::size_t k) {
                    Clause first = clause;
                    first.words = rest;
                    if (k == 0) act(first);
                    else seat_guests(*this, joined_words(rest, so), guests);
                },
                [&](std::size_t k) { return text_of(k == 0 ? rest : so); });
        }
        editor.note("room", fmt::format("\"{}\" is taken as a reason: it changes nothing", text_of(whole.words, why)));
        clause.words.resize(why);
    }
    // "The table round for six people": that, and seats for as many.
    if (const std::size_t whom = find_word(whole.words, {"for"}, 2);
        clause.verb == Verb::make && whom + 1 < whole.words.size() && says_value(part_of(whole.words, 0, whom)))
        if (const int guests = guests_said(joined_words({"seating"}, part_of(whole.words, whom))); guests > 0)
            return do_each(
                editor, 2,
                [&](std::size_t k) {
                    Clause first = clause;
                    first.words = part_of(whole.words, 0, whom);
                    if (k == 0) act(first);
                    else seat_guests(*this, first.words, guests);
                },
                [&](std::size_t k) {
                    return k == 0 ? text_of(whole.words, 0, whom) : text_of(part_of(whole.words, whom));
                });
    if (moved_with_new(*this, whole)) return;
    // "Remove the shelf and put a plant in that corner": where it stood.
    if (const std::size_t n = clause.words.size(); n > 4 && last_gone &&
                                                   text_of(clause.words, n - 3, n - 1) == "in that" &&
                                                   is_one_of(clause.words.back(), {"corner", "spot", "place", "space"}))
        clause.words.resize(n - 3), clause.there = true;
    const Words& words = clause.words;
    // "I want eight people to sit at the table", "make room for eight at the table"
    const std::size_t whom = find_word(words, {"for"});
    const bool new_table = begins_anew(words) && whom < words.size() && find_word(words, {"table"}) < whom;
    const bool seats = find_word(words, {"chairs", "stools", "armchairs", "benches"}) <
                       find_word(words, {"people", "guests", "seating", "room"});
    if (const int guests = new_table || seats ? 0 : guests_said(words);
        guests > 0 && (clause.verb == Verb::want || clause.verb == Verb::make || clause.verb == Verb::add))
        return seat_guests(*this, words, guests);
    // "A basket on top": of what was spoken of.
    if (const std::size_t n = words.size(); n > 2 && words[n - 2] == "on" && words[n - 1] == "top" && !last.empty() &&
                                            find_word(words, {"with"}, 1) == n && begins_anew(words))
        clause.words.back() = "it";
    // "It is too far from the sofa, bring it closer": to that.
    if ((clause.verb == Verb::move || clause.verb == Verb::put) && words.size() > 1) {
        const std::string& way = words.back();
        if (!too_far.empty() && is_one_of(way, {"closer", "nearer"}))
            clause.words = joined_words(joined_words(clause.words, {"to"}), std::exchange(too_far, {}));
        else if (!too_near.empty() && is_one_of(way, {"away", "further", "farther", "off"}))
            clause.words = joined_words(joined_words(part_of(clause.words, 0, words.size() - 1), {"away", "from"}),
                                        std::exchange(too_near, {}));
    }
    // "Clear the table and put a bowl in the middle": of what was cleared.
    if (const std::size_t n = words.size(); n > 4 && (clause.verb == Verb::put || clause.verb == Verb::add) &&
                                            begins_anew(words) && !last_gone_from.empty() &&
                                            text_of(words, n - 3) == "in the middle" && next_place(words) == n - 3)
        clause.words.insert(clause.words.end(), {"of", last_gone_from});
    // "Rearrange the chairs in a circle" says how.
    if (clause.said == "rearrange" && (says_so_that(words) || next_place(words) < words.size()))
        clause.verb = Verb::put, clause.said = "arrange";
    if (clause.verb == Verb::refuse) refuse(clause);
    if (clause.verb == Verb::tidy) return tidy(*this, clause);
    if (clause.verb == Verb::remark) return remark(*this, clause.words);
    there = clause.there, its_place = clause.its_place, said = clause.said;
    if (!has_word(words, {"all"})) more_came = false;
    more = find_word(words, {"more", "another", "additional", "extra"}) < words.size();
    more_came = more_came || more;
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
            remove_all(*this, those_instead(*this, old, by));
            add(*this, by);
        });
    }
    const bool stands = clause.verb == Verb::put || clause.verb == Verb::move || clause.verb == Verb::line;
    if (stands && arrange(*this, words)) return;
    const bool forms = clause.verb == Verb::make && find_word(words, {"rows"}, 1) < words.size();
    if ((stands || forms || clause.verb == Verb::add) && set_in_rows(*this, words)) return;
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
            // "The lamp with three pendants over the island"
            const Words old = part_of(words, 0, with), by = part_of(words, with + 1);
            const std::size_t place = next_place(by);
            const auto at = place < by.size() ? relation_at(by, place) : std::nullopt;
            if (at && is_one_of(at->name, {"above", "next to", "under", "in front of", "in the corner"}) &&
                begins_anew(by) && !has_word(by, {"with"}))
                return editor.together([&] {
                    remove(*this, old);
                    add(*this, by);
                });
            return replace(*this, old, by);
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
            // "Change the pendant lamp for a chandelier"
            if (const std::size_t by = find_word(words, {"for"}, 1); is_one_of(clause.said, {"change", "switch"}) &&
                                                                     by + 1 < words.size() &&
                                                                     begins_anew(part_of(words, by + 1)))
                return replace(*this, part_of(words, 0, by), part_of(words, by + 1));
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
    std::size_t deeds = 0;  // before the clause before
    editing::do_each(
        editor, clauses.size(),
        [&](std::size_t i) {
            if (i + 1 < clauses.size() && editing::picked_up(talk, clauses[i], clauses[i + 1])) return;
            if (clauses[i].taken_back) return editing::take_back(talk, clauses[i]);
            // "Declutter: remove the books"
            if (clauses[i].verb == editing::Verb::tidy && clauses[i].words.empty() && i + 1 < clauses.size()) return;
            const std::vector<std::string> spoken = talk.last;
            if (clauses[i].otherwise && editor.deeds() > deeds) {
                editor.note("room", fmt::format("\"{} {}\" is the other choice: it was not needed", clauses[i].said,
                                                editing::text_of(clauses[i].words)));
                return;
            }
            deeds = editor.deeds();
            try {
                const editing::Snapshot before = editing::snapshot_of(talk);
                talk.act(clauses[i]);
                editing::audit(talk, clauses[i], before);
            } catch (const editing::AlreadySo&) {
                throw;
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

// "a floor lamp beside the bed", "the sofa with two armchairs": what comes new, and what changes places.
#include <algorithm>
#include <utility>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_parts.h"
#include "fastscene/rooms/layout_relations.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/prompt_text.h"

namespace fastscene::editing {
namespace {

// What comes with what was added: "two nightstands with a lamp on each" are two lamps.
void add_with(Talk& talk, const std::vector<std::string>& ids, const Addition& addition) {
    const std::vector<PromptObject>& wishes = addition.wishes;
    const auto at = [&](const std::string& id, const std::string& relation) {
        Place out;
        out.step.wish.relation = relation, out.step.wish.relation_to = asked_kind(talk.editor.placed(id));
        out.step.at = {id};
        return out;
    };
    const std::size_t first = std::min<std::size_t>(1, wishes.size());
    do_each(
        talk.editor, wishes.size() - first,
        [&](std::size_t k) {
            const PromptObject& wish = wishes[k + first];
            const std::string relation = addition.on_it ? "on" : wish.relation;
            if (ids.empty() ||
                (ids.size() > 1 && !addition.each && !addition.on_it && (relation != "on" || wish.count > 1)))
                return add_or_stand(talk, wish, {});
            do_each(talk.editor, ids.size(), [&](std::size_t i) { add_or_stand(talk, wish, at(ids[i], relation)); });
        },
        [&](std::size_t k) { return wishes[k + first].words; });
}

// "It" is what was last put somewhere, or that at which it was put: where the first has no place for it, the other.
std::optional<Addition> at_the_other(const Talk& talk, const Words& words, const std::vector<std::string>& spoken) {
    if (!is_one_of(words.back(), {"it", "them"}) || talk.last_place.wish.relation_to.empty()) return {};
    const std::vector<std::string> others = things_at(talk.editor, talk.last_place);
    if (others.empty() || others == spoken) return {};
    // What is to lie on a shelf lies there or nowhere; a mirror carries nothing.
    constexpr float kCarries = 0.08f;  // metres deep
    const bool carrier = std::any_of(spoken.begin(), spoken.end(), [&](const std::string& id) {
        const Placed& p = talk.editor.placed(id);
        return p.piece.size_m.z > kCarries && !p.flat && !has_role(p.piece.kind, Role::seat);
    });
    if (carrier && words.size() > 1 && words[words.size() - 2] == "on") return {};
    Addition out = addition_of(talk, words, others);
    return out.place ? std::optional(out) : std::nullopt;
}

// A lamp at each end of "it" stands by the sideboard, not by the mirror above that.
Addition at_what_is_meant(Talk& talk, const Words& words) {
    // "Three stools before the counter, and a lamp over it": over the counter, the stools are "them".
    if (words.back() == "it" && talk.last.size() > 1)
        if (const auto other = things_at(talk.editor, talk.last_place); other.size() == 1) talk.last = other;
    // "Paint that wall black and put a picture on it"
    if (const std::size_t n = words.size();
        n > 2 && words.back() == "it" && words[n - 2] == "on" && talk.last.empty() && talk.wall >= 0) {
        Addition out = addition_of(talk, joined_words(part_of(words, 0, n - 1), {"the", "wall"}), {});
        if (out.place) out.place->step.wall = talk.wall;
        return out;
    }
    const bool it = is_one_of(words.back(), {"it", "them"}) && !talk.last.empty();
    const auto hangs = [](Mount mount) { return mount == Mount::wall || mount == Mount::ceiling; };
    const bool hung = it && std::all_of(talk.last.begin(), talk.last.end(), [&](const std::string& id) {
                          return hangs(talk.editor.placed(id).piece.mount);
                      });
    Addition out = addition_of(talk, words, talk.last);
    // On a shelf is on it.
    const bool on_it = out.place && out.place->step.wish.relation == "on" &&
                       std::any_of(talk.last.begin(), talk.last.end(), [&](const std::string& id) {
                           return !talk.editor.placed(id).piece.surfaces.empty();
                       });
    // "On it" of a rug or a stool means the table or island there, for what does not stand on floors or seats.
    const bool rug = it && std::all_of(talk.last.begin(), talk.last.end(), [&](const std::string& id) {
                         const Placed& p = talk.editor.placed(id);
                         constexpr float kStool =
                             0.55f;  // metres: what is lower and has no back carries things as well
                         const bool stool = talk.last.size() == 1 && p.piece.size_m.y < kStool;
                         return p.flat || (has_role(p.piece.kind, Role::seat) && !stool);
                     });
    if (rug && out.place && out.place->step.wish.relation == "on" && furnishing::is_small(out.wishes.front().kind) &&
        !furnishing::lies_on_seats(out.wishes.front().kind))
        if (auto other = at_the_other(talk, words, talk.last)) return *other;
    if (hung && !on_it && out.place && !hangs(mount_of(talk.editor, out.wishes.front().kind)))
        if (auto other = at_the_other(talk, words, talk.last)) return *other;
    return out;
}

Words joined_parts(const std::vector<Words>& parts) {
    Words out;
    for (const Words& part : parts) {
        if (!out.empty()) out.push_back(",");
        out.insert(out.end(), part.begin(), part.end());
    }
    return out;
}

// "A desk with a chair beside it", of what was spoken of before: both come there.
bool both_come_there(const Talk& talk, const Words& words, std::size_t with) {
    const bool spoken = words.back() == "it" ? talk.last.size() == 1 : talk.last.size() > 1;
    return spoken && next_place(part_of(words, 0, with)) == with && parts_of(words).size() == 1 &&
           find_word(words, {"beside", "next", "behind", "front", "between", "opposite"}, with) < words.size();
}

// "A lamp here and the bench under the window": the bench is there, and moves.
bool stands_already(const Talk& talk, const Words& words) {
    const std::size_t place = next_place(words);
    return is_definite(words.front()) && !is_one_of(words.front(), {"it", "them"}) && place > 1 &&
           place < words.size() && !all_named(talk.editor, text_of(words, 0, place)).empty();
}

// "… and a candle on the stool", where a stool comes in a part before it.
bool is_at_one_before(const std::vector<Words>& parts, std::size_t k) {
    const std::size_t place = next_place(parts[k]);
    if (place >= parts[k].size()) return false;
    const std::string& noun = parts[k].back();
    return std::any_of(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(k), [&](const Words& part) {
        return find_word(part_of(part, 0, next_place(part)), {noun}) < part.size() &&
               find_word(part, {noun}) < next_place(part);
    });
}

bool says_how(const Words& words) {
    for (std::size_t i = 1; i < words.size(); ++i)
        if (value_of(part_of(words, i))) return true;
    return false;
}

// "curtains in the same color as the rug"; false: no such words.
bool add_like_another(Talk& talk, const Words& words) {
    const std::size_t same = find_word(words, {"same"}, 1), as = find_word(words, {"as"}, same);
    if (as + 1 >= words.size() || find_word(words, {"color", "shade"}, same) > as) return false;
    Words bare = part_of(words, 0, same);
    while (bare.size() > 1 && is_one_of(bare.back(), {"in", "of", "with", "the"})) bare.pop_back();
    while (bare.size() > 1 && is_joint(bare.back())) bare.pop_back();
    EditStep step;
    step.kind = EditStep::Kind::recolor;
    const Words model = part_of(words, as + 1);
    const bool others = is_one_of(model.back(), {"others", "ones", "rest", "those"});
    if (!others) step.wish.color = talk.editor.color_seen(talk.things(model).front());
    add(talk, bare);
    step.ids = talk.last;
    // "The same color as the others": those of its kind that were there.
    const std::string kind = step.ids.empty() ? "" : asked_kind(talk.editor.placed(step.ids.front()));
    for (const Placed& p : talk.editor.room().furnished.placed)
        if (others && step.wish.color.empty() && asked_kind(p) == kind && !is_among(p.id, step.ids))
            step.wish.color = talk.editor.color_seen(p.id);
    if (step.wish.color.empty()) throw UsageError("there are no others whose color could be meant");
    talk.editor.apply(step);
    return true;
}

}  // namespace

// "a teapot and two cups on it": all of them on what was last spoken of.
void add_there(Talk& talk, const Words& words) {
    const std::vector<std::string> carriers = talk.last;
    const std::vector<Words> riders = parts_of(words);
    // "Between them" is between what came and what that came at.
    std::vector<std::string> both = carriers;
    if (const std::size_t n = words.size(); n > 2 && words[n - 2] == "between" && carriers.size() == 1)
        if (const auto other = things_at(talk.editor, talk.last_place); other.size() < 3)
            for (const std::string& id : other)
                if (both.size() < 2) add_new(both, {id});
    const Words there = part_of(riders.back(), next_place(riders.back()));
    do_each(
        talk.editor, riders.size(),
        [&](std::size_t k) {
            Words rider = riders[k];
            if (next_place(rider) == rider.size()) rider.insert(rider.end(), there.begin(), there.end());
            talk.last = both;
            add(talk, rider);
        },
        [&](std::size_t k) { return text_of(riders[k]); });
    talk.last = carriers;
}

// "a floor lamp beside the bed and two plants in the corner"; a place holds for those before it that name none.
void add(Talk& talk, const Words& words) {
    // "two armchairs before the fire facing each other"
    if (const std::size_t facing = find_word(words, {"facing"}, 1);
        facing + 3 == words.size() && is_one_of(text_of(words, facing + 1), {"each other", "one another"})) {
        add(talk, part_of(words, 0, facing));
        return face(talk, {"them", "facing", "each", "other"});
    }
    // "A coffee machine on a small table in the corner": first the table, where there is none.
    if (const std::size_t on = find_word(words, {"on"}, 2);
        parts_of(words).size() == 1 && on + 2 < words.size() && is_one_of(words[on + 1], {"a", "an"}) &&
        !is_one_of(words.back(), {"it", "them"}) && noun_of(words.back()) != "wall" &&
        all_named(talk.editor, text_of(words, on + 1, next_place(words, on + 1))).empty() &&
        !room_part(words, on + 1)) {
        add(talk, part_of(words, on + 1));
        Words all = part_of(words, 0, on);
        all.insert(all.end(), {"on", "it"});
        return add(talk, all);
    }
    // "A vase is missing, put a blue one on the table"
    if (const std::size_t one = find_word(words, {"one", "ones"});
        !talk.lacks.empty() && one < words.size() && one + 1 == next_place(words)) {
        Words all = one > 0 ? part_of(words, 0, one) : Words{"a"};
        for (const std::string& w : tokens_of(std::exchange(talk.lacks, {}))) all.push_back(w);
        return add(talk, joined_words(all, part_of(words, one + 1)));
    }
    // "Take the lamp away and hang two smaller ones over the table"
    if (const std::size_t place = next_place(words);
        place > 1 && is_one_of(words[place - 1], {"one", "ones"}) && talk.last.empty() && !talk.noun.empty()) {
        Words all = part_of(words, 0, place - 1);
        for (const std::string& w : tokens_of(talk.noun)) all.push_back(w);
        return add(talk, joined_words(all, part_of(words, place)));
    }
    // "Add a third one", "another one"
    if (const std::size_t n = words.size();
        n > 1 && n < 4 && words.back() == "one" && !talk.noun.empty() &&
        is_one_of(words[n - 2], {"another", "second", "third", "fourth", "fifth", "more", "extra"})) {
        Words all{"another"};
        const Words noun = tokens_of(talk.noun);
        return add(talk, joined_words(all, noun));
    }
    // "The tv is too small, get a bigger one": in place of that.
    if (words.size() > 2 && words.back() == "one" && !talk.last.empty() &&
        value_of(part_of(words, 1, words.size() - 1)))
        return replace(talk, {"it"}, words);
    std::vector<Words> parts = parts_of(words);
    // "an armchair by the sofa, facing the tv"
    if (parts.size() > 1 && parts.back().front() == "facing") {
        Words all{"them"};
        all.insert(all.end(), parts.back().begin(), parts.back().end());
        parts.pop_back();
        add(talk, joined_parts(parts));
        return face(talk, all);
    }
    // "a bed with a nightstand on each side"
    if (const std::size_t n = words.size(), with = find_word(words, {"with"}, 1);
        with + 3 < n && is_one_of(words[n - 2], {"each", "both", "either"}) &&
        is_one_of(words[n - 1], {"side", "sides", "end", "ends"}) && begins_anew(part_of(words, with + 1)))
        return add(talk, joined_words(words, {"of", "it"}));
    // "a shelf over the desk with a plant and a candle on it"
    if (const std::size_t with = find_word(words, {"with"}, 1);
        with + 1 < words.size() && is_one_of(words.back(), {"it", "them"}) &&
        (find_word(words, {"and", ","}, with) < words.size() ||
         find_word(words,
                   {"between", "next", "beside", "behind", "above", "front", "over", "under", "opposite", "around",
                    "side", "sides", "end", "ends"},
                   with) < words.size()) &&
        begins_anew(part_of(words, with + 1)) && next_place(part_of(words, with + 1)) < words.size() - with - 1 &&
        !both_come_there(talk, words, with)) {
        add(talk, part_of(words, 0, with));
        return add_there(talk, part_of(words, with + 1));
    }
    // "a rug before the bed, light yellow"
    if (parts.size() > 1 && parts.back().size() > 1 && is_one_of(parts.back().back(), {"one", "ones"}) &&
        value_of(part_of(parts.back(), 0, parts.back().size() - 1)))
        parts.back().pop_back();
    if (parts.size() > 1 && !number_said(parts.back().front()))
        if (const auto value = value_of(parts.back()); value && !value->resizes() && value->brighter == 1) {
            const Words look = parts.back();
            parts.pop_back();
            add(talk, joined_parts(parts));
            Words all{"them"};
            all.insert(all.end(), look.begin(), look.end());
            return make(talk, all);
        }
    // "brick walls and a concrete floor"
    if (parts.size() > 1 && std::all_of(parts.begin(), parts.end(), [&](const Words& w) {
            return is_one_of(noun_of(w.back()), {"wall", "floor", "ceiling"});
        })) {
        for (const Words& part : parts)
            if (!paint_wanted(talk, part)) throw UsageError("expected how to make it, found \"{}\"", text_of(part));
        return;
    }
    if (brightness_said(talk, words) || paint_wanted(talk, words) || add_like_another(talk, words)) return;
    // "a desk, and a lamp on it": first what that is.
    for (std::size_t k = 1; k < parts.size(); ++k) {
        if (!is_one_of(parts[k].back(), {"it", "them"}) || next_place(parts[k]) == parts[k].size()) continue;
        for (const bool first : {true, false}) {
            Words some;
            for (std::size_t i = first ? 0 : k; i < (first ? k : parts.size()); ++i) {
                if (!some.empty()) some.push_back("and");
                some.insert(some.end(), parts[i].begin(), parts[i].end());
            }
            // Of a rug and a chair "it" is the chair.
            if (!first && parts[k].back() == "it" && talk.last.size() > 1 && k > 1) talk.last = {talk.last.back()};
            add(talk, some);
        }
        return;
    }
    if (parts.empty()) throw UsageError("expected a thing to add, found the end of the sentence");
    // "a desk under the window, with a lamp on it"
    for (std::size_t k = parts.size(); k-- > 1;)
        if (parts[k].front() == "with" && parts[k].size() > 1) {
            parts[k - 1].insert(parts[k - 1].end(), parts[k].begin(), parts[k].end());
            parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(k));
        }
    // "A lamp over the table and two chairs at the ends": of the table.
    for (std::size_t k = 1; k < parts.size(); ++k) {
        const Words there = part_of(parts[k - 1], next_place(parts[k - 1]));
        const auto relation = there.empty() ? std::nullopt : relation_at(there, 0);
        const std::size_t n = parts[k].size();
        const bool both = n > 1 && is_one_of(parts[k][n - 2], {"each", "both", "either", "other"}) &&
                          is_one_of(parts[k].back(), {"end", "side"});
        if (!relation || (!both && !is_one_of(parts[k].back(), {"ends", "sides"})) || room_part(there, relation->next))
            continue;
        parts[k].push_back("of");
        parts[k].insert(parts[k].end(), there.begin() + static_cast<std::ptrdiff_t>(relation->next), there.end());
    }
    // "Two armchairs and the sofa around the fireplace": what comes as well as what stands there already.
    for (std::size_t k = parts.size(); k-- > 1;) {
        const std::size_t place = next_place(parts[k]), before = next_place(parts[k - 1]);
        const bool joined = text_of(words).find(text_of(parts[k - 1]) + " and " + text_of(parts[k])) !=
                            std::string::npos;
        if (joined && place < parts[k].size() && before == parts[k - 1].size() && stands_already(talk, parts[k]))
            parts[k - 1] = joined_words(parts[k - 1], part_of(parts[k], place));
    }
    std::vector<std::optional<Addition>> all(parts.size());
    std::vector<bool> later(parts.size());  // at what comes before it in these words
    const std::vector<std::string> spoken_before = std::exchange(talk.last, {});
    std::vector<std::string> together;  // those that share the place of the next one
    // "A rug, a chair in the corner and a lamp": the corner is the chair's alone; "a chair and a lamp in the corner".
    const std::string text = text_of(words);
    const auto shares = [&](std::size_t k, std::size_t next) {
        return k == next || next + 1 == parts.size() ||
               text.find(text_of(parts[next - 1]) + " and " + text_of(parts[next])) != std::string::npos;
    };
    const auto add_part = [&](std::size_t k) {
        const auto own = all[k]->place;
        std::optional<Place> shared;
        for (std::size_t next = k; next < all.size() && !shared; ++next)
            if (all[next] && all[next]->place) {
                if (!shares(k, next)) break;
                shared = all[next]->place;
            }
        const PromptObject& first = all[k]->wishes.front();
        const std::size_t spoken = talk.last.size();
        // Of "two stools and a lamp over the island" the stools stand at it.
        if (shared && !own && shared->step.wish.relation == "above" &&
            mount_of(talk.editor, first.kind) == Mount::floor)
            shared->step.wish.relation = has_role(first.kind, Role::seat) ? "around" : "next to";
        // "An armchair, a lamp and a shelf by the window": at one window, side by side.
        const bool group = shared && !together.empty() && !noun_of(shared->step.wish.relation_to).empty() &&
                           shared->step.wish.relation == "next to";
        talk.editor.together([&] {
            if (group && grouped(talk, first, *shared, together)) return;
            try {
                constexpr float kFlat = 0.05f;  // metres: mats in a row
                const bool flat_row = all[k]->in_row && first.count > 1 && talk.editor.usual_size(first).y < kFlat &&
                                      mount_of(talk.editor, first.kind) == Mount::floor;
                if (all[k]->in_row && !shared && first.count > 1 && !flat_row) add_row(talk, first);
                else add_or_stand(talk, first, shared);
                if (flat_row) {
                    EditStep row;
                    row.kind = EditStep::Kind::rows;
                    row.ids = part_of(talk.last, spoken), row.wish.count = 1;
                    row.yaw = talk.editor.placed(row.ids.front()).yaw;
                    talk.editor.apply(row);
                }
            } catch (const UsageError&) {
                throw;
            } catch (const Error&) {
                // Two that do not fit into one corner: one by the other.
                const bool beside = shared && shared->step.wish.relation == "in the corner" && !together.empty();
                const auto other = beside ? std::nullopt : at_the_other(talk, all[k]->said, spoken_before);
                if (!beside && !other) throw;
                add_wish(talk, first, beside ? beside_those(talk, together) : *other->place);
            }
            shape_as_asked(talk, part_of(talk.last, spoken), all[k]->shape);
        });
        if (own) together.clear();
        else if (together.empty()) together = part_of(talk.last, spoken);
        if (shared) talk.last_place = shared->step;
        const std::vector<std::string> fresh = part_of(talk.last, spoken);
        tell_unshown(talk, fresh, first, all[k]->said);
        add_with(talk, fresh, *all[k]);
    };
    // Parse all of them before adding the first.
    do_each(
        talk.editor, 2 * parts.size(),
        [&](std::size_t i) {
            const std::size_t k = i % parts.size();
            // "Two more chairs, and the walls in green"
            if (parts.size() > 1 && is_definite(parts[k].front()) && says_how(parts[k])) {
                if (i >= parts.size()) make(talk, parts[k]);
            } else if (parts.size() > 1 && stands_already(talk, parts[k])) {
                if (i >= parts.size()) move(talk, parts[k]);
            } else if (i < parts.size()) {
                const std::vector<std::string> none = std::exchange(talk.last, spoken_before);
                const Words part = by_kind_there(talk.editor, parts[k]);
                try {
                    all[k] = at_what_is_meant(talk, with_noun(talk, part));
                } catch (const Error&) {
                    talk.last = none;
                    later[k] = is_at_one_before(parts, k);
                    if (!later[k]) throw;
                }
                talk.last = none;
                if (all[k]) all[k]->said = counted_anew(part);
            } else {
                // "A stool next to it and a candle on the stool"
                if (later[k]) {
                    const Words part = by_kind_there(talk.editor, parts[k]);
                    all[k] = at_what_is_meant(talk, with_noun(talk, part));
                    all[k]->said = counted_anew(part);
                }
                if (all[k]) add_part(k);
            }
        },
        [&](std::size_t i) { return parts.size() > 1 ? text_of(parts[i % parts.size()]) : ""; });
}

}  // namespace fastscene::editing

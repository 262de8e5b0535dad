// "a floor lamp beside the bed", "the sofa with two armchairs": what comes new, and what changes places.
#include <algorithm>

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

// What lies on a table as others do: there, if it has room for one more. Where all of them lie on tables, nowhere else.
bool with_its_like(Talk& talk, EditStep step) {
    if (!furnishing::is_small(step.wish.kind) || !step.wish.relation.empty() || step.position) return false;
    const std::vector<Placed>& all = talk.editor.room().furnished.placed;
    bool elsewhere = false;
    std::string top;
    for (const Placed& p : all) {
        if (asked_kind(p) != step.wish.kind) continue;
        const Placed* under = p.on < 0 ? nullptr : &all[static_cast<std::size_t>(p.on)];
        if (!under || !has_role(under->piece.kind, Role::laid)) elsewhere = true;
        else if (top.empty()) top = under->id, step.wish.relation_to = asked_kind(*under);
    }
    if (top.empty()) return false;
    step.wish.relation = "on", step.at = {top};
    try {
        talk.editor.apply(step);
        return true;
    } catch (const Error&) {
        if (!elsewhere) throw;
        return false;
    }
}

// A chair where others stand at a table: at that table, if it has room for one more.
bool drawn_up(Talk& talk, EditStep step) {
    if (!has_role(step.wish.kind, Role::seat) || !step.wish.relation.empty() || step.position) return false;
    const std::vector<Placed>& all = talk.editor.room().furnished.placed;
    for (const Placed& p : all) {
        if (asked_kind(p) != step.wish.kind || p.with < 0) continue;
        const Placed& table = all[static_cast<std::size_t>(p.with)];
        if (!has_role(table.piece.kind, Role::lamp_above)) continue;
        step.wish.relation = "around", step.wish.relation_to = asked_kind(table);
        try {
            talk.editor.apply(step);
            return true;
        } catch (const Error&) {
            return false;
        }
    }
    return false;
}

// A nightstand where there is one by the bed: at that bed, on its other side first.
bool by_the_same(Talk& talk, EditStep step) {
    if (!step.wish.relation.empty() || step.position || step.wish.count > 1 || has_role(step.wish.kind, Role::seat))
        return false;
    const std::vector<Placed>& all = talk.editor.room().furnished.placed;
    for (const Placed& p : all) {
        if (asked_kind(p) != step.wish.kind || p.piece.mount != Mount::floor || p.flat || p.on >= 0) continue;
        const Placed* by = p.with < 0 ? nullptr : &all[static_cast<std::size_t>(p.with)];
        if (!by || by->piece.mount != Mount::floor || by->flat) continue;
        const bool right = dot(p.position - by->position, right_of(by->yaw)) > 0;
        step.wish.relation_to = asked_kind(*by), step.at = {by->id};
        for (const char* relation : {right ? "left of" : "right of", "next to"}) try {
                step.wish.relation = relation;
                talk.editor.apply(step);
                return true;
            } catch (const Error&) {
            }
        return false;
    }
    return false;
}

// "remove the vase and put a lamp there": where that stood.
void stand_there(Talk& talk, EditStep& step) {
    if (talk.last_gone_from.empty() || !furnishing::is_small(step.wish.kind)) {
        if (talk.last_gone) step.position = talk.last_gone;
        return;
    }
    step.wish.relation = "on", step.wish.relation_to = asked_kind(talk.editor.placed(talk.last_gone_from));
    step.at = {talk.last_gone_from};
}

void add_wish(Talk& talk, const PromptObject& wish, const std::optional<Place>& place) {
    const std::size_t before = talk.editor.document().things.size();
    EditStep step = place ? place->step : EditStep{};
    step.kind = EditStep::Kind::add;
    const PromptObject where = step.wish;
    step.wish = wish;
    if (place)
        step.wish.relation = where.relation, step.wish.relation_to = where.relation_to,
        step.wish.relation_and = where.relation_and;
    if (place && place->count > step.wish.count) step.wish.count = place->count, step.wish.counted = true;
    if (step.each) step.wish.count = std::max(4, wish.count), step.wish.counted = false;
    if (!place && talk.there) stand_there(talk, step);
    if (!place && (drawn_up(talk, step) || with_its_like(talk, step) || by_the_same(talk, step))) {
        // with its like, at their table
    } else if (place && !place->each_at.empty())
        do_each(talk.editor, place->each_at.size(),
                [&](std::size_t k) { step.at = place->each_at[k], talk.editor.apply(step); });
    else talk.editor.apply(step);
    const auto& things = talk.editor.document().things;
    for (std::size_t i = before; i < things.size(); ++i) talk.last.push_back(things[i].id);
}

// "A second armchair facing the first one": the first armchair.
Words with_noun(const Talk& talk, const Words& words) {
    const std::size_t place = next_place(words);
    if (words.size() > place + 1 && is_one_of(words.back(), {"first", "other", "existing"})) {
        Words all = words;
        all.push_back("one");
        return with_noun(talk, all);
    }
    const std::size_t one = find_word(words, {"one"}, 2);
    if (one >= words.size() || one < place || !is_one_of(words[one - 1], {"first", "other", "old", "existing"}))
        return words;
    const PromptSpec spec = read_in_room(talk.editor, text_of(counted_anew(part_of(words, 0, place))));
    if (spec.objects.empty()) return words;
    Words out = words;
    out[one] = spec.objects.front().words;
    if (!is_one_of(out[one - 1], {"first"})) out.erase(out.begin() + static_cast<std::ptrdiff_t>(one) - 1);
    return out;
}

// What stands on tops, where there is none: "a lamp beside it" is one that stands on the floor.
std::optional<PromptObject> standing_form(const PromptObject& wish, const std::optional<Place>& place) {
    if (!place || is_one_of(place->step.wish.relation, {"on", "above"}) || !furnishing::is_small(wish.kind)) return {};
    const Words words = tokens_of(wish.words);
    if (words.size() != 1 || !has_role(wish.kind, Role::light)) return {};
    const std::vector<std::string> forms = base_forms(words.front());
    const auto is_called_so = [&](const std::string& kind) {
        return kind.ends_with("_" + words.front()) ||
               std::any_of(forms.begin(), forms.end(), [&](const std::string& f) { return kind.ends_with("_" + f); });
    };
    for (const std::string& kind : kinds_with(Role::tall))
        if (has_role(kind, Role::light) && is_called_so(kind)) {
            PromptObject out = wish;
            out.kind = kind;
            return out;
        }
    return {};
}

void add_or_stand(Talk& talk, const PromptObject& wish, const std::optional<Place>& place) {
    try {
        add_wish(talk, wish, place);
    } catch (const UsageError&) {
        throw;
    } catch (const Error&) {
        const auto other = standing_form(wish, place);
        if (!other) throw;
        add_wish(talk, *other, place);
    }
}

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
            if (ids.empty() || (!addition.each && !addition.on_it && (relation != "on" || wish.count > 1)))
                return add_or_stand(talk, wish, {});
            do_each(talk.editor, ids.size(), [&](std::size_t i) { add_or_stand(talk, wish, at(ids[i], relation)); });
        },
        [&](std::size_t k) { return wishes[k + first].words; });
}

// Beside those that share its place, and no further from the place than they; false: there is no such place.
bool grouped(Talk& talk, const PromptObject& wish, const Place& shared, const std::vector<std::string>& together) {
    constexpr float kTogether = 1;  // metres from a window
    const std::vector<std::string> before = talk.last;
    try {
        talk.editor.together([&] {
            Place place;
            place.step.wish.relation = "next to";
            place.step.wish.relation_to = talk.editor.placed(together.front()).piece.kind;
            place.step.at = {together.front()};
            add_wish(talk, wish, place);
            PromptObject at = wish;
            at.id = -2;  // none of those that stand there
            at.relation = shared.step.wish.relation, at.relation_to = shared.step.wish.relation_to;
            const Placed& p = talk.editor.placed(talk.last.back());
            const FurnishedRoom& room = talk.editor.room().furnished;
            float off = 1e9f;
            for (const Footprint& o : anchors_of(room.plan, {}, at.relation_to))
                off = std::min(off, distance_to(o, footprint_of(p).center));
            if (off > kTogether && !stands_as_asked(room.plan, room.placed, p, at).value_or(false))
                throw Error("{}: it is too far from there", p.id);
        });
        return true;
    } catch (const Error&) {
        talk.last = before;
        return false;
    }
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
Addition at_what_is_meant(const Talk& talk, const Words& words) {
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
    // On a rug under a table is on the table, and no bowl stands on a stool before an island.
    const bool rug = it && std::all_of(talk.last.begin(), talk.last.end(), [&](const std::string& id) {
                         const Placed& p = talk.editor.placed(id);
                         return p.flat || has_role(p.piece.kind, Role::seat);
                     });
    if (rug && out.place && out.place->step.wish.relation == "on" && furnishing::is_small(out.wishes.front().kind) &&
        !furnishing::lies_on_seats(out.wishes.front().kind))
        if (auto other = at_the_other(talk, words, talk.last)) return *other;
    if (hung && !on_it && out.place && !hangs(mount_of(talk.editor, out.wishes.front().kind)))
        if (auto other = at_the_other(talk, words, talk.last)) return *other;
    return out;
}

Place beside_those(const Talk& talk, const std::vector<std::string>& ids) {
    Place out;
    out.step.wish.relation = "next to", out.step.wish.relation_to = talk.editor.placed(ids.back()).piece.kind;
    out.step.at = {ids.back()};
    return out;
}

// "Two more tables in a row": each beside the one before it.
void add_row(Talk& talk, PromptObject wish) {
    const int count = std::exchange(wish.count, 1);
    add_wish(talk, wish, {});
    for (int n = 1; n < count; ++n) {
        Place next = beside_those(talk, {talk.last.back()});
        bool done = false;
        for (const char* side : {"left of", "right of"}) {
            if (done) break;
            next.step.wish.relation = side;
            try {
                add_wish(talk, wish, next);
                done = true;
            } catch (const Error&) {
            }
        }
        next.step.wish.relation = "next to";
        if (!done) add_wish(talk, wish, next);
    }
}

Words joined_parts(const std::vector<Words>& parts) {
    Words out;
    for (const Words& part : parts) {
        if (!out.empty()) out.push_back(",");
        out.insert(out.end(), part.begin(), part.end());
    }
    return out;
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
    EditStep step;
    step.kind = EditStep::Kind::recolor;
    step.wish.color = talk.editor.color_seen(talk.things(part_of(words, as + 1)).front());
    add(talk, bare);
    step.ids = talk.last;
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
    // "a shelf over the desk with a plant and a candle on it"
    if (const std::size_t with = find_word(words, {"with"}, 1);
        with + 1 < words.size() && is_one_of(words.back(), {"it", "them"}) &&
        (find_word(words, {"and", ","}, with) < words.size() ||
         find_word(words, {"between", "next", "beside", "behind", "above", "front"}, with) < words.size()) &&
        begins_anew(part_of(words, with + 1)) && next_place(part_of(words, with + 1)) < words.size() - with - 1) {
        add(talk, part_of(words, 0, with));
        return add_there(talk, part_of(words, with + 1));
    }
    // "a rug before the bed, light yellow"
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
        const bool both = n > 1 && is_one_of(parts[k][n - 2], {"each", "both", "either"}) &&
                          is_one_of(parts[k].back(), {"end", "side"});
        if (!relation || (!both && !is_one_of(parts[k].back(), {"ends", "sides"})) || room_part(there, relation->next))
            continue;
        parts[k].push_back("of");
        parts[k].insert(parts[k].end(), there.begin() + static_cast<std::ptrdiff_t>(relation->next), there.end());
    }
    std::vector<std::optional<Addition>> all(parts.size());
    const std::vector<std::string> spoken_before = std::exchange(talk.last, {});
    std::vector<std::string> together;  // those that share the place of the next one
    const auto add_part = [&](std::size_t k) {
        const auto own = all[k]->place;
        std::optional<Place> shared;
        for (std::size_t next = k; next < all.size() && !shared; ++next)
            if (all[next]) shared = all[next]->place;
        const PromptObject& first = all[k]->wishes.front();
        const std::size_t spoken = talk.last.size();
        // Of "two stools and a lamp over the island" the stools stand at it.
        if (shared && !own && shared->step.wish.relation == "above" &&
            mount_of(talk.editor, first.kind) == Mount::floor)
            shared->step.wish.relation = has_role(first.kind, Role::seat) ? "around" : "next to";
        // "An armchair, a lamp and a shelf by the window": at one window, side by side.
        const bool group = shared && !together.empty() && noun_of(shared->step.wish.relation_to) != "" &&
                           shared->step.wish.relation == "next to";
        talk.editor.together([&] {
            if (group && grouped(talk, first, *shared, together)) return;
            try {
                if (all[k]->in_row && !shared && first.count > 1) add_row(talk, first);
                else add_or_stand(talk, first, shared);
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
    // All of them are read before any of them comes.
    do_each(
        talk.editor, 2 * parts.size(),
        [&](std::size_t i) {
            const std::size_t k = i % parts.size();
            // "Two more chairs, and the walls in green"
            if (parts.size() > 1 && is_definite(parts[k].front()) && says_how(parts[k])) {
                if (i >= parts.size()) make(talk, parts[k]);
            } else if (i < parts.size()) {
                const std::vector<std::string> none = std::exchange(talk.last, spoken_before);
                const Words& part = parts[k];
                try {
                    all[k] = at_what_is_meant(talk, with_noun(talk, part));
                } catch (const Error&) {
                    talk.last = none;
                    throw;
                }
                talk.last = none;
                all[k]->said = counted_anew(part);
            } else if (all[k]) add_part(k);
        },
        [&](std::size_t i) { return parts.size() > 1 ? text_of(parts[i % parts.size()]) : ""; });
}

void copy(Talk& talk, const Words& words) {
    for (const std::string& id : talk.things_of_parts(words)) {
        const Placed p = talk.editor.placed(id);
        EditStep step;
        step.kind = EditStep::Kind::add;
        step.wish = p.wish;
        step.wish.kind = asked_kind(p), step.wish.words = in_words(step.wish.kind);
        step.wish.count = 1;
        step.wish.relation = step.wish.relation_to = step.wish.relation_and = "";
        for (const DocumentThing& t : talk.editor.document().things)
            if (t.id == id) step.wish.color = t.color, step.wish.material = t.material, step.wish.pattern = t.pattern;
        step.wish.size_m = p.piece.size_m;
        talk.editor.apply(step);
    }
}

namespace {

// "Replace the coffee table with the ottoman": the ottoman that is there takes its place; false: no such words.
bool replaced_by_its_like(Talk& talk, const Words& old, const Words& by) {
    if (by.size() < 2 || !is_definite(by.front()) || is_one_of(by.back(), {"one", "ones"}) ||
        next_place(by) < by.size() || all_named(talk.editor, text_of(by)).empty())
        return false;
    const std::vector<std::string> gone = talk.things_of_parts(old), come = talk.things_of_parts(by);
    if (gone.size() != 1 || come.size() != 1 || gone == come) return false;
    talk.editor.together([&] {
        EditStep step;
        step.kind = EditStep::Kind::place;
        step.ids = come, step.position = flat(talk.editor.placed(gone.front()).position);
        step.yaw = talk.editor.placed(gone.front()).yaw;
        EditStep take;
        take.ids = gone;
        talk.editor.apply(take);
        talk.editor.apply(step);
    });
    talk.last = come;
    return true;
}

}  // namespace

void replace(Talk& talk, const Words& old, const Words& by) {
    if (replaced_by_its_like(talk, old, by)) return;
    EditStep step;
    step.kind = EditStep::Kind::replace;
    step.ids = talk.things_of_parts(old);
    std::vector<Words> parts = parts_of(by);
    // "a loveseat facing the sofa"
    if (const std::size_t facing = find_word(by, {"facing"}, 2); facing + 1 < by.size()) {
        replace(talk, old, part_of(by, 0, facing));
        Words all{"them"};
        all.insert(all.end(), by.begin() + static_cast<std::ptrdiff_t>(facing), by.end());
        return face(talk, all);
    }
    // "with a bigger one", "with a blue one", "with a round one", "with something round"
    if (by.size() > 1 && by.front() == "something") {
        Words one{"a"};
        one.insert(one.end(), by.begin() + 1, by.end());
        one.push_back("one");
        return replace(talk, old, one);
    }
    // "a leather one in brown"
    if (const std::size_t one = find_word(by, {"one", "ones"}, 1); one + 2 < by.size() && by[one + 1] == "in") {
        Words all = part_of(by, 0, one);
        all.insert(all.end(), by.begin() + static_cast<std::ptrdiff_t>(one) + 2, by.end());
        all.push_back(by[one]);
        return replace(talk, old, all);
    }
    if (!by.empty() && is_one_of(by.back(), {"one", "ones"})) {
        Words all{"it"};
        for (const std::string& w : by)
            if (!is_one_of(w, {"a", "an", "one", "ones"})) all.push_back(w);
        if (value_of(part_of(all, 1))) return make(talk, all);
        parts = {by};
        parts[0].back() = in_words(asked_kind(talk.editor.placed(step.ids.front())));
    }
    if (parts.empty()) throw UsageError("expected what comes in place of \"{}\"", text_of(old));
    step.wish = wishes_of(talk.editor, parts.front()).front();
    const bool each = is_one_of(old.front(), {"every", "each"});  // "every chair with a stool"
    const bool one = is_one_of(parts.front().front(), {"a", "an", "another", "one"}) && !each;
    if ((!step.wish.counted || each) && !one) step.wish.count = static_cast<int>(step.ids.size());
    const std::size_t told = talk.editor.result().changes.size();
    talk.editor.apply(step);
    talk.last = {};
    const auto& changes = talk.editor.result().changes;
    for (std::size_t i = told; i < changes.size(); ++i)
        if (const EditChange& change = changes[i]; change.what.starts_with("added in place of"))
            talk.last.push_back(change.id);
    shape_as_asked(talk, talk.last, shape_asked(parts.front()));
    tell_unshown(talk, talk.last, step.wish, parts.front());
    const std::vector<std::string> fresh = talk.last;
    for (std::size_t k = 1; k < parts.size(); ++k) {
        talk.last = fresh;
        if (next_place(parts[k]) < parts[k].size()) {  // "two armchairs and a table between them"
            add(talk, parts[k]);
            continue;
        }
        PromptObject wish = wishes_of(talk.editor, parts[k]).front();
        wish.relation = "next to", wish.relation_to = step.wish.kind;
        add_wish(talk, wish, {});
    }
}

void swap(Talk& talk, Words words) {
    if (swap_colors(talk, words)) return;
    for (const char* name : {"positions", "position", "places", "place"})
        if (const std::size_t at = find_word(words, {name}); at + 1 < words.size() && words[at + 1] == "of")
            words = part_of(words, at + 2);
    // "the two armchairs' places"
    while (words.size() > 1 && is_one_of(words.back(), {"places", "positions", "place", "position", "around", "over"}))
        words.pop_back();
    for (std::string& w : words)
        if (const std::size_t mark = w.find('\''); mark != std::string::npos && mark > 1) w.resize(mark);
    const std::size_t with = find_word(words, {"with", "for", "by", "and"});
    if (const auto two = with == words.size() ? talk.things(words) : std::vector<std::string>{}; two.size() == 2) {
        EditStep step;
        step.kind = EditStep::Kind::swap;
        step.ids = two;
        return talk.editor.apply(step);
    }
    if (with + 1 >= words.size())
        throw UsageError("expected \"swap … and …\" or \"swap … for …\", found \"{}\"", text_of(words));
    const Words one = part_of(words, 0, with), other = part_of(words, with + 1);
    const bool anew = words[with] == "for" || words[with] == "by" ||
                      (words[with] == "with" && is_one_of(other.front(), {"a", "an", "some", "another"}));
    if (anew || (words[with] == "with" && all_named(talk.editor, text_of(other)).empty()))
        return replace(talk, one, other);
    EditStep step;
    step.kind = EditStep::Kind::swap;
    const auto a = talk.things(one), b = talk.things(other);
    if (a.size() != b.size())
        throw UsageError("expected as many things to swap as to swap them with, found {} and {}", a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
        step.ids = {a[k], b[k]};
        talk.editor.apply(step);
    }
}

}  // namespace fastscene::editing

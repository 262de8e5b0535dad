// One thing that comes new: with its like, by the same as they, beside those that share its place.
#include <fmt/format.h>

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

// "front" or "behind", where all seats of a long table, at least two, are on one side of it; empty: they are not.
std::string side_of_seats(const Editor& editor, int table) {
    const std::vector<Placed>& all = editor.room().furnished.placed;
    const Placed& t = all[static_cast<std::size_t>(table)];
    int front = 0, behind = 0;
    for (const Placed& p : all) {
        if (p.with != table || !has_role(p.piece.kind, Role::seat)) continue;
        (dot(p.position - t.position, front_of(t.yaw)) > 0 ? front : behind) += 1;
    }
    constexpr float kLong = 1.8f;  // times as long as it is deep
    if (front + behind < 2 || t.piece.size_m.x < kLong * t.piece.size_m.z) return {};
    return behind == 0 ? "front" : front == 0 ? "behind" : "";
}

// A chair where others stand at a table: at that table, if it has room for one more.
bool drawn_up(Talk& talk, EditStep step) {
    if (!has_role(step.wish.kind, Role::seat) || !step.wish.relation.empty() || step.position) return false;
    const std::vector<Placed>& all = talk.editor.room().furnished.placed;
    for (const Placed& p : all) {
        if (asked_kind(p) != step.wish.kind || p.with < 0) continue;
        const Placed& table = all[static_cast<std::size_t>(p.with)];
        if (!has_role(table.piece.kind, Role::lamp_above)) continue;
        step.wish.relation_to = asked_kind(table);
        // At a bar on the side where the others are.
        std::vector<const char*> relations{"around"};
        if (const std::string side = side_of_seats(talk.editor, p.with); !side.empty())
            relations = {side == "front" ? "in front of" : "behind", "around"}, step.at = {table.id};
        for (const char* relation : relations) try {
                step.wish.relation = relation;
                talk.editor.apply(step);
                return true;
            } catch (const Error&) {
            }
        return false;
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

// What stands on tops, where there is none: "a lamp beside it" is one that stands on the floor.
std::optional<PromptObject> standing_form(const PromptObject& wish, const std::optional<Place>& place) {
    if (!place || is_one_of(place->step.wish.relation, {"on", "above"}) || !furnishing::is_small(wish.kind)) return {};
    const Words words = tokens_of(wish.words);
    if (words.empty() || !has_role(wish.kind, Role::light) || in_words(wish.kind) == wish.words) return {};
    const std::vector<std::string> forms = base_forms(words.back());
    const auto is_called_so = [&](const std::string& kind) {
        return kind.ends_with("_" + words.back()) ||
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

// "I want eight chairs at the table", where six stand: two more.
void fill_up(Talk& talk, EditStep& step) {
    const bool in_all = is_one_of(talk.said, {"i want", "we want", "i need", "we need", "there should be", "have"});
    if (!in_all || talk.more || step.wish.relation != "around" || !has_role(step.wish.kind, Role::seat)) return;
    int there = 0;
    for (const Placed& p : talk.editor.room().furnished.placed)
        if (p.with >= 0 && asked_kind(p) == step.wish.kind &&
            asked_kind(talk.editor.room().furnished.placed[static_cast<std::size_t>(p.with)]) == step.wish.relation_to)
            ++there;
    if (there == 0 || there >= step.wish.count) return;
    talk.editor.note("room",
                     fmt::format("{} of the {} {} stand there already", there, step.wish.count, step.wish.words));
    step.wish.count -= there;
}

}  // namespace

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
    if (place && place->if_uncounted && !wish.counted && !place->each_at.empty()) step.wish.count = 1;
    fill_up(talk, step);
    if (!place && talk.there) stand_there(talk, step);
    if (!place && (drawn_up(talk, step) || with_its_like(talk, step) || by_the_same(talk, step))) {
        // with its like, at their table
    } else if (place && !place->each_at.empty() && !(place->if_uncounted && wish.counted))
        do_each(talk.editor, place->each_at.size(),
                [&](std::size_t k) { step.at = place->each_at[k], talk.editor.apply(step); });
    else talk.editor.apply(step);
    const auto& things = talk.editor.document().things;
    for (std::size_t i = before; i < things.size(); ++i) talk.last.push_back(things[i].id);
    talk.noun = singular(wish.words);  // "the one nearest the door" is one of those
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

Place beside_those(const Talk& talk, const std::vector<std::string>& ids) {
    Place out;
    out.step.wish.relation = "next to", out.step.wish.relation_to = talk.editor.placed(ids.back()).piece.kind;
    out.step.at = {ids.back()};
    return out;
}

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

bool grouped(Talk& talk, const PromptObject& wish, const Place& shared, const std::vector<std::string>& together) {
    constexpr float kTogether = 1;  // metres from a window
    const std::vector<std::string> before = talk.last;
    try {
        talk.editor.together([&] {
            Place place;
            // A chair is drawn up to a desk.
            const std::string& first = talk.editor.placed(together.front()).piece.kind;
            const bool sits_at = has_role(first, Role::work_place) && has_role(wish.kind, Role::seat) &&
                                 !has_role(wish.kind, Role::easy_chair) && !has_role(wish.kind, Role::sofa);
            place.step.wish.relation = sits_at ? "in front of" : "next to";
            place.step.wish.relation_to = first;
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

}  // namespace fastscene::editing

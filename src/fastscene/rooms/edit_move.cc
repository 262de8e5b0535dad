// "the armchair to the window", "the sofa towards the tv", "put it there": things moved and turned.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/prompt_text.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/catalogue.h"

namespace fastscene::editing {
namespace {

// A thing's words and the words of its place.
struct Split {
    Words thing, place;
};
// Where a place may begin: at the last "to" first, then from the left.
std::vector<Split> splits_of(const Words& words) {
    std::vector<std::size_t> ends;
    // "50 cm to the left", "a bit to the left"
    const std::size_t much = next_place(words);
    if (much < words.size() && (number_said(words[much]) || words[much] == "slightly")) ends.push_back(much);
    for (std::size_t i = words.size(); i-- > 1;)
        if (is_one_of(words[i], {"to", "into", "onto"}) &&
            !is_one_of(words[i - 1],
                       {"next", "close", "over", "closer", "up", "nearer", "near", "back", "adjacent", "opposite"})) {
            ends.push_back(i);
            break;
        }
    for (std::size_t i = next_place(words); i < words.size(); i = next_place(words, i + 1)) ends.push_back(i);
    std::vector<Split> out;
    for (const std::size_t end : ends) out.push_back({part_of(words, 0, end), part_of(words, end)});
    return out;
}

// "to the left of the bed": as far as there is room, when that is not a place.
bool shifted(Talk& talk, const std::vector<std::string>& ids, const Words& place) {
    std::vector<EditStep> steps;
    if (ids.size() > 1 && is_one_of(place.back(), {"together", "apart"})) {
        Vec3f middle{};
        for (const std::string& id : ids) middle += talk.editor.placed(id).position;
        middle = middle * (1.f / static_cast<float>(ids.size()));
        constexpr float kStep = 0.4f;  // metres
        for (const std::string& id : ids) {
            Vec3f way = middle - talk.editor.placed(id).position;
            way.y = 0;
            if (!(length(way) > 0)) continue;
            EditStep step;
            step.kind = EditStep::Kind::shift;
            step.ids = {id};
            step.by = way * ((place.back() == "apart" ? -kStep : std::min(kStep, length(way) / 2)) / length(way));
            steps.push_back(step);
        }
    }
    if (text_of(place) == "together" && ids.size() == 2 && !steps.empty()) return put_together(talk, ids);
    for (const std::string& id : steps.empty() ? ids : std::vector<std::string>{})
        if (const auto step = shift_of(talk.editor, place, id)) steps.push_back(*step);
    if (steps.size() < ids.size() || steps.empty()) return false;
    do_each(talk.editor, steps.size(), [&](std::size_t k) { talk.editor.apply(steps[k]); });
    return true;
}

bool put_at(Talk& talk, const std::vector<std::string>& ids, const Words& said,
            const std::vector<std::string>& spoken) {
    const Words words = talk.with_others(said);
    // "The desk and its chair": that goes along with it.
    if (const auto others = without_companions(talk.editor, ids); others.size() < ids.size())
        return put_at(talk, others, said, spoken);
    // "together in the middle": the first there, the others at it
    if (ids.size() > 1 && words.size() > 1 && words.front() == "together") {
        talk.editor.together([&] {
            if (!put_at(talk, {ids.front()}, part_of(words, 1), spoken))
                throw UsageError("expected a place in the room, found \"{}\"", text_of(words, 1));
            for (std::size_t k = 1; k < ids.size(); ++k) put_together(talk, {ids[k - 1], ids[k]});
        });
        return true;
    }
    // "Both mirrors on the same wall": that of the first.
    if (const std::size_t same = find_word(words, {"same"});
        ids.size() > 1 && same + 1 < words.size() && noun_of(words[same + 1]) == "wall") {
        const Placed& first = talk.editor.placed(ids.front());
        EditStep step;
        step.kind = EditStep::Kind::place;
        step.wall = wall_behind(talk.editor.plan(), first);
        step.wish.relation = first.piece.mount == Mount::wall ? "on" : "against", step.wish.relation_to = "wall";
        if (first.piece.mount != Mount::wall) step.wish.relation_to.clear();
        std::vector<std::string> others;
        for (const std::string& id : ids)
            if (wall_behind(talk.editor.plan(), talk.editor.placed(id)) != step.wall) others.push_back(id);
        if (step.wall < 0) throw UsageError("which wall? {} stands at none", ids.front());
        if (others.empty()) throw AlreadySo(fmt::format("{}: they are on one wall already", ids.front()));
        step.ids = others;
        talk.editor.apply(step);
        return true;
    }
    std::string why_not;
    // "closer to it"
    Words way = words;
    if (is_one_of(way.back(), {"it", "them"}) && !spoken.empty()) way.back() = spoken.front();
    try {
        if (shifted(talk, ids, way)) {
            // "Closer to the fireplace" is at it.
            try {
                const std::string kind = asked_kind(talk.editor.placed(ids.front()));
                if (const auto at = place_of(talk.editor, words, kind, ids.front(), spoken)) talk.last_place = at->step;
            } catch (const UsageError&) {
            }
            return true;
        }
    } catch (const UsageError&) {
        throw;
    } catch (const Error& e) {  // "closer to the window", with no free way there: a place at the window
        const std::size_t to = find_word(words, {"to", "window", "door"});
        if (!room_part(words, words[std::min(to, words.size() - 1)] == "to" ? to + 1 : to)) throw;
        why_not = e.what();
    }
    std::optional<Place> place;
    try {
        place = place_of(talk.editor, words, asked_kind(talk.editor.placed(ids.front())), ids.front(), spoken);
    } catch (const UsageError&) {
        if (why_not.empty()) throw;
    }
    if (!place && !why_not.empty()) throw Error("{}", why_not);
    if (!place) return false;
    // "All the toys into the toy box", which is one of them.
    std::vector<std::string> others_go = ids;
    const std::vector<std::string> onto = things_at(talk.editor, place->step);
    if (std::erase_if(others_go, [&](const std::string& id) { return is_among(id, onto); }) > 0 && !others_go.empty())
        return put_at(talk, others_go, said, spoken);
    // "The cushions on the armchairs": one here, one there.
    if (place->each_at.empty() && ids.size() > 1 && place->step.wish.relation == "on" && words.back().ends_with("s"))
        if (const auto there = things_at(talk.editor, place->step); there.size() > 1)
            for (const std::string& id : there) place->each_at.push_back({id});
    const auto put_all = [&] {
        place->step.kind = EditStep::Kind::place;
        // Several chairs at a table are spread along its sides.
        if (place->step.wish.relation == "around" && place->each_at.empty() && ids.size() > 1) {
            place->step.ids = ids;
            return talk.editor.apply(place->step);
        }
        do_each(talk.editor, ids.size(), [&](std::size_t k) {
            place->step.ids = {ids[k]};
            if (!place->each_at.empty()) place->step.at = place->each_at[k % place->each_at.size()];
            EditStep step = place->step;
            // Several on both sides: one here, one there.
            if (ids.size() > 1 && step.wish.relation == "on both sides of")
                step.wish.relation = k % 2 == 0 ? "left of" : "right of";
            talk.editor.apply(step);
            // All of them at that window, where there are several.
            if (k == 0 && ids.size() > 1 && step.wish.relation == "next to" && !step.position &&
                !noun_of(step.wish.relation_to).empty())
                place->step.position = flat(talk.editor.placed(ids[k]).position);
        });
    };
    // "Move the chair to the fire and hang the mirror above it": what it was put at may be "it" as well.
    const std::vector<std::string> others = talk.last_place.wish.relation_to.empty()
                                                ? std::vector<std::string>{}
                                                : things_at(talk.editor, talk.last_place);
    try {
        put_all();
    } catch (const UsageError&) {
        throw;
    } catch (const AlreadySo&) {
        throw;
    } catch (const Error&) {
        if (!is_one_of(words.back(), {"it", "them"}) || others.empty() || others == spoken) throw;
        place = place_of(talk.editor, words, asked_kind(talk.editor.placed(ids.front())), ids.front(), others);
        if (!place) throw;
        put_all();
    }
    turn_as_said(talk, ids);
    talk.last_place = place->step;
    talk.mention_place(place->step, ids);
    return true;
}

// "Push the chairs in": up to the table at which they stand; false: they stand at none.
bool push_in(Talk& talk, const std::vector<std::string>& ids) {
    for (const std::string& id : ids) {
        const int at = talk.editor.placed(id).with;
        if (at < 0) return false;
        put_at(talk, {id}, {"to", talk.editor.document().things[static_cast<std::size_t>(at)].id}, {});
    }
    return true;
}

// Of several lamps, the one that stands on tops, where that is where it is to go; nothing: there are more of them.
std::optional<std::string> the_one_for_tops(const Editor& editor, const Split& split) {
    const auto relation = relation_at(split.place, 0);
    if (!relation || !is_one_of(relation->name, {"to", "on"}) || split.thing.back().ends_with("s")) return {};
    const Words there = part_of(split.place, relation->next);
    if (there.empty() || room_part(there, 0) || is_one_of(there.front(), {"it", "them"})) return {};
    for (const int i : all_named(editor, text_of(there)))
        if (const Placed& p = editor.room().furnished.placed[static_cast<std::size_t>(i)];
            !carries(p) || has_role(p.piece.kind, Role::seat) || has_role(p.piece.kind, Role::bed))
            return {};
    std::vector<std::string> small;
    for (const int i : all_named(editor, text_of(split.thing)))
        if (const Placed& p = editor.room().furnished.placed[static_cast<std::size_t>(i)];
            p.piece.made_mount == Mount::surface)
            small.push_back(p.id);
    return small.size() == 1 ? std::optional(small.front()) : std::nullopt;
}

void move_one(Talk& talk, const std::vector<Words>& before, const Words& words) {
    std::string wrong;
    std::vector<std::string> spoken = talk.last;
    // "The lamps beside the screen, and the tripod in front of it": in front of the screen, the lamps are "them".
    if (words.back() == "it" && spoken.size() > 1)
        if (const auto other = things_at(talk.editor, talk.last_place); other.size() == 1) spoken = other;
    // "the vase from the wardrobe to the desk" stands on it.
    Words all = words;
    const std::size_t from = find_word(words, {"from"}, 1);
    const bool source = from + 1 < words.size() && !is_one_of(words[from - 1], {"away", "further", "farther", "out"}) &&
                        next_place(words, from + 1) < words.size();
    if (source) all[from] = "on";
    for (const Split& split : splits_of(all)) {
        if (source && split.thing.size() <= from) continue;
        std::vector<std::string> ids;
        try {
            for (const Words& part : before) add_new(ids, talk.things(part));
            const auto near = before.empty() ? nearest_of(talk, split.thing, split.place, spoken)
                                             : std::vector<std::string>{};
            add_new(ids, near.empty() ? talk.things(split.thing) : near);
        } catch (const UsageError& e) {  // "the lamp" of several; "the lamp on the desk" may be one
            if (wrong.empty()) wrong = e.what();
            const auto one = the_one_for_tops(talk.editor, split);
            if (!one) continue;
            ids = {*one};
        }
        talk.last = ids;
        if (split.place == Words{"in"} && push_in(talk, ids)) return;
        if (put_at(talk, ids, split.place, spoken)) return;
        if (wrong.empty()) wrong = fmt::format("expected a place in the room, found \"{}\"", text_of(split.place));
    }
    if (wrong.empty())
        wrong = fmt::format("expected where to move \"{}\", for example \"to the window\"", text_of(words));
    throw UsageError("{}", wrong);
}

}  // namespace

std::vector<std::string> things_at(const Editor& editor, const EditStep& place) {
    if (!place.at.empty()) return place.at;
    std::vector<std::string> out;
    for (const DocumentThing& t : editor.document().things)
        if (t.kind == place.wish.relation_to || (t.asked && t.asked->kind == place.wish.relation_to))
            out.push_back(t.id);
    return out;
}

void stand_at(Talk& talk, const std::vector<std::string>& ids, Vec2f at) {
    EditStep step;
    step.kind = EditStep::Kind::place;
    step.ids = ids, step.position = at;
    constexpr float kThere = 0.8f;  // metres from its middle
    talk.editor.together([&] {
        talk.editor.apply(step);
        for (const std::string& id : ids)
            if (length(flat(talk.editor.placed(id).position) - at) > kThere)
                throw Error("{}: there is no free place for it there", id);
    });
    talk.last = ids;
}

std::optional<Vec2f> left_by(const Talk& talk, const std::string& id) {
    constexpr float kMoved = 0.05f;  // metres
    const auto in = [&](const RoomDocument& document) {
        return std::find_if(document.things.begin(), document.things.end(),
                            [&](const DocumentThing& t) { return t.id == id; });
    };
    const auto before = in(talk.was), now = in(talk.editor.document());
    if (before == talk.was.things.end() || now == talk.editor.document().things.end() ||
        length(now->position - before->position) < kMoved)
        return {};
    return flat(before->position);
}

namespace {

// "The desk to the window with its chair": the chair goes along anyway. "Next to each other under the window", "on
// top".
Words as_move(const Talk& talk, Words part) {
    for (std::size_t with = 2; with + 2 < part.size(); ++with) {
        const std::size_t end = with + 3;
        const bool last = end == part.size() || part[end] == "facing";
        if (part[with] != "with" || !last || !is_definite(part[with + 1])) continue;
        const auto noun = look_up(part[with + 2]);
        if (!noun || noun->kind != WordKind::object || !has_role(noun->meaning, Role::seat)) continue;
        const std::size_t from = is_one_of(part[with - 1], {"together", "along"}) ? with - 1 : with;
        part.erase(part.begin() + static_cast<std::ptrdiff_t>(from), part.begin() + static_cast<std::ptrdiff_t>(end));
    }
    for (const char* row : {"next to each other", "side by side", "beside each other"}) {
        const Words phrase = tokens_of(row);
        for (std::size_t i = 1; i + phrase.size() + 1 < part.size(); ++i)
            if (part_of(part, i, i + phrase.size()) == phrase && relation_at(part, i + phrase.size()))
                part.erase(part.begin() + static_cast<std::ptrdiff_t>(i),
                           part.begin() + static_cast<std::ptrdiff_t>(i + phrase.size()));
    }
    if (part.size() > 2 && part[part.size() - 2] == "on" && part.back() == "top" && !talk.last.empty())
        part.insert(part.end(), {"of", "them"});
    return part;
}

}  // namespace

// "the armchair and the plant to the window", "the vase to the desk and the lamp to the shelf"
void move(Talk& talk, const Words& words) {
    std::vector<Words> before, parts;
    for (Words part : parts_of(words)) {
        // "The desks together, facing each other"
        if (!parts.empty() && is_one_of(text_of(part), {"facing each other", "back to back", "face to face"}) &&
            has_word(parts.back(), {"together"})) {
            parts.back() = joined_words(parts.back(), part);
            continue;
        }
        // "Away from the wall, closer to the window": both of them.
        const bool more_of_it = !parts.empty() && next_place(parts.back()) < parts.back().size() &&
                                (relation_at(part, 0) ||
                                 is_one_of(part.front(), {"closer", "nearer", "further", "away"}));
        if (more_of_it && part.front() != "facing") part = joined_words({"them"}, part);
        // "the sideboard to the left and the mirror along with it"
        const std::size_t with = find_word(part, {"with"}, 1);
        if (with + 2 != part.size() || !is_one_of(part.back(), {"it", "them"})) parts.push_back(part);
        else before.push_back(part_of(part, 0, is_one_of(part[with - 1], {"along", "together"}) ? with - 1 : with));
    }
    const auto move_part = [&](const auto& again, const Words& said) -> void {
        const Words part = as_move(talk, said);
        if (before.empty() && join_tables(talk, part, talk.last)) return;
        // "in front of the fireplace, facing it"
        if (part.front() == "facing" && !talk.last.empty()) {
            Words all{"them"};
            all.insert(all.end(), part.begin(), part.end());
            return face(talk, all);
        }
        if (next_place(part) == part.size()) {
            before.push_back(part);
            return;
        }
        if (const auto [place, target] = place_and_view(part); !target.empty()) {
            again(again, place);
            try {
                face(talk, joined_words({"them", "facing"}, target));
            } catch (const AlreadySo&) {
            }
            return;
        }
        // "The table to its center", of a rug that was spoken of
        if (const std::size_t n = part.size(); n > 3 && part[n - 2] == "its" && noun_of(part[n - 1]) == "middle" &&
                                               !talk.last.empty() && next_place(part) + 3 == n &&
                                               talk.editor.placed(talk.last.front()).flat) {
            center(talk, joined_words(part_of(part, 0, n - 3), {"on", "it"}));
            return;
        }
        // "The two sofas facing each other": a turn alone.
        if (const std::size_t place = next_place(part); part[place] == "facing" && before.empty())
            return face(talk, part);
        const std::vector<Words> first = std::exchange(before, {});
        // "in the middle of the room facing the door"
        if (const std::size_t facing = find_word(part, {"facing"}, 2);
            facing + 1 < part.size() && next_place(part) < facing) {
            move_one(talk, first, part_of(part, 0, facing));
            Words all{"them"};
            all.insert(all.end(), part.begin() + static_cast<std::ptrdiff_t>(facing), part.end());
            return face(talk, all);
        }
        move_one(talk, first, part);
    };
    do_each(
        talk.editor, parts.size(), [&](std::size_t k) { move_part(move_part, parts[k]); },
        [&](std::size_t k) { return text_of(parts[k]); });
    // "The desk to the window and the armchair in its place"
    if (const auto left = !before.empty() && talk.its_place && !talk.last.empty() ? left_by(talk, talk.last.front())
                                                                                  : std::nullopt) {
        std::vector<std::string> ids;
        for (const Words& part : before) add_new(ids, talk.things(part));
        return stand_at(talk, ids, *left);
    }
    if (!before.empty() && talk.there && (talk.last_gone || !talk.last_place.wish.relation.empty())) {
        // "remove the shelf and move the plant there"
        EditStep step = talk.last_gone ? EditStep{} : talk.last_place;
        step.kind = EditStep::Kind::place;
        step.position = talk.last_gone;
        for (const Words& part : before) {
            step.ids = talk.things(part);
            talk.editor.apply(step);
        }
        return;
    }
    if (!before.empty())
        throw UsageError("expected where to move \"{}\", for example \"to the window\"", text_of(before.front()));
}

}  // namespace fastscene::editing

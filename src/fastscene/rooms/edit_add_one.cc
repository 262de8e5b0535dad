// One thing that comes new: with its like, by the same as they, beside those that share its place.
#include <fmt/format.h>

#include <algorithm>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/document_parts.h"
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
bool drawn_up(Talk& talk, EditStep step, std::string& full) {
    if (!has_role(step.wish.kind, Role::seat) || !step.wish.relation.empty() || step.position) return false;
    const std::vector<Placed>& all = talk.editor.room().furnished.placed;
    for (const Placed& p : all) {
        if (asked_kind(p) != step.wish.kind || p.with < 0) continue;
        const Placed& table = all[static_cast<std::size_t>(p.with)];
        if (!has_role(table.piece.kind, Role::lamp_above)) continue;
        const std::string id = table.id;
        step.wish.relation_to = asked_kind(table);
        // At a bar on the side where the others are.
        std::vector<const char*> relations{"around"};
        if (const std::string side = side_of_seats(talk.editor, p.with); !side.empty())
            relations = {"around", side == "front" ? "in front of" : "behind"}, step.at = {table.id};
        for (const char* relation : relations) try {
                step.wish.relation = relation;
                talk.editor.apply(step);
                return true;
            } catch (const Error&) {
            }
        full = id;
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
        if (talk.last_gone && has_role(step.wish.kind, Role::seat)) step.yaw = talk.last_gone_yaw;
        // "Move the shelf to the door and put a chair there": where it stood.
        if (!talk.last_gone && !talk.last.empty()) step.position = left_by(talk, talk.last.front());
        if (!step.position && talk.last_place.wish.relation.empty())
            throw UsageError("where is \"there\"? nothing was moved or taken away before");
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
    const bool as_many = is_one_of(talk.said, {"put", "place", "set", "arrange"}) && step.wish.counted;
    if ((!in_all && !as_many) || talk.more || step.wish.relation != "around" || !has_role(step.wish.kind, Role::seat))
        return;
    int there = 0;
    for (const Placed& p : talk.editor.room().furnished.placed)
        if (p.with >= 0 && asked_kind(p) == step.wish.kind &&
            asked_kind(talk.editor.room().furnished.placed[static_cast<std::size_t>(p.with)]) == step.wish.relation_to)
            ++there;
    if (as_many && there == step.wish.count)
        throw AlreadySo(fmt::format("{} {} stand there already", there, step.wish.words));
    if (!in_all || there == 0 || there >= step.wish.count) return;
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
    std::string full;  // the table at which there was no room
    if (!place && talk.there) stand_there(talk, step);
    if (place && place->each_wall) {
        constexpr std::size_t kWalls = 4;
        const int share = step.wish.counted && step.wish.count == static_cast<int>(kWalls) ? 1 : step.wish.count;
        step.wish.count = std::max(1, share);
        do_each(
            talk.editor, kWalls, [&](std::size_t k) { step.wall = static_cast<int>(k), talk.editor.apply(step); },
            [&](std::size_t k) { return fmt::format("{} at wall {}", wish.words, k); });
    } else if (!place && (drawn_up(talk, step, full) || with_its_like(talk, step) || by_the_same(talk, step))) {
        // with its like, at their table
    } else if (place && !place->each_at.empty() && !(place->if_uncounted && wish.counted))
        do_each(talk.editor, place->each_at.size(),
                [&](std::size_t k) { step.at = place->each_at[k], talk.editor.apply(step); });
    else talk.editor.apply(step);
    if (!full.empty())
        talk.editor.note(kNotDone, fmt::format("{}: there was no room at {}: elsewhere, then", wish.words, full));
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

namespace {

constexpr float kSaidSmall = 0.87f;  // of its usual size, where a small one was asked for

std::optional<Piece> usual_piece(const Editor& editor, const PromptObject& wish) {
    PromptSpec spec = editor.room().spec;
    Random rng(editor.room().seed, "size");
    Layout layout(editor.plan(), spec, rng);
    if (!layout.why_not(wish.kind).empty()) return {};
    return make_piece(layout.request(wish.kind, &wish));
}

// Than such things are, though nobody said so.
bool is_smaller_than_usual(const Placed& p, const Style& style) {
    constexpr float kSeen = 0.95f, kFloor = 0.9f;  // of an extent; of the floor that it takes
    if (!p.piece.made_from || !(p.wish.size_m == Vec3f{})) return false;
    PieceRequest request = *p.piece.made_from;
    if (!request.style) request.style = &style;
    const float said = p.wish.size == "small" ? kSaidSmall : 1.f;
    if (request.size_m == Vec3f{}) return request.size_factor < kSeen * said;
    if (p.piece.mount != Mount::floor || p.flat || !p.piece.against_wall) return false;
    request.size_m = {}, request.size_factor = said;
    const Vec3f usual = make_piece(request).size_m;
    return p.piece.size_m.x * p.piece.size_m.z < kFloor * usual.x * usual.z;
}

}  // namespace

Vec3f Editor::usual_size(const PromptObject& wish) const {
    const auto piece = usual_piece(*this, wish);
    return piece ? piece->size_m : Vec3f{};
}

// As large as it is usual; where there is no room for that, smaller; of a number that was not said, as many as fit.
std::vector<Placed> Editor::with_added(const EditStep& step, bool& smaller) const {
    const Standing standing = without({});
    const bool stands = mount_of(*this, step.wish.kind) == Mount::floor && step.wish.relation != "on";
    const int most = std::max(1, step.wish.count), least = step.wish.counted && !step.each ? most : 1;
    for (int count = most; count >= least; --count)
        for (const float scale : {1.f, 0.82f, 0.66f, 0.56f}) {
            EditStep one = step;
            one.wish.count = count;
            if (scale < 1 && full_size_) break;
            if (scale < 1)
                if (const auto usual = usual_piece(*this, one.wish)) one.wish.size_m = shrunk_size(*usual, scale);
            constexpr float kLeastFurniture = 0.8f;
            if (scale < kLeastSeat && has_role(step.wish.kind, Role::seat)) break;
            // What stands on the floor stands closer before it is smaller still.
            if (scale < kLeastFurniture && stands) break;
            if (scale < 1 && (step.wish.size_m != Vec3f{} || one.wish.size_m == Vec3f{})) break;
            const std::vector<Placed> all = laid_out(standing, one, nullptr);
            // Pictures and mirrors shrink to the wall that is free: half as wide as usual, nobody calls them large.
            PromptObject usual = step.wish;
            usual.size.clear();
            if (!all.empty() && step.wish.size == "large" && all.back().piece.size_m.x < 0.5f * usual_size(usual).x)
                break;
            smaller = scale < 1;
            if (!all.empty()) return all;
        }
    throw Error("{}: there is no free place for it{}", step.wish.words, place_in_words(step));
}

// What came to what stood, as things of the document; their ids.
std::vector<std::string> Editor::admit(const std::vector<Placed>& all, const Standing& standing,
                                       const std::vector<std::string>& how) {
    std::vector<std::string> ids, out;
    for (const int was : standing.was) ids.push_back(thing(was).id);
    for (std::size_t i = standing.placed.size(); i < all.size(); ++i) {
        const std::string id = new_id(all[i].wish.kind.empty() ? all[i].piece.kind : all[i].wish.kind);
        ids.push_back(id), out.push_back(id);
        DocumentThing t = thing_of(all[i], ids, i);
        const std::string place = t.on.empty() ? how[std::min(out.size(), how.size()) - 1] : " on " + t.on;
        tell(t.id, fmt::format("added{} at x {:.2f}, z {:.2f}", place, t.position.x, t.position.z));
        if (is_smaller_than_usual(all[i], plan().style)) tell_smaller(t.id);
        result_.document.things.push_back(std::move(t));
    }
    return out;
}

void Editor::add(const EditStep& step) {
    if (step.wish.relation == "on both sides of" && step.wish.count == 2) check_no_pair(step);
    if (add_into_row(step) || seat_more(step) || lay_before_seats(step) || add_on_top(step)) return;
    bool smaller = false;
    std::vector<Placed> all;
    const std::size_t stood = result_.document.things.size();
    const auto squeezed = [&] {
        if (!add_squeezed(step)) return false;
        std::vector<std::string> ids;
        for (std::size_t i = stood; i < result_.document.things.size(); ++i)
            ids.push_back(result_.document.things[i].id);
        tell_uneven_pair(ids, step);
        return true;
    };
    try {
        all = with_added(step, smaller);
        // Not where the camera stands, nor in its way.
        const std::set<std::string> before = fault_texts(room_.furnished.placed), now = fault_texts(all);
        if (!std::includes(before.begin(), before.end(), now.begin(), now.end()) && squeezed()) return;
    } catch (const Error&) {
        if (squeezed()) return;
        throw Error("{}", why_none_added(step));
    }
    std::vector<std::string> fresh;
    together([&] {
        fresh = admit(all, without({}), {place_in_words(step)});
        for (const std::string& id : fresh)
            if (smaller) tell_smaller(id);
        try {
            build();
        } catch (const Error&) {  // the camera stands there
            throw Error("{}", why_none_added(step));
        }
    });
    for (const std::string& id : fresh) tell_aside(id, step), tell_distance(id, step);
    tell_uneven_pair(fresh, step);
    if (step.each) tell_missing_corners(step, fresh.size());
}

}  // namespace fastscene::editing

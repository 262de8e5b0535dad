// What stands in the room and is to stand elsewhere in it: at a window, on a table, in another corner.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_relations.h"

namespace fastscene::editing {

void Editor::place(const EditStep& step) {
    if (seat_those(step)) return;
    do_each(*this, step.ids.size(), [&](std::size_t k) { place_with_seats(index_of(step.ids[k]), step); });
}

void Editor::place_with_seats(int index, const EditStep& step) {
    const std::vector<int> seats = seats_at(index);
    if (!seats.empty()) try {
            return place_one(index, seats, step);
        } catch (const Error&) {  // there is no room for them: it goes alone
        }
    place_one(index, {}, step);
    bring_seats(index, seats);
}

// Those for which there was no room as they stood come one by one, each where it has room at the table.
void Editor::bring_seats(int table, const std::vector<int>& seats) {
    std::vector<std::string> left;
    for (const int i : seats) try {
            const std::string id = thing(i).id;
            const auto there = place_of(*this, {"to", thing(table).id}, asked_kind(placed(i)), id);
            if (!there) throw Error("{}: it has no place there", id);
            EditStep step = there->step;
            step.kind = EditStep::Kind::place;
            step.ids = {id}, step.at = {thing(table).id};
            place_one(i, {}, step);
        } catch (const AlreadySo&) {  // it stands at it still
        } catch (const Error&) {
            left.push_back(thing(i).id);
        }
    if (!left.empty())
        note(kNotDone,
             fmt::format("{} cannot go with {}: there is no room there", fmt::join(left, ", "), thing(table).id));
}

void Editor::place_one(int index, const std::vector<int>& along, EditStep step) {
    std::vector<int> moving{index};
    moving.insert(moving.end(), along.begin(), along.end());
    const Standing standing = without(with_riders(moving));
    const Placed was = placed(index);
    const std::string id = thing(index).id;
    PromptObject& wish = step.wish;
    wish.kind = was.wish.kind.empty() ? was.piece.kind : was.wish.kind;
    wish.words = in_words(wish.kind);
    wish.count = 1;
    wish.size_m = was.piece.size_m, step.yaw = was.yaw;
    if (std::find(step.at.begin(), step.at.end(), id) != step.at.end())
        throw UsageError("{}: it cannot stand{}", id, place_in_words(step));
    if (was.sill >= 0 && wish.relation == "next to" && noun_of(wish.relation_to) == "window" && !step.position)
        throw AlreadySo(id + ": it stands there already");
    const std::vector<Placed> all = laid_out(standing, step, &was);
    constexpr float kThere = 0.02f, kNudge = 0.25f;  // metres
    if (all.size() != standing.placed.size() + 1) {
        if (place_squeezed(index, step, along)) return;
        throw Error("{}: there is no free place for it{}{}", id, place_in_words(step),
                    what_is_missing(step, &was, with_riders(moving)));
    }
    const Placed& found = all.back();
    PromptObject now = wish;
    now.id = -2;  // none of those that stand there
    const bool there = step.wall < 0 && !step.elsewhere && step.at.empty() && !wish.relation.empty() &&
                       is_where_asked(plan(), room_.furnished.placed, placed(index), now);
    if (length(found.position - was.position) < (there ? kNudge : kThere))
        throw AlreadySo(id + ": it stands there already");
    try {
        checked([&] { stand_at_found(index, found, standing, step, along); });
        tell_distance(id, step);
    } catch (const Error& e) {
        const std::vector<Placed> other = laid_out(standing, step, &was, true);
        if (other.size() == standing.placed.size() + 1) try {
                return checked([&] { stand_at_found(index, other.back(), standing, step, along); });
            } catch (const Error&) {  // more closely, then
            }
        if (!place_squeezed(index, step, along))
            throw Error("{}: there is no place for it{}: {}", id, place_in_words(step), e.what());
    }
}

// What was to hang above a thing and hangs above its end.
void Editor::tell_aside(const std::string& id, const EditStep& step) {
    constexpr float kAside = 0.45f;  // of its half
    if (step.wish.relation != "above" || step.wish.count > 1) return;
    float least = 1e9f;
    for (const Placed& below : room_.furnished.placed)
        if (asked_kind(below) == step.wish.relation_to || below.piece.kind == step.wish.relation_to)
            least = std::min(least, std::abs(dot(placed(id).position - below.position, right_of(below.yaw))) /
                                        std::max(0.1f, below.piece.size_m.x / 2));
    if (least > kAside && least < 2) tell(id, "not above its middle: there was no more room");
}

// "Next to the desk", and yet with a step between them.
void Editor::tell_distance(const std::string& id, const EditStep& step) {
    constexpr float kNext = 0.9f;  // metres from edge to edge
    constexpr float kMiddle = 0.8f;
    if (step.wish.relation == "in the middle" && step.wish.relation_to.empty() &&
        placed(id).piece.mount == Mount::floor && step.wish.count < 2)
        if (const float off = length(footprint_of(placed(id)).center); off > kMiddle)
            return tell(id, fmt::format("{:.1f} m off the middle: there was no nearer place", off));
    if (!is_one_of(step.wish.relation, {"next to", "left of", "right of", "on both sides of"}) ||
        !noun_of(step.wish.relation_to).empty())
        return;
    const Placed& p = placed(id);
    if (p.piece.mount != Mount::floor) return;
    const Footprint box = footprint_of(p);
    float least = 1e9f;
    for (const std::string& at : things_at(*this, step)) {
        if (at == id) continue;
        const Footprint there = footprint_of(placed(at));
        const Vec2f to = there.center - box.center;
        least = std::min(least, distance_to(there, box.center) - extent(box, to * (1 / std::max(0.01f, length(to)))));
    }
    if (least > kNext && least < 1e8f) tell(id, fmt::format("{:.1f} m off: there was no nearer place", least));
}

void Editor::stand_at_found(int index, const Placed& found, const Standing& standing, const EditStep& step,
                            const std::vector<int>& along) {
    DocumentThing& t = thing(index);
    const auto id_of = [&](int i) {
        const int old = i < 0 || i >= static_cast<int>(standing.was.size()) ? -1
                                                                            : standing.was[static_cast<std::size_t>(i)];
        return old < 0 ? std::string() : thing(old).id;
    };
    t.on = id_of(found.on), t.below = id_of(found.below), t.with = id_of(found.with);
    t.window = found.sill;
    t.mount.reset();
    if (found.piece.mount != found.piece.made_mount) t.mount = found.piece.mount;
    if (t.asked) t.asked->relation = step.wish.relation, t.asked->relation_to = step.wish.relation_to;
    set_pose(index, {found.position, found.yaw}, along);
}

}  // namespace fastscene::editing

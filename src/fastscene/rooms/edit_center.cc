// "Center the rug under the table", "the picture above the sofa", "the tv on the wall": middles in line.
#include <algorithm>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_relations.h"

namespace fastscene::editing {
namespace {

constexpr float kInLine = 0.02f;  // metres

// By how much a thing is off the middle of a wall, along it.
Vec2f off_wall_middle(const Plan& plan, int wall, const Placed& p) {
    const WallFace face = plan.wall(wall);
    const Vec2f along = flat(face.along);
    return along * dot(flat(face.point(face.length / 2, 0)) - footprint_of(p).center, along);
}

// The middle of what a place is at; nothing: it is at no thing and no opening.
std::optional<Vec2f> middle_of(const Editor& editor, const EditStep& place, Vec2f from) {
    std::optional<Vec2f> best;
    const auto take = [&](Vec2f there) {
        if (!best || length(there - from) < length(*best - from)) best = there;
    };
    if (place.wish.relation == "between" && !place.at.empty() && !place.at_and.empty())
        return (footprint_of(editor.placed(place.at.front())).center +
                footprint_of(editor.placed(place.at_and.front())).center) *
               0.5f;
    for (const std::string& id : things_at(editor, place)) take(footprint_of(editor.placed(id)).center);
    std::vector<Vec2f> openings;
    for (const Opening& o : editor.plan().openings)
        if (is_opening_of(o, place.wish.relation_to))
            openings.push_back(flat(editor.plan().wall(o.wall).point((o.u0 + o.u1) / 2, 0)));
    if (place.wish.relation == "between" && openings.size() == 2) return (openings[0] + openings[1]) * 0.5f;
    for (const Vec2f at : openings) take(at);
    return best;
}

// Of several, the one nearest to what it is to be centered at.
std::vector<std::string> those_there(Talk& talk, const Words& words, const Words& place) {
    const std::vector<int> found = all_named(talk.editor, text_of(words));
    if (found.size() < 2) return talk.things(words);
    const std::string first = talk.editor.document().things[static_cast<std::size_t>(found.front())].id;
    const auto there = place_of(talk.editor, place, asked_kind(talk.editor.placed(first)), first, talk.last);
    const auto off = [&](int i) {
        const Vec2f at = footprint_of(talk.editor.room().furnished.placed[static_cast<std::size_t>(i)]).center;
        const auto to = there ? middle_of(talk.editor, there->step, at) : std::nullopt;
        return to ? length(*to - at) : 1e9f;
    };
    const int best = *std::min_element(found.begin(), found.end(), [&](int a, int b) { return off(a) < off(b); });
    return talk.last = {talk.editor.document().things[static_cast<std::size_t>(best)].id};
}

}  // namespace

bool center(Talk& talk, const Words& words) {
    const std::size_t end = next_place(words);
    if (end == words.size()) return false;
    const Words there = part_of(words, end);
    const auto relation = relation_at(there, 0);
    const auto part = relation ? room_part(there, relation->next) : std::nullopt;
    if (part && part->noun != "wall" && part->noun != "window") return false;
    if (!part && is_one_of(noun_of(there.back()), {"room", "middle", "floor", "side", "corner"})) return false;
    const std::vector<std::string> spoken = talk.last;
    for (const std::string& id : those_there(talk, part_of(words, 0, end), there)) {
        const Placed& p = talk.editor.placed(id);
        const auto place = place_of(talk.editor, there, asked_kind(p), id, spoken);
        if (!place) return false;
        Vec2f by{};
        const int wall = place->step.wall >= 0 ? place->step.wall : wall_behind(talk.editor.plan(), p);
        if (part && part->noun == "wall") {
            if (wall < 0) return false;
            by = off_wall_middle(talk.editor.plan(), wall, p);
        } else {
            const auto to = middle_of(talk.editor, place->step, footprint_of(p).center);
            if (!to) return false;
            by = *to - footprint_of(p).center;
        }
        // What stands or hangs at a wall stays at it.
        if (wall >= 0 && !is_one_of(place->step.wish.relation, {"on", "under"})) {
            const Vec2f along = flat(talk.editor.plan().wall(wall).along);
            by = along * dot(by, along);
        }
        if (length(by) < kInLine) throw AlreadySo(id + ": it is in the middle there already");
        EditStep step;
        step.kind = EditStep::Kind::shift;
        step.ids = {id};
        step.by = {by.x, 0, by.y}, step.exactly = true;
        talk.editor.apply(step);
        talk.last_place = place->step;
    }
    return true;
}

}  // namespace fastscene::editing

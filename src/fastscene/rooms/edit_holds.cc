// Whether a thing stands as a place says: looser than places are searched for, so that what fails here is plainly not
// there.
#include <algorithm>
#include <cmath>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_audit.h"
#include "fastscene/rooms/layout_relations.h"

namespace fastscene::editing {
namespace {

constexpr float kBeside = 1;     // metres between edges: further off, nobody says "next to"
constexpr float kBefore = 1.6f;  // … "in front of"
constexpr float kTouching = 0.06f;

Vec2f ahead_of(const Footprint& box) { return flat(front_of(box.yaw)); }

}  // namespace

Landmark landmark_of(const Shown& shown) { return {shown.box, shown.thing.id, shown.flat, -1}; }

float apart(const Shown& shown, const Landmark& at) { return gap_between(shown.box, at.box); }

std::vector<Landmark> landmarks_called(const Editor& editor, const Snapshot& room, const Mention& mention) {
    std::vector<Landmark> out;
    for (const Shown& s : room.things)
        if (is_called(s.thing, mention)) out.push_back(landmark_of(s));
    const Plan& plan = editor.plan();
    for (std::size_t i = 0; i < plan.openings.size(); ++i) {
        const Opening& o = plan.openings[i];
        const bool door = is_one_of(mention.meaning, {"door", "doorway"}) && o.kind != Opening::Kind::window;
        if (mention.kind != Mention::Kind::part || (!door && !is_opening_of(o, mention.meaning))) continue;
        const WallFace face = plan.wall(o.wall);
        out.push_back({{flat(face.point((o.u0 + o.u1) / 2, 0)),
                        {(o.u1 - o.u0) / 2, 0.01f},
                        std::atan2(face.inward.x, face.inward.z),
                        o.y0,
                        o.y1},
                       "",
                       false,
                       static_cast<int>(i)});
    }
    return out;
}

bool holds_at(const Shown& shown, const std::string& relation, const Landmark& at, float slack) {
    const float far = apart(shown, at) - slack;
    const Vec2f to = at.box.center - shown.box.center;
    const float ahead = -dot(to, ahead_of(at.box));
    const bool carried = !at.id.empty() && shown.thing.on == at.id;
    const bool on_sill = at.opening >= 0 && shown.thing.window == at.opening;
    if (relation == "on") {
        if (carried || on_sill) return true;
        if (shown.mount != Mount::floor && shown.mount != Mount::surface) return far < 0.3f;
        return far < kTouching && shown.thing.on.empty() && (at.flat || at.box.y1 < 0.1f);
    }
    if (relation == "under") {
        if (at.opening >= 0) return shown.mount != Mount::floor ? far < 0.7f : is_below(shown.box, at.box);
        // Its middle, or that of what is above it.
        constexpr float kAside = 0.25f;  // metres
        const bool below = distance_to(at.box, shown.box.center) < kAside ||
                           distance_to(shown.box, at.box.center) < kAside;
        return far < kTouching && below;
    }
    constexpr float kBehindIt = 1.5f;  // metres: on the wall behind a bar
    if (relation == "above" && (carried || (shown.mount == Mount::wall && far < kBehindIt))) return true;
    if (relation == "above") return far < 0.5f && (at.opening >= 0 || shown.box.y1 > at.box.y1);
    if (relation == "in front of") return far < kBefore && (at.flat || ahead > -0.05f);
    if (relation == "behind") return far < kBefore && ahead < 0.05f;
    if (relation == "opposite") return ahead > 0 || dot(to, ahead_of(shown.box)) > 0;
    if (relation == "facing") {
        // Who sits at a desk looks over it: either way.
        if (has_role(shown.thing.kind, Role::work_place) && std::abs(dot(ahead_of(shown.box), to)) > 0.5f * length(to))
            return true;
        constexpr float kTurnedTo = 0.6f;  // cosine
        if (dot(ahead_of(shown.box), to) > kTurnedTo * length(to)) return true;
        // Square to what looks back: rows before a board.
        if (dot(ahead_of(shown.box), ahead_of(at.box)) < -0.9f && ahead > 0) return true;
        // Square to what is wide: straight ahead lies some of it.
        return dot(ahead_of(shown.box), to) > 0 &&
               distance_to(at.box, shown.box.center + ahead_of(shown.box) * dot(ahead_of(shown.box), to)) < 0.1f;
    }
    if (relation == "at the foot of") return carried || (far < 0.8f && ahead > 0);
    return carried || on_sill || far < kBeside;
}

bool holds_in_room(const Plan& plan, const Shown& shown, const std::string& relation) {
    const Footprint& box = shown.box;
    const float aside = plan.width / 2 - std::abs(box.center.x) - extent(box, {1, 0});
    const float along = plan.depth / 2 - std::abs(box.center.y) - extent(box, {0, 1});
    constexpr float kInCorner = 0.8f, kAtWall = 0.4f;  // metres
    if (relation == "in the corner") return !plan.blocks.empty() || (aside < kInCorner && along < kInCorner);
    if (relation == "against")
        return shown.mount == Mount::wall || !plan.blocks.empty() || std::min(aside, along) < kAtWall;
    constexpr float kMiddle = 0.3f;  // of the room, to each side
    if (relation == "in the middle")
        return !plan.blocks.empty() ||
               (std::abs(box.center.x) < kMiddle * plan.width && std::abs(box.center.y) < kMiddle * plan.depth);
    return true;
}

bool is_between_those(const Shown& shown, const std::vector<Landmark>& some, const std::vector<Landmark>& others) {
    constexpr float kAside = 1;  // metres off the line
    for (const Landmark& a : some)
        for (const Landmark& b : others) {
            const Vec2f way = b.box.center - a.box.center, to = shown.box.center - a.box.center;
            const float l = length(way);
            if (l < 0.1f || (!a.id.empty() && a.id == shown.thing.id) || (!b.id.empty() && b.id == shown.thing.id))
                continue;
            const float t = dot(to, way) / (l * l), off = std::abs(to.x * way.y - to.y * way.x) / l;
            if (t > 0.03f && t < 0.97f && off < kAside) return true;
        }
    return false;
}

}  // namespace fastscene::editing

// Mezzanines: a floor halfway up, and the room on it.
#include <algorithm>
#include <cmath>

#include "fastscene/rooms/plan_parts.h"
#include "fastscene/rooms/room_type.h"

namespace fastscene {
namespace {

constexpr float kFloor = 2.6f;                       // metres: of the mezzanine, above the room's
constexpr float kHeadroom = 2.2f;                    // on it
constexpr float kLeastDepth = 2.2f, kMostDepth = 3;  // of it
constexpr float kBefore = 1.2f;                      // from the near wall to the foot of the stairs

}  // namespace

void add_mezzanine(PromptSpec& spec, Plan& plan, Random& rng) {
    const PromptObject* wish = wish_for(spec, "mezzanine");
    if (!wish) return;
    report(spec, *wish, wish->count - 1, "a room has one");
    const bool low = spec.size_m.y > 0 && plan.height<kFloor + kHeadroom, boxed = plan.knee> 0 ||
                     plan.vault != Vault::flat || plan.cabin || has_cut_corners(plan);
    if (low || boxed) return report(spec, *wish, 1, low ? "the room is too low for it" : "not in a room of this shape");
    const float stairs = kMezzanineSteps * kMezzanineGoing, least = kLeastDepth + stairs + kBefore;
    if (plan.measured && plan.depth < least) return report(spec, *wish, 1, "the room is too short for its stairs");
    plan.depth = std::max(plan.depth, least);
    plan.height = std::max(plan.height, kFloor + kHeadroom);
    plan.blocks.clear(), plan.bay = false, plan.beams = plan.coffers = false;
    Mezzanine& m = plan.mezzanine;
    m.floor = kFloor;
    m.depth = std::clamp(0.4f * plan.depth, kLeastDepth, std::min(kMostDepth, plan.depth - stairs - kBefore));
    m.stairs_wall = rng.chance(0.5f) ? 1 : 3;
    const float side = m.stairs_wall == 1 ? 1.f : -1.f, wall = side * plan.width / 2,
                open = side * (plan.width / 2 - kMezzanineStairs), edge = plan.mezzanine_edge();
    plan.blocks.push_back({Block::Kind::stairs, {std::min(wall, open), edge - stairs}, {std::max(wall, open), edge}});
}

void open_mezzanine(PromptSpec& spec, Plan& plan) {
    // Windows of side walls before it go up to the ceiling.
    constexpr float kLintelAbove = 0.45f;
    for (Opening& o : plan.openings) {
        if (o.kind != Opening::Kind::window || o.wall % 2 == 0 || o.shape != Opening::Shape::square) continue;
        const WallFace face = plan.wall(o.wall);
        if (std::max(face.point(o.u0, 0).z, face.point(o.u1, 0).z) < plan.mezzanine_edge() - 0.1f)
            o.y1 = plan.height - kLintelAbove;
    }
    auto up = std::make_shared<NextRoom>();
    const std::string& upstairs = room_type(spec.room).upstairs;
    up->type = upstairs.empty() ? spec.room : upstairs;
    Plan& p = up->plan;
    p.style = plan.style;
    p.joined = true;
    p.width = plan.width, p.depth = plan.mezzanine.depth, p.height = plan.height - plan.mezzanine.floor;
    p.style.shelves = room_type(up->type).shelves;
    // Its near side is open: all of it is kept free, as a way.
    Opening open;
    open.kind = Opening::Kind::doorway, open.wall = 2;
    open.u1 = p.width, open.y1 = p.height;
    p.openings.push_back(open);
    up->room_from_next = {Mat3f{}, {0, plan.mezzanine.floor, plan.depth / 2 - p.depth / 2}};
    plan.next = std::move(up);
}

}  // namespace fastscene

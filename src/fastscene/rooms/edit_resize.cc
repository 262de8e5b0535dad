// Things made larger and smaller where they stand, with what stands on them and at them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_relations.h"

namespace fastscene::editing {
namespace {

// Its back stays at its wall, what hangs keeps its middle, curtains their rod.
Vec3f after_resize(const Placed& p, Vec3f size) {
    Vec3f at = p.position;
    const Vec3f more = size - p.piece.size_m;
    if (p.piece.mount == Mount::wall) at.y -= has_role(p.piece.kind, Role::soft) ? more.y : more.y / 2;
    else if (p.piece.mount == Mount::floor && p.piece.against_wall) at += front_of(p.yaw) * (more.z / 2);
    return at;
}

bool is_among_those(int i, const std::vector<int>& those) {
    return std::find(those.begin(), those.end(), i) != those.end();
}

// The spot on a top nearest to where a thing is to stand at which it reaches into none of those that stand there.
Vec2f free_spot(const Placed& top, const Footprint& box, const std::vector<Footprint>& taken) {
    constexpr float kStep = 0.04f;  // metres
    const Footprint under = footprint_of(top);
    const auto axes = axes_of(under);
    const float wide = under.half.x - extent(box, axes[0]), deep = under.half.y - extent(box, axes[1]);
    const auto is_free = [&](Vec2f at) {
        return std::none_of(taken.begin(), taken.end(), [&](const Footprint& t) {
            return overlap(t, Footprint{at, box.half, box.yaw, t.y0, t.y1});
        });
    };
    Vec2f best = box.center;
    float nearest = is_free(best) ? 0.f : 1e9f;
    for (float x = -wide; x <= wide && nearest > 0; x += kStep)
        for (float z = -deep; z <= deep; z += kStep) {
            const Vec2f at = under.center + axes[0] * x + axes[1] * z;
            if (const float far = length(at - box.center); far < nearest && is_free(at)) nearest = far, best = at;
        }
    return best;
}

}  // namespace

// What stands on a thing of another size keeps its place on the top; on a smaller one, as far as there is room.
void Editor::carry_riders(int index, const Placed& before, Vec3f factor) {
    const Placed& after = placed(index);
    const Vec3f right = right_of(before.yaw), front = front_of(before.yaw);
    std::vector<int> riders;
    for (const int i : with_riders({index}))
        if (placed(i).on == index) riders.push_back(i);
    // What is laid before seats has its place there.
    std::stable_partition(riders.begin(), riders.end(),
                          [&](int i) { return has_role(placed(i).piece.kind, Role::before_seats); });
    std::vector<Footprint> taken;
    for (const int i : riders) {
        const Vec3f d = placed(i).position - before.position;
        Vec3f to = after.position + right * (dot(d, right) * factor.x) + front * (dot(d, front) * factor.z);
        to.y = placed(i).position.y;
        const auto& tops = before.piece.surfaces;
        for (std::size_t k = 0; k < std::min(tops.size(), after.piece.surfaces.size()); ++k)
            if (std::abs(tops[k].center.y - d.y) < 0.02f) to.y = after.position.y + after.piece.surfaces[k].center.y;
        Footprint box = footprint_of(placed(i));
        const Vec2f off = box.center - flat(placed(i).position);
        box.center = flat(to) + off;
        if (factor.x < 1 || factor.z < 1) {
            box.center = free_spot(after, box, taken);
            to.x = box.center.x - off.x, to.z = box.center.y - off.y;
        }
        taken.push_back(box);
        const Vec3f step = to - placed(i).position;
        for (const int k : with_riders({i})) thing(k).position += step;
    }
}

// Chairs keep their distance from the edges of their table.
void Editor::keep_seats(int index, const Placed& before) {
    const Placed& after = placed(index);
    const Vec3f right = right_of(before.yaw), front = front_of(before.yaw);
    const Vec3f old = before.piece.size_m * 0.5f, more = after.piece.size_m * 0.5f - old;
    std::vector<int> around = seats_at(index);
    // What stands beside a bed stands beside it still.
    for (int i = 0; i < static_cast<int>(room_.furnished.placed.size()); ++i) {
        const Placed& p = placed(i);
        if (!has_role(before.piece.kind, Role::bed)) break;
        if (p.with == index && p.piece.mount == Mount::floor && !p.flat && p.on < 0 && !is_among_those(i, around))
            around.push_back(i);
    }
    for (const int i : around) {
        const Vec3f d = placed(i).position - before.position;
        const float x = dot(d, right), z = dot(d, front);
        const auto moved = [](float at, float half, float by) {
            return std::abs(at) > half ? std::copysign(1.f, at) * by : at * by / half;
        };
        Vec3f by = after.position - before.position + right * moved(x, old.x, more.x) + front * moved(z, old.z, more.z);
        // What stands at the same wall stays at it.
        if (before.piece.against_wall && std::abs(x) > old.x && placed(i).piece.against_wall)
            by = by - front * dot(by, front);
        for (const int k : with_riders({i})) thing(k).position += Vec3f{by.x, 0, by.z};
        constexpr float kSeen_m = 0.02f;
        if (length(flat(by)) > kSeen_m && has_role(before.piece.kind, Role::bed))
            tell(thing(i).id, "moved with " + thing(index).id);
    }
}

namespace {

// As far off the walls as a rug is to lie, or where it was.
Vec3f off_walls(const Plan& plan, const Placed& rug) {
    constexpr float kOffWall_m = 0.03f, kMost_m = 0.8f;
    const Footprint box = footprint_of(rug);
    const auto within = [](float at, float half, float reach) {
        return half > reach ? std::clamp(at, reach - half, half - reach) : at;
    };
    Vec3f to = rug.position;
    to.x = within(to.x, plan.width / 2, extent(box, {1, 0}) + kOffWall_m);
    to.z = within(to.z, plan.depth / 2, extent(box, {0, 1}) + kOffWall_m);
    return length(to - rug.position) < kMost_m ? to : rug.position;
}

}  // namespace

// Where it stands, else shifted a little. What is wrong with it in that size; empty: done.
std::string Editor::resize_to(int index, Vec3f factor) {
    const Placed before = placed(index);
    Vec3f size = before.piece.size_m;
    for (std::size_t a = 0; a < 3; ++a) size[a] *= factor[a];
    // Some builders keep an extent: a sofa is as deep as sofas are.
    PieceRequest request = *before.piece.made_from;
    if (!request.style) request.style = &plan().style;
    // As high as it is usual: of a desk with a screen the height is not that of its top.
    const bool same_height = factor.y == 1 && request.size_m.y == 0 && request.size_factor == 1;
    request.size_m = same_height ? Vec3f{size.x, 0, size.z} : size, request.size_factor = 1;
    const Vec3f made = make_piece(request).size_m;
    std::string fault;
    constexpr int kMostTries = 8;  // each builds the room
    int tries = 0;
    for (const float aside : {0.f, 0.1f, -0.1f, 0.2f, -0.2f, 0.35f, -0.35f, 0.5f, -0.5f})
        for (const float ahead : {0.f, 0.1f, -0.1f, 0.2f, -0.2f, 0.3f, -0.3f}) {
            const bool here = aside == 0 && ahead == 0;
            if (ahead != 0 && before.piece.mount != Mount::floor) continue;
            constexpr float kOffWall_m = 0.1f;
            if (before.piece.against_wall && (ahead < 0 || ahead > kOffWall_m)) continue;
            Vec3f at = after_resize(before, made) + right_of(before.yaw) * aside + front_of(before.yaw) * ahead;
            Placed larger = before;
            larger.position = at, larger.piece.size_m = made;
            if (before.flat) larger.position = at = off_walls(plan(), larger);
            constexpr float kTouch_m = 0.01f;
            if (before.flat && !plan().holds(shrunk(footprint_of(larger), kTouch_m))) {
                fault = "it reaches into a wall";
                continue;
            }
            if (!here && before.piece.mount == Mount::floor &&
                !stands_clear(index, footprint_of(larger), seats_at(index)))
                continue;
            if (++tries > kMostTries) return fault;
            try {
                checked([&] {
                    DocumentThing& t = thing(index);
                    t.size_m = same_height ? made : size;
                    if (same_height) t.asked_size_m = request.size_m, t.size_factor = 1;
                    t.position = at;
                    build();
                    carry_riders(index, before, factor);
                    keep_seats(index, before);
                    const Vec3f is = placed(index).piece.size_m;
                    tell(thing(index).id, fmt::format("size: {:.2f} x {:.2f} x {:.2f} m", is.x, is.y, is.z));
                });
                return {};
            } catch (const Error& e) {
                if (fault.empty()) fault = e.what();
            }
        }
    return fault;
}

// "Larger" is as much larger as there is room for, down to what is still seen; "twice as large" is that or nothing.
void Editor::resize_one(int index, Vec3f factor, bool exactly) {
    std::string fault;
    for (const float part : {1.f, 0.75f, 0.5f, 0.35f}) {
        if (part < 1 && exactly) break;
        Vec3f some = factor;
        for (std::size_t a = 0; a < 3; ++a) some[a] = 1 + (factor[a] - 1) * part;
        const std::string wrong = resize_to(index, some);
        if (wrong.empty()) return;
        if (fault.empty()) fault = wrong;
    }
    throw Error("{}: there is no room for it in that size: {}", thing(index).id, fault);
}

void Editor::resize(const EditStep& step) {
    do_each(*this, step.ids.size(),
            [&](std::size_t k) { resize_one(index_of(step.ids[k]), step.factor, step.exactly); });
}

}  // namespace fastscene::editing

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

}  // namespace

// What stands on a thing of another size keeps its place on the top.
void Editor::carry_riders(int index, const Placed& before, Vec3f factor) {
    const Placed& after = placed(index);
    const Vec3f right = right_of(before.yaw), front = front_of(before.yaw);
    for (const int i : with_riders({index})) {
        if (placed(i).on != index) continue;
        const Vec3f d = placed(i).position - before.position;
        Vec3f to = after.position + right * (dot(d, right) * factor.x) + front * (dot(d, front) * factor.z);
        to.y = placed(i).position.y;
        const auto& tops = before.piece.surfaces;
        for (std::size_t k = 0; k < std::min(tops.size(), after.piece.surfaces.size()); ++k)
            if (std::abs(tops[k].center.y - d.y) < 0.02f) to.y = after.position.y + after.piece.surfaces[k].center.y;
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
            return std::abs(at) > half ? std::copysign(by, at) : at * by / half;
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

// Where it stands, else shifted a little. What is wrong with it in that size; empty: done.
std::string Editor::resize_to(int index, Vec3f factor) {
    const Placed before = placed(index);
    Vec3f size = before.piece.size_m;
    for (std::size_t a = 0; a < 3; ++a) size[a] *= factor[a];
    // Some builders keep an extent: a sofa is as deep as sofas are.
    PieceRequest request = *before.piece.made_from;
    if (!request.style) request.style = &plan().style;
    request.size_m = size, request.size_factor = 1;
    const Vec3f made = make_piece(request).size_m;
    std::string fault;
    constexpr int kMostTries = 8;  // each builds the room
    int tries = 0;
    for (const float aside : {0.f, 0.1f, -0.1f, 0.2f, -0.2f, 0.35f, -0.35f, 0.5f, -0.5f})
        for (const float ahead : {0.f, 0.1f, -0.1f, 0.2f, -0.2f, 0.3f, -0.3f}) {
            const bool here = aside == 0 && ahead == 0;
            if (!here && before.flat) return fault;
            if (ahead != 0 && (before.piece.mount != Mount::floor || before.piece.against_wall)) continue;
            const Vec3f at = after_resize(before, made) + right_of(before.yaw) * aside + front_of(before.yaw) * ahead;
            Placed larger = before;
            larger.position = at, larger.piece.size_m = made;
            if (!here && before.piece.mount == Mount::floor &&
                !stands_clear(index, footprint_of(larger), seats_at(index)))
                continue;
            if (++tries > kMostTries) return fault;
            try {
                checked([&] {
                    thing(index).size_m = size;
                    thing(index).position = at;
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

// Things that take the places of others, and change places: on the floor, on walls, on tops.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_parts.h"

namespace fastscene::editing {
namespace {

// How it is where it is: what is set on tops may stand on the floor.
Mount mount_there(const Placed& p) { return p.on >= 0 || p.sill >= 0 ? Mount::surface : p.piece.mount; }

std::string where_it_is(const Placed& p, const std::vector<Placed>& all) {
    if (p.on >= 0) return "stands on " + all[static_cast<std::size_t>(p.on)].id;
    if (p.sill >= 0) return "stands on a windowsill";
    if (p.piece.mount == Mount::wall) return "hangs on a wall";
    return p.piece.mount == Mount::ceiling ? "hangs from the ceiling" : "stands on the floor";
}

// What hangs on walls and what stands on the floor: each below or above where the other was.
bool of_floor_and_wall(const Placed& a, const Placed& b) {
    const auto is = [&](Mount one, Mount other) { return mount_there(a) == one && mount_there(b) == other; };
    return is(Mount::floor, Mount::wall) || is(Mount::wall, Mount::floor);
}

}  // namespace

namespace {

// Where a piece stands in the place of another on the floor: its back where the other's was, or their middles; the
// others further along and further out from there.
std::vector<Vec2f> spots(const Plan& plan, const Piece& piece, const Placed& place, float aside) {
    std::vector<Vec2f> out;
    const Vec2f front = flat(front_of(place.yaw)), right = flat(right_of(place.yaw));
    // A bench that stands at a wall has its back there as well.
    const bool backs = piece.against_wall && (place.piece.against_wall || wall_behind(plan, place) >= 0);
    const float back = backs ? (piece.size_m.z - place.piece.size_m.z) / 2 : 0.f;
    for (const float along : {0.f, 0.12f, -0.12f, 0.25f, -0.25f, 0.4f, -0.4f, 0.6f, -0.6f})
        for (const float out_by : {0.f, 0.05f, 0.12f, 0.22f, 0.35f}) {
            constexpr float kOffWall = 0.12f;  // metres: further off, its back is at no wall
            if (backs && out_by > kOffWall) continue;
            const Vec2f at = flat(place.position) + right * (aside + along);
            out.push_back(at + front * (back + out_by));
            if (!place.piece.against_wall && !backs) out.push_back(at - front * out_by);
        }
    return out;
}

std::optional<int> stand_in_place(Layout& layout, const PieceRequest& request, const PromptObject& wish,
                                  const Placed& place, float aside) {
    const Piece piece = make_piece(request);
    // What has a back and comes for what has none stands with it at the wall.
    Placed there = place, turned = place;
    turned.yaw = std::remainder(place.yaw + kPi, 2 * kPi);
    if (piece.against_wall && !place.piece.against_wall && wall_behind(layout.plan(), place) < 0 &&
        wall_behind(layout.plan(), turned) >= 0)
        there = turned;
    for (const Vec2f at : spots(layout.plan(), piece, there, aside))
        if (const auto i = layout.stand_at(piece, at, there.yaw, wish, {})) return i;
    return {};
}

std::optional<int> hang_in_place(Layout& layout, const PieceRequest& request, const PromptObject& wish,
                                 const Placed& place, float aside) {
    Piece piece = make_piece(request);
    if (piece.mount == Mount::surface) mount_as(piece, Mount::wall);
    piece.hang_height_m = std::max(0.05f, place.position.y + (place.piece.size_m.y - piece.size_m.y) / 2);
    for (int w = 0; w < 4; ++w) {
        const WallFace face = layout.plan().wall(w);
        const float off = dot(place.position - face.origin, face.inward);
        constexpr float kAtWall = 0.08f;  // metres
        if (dot(face.inward, front_of(place.yaw)) < 0.99f || std::abs(off) > kAtWall) continue;
        for (const float further : {0.f, 0.1f, -0.1f, 0.2f, -0.2f})
            if (const auto i = layout.hang_at(piece, w, dot(place.position - face.origin, face.along) + aside + further,
                                              wish))
                return i;
    }
    return {};
}

}  // namespace

std::optional<int> take_place(Layout& layout, const PieceRequest& request, const PromptObject& wish,
                              const Placed& place, int on, float aside) {
    const Piece piece = make_piece(request);
    if (on >= 0) {
        if (piece.mount != Mount::surface) return {};
        const Vec2f at = flat(place.position + right_of(place.yaw) * aside);
        if (const auto i = layout.on_top_at(on, request, at, place.yaw, wish)) return i;
        return layout.on_top(on, request, wish);
    }
    if (place.sill >= 0) return layout.on_sill(request, place.sill, wish);
    // A cactus for a large plant stands on the floor as that did.
    if (piece.mount == Mount::surface && place.piece.mount == Mount::floor)
        return layout.on_floor_near(flat(place.position), request, wish);
    // A screen for a mirror hangs where that hung.
    const bool screen = std::any_of(piece.materials.begin(), piece.materials.end(),
                                    [](const Material& m) { return m.pattern == Pattern::screen; });
    if (screen && piece.mount == Mount::surface && place.piece.mount == Mount::wall)
        return hang_in_place(layout, request, wish, place, aside);
    if (piece.mount != place.piece.mount) return {};
    switch (piece.mount) {
        case Mount::floor:
            if (place.flat)
                return layout.lay(flat(place.position + right_of(place.yaw) * aside), place.yaw, request, wish);
            return stand_in_place(layout, request, wish, place, aside);
        case Mount::wall: return hang_in_place(layout, request, wish, place, aside);
        case Mount::ceiling: return layout.hanging(request, flat(place.position + right_of(place.yaw) * aside), wish);
        case Mount::surface: break;
    }
    return {};
}

// Backs that stood at walls stand at walls. Chairs go with their table, if there is room for them.
void Editor::swap(const EditStep& step) {
    if (step.ids.size() != 2 || step.ids[0] == step.ids[1])
        throw UsageError("expected two things to change places, found {}", step.ids.size());
    const int a = index_of(step.ids[0]), b = index_of(step.ids[1]);
    if (placed(a).on == b || placed(b).on == a)
        throw UsageError("{} and {}: one stands on the other", step.ids[0], step.ids[1]);
    const std::vector<int> seats_a = seats_at(a), seats_b = seats_at(b);
    const bool apart = std::none_of(seats_a.begin(), seats_a.end(), [&](int i) { return i == b; }) &&
                       std::none_of(seats_b.begin(), seats_b.end(), [&](int i) { return i == a; });
    const bool seated = apart && !(seats_a.empty() && seats_b.empty());
    // First into each other's very places, then as near to them as there is room.
    for (const bool nearby : {false, true}) {
        if (seated) try {
                return swap_two(a, b, seats_a, seats_b, nearby);
            } catch (const Error&) {  // there is no room for the chairs as they stand: they follow one by one
            }
        try {
            swap_two(a, b, {}, {}, nearby);
            bring_seats(a, seats_a), bring_seats(b, seats_b);
            return;
        } catch (const UsageError&) {
            throw;
        } catch (const Error&) {
            if (nearby) throw;
        }
    }
}

// Into the place of another among what stands; what is moved aside for it is in `pushed`.
std::optional<Placed> Editor::in_its_place(Standing& among, const Placed& p, const Placed& place, bool nearby,
                                           std::vector<Squeezed>& pushed) const {
    constexpr float kNearest = 0.8f, kStillThere = 1.6f;  // metres
    PromptSpec spec = room_.spec;
    spec.objects = {};
    Random rng(room_.seed, "swap");
    Layout layout = begin_layout(spec, rng, among.placed, nullptr);
    layout.make_as(p.piece.made_from);
    PromptObject wish = p.wish;
    if (wish.kind.empty()) wish.kind = p.piece.kind;
    wish.relation = wish.relation_to = "";
    const int on = place.on < 0 ? -1 : among.now[static_cast<std::size_t>(place.on)];
    const PieceRequest request = layout.request(p.piece.kind, &wish);
    auto i = take_place(layout, request, wish, place, on, 0);
    const bool walls = p.piece.mount == Mount::wall ? of_floor_and_wall(p, place)
                                                    : p.piece.mount == Mount::floor && !p.flat && on < 0;
    for (const float reach : {kNearest, kStillThere})
        if (!i && walls)
            i = layout.against_wall(request,
                                    {.near = flat(place.position), .center_pull = 0, .at_most_from_near = reach}, wish);
    if (i) return layout.placed()[static_cast<std::size_t>(*i)];
    if (!nearby || p.piece.mount != Mount::floor || p.flat || on >= 0) return {};
    EditStep there;
    there.kind = EditStep::Kind::place;
    there.wish = wish;
    there.wish.words = in_words(wish.kind), there.wish.count = 1, there.wish.size_m = p.piece.size_m;
    there.position = flat(place.position), there.yaw = p.yaw;
    for (const Squeeze& how : squeezes(false)) {
        const auto found = squeezed_in(among, there, &p, how, [&](const Squeezed& s) {
            return length(flat(s.all.back().position) - flat(place.position)) < kStillThere;
        });
        if (!found) continue;
        pushed.push_back(*found);
        for (std::size_t k = 0; k < among.placed.size(); ++k) among.placed[k].position = found->all[k].position;
        return found->all.back();
    }
    return {};
}

void Editor::swap_two(int a, int b, const std::vector<int>& with_a, const std::vector<int>& with_b, bool nearby) {
    const Placed one = placed(a), other = placed(b);
    if (mount_there(one) != mount_there(other) && !of_floor_and_wall(one, other))
        throw UsageError("{} {}, {} {}: they cannot change places", one.id, where_it_is(one, room_.furnished.placed),
                         other.id, where_it_is(other, room_.furnished.placed));
    std::vector<int> moving{a, b};
    moving.insert(moving.end(), with_a.begin(), with_a.end());
    moving.insert(moving.end(), with_b.begin(), with_b.end());
    const Standing standing = without(with_riders(moving));
    std::string fault;
    // Whichever comes first may find more room.
    for (const bool in_order : {true, false}) {
        const Placed &p = in_order ? one : other, &q = in_order ? other : one;
        Standing among = standing;
        std::vector<Squeezed> pushed;
        const auto first = in_its_place(among, p, q, nearby, pushed);
        if (first) among.placed.push_back(*first), among.was.push_back(in_order ? a : b);
        const auto second = first ? in_its_place(among, q, p, nearby, pushed) : std::nullopt;
        if (!second) {
            const Placed &left = first ? q : p, &taken = first ? p : q;
            if (fault.empty())
                fault = fmt::format(
                    "{} finds no room where {} stands: it takes {:.2f} x {:.2f} m, {} {:.2f} x {:.2f} m", left.id,
                    taken.id, left.piece.size_m.x, left.piece.size_m.z, taken.id, taken.piece.size_m.x,
                    taken.piece.size_m.z);
            continue;
        }
        const Placed &of_a = in_order ? *first : *second, &of_b = in_order ? *second : *first;
        constexpr float kSame = 0.1f;  // metres
        if (length(flat(of_a.position) - flat(one.position)) < kSame &&
            length(flat(of_b.position) - flat(other.position)) < kSame)
            throw Error("{} and {}: they are at one place", one.id, other.id);
        try {
            return checked(
                [&] {
                    for (const Squeezed& s : pushed) make_way(s, one.id);
                    if (mount_there(one) == mount_there(other))
                        std::swap(thing(a).on, thing(b).on), std::swap(thing(a).window, thing(b).window);
                    set_pose(a, {of_a.position, of_a.yaw}, with_a);
                    set_pose(b, {of_b.position, of_b.yaw}, with_b);
                },
                nearby ? kNarrow : Passage{});
        } catch (const Error& e) {
            if (fault.empty()) fault = e.what();
        }
    }
    throw Error("{}", fault);
}

bool Editor::replaced_nearby(const EditStep& step) {
    const Placed old = placed(step.ids.front());
    if (step.ids.size() != 1 || old.piece.mount != Mount::floor || old.on >= 0 || old.flat) return false;
    constexpr float kNearby_m = 0.9f;
    try {
        together([&] {
            take(step.ids);
            EditStep there = step;
            there.kind = EditStep::Kind::add;
            there.ids.clear(), there.position = flat(old.position), there.wish.count = 1;
            add(there);
            const Placed& fresh = room_.furnished.placed.back();
            if (length(footprint_of(fresh).center - footprint_of(old).center) > kNearby_m)
                throw Error("{}: too far from there", fresh.id);
            tell(fresh.id, "added in place of " + old.id);
        });
    } catch (const Error&) {
        return false;
    }
    return true;
}

}  // namespace fastscene::editing

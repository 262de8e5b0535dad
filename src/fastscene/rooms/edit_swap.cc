// Things that change places: on the floor, on walls, on tops.
#include <fmt/format.h>

#include <algorithm>

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
            } catch (const Error&) {  // there is no room for the chairs: they stay
            }
        try {
            return swap_two(a, b, {}, {}, nearby);
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

}  // namespace fastscene::editing

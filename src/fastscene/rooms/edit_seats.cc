// More seats at a table: evenly along its sides, or around it.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "fastscene/base/error.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"

namespace fastscene::editing {
namespace {

constexpr float kTableTop_m = 0.6f;  // nobody sits at what is lower
constexpr float kBarTop_m = 0.85f;   // a counter, at which one sits on the side of the guests
constexpr float kDrawnUp_m = 0.02f;  // from a table's edge to a chair's front

// Chairs and stools: what is drawn up to tables.
bool sits_at_tables(const std::string& kind) {
    return has_role(kind, Role::sits_before) && !has_role(kind, Role::sofa) && !has_role(kind, Role::easy_chair) &&
           !has_role(kind, Role::rug_before);
}

// The sides of a table: before it, behind it, at its right and its left end.
struct Side {
    Vec3f out, along;  // unit
    float off, half;   // metres from the middle to the edge; half of its length
};
std::array<Side, 4> sides_of(const Placed& table) {
    const Vec3f front = front_of(table.yaw), right = right_of(table.yaw), half = table.piece.size_m * 0.5f;
    return {{{front, right, half.z, half.x},
             {front * -1.f, right, half.z, half.x},
             {right, front, half.x, half.z},
             {right * -1.f, front, half.x, half.z}}};
}

// The side that it faces from close by; -1: it is not at the table.
int side_at(const Placed& table, const Placed& seat) {
    constexpr float kReach_m = 0.45f, kFacing = 0.8f;  // from the edge to its front; cosine
    const auto sides = sides_of(table);
    for (int s = 0; s < 4; ++s) {
        const Side& side = sides[static_cast<std::size_t>(s)];
        const Vec3f d = seat.position - table.position;
        const float gap = dot(d, side.out) - seat.piece.size_m.z / 2 - side.off;
        if (dot(front_of(seat.yaw), side.out) < -kFacing && gap < kReach_m && dot(d, side.out) > side.off - 0.1f &&
            std::abs(dot(d, side.along)) < side.half)
            return s;
    }
    return -1;
}

bool is_one_of_those(int i, const std::vector<int>& those) {
    return std::find(those.begin(), those.end(), i) != those.end();
}

bool is_round(const Placed& table) { return shape_of(table.piece) == "round"; }

// Drawn up to a round one: close, and turned to its middle.
bool faces_middle(const Placed& table, const Placed& seat) {
    constexpr float kReach_m = 0.45f, kFacing = 0.8f;
    const Vec3f to = table.position - seat.position;
    const float far = length(flat(to));
    return far - seat.piece.size_m.z / 2 - table.piece.size_m.x / 2 < kReach_m &&
           dot(front_of(seat.yaw), to) > kFacing * far;
}

// As many of a width as sit side by side on so much of an edge.
int most_along(float edge, float wide) {
    constexpr float kElbows = 1.08f;  // of a seat's width
    return static_cast<int>(edge / (wide * kElbows) + 1e-3f);
}

// One sits on the side of the guests, and at the ends.
bool is_counter(const Placed& table) {
    constexpr float kLong = 1.5f;  // times as long as it is deep
    return !has_role(table.piece.kind, Role::laid) && table.piece.size_m.x > kLong * table.piece.size_m.z;
}

// How many go to each side, the best shares first: none moves where an end is free, and the long sides are alike.
using Shares = std::array<int, 4>;
std::vector<Shares> shares_of(const Placed& table, const Shares& now, int total, float wide) {
    const auto sides = sides_of(table);
    Shares most{};
    for (std::size_t s = 0; s < 4; ++s) {
        const bool end = sides[s].half < sides[(s + 2) % 4].half;
        most[s] = std::max(now[s], std::min(most_along(2 * sides[s].half, wide), end ? 1 : 99));
    }
    const int there = std::accumulate(now.begin(), now.end(), 0);
    const bool counter = is_counter(table) && there == 0 && table.piece.size_m.y > kBarTop_m;
    const bool bar = is_counter(table) && there > 1 && (now[0] == 0) != (now[1] == 0);
    if (bar) most[now[0] == 0 ? 0 : 1] = 0;
    std::vector<std::pair<float, Shares>> all;
    Shares n{};
    for (n[0] = now[0]; n[0] <= most[0]; ++n[0])
        for (n[1] = now[1]; n[1] <= most[1]; ++n[1])
            for (n[2] = now[2]; n[2] <= most[2]; ++n[2])
                for (n[3] = now[3]; n[3] <= most[3]; ++n[3]) {
                    if (std::accumulate(n.begin(), n.end(), 0) != total) continue;
                    constexpr float kRoomy_m = 0.6f;  // of edge for each
                    constexpr float kBehind = 10;     // behind a counter somebody works
                    float cost = counter ? kBehind * static_cast<float>(n[1]) + static_cast<float>(n[2] + n[3])
                                         : 0.3f * static_cast<float>(std::abs(n[0] - n[1]) + std::abs(n[2] - n[3]));
                    for (std::size_t s = 0; s < 4; ++s) {
                        const bool end = sides[s].half < sides[(s + 2) % 4].half;
                        const float each = 2 * sides[s].half / static_cast<float>(std::max(1, n[s]));
                        cost += 4 * std::max(0.f, kRoomy_m - each) * static_cast<float>(n[s]) / 2;
                        if (n[s] > now[s] && now[s] > 0) cost += bar ? 0.f : 0.6f;
                        if (n[s] > now[s] && end) cost += bar ? 2.f : 0.5f;
                    }
                    all.emplace_back(cost, n);
                }
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Shares> out;
    for (const auto& [cost, share] : all) out.push_back(share);
    return out;
}

}  // namespace

std::vector<int> Editor::drawn_up_to(int table) const {
    std::vector<int> out;
    const Placed& t = placed(table);
    const bool round = is_round(t);
    for (int i = 0; i < static_cast<int>(room_.furnished.placed.size()); ++i) {
        const Placed& p = placed(i);
        if (i == table || p.piece.mount != Mount::floor || !sits_at_tables(p.piece.kind)) continue;
        if (round ? faces_middle(t, p) : side_at(t, p) >= 0) out.push_back(i);
    }
    return out;
}

// Those without chairs first, for several of them; then the largest.
std::vector<int> Editor::tables_meant(const EditStep& step) const {
    std::vector<int> out;
    for (int i = 0; i < static_cast<int>(room_.furnished.placed.size()); ++i) {
        const Placed& p = placed(i);
        const bool meant = step.at.empty()
                               ? p.piece.kind == step.wish.relation_to || asked_kind(p) == step.wish.relation_to
                               : is_among(p.id, step.at);
        const float top = p.piece.surfaces.empty() ? 0.f : p.piece.surfaces.front().center.y;
        if (meant && p.piece.mount == Mount::floor && is_table(p.piece.kind) && top > kTableTop_m) out.push_back(i);
    }
    const auto rank = [&](int i) {
        const bool free = step.wish.count > 1 && drawn_up_to(i).empty();
        return std::pair(!free, -placed(i).piece.size_m.x * placed(i).piece.size_m.z);
    };
    std::stable_sort(out.begin(), out.end(), [&](int a, int b) { return rank(a) < rank(b); });
    return out;
}

bool Editor::seat_more(const EditStep& step) {
    if (step.wish.relation != "around" || !sits_at_tables(step.wish.kind)) return false;
    const std::vector<int> tables = tables_meant(step);
    if (tables.empty()) return false;
    const int count = std::max(1, step.wish.count);
    for (int some = count; some > 0; --some)
        for (const int table : tables) {
            const std::string id = thing(table).id;
            const auto there = static_cast<int>(drawn_up_to(table).size());
            if (!seat_at(table, step, some)) continue;
            if (some < count)
                note(kNotDone, fmt::format("{}: there is room for {} of {} at {}, where {} stand now", step.wish.words,
                                           some, count, id, there + some));
            return true;
        }
    const auto there = drawn_up_to(tables.front()).size();
    throw Error("{}: there is no room for {} at {}{}", step.wish.words, count > 1 ? "any of them" : "it",
                thing(tables.front()).id,
                there > 0 ? fmt::format(", where {} {} already", there, there > 1 ? "stand" : "stands") : "");
}

bool Editor::seat_those(const EditStep& step) {
    std::vector<int> comers;
    EditStep one = step;
    for (const std::string& id : step.ids) {
        const int i = index_of(id);
        if (!sits_at_tables(placed(i).piece.kind) || placed(i).piece.mount != Mount::floor) return false;
        comers.push_back(i);
        one.wish.kind = asked_kind(placed(i)), one.wish.words = in_words(one.wish.kind);
    }
    const std::vector<int> tables = step.wish.relation == "around" ? tables_meant(one) : std::vector<int>{};
    if (tables.size() != 1 || comers.size() < 2) return false;
    std::erase_if(comers, [&](int i) { return is_one_of_those(i, drawn_up_to(tables.front())); });
    if (comers.empty()) throw AlreadySo(step.ids.front() + ": it stands there already");
    return seat_at(tables.front(), one, static_cast<int>(comers.size()), comers);
}

// All of them at this table; false: it has no room for them, and nothing changed.
bool Editor::seat_at(int table, const EditStep& step, int count, const std::vector<int>& comers) {
    const Placed t = placed(table);
    std::vector<int> there = drawn_up_to(table);
    std::erase_if(there, [&](int i) { return is_one_of_those(i, comers); });
    const int total = count + static_cast<int>(there.size());
    const Standing standing = without({});
    Placed fresh;
    if (!comers.empty()) {
        fresh.piece = placed(comers.front()).piece;
    } else {
        const auto request = request_of_one(step, "seat", there);
        if (!request) return false;
        fresh.piece = make_piece(*request);
    }
    fresh.wish = step.wish, fresh.wish.count = 1, fresh.with = table;
    const Vec3f size = fresh.piece.size_m;
    std::vector<Vec3f> from;
    for (const int i : there) from.push_back(placed(i).position);

    constexpr int kMostTries = 10;  // of places that look free: each is a room to be checked
    int tries = 0;
    std::vector<int> together = there;
    together.push_back(table);
    together.insert(together.end(), comers.begin(), comers.end());
    const bool round = is_round(t);
    float gap = kDrawnUp_m;
    for (const int i : there)
        if (round)
            gap = std::max(gap, length(flat(placed(i).position - t.position)) - placed(i).piece.size_m.z / 2 -
                                    t.piece.size_m.x / 2);
    const std::vector<int> moving = with_riders(together);
    const auto is_free = [&](const Seat& seat) {
        fresh.position = {seat.at.x, 0, seat.at.z}, fresh.yaw = seat.yaw;
        const Footprint box = shrunk(footprint_of(fresh), 0.01f);
        if (!plan().holds(box) || blocks_opening(plan(), box)) return false;
        for (int i = 0; i < static_cast<int>(standing.placed.size()); ++i)
            if (!placed(i).flat && !is_one_of_those(i, moving) && overlap(box, footprint_of(placed(i)))) return false;
        return true;
    };
    // The old ones to the nearest places, the new ones to the rest; the table moved by so much.
    const auto stand = [&](const std::vector<Seat>& seats, Vec3f by) {
        if (static_cast<int>(seats.size()) != total || tries >= kMostTries) return false;
        std::vector<std::size_t> taken;
        const std::vector<std::size_t> left = left_over(from, seats, taken);
        std::vector<Placed> all = standing.placed;
        if (!std::all_of(seats.begin(), seats.end(), is_free)) return false;
        for (const std::size_t k : comers.empty() ? left : std::vector<std::size_t>{}) {
            fresh.position = {seats[k].at.x, 0, seats[k].at.z}, fresh.yaw = seats[k].yaw;
            all.push_back(fresh);
        }
        ++tries;
        const auto change = [&] {
            if (length(by) > 0.01f) set_pose(table, {t.position + by, t.yaw}, {});
            std::vector<std::string> ids = admit(all, standing, {" at " + t.id});
            for (std::size_t n = 0; n < comers.size(); ++n) {
                set_pose(comers[n], {seats[left[n]].at, seats[left[n]].yaw}, {});
                thing(comers[n]).with = t.id, thing(comers[n]).mount.reset();
                ids.push_back(thing(comers[n]).id);
            }
            for (std::size_t n = 0; n < there.size(); ++n) {
                const Seat& seat = seats[taken[n]];
                DocumentThing& moved = thing(there[n]);
                const float far = length(flat(seat.at) - flat(moved.position));
                constexpr float kStays_m = 0.03f;
                if (far < kStays_m) continue;
                const Vec3f step_by{seat.at.x - moved.position.x, 0, seat.at.z - moved.position.z};
                for (const int k : laid_before(standing.placed, table, there[n])) {
                    DocumentThing& laid = thing(k);
                    const Vec3f was = moved.position - t.position, is = seat.at - t.position - by;
                    const float turn = round ? std::atan2(is.x, is.z) - std::atan2(was.x, was.z) : 0.f;
                    const Vec3f d = laid.position - t.position;
                    const float c = std::cos(turn), s = std::sin(turn);
                    if (round) laid.position = t.position + by + Vec3f{c * d.x + s * d.z, d.y, c * d.z - s * d.x};
                    else laid.position += step_by;
                    laid.yaw = std::remainder(laid.yaw + turn, 2 * kPi);
                    tell(laid.id, "moved with " + moved.id);
                }
                for (const int k : with_riders({there[n]})) thing(k).position += step_by;
                moved.yaw = seat.yaw;
                tell(moved.id, fmt::format("moved {:.2f} m to make room for {}", far, ids.front()));
            }
        };
        for (const Passage& passage : {Passage{}, kNarrow}) try {
                checked(change, passage);
                return true;
            } catch (const Error&) {
            }
        return false;
    };

    // Off its wall, where that is what they lack.
    std::vector<Vec3f> shifts{{}};
    for (const float by : {0.15f, 0.25f, 0.3f, 0.4f, 0.5f, 0.6f})
        for (int w = 0; w < 4; ++w) {
            const WallFace face = plan().wall(w);
            const float off = dot(t.position - face.origin, face.inward) - extent(footprint_of(t), flat(face.inward));
            if (off < size.z + 0.3f && there.empty()) shifts.push_back(face.inward * by);
        }
    if (!round) {
        const auto sides = sides_of(t);
        Shares now{};
        std::array<std::vector<int>, 4> at_side;
        for (const int i : there) {
            const auto s = static_cast<std::size_t>(side_at(t, placed(i)));
            ++now[s], at_side[s].push_back(i);
        }
        constexpr float kFarther_m = 0.12f;  // where something is in the way under the top
        const std::vector<Shares> shares = shares_of(t, now, total, size.x);
        const auto seats_for = [&](const Shares& share, float off, Vec3f by) {
            std::vector<Seat> seats;
            for (std::size_t s = 0; s < 4; ++s) {
                // Where none comes, they stay as they are.
                if (share[s] == now[s])
                    for (const int i : at_side[s]) seats.push_back({placed(i).position, placed(i).yaw});
                for (int k = 0; k < share[s] && share[s] > now[s]; ++k) {
                    const float at = ((static_cast<float>(k) + 0.5f) / static_cast<float>(share[s]) - 0.5f) * 2 *
                                     sides[s].half;
                    seats.push_back(
                        seat_of(t.position + by + sides[s].along * at, sides[s].out, sides[s].off + off + size.z / 2));
                }
            }
            return seats;
        };
        for (const Vec3f by : shifts) {
            Placed moved = t;
            moved.position += by;
            if (length(by) > 0.01f && !stands_clear(table, footprint_of(moved), {})) continue;
            for (std::size_t n = 0; n < 2 * shares.size(); ++n) {
                const Shares& share = shares[n / 2];
                if (!stand(seats_for(share, n % 2 == 0 ? kDrawnUp_m : kFarther_m, by), by)) continue;
                if (there.empty() && is_counter(t) && t.piece.size_m.y > kBarTop_m && share[0] > 0 && share[1] > 0)
                    note(t.id, "seats on both sides of it: there was no room for all of them on one");
                return true;
            }
        }
        return false;
    }
    // Round: as they stand, else turned.
    const float first = there.empty() ? t.yaw
                                      : std::atan2(from.front().x - t.position.x, from.front().z - t.position.z);
    const float step_around = 2 * kPi / static_cast<float>(total);
    for (const Vec3f by : shifts) {
        Placed moved = t;
        moved.position += by;
        if (length(by) > 0.01f && !stands_clear(table, footprint_of(moved), {})) continue;
        for (const float turn : {0.f, 0.5f, 0.25f, 0.75f})
            if (stand(seats_around(t, moved.position, total, size, first + turn * step_around, gap), by)) return true;
        // Not quite evenly, where there is floor for it.
        constexpr int kWays = 36;
        std::vector<float> free;
        for (int k = 0; k < kWays; ++k) {
            const float angle = first + 2 * kPi * static_cast<float>(k) / kWays;
            if (is_free(seats_around(t, moved.position, 1, size, angle, gap).front())) free.push_back(angle);
        }
        const auto [angles, apart] = spread(free, total);
        const float least = 2 * std::atan((size.x / 2 + 0.01f) / (t.piece.size_m.x / 2 + kDrawnUp_m));
        if (angles.empty() || apart < least) continue;
        std::vector<Seat> seats;
        for (const float angle : angles) seats.push_back(seats_around(t, moved.position, 1, size, angle, gap).front());
        if (stand(seats, by)) return true;
    }
    return false;
}

}  // namespace fastscene::editing

// Things set in a circle, and with even gaps: "arrange the chairs in a circle", "space the pictures out evenly".
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_relations.h"

namespace fastscene::editing {
namespace {

struct Circle {
    Vec2f middle;
    float radius = 0;  // to the middles of what stands on it
    float first = 0;   // radians: where the first one stands
    float arc = 2 * kPi;
};

// Where the things of a circle stand, looking at its middle.
std::vector<std::pair<Vec2f, float>> places_on(const Circle& circle, std::size_t count) {
    const bool whole = circle.arc > 1.5f * kPi;
    std::vector<std::pair<Vec2f, float>> out;
    for (std::size_t k = 0; k < count; ++k) {
        const float share = whole ? static_cast<float>(k) / static_cast<float>(count)
                                  : (static_cast<float>(k) + 0.5f) / static_cast<float>(count) - 0.5f;
        const float angle = circle.first + circle.arc * share;
        const Vec2f out_by{std::sin(angle), std::cos(angle)};
        out.emplace_back(circle.middle + out_by * circle.radius, std::atan2(-out_by.x, -out_by.y));
    }
    return out;
}

// Which thing goes to which place, so that they go short ways: the nearest pair first.
std::vector<std::size_t> nearest_places(const std::vector<Vec2f>& from, std::vector<Vec2f> to) {
    std::vector<std::size_t> out(from.size(), to.size());
    std::vector<bool> taken(to.size());
    for (std::size_t n = 0; n < from.size(); ++n) {
        float least = 1e9f;
        std::size_t thing = 0, place = 0;
        for (std::size_t i = 0; i < from.size(); ++i)
            for (std::size_t k = 0; k < to.size() && out[i] == to.size(); ++k)
                if (!taken[k] && length(from[i] - to[k]) < least) least = length(from[i] - to[k]), thing = i, place = k;
        out[thing] = place, taken[place] = true;
    }
    return out;
}

}  // namespace

// About the very things of a place, about `position`, or where they stand; the nearest floor that is free for it.
void Editor::encircle(const EditStep& step) {
    if (step.ids.size() < 2) throw UsageError("expected several things for a circle, found {}", step.ids.size());
    std::vector<int> moving, together;
    std::vector<std::vector<int>> seats;
    std::vector<Vec2f> from;
    float wide = 0, deep = 0;
    for (const std::string& id : step.ids) {
        moving.push_back(index_of(id));
        const Placed& p = placed(moving.back());
        if (p.piece.mount != Mount::floor || p.flat)
            throw UsageError("{}: only what stands on the floor is set in a circle", id);
        from.push_back(footprint_of(p).center);
        wide = std::max(wide, p.piece.size_m.x), deep = std::max(deep, p.piece.size_m.z);
        seats.push_back(seats_at(moving.back()));
        together.insert(together.end(), seats.back().begin(), seats.back().end());
    }
    // Whoever sits at a desk faces it, and sits outside the circle.
    const float turned = together.empty() ? 0 : kPi;
    together.insert(together.end(), moving.begin(), moving.end());
    const auto count = static_cast<float>(moving.size());
    Circle circle;
    for (const Vec2f at : from) circle.middle = circle.middle + at * (1 / count);
    if (step.position) circle.middle = *step.position;
    float inside = 0.3f;  // metres kept free in the middle
    float front = 0;      // where a thing at a wall looks
    bool at_wall = false;
    for (const std::string& id : step.at) {
        const Placed& p = placed(id);
        circle.middle = footprint_of(p).center;
        const float kFree = p.flat ? 0.f : 0.05f;  // metres before it
        inside = p.flat ? inside : std::hypot(p.piece.size_m.x, p.piece.size_m.z) / 2 + kFree;
        at_wall = wall_behind(plan(), p) >= 0, front = p.yaw;
    }
    constexpr float kApart = 0.08f;  // metres between neighbors
    if (step.value == "semicircle" || at_wall) circle.arc = kPi;
    const float gaps = circle.arc < 2 * kPi ? 2 * count : count;
    const float least = std::max((wide + kApart) / (2 * std::sin(kPi / std::max(2.f, gaps))), inside) + deep / 2;
    std::vector<Vec2f> middles{circle.middle};
    constexpr float kStep = 0.2f, kFarthest = 2.f;  // metres: further off it is another place
    for (float x = -kFarthest; x <= kFarthest && step.at.empty(); x += kStep)
        for (float z = -kFarthest; z <= kFarthest; z += kStep) middles.push_back(circle.middle + Vec2f{x, z});
    std::stable_sort(middles.begin(), middles.end(),
                     [&](Vec2f a, Vec2f b) { return length(a - circle.middle) < length(b - circle.middle); });
    const std::vector<int> all = with_riders(moving);
    constexpr int kMostTries = 8;  // of places that look free: each is a room to be checked
    int tries = 0;
    const auto stand = [&](const Circle& c) {
        const auto places = places_on(c, moving.size());
        std::vector<Vec2f> to;
        for (const auto& [at, yaw] : places) {
            Placed there = placed(moving[to.size()]);
            there.position = {at.x, there.position.y, at.y}, there.yaw = yaw + turned;
            const std::size_t k = to.size();
            if (!stands_clear(moving[k], footprint_of(there), together) ||
                !seats_clear(moving[k], there, seats[k], together))
                return false;
            to.push_back(at);
        }
        const std::vector<std::size_t> place = nearest_places(from, to);
        if (++tries > kMostTries) return false;
        try {
            checked(
                [&] {
                    for (std::size_t k = 0; k < moving.size(); ++k) {
                        const auto& [at, yaw] = places[place[k]];
                        thing(moving[k]).with.clear();
                        set_pose(moving[k],
                                 {{at.x, placed(moving[k]).position.y, at.y}, std::remainder(yaw + turned, 2 * kPi)},
                                 seats[k]);
                    }
                },
                kNarrow);
            return true;
        } catch (const Error&) {
            return false;
        }
    };
    for (const float more : {0.1f, 0.f, 0.3f, 0.5f, 0.8f}) {
        tries = 0;
        for (const Vec2f middle : middles)
            for (const float turn : {0.f, 0.5f, 0.25f, 0.75f}) {
                Circle c = circle;
                c.middle = middle, c.radius = least + more;
                c.first = at_wall ? front : 2 * kPi * turn / (circle.arc < 2 * kPi ? 1 : count);
                if (at_wall && turn > 0) break;
                if (stand(c)) return;
            }
    }
    throw Error("{}: there is no free floor for a circle of all {} of them; it takes {:.1f} m across", step.ids.front(),
                step.ids.size(), 2 * least + deep);
}

namespace {

// A row of things: along which way, and how long each is in it.
struct Line {
    Vec3f way;
    std::vector<std::pair<float, int>> order;  // where its middle is, and which thing it is
    bool straight = true;
};

float extent_along(const Placed& p, Vec3f way) { return extent(footprint_of(p), flat(way)); }

}  // namespace

// Seats at one table along its sides; what stands or hangs in a row with equal gaps between those at its ends.
void Editor::space_out(const EditStep& step) {
    std::map<int, std::vector<int>> at_tables;
    std::vector<int> all;
    for (const std::string& id : step.ids) {
        const int i = index_of(id);
        all.push_back(i);
        if (placed(i).with >= 0 && has_role(placed(i).piece.kind, Role::seat)) at_tables[placed(i).with].push_back(i);
    }
    std::size_t seated = 0;
    for (const auto& [table, seats] : at_tables) seated += seats.size();
    if (seated == all.size() && !all.empty()) {
        std::vector<std::pair<int, std::vector<int>>> tables(at_tables.begin(), at_tables.end());
        return do_each(*this, tables.size(), [&](std::size_t k) { space_seats(tables[k].first, tables[k].second); });
    }
    if (all.size() < 2) throw UsageError("expected several things with gaps between them, found {}", all.size());
    space_in_row(all);
}

void Editor::space_seats(int table, const std::vector<int>& seats) {
    const Placed t = placed(table);
    const bool round = shape_of(t.piece) == "round";
    const Vec3f right = right_of(t.yaw), front = front_of(t.yaw), half = t.piece.size_m * 0.5f;
    std::vector<Pose> poses(seats.size());
    std::map<int, std::vector<std::pair<float, std::size_t>>> sides;  // 0, 1: along the table; 2, 3: at its ends
    for (std::size_t k = 0; k < seats.size(); ++k) {
        const Placed& p = placed(seats[k]);
        const Vec3f d = p.position - t.position;
        const float x = dot(d, right), z = dot(d, front);
        poses[k] = {p.position, p.yaw};
        if (round) sides[0].emplace_back(std::atan2(x, z), k);
        else if (std::abs(z) - half.z > std::abs(x) - half.x) sides[z > 0 ? 0 : 1].emplace_back(x, k);
        else sides[x > 0 ? 2 : 3].emplace_back(z, k);
    }
    for (auto& [side, row] : sides) {
        std::sort(row.begin(), row.end());
        const auto count = static_cast<float>(row.size());
        for (std::size_t n = 0; n < row.size(); ++n) {
            Pose& pose = poses[row[n].second];
            const auto nth = static_cast<float>(n);
            if (round) {
                const float angle = row.front().first + 2 * kPi * nth / count;
                const Vec3f out = right * std::sin(angle) + front * std::cos(angle);
                const float off = length(flat(pose.position - t.position)), y = pose.position.y;
                pose = {t.position + out * off, yaw_of(out * -1.f)};
                pose.position.y = y;
                continue;
            }
            const float reach = side < 2 ? half.x : half.z;
            const float to = 2 * reach * (nth + 0.5f) / count - reach;
            pose.position += (side < 2 ? right : front) * (to - row[n].first);
        }
    }
    set_poses(seats, poses, "they stand evenly around " + thing(table).id + " already");
}

void Editor::space_in_row(const std::vector<int>& all) {
    constexpr float kAside = 0.6f;  // metres that a thing of a row may stand beside its line
    Line line;
    for (const Vec3f way : {right_of(placed(all.front()).yaw), front_of(placed(all.front()).yaw)}) {
        Line one{way, {}, true};
        const Vec3f across{way.z, 0, -way.x};
        float least = 1e9f, most = -1e9f;
        for (const int i : all) {
            one.order.emplace_back(dot(placed(i).position, way), i);
            const float aside = dot(placed(i).position, across);
            least = std::min(least, aside), most = std::max(most, aside);
        }
        std::sort(one.order.begin(), one.order.end());
        one.straight = most - least < kAside;
        if (one.straight && (line.order.empty() || one.order.back().first - one.order.front().first >
                                                       line.order.back().first - line.order.front().first))
            line = one;
    }
    if (line.order.empty())
        throw Error("{}: they stand in no row, and at no table, that could be spaced out", thing(all.front()).id);
    float from = line.order.front().first - extent_along(placed(line.order.front().second), line.way);
    float to = line.order.back().first + extent_along(placed(line.order.back().second), line.way);
    float taken = 0;
    for (const auto& [at, i] : line.order) taken += 2 * extent_along(placed(i), line.way);
    // Two of them, or a row without gaps, need a longer row.
    constexpr float kGap = 0.25f;  // metres
    const auto gaps = static_cast<float>(line.order.size() - 1);
    const float longer = std::max(0.f, taken + kGap * gaps - (to - from)) + (all.size() == 2 ? 2 * kGap : 0.f);
    std::string fault;
    for (const float part : {1.f, 0.7f, 0.4f, 0.f}) {
        const float start = from - longer * part / 2, gap = (to - from + longer * part - taken) / gaps;
        if (gap < 0) break;
        std::vector<int> ids;
        std::vector<Pose> poses;
        float at = start;
        for (const auto& [now, i] : line.order) {
            const float half = extent_along(placed(i), line.way);
            ids.push_back(i);
            poses.push_back({placed(i).position + line.way * (at + half - now), placed(i).yaw});
            at += 2 * half + gap;
        }
        try {
            return set_poses(ids, poses, "the gaps between them are even already");
        } catch (const AlreadySo&) {
            throw;
        } catch (const Error& e) {
            if (fault.empty()) fault = e.what();
        }
    }
    throw Error("{}: there is no room for wider gaps{}{}", thing(all.front()).id, fault.empty() ? "" : ": ", fault);
}

// All of them at once; `already`: what to say where none of them would move.
void Editor::set_poses(const std::vector<int>& things, const std::vector<Pose>& poses, const std::string& already) {
    constexpr float kStays = 0.02f;  // metres
    bool moves = false;
    for (std::size_t k = 0; k < things.size(); ++k)
        moves = moves || length(poses[k].position - placed(things[k]).position) > kStays;
    if (!moves) throw AlreadySo(fmt::format("{}: {}", thing(things.front()).id, already));
    checked([&] {
        for (std::size_t k = 0; k < things.size(); ++k)
            if (length(poses[k].position - placed(things[k]).position) > kStays) {
                std::vector<int> along = seats_at(things[k]);
                std::erase_if(along, [&](int i) { return std::find(things.begin(), things.end(), i) != things.end(); });
                set_pose(things[k], poses[k], along);
            }
    });
}

// "The chairs in a circle around the rug", "the pictures out evenly"; false: no such words.
bool arrange(Talk& talk, const Words& said) {
    Words words = said;
    const auto take = [&](std::initializer_list<std::string_view> any, std::size_t from) {
        const std::size_t at = find_word(words, any, from);
        if (at < words.size()) words.erase(words.begin() + static_cast<std::ptrdiff_t>(at));
        return at;
    };
    const bool half = find_word(words, {"semicircle", "halfcircle", "half"}, 1) < words.size();
    const std::size_t circle = find_word(words, {"circle", "semicircle", "halfcircle"}, 2);
    const bool evenly = find_word(words, {"evenly", "equally"}) < words.size();
    const bool spaces = is_one_of(talk.said, {"space", "space out", "spread out", "distribute", "even out"}) ||
                        (evenly && is_one_of(talk.said, {"spread", "arrange", "set", "place", "put", "hang", "line"}) &&
                         !begins_anew(words));
    if (circle >= words.size() && !spaces) return false;
    EditStep step;
    step.kind = circle < words.size() ? EditStep::Kind::circle : EditStep::Kind::space;
    step.value = half ? "semicircle" : "";
    if (circle < words.size()) {
        std::size_t from = circle;
        while (from > 1 && is_one_of(words[from - 1], {"a", "an", "in", "into", "half", "nice", "small", "the", "as"}))
            --from;
        words.erase(words.begin() + static_cast<std::ptrdiff_t>(from),
                    words.begin() + static_cast<std::ptrdiff_t>(circle) + 1);
    } else {
        take({"evenly", "equally"}, 0), take({"out", "apart"}, 1), take({"more"}, 1);
        while (words.size() > 2 && is_one_of(words.back(), {"a", "bit", "little", "further", "slightly"}))
            words.pop_back();
        if (!words.empty() && words.back() == "spaced") words.pop_back();
    }
    const std::vector<std::string> spoken = talk.last;
    const std::size_t end = next_place(words);
    step.ids = talk.things_of_parts(part_of(words, 0, end));
    Words there = part_of(words, end);
    if (step.ids.size() == 1 && step.kind == EditStep::Kind::circle)
        throw UsageError("expected several things for a circle, found {}", step.ids.front());
    if (!there.empty()) {
        const auto place = place_of(talk.editor, there, asked_kind(talk.editor.placed(step.ids.front())),
                                    step.ids.front(), spoken);
        if (!place) throw UsageError("expected a place in the room, found \"{}\"", text_of(there));
        const std::vector<std::string> at = things_at(talk.editor, place->step);
        if (place->step.wish.relation == "in the middle" && at.empty()) step.position = Vec2f{0, 0};
        else if (at.size() == 1) step.at = at;
        else if (step.kind == EditStep::Kind::circle)
            throw UsageError("expected one thing to stand around, found \"{}\"", text_of(there));
    }
    if (step.kind == EditStep::Kind::circle) without_strangers(talk, step.ids);
    talk.editor.apply(step);
    talk.last = step.ids;
    return true;
}

}  // namespace fastscene::editing

// Things pushed together: tables side by side with those who sit at them, desks back to back.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"

namespace fastscene::editing {
namespace {

// A side of a table, in its own frame: before it, behind it, at its right and its left end.
struct Edge {
    float x, z;  // unit
    bool end() const { return x != 0; }
};
constexpr std::array<Edge, 4> kEdges{{{0, 1}, {0, -1}, {1, 0}, {-1, 0}}};

float angle_of(const Edge& e) { return std::atan2(e.x, e.z); }
float half_along(const Placed& table, const Edge& e) {
    return (e.end() ? table.piece.size_m.x : table.piece.size_m.z) / 2;
}

// Whether a seat is on that side of it rather than on another one.
bool sits_at_edge(const Placed& table, const Placed& seat, const Edge& e) {
    const Vec3f d = seat.position - table.position;
    const float x = dot(d, right_of(table.yaw)), z = dot(d, front_of(table.yaw));
    const float off_x = std::abs(x) - table.piece.size_m.x / 2, off_z = std::abs(z) - table.piece.size_m.z / 2;
    return off_x > off_z ? e.x * x > 0 : e.z * z > 0;
}

// Which sides of the two touch, and how many seats lose their place by that.
struct Touch {
    Edge a, b;
    int seats = 0;
};

}  // namespace

float gap_between_edges(const Placed& a, const Placed& b) {
    const Footprint one = footprint_of(a), other = footprint_of(b);
    const Vec2f way = (other.center - one.center) * (1 / std::max(0.01f, length(other.center - one.center)));
    return length(other.center - one.center) - extent(one, way) - extent(other, way);
}

// The second of two tables at the first, with whoever sits at them: side by side, or, to face each other, back to back.
// About `step.position`; without one the first stays where it is, if it can.
void Editor::join(const EditStep& step) {
    const std::array<int, 2> both{index_of(step.ids.at(0)), index_of(step.ids.at(1))};
    const std::array<Placed, 2> was{placed(both[0]), placed(both[1])};
    const std::array<std::vector<int>, 2> seats{seats_at(both[0]), seats_at(both[1])};
    std::vector<int> all{both[0], both[1]};
    for (const auto& some : seats) all.insert(all.end(), some.begin(), some.end());
    const bool facing = step.value == "facing", long_one = step.value == "long";
    const auto taken = [&](std::size_t k, const Edge& e) {
        // Before a desk is the place of its chair, whether there is one or not.
        if (seats[k].empty() && has_role(was[k].piece.kind, Role::work_place)) return e.z > 0 ? 1 : 0;
        return static_cast<int>(
            std::count_if(seats[k].begin(), seats[k].end(), [&](int i) { return sits_at_edge(was[k], placed(i), e); }));
    };
    std::vector<Touch> touches;
    for (const Edge& a : kEdges)
        for (const Edge& b : kEdges)
            if (a.end() == b.end() && !(facing && a.end()) && !(long_one && !a.end()))
                touches.push_back({a, b, taken(0, a) + taken(1, b)});
    // Nobody sits where they touch; the long sides are before the ends, unless they are to be one long table.
    std::stable_sort(touches.begin(), touches.end(), [](const Touch& x, const Touch& y) { return x.seats < y.seats; });

    constexpr int kMostTries = 40;  // of places that look free: each is a room to be checked
    int tries = 0;
    // Where both stand so; the seats that lose their place come after them.
    const auto stand = [&](const std::array<Pose, 2>& poses, const Touch& touch, const Passage& passage) {
        std::array<std::vector<int>, 2> along, left;
        for (std::size_t k = 0; k < 2; ++k) {
            for (const int i : seats[k])
                (sits_at_edge(was[k], placed(i), k == 0 ? touch.a : touch.b) ? left : along)[k].push_back(i);
            Placed there = was[k];
            there.position = poses[k].position, there.yaw = poses[k].yaw;
            if (!stands_clear(both[k], footprint_of(there), all) || !seats_clear(both[k], there, along[k], all))
                return false;
        }
        if (++tries > kMostTries) return false;
        try {
            checked(
                [&] {
                    for (std::size_t k = 0; k < 2; ++k) {
                        thing(both[k]).with.clear();
                        const bool moves = length(poses[k].position - was[k].position) > 1e-3f ||
                                           std::abs(std::remainder(poses[k].yaw - was[k].yaw, 2 * kPi)) > 1e-3f;
                        if (moves) set_pose(both[k], poses[k], along[k]);
                    }
                    build();
                    for (std::size_t k = 0; k < 2; ++k) bring_seats(both[k], left[k]);
                },
                passage);
        } catch (const Error&) {
            return false;
        }
        return true;
    };
    // With that one of them in the first pose.
    const auto poses_for = [&](const Touch& touch, std::size_t first, const Pose& pose) {
        constexpr float kGap_m = 0.01f;
        const Edge &here = first == 0 ? touch.a : touch.b, &there = first == 0 ? touch.b : touch.a;
        const Placed &one = was[first], &other = was[1 - first];
        const Vec3f out = right_of(pose.yaw) * here.x + front_of(pose.yaw) * here.z;
        std::array<Pose, 2> poses;
        poses[first] = pose;
        poses[1 - first].position = pose.position + out * (half_along(one, here) + half_along(other, there) + kGap_m);
        poses[1 - first].position.y = other.position.y;
        poses[1 - first].yaw = std::remainder(yaw_of(out * -1.f) - angle_of(there), 2 * kPi);
        return poses;
    };
    // How far those that move come from.
    const auto travel = [&](const std::array<Pose, 2>& poses) {
        float sum = 0;
        for (std::size_t k = 0; k < 2; ++k)
            sum += length(poses[k].position - was[k].position) +
                   std::abs(std::remainder(poses[k].yaw - was[k].yaw, 2 * kPi));
        return sum;
    };
    struct Choice {
        std::array<Pose, 2> poses;
        Touch touch;
        float cost;
    };
    constexpr float kSeatLost_m = 2;  // as bad as so much of a way
    const auto try_all = [&](std::vector<Choice> choices) {
        std::stable_sort(choices.begin(), choices.end(),
                         [](const Choice& x, const Choice& y) { return x.cost < y.cost; });
        for (const Passage& passage : {Passage{}, kNarrow}) {
            tries = 0;
            for (const Choice& c : choices)
                if (tries <= kMostTries && stand(c.poses, c.touch, passage)) return true;
        }
        return false;
    };
    std::vector<Choice> choices;
    if (!step.position) {
        for (const std::size_t stays : {0u, 1u}) {
            choices.clear();
            for (const Touch& t : touches) {
                const auto poses = poses_for(t, stays, {was[stays].position, was[stays].yaw});
                choices.push_back({poses, t, travel(poses) + kSeatLost_m * static_cast<float>(t.seats)});
            }
            if (try_all(choices)) return;
        }
    }
    const Vec2f wanted = step.position.value_or(flat(was[0].position + was[1].position) * 0.5f);
    constexpr float kStep_m = 0.2f, kReach_m = 1.4f;
    choices.clear();
    for (float x = -kReach_m; x <= kReach_m; x += kStep_m)
        for (float z = -kReach_m; z <= kReach_m; z += kStep_m)
            for (const Touch& t : touches)
                for (const float turn : {0.f, kPi / 2, -kPi / 2, kPi}) {
                    auto poses = poses_for(t, 0, {was[0].position, std::remainder(was[0].yaw + turn, 2 * kPi)});
                    const Vec2f by = wanted + Vec2f{x, z} - flat(poses[0].position + poses[1].position) * 0.5f;
                    for (Pose& pose : poses) pose.position.x += by.x, pose.position.z += by.y;
                    const float off = std::hypot(x, z);
                    choices.push_back(
                        {poses, t, 3 * off + 0.1f * travel(poses) + kSeatLost_m * static_cast<float>(t.seats)});
                }
    if (!try_all(std::move(choices)))
        throw Error("{} and {}: there is no free floor for both of them together, with those who sit at them",
                    step.ids[0], step.ids[1]);
}

namespace {

// The words without the first of these phrases; false: none is there.
bool drop_phrase(Words& words, std::initializer_list<std::string_view> phrases) {
    for (const std::string_view text : phrases) {
        const Words phrase = tokens_of(std::string(text));
        for (std::size_t i = 1; i + phrase.size() <= words.size(); ++i) {
            if (part_of(words, i, i + phrase.size()) != phrase) continue;
            words.erase(words.begin() + static_cast<std::ptrdiff_t>(i),
                        words.begin() + static_cast<std::ptrdiff_t>(i + phrase.size()));
            while (!words.empty() && is_joint(words.back())) words.pop_back();
            return true;
        }
    }
    return false;
}

// Whether a place is said by points in the room: those; none: it is said by nothing that has one.
std::vector<Vec2f> points_of(const Editor& editor, const EditStep& place) {
    if (place.position) return {*place.position};
    std::vector<Vec2f> out;
    if (place.wish.relation == "in the middle" && place.wish.relation_to.empty()) return {{0, 0}};
    if (place.wish.relation == "in the corner") return corners_of_room(editor.plan());
    if (!place.at.empty())
        for (const std::string& id : place.at) out.push_back(footprint_of(editor.placed(id)).center);
    else
        for (const Footprint& box : anchors_of(editor.plan(), editor.room().furnished.placed, place.wish.relation_to))
            out.push_back(box.center);
    return out;
}

float off_points(const std::vector<Vec2f>& points, Vec2f at) {
    float least = points.empty() ? 0.f : 1e9f;
    for (const Vec2f p : points) least = std::min(least, length(p - at));
    return least;
}

// "Two of the chairs", "a chair": so many, and of which; nothing: the words say which ones.
std::optional<std::pair<std::size_t, Words>> some_of(const Words& words) {
    const auto number = words.size() < 2 || is_definite(words.front()) ? std::nullopt : number_said(words.front());
    if (!number || *number < 1 || next_place(words) < words.size() || parts_of(words).size() > 1) return {};
    Words noun = part_of(words, 1);
    if (noun.size() > 2 && noun.front() == "of") noun = part_of(noun, is_definite(noun[1]) ? 2 : 1);
    if (noun.empty() || has_word(noun, {"first", "last", "other", "more"})) return {};
    return std::pair(static_cast<std::size_t>(*number), joined_words({"all"}, noun));
}

}  // namespace

// Of "two of the tables" those that are nearest to where they are to go, and not there yet.
std::vector<std::string> nearest_of(Talk& talk, const Words& thing, const Words& where,
                                    const std::vector<std::string>& spoken) {
    const auto some = some_of(thing);
    if (!some) return {};
    const std::vector<int> all = all_named(talk.editor, text_of(some->second));
    if (all.size() <= some->first) return {};
    const auto at = [&](int i) -> const Placed& {
        return talk.editor.room().furnished.placed[static_cast<std::size_t>(i)];
    };
    // Of chairs and an armchair "a chair" is a chair.
    if (std::any_of(all.begin(), all.end(), [&](int i) { return at(i).piece.kind != at(all.front()).piece.kind; }))
        return {};
    std::optional<Place> place;
    try {
        place = place_of(talk.editor, where, asked_kind(at(all.front())), at(all.front()).id, spoken);
    } catch (const UsageError&) {
    }
    if (!place || place->step.elsewhere) return {};
    const std::vector<Vec2f> points = points_of(talk.editor, place->step);
    if (points.empty()) return {};
    PromptObject wish = place->step.wish;
    wish.id = -2;  // none of those that stand there
    std::vector<std::pair<float, int>> order;
    for (const int i : all) {
        constexpr float kThere = 100;  // metres: last of all
        const bool there = place->step.at.empty() &&
                           is_where_asked(talk.editor.plan(), talk.editor.room().furnished.placed, at(i), wish);
        const bool at_it = at(i).with >= 0 && is_among(at(at(i).with).id, place->step.at);
        order.emplace_back(off_points(points, footprint_of(at(i)).center) + (there || at_it ? kThere : 0.f), i);
    }
    std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::string> ids;
    for (std::size_t k = 0; k < some->first; ++k) ids.push_back(at(order[k].second).id);
    return talk.last = ids;
}

namespace {

// The two that are nearest to those points, and to each other.
std::vector<std::string> closest_two(const Editor& editor, const std::vector<std::string>& ids,
                                     const std::vector<Vec2f>& points) {
    float least = 1e9f;
    std::vector<std::string> best;
    for (const std::string& a : ids)
        for (const std::string& b : ids) {
            const Vec2f at = footprint_of(editor.placed(a)).center, other = footprint_of(editor.placed(b)).center;
            const float far = off_points(points, at) + length(at - other);
            if (a != b && far < least) least = far, best = {a, b};
        }
    return best;
}

// Before the opening that is nearest to them, where both have room.
std::optional<Vec2f> before_nearest(const Editor& editor, const EditStep& place, const std::vector<std::string>& ids) {
    constexpr float kSeats_m = 0.6f;  // for whoever sits there
    float wide = 0;
    for (const std::string& id : ids) wide = std::max(wide, footprint_of(editor.placed(id)).half.y);
    const Vec2f here = footprint_of(editor.placed(ids.front())).center;
    std::optional<Vec2f> out;
    for (const Footprint& o : anchors_of(editor.plan(), editor.room().furnished.placed, place.wish.relation_to)) {
        const Vec2f before = o.center + axes_of(o)[1] * (wide + kSeats_m);
        if (!out || length(before - here) < length(*out - here)) out = before;
    }
    return out;
}

}  // namespace

// "The desks together in the middle, facing each other", "two of the tables together by the window"; false: no such
// words, or they are of no tables.
bool join_tables(Talk& talk, const Words& said, const std::vector<std::string>& spoken) {
    Words words = said;
    // "The two tables by the counter together": which ones.
    const std::size_t first = next_place(said);
    const bool qualified = first < said.size() && said[first] != "together" && said.back() == "together";
    const bool facing = drop_phrase(
        words, {"so that they face each other", "so they face each other", "facing each other", "facing one another",
                "to face each other", "face to face", "back to back"});
    const bool in_pairs = drop_phrase(words, {"in pairs", "into pairs", "in twos", "two by two"});
    const bool long_one = is_one_of(talk.said, {"combine", "join", "merge"});
    if (const std::size_t into = find_word(words, {"into"}, 1); long_one && into < words.size()) words.resize(into);
    const bool together = drop_phrase(words, {"close together", "together"}) || in_pairs || long_one;
    std::size_t place = next_place(words);
    if (qualified) try {
            const std::vector<std::string> last = talk.last, mentioned = talk.mentioned;
            if (talk.things_of_parts(words).size() == 2) place = words.size();
            talk.last = last, talk.mentioned = mentioned;
        } catch (const UsageError&) {  // it is where they go
        }
    if (words.empty() || (!together && (!facing || place == words.size()))) return false;
    const Words where = part_of(words, place), which = part_of(words, 0, place);
    const auto is_joined = [&](const Placed& p) {
        return p.piece.mount == Mount::floor && p.on < 0 && is_sat_at(p.piece.kind) &&
               (!facing || has_role(p.piece.kind, Role::work_place) || together);
    };
    const auto some = some_of(which);
    std::vector<std::string> ids;
    const std::vector<std::string> last = talk.last, mentioned = talk.mentioned;
    if (some && some->first == 2)
        for (const int i : all_named(talk.editor, text_of(some->second)))
            ids.push_back(talk.editor.document().things[static_cast<std::size_t>(i)].id);
    else ids = talk.things_of_parts(which);
    if (ids.size() < 2 || (ids.size() > 2 && !some && !in_pairs) ||
        !std::all_of(ids.begin(), ids.end(),
                     [&](const std::string& id) { return is_joined(talk.editor.placed(id)); })) {
        talk.last = last, talk.mentioned = mentioned;
        return false;
    }
    std::optional<Place> there;
    if (!where.empty()) {
        there = place_of(talk.editor, where, asked_kind(talk.editor.placed(ids.front())), ids.front(), spoken);
        if (!there) throw UsageError("expected a place in the room, found \"{}\"", text_of(where));
    }
    if (in_pairs && ids.size() > 2 && !there) {
        std::vector<EditStep> pairs;
        for (std::vector<std::string> left = ids; left.size() > 1;) {
            EditStep pair;
            pair.kind = EditStep::Kind::join;
            pair.value = facing ? "facing" : "";
            pair.ids = closest_two(talk.editor, left, {});
            for (const std::string& id : pair.ids) std::erase(left, id);
            pairs.push_back(pair);
        }
        do_each(talk.editor, pairs.size(), [&](std::size_t k) { talk.editor.apply(pairs[k]); });
        talk.vague = true;  // which of them pair is told
        return true;
    }
    // Of several, the two that have the shortest way there, and to each other.
    if (ids.size() > 2)
        ids = closest_two(talk.editor, ids, there ? points_of(talk.editor, there->step) : std::vector<Vec2f>{});
    talk.last = ids;
    EditStep step;
    step.kind = EditStep::Kind::join;
    step.ids = ids, step.value = facing ? "facing" : long_one ? "long" : "";
    const bool touch = gap_between_edges(talk.editor.placed(ids[0]), talk.editor.placed(ids[1])) < 0.03f;
    if (touch && !there && !facing)
        throw AlreadySo(fmt::format("{} and {}: they stand together already", ids[0], ids[1]));
    talk.editor.together([&] {
        if (there && there->step.wish.relation == "in the middle" && there->step.at.empty()) {
            step.position = Vec2f{0, 0};
        } else if (there && !noun_of(there->step.wish.relation_to).empty()) {
            step.position = before_nearest(talk.editor, there->step, ids);
        } else if (there) {
            there->step.kind = EditStep::Kind::place, there->step.ids = {ids.front()};
            try {
                talk.editor.apply(there->step);
            } catch (const AlreadySo&) {
            }
        }
        talk.editor.apply(step);
    });
    if (there) talk.last_place = there->step;
    return true;
}

}  // namespace fastscene::editing

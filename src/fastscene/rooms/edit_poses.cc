// Things moved and turned by so much.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_relations.h"
#include "fastscene/rooms/validate.h"

namespace fastscene::editing {
namespace {

// What is wrong with a room, with the ids of its things.
std::set<std::string> faults_of(const RoomDocument& document, const FurnishedRoom& room, const std::vector<Placed>& all,
                                const Passage& passage = {}) {
    std::set<std::string> out;
    for (const Fault& fault : room_faults(room.plan, all, room.camera, passage, round_ones(all))) {
        std::string text = fault.text;
        for (std::size_t i = all.size(); i-- > 0;) {
            const std::string name = all[i].piece.kind + " #" + std::to_string(i);
            for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name))
                text.replace(at, name.size(), document.things[i].id);
        }
        out.insert(text);
    }
    return out;
}

// Where `at` comes to stand when what stood at `from` stands at `to`.
Vec3f carried(Vec3f at, Vec3f from, Vec3f to, float turn) {
    const float c = std::cos(turn), s = std::sin(turn);
    const Vec3f d = at - from;
    return to + Vec3f{c * d.x + s * d.z, d.y, c * d.z - s * d.x};
}

// "room: /things/3: sofa-1 reaches into a wall": of a sentence, only what is wrong.
std::string without_place(const std::string& text) {
    if (text.starts_with("no way leads from the door")) return "it would block the way from the door";
    if (!text.starts_with("room: /things/")) return text;
    return text.substr(text.find(": ", text.find(": ") + 1) + 2);
}

// What was not wrong before; nothing of the camera, which moves.
std::string first_new(const std::set<std::string>& before, const std::set<std::string>& now) {
    for (const std::string& fault : now)
        if (!before.contains(fault) && !is_of_camera(fault)) return fault;
    return {};
}

}  // namespace

bool is_of_camera(const std::string& fault) {
    return fault.ends_with("the camera") && fault.find("a place for") == std::string::npos;
}

// Moves a thing with what stands on it, and with others `along`.
void Editor::set_pose(int index, Pose pose, const std::vector<int>& along) {
    const Placed before = placed(index);
    std::vector<int> moving{index};
    moving.insert(moving.end(), along.begin(), along.end());
    for (const int i : with_riders(moving)) {
        DocumentThing& t = thing(i);
        t.position = carried(t.position, before.position, pose.position, pose.yaw - before.yaw);
        t.yaw = i == index ? pose.yaw : std::remainder(t.yaw + pose.yaw - before.yaw, 2 * kPi);
    }
    tell_pose(index, before.position);
    for (const int i : along) tell(thing(i).id, "moved with " + thing(index).id);
}

void Editor::tell_pose(int index, Vec3f from) {
    const DocumentThing& t = thing(index);
    constexpr float kSeen = 5e-3f;  // metres
    const float far = length(t.position - from);
    constexpr float kTurned = 1 * kPi / 180;
    const bool turned = std::abs(std::remainder(t.yaw - placed(index).yaw, 2 * kPi)) > kTurned;
    const std::string how = fmt::format("turned to {:.0f} degrees", t.yaw * 180 / kPi);
    tell(t.id, far < kSeen ? how
                           : fmt::format("moved {:.2f} m to x {:.2f}, z {:.2f}{}", far, t.position.x, t.position.z,
                                         turned ? ", " + how : ""));
}

// The room with a thing at another pose.
std::vector<Placed> Editor::with_pose(int index, Pose pose, const std::vector<int>& along) const {
    std::vector<Placed> all = room_.furnished.placed;
    std::vector<int> moving{index};
    moving.insert(moving.end(), along.begin(), along.end());
    const float turn = pose.yaw - placed(index).yaw;
    for (const int i : with_riders(moving)) {
        Placed& p = all[static_cast<std::size_t>(i)];
        p.position = carried(p.position, placed(index).position, pose.position, turn);
        p.yaw = i == index ? pose.yaw : std::remainder(p.yaw + turn, 2 * kPi);
    }
    return all;
}

// What is wrong with it that was not before; empty: nothing.
std::string Editor::new_fault(const std::vector<Placed>& all) const {
    const std::set<std::string> before = faults_of(result_.document, room_.furnished, room_.furnished.placed);
    return first_new(before, faults_of(result_.document, room_.furnished, all));
}

void Editor::together(const std::function<void()>& change) {
    const EditResult kept = result_;
    const std::size_t notes = notes_;
    const std::set<std::string> smaller = smaller_;
    try {
        change();
    } catch (const Error&) {
        result_ = kept, notes_ = notes, smaller_ = smaller;
        build();
        throw;
    }
}

// Nothing may be wrong that was not before.
void Editor::checked(const std::function<void()>& change, const Passage& passage) {
    const auto faults = [&] { return faults_of(result_.document, room_.furnished, room_.furnished.placed, passage); };
    const std::set<std::string> before = faults();
    try {
        together([&] {
            change();
            build();
            if (const std::string fault = first_new(before, faults()); !fault.empty()) throw Error("{}", fault);
        });
    } catch (const UsageError&) {
        throw;
    } catch (const Error& e) {
        throw Error("{}", without_place(e.what()));
    }
}

// Turned by an angle; what then reaches into something stands a little off it. False: it has room where it stands, or
// nowhere.
bool Editor::turned_aside(int i, float turn, const std::vector<int>& along) {
    constexpr int kAround = 16;
    const Placed p = placed(i);
    const float yaw = std::remainder(p.yaw + turn, 2 * kPi);
    if (p.piece.mount != Mount::floor || new_fault(with_pose(i, {p.position, yaw}, along)).empty()) return false;
    // With its chairs it may take more room.
    std::vector<float> offs{0.06f, 0.12f, 0.2f, 0.3f, 0.4f, 0.5f};
    if (!along.empty()) offs.insert(offs.end(), {0.6f, 0.7f, 0.8f, 0.9f, 1.f});
    for (const float off : offs)
        for (int way = 0; way < kAround; ++way) {
            const float angle = 2 * kPi * static_cast<float>(way) / kAround;
            Placed turned = p;
            turned.position = p.position + Vec3f{std::sin(angle), 0, std::cos(angle)} * off, turned.yaw = yaw;
            if (!stands_clear(i, footprint_of(turned), along)) continue;
            if (!new_fault(with_pose(i, {turned.position, yaw}, along)).empty()) continue;
            checked([&] { set_pose(i, {turned.position, yaw}, along); });
            return true;
        }
    return false;
}

void Editor::move(const EditStep& step) {
    do_each(*this, step.ids.size(), [&](std::size_t k) {
        const int i = index_of(step.ids[k]);
        if (step.kind == EditStep::Kind::turn) return turn_one(i, step);
        checked([&] {
            const Placed& p = placed(i);
            Vec3f to = p.position;
            if (step.position) to.x = step.position->x, to.z = step.position->y;
            DocumentThing& t = thing(i);
            // Off what carried it, it stands on the floor.
            if (step.position && !t.on.empty()) to.y = 0, t.on.clear();
            set_pose(i, {to, step.yaw.value_or(p.yaw)}, {});
        });
    });
}

void Editor::turn_one(int i, const EditStep& step) {
    const float turn = step.yaw.value_or(kPi), yaw = std::remainder(placed(i).yaw + turn, 2 * kPi);
    if (const std::vector<int> seats = seats_at(i); !seats.empty()) try {
            return checked([&] { set_pose(i, {placed(i).position, yaw}, seats); });
        } catch (const Error&) {  // there is no room for them: a little off, or it turns alone
            if (turned_aside(i, turn, seats)) return;
        }
    if (turned_aside(i, turn, {})) return;
    checked([&] { set_pose(i, {placed(i).position, yaw}, {}); });
}

bool Editor::seats_clear(int table, const Placed& there, const std::vector<int>& seats,
                         const std::vector<int>& along) const {
    const Placed& was = placed(table);
    return std::all_of(seats.begin(), seats.end(), [&](int i) {
        Placed seat = placed(i);
        seat.position = carried(seat.position, was.position, there.position, there.yaw - was.yaw);
        seat.yaw += there.yaw - was.yaw;
        return stands_clear(i, footprint_of(seat), along);
    });
}

std::vector<int> Editor::seats_at(int table) const {
    const std::string& kind = placed(table).piece.kind;
    std::vector<int> out;
    if (!has_role(kind, Role::lamp_above) && !has_role(kind, Role::work_place)) return out;
    for (int i = 0; i < static_cast<int>(room_.furnished.placed.size()); ++i)
        if (placed(i).with == table && has_role(placed(i).piece.kind, Role::seat)) out.push_back(i);
    return out;
}

namespace {

// What hangs on a wall stays on it.
Vec3f along_its_wall(const Placed& p, Vec3f way) {
    if (p.piece.mount != Mount::wall) return way;
    const Vec3f off = front_of(p.yaw);
    return way - off * dot(way, off);
}

// As far as there is room, unless it was said how far; past what is in the way, if that will do.
std::vector<Vec3f> ways_of(const EditStep& step) {
    std::vector<Vec3f> out;
    for (const float turn : {0.f, 0.6f, -0.6f, 1.1f, -1.1f}) {  // radians
        const float c = std::cos(turn), s = std::sin(turn);
        const Vec3f way{c * step.by.x + s * step.by.z, step.by.y, c * step.by.z - s * step.by.x};
        for (const float part : {1.f, 0.75f, 0.5f, 0.35f, 0.2f})
            if (part == 1 || !step.exactly) out.push_back(way * part);
        if (!step.about) break;
    }
    return out;
}

}  // namespace

void Editor::shift(const EditStep& step) {
    do_each(*this, step.ids.size(), [&](std::size_t k) { shift_one(index_of(step.ids[k]), step); });
}

void Editor::shift_one(int i, const EditStep& step) {
    if (placed(i).piece.mount == Mount::ceiling && step.by.y > 0)
        throw Error("{}: it hangs from the ceiling, and no higher than it does", thing(i).id);
    std::string fault;
    const std::vector<int> seats = seats_at(i), before_it = goes_before(i);
    std::vector<std::vector<int>> groups{seats};
    if (!seats.empty()) groups.emplace_back();
    if (!before_it.empty()) groups.push_back(before_it);
    for (const Vec3f way : ways_of(step))
        for (const std::vector<int>& along : groups) {
            const Pose to{placed(i).position + along_its_wall(placed(i), way), placed(i).yaw};
            fault = new_fault(with_pose(i, to, along));
            if (fault.empty()) {
                checked([&] { set_pose(i, to, along); });
                return along.empty() ? bring_seats(i, seats) : void();
            }
        }
    // What stands at a wall goes along it, where the way that was said leads into the wall: as whoever looks at it sees
    // left and right, where that is straight into the wall or off it.
    if (const Placed& p = placed(i); p.piece.against_wall && step.by.y == 0 && wall_behind(plan(), p) >= 0) {
        constexpr float kAlong = 0.25f, kSideways = 0.9f;  // of the way
        const Vec3f up{0, 1, 0};
        const float all = length(step.by), sideways = dot(step.by, cross(room_.furnished.looks, up));
        Vec3f along = right_of(p.yaw);
        if (std::abs(dot(step.by, along)) >= kAlong * all) along = along * std::copysign(1.f, dot(step.by, along));
        else along = cross(front_of(p.yaw) * -1.f, up) * std::copysign(1.f, sideways);
        const bool known = std::abs(dot(step.by, along)) >= kAlong * all || std::abs(sideways) > kSideways * all;
        for (const float part : {1.f, 0.75f, 0.5f, 0.35f, 0.2f}) {
            if (!known || (part < 1 && step.exactly)) break;
            const Pose to{p.position + along * (all * part), p.yaw};
            if (!new_fault(with_pose(i, to, seats)).empty()) continue;
            return checked([&] { set_pose(i, to, seats); });
        }
    }
    throw Error("{}: there is no room for it there: {}", thing(i).id, fault);
}

// Where what it is to face stands: the nearest that is meant.
std::optional<Vec2f> Editor::target_of(const EditStep& step, int from) const {
    std::optional<Vec2f> best;
    const Vec2f here = footprint_of(placed(from)).center;
    const auto take = [&](Vec2f there) {
        if (!best || length(there - here) < length(*best - here)) best = there;
    };
    // Square off the wall behind it.
    if (step.wish.relation_to == "room") {
        constexpr float kFar = 100;  // metres
        Vec2f ahead{};
        float most = -1;
        for (int w = 0; w < 4; ++w)
            if (const Vec2f inward = flat(plan().wall(w).inward); dot(here * -1.f, inward) > most)
                most = dot(here * -1.f, inward), ahead = inward;
        return here + ahead * kFar;
    }
    if (step.wall >= 0) {
        const WallFace face = plan().wall(step.wall);
        return here - flat(face.inward) * dot(here - flat(face.origin), flat(face.inward));
    }
    if (step.wish.relation_to == "viewer") return flat(room_.furnished.camera);
    for (const std::string& id : step.at) take(footprint_of(placed(id)).center);
    // Straight ahead, where the opening is as wide as that.
    for (const Opening& o : plan().openings) {
        if (!is_opening_of(o, step.wish.relation_to)) continue;
        const WallFace face = plan().wall(o.wall);
        const float across = dot(here - flat(face.origin), flat(face.along));
        take(flat(face.point(across > o.u0 && across < o.u1 ? across : (o.u0 + o.u1) / 2, 0)));
    }
    return best;
}

namespace {

// How far off its place a thing may come to stand when it is turned, and by how much past its target it may look:
// first exactly, then nearly.
struct Turned {
    float off, aside;  // metres, radians
};
std::vector<Turned> turns(bool far) {
    constexpr float kNearly = 12 * kPi / 180;
    std::vector<Turned> out{{0, 0}};
    for (const float off : {0.06f, 0.12f, 0.2f, 0.3f}) out.push_back({off, 0});
    for (const float off : {0.f, 0.06f, 0.12f, 0.2f, 0.3f, 0.4f, 0.5f, 0.6f, 0.7f, 0.8f})
        for (const float part : {0.f, 1.f, -1.f, 2.f, -2.f})
            if (off > 0.3f || part != 0) out.push_back({off, part * kNearly});
    for (const float off : {0.9f, 1.f, 1.1f, 1.2f})
        if (far) out.push_back({off, 0});
    return out;
}
constexpr int kDirections = 16;

}  // namespace

// Turned where it stands; what then reaches into something stands a little off it.
void Editor::face(const EditStep& step) {
    do_each(*this, step.ids.size(), [&](std::size_t k) { face_one(index_of(step.ids[k]), step); });
}

void Editor::face_one(int i, const EditStep& step) {
    // To a window one need not look at its very middle.
    const bool opening = step.at.empty() && noun_of(step.wish.relation_to) != "";
    const float kFaces = (opening ? 20.f : 3.f) * kPi / 180;
    {
        const std::string id = thing(i).id;
        const std::optional<Vec2f> target = target_of(step, i);
        if (!target) throw UsageError("there is no {} in the room", in_words(step.wish.relation_to));
        const Placed& p = placed(i);
        std::string fault;
        bool done = false;
        if (step.slightly) {
            const Vec2f way = *target - flat(p.position);
            const float by = std::remainder(std::atan2(way.x, way.y) - p.yaw, 2 * kPi);
            EditStep turn;
            turn.kind = EditStep::Kind::turn;
            turn.ids = {id}, turn.yaw = std::clamp(by, -kSlightTurn, kSlightTurn);
            return turn_one(i, turn);
        }
        const std::vector<int> seats = seats_at(i);
        // Whoever sits at a desk faces it.
        const float sign = has_role(p.piece.kind, Role::work_place) && !seats.empty() ? -1.f : 1.f;
        const Vec2f ahead_now = (*target - flat(p.position)) * sign;
        const float wrong_by = std::abs(std::remainder(std::atan2(ahead_now.x, ahead_now.y) - p.yaw, 2 * kPi));
        const bool sat_at = sign < 0 && !seats.empty();
        const std::vector<int> before_it = goes_before(i);
        std::vector<std::vector<int>> groups{seats, {}};
        if (!before_it.empty()) groups.push_back(before_it);
        for (const auto& [off, aside] : turns(sat_at || !before_it.empty())) {
            if (std::abs(aside) > wrong_by / 2) continue;  // it would hardly turn
            const int ways = off > 0 ? kDirections : 1;
            for (int way = 0; way < ways && !done; ++way) {
                const float angle = 2 * kPi * static_cast<float>(way) / kDirections;
                const Vec3f to = p.position + Vec3f{std::sin(angle), 0, std::cos(angle)} * off;
                const Vec2f ahead = (*target - flat(to)) * sign;
                const float yaw = std::remainder(std::atan2(ahead.x, ahead.y) + aside, 2 * kPi);
                if (off == 0 && aside == 0 && std::abs(std::remainder(yaw - p.yaw, 2 * kPi)) < kFaces) {
                    // By this very sentence: "before the fire, facing it".
                    done = std::any_of(result_.changes.begin(), result_.changes.end(),
                                       [&](const EditChange& c) { return c.id == id; });
                    if (!done) throw AlreadySo(id + ": it faces the " + in_words(step.wish.relation_to) + " already");
                    break;
                }
                Placed turned = p;
                turned.position = to, turned.yaw = yaw;
                for (const std::vector<int>& along : groups) {
                    if (sat_at && along.empty()) continue;  // nobody could sit at it
                    if (off > 0 && !stands_clear(i, footprint_of(turned), along)) continue;
                    const std::string wrong = new_fault(with_pose(i, {to, yaw}, along));
                    if (off == 0 && aside == 0) fault = wrong;
                    done = wrong.empty();
                    if (!done) continue;
                    checked([&] { set_pose(i, {to, yaw}, along); });
                    if (std::abs(aside) > kFaces) tell(id, "not quite turned to that: there is no more room");
                    break;
                }
            }
            if (done) break;
        }
        constexpr float kAbout = 25 * kPi / 180;
        if (!done && wrong_by < kAbout)
            throw AlreadySo(id + ": it faces the " + in_words(step.wish.relation_to) + " already, by and large");
        if (!done) throw Error("{}: there is no room to turn it: {}", id, fault);
    }
}

}  // namespace fastscene::editing

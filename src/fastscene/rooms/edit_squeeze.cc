// Places where the layout's rules of comfort leave none. If someone asks for a thing by name, they want it there: only
// what would overlap something, block a door or hang in the air is refused. Whatever is given up is reported.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_relations.h"
#include "fastscene/rooms/validate.h"

namespace fastscene::editing {
namespace {

constexpr int kMostLooks = 60;  // at the whole room, for one step: a fraction of a second
constexpr float kTouching = 0.01f;

// Boxes that would share a volume, as the validator has it.
bool collide(const Footprint& a, const Footprint& b) {
    return overlap(shrunk(a, kTouching / 2), shrunk(b, kTouching / 2));
}

// What stands in the way of `p`; nothing: a wall, or what nobody moves about, is in it.
std::optional<std::vector<int>> in_the_way(const Plan& plan, const std::vector<Placed>& all, const Placed& p,
                                           const std::vector<int>& loose) {
    const Footprint box = footprint_of(p);
    if (!plan.holds(shrunk(box, kTouching))) return {};
    std::vector<int> out;
    for (int i = 0; i < static_cast<int>(all.size()); ++i) {
        const Placed& other = all[static_cast<std::size_t>(i)];
        if (other.flat || !collide(box, footprint_of(other))) continue;
        int root = i;
        while (all[static_cast<std::size_t>(root)].on >= 0) root = all[static_cast<std::size_t>(root)].on;
        if (std::find(loose.begin(), loose.end(), root) == loose.end()) return {};
        if (std::find(out.begin(), out.end(), root) == out.end()) out.push_back(root);
    }
    return out;
}

// Small free-standing things, which one would push aside to place a piece of furniture.
std::vector<int> loose_ones(const std::vector<Placed>& all) {
    constexpr float kSmall = 0.62f;  // metres wide and deep
    std::vector<int> out;
    for (int i = 0; i < static_cast<int>(all.size()); ++i) {
        const Placed& p = all[static_cast<std::size_t>(i)];
        if (p.piece.mount != Mount::floor || p.flat || p.on >= 0 || p.below >= 0 || p.sill >= 0) continue;
        const bool seated = p.with >= 0 && has_role(p.piece.kind, Role::seat);  // at its table
        const bool small = std::max(p.piece.size_m.x, p.piece.size_m.z) < kSmall && !p.piece.against_wall;
        if (!seated && (small || has_role(p.piece.kind, Role::movable))) out.push_back(i);
    }
    return out;
}

// Whether nothing else is wrong that was not before.
bool only_the_camera(const std::set<std::string>& before, const std::set<std::string>& now) {
    return std::all_of(now.begin(), now.end(),
                       [&](const std::string& fault) { return before.contains(fault) || is_of_camera(fault); });
}

// Where what stands in the way goes, with what stands on it: as near as may be.
bool push_aside(const Plan& plan, std::vector<Placed>& all, int index) {
    constexpr int kRings = 14, kWays = 16;
    constexpr float kFarthest = 0.7f;  // metres: further, it is another place
    const Placed was = all[static_cast<std::size_t>(index)];
    for (int ring = 1; ring <= kRings; ++ring)
        for (int way = 0; way < kWays; ++way) {
            const float angle = 2 * kPi * static_cast<float>(way) / kWays;
            const Vec3f by = Vec3f{std::sin(angle), 0, std::cos(angle)} *
                             (kFarthest * static_cast<float>(ring) / kRings);
            Placed p = was;
            p.position += by;
            const Footprint box = footprint_of(p);
            if (!plan.holds(box) || blocks_opening(plan, box)) continue;
            const bool free = std::none_of(all.begin(), all.end(), [&](const Placed& other) {
                return &other != &all[static_cast<std::size_t>(index)] && !other.flat && other.on != index &&
                       collide(box, footprint_of(other));
            });
            if (!free) continue;
            std::vector<int> along{index};
            for (std::size_t k = 0; k < along.size(); ++k)
                for (int i = 0; i < static_cast<int>(all.size()); ++i)
                    if (all[static_cast<std::size_t>(i)].on == along[k]) along.push_back(i);
            for (const int i : along) all[static_cast<std::size_t>(i)].position += by;
            return true;
        }
    return false;
}

}  // namespace

// In the order in which they are given up: the free floor before other things, the width of the ways, the usual size,
// the very place, small things where they are.
std::vector<Squeeze> squeezes(bool may_shrink) {
    std::vector<Squeeze> out;
    for (const bool narrow : {false, true}) out.push_back({.narrow = narrow});
    if (may_shrink)
        for (const float scale : {0.82f, 0.66f}) out.push_back({.narrow = true, .scale = scale});
    constexpr float kNearby = 0.5f, kThereabouts = 1.3f;  // metres
    out.push_back({.narrow = true, .further = kNearby});
    out.push_back({.narrow = true, .pushes = true});
    out.push_back({.narrow = true, .further = kThereabouts});
    return out;
}

Vec3f shrunk_size(const Piece& usual, float scale) {
    constexpr float kTall_m = 2.f;  // what one walks into, or hangs clothes in
    Vec3f out = usual.size_m * scale;
    if (usual.mount == Mount::floor && usual.against_wall && usual.size_m.y > kTall_m) out.y = usual.size_m.y;
    return out;
}

PieceRequest shrunk_to(PieceRequest request, float scale) {
    if (scale >= 1) return request;
    const Piece usual = make_piece(request);
    if (const Vec3f size = shrunk_size(usual, scale); size.y == usual.size_m.y) {
        request.size_m = size, request.size_factor = 1;
        return request;
    }
    request.size_factor *= scale;
    request.size_m = request.size_m * scale;
    return request;
}

std::set<std::string> Editor::fault_texts(const std::vector<Placed>& all, const Passage& passage) const {
    std::set<std::string> out;
    for (const Fault& f : room_faults(plan(), all, room_.furnished.camera, passage, round_ones(all)))
        out.insert(f.text);
    return out;
}

std::optional<Squeezed> Editor::squeezed_in(const Standing& standing, const EditStep& step, const Placed* moving,
                                            const Squeeze& how,
                                            const std::function<bool(const Squeezed&)>& accepts) const {
    Asked asked = asked_among(standing, step);
    PromptObject& wish = asked.spec.objects[0];
    Random rng(room_.seed, "squeeze:" + wish.kind, asked.among.size());
    Layout layout = begin_layout(asked.spec, rng, asked.among, moving);
    if (!layout.why_not(wish.kind).empty() || wish.count > 1) return {};
    if (wish.relation == "on" && how.pushes) {
        auto found = squeezed_on_top(layout, moving);
        if (found)
            for (int& i : found->pushed) i = standing.was[static_cast<std::size_t>(i)];
        return found && accepts(*found) ? found : std::nullopt;
    }
    const bool under_thing = wish.relation == "under" && noun_of(wish.relation_to).empty();
    if (is_one_of(wish.relation, {"on", "above"}) || under_thing || mount_of(*this, wish.kind) == Mount::wall)
        return squeezed_on_wall(layout, step, moving, how, accepts);
    if (how.scale < kLeastSeat && (has_role(wish.kind, Role::seat) || has_role(wish.kind, Role::bed))) return {};
    Placed p;
    p.piece = make_piece(shrunk_to(layout.request(wish.kind, &wish), how.scale));
    if (p.piece.mount != Mount::floor || is_rug(p.piece)) return {};
    p.wish = wish;
    const std::vector<Placed>& all = layout.placed();
    EditStep there = step;
    const int own = moving ? wall_behind(plan(), *moving) : -1;
    if (step.opposite && own >= 0) there.wall = (own + 2) % 4;
    std::vector<Candidate> places = candidates_for(layout, there, p.piece, how.further);
    // Beside a table no seat is at its end.
    if (wish.relation == kAtTheEnds && has_role(wish.kind, Role::seat))
        std::erase_if(places, [&](const Candidate& c) { return !is_at_an_end(all, wish, c.at); });
    if (step.elsewhere && moving)
        std::erase_if(places, [&](const Candidate& c) {
            p.position = {c.at.x, 0, c.at.y}, p.yaw = c.yaw;
            constexpr float kElsewhere = 0.7f;  // metres: nearer than that is the same place
            const Vec2f from = footprint_of(*moving).center;
            return length(c.at - from) < kElsewhere ||
                   (wish.relation == "in the corner" && from.x * c.at.x > 0 && from.y * c.at.y > 0) ||
                   (own >= 0 && wish.relation != "in the corner" && wall_behind(plan(), p) == own);
        });
    const std::vector<int> loose = how.pushes ? loose_ones(all) : std::vector<int>{};
    const Passage passage = how.narrow ? kNarrow : Passage{};
    const std::set<std::string> before = fault_texts(all, passage);
    int looks = 0;
    std::optional<Squeezed> at_camera;  // the first place at which only the camera is in the way
    for (const Candidate& c : places) {
        p.position = {c.at.x, 0, c.at.y}, p.yaw = c.yaw;
        const auto blocked = in_the_way(plan(), all, p, loose);
        constexpr std::size_t kMostPushed = 2;
        if (!blocked || blocked->size() > kMostPushed) continue;
        Squeezed out{all, {}};
        out.all.push_back(p);
        if (!std::all_of(blocked->begin(), blocked->end(), [&](int i) { return push_aside(plan(), out.all, i); }))
            continue;
        // Before a door there is hardly ever a place: those that lie there count less.
        constexpr int kWhole = 4;
        looks += blocks_opening(plan(), footprint_of(p)) ? 1 : kWhole;
        if (looks > kWhole * kMostLooks) break;
        const auto now = fault_texts(out.all, passage);
        const bool fine = std::includes(before.begin(), before.end(), now.begin(), now.end());
        if (!fine && (at_camera || !only_the_camera(before, now))) continue;
        for (const int i : *blocked) out.pushed.push_back(standing.was[static_cast<std::size_t>(i)]);
        out.off = c.off;
        if (!fine) at_camera = out;
        else if (accepts(out)) return out;
    }
    // The camera is no furniture: it moves.
    return at_camera && accepts(*at_camera) ? at_camera : std::nullopt;
}

namespace {

// Above a thing's end rather than above it.
bool is_off_middle(const std::vector<Placed>& all, const Placed& p, const PromptObject& wish) {
    constexpr float kOfHalf = 0.6f;
    return wish.relation == "above" && std::none_of(all.begin(), all.end(), [&](const Placed& below) {
               return (below.piece.kind == wish.relation_to || below.wish.kind == wish.relation_to) &&
                      std::abs(dot(p.position - below.position, right_of(below.yaw))) <
                          kOfHalf * below.piece.size_m.x / 2;
           });
}

}  // namespace

// What hangs on walls, also before or beside what stands there; a screen, where it was asked for on the wall.
std::optional<Squeezed> Editor::squeezed_on_wall(Layout& layout, const EditStep& step, const Placed* moving,
                                                 const Squeeze& how,
                                                 const std::function<bool(const Squeezed&)>& accepts) const {
    if (how.pushes) return {};
    const PromptObject& wish = layout.spec().objects[0];
    PieceRequest request = layout.request(wish.kind, &wish);
    request.size_factor *= how.scale;
    request.size_m = request.size_m * how.scale;
    Placed p;
    p.piece = make_piece(request);
    p.wish = wish;
    const bool screen = std::any_of(p.piece.materials.begin(), p.piece.materials.end(),
                                    [](const Material& m) { return m.pattern == Pattern::screen; });
    constexpr float kSeated = 0.95f;  // metres: a screen before seats
    const bool at_wall = wish.relation_to == "wall" || (wish.relation == "above" && noun_of(wish.relation_to).empty());
    if (p.piece.mount == Mount::surface && screen && at_wall)
        mount_as(p.piece, Mount::wall), p.piece.hang_height_m = kSeated;
    if (p.piece.mount != Mount::wall) return {};
    const std::vector<Placed>& all = layout.placed();
    const std::vector<Placed> near = how.further > 0 ? grown(all, wish, how.further) : all;
    const std::vector<Footprint> anchors = anchors_of(plan(), all, wish.relation_to);
    // The wall at its back, however far off that is.
    int own = -1;
    for (int w = 0; w < 4 && moving; ++w)
        if (dot(plan().wall(w).inward, front_of(moving->yaw)) > 0.9f) own = w;
    const float usual = p.piece.hang_height_m > 0 ? p.piece.hang_height_m : 1.5f - p.piece.size_m.y / 2;
    const float level = moving && moving->piece.mount == Mount::wall ? moving->position.y : usual;
    struct Spot {
        Vec3f at;
        float yaw, cost;
    };
    std::vector<Spot> spots;
    const std::vector<WallFace> faces = plan().faces();
    for (const WallFace& face : faces) {
        if (!hangs_at(face)) continue;
        if (step.wall >= 0 && dot(face.inward, plan().wall(step.wall).inward) < 0.99f) continue;
        if (step.elsewhere && own >= 0 && dot(face.inward, plan().wall(own).inward) > 0.99f) continue;
        if (step.opposite && own >= 0 && dot(face.inward, plan().wall(own).inward) > -0.99f) continue;
        const float half = p.piece.size_m.x / 2;
        for (float u = half + 0.02f; u < face.length - half; u += kSlotStep)
            for (const float up : {0.f, 0.15f, -0.15f, 0.3f, -0.3f, 0.45f, 0.6f}) {
                p.position = face.point(u, std::max(0.1f, level + up)) + face.inward * 0.004f;
                p.yaw = yaw_of(face.inward);
                const Footprint box = footprint_of(p);
                if (!plan().holds(box) || !hangs_on_wall(plan(), faces, p)) continue;
                const bool blocked = std::any_of(all.begin(), all.end(), [&](const Placed& other) {
                    return !other.flat && (overlap(box, footprint_of(other)) || (!how.narrow && hides(other, p)));
                });
                if (blocked || !(stands_as_asked(plan(), all, p, wish).value_or(wish.relation.empty()) ||
                                 (how.further > 0 && wish.relation != "above" &&
                                  stands_as_asked(plan(), near, p, wish).value_or(false))))
                    continue;
                if (how.further == 0 && is_off_middle(all, p, wish)) continue;
                float cost = std::abs(up);
                if (!anchors.empty()) {
                    float off = 1e9f;
                    for (const Footprint& a : anchors) off = std::min(off, distance_to(a, box.center));
                    cost += off;
                } else if (moving) cost += length(box.center - footprint_of(*moving).center);
                else cost += 0.3f * std::abs(u - face.length / 2);
                spots.push_back({p.position, p.yaw, cost});
            }
    }
    std::stable_sort(spots.begin(), spots.end(), [](const Spot& a, const Spot& b) { return a.cost < b.cost; });
    const std::set<std::string> before = fault_texts(all);
    int looks = 0;
    for (const Spot& spot : spots) {
        if (++looks > kMostLooks) break;
        Squeezed out{all, {}};
        p.position = spot.at, p.yaw = spot.yaw;
        out.all.push_back(p);
        const auto now = fault_texts(out.all);
        if (!std::includes(before.begin(), before.end(), now.begin(), now.end())) continue;
        out.off = spot.cost;
        if (accepts(out)) return out;
    }
    return {};
}

// The room's things that stand elsewhere now, with what stands on them.
void Editor::make_way(const Squeezed& found, const std::string& whom) {
    const std::vector<Placed> before = room_.furnished.placed;
    for (const int i : found.pushed) {
        const auto now = std::find_if(found.all.begin(), found.all.end(),
                                      [&](const Placed& p) { return p.id == before[static_cast<std::size_t>(i)].id; });
        const Vec3f by = now->position - before[static_cast<std::size_t>(i)].position;
        for (const int k : with_riders({i})) thing(k).position += by;
        tell(thing(i).id, fmt::format("moved {:.2f} m to make room for {}", length(by), whom));
    }
}

void Editor::tell_squeeze(const std::string& id, const EditStep& step, const Squeezed& found, const Squeeze& how) {
    if (how.scale < 1) tell_smaller(id);
    if (how.further == 0) tell_distance(id, step);
    constexpr float kUnknown = 1e8f;  // metres: it was asked at no thing
    if (how.further > 0 && found.off < kUnknown)
        tell(id, fmt::format("as near as there was room:{}, {:.1f} m off", place_in_words(step), found.off));
    std::vector<Placed> all = room_.furnished.placed;
    Ways usual(plan());
    for (const Placed& p : all) usual.add(p);
    if (how.narrow && !usual.open()) tell(id, "a narrow way of 0.45 m is left past it");
    else if (how.further == 0 && how.scale == 1) tell(id, "close to what stands about it: there was no more room");
}

bool Editor::place_squeezed(int index, const EditStep& step, const std::vector<int>& along) {
    std::vector<int> moving{index};
    moving.insert(moving.end(), along.begin(), along.end());
    const Standing standing = without(with_riders(moving));
    const Placed was = placed(index);
    const std::string id = thing(index).id;
    const auto stands = [&](const Squeezed& found, const Squeeze& how) {
        // Nearer than it is, or it stays.
        constexpr float kThere = 0.05f, kWorthIt = 0.4f;  // metres
        const float least = how.further > 0 ? kWorthIt : kThere;
        if (length(found.all.back().position - was.position) < least) return false;
        try {
            checked(
                [&] {
                    make_way(found, id);
                    stand_at_found(index, found.all.back(), standing, step, along);
                },
                how.narrow ? kNarrow : Passage{});
        } catch (const Error&) {
            return false;
        }
        tell_squeeze(id, step, found, how);
        return true;
    };
    for (const Squeeze& how : squeezes(false))
        if (squeezed_in(standing, step, &was, how, [&](const Squeezed& found) { return stands(found, how); }))
            return true;
    return false;
}

// What came last there, and room for it; its id.
std::string Editor::admit_squeezed(const EditStep& step, const Squeezed& found) {
    const Standing standing = without({});
    std::vector<Placed> all = standing.placed;
    all.push_back(found.all.back());
    all.back().wish.relation = step.wish.relation, all.back().wish.relation_to = step.wish.relation_to;
    all.back().wish.relation_and = step.wish.relation_and;
    const std::string id = admit(all, standing, {place_in_words(step)}).front();
    make_way(found, id);
    build();
    return id;
}

// One by one; false: none of them has a place.
bool Editor::add_squeezed(const EditStep& step) {
    const int count = std::max(1, step.wish.count);
    const bool pair = step.wish.relation == "on both sides of";
    int done = 0;
    for (int n = 0; n < count; ++n) {
        EditStep one = step;
        one.wish.count = 1;
        if (pair) one.wish.relation = n % 2 == 0 ? "left of" : "right of";
        // Lamps in a row hang in a row, or they do not.
        if (count > 1 && mount_of(*this, step.wish.kind) == Mount::ceiling) return false;
        bool smaller = false, found = false;
        if (count > 1) try {
                const std::vector<Placed> all = with_added(one, smaller);
                for (const std::string& id : admit(all, without({}), {place_in_words(step)}))
                    if (smaller) tell_smaller(id);
                build();
                found = true;
            } catch (const Error&) {
            }
        for (const Squeeze& how : squeezes(step.wish.size_m == Vec3f{})) {
            if (found) break;
            auto squeezed = squeezed_in(without({}), one, nullptr, how, [](const Squeezed&) { return true; });
            if (!squeezed) continue;
            tell_squeeze(admit_squeezed(step, *squeezed), step, *squeezed, how);
            found = true;
        }
        done += found ? 1 : 0;
        if (!found) break;
    }
    if (done > 0 && done < count && step.wish.counted)
        note(kNotDone, fmt::format("{}: there is a free place for {} of {}{}", step.wish.words, done, count,
                                   place_in_words(step)));
    return done > 0;
}

}  // namespace fastscene::editing

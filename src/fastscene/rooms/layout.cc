#include "fastscene/rooms/layout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "fastscene/base/check.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/layout_relations.h"
#include "fastscene/rooms/pack.h"
#include "fastscene/rooms/room_type.h"

namespace fastscene {
namespace {

constexpr float kDoorCasing = 0.1f;   // and a finger
constexpr float kBeforeDoor = 0.85f;  // metres kept free before a door: at least, where a leaf opens into the room
constexpr float kIntoSwing = 0.03f;   // a leaf opens as far as it is wide, but for a finger

}  // namespace

Footprint footprint_of(const Placed& p, float margin) {
    const Vec3f s = p.piece.size_m;
    Footprint f;
    f.yaw = p.yaw;
    f.half = {s.x / 2 + margin, s.z / 2 + margin};
    Vec3f center = p.position;
    f.y0 = center.y;
    if (p.piece.mount == Mount::wall) center += front_of(p.yaw) * (s.z / 2);
    if (p.piece.mount == Mount::ceiling) f.y0 = center.y - s.y;
    f.y1 = f.y0 + s.y;
    f.center = flat(center);
    return f;
}

std::optional<Footprint> part_above(const Placed& p, float height) {
    Footprint whole = footprint_of(p);
    if (whole.y1 <= height) return {};
    Vec3f from{1e9f, 1e9f, 1e9f}, to{-1e9f, -1e9f, -1e9f};
    for (const Mesh& m : p.piece.meshes)
        for (const Vec3f& v : m.positions)
            if (p.position.y + v.y > height)
                for (std::size_t a = 0; a < 3; ++a) from[a] = std::min(from[a], v[a]), to[a] = std::max(to[a], v[a]);
    if (!(from.x <= to.x)) return {};
    whole.center = flat(p.position + right_of(p.yaw) * ((from.x + to.x) / 2) + front_of(p.yaw) * ((from.z + to.z) / 2));
    whole.half = {(to.x - from.x) / 2, (to.z - from.z) / 2};
    whole.y0 = std::max(whole.y0, height);
    return whole;
}

bool shelters(const std::vector<Placed>& all, int over, const Placed& thing) {
    constexpr float kThick = 0.36f;  // of what one lies on, with the frame that bears it
    if (thing.on < 0 || over < 0 || all[static_cast<std::size_t>(thing.on)].below != over) return false;
    const Placed& above = all[static_cast<std::size_t>(over)];
    return !above.piece.surfaces.empty() &&
           footprint_of(thing).y1 < above.position.y + above.piece.surfaces.front().center.y - kThick;
}

bool blocks_opening(const Plan& plan, const Footprint& box) {
    const float height = box.y1;
    for (const Opening& o : plan.openings) {
        const WallFace face = plan.wall(o.wall);
        if (!plan.needs_room(o)) continue;
        const bool door = o.kind != Opening::Kind::window || is_doors(o.glazing);
        if (!door && height > o.y0 - kSillThickness) {
            const Vec3f middle = face.point((o.u0 + o.u1) / 2, 0) + face.inward * (kSillReach / 2);
            if (overlap(box, {flat(middle),
                              {(o.u1 - o.u0) / 2 + kSillBeside, kSillReach / 2},
                              yaw_of(face.inward),
                              o.y0 - kSillThickness,
                              o.y0}))
                return true;
        }
        // What is on a desk may reach a little above the sill.
        constexpr float kAboveSill = 0.2f;
        const float below = free_before(o, kAboveSill);
        if (!door && height < below) continue;
        // At a chord before a round wall a thing stands farther in, and still before its window.
        const bool chords = has_cut_corners(plan);
        const float deep = o.kind == Opening::Kind::door ? std::max(kBeforeDoor, o.u1 - o.u0 - kIntoSwing)
                           : door                        ? kBeforeDoor
                           : chords                      ? 0.8f
                                                         : 0.35f;
        const Vec3f middle = face.point((o.u0 + o.u1) / 2, 0) + face.inward * (deep / 2);
        // Beside a window hang its curtains.
        Footprint zone{flat(middle),
                       {(o.u1 - o.u0) / 2 + (door ? kDoorCasing : kCurtainMargin), deep / 2},
                       yaw_of(face.inward),
                       0,
                       o.y1};
        if (!door) zone.y0 = below;
        if (overlap(box, zone)) return true;
    }
    return false;
}

bool shades_window(const Plan& plan, const Footprint& box) {
    constexpr float kBefore = 0.5f, kMost = 0.04f;  // metres from the wall; share of the window
    return std::any_of(plan.openings.begin(), plan.openings.end(), [&](const Opening& o) {
        if (o.kind != Opening::Kind::window || is_doors(o.glazing) || !plan.needs_room(o)) return false;
        const WallFace face = plan.wall(o.wall);
        const Vec2f to = box.center - flat(face.origin);
        const float u = dot(to, flat(face.along)), half = extent(box, flat(face.along)),
                    off = dot(to, flat(face.inward)) - extent(box, flat(face.inward));
        const float wide = std::min(u + half, o.u1) - std::max(u - half, o.u0),
                    high = std::min(box.y1, o.y1) - std::max(box.y0, o.y0);
        return off < kBefore && wide > 0 && high > 0 && wide * high > kMost * (o.u1 - o.u0) * (o.y1 - o.y0);
    });
}

bool wall_is_free(const Plan& plan, const WallFace& face, float u0, float u1, float y0, float y1) {
    const float beside = plan.cabin ? 0.04f : 0.1f;  // metres; of its frame
    return std::none_of(plan.openings.begin(), plan.openings.end(), [&](const Opening& o) {
        return o.wall == face.wall && u0 + face.from < o.u1 + beside && u1 + face.from > o.u0 - beside &&
               y0 < o.y1 + beside && y1 > o.y0 - beside;
    });
}

bool stands_level(const Plan& plan, const Placed& placed) {
    constexpr float kTolerance = 0.02f;
    if (plan.platforms.empty() || placed.piece.mount != Mount::floor || placed.on >= 0 || placed.sill >= 0) return true;
    const Footprint box = footprint_of(placed);
    return plan.is_level(box) && std::abs(box.y0 - plan.floor_below(box)) < kTolerance;
}

bool clear_of_walls(const Plan& plan, const Placed& placed) {
    const bool stands = placed.piece.mount == Mount::floor && !placed.flat && placed.on < 0;
    return plan.holds(footprint_of(placed, plan.panelling && stands ? kPanelling : 0.f));
}

bool hangs_on_wall(const Plan& plan, const std::vector<WallFace>& faces, const Placed& p) {
    for (const WallFace& face : faces) {
        if (!hangs_at(face)) continue;
        const float u = dot(p.position - face.origin, face.along), half = p.piece.size_m.x / 2,
                    off = dot(p.position - face.origin, face.inward);
        if (dot(face.inward, front_of(p.yaw)) < 0.99f || off < -0.005f || off > 0.06f || u < half ||
            u > face.length - half)
            continue;
        return wall_is_free(plan, face, u - half, u + half, p.position.y, p.position.y + p.piece.size_m.y);
    }
    return false;
}

bool stands_on_sill(const Plan& plan, const Placed& p) {
    if (p.sill < 0 || p.sill >= static_cast<int>(plan.openings.size())) return false;
    const Opening& o = plan.openings[static_cast<std::size_t>(p.sill)];
    const WallFace face = plan.wall(o.wall);
    const Footprint box = footprint_of(p);
    const Vec3f to = p.position - face.origin;
    const float u = dot(to, face.along), off = dot(to, face.inward), half_u = extent(box, flat(face.along)),
                half = extent(box, flat(face.inward));
    constexpr float kTolerance = 0.002f;
    return o.kind == Opening::Kind::window && std::abs(p.position.y - o.y0) < kTolerance && box.y1 < o.y1 &&
           u - half_u > o.u0 && u + half_u < o.u1 && off - half > -kRevealDepth - kTolerance &&
           off + half < kSillReach + kTolerance;
}

bool hangs_in_window(const Plan& plan, const Placed& p) {
    if (p.piece.mount != Mount::wall || p.sill < 0 || p.sill >= static_cast<int>(plan.openings.size())) return false;
    const Opening& o = plan.openings[static_cast<std::size_t>(p.sill)];
    const WallFace face = plan.wall(o.wall);
    const Vec3f to = p.position - face.origin;
    const float u = dot(to, face.along), off = dot(to, face.inward), half = p.piece.size_m.x / 2;
    return o.kind == Opening::Kind::window && dot(face.inward, front_of(p.yaw)) > 0.99f && u - half > o.u0 &&
           u + half < o.u1 && p.position.y > o.y0 - 0.001f && p.position.y + p.piece.size_m.y < o.y1 + 0.001f &&
           off > -kRevealDepth && off + p.piece.size_m.z < kSillReach;
}

void Layout::find_ways() {
    ways_ = Ways(plan_);
    for (const Placed& p : placed_) ways_.add(p);
}

bool hides(const Placed& floor, const Placed& hung) {
    const bool overhead = floor.piece.kind == "hanging_plant";
    const float before_m = overhead ? 0.4f : 0.15f;  // metres before it
    if (hung.piece.mount != Mount::wall || hung.sill >= 0 || (floor.piece.mount != Mount::floor && !overhead) ||
        floor.flat || floor.on >= 0 || floor.piece.kind == "curtain" || has_role(hung.piece.kind, Role::covers_wall))
        return false;
    Footprint before = footprint_of(hung);
    before.half.y += before_m / 2;
    before.center = before.center + flat(front_of(hung.yaw)) * (before_m / 2);
    return overlap(before, footprint_of(floor));
}

void Layout::ground(Placed& placed) const {
    if (plan_.platforms.empty() || placed.piece.mount != Mount::floor) return;
    placed.position.y += plan_.floor_below(footprint_of(placed));
}

bool Layout::fits(const Placed& placed, bool with_clearance) const {
    const Footprint box = footprint_of(placed);
    if (!clear_of_walls(plan_, placed) || !stands_level(plan_, placed)) return false;
    if (placed.flat || placed.overhead) return true;
    if (placed.piece.mount == Mount::floor && blocks_opening(plan_, box)) return false;
    Footprint room_for = box;
    if (with_clearance && placed.piece.mount == Mount::floor && placed.piece.clearance_front_m > 0) {
        const float front = std::min(placed.piece.clearance_front_m, 0.55f);
        room_for.half.y += front / 2;
        const Vec3f f = front_of(placed.yaw) * (front / 2);
        room_for.center = room_for.center + flat(f);
    }
    for (const Placed& other : placed_) {
        if (other.flat || other.below >= 0) continue;
        const Footprint b = footprint_of(other);
        if (other.on >= 0) {  // it may reach a little beyond the edge of what carries it
            if (overlap(box, b)) return false;
            continue;
        }
        if (overlap(box, b) || hides(placed, other)) return false;
        if (with_clearance && other.piece.mount == Mount::floor && overlap(room_for, b)) return false;
        // Nor may it stand in the other's way.
        if (with_clearance && other.piece.mount == Mount::floor && other.piece.against_wall &&
            other.piece.clearance_front_m > 0) {
            Footprint before = b;
            const float front = std::min(other.piece.clearance_front_m, 0.5f);
            before.half.y = front / 2;
            before.center = before.center + flat(front_of(other.yaw) * (b.half.y + front / 2));
            if (overlap(box, before)) return false;
        }
    }
    return true;
}

std::optional<int> Layout::keep(Placed placed, const PromptObject& from) {
    placed.wish = from;
    ways_.add(placed);
    placed_.push_back(std::move(placed));
    return static_cast<int>(placed_.size()) - 1;
}

void Layout::begin_with(std::vector<Placed> fixed) {
    FASTSCENE_CHECK(placed_.empty());
    placed_ = std::move(fixed);
    for (Placed& p : placed_) p.fixed = true;
    find_ways();
}

void Layout::undo(std::size_t mark) {
    if (placed_.size() == mark) return;
    placed_.resize(mark);
    ways_ = Ways(plan_);
    for (const Placed& p : placed_) ways_.add(p);
}

// Whether the floor about it, and the wall above it, are free too.
bool Layout::has_spare(const Placed& placed, const Spare& spare) const {
    if (spare.left > 0 || spare.right > 0 || spare.front > 0 || spare.behind > 0) {
        Footprint box = footprint_of(placed);
        const auto axes = axes_of(box);
        box.center = box.center + axes[0] * ((spare.right - spare.left) / 2) +
                     axes[1] * ((spare.front - spare.behind) / 2);
        box.half = box.half + Vec2f{(spare.left + spare.right) / 2, (spare.front + spare.behind) / 2};
        if (!plan_.holds(box) || blocks_opening(plan_, box)) return false;
        for (const Placed& other : placed_)
            if (!other.flat && other.on < 0 && overlap(box, footprint_of(other))) return false;
    }
    if (!spare.above) return true;
    // A hand's breadth of the wall's height above the piece, as wide as half of it.
    Footprint above = footprint_of(placed);
    above.y0 = above.y1 + 0.1f, above.y1 = above.y0 + 0.5f;
    above.half.x *= 0.5f;
    for (const Opening& o : plan_.openings) {
        const WallFace face = plan_.wall(o.wall);
        const Vec3f middle = face.point((o.u0 + o.u1) / 2, 0);
        if (overlap(above, {flat(middle), {(o.u1 - o.u0) / 2 + 0.15f, 0.3f}, yaw_of(face.inward), o.y0, o.y1}))
            return false;
    }
    return plan_.holds(above) && std::none_of(placed_.begin(), placed_.end(), [&](const Placed& p) {
               return !p.flat && overlap(above, footprint_of(p));
           });
}

namespace {

// The size that was said in metres, as far as such a piece goes.
Vec3f as_measured(const PieceRequest& usual, Vec3f said) {
    if (said == Vec3f{}) return {};
    constexpr float kLeast = 0.55f, kMost = 1.9f;
    const Vec3f size = make_piece(usual).size_m;
    for (std::size_t a = 0; a < 3; ++a)
        if (said[a] > 0) said[a] = std::clamp(said[a], kLeast * size[a], kMost * size[a]);
    return said;
}

}  // namespace

// What the prompt says that furniture of this kind is made of, whichever it is.
std::string Layout::accent_of(const std::string& kind) const {
    const bool seat = has_role(kind, Role::takes_accent);
    for (const std::string& m : spec_.accents) {
        if (is_one_of(m, {"rattan", "wicker", "cane"}) && has_role(kind, Role::takes_woven_accent)) return m;
        if (is_one_of(m, {"leather", "velvet"}) && seat) return m;
    }
    return {};
}

PieceRequest Layout::request(std::string kind, const PromptObject* wish, const std::string& pattern) {
    if (sample_ && wish && (wish->kind == kind || sample_->kind == kind)) {
        PieceRequest again = *sample_;
        if (!again.style) again.style = &plan_.style;
        return again;
    }
    PieceRequest r;
    r.kind = std::move(kind);
    r.style = &plan_.style;
    r.seed = rng_.next_u64();
    if (spec_.pack)
        r.model = spec_.pack->choose_users(r.kind,
                                           wish ? hash_name(spec_.text) + static_cast<std::uint64_t>(wish->id) : r.seed,
                                           wish ? wish->words : std::string{});
    if (r.model) r.pack = spec_.pack;
    if (wish && spec_.pack && !r.model)
        if ((r.model = spec_.pack->choose(r.kind, hash_name(spec_.text) + static_cast<std::uint64_t>(wish->id))))
            r.pack = spec_.pack;
    if (!r.model && !std::binary_search(piece_classes().begin(), piece_classes().end(), r.kind))
        r.kind = stand_in(r.kind).value_or(r.kind);
    if (wish && !wish->style.empty()) r.style = &style_named(wish->style);
    if (r.kind == "desk")
        for (const PromptObject& o : spec_.objects)
            if (o.kind == "monitor" && !o.forbidden && o.relation != "in the next room")
                r.screens = std::min(kMostScreens, r.screens + o.count);
    // An island is of the units' color.
    if (r.kind == "kitchen_island" && (!wish || (wish->color.empty() && wish->material.empty())))
        for (const PromptObject& o : spec_.objects)
            if (o.kind == "kitchen_counter" && !o.forbidden && !o.color.empty())
                r.color = color_named(o.color), r.color_name = o.color;
    // Nobody cooks where the washing is done.
    if (r.kind == "kitchen_counter") r.cooks = room_type(spec_.room).cooks;
    if (wish) {
        if (!wish->color.empty()) r.color = color_named(wish->color), r.color_name = wish->color;
        r.color2_name = wish->color2;
        r.material = wish->material;
        r.pattern = wish->pattern;
        r.holder_color = wish->holder_color;
        r.holder_material = wish->holder_material;
        r.back_color = wish->back_color;
        r.back_material = wish->back_material;
        r.size_factor = wish->size == "large" ? 1.15f : wish->size == "small" ? 0.87f : 1.f;
        r.size_m = as_measured(r, wish->size_m);
        // A small round table is one for two.
        if (r.kind == "dining_table_round" && wish->size == "small" && wish->size_m == Vec3f{})
            r.size_factor = 1.f, r.size_m = {0.75f, 0, 0.75f};
    }
    // An island has the worktop of the units.
    if (r.kind == "kitchen_island" && r.holder_material.empty() && r.holder_color.empty())
        for (const PromptObject& o : spec_.objects)
            if (o.kind == "kitchen_counter" && !o.forbidden)
                r.holder_material = o.holder_material, r.holder_color = o.holder_color;
    if (r.material.empty() && !r.model) r.material = accent_of(r.kind);
    if (r.pattern.empty()) r.pattern = pattern;
    vary(r);
    return r;
}

// Draws again while the form that comes out stands in the room already.
void Layout::vary(PieceRequest& r) const {
    const auto stands = [&](const std::string& form) {
        return std::any_of(placed_.begin(), placed_.end(),
                           [&](const Placed& p) { return p.piece.kind == r.kind && p.piece.form == form; });
    };
    // Only what has forms, and stands already, is made to find out which form it has.
    const int like = find(r.kind).value_or(-1);
    if (like < 0 || placed_[static_cast<std::size_t>(like)].piece.form.empty()) return;
    constexpr int kTries = 12;
    for (int tries = 0; tries < kTries && stands(make_piece(r).form); ++tries) r.seed = mix64(r.seed);
}

float Layout::as_asked(const Placed& placed, const PromptObject& wish) const {
    const std::optional<bool> holds = stands_as_asked(plan_, placed_, placed, insisted_ ? *insisted_ : wish);
    constexpr float kWorth = 5.f;  // more than all that other wishes of taste add up to
    return !holds ? 0.f : *holds ? kWorth : insisted_ ? -std::numeric_limits<float>::infinity() : 0.f;
}

std::string Layout::why_not(const std::string& kind) const {
    if (std::binary_search(piece_classes().begin(), piece_classes().end(), kind) ||
        (spec_.pack && spec_.pack->choose(kind, 0)) || stand_in(kind))
        return {};
    if (spec_.pack && spec_.pack->only_with_attribution(kind))
        return "there is only a model whose author must be named: --assets all uses it";
    return spec_.pack ? "there is no model of it"
                      : "there is no built-in model of it, and no furniture pack (sweethome3d-furniture) is in use";
}

std::optional<int> Layout::find(std::string_view kind) const {
    for (std::size_t i = 0; i < placed_.size(); ++i)
        if (placed_[i].piece.kind == kind || placed_[i].wish.kind == kind) return static_cast<int>(i);
    return {};
}

int Layout::count(std::string_view kind) const {
    return static_cast<int>(
        std::count_if(placed_.begin(), placed_.end(), [&](const Placed& p) { return p.piece.kind == kind; }));
}

}  // namespace fastscene

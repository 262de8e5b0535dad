// Free places where the layout's own search finds none: a fine grid about what the place is said by, and small shifts.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_relations.h"
#include "fastscene/rooms/validate.h"

namespace fastscene::editing {
namespace {

constexpr int kMostChecks = 200;  // of the whole room: a fraction of a second

}  // namespace

// The boxes of what a place is said by: things, or openings as thin boxes.
std::vector<Footprint> anchors_of(const Plan& plan, const std::vector<Placed>& placed, const std::string& kind) {
    std::vector<Footprint> out;
    if (kind.empty()) return out;
    for (const Placed& p : placed)
        if (p.piece.kind == kind || p.wish.kind == kind) out.push_back(footprint_of(p));
    for (const Opening& o : plan.openings) {
        if (!is_opening_of(o, kind)) continue;
        const WallFace face = plan.wall(o.wall);
        out.push_back({flat(face.point((o.u0 + o.u1) / 2, 0)),
                       {(o.u1 - o.u0) / 2, 0.01f},
                       std::atan2(face.inward.x, face.inward.z),
                       o.y0,
                       o.y1});
    }
    return out;
}

namespace {

// Backs at walls, every few centimetres along them.
void add_at_walls(const Plan& plan, Vec3f size, std::vector<Candidate>& out) {
    constexpr float kStep = 0.06f, kOffWall = 0.01f;  // metres
    for (const WallFace& face : plan.faces()) {
        const Vec2f inward = flat(face.inward);
        for (float u = size.x / 2; u <= face.length - size.x / 2; u += kStep)
            out.push_back({flat(face.point(u, 0)) + inward * (size.z / 2 + kOffWall), std::atan2(inward.x, inward.y)});
    }
}

// Everywhere on the floor, square to the room; what is as deep as wide needs but one yaw.
void add_on_floor(const Plan& plan, Vec3f size, std::optional<float> own, std::vector<Candidate>& out) {
    constexpr float kStep = 0.12f;  // metres
    const bool square = std::abs(size.x - size.z) < 0.1f * size.x;
    const float far_x = std::floor(plan.width / 2 / kStep) * kStep, far_z = std::floor(plan.depth / 2 / kStep) * kStep;
    for (float x = -far_x; x <= far_x + 1e-3f; x += kStep)
        for (float z = -far_z; z <= far_z + 1e-3f; z += kStep) {
            if (own) out.push_back({{x, z}, *own});
            // Its back to the nearer wall, its front to the room.
            const bool side = plan.width / 2 - std::abs(x) < plan.depth / 2 - std::abs(z);
            const float along_x = x > 0 ? -kPi / 2 : kPi / 2, along_z = z > 0 ? kPi : 0.f;
            out.push_back({{x, z}, side ? along_x : along_z});
            if (!square) out.push_back({{x, z}, side ? along_z : along_x});
        }
}

// Beside a bed is at its head.
float off_head(Layout& layout, Vec2f at) {
    const PromptObject& wish = layout.spec().objects[0];
    float least = 1e9f;
    for (const Placed& bed : layout.placed())
        if (is_one_of(wish.relation, {"next to", "left of", "right of", "on both sides of"}) &&
            has_role(bed.piece.kind, Role::bed) &&
            (bed.piece.kind == wish.relation_to || bed.wish.kind == wish.relation_to))
            least = std::min(least, std::max(0.f, dot(at - flat(bed.position), flat(front_of(bed.yaw)))));
    return least < 1e8f ? 0.5f * least : 0.f;
}

bool looks_at(const std::string& relation) {
    return relation == "facing" || relation == "opposite" || relation == "in front of";
}

}  // namespace

bool is_rug(const Piece& piece) {
    constexpr float kFlat = 0.03f;  // metres: higher, nobody steps on it
    return piece.size_m.y < kFlat;
}

bool is_beside(const std::vector<Placed>& all, const Placed& piece, const PromptObject& wish) {
    const bool stands = piece.piece.mount == Mount::floor || piece.piece.mount == Mount::surface;
    if (!is_one_of(wish.relation, {"left of", "right of"}) || !stands) return true;
    constexpr float kOfHalf = 0.8f, kAhead = 0.5f;  // of its width; metres before or behind it
    bool known = false;
    const bool beside = std::any_of(all.begin(), all.end(), [&](const Placed& at) {
        if (&at == &piece || (at.piece.kind != wish.relation_to && at.wish.kind != wish.relation_to)) return false;
        known = true;
        const Vec3f to = piece.position - at.position, half = at.piece.size_m * 0.5f;
        return std::abs(dot(to, right_of(at.yaw))) > kOfHalf * half.x &&
               std::abs(dot(to, front_of(at.yaw))) < half.z + kAhead;
    });
    return beside || !known;  // of a window it says nothing
}

bool is_at_foot(const std::vector<Placed>& all, const PromptObject& wish, const Placed& p) {
    constexpr float kNarrow_m = 0.7f, kOfLength = 0.05f;
    if (!p.piece.against_wall || p.piece.size_m.x > kNarrow_m) return false;
    if (!is_one_of(wish.relation, {"next to", "left of", "right of", "on both sides of"})) return false;
    return std::any_of(all.begin(), all.end(), [&](const Placed& bed) {
        return has_role(bed.piece.kind, Role::bed) && !has_role(bed.piece.kind, Role::along_wall) &&
               (bed.piece.kind == wish.relation_to || bed.wish.kind == wish.relation_to) &&
               dot(p.position - bed.position, front_of(bed.yaw)) > kOfLength * bed.piece.size_m.z;
    });
}

float off_middle(const std::vector<Placed>& all, const PromptObject& wish, Vec2f at, const Placed* own) {
    const auto is_of = [&](const Placed& p, const std::string& kind) {
        return &p != own && (p.piece.kind == kind || p.wish.kind == kind);
    };
    float least = std::numeric_limits<float>::infinity();
    for (const Placed& a : all)
        for (const Placed& b : all)
            if (&a != &b && is_of(a, wish.relation_to) && is_of(b, wish.relation_and))
                least = std::min(least, length((footprint_of(a).center + footprint_of(b).center) * 0.5f - at));
    return least;
}

int wall_behind(const Plan& plan, const Placed& p) {
    constexpr float kAtWall = 0.3f, kWalls = 4;  // metres
    const Footprint box = footprint_of(p);
    for (int w = 0; w < static_cast<int>(kWalls); ++w) {
        const WallFace face = plan.wall(w);
        const float off = dot(box.center - flat(face.origin), flat(face.inward)) - extent(box, flat(face.inward));
        if (dot(face.inward, front_of(p.yaw)) > 0.9f && off < kAtWall) return w;
    }
    return -1;
}

bool hang_above(Layout& layout, const PromptObject& wish) {
    if (wish.relation != "above" || wish.count > 1 || !layout.why_not(wish.kind).empty()) return false;
    const PieceRequest request = layout.request(wish.kind, &wish);
    if (make_piece(request).mount != Mount::ceiling) return false;
    for (int i = 0; i < static_cast<int>(layout.placed().size()); ++i) {
        const Placed below = layout.placed()[static_cast<std::size_t>(i)];
        if (below.piece.kind != wish.relation_to && below.wish.kind != wish.relation_to) continue;
        const Vec3f half = below.piece.size_m * 0.5f;
        const bool turned = half.z > half.x;
        const Vec3f along = turned ? front_of(below.yaw) * half.z : right_of(below.yaw) * half.x;
        for (const float part : {0.f, 0.3f, -0.3f, 0.5f, -0.5f, 0.7f, -0.7f})
            if (const auto k = layout.hanging(request, flat(below.position + along * part), wish))
                return layout.join(*k, i), true;
    }
    return false;
}

namespace {

// Where a thing would stand that is pushed up to another: at each of its sides, along it.
void add_at_sides(const Footprint& anchor, Vec3f size, std::vector<Candidate>& out) {
    constexpr float kStep = 0.1f;  // metres
    const auto axes = axes_of(anchor);
    for (const float gap : {0.02f, 0.08f, 0.2f})
        for (const bool beside : {true, false})
            for (const float side : {1.f, -1.f}) {
                const Vec2f out_by = axes[beside ? 0 : 1] * side, along = axes[beside ? 1 : 0];
                const float reach = beside ? anchor.half.y : anchor.half.x;
                const float off = (beside ? anchor.half.x + size.x / 2 : anchor.half.y + size.z / 2) + gap;
                for (float t = -reach; t <= reach + 1e-3f; t += kStep) {
                    const Vec2f at = anchor.center + out_by * off + along * t;
                    out.push_back({at, anchor.yaw});
                    if (!beside && side > 0) out.push_back({at, std::remainder(anchor.yaw + kPi, 2 * kPi)});
                }
            }
}

// From edge to edge.
float off_box(const Footprint& anchor, const Footprint& box) {
    const Vec2f to = anchor.center - box.center;
    const Vec2f way = length(to) > 1e-3f ? to * (1 / length(to)) : Vec2f{0, 1};
    return std::max(0.f, distance_to(anchor, box.center) - extent(box, way));
}

// How far it is from the room's nearest corner, or from that one.
float off_corner(const Plan& plan, const Footprint& box, const std::optional<Vec2f>& corner) {
    float least = 1e9f;
    for (const float x : {plan.width / 2, -plan.width / 2})
        for (const float z : {plan.depth / 2, -plan.depth / 2}) {
            if (corner && length(Vec2f{x, z} - *corner) > 1.f) continue;
            least = std::min(least, std::max(std::abs(x - box.center.x) - extent(box, {1, 0}),
                                             std::abs(z - box.center.y) - extent(box, {0, 1})));
        }
    return std::max(0.f, least);
}

}  // namespace

// Things that are larger all around, so that what is further off is at them still.
std::vector<Placed> grown(std::vector<Placed> all, const PromptObject& wish, float by) {
    for (Placed& p : all)
        for (const std::string* kind : {&wish.relation_to, &wish.relation_and})
            if (!kind->empty() && (p.piece.kind == *kind || p.wish.kind == *kind)) {
                p.piece.size_m.x += 2 * by, p.piece.size_m.z += 2 * by;
                break;
            }
    return all;
}

namespace {

constexpr float kOfCorner = 1.6f;  // metres: further off it is in another one

// A chair around a table is turned to the side at which it stands; false: it stands beyond a corner.
bool faces_side(const std::vector<Footprint>& anchors, Candidate& c, Placed& p) {
    for (const Footprint& a : anchors) {
        const auto axes = axes_of(a);
        const Vec2f to = c.at - a.center;
        const float x = dot(to, axes[0]), z = dot(to, axes[1]);
        const bool beside = std::abs(x) > a.half.x && std::abs(z) < a.half.y;
        const bool before = std::abs(z) > a.half.y && std::abs(x) < a.half.x;
        if (!beside && !before) continue;
        const Vec2f in = beside ? axes[0] * std::copysign(1.f, -x) : axes[1] * std::copysign(1.f, -z);
        c.yaw = p.yaw = std::atan2(in.x, in.y);
        return true;
    }
    return false;
}

// A chair in front of a desk is drawn up to it.
bool is_drawn_up_before(const std::vector<Placed>& all, const PromptObject& wish, const Placed& p) {
    constexpr float kReach_m = 0.35f, kOfHalf = 0.6f;
    if (wish.relation != "in front of" || !has_role(wish.kind, Role::work_seat)) return true;
    return std::none_of(all.begin(), all.end(), [&](const Placed& desk) {
        if ((desk.piece.kind != wish.relation_to && desk.wish.kind != wish.relation_to) ||
            !has_role(desk.piece.kind, Role::work_place))
            return false;
        const Vec3f to = p.position - desk.position;
        return std::abs(dot(to, right_of(desk.yaw))) > kOfHalf * desk.piece.size_m.x / 2 ||
               dot(to, front_of(desk.yaw)) > desk.piece.size_m.z / 2 + p.piece.size_m.z / 2 + kReach_m;
    });
}

}  // namespace

// The places on the floor, the best first, at which it is as was asked; up to so much further off.
std::vector<Candidate> Editor::candidates_for(Layout& layout, const EditStep& step, const Piece& piece,
                                              float further) const {
    const PromptObject& wish = layout.spec().objects[0];
    const bool flat_one = is_rug(piece);
    const bool of_corner = wish.relation == "in the corner" && step.position.has_value();
    std::vector<Candidate> all;
    const std::vector<Footprint> anchors = anchors_of(plan(), layout.placed(), wish.relation_to);
    if (piece.against_wall) add_at_walls(plan(), piece.size_m, all);
    else add_on_floor(plan(), piece.size_m, flat_one ? step.yaw : std::nullopt, all);
    if (!flat_one && noun_of(wish.relation_to).empty())
        for (const Footprint& a : anchors) add_at_sides(a, piece.size_m, all);
    const std::vector<Placed> near = further > 0 ? grown(layout.placed(), wish, further) : layout.placed();
    Placed p;
    p.piece = piece;
    p.flat = flat_one;
    std::erase_if(all, [&](Candidate& c) {
        float nearest = 1e9f;
        Vec2f middle{};
        for (const Footprint& a : anchors)
            if (const float far = distance_to(a, c.at); far < nearest) nearest = far, middle = a.center;
        if (!anchors.empty()) {
            if (looks_at(wish.relation)) c.yaw = std::atan2(middle.x - c.at.x, middle.y - c.at.y);
            c.cost = wish.relation == "between" ? off_middle(layout.placed(), wish, c.at)
                                                : nearest + off_head(layout, c.at);
        } else if (of_corner && length(c.at - *step.position) > kOfCorner + further) return true;
        else if (wish.relation == "in the middle") c.cost = length(c.at);
        else if (step.position) c.cost = length(c.at - *step.position);
        if (looks_at(wish.relation) && piece.against_wall)
            for (const WallFace& face : plan().faces())
                if (dot(flat(face.inward), middle - c.at) > 0.7f * length(middle - c.at))
                    c.yaw = std::atan2(face.inward.x, face.inward.z);
        p.position = {c.at.x, 0, c.at.y}, p.yaw = c.yaw;
        const Footprint box = footprint_of(p);
        if (!plan().holds(box) || is_at_foot(layout.placed(), wish, p)) return true;
        if (wish.relation == "around" && has_role(wish.kind, Role::seat) && !faces_side(anchors, c, p)) return true;
        if (!is_beside(layout.placed(), p, wish) || !is_drawn_up_before(layout.placed(), wish, p)) return true;
        if (step.wall >= 0 && wall_behind(plan(), p) != step.wall) return true;
        for (const Footprint& a : anchors) c.off = std::min(c.off, off_box(a, box));
        if (wish.relation == "in the corner")
            c.off = off_corner(plan(), box, step.position), c.cost += further > 0 ? c.off : 0.f;
        if (stands_as_asked(plan(), layout.placed(), p, wish).value_or(wish.relation.empty())) return false;
        if (!(further > 0)) return true;
        constexpr float kInCorner = 0.55f, kAtOpening = 0.85f;  // metres, as stands_as_asked() has them
        constexpr float kStillCorner = 0.25f;                   // of what it may be further off elsewhere
        if (wish.relation == "in the corner") return c.off > kInCorner + kStillCorner * further;
        if (wish.relation == "next to" && c.off < kAtOpening + further && !anchors.empty()) return false;
        return !stands_as_asked(plan(), near, p, wish).value_or(false);
    });
    std::stable_sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
    return all;
}

// For one thing that stands on the floor; the nearest place first.
bool Editor::search_finely(Layout& layout, const EditStep& step) const {
    const PromptObject& wish = layout.spec().objects[0];
    static constexpr std::array<std::string_view, 11> kBySearch{"next to",  "in front of",   "behind",       "left of",
                                                                "right of", "between",       "opposite",     "facing",
                                                                "against",  "in the corner", "in the middle"};
    const bool known = std::find(kBySearch.begin(), kBySearch.end(), wish.relation) != kBySearch.end();
    if (!known || wish.count > 1 || step.elsewhere || !layout.why_not(wish.kind).empty()) return false;
    const PieceRequest request = layout.request(wish.kind, &wish);
    const Piece piece = make_piece(request);
    if (piece.mount != Mount::floor) return false;
    // A chair before a table is drawn up to it, or it is not at the table.
    if (wish.relation == "in front of" && has_role(wish.kind, Role::work_seat)) return false;
    const std::vector<Candidate> all = candidates_for(layout, step, piece, 0);
    if (is_rug(piece))
        return std::any_of(all.begin(), all.end(), [&](const Candidate& c) {
            const std::size_t mark = layout.mark();
            if (!layout.lay(c.at, c.yaw, request, wish)) return false;
            // It may have been pushed off a wall.
            if (stands_as_asked(plan(), layout.placed(), layout.placed().back(), wish).value_or(false)) return true;
            layout.undo(mark);
            return false;
        });
    const std::set<std::string> before = fault_texts(layout.placed());
    int checks = 0;
    for (const bool with_clearance : {true, false})
        for (const Candidate& c : all) {
            const std::size_t mark = layout.mark();
            if (!layout.stand_at(piece, c.at, c.yaw, wish, {}, with_clearance)) continue;
            const auto now = fault_texts(layout.placed());
            if (std::includes(before.begin(), before.end(), now.begin(), now.end())) return true;
            layout.undo(mark);
            if (++checks == kMostChecks) return false;
        }
    return false;
}

// Seats at the ends of a table, drawn up to it: one at each in turn.
bool Editor::at_the_ends(Layout& layout) const {
    const PromptObject& wish = layout.spec().objects[0];
    if (wish.relation != kAtTheEnds || !layout.why_not(wish.kind).empty()) return false;
    const PieceRequest request = layout.request(wish.kind, &wish);
    const Piece piece = make_piece(request);
    int done = 0;
    for (int t = 0; t < static_cast<int>(layout.placed().size()); ++t) {
        const Placed table = layout.placed()[static_cast<std::size_t>(t)];
        if (table.piece.kind != wish.relation_to && table.wish.kind != wish.relation_to) continue;
        const bool wide = table.piece.size_m.x >= table.piece.size_m.z;
        const Vec3f along = wide ? right_of(table.yaw) : front_of(table.yaw);
        const float half = (wide ? table.piece.size_m.x : table.piece.size_m.z) / 2;
        if (piece.mount == Mount::surface) {
            const float inside = std::max(piece.size_m.x, piece.size_m.z) / 2;
            for (const float side : {1.f, -1.f})
                for (const float in : {0.04f, 0.1f, 0.16f, 0.24f, 0.32f}) {
                    if (done == std::max(1, wish.count)) return true;
                    const Vec3f at = table.position + along * (side * (half - inside - in));
                    if (!layout.on_top_at(t, request, flat(at), table.yaw, wish)) continue;
                    ++done;
                    break;
                }
            continue;
        }
        for (const float side : {1.f, -1.f})
            for (const float gap : {0.02f, 0.12f, 0.2f}) {
                if (done == std::max(1, wish.count)) return true;
                const Vec3f at = table.position + along * (side * (half + gap + piece.size_m.z / 2));
                const auto i = layout.stand_at(piece, flat(at), yaw_of(along * -side), wish, {});
                if (!i) continue;
                layout.join(*i, t);
                ++done;
                break;
            }
    }
    return done == std::max(1, wish.count);
}

// The free place nearest to the middle of a top or, turned as it is, of the room.
bool Editor::in_the_middle(Layout& layout, const EditStep& step, const Placed* moving) const {
    constexpr int kRings = 12, kWays = 12;
    const PromptObject& wish = layout.spec().objects[0];
    const bool room = wish.relation == "in the middle" && moving && moving->piece.mount == Mount::floor &&
                      !moving->flat && !moving->piece.against_wall;
    if (wish.count > 1 || !(room || (wish.relation == "on" && step.centered))) return false;
    if (!layout.why_not(wish.kind).empty()) return false;
    const PieceRequest request = layout.request(wish.kind, &wish);
    const Piece piece = make_piece(request);
    const auto around = [&](Vec2f middle, float reach, const auto& stand) {
        for (int ring = 0; ring <= kRings; ++ring)
            for (int way = 0; way < (ring == 0 ? 1 : kWays); ++way) {
                const float angle = 2 * kPi * static_cast<float>(way) / kWays;
                if (stand(middle +
                          Vec2f{std::sin(angle), std::cos(angle)} * (reach * static_cast<float>(ring) / kRings)))
                    return true;
            }
        return false;
    };
    if (room)
        return around({0, 0}, 0.6f,
                      [&](Vec2f at) { return layout.stand_at(piece, at, moving->yaw, wish, {}).has_value(); });
    for (int i = 0; i < static_cast<int>(layout.placed().size()); ++i) {
        const Placed top = layout.placed()[static_cast<std::size_t>(i)];
        if (top.piece.kind != wish.relation_to && top.wish.kind != wish.relation_to) continue;
        const float reach = 0.25f * std::min(top.piece.size_m.x, top.piece.size_m.z);
        if (around(flat(top.position), reach, [&](Vec2f at) {
                return layout.on_top_at(i, request, at, moving ? moving->yaw : top.yaw, wish).has_value();
            }))
            return true;
    }
    return false;
}

// What usually stands on tops, on the floor by a thing.
bool Editor::on_the_floor(Layout& layout, const EditStep& step) const {
    const PromptObject& wish = layout.spec().objects[0];
    if (!step.on_floor || wish.count > 1 || !layout.why_not(wish.kind).empty()) return false;
    const PieceRequest request = layout.request(wish.kind, &wish);
    constexpr int kTries = 6;
    for (const Footprint& anchor : anchors_of(plan(), layout.placed(), wish.relation_to))
        for (int k = 0; k < kTries; ++k) {
            const std::size_t before = layout.mark();
            if (!layout.on_floor_near(anchor.center, request, wish)) continue;
            if (stands_as_asked(plan(), layout.placed(), layout.placed().back(), wish).value_or(false)) return true;
            layout.undo(before);
        }
    return false;
}

// Above what stands a way off its wall, as a bar does: on the wall behind it, in sight above it.
bool Editor::hang_behind(Layout& layout) const {
    const PromptObject& wish = layout.spec().objects[0];
    if (wish.relation != "above" || wish.count > 1 || !layout.why_not(wish.kind).empty()) return false;
    PieceRequest request = layout.request(wish.kind, &wish);
    if (make_piece(request).mount != Mount::wall) return false;
    constexpr float kFarthest = 2.5f, kAbove = 0.3f;  // metres
    for (int i = 0; i < static_cast<int>(layout.placed().size()); ++i) {
        const Placed below = layout.placed()[static_cast<std::size_t>(i)];
        if (below.piece.kind != wish.relation_to && below.wish.kind != wish.relation_to) continue;
        for (int w = 0; w < 4; ++w) {
            const WallFace face = plan().wall(w);
            const Vec3f to = below.position - face.origin;
            if (dot(face.inward, front_of(below.yaw)) < 0.9f || dot(to, face.inward) > kFarthest) continue;
            for (const float scale : {1.f, 0.8f, 0.6f})
                for (const float further : {0.f, 0.2f, -0.2f, 0.4f, -0.4f, 0.7f, -0.7f}) {
                    PieceRequest r = request;
                    r.size_factor *= scale;
                    Piece piece = make_piece(r);
                    if (std::abs(further) > below.piece.size_m.x / 2) continue;
                    // Higher than what stands at that wall.
                    const float least = std::max(piece.hang_height_m, footprint_of(below).y1 + kAbove);
                    for (const float up : {0.f, 0.15f, 0.3f, 0.45f, 0.6f}) {
                        piece.hang_height_m = least + up;
                        if (layout.hang_at(piece, w, dot(to, face.along) + further, wish)) return true;
                    }
                }
        }
    }
    return false;
}

// Whether a thing with this box would reach into nothing that it does not reach into now; a first look, before all
// is checked.
bool Editor::stands_clear(int index, const Footprint& box, const std::vector<int>& along) const {
    constexpr float kTouch = 0.01f;  // metres
    if (!plan().holds(shrunk(box, kTouch))) return false;
    std::vector<int> moving{index};
    moving.insert(moving.end(), along.begin(), along.end());
    const std::vector<int> all = with_riders(moving);
    const Footprint now = footprint_of(placed(index));
    for (int i = 0; i < static_cast<int>(room_.furnished.placed.size()); ++i) {
        if (placed(i).flat || std::find(all.begin(), all.end(), i) != all.end() || i == placed(index).on) continue;
        const Footprint other = footprint_of(placed(i));
        if (overlap(shrunk(box, kTouch), shrunk(other, kTouch)) && !overlap(shrunk(now, kTouch), shrunk(other, kTouch)))
            return false;
    }
    return true;
}

}  // namespace fastscene::editing

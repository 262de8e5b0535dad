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

// A stool in front of a vanity stands close to it; what is worked at has the layout's own place for a chair.
bool sits_before_table(const PromptObject& wish) {
    return wish.relation == "in front of" && wish.count < 2 && is_sat_at(wish.relation_to) &&
           !has_role(wish.relation_to, Role::work_place) && !has_role(wish.relation_to, Role::centerpiece) &&
           has_role(wish.kind, Role::work_seat);
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
    if (wish.relation == "in front of" && has_role(wish.kind, Role::work_seat) && !sits_before_table(step.wish))
        return false;
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
    // The free floor before what one sits at is for the seat.
    const bool seat = sits_before_table(step.wish);
    for (const bool with_clearance : {true, false})
        for (const Candidate& c : all) {
            if (seat && with_clearance) break;
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

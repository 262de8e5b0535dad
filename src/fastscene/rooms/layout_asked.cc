// What was asked for: when it is placed, and how at another piece. Search where the words say is in
// layout_asked_places.cc.
#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/layout_furnisher.h"
#include "fastscene/rooms/layout_relations.h"
#include "fastscene/rooms/pack.h"

namespace fastscene::furnishing {
namespace {

bool is_before(const std::string& relation) { return is_one_of(relation, {"in front of", "at the foot of"}); }

// Two pieces must stand before what is asked to be between them can.
bool both_stand(const Layout& l, const Ask& ask) {
    const auto standing = [&](const std::string& kind) {
        return std::count_if(l.placed().begin(), l.placed().end(),
                             [&](const Placed& p) { return p.piece.kind == kind || p.wish.kind == kind; });
    };
    return ask.at == ask.and_at ? standing(ask.at) > 1 : standing(ask.at) > 0 && standing(ask.and_at) > 0;
}

}  // namespace

void Furnisher::attend(int index) {
    const std::string built = kind_of(index), asked = at(index).wish.kind;
    for (const bool small : {false, true})
        for (Ask& ask : wishes_.asks()) {
            if (ask.left <= 0 || !ask.at_piece() || stands_on_others(*ask.wish) != small) continue;
            const bool here = ask.at == built || ask.at == asked,
                       last_of_two = ask.relation == "between" && (ask.and_at == built || ask.and_at == asked);
            if (!here && !last_of_two) continue;
            if (ask.relation == "between" && !both_stand(l_, ask)) continue;
            // Several such pieces share what was asked for; around a table and between two all stand together.
            const bool together = ask.relation == "around" || ask.relation == "between";
            const int share = together ? ask.left : (ask.left + wishes_.count(ask.at)) / (1 + wishes_.count(ask.at));
            for (int i = 0; i < share && ask.left > 0; ++i) {
                --ask.left;
                if (const auto placed = at_piece(index, ask)) {
                    attend(*placed);
                    continue;
                }
                ++ask.left;
                break;
            }
        }
}

void Furnisher::summon(const std::string& kind) {
    // "a lamp next to a sofa next to the lamp": whoever waits for himself is placed anywhere.
    if (l_.find(kind) || std::find(summoned_.begin(), summoned_.end(), kind) != summoned_.end()) return;
    summoned_.push_back(kind);
    for (Ask& ask : wishes_.asks()) {
        if (ask.left <= 0 || ask.wish->kind != kind) continue;
        --ask.left;
        if (ask.at_piece()) {
            const std::string anchor = ask.at;
            ++ask.left;
            summon(anchor);
            if (l_.find(kind)) return;
            --ask.left;
        }
        if (const auto i = anywhere(*ask.wish)) return attend(*i);
        ++ask.left;
    }
}

// The floor and the wall that wait for what was asked for at a piece of this class.
Spare Furnisher::spare_for(const std::string& kind) {
    Spare spare;
    for (const Ask& ask : wishes_.asks()) {
        if (ask.left <= 0 || ask.at != kind || !ask.at_piece()) continue;
        if (!l_.why_not(ask.wish->kind).empty()) continue;
        const Piece piece = make_piece(l_.request(ask.wish->kind, ask.wish));
        const bool floor = piece.mount == Mount::floor && ask.wish->kind != "rug";
        const float wide = piece.size_m.x + 0.12f, deep = piece.size_m.z;
        const int each = (ask.left + wishes_.count(kind)) / (1 + wishes_.count(kind));
        if (ask.relation == "above" && piece.mount != Mount::ceiling) spare.above = true;
        if (is_beside(ask.relation) && piece.mount != Mount::ceiling) {
            // Small things stand on a small table there.
            const float width = floor || piece.mount == Mount::wall ? wide : 0.6f;
            if (ask.relation != "left of") spare.right = std::max(spare.right, width);
            if (ask.relation == "left of" || each > 1) spare.left = std::max(spare.left, width);
        }
        if (!floor) continue;
        if (is_before(ask.relation)) spare.front = std::max(spare.front, deep + 0.1f);
        if (ask.relation == "behind") spare.behind = std::max(spare.behind, deep + 0.06f);
    }
    return spare;
}

std::optional<int> Furnisher::at_piece(int anchor, const Ask& ask) {
    if (!l_.why_not(ask.wish->kind).empty() || is_blind(ask.wish->kind)) return {};
    const PieceRequest r = l_.request(ask.wish->kind, ask.wish);
    const Piece piece = make_piece(r);
    std::optional<int> i;
    if (ask.wish->in_row && ask.wish->kind != "monitor")
        i = next_in_row(*ask.wish, r);  // monitors stand in a row as it is
    if (i) return i;
    if (ask.wish->kind == "rug") i = rug_at(anchor, ask, r);
    else if (ask.wish->kind == "wall_lamp" && is_beside(ask.relation)) i = wall_lamp_at(anchor, r, *ask.wish);
    else if (ask.relation == "at the foot of" && has_role(kind_of(anchor), Role::bed) && lies_on_seats(ask.wish->kind))
        i = at_the_foot(anchor, r, *ask.wish);
    else if (ask.relation == "on") i = on_piece(anchor, ask, r);
    else if (ask.relation == "above") i = above_piece(anchor, ask, r, piece);
    else if (ask.relation == "under") i = under_piece(anchor, ask, r, piece);
    else if (piece.mount == Mount::floor) {
        if (is_before(ask.relation)) i = before_piece(anchor, ask, r);
        if (ask.relation == "behind") i = l_.behind(anchor, r, *ask.wish);
        if (ask.relation == "around")
            i = l_.around(anchor, r, 1, *ask.wish) ? std::optional(static_cast<int>(l_.placed().size()) - 1)
                                                   : std::nullopt;
        if (is_beside(ask.relation)) i = next_to_piece(anchor, ask, r);
        if (ask.relation == "facing" && !piece.against_wall) {
            const Insisting insisting(l_, *ask.wish);
            i = l_.angled_towards(flat(at(anchor).position), r, *ask.wish);
        }
    }
    if (i) return i;
    // Only what says so itself can be searched for.
    if (ask.wish->relation.empty()) return {};
    if (piece.mount == Mount::surface && ask.relation != "on" && ask.wish->kind != "tv")
        return on_a_top_there(*ask.wish, r, anchor);
    return where_asked(*ask.wish, r, piece);
}

std::optional<int> Furnisher::on_piece(int anchor, const Ask& ask, const PieceRequest& r) {
    if (ask.wish->kind == "monitor" && kind_of(anchor) == "desk") return next_screen(l_, anchor, r, *ask.wish);
    // A dog on the rug lies within it.
    if (kind_of(anchor) == "rug" && lies_on_seats(ask.wish->kind))
        for (int tries = 0; tries < 8; ++tries) {
            const std::size_t before = l_.mark();
            const Vec2f spread{0.3f * size(anchor).x, 0.3f * size(anchor).z};
            const Vec2f there = flat(at(anchor).position +
                                     right_of(at(anchor).yaw) * l_.rng().uniform(-spread.x, spread.x) +
                                     front_of(at(anchor).yaw) * l_.rng().uniform(-spread.y, spread.y));
            if (const auto i = l_.on_floor_near(there, r, *ask.wish)) {
                if (stands_as_asked(l_.plan(), l_.placed(), at(*i), *ask.wish).value_or(false)) return i;
                l_.undo(before);
            }
        }
    for (const float size : {1.f, 0.85f, 0.7f}) {
        PieceRequest smaller = r;
        // What stands on a table is a plant in a small pot.
        if (!smaller.model) smaller.kind = small_form_of(r.kind);
        // On a bathtub's rim they stand one by one.
        if (!smaller.model && r.kind == "candle" && kind_of(anchor) == "bathtub") smaller.size_m.x = 0.06f;
        smaller.size_factor *= size;
        if (const auto i = l_.on_top(anchor, smaller, *ask.wish)) return i;
    }
    return {};
}

// "A blanket at the foot of the bed" lies on it there, across.
std::optional<int> Furnisher::at_the_foot(int anchor, const PieceRequest& r, const PromptObject& wish) {
    const Placed bed = at(anchor);
    const bool along = has_role(bed.piece.kind, Role::along_wall);
    const float half = 0.5f * (along ? bed.piece.size_m.x : bed.piece.size_m.z);
    for (const float from_end : {0.5f, 0.62f, 0.42f, 0.75f})
        for (const float side : {1.f, -1.f}) {
            if (!along && side < 0) continue;
            const Vec3f way = along ? right_of(bed.yaw) * side : front_of(bed.yaw);
            if (const auto i = l_.on_top_at(anchor, r, flat(bed.position + way * (half - from_end)),
                                            bed.yaw + (along ? 0.5f * kPi : 0.f), wish))
                return i;
        }
    return l_.on_top(anchor, r, wish);
}

std::optional<int> Furnisher::above_piece(int anchor, const Ask& ask, const PieceRequest& r, const Piece& piece) {
    if (piece.mount == Mount::ceiling) {
        // Several hang in a row along it.
        const Vec2f middle = flat(at(anchor).position), along = flat(right_of(at(anchor).yaw));
        const float step = std::max(0.45f, piece.size_m.x + 0.1f);
        const bool several = ask.wish->count > 1;
        const std::vector<float> places = several ? std::vector<float>{-0.5f, 0.5f, -1.5f, 1.5f, 0.f}
                                                  : std::vector<float>{0.f, 0.5f, -0.5f};
        for (const float k : places)
            if (std::abs(k * step) < size(anchor).x / 2)
                if (const auto i = l_.hanging(r, middle + along * (k * step), *ask.wish)) return l_.join(*i, anchor), i;
        return {};
    }
    // All of a row fit above it.
    const float each = ask.wish->in_row ? size(anchor).x / static_cast<float>(ask.wish->count) - kInRow : 1e9f;
    for (const float size : {1.f, 0.82f, 0.66f, 0.5f, 0.4f}) {
        PieceRequest smaller = r;
        smaller.size_factor *= size;
        if (size * piece.size_m.x > each && size > 0.4f) continue;
        if (const auto i = l_.on_wall(smaller, anchor, *ask.wish)) return i;
    }
    return piece.mount == Mount::surface ? l_.on_top(anchor, r, *ask.wish) : std::nullopt;
}

std::optional<int> Furnisher::under_piece(int anchor, const Ask& ask, const PieceRequest& r, const Piece& piece) {
    // Below what hangs on a wall: at that wall.
    if (at(anchor).piece.mount == Mount::wall && piece.mount == Mount::floor)
        return l_.against_wall(r, {.near = flat(at(anchor).position), .at_most_from_near = 0.6f}, *ask.wish);
    if (piece.mount == Mount::wall || piece.mount == Mount::ceiling) return {};
    for (const float size : {1.f, 0.85f, 0.7f}) {
        PieceRequest smaller = r;
        smaller.size_factor *= size;
        if (const auto i = l_.below(anchor, smaller, *ask.wish)) return i;
    }
    return {};
}

std::optional<int> Furnisher::before_piece(int anchor, const Ask& ask, const PieceRequest& r) {
    const std::string& kind = ask.wish->kind;
    const std::string& whose = kind_of(anchor);
    const bool seat = has_role(kind, Role::sits_before);
    const bool seat_at_work = has_role(kind, Role::work_seat) && has_role(whose, Role::work_place);
    const bool pair = seat && ask.wish->count > 1;  // side by side
    if (!pair && has_role(kind, Role::drawn_up) && !has_role(whose, Role::bed) && !has_role(whose, Role::sofa)) {
        // Drawn up to the fire, turned to it.
        const Insisting insisting(l_, *ask.wish);
        if (const auto i = l_.angled_towards(front_point(anchor, 0.f), r, *ask.wish)) return i;
    }
    const float gap = seat_at_work ? (kind == "office_chair" ? -0.2f : 0.05f)
                      : has_role(whose, Role::bed) && !has_role(whose, Role::along_wall) ? 0.06f
                      : kind == "coffee_table"                                           ? 0.42f
                      : seat                                                             ? 0.9f
                                                                                         : 0.35f;
    const float aside = !pair ? 0.f : ask.left % 2 == 0 ? 0.55f : -0.55f;
    for (const float g : {gap, std::max(gap, 0.05f), 0.6f, 1.f})
        if (const auto i = l_.in_front_of(anchor, r, g, seat && !has_role(whose, Role::bed), *ask.wish, aside))
            return i;
    return {};
}

std::optional<int> Furnisher::next_to_piece(int anchor, const Ask& ask, const PieceRequest& r) {
    // A pair stands on both sides: the side with nothing of its kind first.
    int sides[2] = {1, -1};
    if (ask.relation == "left of") sides[0] = sides[1] = -1;
    else if (ask.relation == "right of") sides[0] = sides[1] = 1;
    else {
        const auto axes = axes_of(footprint_of(at(anchor)));
        const Vec2f middle = flat(at(anchor).position);
        float right = 0;
        for (const Placed& p : l_.placed())
            if (p.wish.id == ask.wish->id && p.with == anchor)
                right += dot(flat(p.position) - middle, axes[0]) > 0 ? 1.f : -1.f;
        if (right > 0) sides[0] = -1, sides[1] = 1;
    }
    for (const int side : sides)
        if (const auto i = l_.beside(anchor, r, side, 0.06f, *ask.wish)) return i;
    return {};
}

std::optional<int> Furnisher::rug_at(int anchor, const Ask& ask, const PieceRequest& r) {
    const Vec3f s = size(anchor);
    const std::string& whose = kind_of(anchor);
    const bool along = has_role(whose, Role::along_wall), bed = has_role(whose, Role::bed) && !along,
               seat = has_role(whose, Role::rug_before);
    if (ask.relation == "between") {
        const Placed* other = nullptr;
        for (const Placed& p : l_.placed())
            if (&p != &at(anchor) && (p.wish.kind == ask.at || p.wish.kind == ask.and_at || p.piece.kind == ask.at))
                other = &p;
        if (!other) return {};
        PieceRequest sized = r;
        const Vec2f apart = flat(other->position - at(anchor).position);
        for (const float wide : {1.2f, 0.8f, 0.55f}) {
            sized.size_m = {wide, 0, 1.5f * wide};
            if (const auto i = l_.lay(flat(at(anchor).position) + apart * 0.5f, at(anchor).yaw, sized, *ask.wish))
                return i;
        }
        return {};
    }
    if (ask.relation == "under" || ask.relation == "on" || ask.relation == "around") {
        if (bed) return laid_under(anchor, r, {s.x + 1.1f, 1.9f}, 0.75f, *ask.wish);
        if (along) return laid_under(anchor, r, {s.x - 0.2f, 1.4f}, s.z / 2 + 0.75f, *ask.wish);
        if (seat) return laid_under(anchor, r, {s.x + 0.5f, 1.9f}, s.z / 2 + 0.35f, *ask.wish);
        return laid_under(anchor, r, {s.x + (s.x > 1.4f ? 1.3f : 1.f), s.z + (s.x > 1.4f ? 1.3f : 1.1f)}, 0, *ask.wish);
    }
    if (is_beside(ask.relation)) {
        const float side = ask.relation == "left of" ? -1.f : 1.f;
        PieceRequest sized = r;
        sized.size_m = {0.8f, 0, 1.4f};
        for (const float k : {side, is_one_of(ask.relation, {"next to", "on both sides of"}) ? -side : side})
            if (const auto i = l_.lay(flat(at(anchor).position + right_of(at(anchor).yaw) * (k * (s.x / 2 + 0.5f))),
                                      at(anchor).yaw, sized, *ask.wish))
                return l_.join(*i, anchor), i;
    }
    return laid_under(anchor, r, {std::max(1.4f, s.x), 1.1f}, s.z / 2 + 0.62f, *ask.wish);
}

// Our own small pieces by their class, those of the pack by how they are mounted.
bool Furnisher::stands_on_others(const PromptObject& wish) const {
    if (is_small(wish.kind)) return true;
    const PackModel* model = l_.spec().pack ? l_.spec().pack->choose(wish.kind, 0) : nullptr;
    return (model && model->elevation_m + model->size_m.y < 0.8f && model->size_m.x < 0.55f) ||
           is_small(stand_in(wish.kind).value_or(""));
}

void Furnisher::asked_in_the_shell() {
    for (const bool small : {false, true})
        for (Ask& ask : wishes_.asks()) {
            if (!ask.at_shell() || ask.wish->kind == "curtain" || is_blind(ask.wish->kind) ||
                stands_on_others(*ask.wish) != small)
                continue;
            while (ask.left > 0) {
                --ask.left;
                if (const auto i = in_shell(ask)) {
                    attend(*i);
                    continue;
                }
                ++ask.left;
                break;
            }
        }
}

// What no group has used. What finds no place where it was asked for stands elsewhere.
void Furnisher::remaining_wishes(bool small) {
    for (Ask& ask : wishes_.asks()) {
        const std::string& kind = ask.wish->kind;
        if (small || ask.left <= 0 || !(kind == "curtain" || is_blind(kind))) continue;
        ask.left = 0;
        const PieceRequest r = l_.request(kind, ask.wish);
        const int hung = is_blind(kind) ? l_.in_windows(r, *ask.wish) : l_.at_windows(r, *ask.wish);
        if (hung == 0) l_.spec().not_placed.push_back(ask.wish->words + ": no window has room for them");
    }
    for (const bool bound : {false, true})
        for (Ask& ask : wishes_.asks()) {
            if (stands_on_others(*ask.wish) != small || ask.at_piece() != bound) continue;
            while (ask.left > 0) {
                --ask.left;
                if (const std::string why = l_.why_not(ask.wish->kind); !why.empty())
                    l_.spec().not_placed.push_back(ask.wish->words + ": " + why);
                else if (const auto i = anywhere(*ask.wish)) attend(*i);
                else l_.spec().not_placed.push_back(ask.wish->words + ": no free place for it");
            }
        }
}

}  // namespace fastscene::furnishing

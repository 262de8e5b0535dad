// What stands on the floor: at walls, before, beside and around other pieces, free.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fastscene/rooms/layout.h"
#include "fastscene/rooms/catalogue.h"

namespace fastscene {
namespace {

constexpr float kWallGap = 0.015f;

}  // namespace

float Layout::worth(const Placed& placed, const PromptObject& from, float score, float best) const {
    constexpr float kCutsOff = 2.f;  // what was asked for stands rather where all of the floor can be walked on
    const float total = score + as_asked(placed, from);
    if (!(total > best)) return total;
    if (!leaves_way(placed, from)) return -std::numeric_limits<float>::infinity();
    return !from.kind.empty() && ways_.open() && ways_.cuts_off(placed) ? total - kCutsOff : total;
}

std::optional<int> Layout::against_wall(const PieceRequest& request, const WallWish& wish, const PromptObject& from) {
    Placed p;
    p.piece = make_piece(request);
    const Vec3f size = p.piece.size_m;
    // Panelling and its rail stand proud of the wall; so does the sill of a window that the piece reaches up to.
    const float gap = plan_.panelling ? kPanelling + 0.005f : kWallGap;
    const auto gap_at = [&](const WallFace& face, float u) {
        const bool at_sill = std::any_of(plan_.openings.begin(), plan_.openings.end(), [&](const Opening& o) {
            const float left = face.from + u - size.x / 2, right = left + size.x;
            return o.kind == Opening::Kind::window && o.wall == face.wall && size.y > o.y0 - kSillThickness &&
                   right > o.u0 - kSillBeside && left < o.u1 + kSillBeside;
        });
        return at_sill ? std::max(gap, kSillReach + 0.005f) : gap;
    };
    const Spare& want = wish.spare;
    const bool spares = want.above || want.left > 0 || want.right > 0 || want.front > 0 || want.behind > 0;
    struct Strictness {
        bool spare, clearance;
    };
    for (const Strictness must : {Strictness{true, true}, {true, false}, {false, true}, {false, false}}) {
        if ((must.spare && !spares) || (wish.needs_spare && !must.spare)) continue;
        const float off_wall = must.spare ? want.behind : 0.f;
        std::optional<Placed> best;
        float best_score = -std::numeric_limits<float>::infinity();
        for (const WallFace& face : faces_) {
            if (p.piece.mount == Mount::wall && !hangs_at(face)) continue;
            // A wall is also what stands before it: the chimney breast, the side of an L's corner.
            if (wish.wall >= 0 && dot(face.inward, plan_.wall(wish.wall).inward) < 0.99f) continue;
            p.yaw = yaw_of(face.inward);
            for (float u = size.x / 2 + gap; u <= face.length - size.x / 2 - gap; u += kSlotStep) {
                p.position = face.point(u, 0) + face.inward * (size.z / 2 + gap_at(face, u) + off_wall);
                if (p.piece.mount == Mount::wall)
                    p.position = face.point(u, p.piece.hang_height_m +
                                                   plan_.floor_before(face, u - size.x / 2, u + size.x / 2)) +
                                 face.inward * kWallGap;
                ground(p);
                if (!fits(p, must.clearance) || (must.spare && !has_spare(p, want))) continue;
                if (p.piece.mount == Mount::wall &&
                    !wall_is_free(plan_, face, u - size.x / 2, u + size.x / 2, p.position.y, p.position.y + size.y))
                    continue;
                if (wish.clear_of_windows &&
                    std::any_of(plan_.openings.begin(), plan_.openings.end(), [&](const Opening& o) {
                        return o.wall == face.wall && o.kind == Opening::Kind::window &&
                               face.from + u + size.x / 2 > o.u0 && face.from + u - size.x / 2 < o.u1;
                    }))
                    continue;
                const float off = std::abs(u - face.length / 2) / (face.length / 2),
                            edge = std::min(u - size.x / 2, face.length - u - size.x / 2);
                float score = -wish.center_pull * off + 0.02f * rng_.uniform();
                if (wish.corner) score += 2.f - edge;
                if (wish.near) score -= 0.8f * length(flat(p.position) - *wish.near);
                if (wish.near && length(flat(p.position) - *wish.near) > wish.at_most_from_near) continue;
                if (wish.apart_pull > 0) {
                    float apart = 2.f;
                    for (const Placed& other : placed_)
                        if (other.on < 0 && !other.flat && !other.overhead)
                            apart = std::min(apart, distance_to(footprint_of(other), flat(p.position)));
                    score += wish.apart_pull * apart;
                }
                score -= face.behind;                // nearer to the wall itself
                if (face.wall == 2) score -= 0.25f;  // the wall with the door is the last choice
                for (const Opening& o : plan_.openings)
                    if (o.kind == Opening::Kind::window && o.wall == face.wall) {
                        const float apart = std::max(
                            0.f, std::abs(face.from + u - (o.u0 + o.u1) / 2) - (o.u1 - o.u0) / 2 - size.x / 2);
                        score += wish.window_pull * std::max(0.f, 1.f - apart);
                    }
                if (const float total = worth(p, from, score, best_score); total > best_score)
                    best_score = total, best = p;
            }
        }
        if (best) return keep(*best, from);
    }
    return {};
}

std::optional<int> Layout::in_front_of(int anchor, const PieceRequest& request, float gap, bool facing,
                                       const PromptObject& from, float aside) {
    const Placed& a = placed_[static_cast<std::size_t>(anchor)];
    Placed p;
    p.piece = make_piece(request);
    p.yaw = facing ? a.yaw + kPi : a.yaw;
    const Vec3f front = front_of(a.yaw), right = right_of(a.yaw);
    for (const float extra : {0.f, 0.1f, -0.1f, 0.25f})
        for (const float further : {0.f, 0.15f, -0.15f, 0.35f, -0.35f, 0.6f, -0.6f}) {
            const float side = aside + further;
            if (std::abs(side) > a.piece.size_m.x / 2 + 0.2f) continue;
            p.position = a.position + front * (a.piece.size_m.z / 2 + gap + extra + p.piece.size_m.z / 2) +
                         right * side;
            p.position.y = 0;
            p.with = anchor;
            ground(p);
            if (fits(p, false) && leaves_way(p, from)) return keep(p, from);
        }
    return {};
}

std::optional<int> Layout::beside(int anchor, const PieceRequest& request, int side, float gap,
                                  const PromptObject& from) {
    const Placed& a = placed_[static_cast<std::size_t>(anchor)];
    Placed p;
    p.piece = make_piece(request);
    p.yaw = a.yaw;
    const Vec3f front = front_of(a.yaw), right = right_of(a.yaw);
    for (const float extra : {0.f, 0.06f, 0.15f}) {
        // Backs in line.
        p.position = a.position +
                     right * (static_cast<float>(side) * (a.piece.size_m.x / 2 + p.piece.size_m.x / 2 + gap + extra)) +
                     front * ((p.piece.size_m.z - a.piece.size_m.z) / 2);
        p.position.y = 0;
        p.with = anchor;
        ground(p);
        // Beside a fire before its chimney breast: back to the wall, where there is one.
        constexpr float kBack = 0.05f, kDeepest = 0.5f;
        for (Placed back = p;
             p.piece.against_wall && length(back.position - a.position) < length(p.position - a.position) + kDeepest;) {
            back.position -= front * kBack;
            if (!fits(back, false)) break;
            p = back;
        }
        if (fits(p, false) && leaves_way(p, from)) return keep(p, from);
    }
    return {};
}

std::optional<int> Layout::in_line(int anchor, const PieceRequest& request, int side, const PromptObject& from) {
    const Placed a = placed_[static_cast<std::size_t>(anchor)];
    PieceRequest alike = request;
    if (a.piece.mount == Mount::wall) alike.size_factor = 1.f, alike.size_m = {a.piece.size_m.x, a.piece.size_m.y, 0};
    Placed p;
    p.piece = make_piece(alike);
    if (p.piece.mount != a.piece.mount || a.flat) return {};
    p.yaw = a.yaw, p.on = a.on, p.below = a.below, p.overhead = a.overhead;
    for (const float gap : {kInRow, 0.04f, 0.25f}) {
        p.position = a.position +
                     right_of(a.yaw) * (static_cast<float>(side) * (a.piece.size_m.x / 2 + p.piece.size_m.x / 2 + gap));
        p.with = a.with >= 0 ? a.with : anchor;
        const Footprint box = footprint_of(p);
        bool fine = plan_.holds(box) && leaves_way(p, from);
        if (p.on >= 0) {
            const auto& tops = placed_[static_cast<std::size_t>(p.on)].piece.surfaces;
            const Footprint top = footprint_of(placed_[static_cast<std::size_t>(p.on)]);
            for (const Vec2f corner : corners_of(box)) fine = fine && distance_to(top, corner) <= 0.005f;
            fine = fine && !tops.empty() && free_on_top(p);
        } else if (p.piece.mount == Mount::wall) {
            fine = fine && hangs_on_wall(plan_, faces_, p) &&
                   std::none_of(placed_.begin(), placed_.end(),
                                [&](const Placed& other) { return overlap(box, footprint_of(other)); });
        } else if (p.piece.mount == Mount::ceiling) {
            fine = fine && std::none_of(placed_.begin(), placed_.end(), [&](const Placed& other) {
                       return !other.flat && overlap(box, footprint_of(other));
                   });
        } else {
            fine = fine && fits(p, false);
        }
        if (fine && std::isfinite(as_asked(p, from))) return keep(p, from);
    }
    return {};
}

std::optional<int> Layout::behind(int anchor, const PieceRequest& request, const PromptObject& from) {
    const Placed& a = placed_[static_cast<std::size_t>(anchor)];
    Placed p;
    p.piece = make_piece(request);
    p.yaw = a.yaw;
    p.with = anchor;
    const Vec3f front = front_of(a.yaw), right = right_of(a.yaw);
    // Near an end it is seen best.
    const float end = std::max(0.f, (a.piece.size_m.x - p.piece.size_m.x) / 2);
    for (const float gap : {0.04f, 0.12f, 0.3f, 0.01f})
        for (const float side : {0.8f, -0.8f, 0.4f, -0.4f, 0.f, 1.f, -1.f}) {
            p.position = a.position - front * (a.piece.size_m.z / 2 + gap + p.piece.size_m.z / 2) +
                         right * (side * end);
            p.position.y = 0;
            ground(p);
            if (fits(p, false) && leaves_way(p, from)) return keep(p, from);
        }
    return {};
}

std::optional<int> Layout::below(int anchor, const PieceRequest& request, const PromptObject& from) {
    const Placed& a = placed_[static_cast<std::size_t>(anchor)];
    constexpr float kTop = 0.07f, kLegs = 0.1f;  // how thick a top is with what holds it; how far in legs stand
    Placed p;
    p.piece = make_piece(request);
    p.with = p.below = anchor;
    for (const float turn : {0.f, kPi / 2}) {
        const Vec3f s = p.piece.size_m;
        const float wide = turn == 0.f ? s.x : s.z, deep = turn == 0.f ? s.z : s.x;
        if (a.piece.surfaces.empty() || s.y > a.piece.surfaces.front().center.y - kTop ||
            wide > a.piece.size_m.x - 2 * kLegs || deep > a.piece.size_m.z - 0.02f)
            continue;
        p.yaw = a.yaw + turn;
        for (const float side : {0.f, 0.6f, -0.6f}) {
            const float slack = (a.piece.size_m.x - 2 * kLegs - wide) / 2;
            // Below a bed near its front, away from the ladder at its foot.
            const bool bed = has_role(a.piece.kind, Role::bed);
            p.position = a.position + right_of(a.yaw) * ((bed ? side - 0.6f : side) * slack);
            if (bed) p.position += front_of(a.yaw) * std::max(0.f, (a.piece.size_m.z - deep) / 2 - kInsideBed);
            p.position.y = 0;
            ground(p);
            const Footprint box = footprint_of(p);
            const bool free = std::none_of(placed_.begin(), placed_.end(), [&](const Placed& other) {
                return !other.flat && &other != &a && overlap(box, footprint_of(other));
            });
            if (free && plan_.holds(box)) return keep(p, from);
        }
    }
    return {};
}

std::optional<int> Layout::free_standing(const PieceRequest& request, const PromptObject& from, const Spare& spare) {
    Placed p;
    p.piece = make_piece(request);
    std::optional<Placed> best;
    float best_score = -std::numeric_limits<float>::infinity();
    for (const float yaw : {0.f, kPi / 2, kPi, -kPi / 2})
        for (float x = -plan_.width / 2; x < plan_.width / 2; x += 0.2f)
            for (float z = -plan_.depth / 2; z < plan_.depth / 2; z += 0.2f) {
                p.position = {x, 0, z};
                p.yaw = yaw;
                ground(p);
                if (!fits(p, false)) continue;
                Footprint wide = footprint_of(p, 0.5f);
                float score = -0.3f * std::hypot(x, z - 0.3f) + 0.02f * rng_.uniform() +
                              (has_spare(p, spare) ? 1.f : 0.f);
                for (const Placed& other : placed_)
                    if (!other.flat && !other.overhead && other.on < 0 && overlap(wide, footprint_of(other)))
                        score -= 0.5f;
                if (const float total = worth(p, from, score, best_score); total > best_score)
                    best_score = total, best = p;
            }
    return best ? keep(*best, from) : std::nullopt;
}

std::optional<int> Layout::stand_at(const Piece& piece, Vec2f at, float yaw, const PromptObject& from,
                                    const Spare& spare, bool with_clearance) {
    Placed p;
    p.piece = piece;
    p.position = {at.x, 0, at.y};
    p.yaw = yaw;
    p.fixed = true;
    ground(p);
    if (!fits(p, with_clearance) || !has_spare(p, spare) || !leaves_way(p, from)) return {};
    return keep(std::move(p), from);
}

std::optional<Placed> Layout::hung(const Piece& piece, const WallFace& face, float u) const {
    constexpr float kOffWall = 0.004f, kBelowCeiling = 0.2f;
    Placed p;
    p.piece = piece;
    p.yaw = yaw_of(face.inward);
    p.fixed = true;
    const float floor = plan_.floor_before(face, u - piece.size_m.x / 2, u + piece.size_m.x / 2),
                y = std::min(floor + piece.hang_height_m, plan_.wall_top() - kBelowCeiling - piece.size_m.y);
    p.position = face.point(u, y) + face.inward * kOffWall;
    const Footprint box = footprint_of(p);
    if (y < 0.f || !plan_.holds(box) || !hangs_on_wall(plan_, faces_, p) || !leaves_way(p)) return {};
    for (const Placed& other : placed_)
        if (!other.flat && (overlap(box, footprint_of(other)) || hides(other, p))) return {};
    return p;
}

std::optional<int> Layout::hang_at(const Piece& piece, int wall, float u, const PromptObject& from) {
    return hang_on(piece, plan_.wall(wall), u, from);
}

std::optional<int> Layout::hang_on(const Piece& piece, const WallFace& face, float u, const PromptObject& from) {
    std::optional<Placed> p = hung(piece, face, u);
    return p ? keep(std::move(*p), from) : std::nullopt;
}

std::optional<int> Layout::angled_towards(Vec2f target, const PieceRequest& request, const PromptObject& from) {
    Placed p;
    p.piece = make_piece(request);
    std::optional<Placed> best;
    float best_score = -std::numeric_limits<float>::infinity();
    for (float x = -plan_.width / 2 + 0.4f; x < plan_.width / 2 - 0.3f; x += 0.12f)
        for (float z = -plan_.depth / 2 + 0.4f; z < plan_.depth / 2 - 0.3f; z += 0.12f) {
            const Vec2f to = target - Vec2f{x, z};
            const float far = length(to);
            if (!(far > 1.1f && far < 3.2f)) continue;
            p.position = {x, 0, z};
            // Turned towards the target by steps of 15 degrees.
            p.yaw = std::round(std::atan2(to.x, to.y) / (kPi / 12)) * (kPi / 12);
            ground(p);
            if (!fits(p, false)) continue;
            const float wall = plan_.wall_distance({x, z});
            const float score = -std::abs(far - 1.8f) - 0.6f * wall + 0.05f * rng_.uniform();
            if (const float total = worth(p, from, score, best_score); total > best_score) best_score = total, best = p;
        }
    return best ? keep(*best, from) : std::nullopt;
}

int Layout::around(int table, const PieceRequest& request, int count, const PromptObject& from) {
    const Placed a = placed_[static_cast<std::size_t>(table)];
    const float w = a.piece.size_m.x, d = a.piece.size_m.z;
    // Along the long sides first, then the heads.
    struct Seat {
        float x, z, yaw;
    };
    std::vector<Seat> seats;
    // At a bar one sits on one side; around a table on both.
    const bool bar = a.piece.kind == "kitchen_island" && from.relation != "around";
    const int along = std::max(1, static_cast<int>(w / (bar ? 0.5f : 0.62f)));
    for (int i = 0; i < (bar ? 2 : 1) * along; ++i) {
        const float x = (static_cast<float>(i % along) + 0.5f) / static_cast<float>(along) * w - w / 2;
        if (!bar || i < along) seats.push_back({x, bar ? -d / 2 : d / 2, bar ? 0 : kPi});
        if (!bar || i >= along) seats.push_back({x, bar ? d / 2 : -d / 2, bar ? kPi : 0});
    }
    seats.push_back({w / 2, 0, -kPi / 2});
    seats.push_back({-w / 2, 0, kPi / 2});
    int placed = 0;
    for (const Seat& seat : seats) {
        if (placed >= count) break;
        PieceRequest r = request;
        r.seed = request.seed;  // chairs of one table are alike
        Placed p;
        p.piece = make_piece(r);
        const Vec3f front = front_of(a.yaw), right = right_of(a.yaw);
        // A chair is pushed in by a third of its depth, where the table lets it.
        const Vec3f out = normalize(right * (seat.yaw == kPi || seat.yaw == 0 ? 0.f : seat.x) +
                                    front * (seat.yaw == kPi || seat.yaw == 0 ? seat.z : 0.f));
        p.yaw = a.yaw + seat.yaw;
        for (const float pull : {0.02f, 0.12f}) {
            p.position = a.position + right * seat.x + front * seat.z + out * (p.piece.size_m.z / 2 + pull);
            p.position.y = 0;
            p.with = table;
            ground(p);
            if (fits(p, false) && leaves_way(p, from)) {
                keep(p, from);
                ++placed;
                break;
            }
        }
    }
    return placed;
}

std::optional<int> Layout::under(int anchor, const PieceRequest& request, float shift, const PromptObject& from) {
    const Placed& a = placed_[static_cast<std::size_t>(anchor)];
    const auto i = lay(flat(a.position + front_of(a.yaw) * shift), a.yaw, request, from);
    if (i) join(*i, anchor);
    return i;
}

std::optional<int> Layout::lay(Vec2f at, float yaw, const PieceRequest& request, const PromptObject& from) {
    Placed p;
    p.piece = make_piece(request);
    p.flat = true;
    p.yaw = yaw;
    p.position = {at.x, 0, at.y};
    // Into the room, not into the wall.
    Footprint f = footprint_of(p);
    const float over_x = std::abs(f.center.x) + extent(f, {1, 0}) - plan_.width / 2 + 0.12f,
                over_z = std::abs(f.center.y) + extent(f, {0, 1}) - plan_.depth / 2 + 0.12f;
    if (over_x > 0) p.position.x -= std::copysign(over_x, p.position.x);
    if (over_z > 0) p.position.z -= std::copysign(over_z, p.position.z);
    ground(p);
    if (!plan_.holds(footprint_of(p)) || !stands_level(plan_, p)) return {};
    for (const Placed& other : placed_)
        if (other.flat && overlap(footprint_of(p), footprint_of(other))) return {};
    return keep(p, from);
}

}  // namespace fastscene

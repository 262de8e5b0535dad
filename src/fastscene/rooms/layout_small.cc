// What stands on tops and hangs on walls.
#include <algorithm>
#include <cmath>
#include <limits>

#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/layout_parts.h"
#include "fastscene/rooms/layout_relations.h"
#include "fastscene/rooms/shapes.h"

namespace fastscene {

void mount_as(Piece& piece, Mount mount) {
    const float half = piece.size_m.z / 2;
    if (mount == Mount::surface && piece.mount == Mount::wall)
        for (Mesh& m : piece.meshes) shapes::move(m, {0, 0, -half});
    if (mount == Mount::wall && piece.mount != Mount::wall)
        for (Mesh& m : piece.meshes) shapes::move(m, {0, 0, half});
    piece.mount = mount;
}

bool Layout::free_on_top(const Placed& p, int self) const {
    constexpr float kBeams = 0.25f;  // what hangs from the ceiling is in no box
    const Footprint box = footprint_of(p);
    if (!plan_.holds(box) || (plan_.beams && box.y1 > plan_.height - kBeams)) return false;
    for (int i = 0; i < static_cast<int>(placed_.size()); ++i) {
        const Placed& other = placed_[static_cast<std::size_t>(i)];
        if (i != self && i != p.on && !other.flat && !shelters(placed_, i, p) && overlap(box, footprint_of(other)))
            return false;
    }
    return true;
}

std::optional<int> Layout::on_top(int anchor, const PieceRequest& request, const PromptObject& from) {
    const Placed a = placed_[static_cast<std::size_t>(anchor)];
    Placed p;
    p.piece = make_piece(request);
    p.on = anchor;
    const bool leans = p.piece.mount == Mount::wall, asked = !from.kind.empty();
    if (leans) mount_as(p.piece, Mount::surface);
    const Vec3f front = front_of(a.yaw), right = right_of(a.yaw), size = p.piece.size_m;
    // One machine on the other: what is no larger than what carries it may reach beyond the free part of its top.
    const bool stacks = asked && size.x <= a.piece.size_m.x + 0.02f && size.z <= a.piece.size_m.z + 0.02f;
    // At a table people sit: what stands there keeps to its middle line.
    const bool keeps_middle = !asked && has_role(a.piece.kind, Role::laid);
    for (const Surface& s : a.piece.surfaces) {
        float slack_x = s.half.x - size.x / 2 - 0.01f, slack_z = s.half.y - size.z / 2 - 0.005f;
        const bool over = slack_x < 0 || slack_z < 0;
        if (over && !stacks) continue;
        // Beyond the edge of a worktop nothing reaches into what hangs above it.
        const bool middle_of_all = over && s.center.y > a.piece.size_m.y - 0.02f;
        if (over && !middle_of_all && !(asked && a.piece.size_m.y < s.center.y + 0.6f)) continue;
        slack_x = std::max(0.f, slack_x), slack_z = std::max(0.f, slack_z);
        constexpr float kMiddle = 0.2f;
        if (keeps_middle) (slack_x < slack_z ? slack_x : slack_z) *= kMiddle;
        // Out of reach only vases and baskets are kept.
        if (!asked && s.center.y > 1.5f && p.piece.kind != "vase" && p.piece.kind != "basket") continue;
        for (int tries = 0; tries < (asked ? 30 : 14); ++tries) {
            // Televisions and the like stand in the middle, small things anywhere; pictures lean at the back.
            const bool middle = over || ((size.x > 0.55f || keeps_middle) && tries == 0);
            const float x = middle ? 0.f : rng_.uniform(-slack_x, slack_x), z = leans ? -slack_z
                                                                                : middle
                                                                                    ? 0.f
                                                                                    : rng_.uniform(-slack_z, slack_z);
            const Vec2f at = middle_of_all ? Vec2f{0, 0} : Vec2f{s.center.x + x, s.center.z + z};
            p.position = a.position + right * at.x + front * at.y + Vec3f{0, s.center.y, 0};
            p.yaw = a.yaw + (size.x > 0.3f || leans ? 0.f : rng_.uniform(-0.3f, 0.3f));
            if (free_on_top(p) && !shades_window(plan_, footprint_of(p)) && std::isfinite(as_asked(p, from)) &&
                leaves_way(p, from))
                return keep(p, from);
        }
    }
    return {};
}

std::optional<int> Layout::on_top_at(int anchor, const PieceRequest& request, Vec2f at, float yaw,
                                     const PromptObject& from) {
    const Placed& a = placed_[static_cast<std::size_t>(anchor)];
    if (a.piece.surfaces.empty()) return {};
    Placed p;
    p.piece = make_piece(request);
    p.on = anchor;
    p.yaw = yaw;
    p.position = {at.x, a.position.y + a.piece.surfaces.front().center.y, at.y};
    const Footprint box = footprint_of(p), table = footprint_of(a);
    // All of it on the top.
    for (const Vec2f corner : corners_of(box))
        if (distance_to(table, corner) > 0.005f) return {};
    for (std::size_t i = 0; i < placed_.size(); ++i)
        if (static_cast<int>(i) != anchor && !placed_[i].flat && !shelters(placed_, static_cast<int>(i), p) &&
            overlap(box, footprint_of(placed_[i])))
            return {};
    if (!leaves_way(p, from)) return {};
    return keep(p, from);
}

std::optional<int> Layout::on_sill(const PieceRequest& request, std::optional<int> window, const PromptObject& from) {
    if (make_piece(request).mount != Mount::surface) return {};
    constexpr float kLowest = 0.3f;  // a window down to the floor has no sill
    constexpr float kSides = 0.14f;  // of the window's width, at either side: there hang its curtains
    const int count = static_cast<int>(plan_.openings.size()), first = count > 0 ? rng_.index(count) : 0;
    for (const float size : {1.f, 0.85f, 0.7f, 0.58f, 0.48f}) {
        PieceRequest smaller = request;
        smaller.size_factor *= size;
        Placed p;
        p.piece = make_piece(smaller);
        const Vec3f extents = p.piece.size_m;
        if (extents.z > kRevealDepth + kSillReach || !p.piece.surfaces.empty()) continue;
        for (int k = 0; k < count; ++k) {
            p.sill = (first + k) % count;
            if (window && *window != p.sill) continue;
            const Opening& o = plan_.openings[static_cast<std::size_t>(p.sill)];
            if (o.kind != Opening::Kind::window || o.shape == Opening::Shape::round || o.y0 < kLowest) continue;
            const WallFace face = plan_.wall(o.wall);
            const float side = std::max(0.06f, kSides * (o.u1 - o.u0)) + extents.x / 2;
            p.yaw = yaw_of(face.inward);
            for (int tries = 0; tries < (o.u1 - o.u0 > 2 * side ? 12 : 0); ++tries) {
                p.position = face.point(rng_.uniform(o.u0 + side, o.u1 - side), o.y0) +
                             face.inward * ((kSillReach - kRevealDepth) / 2);
                const Footprint room_for = footprint_of(p, 0.01f);
                const bool free = std::none_of(placed_.begin(), placed_.end(), [&](const Placed& other) {
                    return !other.flat && overlap(room_for, footprint_of(other));
                });
                if (free && stands_on_sill(plan_, p) && std::isfinite(as_asked(p, from))) return keep(p, from);
            }
        }
    }
    return {};
}

std::optional<int> Layout::on_floor_near(Vec2f at, const PieceRequest& request, const PromptObject& from) {
    Placed p;
    p.piece = make_piece(request);
    mount_as(p.piece, Mount::floor);
    for (int tries = 0; tries < 24; ++tries) {
        const float far = tries < 12 ? 0.7f : 1.6f;
        p.position = {at.x + rng_.uniform(-far, far), 0.013f, at.y + rng_.uniform(-far, far)};  // it may lie on a rug
        p.yaw = rng_.uniform(-kPi, kPi);
        ground(p);
        if (fits(p, false) && leaves_way(p, from)) return keep(p, from);
    }
    return {};
}

std::optional<int> Layout::on_any_top(const PieceRequest& request, const PromptObject& from) {
    const int first = placed_.empty() ? 0 : rng_.index(static_cast<int>(placed_.size()));
    // What was asked for stands on a wardrobe only when nothing lower has room.
    constexpr float kInReach = 1.5f;
    for (std::size_t k = 0; k < 2 * placed_.size(); ++k) {
        const int i = static_cast<int>((static_cast<std::size_t>(first) + k) % placed_.size());
        const Placed& p = placed_[static_cast<std::size_t>(i)];
        if (p.on >= 0 || p.piece.surfaces.empty() || p.piece.kind == "kitchen_counter") continue;
        const bool low = p.piece.surfaces.front().center.y < kInReach, second = k >= placed_.size();
        if (second == low) continue;
        if (!furnishing::lies_on_seats(request.kind) && furnishing::is_seat(p.piece.kind)) continue;
        // Three bowls in a row are a shop.
        const auto alike = std::count_if(placed_.begin(), placed_.end(),
                                         [&](const Placed& q) { return q.on == i && q.piece.kind == request.kind; });
        if (from.kind.empty() && alike > (request.kind == "candle" || request.kind == "book_stack" ? 1 : 0)) continue;
        if (const auto index = on_top(i, request, from)) return index;
    }
    return {};
}

std::optional<int> Layout::on_wall(const PieceRequest& request, std::optional<int> above, const PromptObject& from) {
    Placed p;
    p.piece = make_piece(request);
    if (p.piece.mount == Mount::floor) return against_wall(request, {}, from);
    if (p.piece.mount == Mount::ceiling) return {};
    if (p.piece.mount == Mount::surface) {
        // A television hangs as well as it stands; other small things need a top.
        if (p.piece.kind != "tv") return {};
        PieceRequest hung = request;
        hung.pattern = kHungScreen;
        p.piece = make_piece(hung);
        mount_as(p.piece, Mount::wall);
        p.piece.hang_height_m = 0.95f;
    }
    const Vec3f size = p.piece.size_m;
    const float top = plan_.wall_top() - (plan_.beams ? kBeamDepth : 0.f);
    std::optional<Placed> best;
    float best_score = -std::numeric_limits<float>::infinity();
    for (const WallFace& face : faces_) {
        if (!hangs_at(face)) continue;
        p.yaw = yaw_of(face.inward);
        float y = p.piece.hang_height_m > 0 ? p.piece.hang_height_m : 1.5f - size.y / 2;
        std::optional<float> wanted_u;
        float reach = 0.5f;
        if (above) {
            const Placed& a = placed_[static_cast<std::size_t>(*above)];
            const float off = dot(a.position - face.origin, face.inward) -
                              (a.piece.mount == Mount::wall ? 0.f : a.piece.size_m.z / 2);
            if (std::abs(std::remainder(a.yaw - p.yaw, 2 * kPi)) > 0.1f || std::abs(off) > (a.on >= 0 ? 0.4f : 0.25f))
                continue;
            wanted_u = dot(a.position - face.origin, face.along);
            reach = std::max(reach, a.piece.size_m.x / 2);
            // A hand above it; asked to be above, low enough to be seen with it.
            const float high = footprint_of(a).y1;
            y = from.relation == "above" ? std::max(high + 0.12f, std::min(y, high + 0.45f))
                                         : std::max(y, high + 0.15f);
            if (y + size.y > top - 0.12f) y = high + 0.05f;
            if (y + size.y > top - 0.05f) continue;
        } else if (y + size.y > top - 0.12f) y = top - 0.12f - size.y;
        if (y < 0) continue;
        const float usual = y;
        for (float u = size.x / 2 + 0.1f; u <= face.length - size.x / 2 - 0.1f; u += kSlotStep) {
            if (const float floor = plan_.floor_before(face, u - size.x / 2, u + size.x / 2); floor > 0 && !above)
                y = std::min(floor + usual, top - 0.12f - size.y);
            else y = usual;
            if (!wall_is_free(plan_, face, u - size.x / 2, u + size.x / 2, y, y + size.y)) continue;
            if (wanted_u && std::abs(u - *wanted_u) > reach) continue;
            p.position = face.point(u, y) + face.inward * 0.002f;
            const Footprint box = footprint_of(p, 0.03f);
            bool free = plan_.holds(footprint_of(p));
            for (const Placed& other : placed_)
                free = free && !overlap(box, footprint_of(other, other.piece.mount == Mount::wall ? 0.05f : 0.f)) &&
                       !hides(other, p);
            if (!free) continue;
            float score = wanted_u ? -std::abs(u - *wanted_u)
                                   : -0.2f * std::abs(u - face.length / 2) + rng_.uniform() * 0.4f -
                                         (face.wall == 2 ? 0.4f : 0.f);
            if (!wanted_u) {
                // Where the wall is barest.
                float bare = 2.f;
                for (const Placed& other : placed_)
                    if (!other.flat && !other.overhead && footprint_of(other).y1 > 1.2f)
                        bare = std::min(bare, distance_to(footprint_of(other), flat(p.position)));
                score += 0.8f * bare;
            }
            if (const float total = worth(p, from, score, best_score); total > best_score) best_score = total, best = p;
        }
    }
    if (best && above) best->with = *above;
    return best ? keep(*best, from) : std::nullopt;
}

std::optional<int> Layout::beside_on_wall(int anchor, const PieceRequest& request, int side, const PromptObject& from) {
    const Placed a = placed_[static_cast<std::size_t>(anchor)];
    Placed p;
    p.piece = make_piece(request);
    if (p.piece.mount != Mount::wall) return {};
    const Vec3f size = p.piece.size_m;
    const bool hung = a.piece.mount == Mount::wall;
    constexpr float kLowest = 1.1f, kHighest = 1.75f;
    const float floor = plan_.floor_below(footprint_of(a)),
                y = hung ? std::clamp(a.position.y + (a.piece.size_m.y - size.y) / 2, floor + kLowest, floor + kHighest)
                         : floor + p.piece.hang_height_m;
    for (const WallFace& face : faces_) {
        if (!hangs_at(face)) continue;
        const float off = dot(a.position - face.origin, face.inward) - (hung ? 0.f : a.piece.size_m.z / 2);
        if (dot(face.inward, front_of(a.yaw)) < 0.99f || std::abs(off) > 0.3f) continue;
        p.yaw = yaw_of(face.inward);
        const float middle = dot(a.position - face.origin, face.along),
                    way = dot(right_of(a.yaw), face.along) > 0 ? 1.f : -1.f;
        if (middle < 0 || middle > face.length) continue;
        // A hand beside it; beside a bed over its nightstand.
        for (const float gap : {hung ? 0.1f : 0.22f, 0.16f, 0.08f, 0.3f, 0.42f}) {
            const float u = middle + way * static_cast<float>(side) * (a.piece.size_m.x / 2 + size.x / 2 + gap);
            if (u < size.x / 2 + 0.05f || u > face.length - size.x / 2 - 0.05f ||
                !wall_is_free(plan_, face, u - size.x / 2, u + size.x / 2, y, y + size.y))
                continue;
            p.position = face.point(u, y) + face.inward * 0.002f;
            const Footprint box = footprint_of(p, 0.02f);
            bool free = plan_.holds(footprint_of(p));
            for (const Placed& other : placed_)
                free = free && !overlap(box, footprint_of(other, other.piece.mount == Mount::wall ? 0.03f : 0.f)) &&
                       !hides(other, p);
            if (!free || !leaves_way(p, from) || !std::isfinite(as_asked(p, from))) continue;
            p.with = anchor;
            return keep(p, from);
        }
    }
    return {};
}

}  // namespace fastscene

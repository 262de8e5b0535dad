#include "fastscene/rooms/layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace fastscene {
namespace {

constexpr float kSlotStep = 0.07f;
constexpr float kWallGap = 0.015f;
constexpr float kEyeHeight = 1.5f;
constexpr float kCurtainMargin = 0.32f;   // how far the rod reaches beyond the window
constexpr float kPi = std::numbers::pi_v<float>;

Vec2f flat(Vec3f v) { return {v.x, v.z}; }
Vec3f front_of(float yaw) { return {std::sin(yaw), 0, std::cos(yaw)}; }
Vec3f right_of(float yaw) { return {std::cos(yaw), 0, -std::sin(yaw)}; }  // the object's +x
float yaw_of(Vec3f front) { return std::atan2(front.x, front.z); }

std::array<Vec2f, 2> axes_of(const Footprint& f) { return {flat(right_of(f.yaw)), flat(front_of(f.yaw))}; }

// Half the extent of a box along a unit axis.
float extent(const Footprint& f, Vec2f axis) {
    const auto a = axes_of(f);
    return std::abs(dot(a[0], axis)) * f.half.x + std::abs(dot(a[1], axis)) * f.half.y;
}

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

bool overlap(const Footprint& a, const Footprint& b) {
    constexpr float kTouch = 0.004f;  // standing side by side is no overlap
    if (a.y0 >= b.y1 - kTouch || b.y0 >= a.y1 - kTouch) return false;
    const Vec2f between = b.center - a.center;
    for (const Footprint* f : {&a, &b})
        for (const Vec2f axis : axes_of(*f))
            if (std::abs(dot(between, axis)) >= extent(a, axis) + extent(b, axis) - kTouch) return false;
    return true;
}

float distance_to(const Footprint& box, Vec2f point) {
    const auto axes = axes_of(box);
    const Vec2f d = point - box.center;
    const float x = std::max(0.f, std::abs(dot(d, axes[0])) - box.half.x), y = std::max(0.f, std::abs(dot(d, axes[1])) - box.half.y);
    return std::hypot(x, y);
}

bool Layout::inside_room(const Footprint& box) const {
    return std::abs(box.center.x) + extent(box, {1, 0}) <= plan_.width / 2 - 0.002f && std::abs(box.center.y) + extent(box, {0, 1}) <= plan_.depth / 2 - 0.002f &&
           box.y0 > -0.01f && box.y1 < plan_.height + 0.01f;
}

// In the door's way, or tall before a window.
bool Layout::blocks_opening(const Footprint& box, float height) const {
    for (const Opening& o : plan_.openings) {
        const WallFace face = plan_.wall(o.wall);
        const bool door = o.kind == Opening::Kind::door;
        // What is on a desk may reach a little above the sill.
        constexpr float kAboveSill = 0.2f;
        if (!door && height < o.y0 + kAboveSill) continue;
        const float deep = door ? 0.85f : 0.35f;
        const Vec3f middle = face.point((o.u0 + o.u1) / 2, 0) + face.inward * (deep / 2);
        // Beside a window hang its curtains.
        Footprint zone{flat(middle), {(o.u1 - o.u0) / 2 + (door ? 0.05f : kCurtainMargin), deep / 2}, yaw_of(face.inward), 0, door ? 2.f : o.y1};
        if (!door) zone.y0 = o.y0 + kAboveSill;
        if (overlap(box, zone)) return true;
    }
    return false;
}

bool Layout::fits(const Placed& placed, bool with_clearance) const {
    const Footprint box = footprint_of(placed);
    if (!inside_room(box)) return false;
    if (placed.flat || placed.overhead) return true;
    if (placed.piece.mount == Mount::floor && blocks_opening(box, box.y1)) return false;
    Footprint room_for = box;
    if (with_clearance && placed.piece.mount == Mount::floor && placed.piece.clearance_front_m > 0) {
        const float front = std::min(placed.piece.clearance_front_m, 0.55f);
        room_for.half.y += front / 2;
        const Vec3f f = front_of(placed.yaw) * (front / 2);
        room_for.center = room_for.center + flat(f);
    }
    for (const Placed& other : placed_) {
        if (other.flat || other.on >= 0) continue;
        const Footprint b = footprint_of(other);
        if (overlap(box, b)) return false;
        if (with_clearance && other.piece.mount == Mount::floor && overlap(room_for, b)) return false;
        // Nor may it stand in the other's way.
        if (with_clearance && other.piece.mount == Mount::floor && other.piece.against_wall && other.piece.clearance_front_m > 0) {
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

PieceRequest Layout::request(std::string klass, const PromptObject* wish) {
    PieceRequest r;
    r.klass = std::move(klass);
    r.style = &plan_.style;
    r.seed = dice_.next_u64();
    if (wish) {
        if (!wish->color.empty()) r.color = color_named(wish->color);
        r.color_name = wish->color;
        r.material = wish->material;
        r.pattern = wish->pattern;
        r.size_factor = wish->size == "large" ? 1.15f : wish->size == "small" ? 0.87f : 1.f;
    }
    return r;
}

std::optional<int> Layout::find(std::string_view klass) const {
    for (std::size_t i = 0; i < placed_.size(); ++i)
        if (placed_[i].piece.klass == klass) return static_cast<int>(i);
    return {};
}

int Layout::count(std::string_view klass) const {
    return static_cast<int>(std::count_if(placed_.begin(), placed_.end(), [&](const Placed& p) { return p.piece.klass == klass; }));
}

std::optional<int> Layout::against_wall(const PieceRequest& request, const WallWish& wish, const PromptObject& from) {
    Placed p;
    p.piece = make_piece(request);
    const Vec3f size = p.piece.size_m;
    for (const bool clearance : {true, false}) {
        std::optional<Placed> best;
        float best_score = -std::numeric_limits<float>::infinity();
        for (int w = 0; w < 4; ++w) {
            if (wish.wall >= 0 && w != wish.wall) continue;
            const WallFace face = plan_.wall(w);
            p.yaw = yaw_of(face.inward);
            for (float u = size.x / 2 + kWallGap; u <= face.length - size.x / 2 - kWallGap; u += kSlotStep) {
                p.position = face.point(u, 0) + face.inward * (size.z / 2 + kWallGap);
                if (p.piece.mount == Mount::wall) p.position = face.point(u, p.piece.hang_height_m) + face.inward * kWallGap;
                if (!fits(p, clearance)) continue;
                if (p.piece.mount == Mount::wall && !wall_is_free(w, u - size.x / 2, u + size.x / 2, p.position.y, p.position.y + size.y)) continue;
                if (wish.clear_of_windows && std::any_of(plan_.openings.begin(), plan_.openings.end(), [&](const Opening& o) {
                        return o.wall == w && o.kind == Opening::Kind::window && u + size.x / 2 > o.u0 && u - size.x / 2 < o.u1;
                    }))
                    continue;
                const float off = std::abs(u - face.length / 2) / (face.length / 2), edge = std::min(u - size.x / 2, face.length - u - size.x / 2);
                float score = -wish.center_pull * off + 0.02f * dice_.uniform();
                if (wish.corner) score += 2.f - edge;
                if (wish.near) score -= 0.8f * length(flat(p.position) - *wish.near);
                if (w == 2) score -= 0.25f;  // the wall with the door is the last choice
                for (const Opening& o : plan_.openings)
                    if (o.kind == Opening::Kind::window && o.wall == w) {
                        const float apart = std::max(0.f, std::abs(u - (o.u0 + o.u1) / 2) - (o.u1 - o.u0) / 2 - size.x / 2);
                        score += wish.window_pull * std::max(0.f, 1.f - apart);
                    }
                if (score > best_score && leaves_way(p)) best_score = score, best = p;
            }
        }
        if (best) return keep(*best, from);
    }
    return {};
}

std::optional<int> Layout::in_front_of(int anchor, const PieceRequest& request, float gap, bool facing, const PromptObject& from) {
    const Placed& a = placed_[static_cast<std::size_t>(anchor)];
    Placed p;
    p.piece = make_piece(request);
    p.yaw = facing ? a.yaw + kPi : a.yaw;
    const Vec3f front = front_of(a.yaw), right = right_of(a.yaw);
    for (const float extra : {0.f, 0.1f, -0.1f, 0.25f})
        for (const float side : {0.f, 0.15f, -0.15f, 0.35f, -0.35f}) {
            p.position = a.position + front * (a.piece.size_m.z / 2 + gap + extra + p.piece.size_m.z / 2) + right * side;
            p.position.y = 0;
            if (fits(p, false) && leaves_way(p)) return keep(p, from);
        }
    return {};
}

std::optional<int> Layout::beside(int anchor, const PieceRequest& request, int side, float gap, const PromptObject& from) {
    const Placed& a = placed_[static_cast<std::size_t>(anchor)];
    Placed p;
    p.piece = make_piece(request);
    p.yaw = a.yaw;
    const Vec3f front = front_of(a.yaw), right = right_of(a.yaw);
    for (const float extra : {0.f, 0.06f, 0.15f}) {
        // Backs in line.
        p.position = a.position + right * (static_cast<float>(side) * (a.piece.size_m.x / 2 + p.piece.size_m.x / 2 + gap + extra)) +
                     front * ((p.piece.size_m.z - a.piece.size_m.z) / 2);
        p.position.y = 0;
        if (fits(p, false) && leaves_way(p)) return keep(p, from);
    }
    return {};
}

std::optional<int> Layout::free_standing(const PieceRequest& request, const PromptObject& from) {
    Placed p;
    p.piece = make_piece(request);
    std::optional<Placed> best;
    float best_score = -1e9f;
    for (const float yaw : {0.f, kPi / 2, kPi, -kPi / 2})
        for (float x = -plan_.width / 2; x < plan_.width / 2; x += 0.2f)
            for (float z = -plan_.depth / 2; z < plan_.depth / 2; z += 0.2f) {
                p.position = {x, 0, z};
                p.yaw = yaw;
                if (!fits(p, false)) continue;
                Footprint wide = footprint_of(p, 0.5f);
                float score = -0.3f * std::hypot(x, z - 0.3f) + 0.02f * dice_.uniform();
                for (const Placed& other : placed_)
                    if (!other.flat && !other.overhead && other.on < 0 && overlap(wide, footprint_of(other))) score -= 0.5f;
                if (score > best_score && leaves_way(p)) best_score = score, best = p;
            }
    return best ? keep(*best, from) : std::nullopt;
}

std::optional<int> Layout::angled_towards(Vec2f target, const PieceRequest& request, const PromptObject& from) {
    Placed p;
    p.piece = make_piece(request);
    std::optional<Placed> best;
    float best_score = -1e9f;
    for (float x = -plan_.width / 2 + 0.4f; x < plan_.width / 2 - 0.3f; x += 0.12f)
        for (float z = -plan_.depth / 2 + 0.4f; z < plan_.depth / 2 - 0.3f; z += 0.12f) {
            const Vec2f to = target - Vec2f{x, z};
            const float far = length(to);
            if (!(far > 1.1f && far < 3.2f)) continue;
            p.position = {x, 0, z};
            // Turned towards the target by steps of 15 degrees.
            p.yaw = std::round(std::atan2(to.x, to.y) / (kPi / 12)) * (kPi / 12);
            if (!fits(p, false)) continue;
            const float wall = std::min(plan_.width / 2 - std::abs(x), plan_.depth / 2 - std::abs(z));
            const float score = -std::abs(far - 1.8f) - 0.6f * wall + 0.05f * dice_.uniform();
            if (score > best_score && leaves_way(p)) best_score = score, best = p;
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
    const int along = std::max(1, static_cast<int>(w / 0.62f));
    for (int i = 0; i < along; ++i) {
        const float x = (static_cast<float>(i) + 0.5f) / static_cast<float>(along) * w - w / 2;
        seats.push_back({x, d / 2, kPi});
        seats.push_back({x, -d / 2, 0});
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
        const Vec3f out = normalize(right * (seat.yaw == kPi || seat.yaw == 0 ? 0.f : seat.x) + front * (seat.yaw == kPi || seat.yaw == 0 ? seat.z : 0.f));
        p.yaw = a.yaw + seat.yaw;
        for (const float pull : {0.02f, 0.12f}) {
            p.position = a.position + right * seat.x + front * seat.z + out * (p.piece.size_m.z / 2 + pull);
            p.position.y = 0;
            if (fits(p, false) && leaves_way(p)) {
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
    Placed p;
    p.piece = make_piece(request);
    p.flat = true;
    p.yaw = a.yaw;
    p.position = a.position + front_of(a.yaw) * shift;
    p.position.y = 0;
    // Into the room, not into the wall.
    Footprint f = footprint_of(p);
    const float over_x = std::abs(f.center.x) + extent(f, {1, 0}) - plan_.width / 2 + 0.12f, over_z = std::abs(f.center.y) + extent(f, {0, 1}) - plan_.depth / 2 + 0.12f;
    if (over_x > 0) p.position.x -= std::copysign(over_x, p.position.x);
    if (over_z > 0) p.position.z -= std::copysign(over_z, p.position.z);
    if (!inside_room(footprint_of(p))) return {};
    for (const Placed& other : placed_)
        if (other.flat && overlap(footprint_of(p), footprint_of(other))) return {};
    return keep(p, from);
}

std::optional<int> Layout::on_top(int anchor, const PieceRequest& request, const PromptObject& from) {
    const Placed a = placed_[static_cast<std::size_t>(anchor)];
    Placed p;
    p.piece = make_piece(request);
    p.on = anchor;
    const Vec3f front = front_of(a.yaw), right = right_of(a.yaw);
    for (const Surface& s : a.piece.surfaces) {
        const float slack_x = s.half.x - p.piece.size_m.x / 2 - 0.01f, slack_z = s.half.y - p.piece.size_m.z / 2 - 0.005f;
        if (slack_x < 0 || slack_z < 0) continue;
        // Out of reach only vases and baskets are kept.
        if (s.center.y > 1.5f && p.piece.klass != "vase" && p.piece.klass != "basket") continue;
        for (int tries = 0; tries < 14; ++tries) {
            // Televisions and the like stand in the middle, small things anywhere.
            const bool middle = p.piece.size_m.x > 0.55f && tries == 0;
            const float x = middle ? 0.f : dice_.uniform(-slack_x, slack_x), z = middle ? 0.f : dice_.uniform(-slack_z, slack_z);
            p.position = a.position + right * (s.center.x + x) + front * (s.center.z + z) + Vec3f{0, s.center.y, 0};
            p.yaw = a.yaw + (p.piece.size_m.x > 0.3f ? 0.f : dice_.uniform(-0.3f, 0.3f));
            if (!inside_room(footprint_of(p))) continue;
            bool free = true;
            for (const Placed& other : placed_) free = free && (other.flat || &other == &placed_[static_cast<std::size_t>(anchor)] || !overlap(footprint_of(p), footprint_of(other)));
            if (free && leaves_way(p)) return keep(p, from);
        }
    }
    return {};
}

std::optional<int> Layout::on_any_top(const PieceRequest& request, const PromptObject& from) {
    const int first = placed_.empty() ? 0 : dice_.index(static_cast<int>(placed_.size()));
    for (std::size_t k = 0; k < placed_.size(); ++k) {
        const int i = static_cast<int>((static_cast<std::size_t>(first) + k) % placed_.size());
        const Placed& p = placed_[static_cast<std::size_t>(i)];
        static constexpr std::array<const char*, 7> kSeats{"armchair", "sofa", "loveseat", "chair", "stool", "bar_stool", "office_chair"};
        if (p.on >= 0 || p.piece.surfaces.empty() || p.piece.klass == "kitchen_counter") continue;
        if (request.klass != "cat" && request.klass != "cushion" && std::find(kSeats.begin(), kSeats.end(), p.piece.klass) != kSeats.end()) continue;
        if (const auto index = on_top(i, request, from)) return index;
    }
    return {};
}

bool Layout::wall_is_free(int wall, float u0, float u1, float y0, float y1) const {
    for (const Opening& o : plan_.openings)
        if (o.wall == wall && u0 < o.u1 + 0.1f && u1 > o.u0 - 0.1f && y0 < o.y1 + 0.1f && y1 > o.y0 - 0.1f) return false;
    return true;
}

std::optional<int> Layout::on_wall(const PieceRequest& request, std::optional<int> above, const PromptObject& from) {
    Placed p;
    p.piece = make_piece(request);
    if (p.piece.mount != Mount::wall) return against_wall(request, {}, from);
    const Vec3f size = p.piece.size_m;
    std::optional<Placed> best;
    float best_score = -1e9f;
    for (int w = 0; w < 4; ++w) {
        const WallFace face = plan_.wall(w);
        p.yaw = yaw_of(face.inward);
        float y = p.piece.hang_height_m > 0 ? p.piece.hang_height_m : 1.5f - size.y / 2;
        std::optional<float> wanted_u;
        if (above) {
            const Placed& a = placed_[static_cast<std::size_t>(*above)];
            if (std::abs(std::remainder(a.yaw - p.yaw, 2 * kPi)) > 0.1f || std::abs(dot(a.position - face.origin, face.inward) - a.piece.size_m.z / 2) > 0.2f) continue;
            wanted_u = dot(a.position - face.origin, face.along);
            y = std::max(y, a.piece.size_m.y + 0.15f);
        }
        if (y + size.y > plan_.height - 0.12f) y = plan_.height - 0.12f - size.y;
        if (y < 0) continue;
        for (float u = size.x / 2 + 0.1f; u <= face.length - size.x / 2 - 0.1f; u += kSlotStep) {
            if (!wall_is_free(w, u - size.x / 2, u + size.x / 2, y, y + size.y)) continue;
            p.position = face.point(u, y) + face.inward * 0.002f;
            const Footprint box = footprint_of(p, 0.03f);
            bool free = true;
            for (const Placed& other : placed_) free = free && !overlap(box, footprint_of(other, other.piece.mount == Mount::wall ? 0.05f : 0.f));
            if (!free) continue;
            float score = wanted_u ? -std::abs(u - *wanted_u) : -0.2f * std::abs(u - face.length / 2) + dice_.uniform() * 0.4f - (w == 2 ? 0.4f : 0.f);
            if (!wanted_u) {
                // Where the wall is barest.
                float bare = 2.f;
                for (const Placed& other : placed_)
                    if (!other.flat && !other.overhead && footprint_of(other).y1 > 1.2f) bare = std::min(bare, distance_to(footprint_of(other), flat(p.position)));
                score += 0.8f * bare;
            }
            if (score > best_score && leaves_way(p)) best_score = score, best = p;
        }
    }
    if (above && best_score < -0.5f) return {};
    return best ? keep(*best, from) : std::nullopt;
}

std::optional<int> Layout::hanging(const PieceRequest& request, Vec2f at, const PromptObject& from) {
    Placed p;
    p.piece = make_piece(request);
    p.overhead = true;
    p.position = {at.x, plan_.height, at.y};
    if (!inside_room(footprint_of(p))) return {};
    for (const Placed& other : placed_)
        if (!other.flat && overlap(footprint_of(p, 0.05f), footprint_of(other))) return {};
    if (!leaves_way(p)) return {};
    return keep(p, from);
}

int Layout::at_windows(const PieceRequest& request, const PromptObject& from) {
    int hung = 0;
    for (const Opening& o : plan_.openings) {
        if (o.kind != Opening::Kind::window) continue;
        const WallFace face = plan_.wall(o.wall);
        const float top = std::min(plan_.height - 0.06f, o.y1 + 0.16f);
        const auto hang = [&](float margin, float low) {
            PieceRequest r = request;
            r.size_m = {std::min(o.u1 - o.u0 + 2 * margin, face.length - 0.04f), top - low, 0};
            Placed p;
            p.piece = make_piece(r);
            p.yaw = yaw_of(face.inward);
            p.position = face.point((o.u0 + o.u1) / 2, p.piece.mount == Mount::wall ? top - p.piece.size_m.y : low) + face.inward * 0.045f;
            if (p.piece.mount != Mount::wall) p.position = p.position + face.inward * (p.piece.size_m.z / 2);
            const Footprint box = footprint_of(p);
            bool free = inside_room(box);
            for (const Placed& other : placed_) free = free && (other.flat || !overlap(box, footprint_of(other)));
            free = free && leaves_way(p);
            if (free) keep(p, from);
            return free;
        };
        // To the floor; else to the sill, or to what stands below; at last narrower.
        bool done = hang(kCurtainMargin, 0.02f);
        for (const float margin : {kCurtainMargin, 0.18f, 0.08f})
            for (const float low : {o.y0 - 0.12f, o.y0 - 0.02f, o.y0 + 0.15f, o.y0 + 0.4f}) done = done || hang(margin, std::max(0.02f, low));
        hung += done;
    }
    return hung;
}

namespace {

// Whether the segment from a to b passes through the box (slabs in the box's own frame).
bool passes(const Footprint& box, Vec3f a, Vec3f b) {
    const auto axes = axes_of(box);
    float t0 = 0, t1 = 1;
    const auto slab = [&](float from, float to, float low, float high) {
        const float d = to - from;
        if (std::abs(d) < 1e-6f) {
            if (from < low || from > high) t0 = 2;
            return;
        }
        const float u = (low - from) / d, v = (high - from) / d;
        t0 = std::max(t0, std::min(u, v));
        t1 = std::min(t1, std::max(u, v));
    };
    for (std::size_t k = 0; k < 2; ++k) {
        const float half = k == 0 ? box.half.x : box.half.y;
        slab(dot(flat(a) - box.center, axes[k]), dot(flat(b) - box.center, axes[k]), -half, half);
    }
    slab(a.y, b.y, box.y0, box.y1);
    return t0 < t1;
}

}  // namespace

// How many of the pieces that were asked for nothing can be seen of: other pieces stand before them.
int Layout::hidden_wishes(Vec3f eye) const {
    int hidden = 0;
    for (std::size_t i = 0; i < placed_.size(); ++i) {
        if (placed_[i].wish.klass.empty()) continue;
        const Footprint box = footprint_of(placed_[i]);
        const auto axes = axes_of(box);
        bool seen = false;
        for (const float along : {0.f, -0.7f, 0.7f})
            for (const float up : {0.95f, 0.5f}) {
                if (seen) break;
                const Vec2f at = box.center + axes[0] * (along * box.half.x);
                const Vec3f target{at.x, box.y0 + up * (box.y1 - box.y0), at.y};
                seen = true;
                for (std::size_t k = 0; k < placed_.size() && seen; ++k) {
                    if (k == i || placed_[k].flat || placed_[k].on == static_cast<int>(i) || placed_[i].on == static_cast<int>(k)) continue;
                    seen = !passes(footprint_of(placed_[k]), eye, target);
                }
            }
        hidden += !seen;
    }
    return hidden;
}

Vec3f Layout::camera_position() const {
    Vec3f best{0, kEyeHeight, 0};
    float best_score = -1e9f;
    for (float x = -plan_.width / 2 + 0.6f; x <= plan_.width / 2 - 0.6f; x += 0.1f)
        for (float z = -plan_.depth / 2 + 0.6f; z <= plan_.depth / 2 - 0.6f; z += 0.1f) {
            float tall = std::min(plan_.width / 2 - std::abs(x), plan_.depth / 2 - std::abs(z)), low = 1.f;
            for (const Placed& p : placed_) {
                if (p.flat) continue;
                const Footprint f = footprint_of(p);
                const float far = distance_to(f, {x, z});
                // Heights within the ball of 0.7 m about the eyes count fully; what is lower only keeps the feet away.
                if (f.y1 > kEyeHeight - 0.7f && f.y0 < kEyeHeight + 0.7f) tall = std::min(tall, far);
                else if (f.y1 < kEyeHeight) low = std::min(low, far);
            }
            // Beyond 1.1 m more space is no gain; the middle of the room shows most of it.
            float score = 3.f * std::min(tall, 1.1f) + 0.8f * std::min(low, 0.4f) - 0.35f * std::hypot(x, z);
            // Air around the eyes comes before all that may be seen, and behind a barrier of tables nobody stands.
            constexpr float kMustBeFree = 0.58f;
            if (tall < kMustBeFree) score -= 100.f * (kMustBeFree - tall) + 10.f;
            if (score <= best_score) continue;
            if (!ways_.reaches({x, z})) score -= 50.f;
            if (score <= best_score) continue;
            score -= 0.6f * static_cast<float>(hidden_wishes({x, kEyeHeight, z}));
            if (score > best_score) best_score = score, best = {x, kEyeHeight, z};
        }
    return best;
}

std::vector<std::string> layout_faults(const Plan& plan, const std::vector<Placed>& placed) {
    std::vector<std::string> faults;
    const auto name = [&](std::size_t i) { return placed[i].piece.klass + " #" + std::to_string(i); };
    for (std::size_t i = 0; i < placed.size(); ++i) {
        const Footprint a = footprint_of(placed[i]);
        if (std::abs(a.center.x) + extent(a, {1, 0}) > plan.width / 2 + 0.01f || std::abs(a.center.y) + extent(a, {0, 1}) > plan.depth / 2 + 0.01f)
            faults.push_back(name(i) + " reaches into a wall");
        if (a.y0 < -0.02f || a.y1 > plan.height + 0.02f) faults.push_back(name(i) + " reaches through floor or ceiling");
        if (placed[i].flat) continue;
        for (std::size_t k = i + 1; k < placed.size(); ++k) {
            if (placed[k].flat || placed[k].on == static_cast<int>(i) || placed[i].on == static_cast<int>(k)) continue;
            if (overlap(a, footprint_of(placed[k]))) faults.push_back(name(i) + " and " + name(k) + " stand in each other");
        }
        for (const Opening& o : plan.openings)
            if (o.kind == Opening::Kind::door && placed[i].piece.mount == Mount::floor) {
                const WallFace face = plan.wall(o.wall);
                const Vec3f middle = face.point((o.u0 + o.u1) / 2, 0) + face.inward * 0.35f;
                if (overlap(a, {flat(middle), {0.4f, 0.34f}, yaw_of(face.inward), 0, 2})) faults.push_back(name(i) + " blocks the door");
            }
    }
    Ways ways(plan);
    for (const Placed& p : placed) ways.add(p);
    if (!ways.open()) faults.push_back("no way leads from the door to a place for the camera");
    return faults;
}

}  // namespace fastscene

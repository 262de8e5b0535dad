// What a layout costs a visitor. The terms and their source are in layout_anneal.h.
#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/layout_anneal.h"
#include "fastscene/rooms/layout_relations.h"

namespace fastscene {
namespace {

// An upright box with its axes: sines are taken once.
struct Box {
    Vec2f center, right, front, half;
    float y0, y1;
    float reach(Vec2f axis) const { return half.x * std::abs(dot(right, axis)) + half.y * std::abs(dot(front, axis)); }
};
Box box_of(const Placed& p) {
    const Footprint f = footprint_of(p);
    const auto axes = axes_of(f);
    return {f.center, axes[0], axes[1], f.half, f.y0, f.y1};
}

// How far two boxes lie apart along the axis that parts them most; negative: how deep they lie in each other.
float apart(const Box& a, const Box& b) {
    float most = -1e9f;
    for (const Vec2f axis : {a.right, a.front, b.right, b.front})
        most = std::max(most, std::abs(dot(b.center - a.center, axis)) - a.reach(axis) - b.reach(axis));
    return most;
}

float share(float value, float of) { return std::clamp(value / of, 0.f, 1.f); }

class Costing {
  public:
    Costing(const Plan& plan, const std::vector<Placed>& placed) : plan_(plan), placed_(placed) {
        for (std::size_t i = 0; i < placed.size(); ++i) {
            boxes_.push_back(box_of(placed[i]));
            const Placed& p = placed[i];
            if (p.piece.mount == Mount::floor && p.on < 0 && p.below < 0 && !p.flat && p.piece.kind != "curtain")
                floor_.push_back(i);
            std::size_t root = i;
            for (int steps = 0; steps < 8; ++steps) {
                const Placed& r = placed[root];
                const int up = r.on >= 0 ? r.on : r.with;
                if (up < 0) break;
                root = static_cast<std::size_t>(up);
            }
            root_.push_back(root);
        }
    }
    LayoutCost cost() const {
        LayoutCost c;
        c.clearance = clearance();
        c.walkway = walkway();
        c.facing = facing();
        c.alignment = alignment();
        c.wall = wall();
        for (const Placed& p : placed_)
            if (!p.wish.relation.empty() && !stands_as_asked(plan_, placed_, p, p.wish).value_or(true)) c.asked += 4.f;
        return c;
    }

  private:
    const std::string& kind(std::size_t i) const { return placed_[i].piece.kind; }

    // The free floor a piece wants on one side, as a box.
    float taken(std::size_t i, Vec2f side, float half_along, float half_across, float depth) const {
        const Box& b = boxes_[i];
        const Box zone{
            b.center + side * (half_along + depth / 2), {side.y, -side.x}, side, {half_across, depth / 2}, 0, 1};
        float worst = 0;
        for (const std::size_t k : floor_)
            if (root_[k] != root_[i]) worst = std::max(worst, -apart(zone, boxes_[k]));
        return share(worst, 0.6f);
    }
    float clearance() const {
        float sum = 0;
        for (const std::size_t i : floor_) {
            const Box& b = boxes_[i];
            const Piece& p = placed_[i].piece;
            if (p.clearance_front_m > 0)
                sum += taken(i, b.front, b.half.y, b.half.x * 0.9f, std::max(0.5f, p.clearance_front_m));
            if (p.clearance_side_m > 0)
                for (const float side : {-1.f, 1.f})
                    sum += 0.5f * taken(i, b.right * side, b.half.x, b.half.y * 0.8f, p.clearance_side_m);
        }
        return sum;
    }

    float walkway() const {
        float sum = 0;
        for (const Opening& o : plan_.openings) {
            if (o.kind == Opening::Kind::window) continue;
            constexpr float kDeep = 1.2f;
            const WallFace face = plan_.wall(o.wall);
            const Vec2f in = flat(face.inward);
            const Box zone{flat(face.point((o.u0 + o.u1) / 2, 0)) + in * (kDeep / 2),
                           flat(face.along),
                           in,
                           {(o.u1 - o.u0) / 2, kDeep / 2},
                           0,
                           2};
            for (const std::size_t i : floor_) sum += share(-apart(zone, boxes_[i]), 0.5f);
        }
        for (std::size_t a = 0; a < floor_.size(); ++a)
            for (std::size_t b = 0; b < a; ++b) {
                const std::size_t i = floor_[a], k = floor_[b];
                if (root_[i] == root_[k]) continue;
                const float gap = apart(boxes_[i], boxes_[k]);
                // Side by side at one wall nobody walks between them.
                const bool in_line = dot(boxes_[i].front, boxes_[k].front) > 0.9f &&
                                     std::abs(dot(boxes_[i].center - boxes_[k].center, boxes_[i].front)) < 0.5f;
                if (gap > 0.12f && gap < 0.55f && !in_line) sum += 0.5f * (0.55f - gap) / 0.43f;
            }
        return sum;
    }

    float facing() const {
        float sum = 0;
        for (const std::size_t i : floor_) {
            if (!has_role(kind(i), Role::sofa)) continue;
            const Box& sofa = boxes_[i];
            float best = -1;
            for (const std::size_t k : floor_) {
                if (!has_role(kind(k), Role::focus)) continue;
                const Vec2f to = boxes_[k].center - sofa.center;
                const float far = length(to), ahead = dot(to, sofa.front), side = std::abs(dot(to, sofa.right));
                const float c = 0.5f * (1 - ahead / std::max(far, 0.1f)) +
                                0.5f * (1 + dot(to, boxes_[k].front) / std::max(far, 0.1f)) + 0.5f * share(side, 1.5f) +
                                share(std::max(1.8f - far, far - 4.f), 2.f);
                if (best < 0 || c < best) best = c;
            }
            sum += std::max(0.f, best);
            for (const std::size_t k : floor_) {
                if (kind(k) != "armchair") continue;
                const Vec2f middle = sofa.center + sofa.front * (sofa.half.y + 0.7f), to = middle - boxes_[k].center;
                const float far = length(to);
                sum += 0.25f * (1 - dot(to, boxes_[k].front) / std::max(far, 0.1f)) +
                       0.5f * share(std::max(0.9f - far, far - 2.4f), 1.5f);
            }
            break;
        }
        return sum;
    }

    bool is_main(std::size_t i) const { return has_role(kind(i), Role::main_piece); }
    float alignment() const {
        float sum = 0;
        for (const std::size_t i : floor_) {
            const Box& b = boxes_[i];
            if (has_role(kind(i), Role::centerpiece) && root_[i] == i)
                sum += 0.3f * std::abs(std::sin(2 * placed_[i].yaw)) + 0.2f * share(length(b.center), 1.5f);
            if (!is_main(i)) continue;
            for (const WallFace& face : faces_) {
                const float off = dot(b.center - flat(face.origin), flat(face.inward)) - b.half.y,
                            u = dot(b.center - flat(face.origin), flat(face.along));
                if (dot(flat(face.inward), b.front) < 0.99f || off > 0.3f || u < 0 || u > face.length) continue;
                sum += 0.35f * share(std::abs(u - face.length / 2), face.length / 2);
                break;
            }
        }
        return sum;
    }

    float wall() const {
        float sum = 0, area = 0;
        Vec2f center{0, 0};
        const Vec2f half{plan_.width / 2, plan_.depth / 2};
        for (const std::size_t i : floor_) {
            const Box& b = boxes_[i];
            const float a = 4 * b.half.x * b.half.y;
            area += a;
            center = center + b.center * a;
            if (b.y1 > 1.3f || has_role(kind(i), Role::focus))
                for (const Opening& o : plan_.openings) {
                    if (o.kind != Opening::Kind::window) continue;
                    const WallFace face = plan_.wall(o.wall);
                    const Vec2f to = b.center - flat(face.point((o.u0 + o.u1) / 2, 0));
                    const float along = std::abs(dot(to, flat(face.along))) - (o.u1 - o.u0) / 2 -
                                        b.reach(flat(face.along)),
                                deep = dot(to, flat(face.inward));
                    if (along < 0.3f && deep < 1.f) sum += share(0.3f - along, 0.3f);
                }
            if (is_main(i) && b.front.y > 0.9f && b.center.y < -half.y + 1.f) sum += 0.25f;
            if (root_[i] == i && has_role(kind(i), Role::at_edges))
                sum += 0.15f *
                       share(std::max(half.x - std::abs(b.center.x), half.y - std::abs(b.center.y)) - 0.3f, 1.2f);
        }
        if (area > 0) sum += 0.6f * share(length(Vec2f{center.x / area / half.x, center.y / area / half.y}), 1.f);
        return sum;
    }

    const Plan& plan_;
    const std::vector<Placed>& placed_;
    const std::vector<WallFace> faces_ = plan_.faces();
    std::vector<Box> boxes_;
    std::vector<std::size_t> floor_, root_;
};

}  // namespace

LayoutCost layout_cost(const Plan& plan, const std::vector<Placed>& placed) { return Costing(plan, placed).cost(); }

}  // namespace fastscene

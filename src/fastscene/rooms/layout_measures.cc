#include "fastscene/rooms/layout_measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/layout_measures_parts.h"
#include "fastscene/rooms/repeated_forms.h"

namespace fastscene {
namespace measuring {

std::string name_of_piece(const std::vector<Placed>& placed, int piece) {
    return fmt::format("{} #{}", placed[static_cast<std::size_t>(piece)].piece.kind, piece);
}

std::vector<Solid> solids_of(const std::vector<Placed>& placed) {
    std::vector<Solid> out;
    for (std::size_t i = 0; i < placed.size(); ++i) {
        const Placed& p = placed[i];
        // The roof of a tent or an igloo is the room itself.
        if (is_shell(p.piece.kind) || has_role(p.piece.kind, Role::roof)) continue;
        Solid solid{static_cast<int>(i), {}, {}};
        const float c = std::cos(p.yaw), s = std::sin(p.yaw);
        const auto placed_at = [&](Vec3f v) { return p.position + Vec3f{c * v.x + s * v.z, v.y, c * v.z - s * v.x}; };
        for (const Mesh& mesh : p.piece.meshes)
            for (std::size_t t = 0; t + 2 < mesh.triangles.size(); t += 3) {
                Corners corners;
                for (std::size_t k = 0; k < 3; ++k) {
                    corners[k] = placed_at(mesh.positions[mesh.triangles[t + k]]);
                    solid.box.add(corners[k]);
                }
                solid.triangles.push_back(corners);
            }
        if (!solid.triangles.empty()) out.push_back(std::move(solid));
    }
    return out;
}

std::vector<Vec3f> clipped(const std::vector<Vec3f>& polygon, std::size_t axis, float at, bool above) {
    std::vector<Vec3f> out;
    const auto off = [&](Vec3f p) { return above ? p[axis] - at : at - p[axis]; };
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3f a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        const float from = off(a), to = off(b);
        if (from >= 0) out.push_back(a);
        if ((from < 0) != (to < 0)) out.push_back(lerp(a, b, from / (from - to)));
    }
    return out;
}

bool is_floor(const Plan& plan, Vec2f p, float slack) {
    if (std::abs(p.x) > plan.width / 2 + slack || std::abs(p.y) > plan.depth / 2 + slack) return false;
    for (const Block& b : plan.blocks)
        if (!cuts_corner(b) && p.x > b.low.x + slack && p.x < b.high.x - slack && p.y > b.low.y + slack &&
            p.y < b.high.y - slack)
            return false;
    if (!has_cut_corners(plan)) return true;
    // The outline goes around once, whichever way.
    bool left = true, right = true;
    const std::vector<Vec2f> line = plan.outline();
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Vec2f a = line[i], e = line[(i + 1) % line.size()] - a, to = p - a;
        const float side = (e.x * to.y - e.y * to.x) / std::max(1e-6f, length(e));
        left = left && side >= -slack, right = right && side <= slack;
    }
    return left || right;
}

namespace {

constexpr float kOutside = 0.01f;      // share of a piece's surface that may be off the floor plan; SceneEval's
constexpr float kOnTheWall = 0.003f;   // metres: a back that lies in the wall's plane is not behind it
constexpr float kBeforeWindow = 0.5f;  // metres kept free before a window; SceneEval's
constexpr float kPassage = 0.8f;       // … before a door without a leaf that swings
constexpr float kTouch = 0.03f;        // metres by which an opening's box is smaller: so little reaches into none
constexpr float kMat = 0.03f;          // metres above the floor: one walks over a mat before a door

// A part of a window: what hangs before it to be drawn, what stands on its sill, a railing.
bool dresses_window(const Placed& p) {
    return p.sill >= 0 || is_curtain(p.piece.kind) || has_role(p.piece.kind, Role::blind) ||
           (has_nyu40_label(p.piece.kind, "other structure") && has_role(p.piece.kind, Role::under_windows));
}

// In the reveal of a window, or in a doorway.
bool in_an_opening(const Plan& plan, Vec3f p) {
    return std::any_of(plan.openings.begin(), plan.openings.end(), [&](const Opening& o) {
        const WallFace wall = plan.wall(o.wall);
        const Vec3f to = p - wall.origin;
        const float u = dot(to, wall.along), off = dot(to, wall.inward);
        return u > o.u0 && u < o.u1 && p.y > o.y0 - kOnTheWall && p.y < o.y1 && off <= 0 &&
               off > -plan.wall_thickness();
    });
}

// The share of its surface that is not over the floor plan, by points spread evenly over it.
float share_outside(const Plan& plan, const Solid& solid) {
    constexpr int kLeastPoints = 1000;    // SceneEval's
    constexpr float kPointsPerM3 = 5000;  // … of the box about it
    std::vector<float> up_to;
    float area = 0;
    for (const Corners& t : solid.triangles) up_to.push_back(area += 0.5f * length(cross(t[1] - t[0], t[2] - t[0])));
    const Vec3f size = solid.box.high - solid.box.low;
    const int points = std::max(kLeastPoints, static_cast<int>(kPointsPerM3 * size.x * size.y * size.z));
    Random rng(0, "points on a piece", static_cast<std::uint64_t>(solid.piece));
    int outside = 0;
    for (int i = 0; i < points; ++i) {
        const float at = area * (static_cast<float>(i) + rng.uniform()) / static_cast<float>(points);
        const auto k = static_cast<std::size_t>(std::lower_bound(up_to.begin(), up_to.end(), at) - up_to.begin());
        const Corners& t = solid.triangles[std::min(k, solid.triangles.size() - 1)];
        const float r = std::sqrt(rng.uniform()), s = rng.uniform();
        const Vec3f p = t[0] * (1 - r) + t[1] * (r * (1 - s)) + t[2] * (r * s);
        outside += !is_floor(plan, {p.x, p.z}, kOnTheWall) && !in_an_opening(plan, p);
    }
    return static_cast<float>(outside) / static_cast<float>(points);
}

// What of a triangle is in the box before an opening, seen along the wall and up.
std::vector<Vec2f> before(const Plan& plan, const Opening& o, float depth, const Corners& t) {
    const WallFace wall = plan.wall(o.wall);
    std::vector<Vec3f> polygon;  // along the wall, up, into the room
    for (const Vec3f p : t) {
        const Vec3f to = p - wall.origin;
        polygon.push_back({dot(to, wall.along), p.y, dot(to, wall.inward)});
    }
    const bool on_floor = o.y0 < kMat;
    const Vec3f low{o.u0 + kTouch, on_floor ? kMat : o.y0 + kTouch, -plan.wall_thickness() / 2},
        high{o.u1 - kTouch, o.y1 - kTouch, depth - kTouch};
    for (std::size_t a = 0; a < 3 && !polygon.empty(); ++a)
        polygon = clipped(clipped(polygon, a, low[a], true), a, high[a], false);
    std::vector<Vec2f> out;
    for (const Vec3f p : polygon) out.push_back({p.x, p.y});
    return out;
}

void measure_openings(const Plan& plan, const std::vector<Placed>& placed, const std::vector<Solid>& solids,
                      LayoutMeasures& out) {
    for (const Opening& o : plan.openings) {
        const bool window = o.kind == Opening::Kind::window && !is_doors(o.glazing);
        const float wide = o.u1 - o.u0, depth = window                          ? kBeforeWindow
                                                : o.kind == Opening::Kind::door ? wide
                                                                                : std::min(wide, kPassage);
        CellMap covered({o.u0, o.y0}, {o.u1, o.y1}, 0.02f);
        std::string what;
        for (const Solid& solid : solids) {
            const Placed& p = placed[static_cast<std::size_t>(solid.piece)];
            if (p.flat || dresses_window(p)) continue;
            bool any = false;
            for (const Corners& t : solid.triangles) {
                const std::vector<Vec2f> part = before(plan, o, depth, t);
                any = any || !part.empty();
                covered.fill(part);
            }
            if (any) what += (what.empty() ? "" : ", ") + name_of_piece(placed, solid.piece);
        }
        const float area = (o.u1 - o.u0) * (o.y1 - o.y0);
        const auto cells = static_cast<float>(std::count(covered.set.begin(), covered.set.end(), 1));
        const float share = std::min(1.f, cells / static_cast<float>(covered.set.size()));
        ++out.openings;
        out.opening_m2 += area, out.covered_m2 += area * share;
        constexpr float kMostOfAWindow = 0.05f;
        const bool clear = what.empty() || (window && share <= kMostOfAWindow);
        out.clear += clear, out.untouched += what.empty();
        if (!clear)
            out.findings.push_back({"opening", fmt::format("{} before {} in wall {}: {:.0f} % of it", what,
                                                           window ? "a window" : "a door", o.wall, 100 * share)});
    }
}

}  // namespace
}  // namespace measuring

void LayoutMeasures::add(const LayoutMeasures& o) {
    rooms += o.rooms, pieces += o.pieces, colliding += o.colliding, outside += o.outside;
    rooms_colliding += o.rooms_colliding, navigability += o.navigability;
    openings += o.openings, clear += o.clear, untouched += o.untouched, opening_m2 += o.opening_m2,
        covered_m2 += o.covered_m2;
    repeats += o.repeats;
}

LayoutMeasures measure_layout(const Plan& plan, const std::vector<Placed>& placed) {
    using namespace measuring;
    const std::vector<Solid> solids = solids_of(placed);
    LayoutMeasures out;
    out.rooms = 1;
    out.pieces = static_cast<int>(solids.size());
    std::vector<bool> collides(placed.size(), false);
    for (std::size_t i = 0; i < solids.size(); ++i)
        for (std::size_t k = i + 1; k < solids.size(); ++k) {
            const auto a = static_cast<std::size_t>(solids[i].piece), b = static_cast<std::size_t>(solids[k].piece);
            // What stands on a carpet stands in its pile.
            if (placed[a].flat || placed[b].flat || !collide(solids[i], solids[k])) continue;
            collides[a] = collides[b] = true;
            out.findings.push_back({"collision", fmt::format("{} and {}", name_of_piece(placed, solids[i].piece),
                                                             name_of_piece(placed, solids[k].piece))});
        }
    out.colliding = static_cast<int>(std::count(collides.begin(), collides.end(), true));
    out.rooms_colliding = out.colliding > 0;
    for (const Solid& solid : solids)
        if (const float share = share_outside(plan, solid); share > kOutside) {
            ++out.outside;
            out.findings.push_back(
                {"outside", fmt::format("{}: {:.0f} % of it", name_of_piece(placed, solid.piece), 100 * share)});
        }
    out.navigability = navigability_of(plan, placed, solids, out.findings);
    measure_openings(plan, placed, solids, out);
    for (const RepeatedForm& r : repeated_forms(placed)) {
        ++out.repeats;
        const std::string& form = placed[static_cast<std::size_t>(r.piece)].piece.form;
        out.findings.push_back(
            {"repeat", fmt::format("{} is like {}{}", name_of_piece(placed, r.piece), name_of_piece(placed, r.first),
                                   form.empty() ? "" : " (" + form + ")")});
    }
    return out;
}

}  // namespace fastscene

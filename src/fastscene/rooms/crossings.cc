#include "fastscene/rooms/crossings.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/layout_parts.h"
#include "fastscene/rooms/plan.h"

namespace fastscene {
namespace {

struct Bounds {
    Vec3f low{1e9f, 1e9f, 1e9f}, high{-1e9f, -1e9f, -1e9f};
    void add(Vec3f p) {
        for (std::size_t a = 0; a < 3; ++a) low[a] = std::min(low[a], p[a]), high[a] = std::max(high[a], p[a]);
    }
    bool holds(Vec3f p) const {
        return p.x >= low.x && p.y >= low.y && p.z >= low.z && p.x <= high.x && p.y <= high.y && p.z <= high.z;
    }
    bool empty() const { return !(low.x < high.x && low.y < high.y && low.z < high.z); }
    Bounds shrunk(float by) const { return {low + Vec3f{by, by, by}, high - Vec3f{by, by, by}}; }
};
Bounds common(const Bounds& a, const Bounds& b) {
    Bounds out;
    for (std::size_t i = 0; i < 3; ++i)
        out.low[i] = std::max(a.low[i], b.low[i]), out.high[i] = std::min(a.high[i], b.high[i]);
    return out;
}

using Triangle = std::array<Vec3f, 3>;

// A thing: an object, or one mesh of the shell.
struct Body {
    int object = -1;
    bool soft = false;  // others may sink into it, and it into others
    bool of_shell = false;
    bool hung = false;  // its rose is let into the ceiling
    Bounds box;
    std::vector<Triangle> triangles;
};

float distance_to_triangle(Vec3f p, const Triangle& t) {
    const Vec3f n = cross(t[1] - t[0], t[2] - t[0]);
    const float area = dot(n, n);
    const auto edge = [&](Vec3f a, Vec3f b) {
        const Vec3f d = b - a, to = p - a;
        const float l = dot(d, d), s = l > 0 ? std::clamp(dot(to, d) / l, 0.f, 1.f) : 0.f;
        return length(to - d * s);
    };
    if (area > 0 && dot(cross(t[1] - t[0], p - t[0]), n) >= 0 && dot(cross(t[2] - t[1], p - t[1]), n) >= 0 &&
        dot(cross(t[0] - t[2], p - t[2]), n) >= 0)
        return std::abs(dot(p - t[0], n)) / std::sqrt(area);
    return std::min({edge(t[0], t[1]), edge(t[1], t[2]), edge(t[2], t[0])});
}

// How many solids lie around the point: surfaces left minus surfaces entered along a line up, and along one down. A
// sheet is met on one side only, so the two disagree: it has no inside.
int solids_around(Vec3f p, const std::vector<Triangle>& triangles) {
    int up = 0, down = 0;
    // A little off, so that the line meets no edge.
    const float x = p.x + 1.3e-5f, z = p.z + 2.1e-5f;
    for (const Triangle& t : triangles) {
        const auto side = [&](Vec3f a, Vec3f b) { return (b.x - a.x) * (z - a.z) - (b.z - a.z) * (x - a.x); };
        const float a = side(t[0], t[1]), b = side(t[1], t[2]), c = side(t[2], t[0]);
        if (!((a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0))) continue;
        const float y = (t[2].y * a + t[0].y * b + t[1].y * c) / (a + b + c);
        // The normal's y has the sign of -(a + b + c).
        const int faces = a + b + c < 0 ? 1 : -1;
        (y > p.y ? up : down) += y > p.y ? faces : -faces;
    }
    return up == down ? up : 0;
}

// Points of `a` deep in `b`.
void look_inside(const Body& a, const Body& b, float tolerance, std::vector<Crossing>& found) {
    const Bounds part = common(a.box, b.box.shrunk(tolerance));
    if (part.empty()) return;
    std::vector<Triangle> column;
    for (const Triangle& t : b.triangles) {
        Bounds box;
        for (const Vec3f p : t) box.add(p);
        // A hand wider than needed for counting, so that sides near by limit the depth.
        constexpr float kBeside = 0.05f;
        if (box.low.x < part.high.x + kBeside && box.high.x > part.low.x - kBeside &&
            box.low.z < part.high.z + kBeside && box.high.z > part.low.z - kBeside)
            column.push_back(t);
    }
    if (column.empty()) return;
    Crossing deepest{a.object, b.object, {}, 0.f};
    const auto look = [&](Vec3f p) {
        if (!part.holds(p) || solids_around(p, column) <= 0) return;
        float near = 1e9f;
        for (const Triangle& t : column) {
            near = std::min(near, distance_to_triangle(p, t));
            if (near <= tolerance) return;
        }
        if (near > deepest.depth_m) deepest.depth_m = near, deepest.at = p;
    };
    constexpr float kStep = 0.02f;
    for (const Triangle& t : a.triangles) {
        Bounds box;
        for (const Vec3f p : t) box.add(p);
        if (common(box, part).low.x > common(box, part).high.x || box.low.y > part.high.y || box.high.y < part.low.y ||
            box.low.z > part.high.z || box.high.z < part.low.z)
            continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3f from = t[k], along = t[(k + 1) % 3] - from;
            const int steps = std::clamp(static_cast<int>(length(along) / kStep), 1, 400);
            for (int i = 0; i < steps; ++i) look(from + along * (static_cast<float>(i) / static_cast<float>(steps)));
        }
    }
    if (deepest.depth_m > tolerance) found.push_back(deepest);
}

bool is_soft(std::string_view kind) { return has_role(kind, Role::soft); }
bool is_hung(std::string_view kind) { return has_role(kind, Role::overhead); }

std::vector<Body> bodies_of(const Room& room) {
    std::vector<Body> objects(room.objects.size()), shell;
    for (const Mesh& mesh : room.meshes) {
        Body* body = nullptr;
        // Panelling and beams reach all around the room: their boxes say something mesh by mesh only.
        const bool part = mesh.object >= 0 && is_shell(room.objects[static_cast<std::size_t>(mesh.object)].kind);
        if (mesh.object >= 0 && !part) {
            body = &objects[static_cast<std::size_t>(mesh.object)];
            body->object = mesh.object;
            body->soft = is_soft(room.objects[static_cast<std::size_t>(mesh.object)].kind);
            body->hung = is_hung(room.objects[static_cast<std::size_t>(mesh.object)].kind);
        } else {
            body = &shell.emplace_back();
            body->object = mesh.object;
            body->of_shell = true;
        }
        for (std::size_t t = 0; t + 2 < mesh.triangles.size(); t += 3) {
            body->triangles.push_back({mesh.positions[mesh.triangles[t]], mesh.positions[mesh.triangles[t + 1]],
                                       mesh.positions[mesh.triangles[t + 2]]});
            for (const Vec3f p : body->triangles.back()) body->box.add(p);
        }
    }
    std::move(shell.begin(), shell.end(), std::back_inserter(objects));
    return objects;
}

}  // namespace

std::vector<Crossing> room_crossings(const Room& room, float tolerance) {
    const std::vector<Body> bodies = bodies_of(room);
    std::vector<Crossing> found;
    for (const Body& a : bodies)
        for (const Body& b : bodies)
            if (&a != &b && !a.soft && !b.soft && !(a.of_shell && b.of_shell) && !(a.hung && b.of_shell))
                look_inside(a, b, tolerance, found);
    return found;
}

}  // namespace fastscene

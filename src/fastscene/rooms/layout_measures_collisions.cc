// Whether two pieces cut each other, triangle by triangle.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "fastscene/rooms/layout_measures_parts.h"

namespace fastscene::measuring {
namespace {

constexpr float kGive = 0.005f;  // metres by which one of two that touch may be moved to part them; SceneEval's

struct Sized {
    Corners corners;
    Extents box;
};

// Where the segment passes through the triangle; an edge that lies in its plane does not.
std::optional<Vec3f> hit(Vec3f from, Vec3f to, const Corners& t) {
    const Vec3f e1 = t[1] - t[0], e2 = t[2] - t[0], way = to - from, h = cross(way, e2);
    const float det = dot(e1, h);
    if (std::abs(det) < 1e-12f) return {};
    const Vec3f s = from - t[0];
    const float u = dot(s, h) / det;
    if (u < 0 || u > 1) return {};
    const Vec3f q = cross(s, e1);
    const float v = dot(way, q) / det, at = dot(e2, q) / det;
    if (v < 0 || u + v > 1 || at < 0 || at > 1) return {};
    return from + way * at;
}

std::optional<Vec3f> cut(const Corners& a, const Corners& b) {
    for (std::size_t k = 0; k < 3; ++k) {
        if (const auto p = hit(a[k], a[(k + 1) % 3], b)) return p;
        if (const auto p = hit(b[k], b[(k + 1) % 3], a)) return p;
    }
    return {};
}

// The triangles near the other piece, by where they begin along x.
std::vector<Sized> near(const Solid& solid, Extents other) {
    other.low += Vec3f{-kGive, -kGive, -kGive}, other.high += Vec3f{kGive, kGive, kGive};
    std::vector<Sized> out;
    for (const Corners& t : solid.triangles) {
        Sized s{t, {}};
        for (const Vec3f p : t) s.box.add(p);
        if (s.box.meets(other)) out.push_back(s);
    }
    std::sort(out.begin(), out.end(), [](const Sized& a, const Sized& b) { return a.box.low.x < b.box.low.x; });
    return out;
}

// Where triangles of `a` and `b` cut each other with `b` moved: the first such point, or the mean of up to `most`.
std::optional<Vec3f> contact(const std::vector<Sized>& a, const std::vector<Sized>& b, Vec3f move, int most) {
    Vec3f sum{};
    int count = 0;
    std::size_t first = 0;
    float longest = 0;
    for (const Sized& t : b) longest = std::max(longest, t.box.high.x - t.box.low.x);
    for (const Sized& s : a) {
        while (first < b.size() && b[first].box.low.x + move.x + longest < s.box.low.x) ++first;
        for (std::size_t i = first; i < b.size() && b[i].box.low.x + move.x <= s.box.high.x; ++i) {
            Extents box = b[i].box;
            box.low += move, box.high += move;
            if (!box.meets(s.box)) continue;
            const Corners moved{b[i].corners[0] + move, b[i].corners[1] + move, b[i].corners[2] + move};
            if (const auto p = cut(s.corners, moved)) {
                sum += *p;
                if (++count >= most) return sum / static_cast<float>(count);
            }
        }
    }
    if (count == 0) return {};
    return sum / static_cast<float>(count);
}

// How often the surface goes around the point (Jacobson et al. 2013): 1 inside of what is closed, 0 outside.
double winding(Vec3f p, const Solid& solid) {
    double sum = 0;
    for (const Corners& t : solid.triangles) {
        const Vec3f a = t[0] - p, b = t[1] - p, c = t[2] - p;
        const double la = length(a), lb = length(b), lc = length(c);
        const double up = dot(a, cross(b, c));
        const double down = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
        sum += std::atan2(up, down);
    }
    return sum / (2 * std::numbers::pi);
}

bool lies_in(const Solid& a, const Solid& b) {
    constexpr double kInside = 0.5;  // of a turn: open seams count for little
    return a.box.within(b.box) && !a.triangles.empty() && std::abs(winding(a.triangles[0][0], b)) > kInside;
}

}  // namespace

bool collide(const Solid& a, const Solid& b) {
    if (!a.box.meets(b.box)) return false;
    const std::vector<Sized> some = near(a, b.box), others = near(b, a.box);
    constexpr int kForMean = 64;  // contacts whose middle says which way they part
    const auto touch = contact(some, others, {}, kForMean);
    if (!touch) return lies_in(a, b) || lies_in(b, a);
    const Vec3f middle = (b.box.low + b.box.high) * 0.5f;
    std::vector<Vec3f> ways{normalize(middle - *touch)};
    for (const float s : {1.f, -1.f})
        for (const Vec3f axis : {Vec3f{0, 1, 0}, Vec3f{1, 0, 0}, Vec3f{0, 0, 1}}) ways.push_back(axis * s);
    return std::all_of(ways.begin(), ways.end(),
                       [&](Vec3f way) { return contact(some, others, way * kGive, 1).has_value(); });
}

}  // namespace fastscene::measuring

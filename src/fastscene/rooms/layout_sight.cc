#include "fastscene/rooms/layout_sight.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace fastscene {
namespace {

Vec3f into_object(const Placed& p, Vec3f v) {
    const Vec3f d = v - p.position;
    return {dot(d, right_of(p.yaw)), d.y, dot(d, front_of(p.yaw))};
}
Vec3f out_of_object(const Placed& p, Vec3f v) {
    return p.position + right_of(p.yaw) * v.x + Vec3f{0, v.y, 0} + front_of(p.yaw) * v.z;
}

// Whether the line from a to a + d meets the box between its ends.
bool meets(Vec3f low, Vec3f high, Vec3f a, Vec3f d) {
    float t0 = 0, t1 = 1;
    for (std::size_t k = 0; k < 3; ++k) {
        if (std::abs(d[k]) < 1e-9f) {
            if (a[k] < low[k] || a[k] > high[k]) return false;
            continue;
        }
        const float u = (low[k] - a[k]) / d[k], v = (high[k] - a[k]) / d[k];
        t0 = std::max(t0, std::min(u, v));
        t1 = std::min(t1, std::max(u, v));
    }
    return t0 <= t1;
}

// Möller and Trumbore 1997; from either side, before `end`.
bool crosses(Vec3f p0, Vec3f p1, Vec3f p2, Vec3f a, Vec3f d, float end) {
    const Vec3f u = p1 - p0, v = p2 - p0, h = cross(d, v);
    const float det = dot(u, h);
    if (std::abs(det) < 1e-12f) return false;
    const Vec3f s = a - p0, q = cross(s, u);
    const float b = dot(s, h) / det, c = dot(d, q) / det, t = dot(v, q) / det;
    return b >= 0 && c >= 0 && b + c <= 1 && t > 0 && t < end;
}

// Points spread evenly over the triangles of a piece, in its own frame, each for the same share of the area.
class Points {
  public:
    explicit Points(const Piece& piece) {
        for (const Mesh& m : piece.meshes)
            for (std::size_t t = 0; t + 2 < m.triangles.size(); t += 3) {
                const Vec3f a = m.positions[m.triangles[t]], u = m.positions[m.triangles[t + 1]] - a,
                            v = m.positions[m.triangles[t + 2]] - a;
                const Vec3f n = cross(u, v);
                if (!(length(n) > 0)) continue;
                sum_ += 0.5 * length(n);
                triangles_.push_back({a, u, v, normalize(n), sum_});
            }
    }
    float area() const { return static_cast<float>(sum_); }
    bool empty() const { return triangles_.empty(); }
    struct Point {
        Vec3f at, normal;
    };
    // Additive recurrence: any number of first points is spread evenly.
    Point operator[](int i) const {
        const auto part = [i](double step) { return std::fmod(0.5 + step * (i + 1), 1.0); };
        const double along = part(0.8191725133961645) * sum_;
        const auto t = std::lower_bound(triangles_.begin(), triangles_.end() - 1, along,
                                        [](const Triangle& x, double s) { return x.until < s; });
        auto b = static_cast<float>(part(0.6710436067037893)), c = static_cast<float>(part(0.5497004779019702));
        if (b + c > 1) b = 1 - b, c = 1 - c;
        return {t->corner + t->u * b + t->v * c, t->normal};
    }

  private:
    struct Triangle {
        Vec3f corner, u, v, normal;
        double until;
    };
    std::vector<Triangle> triangles_;
    double sum_ = 0;
};

}  // namespace

Sight::Sight(const Plan& plan, const std::vector<Placed>& placed) : plan_(plan), placed_(placed) {
    for (const Placed& p : placed) {
        Body body;
        for (const Mesh& m : p.piece.meshes) {
            Box box;
            for (const Vec3f v : m.positions)
                for (std::size_t k = 0; k < 3; ++k)
                    box.low[k] = std::min(box.low[k], v[k]), box.high[k] = std::max(box.high[k], v[k]);
            for (std::size_t k = 0; k < 3; ++k)
                body.box.low[k] = std::min(body.box.low[k], box.low[k]),
                body.box.high[k] = std::max(body.box.high[k], box.high[k]);
            body.meshes.push_back(box);
        }
        bodies_.push_back(std::move(body));
    }
    for (const Block& b : plan.blocks)
        if (!cuts_corner(b) && b.kind != Block::Kind::stairs)  // the room is convex there
            blocks_.push_back({(b.low + b.high) * 0.5f, (b.high - b.low) * 0.5f, 0, 0, plan.height});
    constexpr float kOn = 0.01f;  // what stands on a platform is not hidden by it
    for (const Platform& p : plan.platforms)
        blocks_.push_back({(p.low + p.high) * 0.5f, (p.high - p.low) * 0.5f, 0, 0, p.height - kOn});
}

bool Sight::stops(std::size_t piece, Vec3f eye, Vec3f target) const {
    const Placed& p = placed_[piece];
    const Body& body = bodies_[piece];
    const Vec3f a = into_object(p, eye), d = into_object(p, target) - a;
    if (!meets(body.box.low, body.box.high, a, d)) return false;
    constexpr float kNear = 0.0015f;  // metres before the target: what it lies on itself
    const float end = 1.f - kNear / length(d);
    for (std::size_t k = 0; k < body.meshes.size(); ++k) {
        if (!meets(body.meshes[k].low, body.meshes[k].high, a, d)) continue;
        const Mesh& m = p.piece.meshes[k];
        for (std::size_t t = 0; t + 2 < m.triangles.size(); t += 3)
            if (crosses(m.positions[m.triangles[t]], m.positions[m.triangles[t + 1]], m.positions[m.triangles[t + 2]],
                        a, d, end))
                return true;
    }
    return false;
}

int Sight::hider(int own, Vec3f eye, Vec3f target) const {
    for (const Footprint& b : blocks_)
        if (passes(b, eye, target)) return -2;
    if (stops(static_cast<std::size_t>(own), eye, target)) return own;
    for (std::size_t i = 0; i < placed_.size(); ++i)
        if (static_cast<int>(i) != own && stops(i, eye, target)) return static_cast<int>(i);
    return -1;
}

Sight::View Sight::look(int piece, Vec3f eye) const {
    const Placed& p = placed_[static_cast<std::size_t>(piece)];
    const Points points(p.piece);
    View view;
    if (points.empty()) return view;
    constexpr int kPoints = 64, kEnoughForLarge = 12;
    constexpr float kPixel = 2 * std::numbers::pi_v<float> / 512.f;  // radians, both ways
    float seen = 0;                                                  // square pixels
    std::map<int, float> hidden;
    int n = 0;
    for (; n < kPoints && !(n >= kEnoughForLarge && seen * points.area() > kMany * static_cast<float>(n)); ++n) {
        const auto point = points[n];
        const Vec3f at = out_of_object(p, point.at), normal = out_of_object(p, point.normal) - p.position,
                    to = at - eye;
        const float far = length(to), level = std::hypot(to.x, to.z) / far;
        if (!(far > 0.05f)) continue;
        // Pixels of a panorama are narrower towards its poles.
        const float size = std::abs(dot(normal, to)) / (far * far * far) / (kPixel * kPixel * std::max(0.05f, level));
        const int by = hider(piece, eye, at);
        if (by == -1) seen += size;
        else if (by != piece) hidden[by] += size;
    }
    view.pixels = std::min(kMany, seen * points.area() / static_cast<float>(n));
    std::vector<std::pair<float, int>> order;
    float covered = 0;
    for (const auto& [by, size] : hidden) covered += size;
    view.share = seen > 0 ? seen / (seen + covered) : 0;
    for (const auto& [by, size] : hidden)
        if (by >= 0) order.push_back({-size, by});
    std::sort(order.begin(), order.end());
    for (const auto& [size, by] : order) view.hiders.push_back(by);
    return view;
}

}  // namespace fastscene

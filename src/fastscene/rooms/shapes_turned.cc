// Surfaces of revolution, rods and tubes.
#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/rooms/shapes_parts.h"

namespace fastscene::shapes {
namespace {

// A surface of revolution's band between two rings; ring vertices are made anew when the corner is sharp.
struct RingMaker {
    Mesh& m;
    int sides;
    std::uint32_t add(Vec2f p, Vec2f n) {
        const auto first = static_cast<std::uint32_t>(m.positions.size());
        for (int i = 0; i <= sides; ++i) {
            const float a = 2.f * kPi * static_cast<float>(i % sides) / static_cast<float>(sides);
            vertex(m, {p.x * std::cos(a), p.y, p.x * std::sin(a)},
                   normalize(Vec3f{n.x * std::cos(a), n.y, n.x * std::sin(a)}));
        }
        return first;
    }
    void join(std::uint32_t low, std::uint32_t high) {
        for (int i = 0; i < sides; ++i) {
            const auto k = static_cast<std::uint32_t>(i);
            quad(m, low + k, high + k, high + k + 1, low + k + 1);
        }
    }
};

// The outside of a turned profile; no caps of its own.
void turn_profile(Mesh& m, std::span<const Vec2f> profile, int sides, bool smooth) {
    RingMaker rings{m, sides};
    const std::size_t count = profile.size();
    std::vector<Vec2f> side(count - 1);
    for (std::size_t i = 0; i + 1 < count; ++i) {
        const Vec2f d = profile[i + 1] - profile[i];
        side[i] = unit2({d.y, -d.x});
    }
    std::uint32_t last = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2f before = side[i > 0 ? i - 1 : 0], after = side[std::min(i, count - 2)];
        const bool sharp = !smooth && dot(before, after) < 0.82f;
        if (i == 0) {
            last = rings.add(profile[i], after);
            continue;
        }
        const Vec2f mean = unit2(before + after);
        const std::uint32_t here = rings.add(profile[i], sharp ? before : mean);
        rings.join(last, here);
        last = sharp && i + 1 < count ? rings.add(profile[i], after) : here;
    }
}

}  // namespace

Mesh lathe(std::span<const Vec2f> profile, int sides, bool smooth) {
    Mesh m;
    std::vector<Vec2f> closed(profile.begin(), profile.end());
    if (closed.front().x > 1e-5f) closed.insert(closed.begin(), {0.f, closed.front().y});
    if (closed.back().x > 1e-5f) closed.push_back({0.f, closed.back().y});
    turn_profile(m, closed, sides, smooth);
    drop_slivers(m);
    lay_grain(m);
    return m;
}

Mesh vessel(std::span<const Vec2f> profile, float wall, int sides) {
    std::vector<Vec2f> all(profile.begin(), profile.end());
    if (all.front().x > 1e-5f) all.insert(all.begin(), {0.f, all.front().y});
    for (std::size_t i = profile.size(); i-- > 0;)
        if (profile[i].x > 1.5f * wall)
            all.push_back({profile[i].x - wall, std::max(profile[i].y, profile.front().y + wall)});
    all.push_back({0.f, profile.front().y + wall});
    Mesh m;
    turn_profile(m, all, sides, false);
    drop_slivers(m);
    lay_grain(m);
    return m;
}

Mesh shade(std::span<const Vec2f> profile, int sides) {
    Mesh m;
    turn_profile(m, profile, sides, true);
    drop_slivers(m);
    lay_grain(m);
    return m;
}

std::vector<Vec2f> curve(std::span<const Vec2f> points, int steps) {
    std::vector<Vec2f> out;
    const auto last = points.size() - 1;
    for (std::size_t i = 0; i < last; ++i) {
        const Vec2f p0 = points[i > 0 ? i - 1 : 0], p1 = points[i], p2 = points[i + 1],
                    p3 = points[std::min(i + 2, last)];
        for (int k = 0; k < steps; ++k) {
            const float t = static_cast<float>(k) / static_cast<float>(steps);
            out.push_back((p1 * 2.f + (p2 - p0) * t + (p0 * 2.f - p1 * 5.f + p2 * 4.f - p3) * (t * t) +
                           (p1 * 3.f - p0 - p2 * 3.f + p3) * (t * t * t)) *
                          0.5f);
        }
    }
    out.push_back(points[last]);
    return out;
}

Mesh rod(Vec3f a, Vec3f b, float ra, float rb, int sides) {
    const float l = length(b - a), ea = std::min(0.35f * ra, 0.2f * l), eb = std::min(0.35f * rb, 0.2f * l);
    const std::array<Vec2f, 4> profile{Vec2f{ra - ea, 0.f}, Vec2f{ra, ea}, Vec2f{rb, l - eb}, Vec2f{rb - eb, l}};
    Mesh m = lathe(profile, sides);
    const Vec3f y = normalize(b - a);
    Vec3f s, t;
    make_frame(y, s, t);
    const Mat3f r = Mat3f::from_columns(t, y, s);
    for (auto& p : m.positions) p = r * p + a;
    for (auto& n : m.normals) n = r * n;
    return m;
}

Mesh ball(Vec3f center, Vec3f radii, int sides) {
    std::vector<Vec2f> profile;
    const int rows = std::max(4, sides / 2);
    for (int i = 0; i <= rows; ++i) {
        const float t = kPi * static_cast<float>(i) / static_cast<float>(rows);
        profile.push_back({i == 0 || i == rows ? 0.f : std::sin(t), -std::cos(t)});
    }
    Mesh m = lathe(profile, sides, true);
    for (std::size_t i = 0; i < m.positions.size(); ++i) {
        const Vec3f unit = m.positions[i];
        m.normals[i] = normalize(Vec3f{unit.x / radii.x, unit.y / radii.y, unit.z / radii.z});
        m.positions[i] = unit * radii + center;
    }
    lay_grain(m);
    return m;
}

Mesh tube(std::span<const Vec3f> path, float radius, int sides) {
    Mesh m;
    Vec3f s, t;
    make_frame(normalize(path[1] - path[0]), s, t);
    std::vector<std::uint32_t> rings;
    float run = 0.f;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const Vec3f d = normalize(path[std::min(i + 1, path.size() - 1)] - path[i > 0 ? i - 1 : 0]);
        s = normalize(s - d * dot(s, d));
        t = cross(d, s);
        if (i > 0) run += length(path[i] - path[i - 1]);
        rings.push_back(static_cast<std::uint32_t>(m.positions.size()));
        for (int k = 0; k <= sides; ++k) {
            const float a = 2.f * kPi * static_cast<float>(k % sides) / static_cast<float>(sides);
            const Vec3f n = s * std::cos(a) + t * std::sin(a);
            vertex(m, path[i] + n * radius, n);
            m.coords.push_back({radius * std::cos(a), run, radius * std::sin(a)});
        }
    }
    for (std::size_t i = 0; i + 1 < rings.size(); ++i)
        for (int k = 0; k < sides; ++k) {
            const auto j = static_cast<std::uint32_t>(k);
            quad(m, rings[i] + j, rings[i] + j + 1, rings[i + 1] + j + 1, rings[i + 1] + j);
        }
    for (int end = 0; end < 2; ++end) {
        const std::uint32_t ring = end ? rings.back() : rings.front();
        const Vec3f c = end ? path.back() : path.front();
        const Vec3f n = normalize(end ? path[path.size() - 1] - path[path.size() - 2] : path[0] - path[1]);
        const std::uint32_t hub = vertex(m, c, n);
        m.coords.push_back({0, end ? run : 0.f, 0});
        for (int k = 0; k < sides; ++k) {
            const auto j = static_cast<std::uint32_t>(k);
            if (end) triangle(m, hub, ring + j, ring + j + 1);
            else triangle(m, hub, ring + j + 1, ring + j);
        }
    }
    return m;
}

Mesh ring(float radius, float thickness, int sides) {
    std::vector<Vec2f> profile;
    for (int i = 0; i <= 10; ++i) {
        const float a = 2.f * kPi * static_cast<float>(i % 10) / 10.f;
        profile.push_back({radius + 0.5f * thickness * std::cos(a), 0.5f * thickness * std::sin(a)});
    }
    Mesh m;
    turn_profile(m, profile, sides, true);
    drop_slivers(m);
    lay_grain(m);
    return m;
}

}  // namespace fastscene::shapes

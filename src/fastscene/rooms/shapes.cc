#include "fastscene/rooms/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "fastscene/base/random.h"

namespace fastscene::shapes {
namespace {

float cell(int x, int y, int z, std::uint32_t seed) {
    const auto key = (static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)) << 42) ^
                     (static_cast<std::uint64_t>(static_cast<std::uint32_t>(y)) << 21) ^ static_cast<std::uint32_t>(z) ^
                     (static_cast<std::uint64_t>(seed) << 32);
    return static_cast<float>(mix64(key) >> 40) * 0x1p-23f - 1.f;
}

void triangle(Mesh& m, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a == b || b == c || a == c) return;
    m.triangles.insert(m.triangles.end(), {a, b, c});
}
void quad(Mesh& m, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    triangle(m, a, b, c);
    triangle(m, a, c, d);
}
std::uint32_t vertex(Mesh& m, Vec3f p, Vec3f n) {
    m.positions.push_back(p);
    m.normals.push_back(n);
    return static_cast<std::uint32_t>(m.positions.size() - 1);
}

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

Vec2f unit2(Vec2f v) {
    const float l = length(v);
    return l > 1e-9f ? v * (1.f / l) : Vec2f{1, 0};
}

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

void drop_slivers(Mesh& m) {
    std::vector<std::uint32_t> kept;
    for (std::size_t t = 0; t < m.triangles.size(); t += 3) {
        const Vec3f a = m.positions[m.triangles[t]], b = m.positions[m.triangles[t + 1]],
                    c = m.positions[m.triangles[t + 2]];
        // Relative to the edges: with fused multiply-add the cross product of equal edges is small, not zero.
        const float longest = std::max(dot(b - a, b - a), std::max(dot(c - a, c - a), dot(c - b, c - b)));
        if (length(cross(b - a, c - a)) > 1e-5f * longest)
            kept.insert(kept.end(), m.triangles.begin() + static_cast<long>(t),
                        m.triangles.begin() + static_cast<long>(t) + 3);
    }
    m.triangles = std::move(kept);
}

// The cube's surface as six grids; map() turns a point of the cube [-1, 1]^3 into (position, normal).
Mesh cube_surface(const std::array<std::vector<float>, 3>& lines,
                  const std::function<void(Vec3f, Vec3f&, Vec3f&)>& map) {
    Mesh m;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end) {
            const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
            const auto first = static_cast<std::uint32_t>(m.positions.size());
            for (const float b : lines[v])
                for (const float a : lines[u]) {
                    Vec3f q, p, n;
                    q[axis] = end ? 1.f : -1.f;
                    q[u] = a;
                    q[v] = b;
                    map(q, p, n);
                    vertex(m, p, n);
                }
            const auto w = static_cast<std::uint32_t>(lines[u].size()), h = static_cast<std::uint32_t>(lines[v].size());
            for (std::uint32_t j = 0; j + 1 < h; ++j)
                for (std::uint32_t i = 0; i + 1 < w; ++i) {
                    const std::uint32_t a = first + j * w + i;
                    if (end) quad(m, a, a + 1, a + w + 1, a + w);
                    else quad(m, a, a + w, a + w + 1, a + 1);
                }
        }
    return m;
}

}  // namespace

float wobble(Vec3f p, std::uint32_t seed) {
    const float fx = std::floor(p.x), fy = std::floor(p.y), fz = std::floor(p.z);
    const int x = static_cast<int>(fx), y = static_cast<int>(fy), z = static_cast<int>(fz);
    const auto ease = [](float t) { return t * t * (3.f - 2.f * t); };
    const float u = ease(p.x - fx), v = ease(p.y - fy), w = ease(p.z - fz);
    const auto mix = [](float a, float b, float t) { return a + (b - a) * t; };
    const auto layer = [&](int k) {
        return mix(mix(cell(x, y, k, seed), cell(x + 1, y, k, seed), u),
                   mix(cell(x, y + 1, k, seed), cell(x + 1, y + 1, k, seed), u), v);
    };
    return mix(layer(z), layer(z + 1), w);
}

Mesh box(Vec3f size, float bevel) {
    const float b = std::min(bevel, 0.45f * min_component(size));
    std::array<std::vector<float>, 3> lines;
    for (std::size_t k = 0; k < 3; ++k) lines[k] = {-1.f, -1.f + 2.f * b / size[k], 1.f - 2.f * b / size[k], 1.f};
    const Vec3f inner = size * 0.5f - Vec3f{b, b, b};
    // The outer ring of each face's grid lies on the chamfer's middle, which the neighbouring faces share.
    Mesh m = cube_surface(lines, [&](Vec3f q, Vec3f& p, Vec3f& n) {
        const Vec3f full = q * (size * 0.5f);
        Vec3f core = full, over;
        for (std::size_t k = 0; k < 3; ++k) {
            core[k] = std::clamp(full[k], -inner[k], inner[k]);
            over[k] = full[k] - core[k];
            if (std::fabs(over[k]) < 1e-7f) over[k] = 0.f;
        }
        n = normalize(over);
        p = core + n * b;
    });
    drop_slivers(m);
    lay_grain(m);
    return m;
}

Mesh soft_box(Vec3f size, const Soft& soft) {
    const float r = std::min(soft.round_m, 0.49f * min_component(size)),
                puff = std::min(soft.puff_m, 0.3f * min_component(size));
    const float longest = max_component(size);
    std::array<std::vector<float>, 3> lines;
    for (std::size_t k = 0; k < 3; ++k) {
        const float c = std::min(0.98f, 2.f * r / size[k]);
        const int flat = std::clamp(static_cast<int>(static_cast<float>(soft.steps) * size[k] / longest), 1,
                                    soft.steps);
        constexpr int kRound = 3;
        for (int i = 0; i < kRound; ++i) lines[k].push_back(-1.f + c * static_cast<float>(i) / kRound);
        for (int i = 0; i <= flat; ++i)
            lines[k].push_back(-1.f + c + (2.f - 2.f * c) * static_cast<float>(i) / static_cast<float>(flat));
        for (int i = kRound - 1; i >= 0; --i) lines[k].push_back(-lines[k][static_cast<std::size_t>(i)]);
    }
    const Vec3f half = size * 0.5f - Vec3f{puff, puff, puff} * 0.7f;
    const Vec3f inner = {std::max(half.x - r, 0.f), std::max(half.y - r, 0.f), std::max(half.z - r, 0.f)};
    Mesh m = cube_surface(lines, [&](Vec3f q, Vec3f& p, Vec3f& n) {
        const Vec3f full = q * half;
        Vec3f over;
        Vec3f core;
        for (std::size_t k = 0; k < 3; ++k) {
            core[k] = std::clamp(full[k], -inner[k], inner[k]);
            over[k] = full[k] - core[k];
        }
        n = normalize(over);
        p = core + n * r;
        const auto dome = [](float a, float b) { return (1.f - a * a) * (1.f - b * b); };
        const Vec3f bulge{n.x * dome(q.y, q.z), n.y * dome(q.x, q.z), n.z * dome(q.x, q.y)};
        p += bulge * puff * 0.7f;
        const Vec3f s{17.f, 17.f, 17.f};
        const float fold = wobble(p * s, soft.seed) + 0.5f * wobble(p * (s * 2.3f), soft.seed + 7);
        p += n * (soft.wrinkle_m * (fold - 1.f) * 0.6f);
    });
    drop_slivers(m);
    // The six grids share their rims in space only: normals are taken from the whole, by place.
    smooth_normals(m);
    lay_grain(m);
    return m;
}

Mesh pillow(Vec3f size, std::uint32_t seed, int steps) {
    const auto line = [&](int i) { return -1.f + 2.f * static_cast<float>(i) / static_cast<float>(steps); };
    Mesh m;
    for (int side = 0; side < 2; ++side) {
        const auto first = static_cast<std::uint32_t>(m.positions.size());
        for (int j = 0; j <= steps; ++j)
            for (int i = 0; i <= steps; ++i) {
                const float a = line(i), b = line(j);
                const float body = std::pow(std::max(0.f, (1.f - a * a) * (1.f - b * b)), 0.42f);
                // The rim draws in between the corners, and the cloth puckers towards it.
                const float in_x = 1.f - 0.07f * (1.f - b * b), in_y = 1.f - 0.07f * (1.f - a * a);
                const Vec3f base{0.5f * size.x * a * in_x, 0.5f * size.y * (1.f + b * in_y), 0.f};
                const float crease = 1.f + 0.1f * wobble(base * 11.f + Vec3f{0, 0, static_cast<float>(side)}, seed) +
                                     0.05f * wobble(base * 28.f, seed + 3);
                const float z = 0.46f * size.z * body * crease;
                vertex(m, base + Vec3f{0, 0, side ? -z : z}, {0, 0, 1});
            }
        const auto w = static_cast<std::uint32_t>(steps + 1);
        for (std::uint32_t j = 0; j + 1 < w; ++j)
            for (std::uint32_t i = 0; i + 1 < w; ++i) {
                const std::uint32_t a = first + j * w + i;
                if (side) quad(m, a, a + w, a + w + 1, a + 1);
                else quad(m, a, a + 1, a + w + 1, a + w);
            }
    }
    smooth_normals(m);
    lay_grain(m);
    return m;
}

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

Mesh prism(std::span<const Vec2f> outline, float y0, float y1, float bevel) {
    Mesh m;
    const auto count = outline.size();
    const float b = std::min(bevel, 0.45f * (y1 - y0));
    Vec2f middle{};
    for (const Vec2f p : outline) middle = middle + p * (1.f / static_cast<float>(count));
    std::vector<Vec2f> out(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2f d = outline[(i + 1) % count] - outline[(i + count - 1) % count];
        out[i] = unit2({-d.y, d.x});
        if (dot(out[i], outline[i] - middle) < 0.f) out[i] = out[i] * -1.f;
    }
    // Area's sign tells which way the outline runs; sides are wound so that they face outward.
    float area = 0.f;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2f p = outline[i], q = outline[(i + 1) % count];
        area += p.x * q.y - q.x * p.y;
    }
    const auto add_ring = [&](float inset, float y, Vec3f up) {
        const auto first = static_cast<std::uint32_t>(m.positions.size());
        for (std::size_t i = 0; i < count; ++i) {
            const Vec2f p = outline[i] - out[i] * inset;
            vertex(m, {p.x, y, p.y}, normalize(Vec3f{out[i].x, 0, out[i].y} * (1.f - std::fabs(up.y)) + up));
        }
        return first;
    };
    const auto n = static_cast<std::uint32_t>(count);
    const auto join = [&](std::uint32_t low, std::uint32_t high) {
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t j = (i + 1) % n;
            if (area > 0.f) quad(m, low + i, high + i, high + j, low + j);
            else quad(m, low + i, low + j, high + j, high + i);
        }
    };
    const auto fan = [&](std::uint32_t ring, bool top, float y) {
        const std::uint32_t hub = vertex(m, {middle.x, y, middle.y}, {0, top ? 1.f : -1.f, 0});
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t j = (i + 1) % n;
            if ((area > 0.f) == top) triangle(m, hub, ring + j, ring + i);
            else triangle(m, hub, ring + i, ring + j);
        }
    };
    const auto bottom_inner = add_ring(b, y0, {0, -1, 0}), bottom = add_ring(0.f, y0 + b, {}),
               top = add_ring(0.f, y1 - b, {}), top_inner = add_ring(b, y1, {0, 1, 0});
    join(bottom_inner, bottom);
    join(bottom, top);
    join(top, top_inner);
    fan(top_inner, true, y1);
    fan(bottom_inner, false, y0);
    drop_slivers(m);
    lay_grain(m);
    return m;
}

std::vector<Vec2f> rounded_rectangle(float width, float depth, float radius, int steps) {
    std::vector<Vec2f> out;
    const float r = std::min(radius, 0.499f * std::min(width, depth));
    for (int c = 0; c < 4; ++c) {
        const Vec2f center{(c == 0 || c == 3 ? 1.f : -1.f) * (0.5f * width - r),
                           (c < 2 ? 1.f : -1.f) * (0.5f * depth - r)};
        for (int i = 0; i <= steps; ++i) {
            const float a = 0.5f * kPi * (static_cast<float>(c) + static_cast<float>(i) / static_cast<float>(steps));
            out.push_back(center + Vec2f{r * std::cos(a), r * std::sin(a)});
        }
    }
    return out;
}
std::vector<Vec2f> circle(float radius, int steps) {
    std::vector<Vec2f> out;
    for (int i = 0; i < steps; ++i) {
        const float a = 2.f * kPi * static_cast<float>(i) / static_cast<float>(steps);
        out.push_back({radius * std::cos(a), radius * std::sin(a)});
    }
    return out;
}

namespace {

// How far a point is from the limbs' common skin (negative inside): the polynomial smooth minimum of their distances.
float distance_to_skin(std::span<const Limb> limbs, float flow, Vec3f p) {
    float least = 1e9f;
    for (const Limb& l : limbs) {
        const Vec3f along = l.b - l.a;
        const float far = dot(along, along), t = far > 1e-12f ? std::clamp(dot(p - l.a, along) / far, 0.f, 1.f) : 0.f;
        const float d = length(p - (l.a + along * t)) - (l.ra + (l.rb - l.ra) * t);
        const float h = std::max(flow - std::abs(d - least), 0.f) / flow;
        least = std::min(least, d) - 0.25f * h * h * flow;
    }
    return least;
}

}  // namespace

Mesh skin(std::span<const Limb> limbs, float flow_m, float cell_m) {
    Box box;
    for (const Limb& l : limbs)
        for (const auto& [at, r] : {std::pair{l.a, l.ra}, {l.b, l.rb}})
            for (std::size_t k = 0; k < 3; ++k)
                box.low[k] = std::min(box.low[k], at[k] - r), box.high[k] = std::max(box.high[k], at[k] + r);
    std::array<int, 3> n{};
    for (std::size_t k = 0; k < 3; ++k)
        box.low[k] -= flow_m, n[k] = static_cast<int>((box.high[k] + flow_m - box.low[k]) / cell_m) + 2;
    const auto index = [&](int x, int y, int z) { return static_cast<std::size_t>((z * n[1] + y) * n[0] + x); };
    const auto point = [&](int x, int y, int z) {
        return box.low + Vec3f{static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)} * cell_m;
    };
    std::vector<float> field(static_cast<std::size_t>(n[0] * n[1] * n[2]));
    for (int z = 0; z < n[2]; ++z)
        for (int y = 0; y < n[1]; ++y)
            for (int x = 0; x < n[0]; ++x) field[index(x, y, z)] = distance_to_skin(limbs, flow_m, point(x, y, z));
    // Each cell in six tetrahedra about its diagonal; their cut edges, shared by neighbours, are the vertices.
    static constexpr std::array<std::array<int, 4>, 6> kTetrahedra{
        {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};
    Mesh m;
    std::map<std::pair<std::size_t, std::size_t>, std::uint32_t> cuts;
    for (int z = 0; z + 1 < n[2]; ++z)
        for (int y = 0; y + 1 < n[1]; ++y)
            for (int x = 0; x + 1 < n[0]; ++x) {
                std::array<std::size_t, 8> id{};
                std::array<Vec3f, 8> at{};
                int inside = 0;
                for (int c = 0; c < 8; ++c) {
                    const int cx = x + (c & 1), cy = y + (c >> 1 & 1), cz = z + (c >> 2 & 1);
                    const auto k = static_cast<std::size_t>(c);
                    id[k] = index(cx, cy, cz), at[k] = point(cx, cy, cz), inside += field[id[k]] < 0;
                }
                if (inside == 0 || inside == 8) continue;
                const auto cut = [&](int a, int b) {
                    auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
                    if (id[i] > id[j]) std::swap(i, j);
                    const auto [found, fresh] = cuts.try_emplace({id[i], id[j]},
                                                                 static_cast<std::uint32_t>(m.positions.size()));
                    if (fresh) {
                        const float t = field[id[i]] / (field[id[i]] - field[id[j]]);
                        m.positions.push_back(lerp(at[i], at[j], std::clamp(t, 0.02f, 0.98f)));
                    }
                    return found->second;
                };
                for (const std::array<int, 4>& t : kTetrahedra) {
                    std::array<int, 4> in{}, out{};
                    std::size_t ins = 0, outs = 0;
                    for (const int c : t) (field[id[static_cast<std::size_t>(c)]] < 0 ? in[ins++] : out[outs++]) = c;
                    if (ins == 0 || outs == 0) continue;
                    const Vec3f outward = at[static_cast<std::size_t>(out[0])] - at[static_cast<std::size_t>(in[0])];
                    const auto face = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
                        if (dot(cross(m.positions[b] - m.positions[a], m.positions[c] - m.positions[a]), outward) < 0)
                            std::swap(b, c);
                        m.triangles.insert(m.triangles.end(), {a, b, c});
                    };
                    if (ins == 1) face(cut(in[0], out[0]), cut(in[0], out[1]), cut(in[0], out[2]));
                    else if (outs == 1) face(cut(in[0], out[0]), cut(in[1], out[0]), cut(in[2], out[0]));
                    else {
                        const std::uint32_t a = cut(in[0], out[0]), b = cut(in[0], out[1]), c = cut(in[1], out[1]),
                                            d = cut(in[1], out[0]);
                        face(a, b, c), face(a, c, d);
                    }
                }
            }
    // The field's slope is the normal.
    const float step = 0.3f * cell_m;
    for (const Vec3f& p : m.positions) {
        Vec3f slope;
        for (std::size_t k = 0; k < 3; ++k) {
            Vec3f d{};
            d[k] = step;
            slope[k] = distance_to_skin(limbs, flow_m, p + d) - distance_to_skin(limbs, flow_m, p - d);
        }
        m.normals.push_back(normalize(slope));
    }
    m.coords = m.positions;
    return m;
}

Mesh sheet(int columns, int rows, const std::function<Vec3f(float, float)>& point) {
    Mesh m;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i)
            vertex(m,
                   point(static_cast<float>(i) / static_cast<float>(columns),
                         static_cast<float>(j) / static_cast<float>(rows)),
                   {0, 1, 0});
    const auto w = static_cast<std::uint32_t>(columns + 1);
    for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(rows); ++j)
        for (std::uint32_t i = 0; i + 1 < w; ++i) {
            const std::uint32_t a = j * w + i;
            quad(m, a, a + 1, a + w + 1, a + w);
        }
    smooth_normals(m);
    lay_grain(m);
    return m;
}

Mesh slab(int columns, int rows, float thickness, const std::function<Vec3f(float, float)>& point) {
    Mesh m = sheet(columns, rows, point);
    const auto count = static_cast<std::uint32_t>(m.positions.size());
    const std::vector<std::uint32_t> front = m.triangles;
    for (std::uint32_t i = 0; i < count; ++i) vertex(m, m.positions[i] - m.normals[i] * thickness, -m.normals[i]);
    for (std::size_t t = 0; t < front.size(); t += 3)
        triangle(m, front[t] + count, front[t + 2] + count, front[t + 1] + count);
    const auto w = static_cast<std::uint32_t>(columns + 1), h = static_cast<std::uint32_t>(rows + 1);
    const auto rim = [&](std::uint32_t a, std::uint32_t b) {
        const std::uint32_t old[] = {b, a, a + count, b + count};
        const Vec3f n = normalize(
            cross(m.positions[old[1]] - m.positions[old[0]], m.positions[old[2]] - m.positions[old[0]]));
        std::uint32_t made[4];
        for (int i = 0; i < 4; ++i)
            made[i] = vertex(m, Vec3f(m.positions[old[i]]), length(n) > 0.5f ? n : m.normals[old[i]]);
        quad(m, made[0], made[1], made[2], made[3]);
    };
    for (std::uint32_t i = 0; i + 1 < w; ++i) {
        rim(i, i + 1);
        rim((h - 1) * w + i + 1, (h - 1) * w + i);
    }
    for (std::uint32_t j = 0; j + 1 < h; ++j) {
        rim((j + 1) * w, j * w);
        rim(j * w + w - 1, (j + 1) * w + w - 1);
    }
    lay_grain(m);
    return m;
}

Mesh& move(Mesh& mesh, Vec3f by) {
    for (auto& p : mesh.positions) p += by;
    return mesh;
}
Mesh& turn(Mesh& mesh, Vec3f axis, float degrees) {
    const Mat3f r = rotation_about(normalize(axis), degrees * kPi / 180.f);
    for (auto& p : mesh.positions) p = r * p;
    for (auto& n : mesh.normals) n = r * n;
    return mesh;
}
void append(Mesh& mesh, const Mesh& part) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
    mesh.normals.insert(mesh.normals.end(), part.normals.begin(), part.normals.end());
    mesh.coords.insert(mesh.coords.end(), part.coords.begin(), part.coords.end());
    for (const std::uint32_t i : part.triangles) mesh.triangles.push_back(first + i);
}
void lay_grain(Mesh& mesh, Vec3f offset) {
    const Box b = bounds(mesh);
    const Vec3f size = b.high - b.low;
    const std::size_t up = size.x > size.y && size.x >= size.z ? 0 : size.z > size.y ? 2 : 1;
    mesh.coords.resize(mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const Vec3f p = mesh.positions[i];
        mesh.coords[i] = (up == 0 ? Vec3f{-p.y, p.x, p.z} : up == 2 ? Vec3f{p.x, p.z, -p.y} : p) + offset;
    }
}
void smooth_normals(Mesh& mesh) {
    // Vertices at the same place (to 10 micrometres) share one normal, so that the rims of grids do not show.
    const std::size_t count = mesh.positions.size();
    std::vector<std::uint32_t> order(count), group(count);
    for (std::uint32_t i = 0; i < count; ++i) order[i] = i;
    const auto key = [&](std::uint32_t i, std::size_t k) {
        return static_cast<long>(std::lround(mesh.positions[i][k] * 1e5f));
    };
    const auto less = [&](std::uint32_t a, std::uint32_t b) {
        for (std::size_t k = 0; k < 3; ++k)
            if (key(a, k) != key(b, k)) return key(a, k) < key(b, k);
        return false;
    };
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return less(a, b) || (!less(b, a) && a < b); });
    for (std::size_t i = 0; i < count; ++i)
        group[order[i]] = i > 0 && !less(order[i - 1], order[i]) ? group[order[i - 1]] : order[i];
    std::vector<Vec3f> sum(count);
    for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
        const std::uint32_t a = mesh.triangles[t], b = mesh.triangles[t + 1], c = mesh.triangles[t + 2];
        const Vec3f n = cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
        for (const std::uint32_t i : {a, b, c}) sum[group[i]] += n;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3f n = normalize(sum[group[i]]);
        if (length(n) > 0.5f) mesh.normals[i] = n;
    }
}
Box bounds(const Mesh& mesh) {
    Box b;
    for (const Vec3f p : mesh.positions)
        for (std::size_t k = 0; k < 3; ++k) {
            b.low[k] = std::min(b.low[k], p[k]);
            b.high[k] = std::max(b.high[k], p[k]);
        }
    return b;
}
float signed_volume(const Mesh& mesh) {
    double v = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
        const Vec3f a = mesh.positions[mesh.triangles[t]], b = mesh.positions[mesh.triangles[t + 1]],
                    c = mesh.positions[mesh.triangles[t + 2]];
        v += dot(a, cross(b, c)) / 6.0;
    }
    return static_cast<float>(v);
}

}  // namespace fastscene::shapes

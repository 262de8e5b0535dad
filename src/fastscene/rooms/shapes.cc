#include "fastscene/rooms/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/random.h"
#include "fastscene/rooms/shapes_parts.h"

namespace fastscene::shapes {
namespace {

float cell(int x, int y, int z, std::uint32_t seed) {
    const auto key = (static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)) << 42) ^
                     (static_cast<std::uint64_t>(static_cast<std::uint32_t>(y)) << 21) ^ static_cast<std::uint32_t>(z) ^
                     (static_cast<std::uint64_t>(seed) << 32);
    return static_cast<float>(mix64(key) >> 40) * 0x1p-23f - 1.f;
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

}  // namespace fastscene::shapes

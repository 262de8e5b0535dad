// The smooth skin about limbs: the zero level of a distance field, by marching tetrahedra.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "fastscene/rooms/shapes.h"

namespace fastscene::shapes {
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

}  // namespace fastscene::shapes

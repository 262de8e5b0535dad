// What is done to finished meshes: moved, joined, smoothed, measured.
#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/rooms/shapes_parts.h"

namespace fastscene::shapes {

void drop_slivers(Mesh& m) {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < m.triangles.size(); t += 3) {
        const Vec3f a = m.positions[m.triangles[t]], b = m.positions[m.triangles[t + 1]],
                    c = m.positions[m.triangles[t + 2]];
        // Relative to the edges: with fused multiply-add the cross product of equal edges is small, not zero.
        const float longest = std::max(dot(b - a, b - a), std::max(dot(c - a, c - a), dot(c - b, c - b)));
        if (length(cross(b - a, c - a)) > 1e-5f * longest)
            for (std::size_t k = 0; k < 3; ++k) m.triangles[kept++] = m.triangles[t + k];
    }
    m.triangles.resize(kept);
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
    const std::size_t before = mesh.triangles.size();
    mesh.triangles.resize(before + part.triangles.size());
    for (std::size_t i = 0; i < part.triangles.size(); ++i) mesh.triangles[before + i] = first + part.triangles[i];
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
    struct Vertex {
        std::array<long, 3> place;
        std::uint32_t index;
        bool operator<(const Vertex& other) const {
            for (std::size_t k = 0; k < 3; ++k)
                if (place[k] != other.place[k]) return place[k] < other.place[k];
            return index < other.index;
        }
    };
    std::vector<Vertex> order(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < 3; ++k) order[i].place[k] = std::lround(mesh.positions[i][k] * 1e5f);
        order[i].index = i;
    }
    std::sort(order.begin(), order.end());
    std::vector<std::uint32_t> group(count);
    for (std::size_t i = 0; i < count; ++i)
        group[order[i].index] = i > 0 && order[i].place == order[i - 1].place ? group[order[i - 1].index]
                                                                              : order[i].index;
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

// What the makers of shapes are written with. Private to shapes*.cc.
#pragma once

#include "fastscene/rooms/shapes.h"

namespace fastscene::shapes {

// Nothing for a triangle with two corners that are one vertex.
inline void triangle(Mesh& m, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a == b || b == c || a == c) return;
    m.triangles.insert(m.triangles.end(), {a, b, c});
}
inline void quad(Mesh& m, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    triangle(m, a, b, c);
    triangle(m, a, c, d);
}
inline std::uint32_t vertex(Mesh& m, Vec3f p, Vec3f n) {
    m.positions.push_back(p);
    m.normals.push_back(n);
    return static_cast<std::uint32_t>(m.positions.size() - 1);
}

inline Vec2f unit2(Vec2f v) {
    const float l = length(v);
    return l > 1e-9f ? v * (1.f / l) : Vec2f{1, 0};
}

// Removes triangles without an area.
void drop_slivers(Mesh& mesh);

}  // namespace fastscene::shapes

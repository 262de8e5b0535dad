// Unwraps meshes into a picture, in which every triangle has texels of its own.
#pragma once

#include <cstdint>
#include <vector>

#include "fastscene/export/bake.h"

namespace fastscene {

// Neighbouring triangles that face about the same way, seen from straight in front.
struct Chart {
    int mesh = 0;                             // index into Room::meshes
    std::vector<std::uint32_t> triangles;     // of the mesh: index of the first corner in Mesh::triangles
    Vec3f right, down;                        // unit; world
    Vec2f low, high;                          // bounds along them, in metres
    int x = 0, y = 0, width = 0, height = 0;  // texels, without the gutter around

    Vec2f flat(Vec3f p) const { return {dot(p, right), dot(p, down)}; }
};
struct ChartAtlas {
    std::vector<Chart> charts;
    int width = 0, height = 0;
    float texels_per_metre = 0;

    // glTF: (0, 0) is the picture's top left corner.
    Vec2f uv(const Chart& chart, Vec3f p) const {
        const Vec2f m = (chart.flat(p) - chart.low) * texels_per_metre;
        return {(static_cast<float>(chart.x) + m.x) / static_cast<float>(width),
                (static_cast<float>(chart.y) + m.y) / static_cast<float>(height)};
    }
};
// Of the meshes with these indices; as dense as asked for, or as fits the texture size.
ChartAtlas chart_atlas(const Room& room, const std::vector<int>& meshes, const BakeParams& params);
// That mesh in the atlas; `charts`: of the atlas, those of the mesh.
BakedMesh mapped(const Mesh& mesh, const ChartAtlas& atlas, const std::vector<std::size_t>& charts);

// A texel of a surface.
struct ChartTexel {
    int x, y;
    Vec3f position, normal;  // world; the triangle's normal, out of the surface
};
// Those that the chart's triangles cover, and those around them that filtering touches.
std::vector<ChartTexel> texels_of(const Room& room, const ChartAtlas& atlas, const Chart& chart);

}  // namespace fastscene

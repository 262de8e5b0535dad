// The triangles of a primitive of a glTF mesh. Private to io/.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "fastscene/io/gltf_document.h"
#include "fastscene/io/gltf_materials.h"

namespace fastscene {

using GltfColor = std::array<float, 4>;

struct GltfShape {
    std::vector<Vec3f> positions, normals;
    std::vector<Vec2f> uvs;  // v grows upward; empty: none
    std::vector<std::uint32_t> triangles;
    GltfColor color{1, 1, 1, 1};  // of all vertices
    bool has_colors = false;      // they differ: `color` says nothing
    std::size_t turned = 0;       // triangles whose winding contradicted their normals
    bool odd_uvs = false;         // some were not finite
    bool uvs_beyond = false;      // some are beyond the picture's border
};

// How many triangles a primitive has by its accessors' counts, for modes that have triangles.
std::size_t gltf_triangle_count(GltfDocument& document, const Json& primitive);
bool has_gltf_triangles(const GltfDocument& document, const Json& primitive);
// In the world; triangles without area are left out.
GltfShape gltf_shape(GltfDocument& document, const Json& primitive, const GltfJson::Transform& world_from_node,
                     const GltfUvUse& uv);

}  // namespace fastscene

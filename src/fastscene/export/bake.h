// Bakes procedural materials into textures: one image per material, an atlas of the flat pieces of the pattern that its
// meshes show.
#pragma once

#include <cstdint>
#include <vector>

#include "fastscene/base/fields.h"
#include "fastscene/base/run.h"
#include "fastscene/image/image.h"
#include "fastscene/scene/room.h"

namespace fastscene {

struct BakeParams {
    float texels_per_metre = 256;
    int texture_size = 2048;  // greatest width and height; a material that needs more is baked less densely
};
template <class V>
void visit_fields(BakeParams& p, V&& v) {
    v("texels-per-metre", p.texels_per_metre, Bounds{8, 4096}, "Density of baked textures.");
    v("texture-size", p.texture_size, Bounds{64, 8192}, "Maximum width and height of a texture in pixels.");
}

struct BakedMaterial {
    ImageRgb8 texture;  // sRGB; empty: `color` everywhere
    ImageRgb8 shown;    // sRGB, as large: factors of the emission; empty: 1 everywhere
    Vec3f color;        // linear; the mean of the texture
    float roughness = 0.6f;
};
// A mesh whose vertices are split where the pattern's plane changes.
struct BakedMesh {
    std::vector<std::uint32_t> vertices;   // index into the mesh's positions and normals
    std::vector<Vec2f> uv;                 // glTF: (0, 0) is the texture's top left corner
    std::vector<std::uint32_t> triangles;  // as many as the mesh has, in its order
};
struct BakedRoom {
    std::vector<BakedMaterial> materials;  // of `Room::materials`; empty ones are used by no mesh
    std::vector<BakedMesh> meshes;         // of `Room::meshes`
};
// Materials that equal each other get one bake: `same[i]` is the first that equals material i.
std::vector<int> same_materials(const std::vector<Material>& materials);
BakedRoom bake(const Room& room, const std::vector<int>& same, const BakeParams& params, const Run& run);

}  // namespace fastscene

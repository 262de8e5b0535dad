// Materials and meshes of models from files, as the tracer has them.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fastscene/image/image.h"
#include "fastscene/io/gltf_model.h"
#include "fastscene/io/obj.h"
#include "fastscene/scene/room.h"

namespace fastscene {

// A model's triangles of one material, in the file's frame and units until they are placed.
struct ModelMesh {
    Mesh mesh;  // coords: those of its pictures, where the material has any
    Material material;
    ImageMask alpha;  // what of the picture is there; empty: all
    int alpha_cutoff = 128;
    ImageRgb8 glow;  // picture of `material.emission`'s share; empty: all of it glows
};

std::vector<ModelMesh> meshes_of(GltfModel model, std::vector<std::string>& notes);
// `read_sibling`: the content of a file that the materials name, or nothing.
std::vector<ModelMesh> meshes_of(ObjModel model, const std::string& file,
                                 const std::function<std::optional<std::string>(const std::string&)>& read_sibling,
                                 bool textures, std::vector<std::string>& notes);

// Once the mesh is in metres: the scale of its pictures, holes where they are transparent, and what glows.
// Appends to `out`.
void finish(ModelMesh mesh, std::vector<ModelMesh>& out);
// A lamp: what glows in the file, or else what is named like a bulb or a shade, gives its light. Emissions become
// shares of a lamp's light; a note says if nothing can shine.
void light_up(std::vector<ModelMesh>& meshes, std::vector<std::string>& notes);

// What an old MTL says, as our materials say it: colors are sRGB, Phong's exponent becomes a roughness.
Material material_from(const ObjMaterial& material);
// Halved until no side has more texels than that.
std::shared_ptr<const TextureImage> texture_at_most(ImageRgb8 image, int texels);
// Metres that u = 1 spans, from the areas of the triangles in space and in the picture (Mesh::coords).
float metres_per_uv(const Mesh& mesh);
float area_of(const Mesh& mesh);  // square metres

}  // namespace fastscene

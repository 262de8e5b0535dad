// The furnished room before it is written in a format: nodes, meshes that equal things share, surfaces, lamps.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fastscene/export/bake.h"
#include "fastscene/math/rigid.h"

namespace fastscene {

// Triangles with one material, in the axes of the node that shows them.
struct ModelPart {
    int material = 0;  // index into Room::materials and BakedRoom::materials
    std::vector<Vec3f> positions, normals;
    std::vector<Vec2f> uv;  // empty: a plain color. (0, 0) is the texture's top left corner
    std::vector<std::uint32_t> triangles;
};
struct ModelMesh {
    std::string name;
    std::vector<ModelPart> parts;
};
// A light; it has the color times the intensity.
struct ModelLight {
    Vec3f color;  // 1 at most
    float intensity = 0;
    Vec3f position;  // of a lamp: in its node's axes
};
struct ModelNode {
    std::string id;   // of the thing, or "floor", "ceiling", "walls"
    int object = -1;  // index into Room::objects; -1: the shell
    Rigid pose;       // parent_from_node, in the axes of kGltfAxes
    int mesh = -1;    // index into RoomModel::meshes; -1: none
    std::optional<ModelLight> lamp;
};
struct RoomModel {
    std::vector<BakedMaterial> materials;  // of Room::materials
    std::vector<ModelMesh> meshes;
    std::vector<ModelNode> nodes;   // the shell, then a node per thing, in the order of Room::objects
    std::optional<ModelLight> sun;  // it shines along -z of `sun_pose`
    Rigid sun_pose;
};
RoomModel room_model(const Room& room, const BakeParams& params, const Run& run);

// What a material is in a rasteriser.
struct ModelSurface {
    Vec3f color;                  // multiplies the texture
    const ImageRgb8* texture;     // null: none
    float metal, roughness, ior;  // ior 1.5: the usual one
    float opacity;
    Vec3f emission;
};
ModelSurface surface_of(const Material& material, const BakedMaterial& baked);

inline constexpr float kUsualIor = 1.5f;
inline constexpr float kCameraFov_deg = 60;  // vertical: as an engine's usual camera
inline constexpr float kCameraNear_m = 0.05f;

// sRGB JPEG. Its quality: grain of plaster and fabric is not worth more bytes.
std::string texture_jpeg(const ImageRgb8& texture);

}  // namespace fastscene

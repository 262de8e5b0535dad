// The furnished room before it is written in a format: nodes, meshes that equal things share, surfaces, lamps.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fastscene/export/bake.h"
#include "fastscene/math/rigid.h"
#include "fastscene/trace/trace.h"

namespace fastscene {

inline constexpr float kUsualIor = 1.5f;
inline constexpr float kClearOpacity = 0.2f;  // of panes and drinking glasses

// What a surface is in a rasteriser.
struct ModelMaterial {
    std::string name;
    Vec3f color;       // linear, 0..1; multiplies the texture
    int texture = -1;  // index into RoomModel::textures; -1: none
    float metal = 0, roughness = 1, ior = kUsualIor, opacity = 1;
    Vec3f emission{};    // radiance
    int shown = -1;      // index into RoomModel::textures: factors of `emission`; -1: none
    bool unlit = false;  // the texture is what is seen, light and all
};
// Triangles with one material, in the axes of the node that shows them.
struct ModelPart {
    int material = 0;  // index into RoomModel::materials
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
    std::vector<ImageRgb8> textures;  // sRGB
    std::vector<ModelMaterial> materials;
    std::vector<ModelMesh> meshes;
    std::vector<ModelNode> nodes;   // the shell, then a node per thing, in the order of Room::objects
    std::optional<ModelLight> sun;  // it shines along -z of `sun_pose`
    Rigid sun_pose;
    bool lit = false;  // its surfaces need no light
};
// Materials for an engine's light.
RoomModel room_model(const Room& room, const BakeParams& params, const Run& run);
// Every surface with the light that falls on it: unlit textures, no lamps, no sun. The room needs its light.
RoomModel lit_room_model(const TracedRoom& room, const BakeParams& params, const Run& run);

inline constexpr float kCameraFov_deg = 60;  // vertical: as an engine's usual camera
inline constexpr float kCameraNear_m = 0.05f;

// sRGB JPEG. Its quality: grain of plaster and fabric is not worth more bytes.
std::string texture_jpeg(const ImageRgb8& texture);

}  // namespace fastscene

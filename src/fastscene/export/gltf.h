// Collects the parts of a glTF file: buffer views, accessors, images, materials, meshes, nodes.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/math/rigid.h"

namespace fastscene {

// x left, y up, z forward (docs/conventions.md): a half turn, so nothing is mirrored.
inline constexpr Mat3f kGltfAxes{{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}};

Json json_list(Vec3f v);  // [x, y, z]

class Gltf {
  public:
    int add_positions(const std::vector<Vec3f>& values);  // with the bounds that the format requires
    int add_vectors(const std::vector<Vec3f>& values);
    int add_uv(const std::vector<Vec2f>& values);
    int add_indices(const std::vector<std::uint32_t>& values);  // 16 bits each if they fit
    int add_image(const std::string& encoded, const char* mime, const std::string& name);
    // Appends to one of the format's arrays: "materials", "nodes" …; returns its index there.
    int add(const std::string& array, Json entry);
    void use(const std::string& extension);
    Json& operator[](const std::string& key) { return json_[key]; }
    // The bytes of a .glb file with that scene.
    std::string bytes(Json scene) const;

  private:
    int view(std::size_t begin, int target);
    std::string binary_;
    Json json_ = Json::object();
};

// Sets the node's translation and rotation, where they are not the identity's.
void set_pose(Json& node, const Rigid& parent_from_node);

}  // namespace fastscene

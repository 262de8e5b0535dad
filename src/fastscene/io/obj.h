// Wavefront OBJ with its MTL: triangles by material. Axes and units stay as the file has them.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/math/vec.h"

namespace fastscene {

struct ObjMaterial {
    std::string name;
    Vec3f diffuse{0.8f, 0.8f, 0.8f}, specular{}, emission{};  // as written: sRGB-like, 0..1
    float shininess = 0.f;                                    // Ns
    float opacity = 1.f;                                      // d, or 1 - Tr
    std::string diffuse_map;                                  // file name, "" = none
};
struct ObjGroup {
    std::size_t material = 0;               // index into ObjModel::materials
    std::vector<Vec3f> positions, normals;  // per vertex; normals unit, on the side the triangle's winding shows
    std::vector<Vec2f> uvs;                 // v grows upward
    std::vector<std::uint32_t> triangles;   // 3 indices each
};
struct ObjModel {
    std::vector<ObjMaterial> materials;
    std::vector<ObjGroup> groups;  // one a material, without empty ones
};

// `where` names the file in errors; `read_sibling` gives the text of a file named by mtllib, or nothing.
// Faces of any number of corners; negative indices; missing normals are computed (smooth below 40 degrees).
// Throws Error for indices or numbers that make no sense.
ObjModel parse_obj(std::string_view text, const std::string& where,
                   const std::function<std::optional<std::string>(const std::string&)>& read_sibling);

}  // namespace fastscene

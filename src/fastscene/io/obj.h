// Wavefront OBJ with MTL: triangles grouped by material. Axes and units are those of the file.
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
    Vec3f diffuse{0.8f, 0.8f, 0.8f}, specular{}, emission{};  // as stored: sRGB-like, 0..1
    float shininess = 0.f;                                    // Ns
    float opacity = 1.f;                                      // d, or 1 - Tr
    std::string diffuse_map;                                  // file name, "" = none
};
struct ObjGroup {
    std::size_t material = 0;               // index into ObjModel::materials
    std::vector<Vec3f> positions, normals;  // per vertex; unit normals on the side given by the winding
    std::vector<Vec2f> uvs;                 // v grows upward
    std::vector<std::uint32_t> triangles;   // 3 indices each
};
struct ObjModel {
    std::vector<ObjMaterial> materials;
    std::vector<ObjGroup> groups;  // one per non-empty material
};

// `where` names the file in errors; `read_sibling` returns the content of a file named by mtllib, or nothing. Supports
// polygons, negative indices and missing normals (smooth below 40 degrees). Throws Error for invalid indices or
// numbers.
ObjModel parse_obj(std::string_view text, const std::string& where,
                   const std::function<std::optional<std::string>(const std::string&)>& read_sibling);

}  // namespace fastscene

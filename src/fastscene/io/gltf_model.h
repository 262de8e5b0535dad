// glTF 2.0 models of things (.glb, or .gltf with its files): triangles grouped by material, materials, pictures. Rooms
// are written by export/, splats in glTF read by splat_io.h.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/image/image.h"
#include "fastscene/math/vec.h"

namespace fastscene {

enum class GltfAlpha { opaque, mask, blend };

// Factors multiply the pictures. Pictures are indices into GltfModel::images, -1: none.
struct GltfMaterial {
    std::string name;
    Vec3f base_color{1, 1, 1};  // linear
    float alpha = 1;            // 1 if `alpha_mode` is opaque
    float metallic = 1, roughness = 1;
    Vec3f emission{};  // linear, times its strength
    float ior = 1.5f, transmission = 0, clearcoat = 0;
    float sheen = 0;  // luminance of its color
    GltfAlpha alpha_mode = GltfAlpha::opaque;
    float alpha_cutoff = 0.5f;
    bool double_sided = false;
    int base_color_image = -1;
    int metallic_roughness_image = -1;  // green: roughness, blue: metallic
    int normal_image = -1;              // tangent space, 0..255 is -1..1, green along v
    int emission_image = -1;
    float normal_scale = 1;
};
struct GltfGroup {
    std::size_t material = 0;               // index into GltfModel::materials
    std::vector<Vec3f> positions, normals;  // per vertex; unit normals on the side given by the winding
    std::vector<Vec2f> uvs;                 // v grows upward; empty: none
    std::vector<std::uint32_t> triangles;   // 3 indices each
};
struct GltfImage {
    std::string name;
    ImageRgb8 color;  // not dimmed by alpha
    ImageMask alpha;  // of base colors; empty: opaque
};
struct GltfModel {
    std::vector<GltfMaterial> materials;  // those that triangles have
    std::vector<GltfGroup> groups;  // one for each of them, in the same order. Metres, y up, nodes' transforms applied
    std::vector<GltfImage> images;
    std::string generator, copyright, author, license, source, title;  // as the file tells them, "" = not
    std::vector<std::string> notes;                                    // sentences on what was left out or repaired
    std::size_t triangle_count = 0;
};
struct GltfLimits {
    std::size_t triangles = 3'000'000;       // of all nodes; more throw Error before any is read
    int image_side = 8192;                   // larger pictures are left out, with a note
    std::size_t image_pixels = 400'000'000;  // of all pictures; those beyond are left out, with a note
    bool images = true;                      // false: none is read, for what only needs the shape
};

// Default scene in its rest pose. Throws Error naming the file for what is no glTF 2.0, needs extensions that are not
// supported, has no triangles, or data that contradict each other; pictures that cannot be read are only noted. Files
// outside of the model's folder are never opened.
GltfModel read_gltf(const std::filesystem::path& file, const GltfLimits& limits = {});
// The same from bytes; `where` names the model in errors. `read_sibling` returns the content of a file beside it, named
// relative to it, or nothing.
GltfModel read_gltf_bytes(std::string_view bytes, const std::string& where,
                          const std::function<std::optional<std::string>(const std::string& name)>& read_sibling,
                          const GltfLimits& limits = {});

}  // namespace fastscene

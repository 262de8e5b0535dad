// For tests: makes glTF models, and looks at what was read of them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "fastscene/base/bytes.h"
#include "fastscene/io/glb_container.h"
#include "fastscene/io/gltf_model.h"

namespace fastscene {

struct GltfMaker {
    Json json{{"asset", {{"version", "2.0"}}}};
    std::string binary;

    std::size_t add(const char* list, Json value) {
        json[list].push_back(std::move(value));
        return json[list].size() - 1;
    }
    std::size_t add_view(const std::string& bytes) {
        binary.append((4 - binary.size() % 4) % 4, '\0');
        const std::size_t at = binary.size();
        binary += bytes;
        return add("bufferViews", {{"buffer", 0}, {"byteOffset", at}, {"byteLength", bytes.size()}});
    }
    template <class T>
    std::size_t add_accessor(const std::vector<T>& values, const char* type, bool normalized = false) {
        std::string bytes;
        for (const T v : values) append(bytes, v);
        const std::string name = type;
        const std::size_t width = name == "SCALAR" ? 1 : static_cast<std::size_t>(name.back() - '0');
        Json accessor{{"bufferView", add_view(bytes)},
                      {"componentType", component_type(T{})},
                      {"count", values.size() / width},
                      {"type", type}};
        if (normalized) accessor["normalized"] = true;
        return add("accessors", std::move(accessor));
    }
    std::string glb() const {
        Json whole = json;
        if (!binary.empty()) whole["buffers"][0] = {{"byteLength", binary.size()}};
        return glb_bytes(whole, binary);
    }

    static int component_type(float) { return 5126; }
    static int component_type(std::int8_t) { return 5120; }
    static int component_type(std::uint8_t) { return 5121; }
    static int component_type(std::int16_t) { return 5122; }
    static int component_type(std::uint16_t) { return 5123; }
    static int component_type(std::uint32_t) { return 5125; }
};

// A cube of 2 m around the origin, outward: 8 corners, 12 triangles.
inline const std::vector<float> kCubeCorners{-1, -1, -1, 1, -1, -1, 1, 1, -1, -1, 1, -1,
                                             -1, -1, 1,  1, -1, 1,  1, 1, 1,  -1, 1, 1};
inline const std::vector<std::uint32_t> kCubeTriangles{4, 5, 6, 4, 6, 7, 1, 0, 3, 1, 3, 2, 5, 1, 2, 5, 2, 6,
                                                       0, 4, 7, 0, 7, 3, 7, 6, 2, 7, 2, 3, 0, 1, 5, 0, 5, 4};

inline std::vector<float> unshared_cube() {
    std::vector<float> out;
    for (const std::uint32_t i : kCubeTriangles)
        out.insert(out.end(), kCubeCorners.begin() + 3 * i, kCubeCorners.begin() + 3 * i + 3);
    return out;
}

// One mesh of one primitive in one node.
inline GltfMaker gltf_with(GltfMaker maker, Json primitive) {
    maker.add("meshes", {{"primitives", Json::array({std::move(primitive)})}});
    maker.add("nodes", {{"mesh", 0}});
    maker.add("scenes", {{"nodes", {0}}});
    return maker;
}
inline GltfMaker cube_gltf() {
    GltfMaker maker;
    Json primitive{{"attributes", {{"POSITION", maker.add_accessor(kCubeCorners, "VEC3")}}},
                   {"indices", maker.add_accessor(kCubeTriangles, "SCALAR")}};
    return gltf_with(std::move(maker), std::move(primitive));
}
inline Json& only_primitive(GltfMaker& maker) { return maker.json["meshes"][0]["primitives"][0]; }

inline std::optional<std::string> no_gltf_siblings(const std::string&) { return {}; }
inline GltfModel model_of(const std::string& bytes, const GltfLimits& limits = {}) {
    return read_gltf_bytes(bytes, "test.glb", no_gltf_siblings, limits);
}
inline GltfModel model_of(const GltfMaker& maker) { return model_of(maker.glb()); }

// Corners in thousandths, from the smallest on, in the order of the winding; sorted.
using GltfTriangles = std::vector<std::array<std::array<int, 3>, 3>>;
inline GltfTriangles triangles_of(const GltfModel& model) {
    GltfTriangles out;
    for (const GltfGroup& group : model.groups)
        for (std::size_t t = 0; t < group.triangles.size(); t += 3) {
            std::array<std::array<int, 3>, 3> triangle;
            for (std::size_t i = 0; i < 3; ++i)
                for (std::size_t c = 0; c < 3; ++c)
                    triangle[i][c] = static_cast<int>(std::lround(1000 * group.positions[group.triangles[t + i]][c]));
            std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
            out.push_back(triangle);
        }
    std::sort(out.begin(), out.end());
    return out;
}

// Positive where closed meshes face outward.
inline double volume_of(const GltfModel& model) {
    double sum = 0;
    for (const GltfGroup& group : model.groups)
        for (std::size_t t = 0; t < group.triangles.size(); t += 3) {
            const auto p = [&](std::size_t i) { return group.positions[group.triangles[t + i]]; };
            sum += dot(p(0), cross(p(1), p(2))) / 6;
        }
    return sum;
}

}  // namespace fastscene

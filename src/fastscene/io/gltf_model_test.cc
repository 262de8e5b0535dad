// Reading people's glTF models: the same shape comes back however it is stored.
#include "fastscene/io/gltf_model.h"

#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <cstring>
#include <limits>

#include "fastscene/base/base64.h"
#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/random.h"
#include "fastscene/io/test_gltf.h"
#include "fastscene/io/test_scratch.h"

namespace fastscene {
namespace {

const GltfTriangles& cube() {
    static const GltfTriangles triangles = triangles_of(model_of(cube_gltf()));
    return triangles;
}

void expect_cube(const GltfModel& model) {
    EXPECT_EQ(model.triangle_count, 12u);
    EXPECT_EQ(triangles_of(model), cube());
    EXPECT_NEAR(volume_of(model), 8, 1e-3);
    for (const GltfGroup& group : model.groups) {
        ASSERT_EQ(group.normals.size(), group.positions.size());
        for (std::size_t i = 0; i < group.positions.size(); ++i) {
            EXPECT_NEAR(length(group.normals[i]), 1, 1e-5);
            EXPECT_GT(dot(group.normals[i], group.positions[i]), 0.9f);
        }
    }
}

template <class T>
std::vector<T> as(const std::vector<std::uint32_t>& values) {
    return {values.begin(), values.end()};
}
template <class T>
std::vector<T> scaled(const std::vector<float>& values, float factor) {
    std::vector<T> out;
    for (const float v : values) out.push_back(static_cast<T>(std::lround(v * factor)));
    return out;
}

template <class T>
GltfMaker cube_indexed_by() {
    GltfMaker maker;
    Json primitive{{"attributes", {{"POSITION", maker.add_accessor(kCubeCorners, "VEC3")}}},
                   {"indices", maker.add_accessor(as<T>(kCubeTriangles), "SCALAR")}};
    return gltf_with(maker, primitive);
}

TEST(GltfModel, TheTestsOwnCubeIsOne) {
    const GltfModel model = model_of(cube_gltf());
    expect_cube(model);
    EXPECT_EQ(std::set(cube().begin(), cube().end()).size(), 12u);
    ASSERT_EQ(model.groups.size(), 1u);
    EXPECT_EQ(model.materials.size(), 1u);
    EXPECT_TRUE(model.groups[0].uvs.empty());
    EXPECT_TRUE(model.notes.empty());
}

TEST(GltfModel, IndicesOfEveryTypeOrNone) {
    expect_cube(model_of(cube_indexed_by<std::uint8_t>()));
    expect_cube(model_of(cube_indexed_by<std::uint16_t>()));
    expect_cube(model_of(cube_indexed_by<std::uint32_t>()));
    GltfMaker maker;
    Json primitive{{"attributes", {{"POSITION", maker.add_accessor(unshared_cube(), "VEC3")}}}};
    expect_cube(model_of(gltf_with(maker, primitive)));
}

template <class T>
GltfMaker quantized_cube(float largest, bool normalized, float offset = 0) {
    GltfMaker maker;
    std::vector<float> corners = kCubeCorners;
    for (float& v : corners) v += offset;
    Json primitive{{"attributes", {{"POSITION", maker.add_accessor(scaled<T>(corners, largest), "VEC3", normalized)}}},
                   {"indices", maker.add_accessor(kCubeTriangles, "SCALAR")}};
    maker = gltf_with(maker, primitive);
    maker.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    const float scale = normalized ? 1 / (1.f + offset) : 1 / largest;
    if (offset > 0) maker.json["nodes"][0]["translation"] = {-1, -1, -1};
    maker.json["nodes"][0]["scale"] = {scale, scale, scale};
    if (normalized && offset > 0) maker.json["nodes"][0]["scale"] = {2, 2, 2};
    return maker;
}

TEST(GltfModel, QuantizedPositions) {
    expect_cube(model_of(quantized_cube<std::int8_t>(127, true)));
    expect_cube(model_of(quantized_cube<std::int16_t>(32767, true)));
    expect_cube(model_of(quantized_cube<std::int8_t>(50, false)));
    expect_cube(model_of(quantized_cube<std::int16_t>(1000, false)));
    expect_cube(model_of(quantized_cube<std::uint8_t>(100, false, 1)));
    expect_cube(model_of(quantized_cube<std::uint16_t>(20000, false, 1)));
    expect_cube(model_of(quantized_cube<std::uint8_t>(127.5f, true, 1)));
    expect_cube(model_of(quantized_cube<std::uint16_t>(32767.5f, true, 1)));
}

TEST(GltfModel, SparsePositions) {
    GltfMaker maker = cube_gltf();
    // A cube out of nothing.
    std::vector<std::uint16_t> all{0, 1, 2, 3, 4, 5, 6, 7};
    std::string indices, values;
    for (const std::uint16_t i : all) append(indices, i);
    for (const float v : kCubeCorners) append(values, v);
    maker.json["accessors"][0].erase("bufferView");
    maker.json["accessors"][0]["sparse"] = {
        {"count", 8},
        {"indices", {{"bufferView", maker.add_view(indices)}, {"componentType", 5123}}},
        {"values", {{"bufferView", maker.add_view(values)}}}};
    expect_cube(model_of(maker));
    // One corner moved back to where it belongs.
    std::vector<float> bent = kCubeCorners;
    bent[3 * 6] = 5;
    GltfMaker other;
    Json primitive{{"attributes", {{"POSITION", other.add_accessor(bent, "VEC3")}}},
                   {"indices", other.add_accessor(kCubeTriangles, "SCALAR")}};
    other = gltf_with(other, primitive);
    EXPECT_NE(triangles_of(model_of(other)), cube());
    std::string corner;
    for (const float v : {1.f, 1.f, 1.f}) append(corner, v);
    other.json["accessors"][0]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", other.add_view("\6")}, {"componentType", 5121}}},
        {"values", {{"bufferView", other.add_view(corner)}}}};
    expect_cube(model_of(other));
}

TEST(GltfModel, InterleavedVertices) {
    GltfMaker maker;
    std::string bytes;
    for (std::size_t i = 0; i < 8; ++i) {
        for (std::size_t c = 0; c < 3; ++c) append(bytes, 77.f);
        for (std::size_t c = 0; c < 3; ++c) append(bytes, kCubeCorners[3 * i + c]);
        append(bytes, 0.25f), append(bytes, 0.125f * static_cast<float>(i));
    }
    const std::size_t view = maker.add_view(bytes);
    maker.json["bufferViews"][view]["byteStride"] = 32;
    const auto accessor = [&](std::size_t offset, const char* type) {
        return maker.add(
            "accessors",
            {{"bufferView", view}, {"byteOffset", offset}, {"componentType", 5126}, {"count", 8}, {"type", type}});
    };
    Json primitive{{"attributes", {{"POSITION", accessor(12, "VEC3")}, {"TEXCOORD_0", accessor(24, "VEC2")}}},
                   {"indices", maker.add_accessor(kCubeTriangles, "SCALAR")}};
    const GltfModel model = model_of(gltf_with(maker, primitive));
    expect_cube(model);
    for (const Vec2f uv : model.groups[0].uvs) EXPECT_FLOAT_EQ(uv.x, 0.25f);
}

// Three triangles of a strip and of a fan over the same five points, against their list.
TEST(GltfModel, StripsAndFans) {
    const std::vector<float> points{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0};
    const auto read = [&](const std::vector<std::uint8_t>& indices, int mode) {
        GltfMaker maker;
        Json primitive{{"attributes", {{"POSITION", maker.add_accessor(points, "VEC3")}}},
                       {"indices", maker.add_accessor(indices, "SCALAR")},
                       {"mode", mode}};
        return triangles_of(model_of(gltf_with(maker, primitive)));
    };
    EXPECT_EQ(read({0, 1, 2, 3, 4}, 5), read({0, 1, 2, 1, 3, 2, 2, 3, 4}, 4));
    EXPECT_EQ(read({0, 1, 3, 4}, 6), read({0, 1, 3, 0, 3, 4}, 4));
    // Joined strips repeat a vertex.
    EXPECT_EQ(read({0, 1, 2, 2, 3, 4}, 5), read({0, 1, 2, 2, 4, 3}, 4));
}

TEST(GltfModel, MeshesOfSeveralNodesAndPrimitives) {
    GltfMaker maker = cube_gltf();
    Json again = only_primitive(maker);
    maker.add("materials", {{"name", "red"}});
    again["material"] = 0;
    maker.json["meshes"][0]["primitives"].push_back(again);
    maker.add("nodes", {{"mesh", 0}, {"translation", {10, 0, 0}}});
    maker.json["scenes"][0]["nodes"] = {0, 1};
    const GltfModel model = model_of(maker);
    EXPECT_EQ(model.triangle_count, 48u);
    ASSERT_EQ(model.groups.size(), 2u);
    EXPECT_EQ(model.groups[0].triangles.size(), 72u);
    EXPECT_EQ(model.groups[1].triangles.size(), 72u);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(model.groups[i].material, i);
    EXPECT_TRUE(model.materials[0].name == "red" || model.materials[1].name == "red");
    EXPECT_NEAR(volume_of(model), 32, 1e-3);
}

TEST(GltfModel, OnlyTheDefaultSceneOrAllRoots) {
    GltfMaker maker = cube_gltf();
    maker.add("nodes", {{"mesh", 0}, {"translation", {10, 0, 0}}});
    maker.add("scenes", {{"nodes", {1}}});
    expect_cube(model_of(maker));
    maker.json["scene"] = 1;
    EXPECT_NE(triangles_of(model_of(maker)), cube());
    EXPECT_EQ(model_of(maker).triangle_count, 12u);
    maker.json.erase("scenes"), maker.json.erase("scene");
    EXPECT_EQ(model_of(maker).triangle_count, 24u);
    maker.add("nodes", {{"children", {0, 1}}});
    EXPECT_EQ(model_of(maker).triangle_count, 24u);
    maker.json.erase("nodes");
    expect_cube(model_of(maker));
}

TEST(GltfModel, TransformsCompose) {
    GltfMaker parts = cube_gltf();
    parts.json["nodes"] = {{{"children", {1}}, {"translation", {1, 2, 3}}, {"scale", {2, 2, 2}}},
                           {{"mesh", 0}, {"rotation", {0, 0, std::sqrt(0.5), std::sqrt(0.5)}}, {"scale", {1, 2, 3}}}};
    // Columns: x becomes 2 y, y becomes -4 x, z becomes 6 z.
    GltfMaker whole = cube_gltf();
    whole.json["nodes"][0]["matrix"] = {0, 2, 0, 0, -4, 0, 0, 0, 0, 0, 6, 0, 1, 2, 3, 1};
    EXPECT_EQ(triangles_of(model_of(parts)), triangles_of(model_of(whole)));
    EXPECT_NEAR(volume_of(model_of(whole)), 8 * 48, 0.1);
    EXPECT_EQ(triangles_of(model_of(parts)).front()[0], (std::array{-3000, 0, -3000}));
}

GltfMaker cube_with_normals() {
    GltfMaker maker;
    std::vector<float> normals;
    const std::vector<float> corners = unshared_cube();
    for (std::size_t face = 0; face < 12; ++face) {
        const auto p = [&](std::size_t i) {
            return Vec3f{corners[9 * face + 3 * i], corners[9 * face + 3 * i + 1], corners[9 * face + 3 * i + 2]};
        };
        const Vec3f n = normalize(cross(p(1) - p(0), p(2) - p(0)));
        for (int i = 0; i < 3; ++i) normals.insert(normals.end(), {n.x, n.y, n.z});
    }
    Json primitive{{"attributes",
                    {{"POSITION", maker.add_accessor(corners, "VEC3")},
                     {"NORMAL", maker.add_accessor(scaled<std::int8_t>(normals, 127), "VEC3", true)}}}};
    return gltf_with(maker, primitive);
}

TEST(GltfModel, MirroredNodesStillFaceOutward) {
    for (GltfMaker maker : {cube_gltf(), cube_with_normals()}) {
        expect_cube(model_of(maker));
        for (const Json& scale : {Json{-1, 1, 1}, Json{1, -1, 1}, Json{-1, -1, -1}}) {
            maker.json["nodes"][0]["scale"] = scale;
            const GltfModel model = model_of(maker);
            EXPECT_NEAR(volume_of(model), 8, 1e-3);
            EXPECT_TRUE(model.notes.empty());
            for (std::size_t i = 0; i < model.groups[0].positions.size(); ++i)
                EXPECT_GT(dot(model.groups[0].normals[i], model.groups[0].positions[i]), 0.9f);
        }
    }
}

TEST(GltfModel, NormalsStayPerpendicularUnderUnevenScale) {
    GltfMaker maker = cube_with_normals();
    maker.json["nodes"][0]["matrix"] = {1, 0.5, 0, 0, 0, 2, 0, 0, 0, 0, 0.1, 0, 0, 0, 0, 1};  // sheared
    const GltfGroup group = model_of(maker).groups[0];
    for (std::size_t t = 0; t < group.triangles.size(); t += 3) {
        const auto p = [&](std::size_t i) { return group.positions[group.triangles[t + i]]; };
        const Vec3f own = normalize(cross(p(1) - p(0), p(2) - p(0)));
        EXPECT_NEAR(dot(own, group.normals[group.triangles[t]]), 1, 1e-4);
    }
}

TEST(GltfModel, WindingsAgainstTheirNormalsAreTurned) {
    GltfMaker maker = cube_with_normals();
    std::vector<std::uint8_t> indices;
    for (std::uint8_t i = 0; i < 36; ++i) indices.push_back(i);
    std::swap(indices[0], indices[1]);
    only_primitive(maker)["indices"] = maker.add_accessor(indices, "SCALAR");
    const GltfModel model = model_of(maker);
    expect_cube(model);
    ASSERT_EQ(model.notes.size(), 1u);
    EXPECT_EQ(model.notes[0], "Triangles that faced away from their normals are turned around: 1.");
}

TEST(GltfModel, MissingNormalsAreSmoothBelow40Degrees) {
    // Walls of a column of 24 sides, 15 degrees apart, its vertices not shared.
    std::vector<float> points;
    for (int i = 0; i < 24; ++i) {
        const auto at = [&](int side, float y) {
            const float a = static_cast<float>(side) * kPi / 12;
            points.insert(points.end(), {std::cos(a), y, std::sin(a)});
        };
        at(i, 0), at(i, 1), at(i + 1, 1), at(i, 0), at(i + 1, 1), at(i + 1, 0);
    }
    GltfMaker maker;
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = std::round(points[i] * 1e4f) / 1e4f;
    Json primitive{{"attributes", {{"POSITION", maker.add_accessor(points, "VEC3")}}}};
    const GltfGroup group = model_of(gltf_with(maker, primitive)).groups[0];
    for (std::size_t i = 0; i < group.positions.size(); ++i) {
        const Vec3f out = normalize(Vec3f{group.positions[i].x, 0, group.positions[i].z});
        EXPECT_GT(dot(group.normals[i], out), 0.998f);  // a flat one: 0.991
    }
}

TEST(GltfModel, CompressedByMeshopt) {
    for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
        GltfMaker maker = cube_gltf();
        std::string vertices(meshopt_encodeVertexBufferBound(8, 12), '\0'),
            indices(meshopt_encodeIndexBufferBound(36, 8), '\0');
        meshopt_encodeVertexVersion(0);
        vertices.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(vertices.data()), vertices.size(),
                                                   kCubeCorners.data(), 8, 12));
        indices.resize(meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(indices.data()), indices.size(),
                                                 kCubeTriangles.data(), kCubeTriangles.size()));
        maker.binary = vertices + indices;
        maker.json["buffers"] = {{{"byteLength", maker.binary.size()}}, {{"byteLength", 240}}};
        maker.json["bufferViews"][0]["extensions"][name] = {
            {"buffer", 0}, {"byteLength", vertices.size()}, {"byteStride", 12}, {"count", 8}, {"mode", "ATTRIBUTES"}};
        maker.json["bufferViews"][1]["extensions"][name] = {{"buffer", 0},
                                                            {"byteOffset", vertices.size()},
                                                            {"byteLength", indices.size()},
                                                            {"byteStride", 4},
                                                            {"count", 36},
                                                            {"mode", "TRIANGLES"}};
        for (Json& view : maker.json["bufferViews"]) view["buffer"] = 1;
        maker.json["extensionsRequired"] = {name};
        expect_cube(model_of(maker));
        maker.json["bufferViews"][0]["extensions"][name]["count"] = 4'000'000'000u;
        EXPECT_THROW(model_of(maker), Error);
        maker.json["bufferViews"][0]["extensions"][name]["count"] = 80;
        EXPECT_THROW(model_of(maker), Error);
    }
}

TEST(GltfModel, JsonWithDataInItOrBesideIt) {
    GltfMaker maker = cube_gltf();
    Json json = maker.json;
    json["buffers"] = {
        {{"byteLength", maker.binary.size()}, {"uri", "data:application/octet-stream;base64," + base64(maker.binary)}}};
    expect_cube(model_of("\xef\xbb\xbf\n " + json.dump()));
    json["buffers"][0]["uri"] = "parts/the%20data.bin";
    make_directories(scratch("parts"));
    write_file(scratch("parts/the data.bin"), maker.binary);
    write_file(scratch("cube.gltf"), json.dump());
    expect_cube(read_gltf(scratch("cube.gltf")));
    write_file(scratch("cube.glb"), maker.glb());
    expect_cube(read_gltf(scratch("cube.glb")));
}

TEST(GltfModel, Base64IsDecodedAsItIsEncoded) {
    Random random(3, "base64");
    for (std::size_t size = 0; size < 70; ++size) {
        std::string bytes(size, '\0');
        for (char& c : bytes) c = static_cast<char>(random.index(256));
        EXPECT_EQ(from_base64(base64(bytes)), bytes);
    }
    EXPECT_EQ(from_base64("Zg"), "f");
    EXPECT_FALSE(from_base64("Z"));
    EXPECT_FALSE(from_base64("Zg==Zg=="));
    EXPECT_FALSE(from_base64("Z g="));
}

TEST(GltfModel, SaysWhoMadeIt) {
    GltfMaker maker = cube_gltf();
    maker.json["asset"] = {
        {"version", "2.0"},
        {"generator", "a modeller"},
        {"copyright", "2024 someone"},
        {"extras", {{"author", "someone"}, {"license", "CC-BY-4.0"}, {"source", "https://x"}, {"title", "Cube"}}}};
    const GltfModel model = model_of(maker);
    EXPECT_EQ(model.generator, "a modeller");
    EXPECT_EQ(model.copyright, "2024 someone");
    EXPECT_EQ(model.author + model.license + model.source + model.title, "someoneCC-BY-4.0https://xCube");
}

}  // namespace
}  // namespace fastscene

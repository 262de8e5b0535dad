// glTF models that are refused, each with its reason.
#include <gtest/gtest.h>

#include <limits>

#include "fastscene/base/error.h"
#include "fastscene/base/random.h"
#include "fastscene/io/test_gltf.h"

namespace fastscene {
namespace {

// The error's text after the model's name.
std::string refusal(const std::string& bytes, const GltfLimits& limits = {}) {
    try {
        model_of(bytes, limits);
    } catch (const Error& e) {
        const std::string text = e.what();
        EXPECT_TRUE(text.starts_with("test.glb: ")) << text;
        const std::string place = "JSON at byte 20: ";
        const std::size_t at = text.find(place);
        return at == std::string::npos ? text.substr(10) : text.substr(at + place.size());
    }
    return "nothing";
}
std::string refusal(const std::function<void(GltfMaker&)>& change, const GltfLimits& limits = {}) {
    GltfMaker maker = cube_gltf();
    EXPECT_EQ(refusal(maker.glb()), "nothing");
    change(maker);
    return refusal(maker.glb(), limits);
}

TEST(GltfRefused, WhatIsNoGltf2) {
    EXPECT_EQ(refusal(std::string()), "expected a glTF model (.glb, or .gltf: JSON), found something else");
    EXPECT_EQ(refusal(std::string("ply\n")), "expected a glTF model (.glb, or .gltf: JSON), found something else");
    std::string old = cube_gltf().glb();
    old[4] = 1;
    EXPECT_EQ(refusal(old), "byte 8: expected glTF 2, found 1");
    EXPECT_EQ(refusal([](GltfMaker& m) { m.json["asset"]["version"] = "1.0"; }), "expected glTF 2.0, found 1.0");
    EXPECT_EQ(refusal([](GltfMaker& m) { m.json.erase("asset"); }), "expected glTF 2.0, found no version");
    EXPECT_TRUE(refusal(std::string("{\"asset\": ")).starts_with("byte 0: expected JSON, found: "));
}

TEST(GltfRefused, ExtensionsThatAreRequired) {
    const auto require = [](const char* name) {
        return refusal([&](GltfMaker& m) { m.json["extensionsRequired"] = {name}; });
    };
    EXPECT_EQ(require("KHR_texture_transform"), "nothing");
    EXPECT_EQ(require("KHR_draco_mesh_compression"),
              "expected a model that can be read without KHR_draco_mesh_compression, found that it requires "
              "KHR_draco_mesh_compression: save it without Draco compression");
    EXPECT_EQ(
        require("KHR_texture_basisu"),
        "expected a model that can be read without KHR_texture_basisu, found that it requires KHR_texture_basisu: "
        "save it with PNG or JPEG textures");
    EXPECT_EQ(require("ACME_shapes"),
              "expected a model that can be read without ACME_shapes, found that it requires ACME_shapes");
    // Not told to be required, but there are no other data.
    EXPECT_NE(refusal([](GltfMaker& m) {
                  only_primitive(m)["extensions"]["KHR_draco_mesh_compression"] = Json::object();
                  m.json["accessors"][0].erase("bufferView");
              }).find("save it without Draco"),
              std::string::npos);
}

TEST(GltfRefused, NodesThatAreNoTree) {
    EXPECT_EQ(refusal([](GltfMaker& m) { m.json["nodes"][0]["children"] = {0}; }),
              "expected a tree of nodes, found that nodes[0] is its own ancestor");
    EXPECT_EQ(refusal([](GltfMaker& m) {
                  m.json["nodes"][0]["children"] = {1};
                  m.add("nodes", {{"children", {2}}}), m.add("nodes", {{"children", {1}}});
              }),
              "expected a tree of nodes, found that nodes[1] is its own ancestor");
    EXPECT_EQ(refusal([](GltfMaker& m) {
                  m.json["scenes"][0]["nodes"] = {0, 0};
              }),
              "expected a tree of nodes, found nodes[0] twice");
    EXPECT_EQ(refusal([](GltfMaker& m) {
                  for (std::size_t i = 1; i <= 101; ++i)
                      m.json["nodes"].back()["children"] = {i}, m.add("nodes", Json::object());
              }),
              "expected nodes at most 100 deep, found more");
    EXPECT_EQ(refusal([](GltfMaker& m) { m.json["nodes"][0]["children"] = {7}; }),
              "expected an object nodes[7], found 1 of them");
    EXPECT_EQ(refusal([](GltfMaker& m) { m.json["nodes"][0]["mesh"] = 3; }),
              "expected an object meshes[3], found 1 of them");
    EXPECT_EQ(refusal([](GltfMaker& m) {
                  m.json["nodes"][0]["rotation"] = {0, 0, 0, 0};
              }),
              "expected a unit quaternion as a node's rotation, found zero");
}

TEST(GltfRefused, DataThatContradictEachOther) {
    const auto accessor = [](std::size_t index, const char* name, Json value) {
        return refusal([&](GltfMaker& m) { m.json["accessors"][index][name] = value; });
    };
    EXPECT_EQ(
        accessor(0, "count", 9),
        "accessors[0]: expected 9 rows of 12 bytes, 12 bytes apart from byte 0, found 96 bytes in bufferViews[0]");
    EXPECT_EQ(
        accessor(0, "byteOffset", 4),
        "accessors[0]: expected 8 rows of 12 bytes, 12 bytes apart from byte 4, found 96 bytes in bufferViews[0]");
    EXPECT_EQ(accessor(0, "count", 7), "indices: expected less than 7, found 7");
    EXPECT_EQ(accessor(0, "type", "VEC2"), "POSITION: expected 3 numbers in a row, found 2 in accessors[0]");
    EXPECT_EQ(accessor(0, "type", "MAT4"), "accessors[0]: expected a scalar or vector, found \"MAT4\"");
    EXPECT_EQ(accessor(0, "componentType", 5125),
              "POSITION: expected floats, bytes or shorts, found component type 5125 in accessors[0]");
    EXPECT_EQ(accessor(0, "componentType", 77), "accessors[0]: expected a component type of glTF, found 77");
    EXPECT_EQ(accessor(1, "componentType", 5126),
              "indices: expected whole numbers without a sign, found component type 5126 in accessors[1]");
    EXPECT_EQ(accessor(0, "count", -1), "expected a whole number as \"count\", found -1");
    EXPECT_EQ(accessor(0, "bufferView", 8), "expected an object bufferViews[8], found 2 of them");
    EXPECT_EQ(refusal([](GltfMaker& m) { m.json["bufferViews"][0]["byteStride"] = 8; }),
              "accessors[0]: expected 8 rows of 12 bytes, 8 bytes apart from byte 0, found 96 bytes in bufferViews[0]");
    EXPECT_EQ(refusal([](GltfMaker& m) { m.json["bufferViews"][0]["byteLength"] = 1000; }),
              "expected 1000 bytes from byte 0 of buffers[0], found 240 in all");
    EXPECT_EQ(refusal([](GltfMaker& m) { m.json["bufferViews"][0]["buffer"] = 1; }),
              "expected an object buffers[1], found 1 of them");
    EXPECT_EQ(refusal([](GltfMaker& m) {
                  only_primitive(m)["attributes"]["NORMAL"] = m.add_accessor<float>({0, 1, 0}, "VEC3");
              }),
              "NORMAL: expected 8 rows as POSITION has, found 1");
    const auto sparse = [](Json indices) {
        return refusal([&](GltfMaker& m) {
            const std::size_t view = m.add_view(std::string("\5\3", 2)), values = m.add_view(std::string(24, '\0'));
            m.json["accessors"][0]["sparse"] = {{"count", 2},
                                                {"indices", {{"bufferView", view}, {"componentType", 5121}}},
                                                {"values", {{"bufferView", values}}}};
            m.json["accessors"][0]["sparse"]["indices"].update(indices);
        });
    };
    EXPECT_EQ(sparse(Json::object()), "accessors[0]: expected growing sparse indices below 8, found 3");
    EXPECT_EQ(sparse({{"componentType", 5126}}),
              "accessors[0]: expected sparse indices without a sign, found component type 5126");
    EXPECT_EQ(sparse({{"componentType", 5125}}),
              "accessors[0] (sparse indices): expected 2 rows of 4 bytes, 4 bytes apart from byte 0, found 2 bytes in "
              "bufferViews[2]");
}

TEST(GltfRefused, BuffersThatAreNotThere) {
    const auto buffer = [](const std::string& uri) {
        Json json = cube_gltf().json;
        json["buffers"] = {{{"byteLength", 240}, {"uri", uri}}};
        const std::string text = refusal(json.dump());
        return text.substr(std::string("JSON at byte 0: ").size());
    };
    EXPECT_EQ(buffer("cube.bin"), "buffers[0]: expected a file cube.bin, found none");
    EXPECT_EQ(buffer("data:;base64,AAAA"), "buffers[0]: expected 240 bytes, found 3");
    EXPECT_EQ(buffer("data:;base64,A*AA"), "expected base64 in a data URI, found other characters");
    EXPECT_EQ(buffer("data:"), "expected data after \"data:\" in a URI, found none");
    for (const char* uri :
         {"/etc/hosts", "../cube.bin", "a/../../b", "%2e%2E/b", "C:\\cube.bin", "file:cube.bin", "..\\b"})
        EXPECT_EQ(buffer(uri),
                  fmt::format("expected a URI of data or of a file in the model's folder, found \"{}\"", uri));
}

TEST(GltfRefused, NumbersThatAreNone) {
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()})
        EXPECT_TRUE(refusal([&](GltfMaker& m) {
                        std::vector<float> corners = kCubeCorners;
                        corners[4] = bad;
                        only_primitive(m)["attributes"]["POSITION"] = m.add_accessor(corners, "VEC3");
                    }).starts_with("POSITION: expected finite numbers, found (1, "));
    EXPECT_EQ(refusal([](GltfMaker& m) {
                  m.json["nodes"][0]["scale"] = {1e39, 1, 1};
              }),
              "POSITION: expected finite numbers, found (-1, -1, 1) in row 4, which its node moves out of range");
}

TEST(GltfRefused, NothingToSee) {
    EXPECT_EQ(refusal(std::string("{\"asset\": {\"version\": \"2.0\"}}")),
              "JSON at byte 0: expected triangles, found none");
    EXPECT_EQ(refusal([](GltfMaker& m) { m.json["scenes"][0]["nodes"] = Json::array(); }),
              "expected triangles, found none");
    EXPECT_EQ(refusal([](GltfMaker& m) { only_primitive(m)["mode"] = 1; }), "expected triangles, found none");
    EXPECT_EQ(refusal([](GltfMaker& m) {
                  m.json["nodes"][0]["scale"] = {0, 0, 0};
              }),
              "expected triangles with an area, found none");
}

// Counted by what the accessors say, so that no memory is taken first.
TEST(GltfRefused, MoreTrianglesThanAllowed) {
    const GltfLimits twelve{12, 100, 100}, eleven{11, 100, 100};
    EXPECT_EQ(refusal([](GltfMaker&) {}, twelve), "nothing");
    EXPECT_EQ(refusal([](GltfMaker&) {}, eleven), "expected at most 11 triangles, found more");
    EXPECT_EQ(refusal([](GltfMaker& m) { m.json["accessors"][1]["count"] = 4'000'000'000'000'000'000; }, twelve),
              "expected at most 12 triangles, found more");
    EXPECT_EQ(refusal(
                  [](GltfMaker& m) {
                      m.add("nodes", {{"mesh", 0}});
                      m.json["scenes"][0]["nodes"] = {0, 1};
                  },
                  twelve),
              "expected at most 12 triangles, found more");
    EXPECT_EQ(refusal([](GltfMaker& m) {
                  m.json["accessors"][0].erase("bufferView");
                  m.json["accessors"][0]["count"] = 4'000'000'000;
              }),
              "accessors[0]: expected a buffer view for 4000000000 rows, found none");
}

// Damaged in one or a few places: an Error that names the model, or a model that is sound.
TEST(GltfRefused, DamagedFiles) {
    GltfMaker maker = cube_gltf();
    only_primitive(maker)["attributes"]["TEXCOORD_0"] = maker.add_accessor(std::vector<float>(16, 0.5f), "VEC2");
    const std::string whole = maker.glb();
    const auto try_one = [](const std::string& bytes) {
        try {
            const GltfModel model = model_of(bytes, {1000, 100, 10000});
            for (const GltfGroup& group : model.groups) {
                EXPECT_EQ(group.normals.size(), group.positions.size());
                EXPECT_TRUE(group.uvs.empty() || group.uvs.size() == group.positions.size());
                for (const std::uint32_t i : group.triangles) EXPECT_LT(i, group.positions.size());
                for (const Vec3f n : group.normals) EXPECT_NEAR(length(n), 1, 1e-4);
            }
        } catch (const Error& e) {
            EXPECT_TRUE(std::string(e.what()).starts_with("test.glb: ")) << e.what();
        }
    };
    for (std::size_t keep = 0; keep < whole.size(); keep += 7) try_one(whole.substr(0, keep));
    Random random(5, "gltf");
    for (int n = 0; n < 4000; ++n) {
        std::string bytes = whole;
        for (int k = 0; k <= n % 3; ++k) {
            char& byte = bytes[static_cast<std::size_t>(random.index(static_cast<int>(bytes.size())))];
            // Digits become other digits: what the JSON says stays readable.
            if (byte >= '0' && byte <= '9') byte = static_cast<char>('0' + random.index(10));
            else byte = static_cast<char>(random.index(256));
        }
        try_one(bytes);
    }
}

}  // namespace
}  // namespace fastscene

// Materials and pictures of people's glTF models.
#include <gtest/gtest.h>
#include <png.h>
#include <webp/encode.h>

#include "fastscene/base/base64.h"
#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/test_gltf.h"
#include "fastscene/io/test_scratch.h"

namespace fastscene {
namespace {

using Rgba = std::array<std::uint8_t, 4>;

std::string png_of(int width, int height, Rgba color, bool with_alpha) {
    std::string pixels;
    for (int i = 0; i < width * height; ++i)
        pixels.append(reinterpret_cast<const char*>(color.data()), with_alpha ? 4 : 3);
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(width), image.height = static_cast<png_uint_32>(height);
    image.format = with_alpha ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
    std::string out(size, '\0');
    EXPECT_TRUE(png_image_write_to_memory(&image, out.data(), &size, 0, pixels.data(), 0, nullptr));
    out.resize(size);
    return out;
}

std::string webp_of(int width, int height, Rgba color) {
    std::string pixels;
    for (int i = 0; i < width * height; ++i) pixels.append(reinterpret_cast<const char*>(color.data()), 4);
    std::uint8_t* out = nullptr;
    const std::size_t size = WebPEncodeLosslessRGBA(reinterpret_cast<const std::uint8_t*>(pixels.data()), width, height,
                                                    4 * width, &out);
    std::string bytes(reinterpret_cast<const char*>(out), size);
    WebPFree(out);
    return bytes;
}

// A square of 1 m with texture coordinates: its corners' x and, downward, y.
GltfMaker square(Json material, int uv_sets = 1) {
    GltfMaker maker;
    Json attributes{{"POSITION", maker.add_accessor<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, "VEC3")}};
    for (int set = 0; set < uv_sets; ++set) {
        const float d = 10.f * static_cast<float>(set);
        attributes[fmt::format("TEXCOORD_{}", set)] = maker.add_accessor<float>(
            {0 + d, 1, 1 + d, 1, 1 + d, 0, 0 + d, 0}, "VEC2");
    }
    Json primitive{{"attributes", attributes},
                   {"indices", maker.add_accessor<std::uint8_t>({0, 1, 2, 0, 2, 3}, "SCALAR")},
                   {"material", maker.add("materials", std::move(material))}};
    return gltf_with(std::move(maker), std::move(primitive));
}

std::size_t add_texture(GltfMaker& maker, const std::string& bytes, const char* type = "image/png") {
    const std::size_t view = maker.add_view(bytes);
    return maker.add("textures", {{"source", maker.add("images", {{"bufferView", view}, {"mimeType", type}})}});
}

Json textured(Json info) { return {{"pbrMetallicRoughness", {{"baseColorTexture", std::move(info)}}}}; }

GltfMaterial material_of(const Json& material) {
    const GltfModel model = model_of(square(material));
    EXPECT_EQ(model.materials.size(), 1u);
    EXPECT_TRUE(model.notes.empty());
    return model.materials.front();
}

TEST(GltfMaterials, FactorsAndTheirDefaults) {
    const GltfMaterial plain = material_of(Json::object());
    EXPECT_EQ(plain.name, "material 0");
    EXPECT_EQ(plain.base_color, (Vec3f{1, 1, 1}));
    EXPECT_EQ(plain.metallic, 1);
    EXPECT_EQ(plain.roughness, 1);
    EXPECT_EQ(plain.ior, 1.5f);
    EXPECT_FALSE(plain.double_sided);
    const GltfMaterial m = material_of(
        {{"name", "glass"},
         {"doubleSided", true},
         {"alphaMode", "MASK"},
         {"alphaCutoff", 0.25},
         {"emissiveFactor", {0.5, 0.25, 0}},
         {"pbrMetallicRoughness",
          {{"baseColorFactor", {0.1, 0.2, 0.3, 0.4}}, {"metallicFactor", 0.5}, {"roughnessFactor", 0.75}}},
         {"extensions",
          {{"KHR_materials_emissive_strength", {{"emissiveStrength", 8}}},
           {"KHR_materials_ior", {{"ior", 1.33}}},
           {"KHR_materials_transmission", {{"transmissionFactor", 0.9}}},
           {"KHR_materials_clearcoat", {{"clearcoatFactor", 0.6}}},
           {"KHR_materials_sheen", {{"sheenColorFactor", {0.5, 0.5, 0.5}}}}}}});
    EXPECT_EQ(m.name, "glass");
    EXPECT_EQ(m.base_color, (Vec3f{0.1f, 0.2f, 0.3f}));
    EXPECT_FLOAT_EQ(m.alpha, 0.4f);
    EXPECT_EQ(m.alpha_mode, GltfAlpha::mask);
    EXPECT_FLOAT_EQ(m.alpha_cutoff, 0.25f);
    EXPECT_FLOAT_EQ(m.metallic, 0.5f);
    EXPECT_FLOAT_EQ(m.roughness, 0.75f);
    EXPECT_EQ(m.emission, (Vec3f{4, 2, 0}));
    EXPECT_FLOAT_EQ(m.ior, 1.33f);
    EXPECT_FLOAT_EQ(m.transmission, 0.9f);
    EXPECT_FLOAT_EQ(m.clearcoat, 0.6f);
    EXPECT_FLOAT_EQ(m.sheen, 0.5f);
    EXPECT_TRUE(m.double_sided);
    const GltfMaterial unlit = material_of(
        {{"pbrMetallicRoughness", {{"roughnessFactor", 0.1}, {"baseColorFactor", {1, 1, 1, 0.5}}}},
         {"extensions", {{"KHR_materials_unlit", Json::object()}}}});
    EXPECT_EQ(unlit.metallic, 0);
    EXPECT_EQ(unlit.roughness, 1);
    EXPECT_EQ(unlit.alpha, 1);  // opaque
}

TEST(GltfMaterials, NumbersOutOfRangeAreBounded) {
    const GltfMaterial m = material_of(
        {{"emissiveFactor", {1e300, -1, 0}},
         {"pbrMetallicRoughness", {{"baseColorFactor", {9, -9, 1e300, 1}}, {"roughnessFactor", -3}}},
         {"extensions", {{"KHR_materials_ior", {{"ior", 0}}}}}});
    EXPECT_EQ(m.base_color, (Vec3f{1, 0, 1}));
    EXPECT_EQ(m.roughness, 0);
    EXPECT_TRUE(std::isfinite(m.emission.x) && m.emission.y == 0);
    EXPECT_EQ(m.ior, 1.5f);
}

TEST(GltfMaterials, OneOfEachPictureIsRead) {
    GltfMaker maker = square(
        {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}, {"metallicRoughnessTexture", {{"index", 1}}}}},
         {"normalTexture", {{"index", 2}, {"scale", 0.5}}},
         {"emissiveTexture", {{"index", 3}}},
         {"emissiveFactor", {1, 1, 1}}});
    add_texture(maker, png_of(4, 2, {10, 20, 30, 255}, false));
    add_texture(maker, encode_jpeg(ImageRgb8(8, 8, {0, 128, 255})), "image/jpeg");
    add_texture(maker, png_of(1, 1, {128, 128, 255, 255}, true));
    maker.add("textures", {{"source", 0}});
    const GltfModel model = model_of(maker);
    const GltfMaterial& m = model.materials[0];
    ASSERT_EQ(model.images.size(), 3u);
    EXPECT_EQ(m.base_color_image, 0);
    EXPECT_EQ(m.metallic_roughness_image, 1);
    EXPECT_EQ(m.normal_image, 2);
    EXPECT_EQ(m.emission_image, 0);
    EXPECT_FLOAT_EQ(m.normal_scale, 0.5f);
    EXPECT_EQ(model.images[0].color, ImageRgb8(4, 2, {10, 20, 30}));
    EXPECT_EQ(model.images[2].color, ImageRgb8(1, 1, {128, 128, 255}));
    for (const GltfImage& image : model.images) EXPECT_TRUE(image.alpha.empty());
    EXPECT_TRUE(model.notes.empty());
}

// What is see-through keeps its color: it must not turn black.
TEST(GltfMaterials, AlphaDoesNotDimColors) {
    for (const bool is_webp : {false, true}) {
        Json material = textured({{"index", 0}});
        material["alphaMode"] = "MASK";
        material["normalTexture"] = {{"index", 1}};
        GltfMaker maker = square(material);
        const Rgba color{200, 100, 50, 51};
        add_texture(maker, is_webp ? webp_of(3, 2, color) : png_of(3, 2, color, true));
        if (is_webp) maker.json["textures"][0] = {{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}};
        add_texture(maker, png_of(1, 1, {1, 2, 3, 4}, true));
        const GltfModel model = model_of(maker);
        ASSERT_EQ(model.images.size(), 2u);
        EXPECT_EQ(model.images[0].color, ImageRgb8(3, 2, {200, 100, 50}));
        EXPECT_EQ(model.images[0].alpha, ImageMask(3, 2, 51));
        EXPECT_TRUE(model.images[1].alpha.empty());  // a normal has none
        EXPECT_EQ(model.images[1].color, ImageRgb8(1, 1, {1, 2, 3}));
    }
}

TEST(GltfMaterials, TextureCoordinatesGrowUpward) {
    const GltfGroup group = model_of(square(Json::object())).groups[0];
    ASSERT_EQ(group.uvs.size(), group.positions.size());
    for (std::size_t i = 0; i < group.uvs.size(); ++i) {
        EXPECT_FLOAT_EQ(group.uvs[i].x, group.positions[i].x);
        EXPECT_FLOAT_EQ(group.uvs[i].y, group.positions[i].y);
    }
}

TEST(GltfMaterials, TextureTransformsAndSets) {
    const auto uvs = [&](Json info, const std::string& note = "") {
        Json material = textured(info);
        material["normalTexture"] = {{"index", 0}};
        if (note.empty()) material["normalTexture"] = info;
        GltfMaker maker = square(material, 2);
        add_texture(maker, png_of(1, 1, {9, 9, 9, 255}, false));
        const GltfModel model = model_of(maker);
        EXPECT_EQ(model.notes, note.empty() ? std::vector<std::string>{} : std::vector{note});
        EXPECT_EQ(model.materials[0].normal_image, note.empty() ? 0 : -1);
        return model.groups[0].uvs;
    };
    const auto transform = [](Json how) {
        return Json{{"index", 0}, {"extensions", {{"KHR_texture_transform", std::move(how)}}}};
    };
    const std::string other =
        "Material \"material 0\": its picture of normal is left out: it has texture coordinates of its own.";
    EXPECT_FLOAT_EQ(uvs({{"index", 0}, {"texCoord", 1}}, other)[0].x, 10);
    EXPECT_FLOAT_EQ(uvs(transform({{"texCoord", 1}}))[0].x, 10);
    const auto moved = uvs(transform({{"offset", {0.25, 0.5}}, {"scale", {2, 4}}}), other);
    EXPECT_FLOAT_EQ(moved[0].x, 0.25f);  // stored: (0, 1), moved (0.25, 4.5)
    EXPECT_FLOAT_EQ(moved[0].y, 1 - 4.5f);
    EXPECT_FLOAT_EQ(moved[2].x, 2.25f);  // (1, 0), (2.25, 0.5)
    EXPECT_FLOAT_EQ(moved[2].y, 0.5f);
    // A quarter counter-clockwise about the picture's top left corner: right becomes up.
    const auto turned = uvs(transform({{"rotation", kPi / 2}}));
    EXPECT_NEAR(turned[2].x, 0, 1e-6);  // (1, 0) becomes (0, -1)
    EXPECT_NEAR(turned[2].y, 2, 1e-6);
    EXPECT_NEAR(turned[0].x, 1, 1e-6);  // (0, 1), (1, 0)
    EXPECT_NEAR(turned[0].y, 1, 1e-6);
}

TEST(GltfMaterials, SpecularGlossiness) {
    const auto with = [](Json glossy) {
        return Json{{"pbrMetallicRoughness", {{"metallicFactor", 1}, {"baseColorFactor", {0, 0, 0, 1}}}},
                    {"extensions", {{"KHR_materials_pbrSpecularGlossiness", std::move(glossy)}}}};
    };
    const GltfMaterial plain = material_of(
        with({{"diffuseFactor", {0.5, 0.25, 0.125, 1}}, {"glossinessFactor", 0.75}, {"specularFactor", {0, 0, 0}}}));
    EXPECT_EQ(plain.base_color, (Vec3f{0.5f, 0.25f, 0.125f}));
    EXPECT_EQ(plain.metallic, 0);
    EXPECT_FLOAT_EQ(plain.roughness, 0.25f);
    const GltfMaterial gold = material_of(
        with({{"diffuseFactor", {0, 0, 0, 1}}, {"specularFactor", {1, 0.75, 0.25}}, {"glossinessFactor", 1}}));
    EXPECT_EQ(gold.base_color, (Vec3f{1, 0.75f, 0.25f}));
    EXPECT_EQ(gold.metallic, 1);
    GltfMaker maker = square(with({{"diffuseTexture", {{"index", 0}}},
                                   {"specularGlossinessTexture", {{"index", 1}}},
                                   {"glossinessFactor", 0.5}}));
    add_texture(maker, png_of(2, 2, {70, 80, 90, 255}, false));
    add_texture(maker, png_of(3, 1, {10, 10, 10, 200}, true));
    const GltfModel model = model_of(maker);
    const GltfMaterial& m = model.materials[0];
    ASSERT_EQ(model.images.size(), 2u);
    EXPECT_EQ(m.base_color_image, 0);
    EXPECT_EQ(m.metallic_roughness_image, 1);
    EXPECT_EQ(m.metallic, 0);
    EXPECT_EQ(m.roughness, 1);
    EXPECT_EQ(model.images[1].color, ImageRgb8(3, 1, {0, 155, 0}));  // 255 - 200 / 2
}

TEST(GltfMaterials, ColorsOfVertices) {
    const auto read = [](const std::vector<std::uint8_t>& colors) {
        GltfMaker maker = square({{"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 1, 1, 1}}}}});
        only_primitive(maker)["attributes"]["COLOR_0"] = maker.add_accessor(colors, "VEC4", true);
        return model_of(maker);
    };
    const GltfModel even = read({51, 102, 255, 255, 51, 102, 255, 255, 51, 102, 255, 255, 51, 102, 255, 255});
    EXPECT_TRUE(even.notes.empty());
    EXPECT_NEAR(even.materials[0].base_color.x, 0.1f, 1e-6);
    EXPECT_NEAR(even.materials[0].base_color.y, 0.4f, 1e-6);
    const GltfModel varied = read({51, 102, 255, 255, 9, 102, 255, 255, 51, 102, 255, 255, 51, 102, 255, 255});
    EXPECT_EQ(varied.notes, std::vector<std::string>{"Material \"material 0\": colors of vertices are left out."});
    EXPECT_EQ(varied.materials[0].base_color, (Vec3f{0.5f, 1, 1}));
}

// Only what triangles show is read.
TEST(GltfMaterials, UnusedMaterialsAreNot) {
    GltfMaker maker = square(Json::object());
    Json other = textured({{"index", 99}});
    maker.json["materials"].push_back(other);
    const GltfModel model = model_of(maker);
    EXPECT_EQ(model.materials.size(), 1u);
    EXPECT_TRUE(model.images.empty());
}

std::vector<std::string> notes_of(const std::function<void(GltfMaker&)>& change, const GltfLimits& limits = {}) {
    GltfMaker maker = square(textured({{"index", 0}}));
    add_texture(maker, png_of(8, 4, {1, 2, 3, 255}, false));
    EXPECT_TRUE(model_of(maker.glb()).notes.empty());
    change(maker);
    const GltfModel model = model_of(maker.glb(), limits);
    EXPECT_EQ(model.triangle_count, 2u);
    return model.notes;
}
#define EXPECT_NOTE(text, ...) EXPECT_EQ(notes_of(__VA_ARGS__), std::vector<std::string>{text})

TEST(GltfMaterials, WhatCannotBeReadIsNoted) {
    const auto image = [](Json to) { return [to](GltfMaker& m) { m.json["images"][0] = to; }; };
    EXPECT_NOTE("Picture \"wood.png\" is left out: there is no such file.", image({{"uri", "wood.png"}}));
    EXPECT_NOTE(
        "Picture \"image 0\" is left out: image 0: expected a PNG, JPEG, WebP, TIFF, HEIC, AVIF, JPEG XL, "
        "OpenEXR, Radiance or PFM picture, found GIF.",
        image({{"uri", "data:image/gif;base64," + base64("GIF89a-and-more")}}));
    EXPECT_NOTE(
        "Picture \"image 0\" is left out: expected at most 6 pixels a side, found 8 x 4.", [](GltfMaker&) {},
        GltfLimits{100, 6, 1000});
    EXPECT_NOTE(
        "Picture \"image 0\" is left out: expected at most 31 pixels in all pictures, found more.", [](GltfMaker&) {},
        GltfLimits{100, 8, 31});
    EXPECT_NOTE("Texture 0 is left out: it is KTX 2 (Basis); save it as PNG or JPEG.", [](GltfMaker& m) {
        m.json["textures"][0] = {{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}};
    });
    EXPECT_NOTE("Texture 0 is left out: it has no picture.",
                [](GltfMaker& m) { m.json["textures"][0] = Json::object(); });
    EXPECT_NOTE("Material \"material 0\" has pictures, but not all its triangles have texture coordinates.",
                [](GltfMaker& m) { only_primitive(m)["attributes"].erase("TEXCOORD_0"); });
    EXPECT_NOTE(
        "Material \"material 0\": its picture is repeated where it should be mirrored or end.", [](GltfMaker& m) {
            m.json["samplers"] = {{{"wrapS", 33071}}};
            m.json["textures"][0]["sampler"] = 0;
            only_primitive(m)["attributes"]["TEXCOORD_0"] = m.add_accessor<float>({0, 0, 2, 0, 2, 1, 0, 1}, "VEC2");
        });
    EXPECT_NOTE("What KHR_lights_punctual adds is left out.", [](GltfMaker& m) {
        m.json["extensionsUsed"] = {"KHR_lights_punctual", "KHR_materials_ior"};
    });
    EXPECT_NOTE("Animations are left out: the model is in its rest pose.",
                [](GltfMaker& m) { m.json["animations"] = {Json::object()}; });
    EXPECT_NOTE("Skins are left out: meshes stand as they were modelled.",
                [](GltfMaker& m) { m.json["nodes"][0]["skin"] = 0; });
    EXPECT_NOTE("Morph targets are left out.", [](GltfMaker& m) { only_primitive(m)["targets"] = {Json::object()}; });
    EXPECT_NOTE("Points and lines are left out.", [](GltfMaker& m) {
        Json lines = only_primitive(m);
        lines["mode"] = 1;
        m.json["meshes"][0]["primitives"].push_back(lines);
    });
    EXPECT_NOTE("Material \"material 0\": clearcoatTexture is left out; its factor is used.", [](GltfMaker& m) {
        m.json["materials"][0]["extensions"]["KHR_materials_clearcoat"] = {{"clearcoatTexture", {{"index", 0}}}};
    });
    EXPECT_NOTE("Texture coordinates that are no numbers, or huge, are set to 0.", [](GltfMaker& m) {
        only_primitive(m)["attributes"]["TEXCOORD_0"] = m.add_accessor<float>({0, 0, NAN, 0, 1, 1, 0, 1}, "VEC2");
    });
}

// They are shown on terminals, and go into JSON.
TEST(GltfMaterials, NotesAreWholeCharacters) {
    const auto notes = notes_of([](GltfMaker& m) {
        std::string name = "\x1b[2J" + std::string(77 - 4, 'x');
        for (int i = 0; i < 20; ++i) name += "\xc3\xa4";
        m.json["extensionsUsed"] = {name};
    });
    EXPECT_EQ(notes, std::vector{"What ?[2J" + std::string(73, 'x') + "\xc3\xa4 adds is left out."});
}

TEST(GltfMaterials, ManyNotesEnd) {
    const auto notes = notes_of([](GltfMaker& m) {
        for (int i = 0; i < 200; ++i) m.json["extensionsUsed"].push_back(fmt::format("VENDOR_{}", i));
    });
    EXPECT_EQ(notes.size(), 51u);
    EXPECT_EQ(notes.back(), "There is more that was left out.");
}

TEST(GltfMaterials, PicturesBesideTheModel) {
    GltfMaker maker = square(textured({{"index", 0}}));
    maker.add("images", {{"uri", "maps%2Foak%20%C3%A4.png"}});
    maker.add("textures", {{"source", 0}});
    make_directories(scratch("model/maps"));
    write_file(scratch("model/maps/oak ä.png"), png_of(2, 1, {5, 6, 7, 255}, false));
    write_file(scratch("secret.png"), png_of(1, 1, {5, 6, 7, 255}, false));
    const auto read = [&](const std::string& uri) {
        maker.json["images"][0]["uri"] = uri;
        write_file(scratch("model/square.glb"), maker.glb());
        return read_gltf(scratch("model/square.glb"));
    };
    EXPECT_EQ(read("maps%2Foak%20%C3%A4.png").images.at(0).color, ImageRgb8(2, 1, {5, 6, 7}));
    EXPECT_EQ(read("maps\\oak ä.png").images.size(), 1u);
    for (const std::string& uri :
         {std::string("../secret.png"), std::string("maps/../../secret.png"), std::string("%2e%2e/secret.png"),
          std::string("..\\secret.png"), scratch("secret.png").string(), "file://" + scratch("secret.png").string(),
          std::string("https://example.org/a.png"), std::string("maps/oak ä.png%00")}) {
        const GltfModel model = read(uri);
        EXPECT_TRUE(model.images.empty()) << uri;
        ASSERT_EQ(model.notes.size(), 1u) << uri;
        EXPECT_NE(model.notes[0].find("in the model's folder"), std::string::npos) << model.notes[0];
    }
}

}  // namespace
}  // namespace fastscene

// The user's own models and skies: what a folder's files are taken for, how they stand in rooms, what is refused.
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "fastscene/base/bytes.h"
#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/io/glb_container.h"
#include "fastscene/io/image_io.h"
#include "fastscene/rooms/cutout.h"
#include "fastscene/rooms/document.h"
#include "fastscene/rooms/pack.h"
#include "fastscene/rooms/tops.h"
#include "fastscene/rooms/user_inventory.h"
#include "fastscene/rooms/user_model.h"
#include "fastscene/rooms/user_sky.h"
#include "fastscene/rooms/user_texture.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;
const Run kRun{4, nullptr, {}};

struct Box {
    Vec3f low, high;
};

void append_box(const Box& b, std::vector<Vec3f>& points, std::vector<std::uint32_t>& triangles) {
    const auto first = static_cast<std::uint32_t>(points.size());
    for (int i = 0; i < 8; ++i)
        points.push_back({i & 1 ? b.high.x : b.low.x, i & 2 ? b.high.y : b.low.y, i & 4 ? b.high.z : b.low.z});
    for (const std::uint32_t i :
         {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5})
        triangles.push_back(first + i);
}

// A glTF file of boxes.
std::string glb_of(const std::vector<Box>& boxes, Json extras = Json::object()) {
    std::vector<Vec3f> points;
    std::vector<std::uint32_t> triangles;
    for (const Box& b : boxes) append_box(b, points, triangles);
    std::string binary;
    Vec3f low = points.front(), high = low;
    for (const Vec3f p : points)
        for (std::size_t k = 0; k < 3; ++k) {
            append(binary, p[k]);
            low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
        }
    const std::size_t positions = binary.size();
    for (const std::uint32_t i : triangles) append(binary, i);
    return glb_bytes(
        {{"asset", {{"version", "2.0"}, {"extras", std::move(extras)}}},
         {"scene", 0},
         {"scenes", {{{"nodes", {0}}}}},
         {"nodes", {{{"mesh", 0}}}},
         {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}, {"material", 0}}}}}}},
         {"materials", {{{"name", "cloth"}, {"pbrMetallicRoughness", {{"baseColorFactor", {0.1, 0.2, 0.3, 1}}}}}}},
         {"buffers", {{{"byteLength", binary.size()}}}},
         {"bufferViews",
          {{{"buffer", 0}, {"byteOffset", 0}, {"byteLength", positions}},
           {{"buffer", 0}, {"byteOffset", positions}, {"byteLength", binary.size() - positions}}}},
         {"accessors",
          {{{"bufferView", 0},
            {"componentType", 5126},
            {"count", points.size()},
            {"type", "VEC3"},
            {"min", {low.x, low.y, low.z}},
            {"max", {high.x, high.y, high.z}}},
           {{"bufferView", 1}, {"componentType", 5125}, {"count", triangles.size()}, {"type", "SCALAR"}}}}},
        binary);
}
Box block(Vec3f size) { return {{-size.x / 2, 0, -size.z / 2}, {size.x / 2, size.y, size.z / 2}}; }

class UserAssets : public ::testing::Test {
  protected:
    void SetUp() override {
        root_ = fs::path(::testing::TempDir()) /
                ("fastscene_assets_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
        fs::remove_all(root_);
        make_directories(root_);
    }
    void TearDown() override { fs::remove_all(root_); }

    void put(const std::string& name, const std::string& bytes) {
        make_directories((root_ / name).parent_path());
        write_file(root_ / name, bytes);
    }
    // The model that a folder with this one file has.
    UserPiece piece(const std::string& name, const std::string& bytes, const std::string& row = {}) {
        put(name, bytes);
        if (!row.empty()) put(kAssetsFile, "[[model]]\nfile = \"" + name + "\"\n" + row);
        const auto assets = read_user_assets(root_);
        EXPECT_EQ(assets.complaints, std::vector<std::string>{});
        return load_user_model(root_, assets.models.at(0));
    }
    std::shared_ptr<const FurniturePack> pack() {
        complaints_.clear();
        return FurniturePack::open("none," + root_.string(), complaints_);
    }
    std::string refusal(const std::function<void()>& act) {
        try {
            act();
        } catch (const Error& error) {
            return error.what();
        }
        return "nothing was refused";
    }

    fs::path root_;
    std::vector<std::string> complaints_;
};

TEST_F(UserAssets, FileNamesSayWhatThingsAre) {
    EXPECT_EQ(spoken_name("Vintage_Armchair-02 (1)"), "vintage armchair");
    EXPECT_EQ(spoken_name("GreenChair_lowpoly_v2"), "green chair");
    for (const char* name : {"Vintage_Armchair-02.glb", "sofa/scene.glb", "teleporter_gate.glb", ".hidden/lamp.glb"})
        put(name, glb_of({block({0.8f, 0.9f, 0.8f})}));
    const auto found = read_user_assets(root_).models;
    ASSERT_EQ(found.size(), 3u);
    EXPECT_EQ(found[0].kind, "armchair");
    EXPECT_EQ(found[1].kind, "sofa");
    EXPECT_EQ(found[2].kind, "teleporter_gate");
    EXPECT_EQ(found[2].names.front(), "teleporter gate");
}

TEST_F(UserAssets, ASizeThatIsNoneOfSuchThingsIsReadInOtherUnits) {
    const float metres = piece("armchair.glb", glb_of({block({0.8f, 0.9f, 0.8f})})).piece.size_m.y;
    EXPECT_NEAR(metres, 0.9f, 1e-5f);
    const UserPiece centimetres = piece("armchair.glb", glb_of({block({80, 90, 80})}));
    EXPECT_NEAR(centimetres.piece.size_m.y, 0.9f, 1e-4f);
    ASSERT_EQ(centimetres.notes.size(), 1u);
    EXPECT_NE(centimetres.notes[0].find("centimetres"), std::string::npos) << centimetres.notes[0];
    // Out of a network that fills a cube: as large as armchairs are.
    const UserPiece unit = piece("armchair.glb", glb_of({block({3.9f, 4.f, 3.9f})}));
    EXPECT_NEAR(length(unit.piece.size_m),
                length(make_piece({.kind = "armchair", .style = &all_styles().front()}).size_m), 1e-3f);
    const UserPiece said = piece("armchair.glb", glb_of({block({2, 4, 1})}), "height_m = 1.0\n");
    EXPECT_NEAR(said.piece.size_m.x, 0.5f, 1e-5f);
    EXPECT_NEAR(said.piece.size_m.z, 0.25f, 1e-5f);
    fs::remove(root_ / "armchair.glb"), fs::remove(root_ / kAssetsFile);
    EXPECT_NE(refusal([&] {
                  piece("teleporter_gate.glb", glb_of({block({200000, 90000, 90000})}));
              }).find("expected a size"),
              std::string::npos);
}

TEST_F(UserAssets, AxesOfTheFileBecomeOurs) {
    // A seat with its back at -x and z up: the front looks along +x.
    const std::string file = glb_of(
        {{{-0.4f, -0.3f, 0}, {0.4f, 0.3f, 0.4f}}, {{-0.4f, -0.3f, 0.4f}, {-0.3f, 0.3f, 0.9f}}});
    const Piece p = piece("armchair.glb", file, "up = \"z\"\nfront = \"x\"\n").piece;
    EXPECT_NEAR(p.size_m.x, 0.6f, 1e-5f);
    EXPECT_NEAR(p.size_m.y, 0.9f, 1e-5f);
    EXPECT_NEAR(p.size_m.z, 0.8f, 1e-5f);
    float back = -1;  // z of the highest points
    for (const Mesh& m : p.meshes)
        for (const Vec3f v : m.positions)
            if (v.y > 0.85f) back = std::max(back, v.z);
    EXPECT_NEAR(back, -0.3f, 1e-5f);
    put(kAssetsFile, "[[model]]\nfile = \"armchair.glb\"\nup = \"y\"\nfront = \"-y\"\n");
    EXPECT_NE(read_user_assets(root_).complaints.at(0).find("right angles"), std::string::npos);
}

TEST_F(UserAssets, FlatTopsCarryThings) {
    const Piece table = piece("side_table.glb", glb_of({{{-0.3f, 0.5f, -0.2f}, {0.3f, 0.55f, 0.2f}},
                                                        {{-0.05f, 0, -0.05f}, {0.05f, 0.5f, 0.05f}}}))
                            .piece;
    ASSERT_EQ(table.surfaces.size(), 1u);
    EXPECT_NEAR(table.surfaces[0].center.y, 0.55f, 1e-3f);
    EXPECT_NEAR(table.surfaces[0].half.x, 0.3f, 0.02f);
    EXPECT_NEAR(table.surfaces[0].half.y, 0.2f, 0.02f);
    // A roof carries nothing.
    Piece roof;
    roof.size_m = {1, 0.6f, 1};
    roof.meshes.push_back({.positions = {{-0.5f, 0.3f, -0.5f}, {0.5f, 0.3f, -0.5f}, {0, 0.6f, 0.5f}},
                           .normals = {},
                           .coords = {},
                           .triangles = {0, 1, 2}});
    EXPECT_FALSE(flat_top(roof));
}

TEST_F(UserAssets, LampsShine) {
    const auto lamp = [&](const std::string& material) {
        put("lamp.mtl", "newmtl " + material + "\nKd 0.9 0.9 0.9\n");
        return piece("floor_lamp.obj",
                     "mtllib lamp.mtl\nv 0 0 0\nv 0.3 0 0\nv 0 1.6 0.3\nusemtl " + material + "\nf 1 2 3\n");
    };
    const UserPiece dark = lamp("steel");
    ASSERT_EQ(dark.notes.size(), 1u);
    EXPECT_NE(dark.notes[0].find("gives no light"), std::string::npos) << dark.notes[0];
    EXPECT_TRUE(lamp("Bulb_01").notes.empty());
    // As bright as the style's lamps, and its light counts only where lamps are lit.
    const auto own = pack();
    const Style& style = all_styles().front();
    const Piece made = make_piece(
        {.kind = "floor_lamp", .style = &style, .pack = own, .model = own->choose_users("floor_lamp", 1)});
    const Vec3f emission = made.materials[0].emission;
    EXPECT_GT(luminance(emission), 0.1f * luminance(style.lamp_light));
    EXPECT_LT(luminance(emission), luminance(style.lamp_light));
}

TEST(Cutout, KeepsWhatIsOpaque) {
    Mesh quad;
    quad.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    quad.normals.assign(4, {0, 0, 1});
    quad.coords = quad.positions;
    quad.triangles = {0, 1, 2, 0, 2, 3};
    ImageMask disc(128, 128);
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x) disc.at(x, y) = std::hypot(x - 63.5, y - 63.5) < 40 ? 255 : 0;
    const Mesh cut = cut_out(quad, disc, 128, 100000);
    double area = 0;
    for (std::size_t t = 0; t < cut.triangles.size(); t += 3) {
        const Vec3f a = cut.positions[cut.triangles[t]], b = cut.positions[cut.triangles[t + 1]],
                    c = cut.positions[cut.triangles[t + 2]];
        area += 0.5 * static_cast<double>(length(cross(b - a, c - a)));
        const Vec3f center = (a + b + c) / 3.f;
        EXPECT_LT(std::hypot(center.x - 0.5f, center.y - 0.5f), 43.f / 128);
    }
    EXPECT_NEAR(area, std::numbers::pi * 40 * 40 / (128 * 128), 0.01);
}

TEST_F(UserAssets, StandInRoomsAndAreCredited) {
    put("Wingback.glb",
        glb_of({block({0.7f, 1.1f, 0.7f})}, {{"author", "A"}, {"license", "CC BY 4.0"}, {"title", "W"}}));
    put("teleporter_gate.glb", glb_of({block({0.9f, 1.5f, 0.6f})}));
    put(kAssetsFile, "[[model]]\nfile = \"Wingback.glb\"\nclass = \"armchair\"\nnames = [\"reading throne\"]\n");
    put("monkey_idol.glb", glb_of({block({0.5f, 1.2f, 0.5f})}));
    const auto own = pack();
    EXPECT_EQ(complaints_, std::vector<std::string>{});
    // Words that are known by themselves are no obstacle to a name.
    const PromptSpec idols = understand_prompt("a study with two monkey idols", true, own);
    ASSERT_EQ(idols.objects.size(), 1u);
    EXPECT_EQ(idols.objects[0].kind, "monkey_idol");
    EXPECT_EQ(idols.objects[0].count, 2);
    // Nor words that are known as nothing that rooms have.
    put("sundial.glb", glb_of({block({0.5f, 0.9f, 0.5f})}));
    EXPECT_EQ(understand_prompt("a study with a sundial", true, pack()).objects.at(0).kind, "sundial");
    for (const char* prompt : {"a study with an armchair and a teleporter gate", "a study with a reading throne"}) {
        PromptSpec spec = understand_prompt(prompt, true, own);
        const Room room = make_room(spec, kRun);
        EXPECT_TRUE(spec.not_placed.empty()) << prompt;
        const auto of = [&](const std::string& kind) {
            return std::find_if(room.objects.begin(), room.objects.end(),
                                [&](const RoomObject& o) { return o.kind == kind; });
        };
        ASSERT_NE(of("armchair"), room.objects.end());
        EXPECT_EQ(of("armchair")->source, "W by A (CC BY 4.0), Wingback.glb");
        EXPECT_NEAR(of("armchair")->size_m.y, 1.1f, 1e-4f);
        if (std::string_view(prompt).ends_with("gate")) {
            ASSERT_NE(of("teleporter_gate"), room.objects.end());
            EXPECT_EQ(of("teleporter_gate")->source, "teleporter_gate (licence not stated), teleporter_gate.glb");
        }
    }
    // Its document names the model, and builds the same room from it.
    PromptSpec spec = understand_prompt("a study with an armchair", true, own);
    const FurnishedRoom furnished = furnish_room(spec, kRun, {});
    const RoomDocument document = document_of(spec, furnished, kRun.seed);
    const auto chair = std::find_if(document.things.begin(), document.things.end(),
                                    [](const DocumentThing& t) { return t.kind == "armchair"; });
    ASSERT_NE(chair, document.things.end());
    EXPECT_EQ(chair->model, "Wingback.glb");
    DocumentRoom again = furnish_document(document, "room.json", own, kRun);
    EXPECT_EQ(document_json(document_of(again)).dump(), document_json(document).dump());
    EXPECT_NE(refusal([&] { furnish_document(document, "room.json", nullptr, kRun); }).find("Wingback.glb"),
              std::string::npos);
}

TEST_F(UserAssets, TexturesCoverFloorsAndWalls) {
    ImageRgb8 color(64, 32, Rgb8{200, 100, 50});
    save_png(root_ / "c.png", color);
    put("old_tiles_2k/old_tiles_Color.png", read_file(root_ / "c.png"));
    put("old_tiles_2k/old_tiles_Roughness.png", read_file(root_ / "c.png"));
    fs::remove(root_ / "c.png");
    put(kAssetsFile, "[[texture]]\nfolder = \"old_tiles_2k\"\nwidth_m = 1.5\n");
    const auto own = pack();
    EXPECT_EQ(complaints_, std::vector<std::string>{});
    PromptSpec spec = understand_prompt("a kitchen with an old tiles floor", true, own);
    const Room room = make_room(spec, kRun);
    const auto material = std::find_if(room.materials.begin(), room.materials.end(),
                                       [](const Material& m) { return m.name == "old tiles"; });
    ASSERT_NE(material, room.materials.end());
    ASSERT_NE(material->image, nullptr);
    EXPECT_EQ(material->image->levels[0].width, 64);
    EXPECT_EQ(material->scale_m, 1.5f);
    ASSERT_NE(material->metallic_roughness, nullptr);
    EXPECT_EQ(material->metallic_roughness->levels[0].at(0, 0), (Rgb8{0, 100, 255}));
    // Its pictures span 1.5 m, wherever it lies.
    for (const Mesh& mesh : room.meshes) {
        if (&room.materials[static_cast<std::size_t>(mesh.material)] != &*material) continue;
        for (std::size_t t = 0; t + 1 < mesh.triangles.size(); t += 3) {
            const std::uint32_t a = mesh.triangles[t], b = mesh.triangles[t + 1];
            EXPECT_NEAR(length(mesh.positions[a] - mesh.positions[b]), 1.5f * length(mesh.coords[a] - mesh.coords[b]),
                        1e-3f);
        }
    }
    // Wherever else the room has it, too.
    PromptSpec doors = understand_prompt("a kitchen with an old tiles door and old tiles walls", true, own);
    for (const Material& m : make_room(doors, kRun).materials)
        EXPECT_TRUE(m.pattern != Pattern::image || m.image) << m.name;
    // The document names it, and needs the folder.
    const FurnishedRoom furnished = furnish_room(spec, kRun, {});
    const RoomDocument document = document_of(spec, furnished, kRun.seed);
    ASSERT_TRUE(document.surfaces.floor);
    EXPECT_EQ(document.surfaces.floor->name, "old tiles");
    const RoomDocument read = read_document(document_json(document).dump(), "room.json");
    DocumentRoom again = furnish_document(read, "room.json", own, kRun);
    const std::vector<Material> built = room_of(again).materials;
    EXPECT_TRUE(
        std::any_of(built.begin(), built.end(), [](const Material& m) { return m.name == "old tiles" && m.image; }));
    DocumentRoom without = furnish_document(read, "room.json", nullptr, kRun);
    EXPECT_NE(refusal([&] { room_of(without); }).find("texture \"old tiles\""), std::string::npos);
}

TEST(NormalsOfHeight, AreThoseOfAPlane) {
    ImageRgb8 slope(64, 64);  // 1/64 of the depth a pixel, to the right
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) slope.at(x, y).g = static_cast<std::uint8_t>(4 * x);
    // 0.5 m deep over 1 m: it rises by half of what it runs.
    const Rgb8 n = normals_of_height(slope, 0.5f * 255 / 256, 1).at(32, 32);
    EXPECT_NEAR(n.r / 127.5 - 1, -0.5 / std::hypot(0.5, 1), 0.01);
    EXPECT_NEAR(n.g / 127.5 - 1, 0, 0.01);
    EXPECT_NEAR(n.b / 127.5 - 1, 1 / std::hypot(0.5, 1), 0.01);
}

TEST_F(UserAssets, WhatIsWrongIsNamedAndTheRestGoesOn) {
    put("armchair.glb", glb_of({block({0.8f, 0.9f, 0.8f})}));
    put("broken_sofa.glb", "glTF, but not for long");
    put("oak_window.glb", glb_of({block({1, 1, 0.1f})}));
    put(kAssetsFile,
        "[[model]]\nfile = \"armchair.glb\"\nheigth_m = 1\n\n[[model]]\nfile = \"nothing.glb\"\n\n"
        "[[model]]\nfile = \"../outside.glb\"\n");
    const auto own = pack();
    ASSERT_EQ(complaints_.size(), 5u) << fmt::format("{}", fmt::join(complaints_, "\n"));
    EXPECT_NE(complaints_[0].find("assets.toml:3: unknown key \"heigth_m\""), std::string::npos) << complaints_[0];
    EXPECT_NE(complaints_[0].find("did you mean height_m?"), std::string::npos) << complaints_[0];
    EXPECT_NE(complaints_[1].find("\"nothing.glb\" is not there"), std::string::npos) << complaints_[1];
    EXPECT_NE(complaints_[2].find("below the folder"), std::string::npos) << complaints_[2];
    EXPECT_NE(complaints_[3].find("oak_window.glb: a window belongs to the room"), std::string::npos) << complaints_[3];
    EXPECT_NE(complaints_[4].find("broken_sofa.glb"), std::string::npos) << complaints_[4];
    EXPECT_NE(own->choose_users("armchair", 1), nullptr);
    EXPECT_EQ(own->choose_users("sofa", 1), nullptr);
    EXPECT_NE(refusal([&] { assets_named((root_ / "none").string()); }).find("a folder of models"), std::string::npos);
}

TEST_F(UserAssets, RowsAreAddedOnlyForWhatCanBeUsed) {
    put("from/Chair.glb", glb_of({block({0.5f, 0.9f, 0.5f})}));
    put("from/bad.glb", "nothing");
    const fs::path folder = root_ / "mine";
    NewModel model;
    model.kind = "dining chair", model.names = {"my \"good\" chair"}, model.attribution.license = "CC0";
    const Inventory added = add_model(folder, root_ / "from/Chair.glb", model, kRun);
    ASSERT_EQ(added.items.size(), 1u);
    EXPECT_NE(refusal([&] { add_model(folder, root_ / "from/bad.glb", {}, kRun); }).find("bad.glb"), std::string::npos);
    EXPECT_NE(refusal([&] { add_model(folder, root_ / "from/Chair.glb", {}, kRun); }).find("already"),
              std::string::npos);
    const auto found = read_user_assets(folder);
    EXPECT_EQ(found.complaints, std::vector<std::string>{});
    ASSERT_EQ(found.models.size(), 1u);
    EXPECT_EQ(found.models[0].names.front(), "my \"good\" chair");
    EXPECT_EQ(found.models[0].attribution.license, "CC0");
    EXPECT_EQ(std::distance(fs::recursive_directory_iterator(folder), {}), 2);
}

TEST(PhotographedSky, TheSunIsTakenOutAndNoLightIsLost) {
    ImageColor image(256, 128, Vec3f{1, 1.2f, 1.5f});
    const EquirectSize size{256, 128};
    Vec3<double> irradiance{};
    for (int y = 40; y < 43; ++y)
        for (int x = 200; x < 203; ++x) {
            image.at(x, y) = {9000, 8000, 6000};
            irradiance += Vec3<double>{9000, 8000, 6000} * pixel_solid_angle(y, size);
        }
    const double even = 0.2126 * 1 + 0.7152 * 1.2 + 0.0722 * 1.5;
    const PhotographedSky sky = photographed_sky(image, "sky");
    EXPECT_GT(dot(sky.sun_dir, direction_of_pixel(201, 41, size)), 0.9999f);
    // The sun and what is left of it in the picture, over the sky's own light.
    double left = 0, total = 0, mean = 0, weight = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 256; ++x) {
            const double w = pixel_solid_angle(y, size);
            (std::abs(x - 201) < 2 && std::abs(y - 41) < 2 ? left : total) += w * static_cast<double>(
                                                                                      luminance(sky.picture.at(x, y)));
            mean += w * static_cast<double>(luminance(sky.picture.at(x, y))), weight += w;
        }
    EXPECT_NEAR(mean / weight, 1, 1e-4);
    const double scale = total / (even * (weight - 9 * pixel_solid_angle(41, size)));
    const double sun = 0.2126 * irradiance.x + 0.7152 * irradiance.y + 0.0722 * irradiance.z;
    EXPECT_NEAR((static_cast<double>(luminance(sky.sun_irradiance)) + left) / (sun * scale), 1, 0.01);

    EXPECT_EQ(max_component(photographed_sky(ImageColor(64, 32, Vec3f{1, 1, 1}), "even").sun_irradiance), 0);
    EXPECT_THROW(photographed_sky(ImageColor(64, 48, Vec3f{1, 1, 1}), "odd"), Error);
    EXPECT_THROW(photographed_sky(ImageColor(64, 32, Vec3f{}), "black"), Error);
}

TEST(PhotographedSky, TurnsToTheRight) {
    ImageColor image(360, 180);
    image.at(180, 90) = {1, 1, 1};
    EXPECT_EQ(turned_to(image, 0), image);
    EXPECT_EQ(turned_to(image, kPi / 2).at(270, 90).x, 1);
    EXPECT_EQ(turned_to(image, -kPi / 2).at(90, 90).x, 1);
}

}  // namespace
}  // namespace fastscene

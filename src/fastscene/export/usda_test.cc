// What room.usda says of a room whose geometry is known. tests/readers asks other programs to read it.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "fastscene/export/identities.h"
#include "fastscene/export/instances.h"
#include "fastscene/export/room_usda.h"
#include "fastscene/export/test_rooms.h"
#include "fastscene/io/usda.h"
#include "fastscene/scene/box.h"

namespace fastscene {
namespace {

const Run kSilent{7, nullptr, {}};

std::size_t count_of(const std::string& text, const std::string& word) {
    std::size_t count = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + word.size())) ++count;
    return count;
}

TEST(UsdaText, NamesAndQuotes) {
    EXPECT_EQ(usda_name("armchair-1"), "armchair_1");
    EXPECT_EQ(usda_name("3 seats"), "_3_seats");
    EXPECT_EQ(usda_name(""), "_");
    EXPECT_EQ(usda_quoted("a \"red\" \\ chair\n"), "\"a \\\"red\\\" \\\\ chair \"");
    std::string text;
    for (const float v : {1.f, -0.00001f, 0.25f, -2.5f, 100.f}) append_decimals(text, v, 3), text += ' ';
    EXPECT_EQ(text, "1 0 0.25 -2.5 100 ");
}

TEST(RoomUsda, HasAPrimPerThingWithItsLabels) {
    const Room room = room_from("a bedroom with two chairs and a desk");
    const UsdaRoom usda = room_usda(room, "room_textures", {.texels_per_metre = 16}, kSilent);
    EXPECT_TRUE(usda.text.starts_with("#usda 1.0\n"));
    for (const char* line : {"metersPerUnit = 1\n", "upAxis = \"Y\"\n", "defaultPrim = \"Room\"\n"})
        EXPECT_EQ(count_of(usda.text, line), 1u) << line;
    EXPECT_EQ(count_of(usda.text, "{"), count_of(usda.text, "}"));
    const std::vector<Instance> instances = instances_of(room);
    for (std::size_t i = 1; i < instances.size(); ++i) {
        const std::string begin = fmt::format("def Xform \"{}\" (", usda_name(instances[i].id));
        const std::size_t at = usda.text.find(begin);
        ASSERT_NE(at, std::string::npos) << begin;
        const std::string head = usda.text.substr(at, usda.text.find("def ", at + begin.size()) - at);
        EXPECT_NE(head.find(fmt::format("string id = \"{}\"", instances[i].id)), std::string::npos) << head;
        EXPECT_NE(head.find(fmt::format("int primvars:instance = {}\n", i)), std::string::npos) << head;
        EXPECT_NE(head.find(fmt::format("semantics:labels:class = [\"{}\"]", instances[i].kind)), std::string::npos);
    }
    std::set<std::string> files;
    for (const NamedBytes& texture : usda.textures) {
        EXPECT_TRUE(files.insert(texture.name).second);
        EXPECT_NE(usda.text.find("@./room_textures/" + texture.name + "@"), std::string::npos);
    }
    EXPECT_EQ(count_of(usda.text, "asset inputs:file"), files.size());
}

TEST(RoomUsda, ThingsThatAreEqualReferToTheFirst) {
    Room room;
    room.materials.push_back({.name = "paint"});
    for (int i = 0; i < 3; ++i) {
        RoomObject object;
        object.kind = "stool";
        object.world_from_object = {rotation_about(Vec3f{0, 1, 0}, static_cast<float>(i)),
                                    {static_cast<float>(i), 1, 2}};
        Mesh mesh = box_mesh({-0.2f, 0, -0.2f}, {0.2f, i == 2 ? 0.7f : 0.5f, 0.2f}, 0, i);
        for (Vec3f& p : mesh.positions) p = object.world_from_object * p;
        for (Vec3f& n : mesh.normals) n = object.world_from_object.rotation * n;
        room.objects.push_back(object);
        room.meshes.push_back(mesh);
    }
    const std::string text = room_usda(room, "t", {}, kSilent).text;
    EXPECT_EQ(count_of(text, "def Mesh"), 2u);
    EXPECT_EQ(count_of(text, "references = </Room/stool_1/geometry>"), 1u);
    EXPECT_EQ(count_of(text, "instanceable = true"), 1u);
    EXPECT_EQ(count_of(text, "material:binding = </Room/Materials/paint>"), 2u);
}

}  // namespace
}  // namespace fastscene

// The doors of the kinds of rooms: their leaves, what they are made of, and where they stand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "fastscene/base/error.h"
#include "fastscene/rooms/layout.h"
#include "fastscene/rooms/plan.h"
#include "fastscene/rooms/room_type.h"
#include "fastscene/rooms/test_prompts.h"

namespace fastscene {
namespace {

struct Built {
    Plan plan;
    Room room;
};
Built built(const std::string& text, std::uint64_t seed) {
    PromptSpec spec = read(text);
    Run run;
    run.seed = seed;
    Built out{furnish_room(spec, run).plan, {}};
    out.room.seed = seed;
    build_shell(out.plan, out.room);
    return out;
}
const Opening* door_of(const Plan& plan) {
    const auto found = std::find_if(plan.openings.begin(), plan.openings.end(),
                                    [](const Opening& o) { return o.kind == Opening::Kind::door; });
    return found == plan.openings.end() ? nullptr : &*found;
}
std::set<std::string> materials_of_door(const Room& room) {
    std::set<std::string> out;
    for (const Mesh& mesh : room.meshes)
        if (mesh.object >= 0 && room.objects[static_cast<std::size_t>(mesh.object)].kind == "door")
            out.insert(room.materials[static_cast<std::size_t>(mesh.material)].name);
    return out;
}

TEST(Doors, AreAsWideAndHighAsTheirKindHasThem) {
    for (const char* text : {"a church", "a bookstore", "a warehouse", "a classroom", "a bedroom", "a cinema"})
        for (std::uint64_t seed = 0; seed < 3; ++seed) {
            const Built b = built(text, seed);
            const Opening* door = door_of(b.plan);
            ASSERT_TRUE(door) << text;
            EXPECT_NEAR(door->u1 - door->u0, b.plan.door.width_m, 1e-4f) << text;
            EXPECT_LE(door->y1, b.plan.door.height_m + 1e-4f) << text;
            EXPECT_EQ(door->shape == Opening::Shape::arched, b.plan.door.arched) << text;
        }
    EXPECT_FALSE(door_of(built("a shopping mall", 1).plan));
}

// A pair of leaves is the same seen in a mirror, and all of a door stands on the floor, before its wall, within what
// its opening and its casing take.
TEST(Doors, TwoLeavesAreMirrorImages) {
    for (const char* text : {"a church", "a bookstore", "a warehouse", "a lecture hall", "a banquet hall"}) {
        const Built b = built(text, 5);
        const Opening* door = door_of(b.plan);
        ASSERT_TRUE(door && door->u1 - door->u0 > 1.25f) << text;
        const WallFace face = b.plan.wall(door->wall);
        const float middle = (door->u0 + door->u1) / 2;
        double moment = 0;
        int vertices = 0;
        for (const Mesh& mesh : b.room.meshes) {
            if (mesh.object < 0 || b.room.objects[static_cast<std::size_t>(mesh.object)].kind != "door") continue;
            for (const Vec3f& p : mesh.positions) {
                const float u = dot(p - face.origin, face.along), w = dot(p - face.origin, face.inward);
                moment += static_cast<double>(u - middle), ++vertices;
                EXPECT_GT(p.y, -1e-4f) << text;
                EXPECT_LT(p.y, door->y1 + 0.1f) << text;
                EXPECT_TRUE(u > door->u0 - 0.1f && u < door->u1 + 0.1f) << text;
                EXPECT_TRUE(w > -0.03f && w < 0.1f) << text;
            }
        }
        ASSERT_GT(vertices, 100) << text;
        EXPECT_NEAR(moment / vertices, 0, 2e-3) << text;
    }
}

TEST(Doors, AreOfTheirFormAndInTheColorAskedFor) {
    EXPECT_TRUE(materials_of_door(built("a bakery", 2).room).contains("etched glass"));
    EXPECT_TRUE(materials_of_door(built("a boiler room", 2).room).contains("steel door"));
    EXPECT_FALSE(materials_of_door(built("a bedroom", 2).room).contains("steel door"));
    const Built red = built("a classroom with a red door", 3);
    const auto of_red = std::find_if(red.room.objects.begin(), red.room.objects.end(),
                                     [](const RoomObject& o) { return o.kind == "door"; });
    ASSERT_NE(of_red, red.room.objects.end());
    EXPECT_EQ(of_red->color, "red");
}

TEST(Doors, ErrorsOfRoomFilesNameTheKey) {
    const auto fails = [](const std::string& lines, const std::string& expected) {
        std::string text;
        for (const char* line :
             {"name = \"x\"", "title = \"x\"", "rank = 1", "wet = false", "for_children = false", "deep_paints = false",
              "next_rooms = [\"hallway\", \"hallway\"]", "furnished_as = \"bedroom\"", "[size]", "width_m = [3, 4]",
              "depth_m = [3, 4]", "[shape]", "breast_probability = 0", "corner_probability = 0", "bay_probability = 0",
              "alcove_probability = 0", "doorway_probability = 0"})
            text += std::string(line) + "\n";
        try {
            read_room_type(text + "[door]\n" + lines, "x.toml");
            FAIL() << "no error for " << lines;
        } catch (const Error& e) {
            EXPECT_NE(std::string(e.what()).find(expected), std::string::npos) << e.what();
        }
    };
    fails("form = \"oval\"", "panelled");
    fails("width_m = 9", "width_m");
    fails("leaves = 2", "leaves");
}

}  // namespace
}  // namespace fastscene

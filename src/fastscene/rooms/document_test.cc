#include "fastscene/rooms/document.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "fastscene/base/file.h"
#include "fastscene/base/parallel.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/pack.h"

namespace fastscene {
namespace {

template <class T>
void add(std::string& bytes, const std::vector<T>& values) {
    if (!values.empty()) bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}
void add(std::string& bytes, std::initializer_list<Vec3f> values) { add(bytes, std::vector<Vec3f>(values)); }

// All of a room that a picture shows or that a file tells.
std::string bytes_of(const Room& room) {
    std::string out = room_json(room, {}).dump() + std::to_string(room.seed);
    for (const Mesh& m : room.meshes) {
        add(out, m.positions), add(out, m.normals), add(out, m.coords), add(out, m.triangles);
        out += fmt::format("{} {};", m.material, m.object);
    }
    for (const Material& m : room.materials) {
        add(out, {m.color_a,
                  m.color_b,
                  m.color_c,
                  m.emission,
                  {m.scale_m, m.bump_m, m.roughness},
                  {m.specular, m.metal, m.transmission},
                  {m.crease_m, m.sheen, 0}});
        out += fmt::format("{} {} {} {} {};", m.name, static_cast<int>(m.pattern), m.mirror, m.burns, m.seed);
    }
    for (const Portal& p : room.portals) add(out, {p.corner, p.edge_u, p.edge_v});
    const Sky& s = room.sky;
    add(out, {s.sun_dir, s.sun_irradiance, s.zenith, s.horizon, s.ground, {s.clouds, s.seen, s.sun_limit}});
    out += fmt::format("{} {} {} {}", static_cast<int>(s.time), static_cast<int>(s.view), s.snow, s.seed);
    add(out, {room.look.white, room.min_corner, room.max_corner});
    return out;
}

const fastscene::Run kRun{7, nullptr, {}}, kNoSeed{};

void expect_same_room(const std::string& prompt, const std::shared_ptr<const FurniturePack>& pack = nullptr) {
    SCOPED_TRACE(prompt);
    PromptSpec spec = understand_prompt(prompt, false, pack);
    const FurnishedRoom furnished = furnish_room(spec, kRun);
    const RoomDocument document = document_of(spec, furnished, kRun.seed);
    const std::string room = bytes_of(room_of(spec, furnished, kRun)), text = document_json(document).dump(2);

    const RoomDocument again = read_document(text, "room.json");
    EXPECT_EQ(document_json(again).dump(2), text);
    DocumentRoom built = furnish_document(again, "room.json", pack, kNoSeed);
    EXPECT_TRUE(bytes_of(room_of(built.spec, built.furnished, kRun)) == room);
    EXPECT_EQ(document_json(completed(again, "room.json", pack, kNoSeed)).dump(2), text);
}

std::string error_of(const std::string& text) {
    try {
        furnish_document(read_document(text, "room.json"), "room.json", nullptr, kRun);
    } catch (const Error& e) {
        return e.what();
    }
    return {};
}
std::string with(const std::string& fields) {
    return "{\"format\": \"fastscene-room\", \"version\": 1,\n\"room\": \"bedroom\"" +
           (fields.empty() ? "" : ",\n" + fields) + "}";
}
const std::string kPlan = "\"plan\": {\"width_m\": 4, \"depth_m\": 4, \"height_m\": 2.6, \"openings\": []}";
std::string thing(const std::string& id, const std::string& kind, const std::string& at, const std::string& more = "") {
    return "{\"id\": \"" + id + "\", \"kind\": \"" + kind + "\", \"position\": [" + at + "]" + more + "}";
}

TEST(RoomDocument, BuildsTheSameTrianglesForEveryRoomType) {
    const std::vector<std::string> rooms = room_types(), all = styles();
    parallel_for(static_cast<std::int64_t>(rooms.size()), 1, [&](std::int64_t begin, std::int64_t end) {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
            expect_same_room("a " + all[i % all.size()] + " " + room_title(rooms[i]));
    });
}

TEST(RoomDocument, BuildsTheSameTrianglesOfWhatPromptsAskFor) {
    for (const char* prompt :
         {"a cozy bedroom with a red armchair, an arched window and a loft bed in the evening",
          "a bathroom with blue tiles, gold taps and a freestanding tub on a rainy night",
          "a living room with a wall mounted tv, a fireplace and a picture on the mantelpiece, with a neon light in "
          "purple",
          "an attic study with skylights and a green velvet sofa under the slope",
          "a bedroom with an en-suite bathroom and a black door, everything is pink",
          "an abandoned loft with brick walls", "a snowy kitchen with an island, marble countertops and three stools"})
        expect_same_room(prompt);
}

TEST(RoomDocument, NamesModelsOfTheFurniturePack) {
    std::vector<std::string> complaints;
    const auto pack = FurniturePack::open(FurniturePack::default_folder(), {Assets::cc0, {}}, complaints);
    if (!pack) GTEST_SKIP() << "no furniture pack is installed";
    expect_same_room("a living room with a grand piano and a dog", pack);
}

TEST(RoomDocument, KeepsWhatIsGivenWhenItFurnishes) {
    const std::string text = with(
        "\"seed\": 3, \"furnish\": true, \"plan\": {\"width_m\": 4.4, \"depth_m\": 4.8},\n"
        "\"things\": [" +
        thing("my bed", "bed", "0, 0, 1.2", ", \"yaw_deg\": 180, \"color\": \"#336699\"") + "]");
    const RoomDocument out = completed(read_document(text, "room.json"), "room.json", nullptr, kRun);
    ASSERT_GT(out.things.size(), 5u);
    EXPECT_EQ(out.things[0].id, "my bed");
    EXPECT_EQ(out.things[0].position, (Vec3f{0, 0, 1.2f}));
    EXPECT_EQ(out.things[0].color, "#336699");
    EXPECT_EQ(
        std::count_if(out.things.begin(), out.things.end(), [](const DocumentThing& t) { return t.kind == "bed"; }), 1);
    EXPECT_FALSE(out.furnish);
    // All of it is told: completing it again changes nothing.
    EXPECT_EQ(document_json(completed(out, "room.json", nullptr, kNoSeed)).dump(), document_json(out).dump());
}

TEST(RoomDocument, NamesOfWoodAreBoardsOnFloors) {
    const RoomDocument named = read_document(with("\"surfaces\": {\"floor\": \"oak\", \"wood\": \"oak\"}"),
                                             "room.json");
    EXPECT_EQ(named.surfaces.floor->pattern, Pattern::planks);
    EXPECT_EQ(named.surfaces.wood->pattern, Pattern::wood);
}

TEST(RoomDocument, IsTakenAsItIs) {
    const RoomDocument bare = completed(read_document(with(""), "room.json"), "room.json", nullptr, kRun);
    EXPECT_TRUE(bare.things.empty());
    ASSERT_TRUE(bare.plan.openings);
    EXPECT_FALSE(bare.plan.openings->empty());

    const std::string lamp = thing("lamp", "floor_lamp", "1, 0, 1", ", \"size_m\": [0, 1.2, 0]");
    DocumentRoom room = furnish_document(read_document(with(kPlan + ", \"things\": [" + lamp + "]"), "room.json"),
                                         "room.json", nullptr, kRun);
    ASSERT_EQ(room.furnished.placed.size(), 1u);
    EXPECT_NEAR(room.furnished.placed[0].piece.size_m.y, 1.2f, 1e-3f);
    EXPECT_TRUE(room.furnished.plan.openings.empty());
}

TEST(RoomDocument, TakesAnOutline) {
    const auto plan = [](const std::string& corners) {
        return with("\"plan\": {\"polygon\": [" + corners + "], \"openings\": []}");
    };
    const DocumentRoom room = furnish_document(
        read_document(plan("[-3,-2],[3,-2],[3,0.5],[0,0.5],[0,2],[-3,2]"), "room.json"), "room.json", nullptr, kRun);
    EXPECT_FLOAT_EQ(room.furnished.plan.width, 6);
    EXPECT_FLOAT_EQ(room.furnished.plan.depth, 4);
    ASSERT_EQ(room.furnished.plan.blocks.size(), 1u);
    EXPECT_EQ(room.furnished.plan.blocks[0].low, (Vec2f{0, 0.5f}));
    EXPECT_NE(error_of(plan("[-2,-2],[2,-2],[2,1],[-1,1],[-1,-3],[-2,-3]")).find("crosses itself"), std::string::npos);
    EXPECT_NE(error_of(plan("[-2,-2],[2,-2],[1,2],[-2,2]")).find("slanted"), std::string::npos);

    const DocumentRoom cut = furnish_document(
        read_document(plan("[-2,-3],[1,-3],[2,-2],[2,3],[-1,3],[-2,2]"), "room.json"), "room.json", nullptr, kRun);
    ASSERT_EQ(cut.furnished.plan.blocks.size(), 2u);
    for (const Block& b : cut.furnished.plan.blocks) EXPECT_EQ(b.kind, Block::Kind::cut);
    EXPECT_EQ(cut.furnished.plan.outline().size(), 6u);
}

TEST(RoomDocument, ErrorsOfVaultsAndCutCorners) {
    const auto plan = [](const std::string& fields) {
        return with("\"plan\": {\"width_m\": 4, \"depth_m\": 4, \"height_m\": 3, \"openings\": [], " + fields + "}");
    };
    EXPECT_NE(error_of(plan("\"vault\": \"dome\"")).find("/plan/spring_m"), std::string::npos);
    EXPECT_NE(error_of(plan("\"vault\": \"dome\", \"spring_m\": 3.5")).find("/plan/spring_m"), std::string::npos);
    EXPECT_NE(error_of(plan("\"mezzanine_m\": 1.5")).find("/plan/mezzanine_floor_m"), std::string::npos);
    EXPECT_NE(error_of(plan("\"mezzanine_m\": 4.5, \"mezzanine_floor_m\": 2")).find("/plan/mezzanine_m"),
              std::string::npos);
    EXPECT_NE(error_of(plan("\"oculus_m\": 0.4")).find("/plan/oculus_m"), std::string::npos);
    EXPECT_NE(
        error_of(plan("\"blocks\": [{\"kind\": \"cut\", \"low\": [0, 0], \"high\": [1, 1]}]")).find("/plan/blocks/0"),
        std::string::npos);
}

TEST(RoomDocument, ErrorsNameThePlaceAndTheNearestWord) {
    const std::string wardrobe = thing("wardrobe", "wardrobe", "1, 0, 1");
    const std::vector<std::array<std::string, 2>> cases{
        {"{\"format\": \"fastscene-room\", \"version\": 2, \"room\": \"bedroom\"}", "a newer fastscene wrote it"},
        {"{\"version\": 1}", "expected \"format\""},
        {"[1, 2", "room.json:1: expected JSON"},
        {"22E422", "room.json: expected numbers that a computer can hold"},
        {with("\"styel\": \"modern\""), "room.json:3: /styel: unknown key \"styel\"; did you mean \"style\"?"},
        {with("\"style\": 3"), "room.json:3: /style: expected a text, found 3"},
        {with("\"style\": \"modrn\""), "/style: unknown \"modrn\"; did you mean \"modern\"?"},
        {with("\"light\": {\"hour\": \"noon\"}"), "expected one of morning, day, evening, dusk, night"},
        {with("\"things\": [" + thing("a", "sofa", "0, 0") + "]"),
         "room.json:3: /things/0/position: expected 3 numbers"},
        {with("\"things\": [" + thing("a", "soffa", "0, 0, 0") + "]"),
         "/things/0/kind: unknown \"soffa\"; did you mean \"sofa\"?"},
        {with("\"things\": [" + thing("a", "chair", "0, 0, 0") + "," + thing("a", "chair", "1, 0, 0") + "]"),
         "/things/1/id: \"a\" stands twice"},
        {with("\"things\": [" + thing("a", "vase", "0, 0, 0", ", \"on\": \"table\"") + "]"),
         "/things/0/on: unknown \"table\""},
        {with(kPlan + ", \"things\": [" + thing("a", "wardrobe", "2, 0, 0") + "]"), "a reaches into a wall"},
        {with(kPlan + ", \"camera\": {\"position\": [1, 1.5, 1]}, \"things\": [" + wardrobe + "]"),
         "the camera stands inside wardrobe"},
        {with(kPlan + ", \"camera\": {\"position\": [5, 1.5, 1]}"), "expected a place in the room"}};
    for (const auto& [text, expected] : cases)
        EXPECT_NE(error_of(text).find(expected), std::string::npos) << text << "\n" << error_of(text);
}

TEST(RoomDocument, SchemaIsPublished) {
    const std::filesystem::path file = std::filesystem::path(FASTSCENE_SOURCE_DIR) / "docs/reference/room.schema.json";
    EXPECT_EQ(read_file(file), document_schema().dump(2) + "\n")
        << "write it with: fastscene rooms schema > docs/reference/room.schema.json";
}

}  // namespace
}  // namespace fastscene

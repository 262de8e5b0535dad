// Laws of the exported files: what glTF must say of a room whose geometry is known.
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include "fastscene/export/bake.h"
#include "fastscene/export/collision.h"
#include "fastscene/export/gltf.h"
#include "fastscene/export/identities.h"
#include "fastscene/export/labels.h"
#include "fastscene/export/meshopt.h"
#include "fastscene/export/room_glb.h"
#include "fastscene/export/test_rooms.h"
#include "fastscene/image/color.h"
#include "fastscene/io/image_io.h"
#include "fastscene/rooms/rooms.h"
#include "fastscene/scene/box.h"
#include "fastscene/trace/standable.h"
#include "fastscene/trace/texture.h"
#include "fastscene/trace/trace.h"

namespace fastscene {
namespace {

const Run kQuiet{7, nullptr, {}};

Room bedroom() {
    PromptSpec spec = understand_prompt("a bedroom with two chairs and a desk", false);
    return make_room(spec, kQuiet);
}

// A reader of its own: it shares no code with the writer.
struct Glb {
    Json json;
    std::string binary;

    explicit Glb(const std::string& bytes) {
        std::uint32_t length = 0;
        std::memcpy(&length, bytes.data() + 12, 4);
        json = Json::parse(bytes.substr(20, length));
        binary = bytes.substr(20 + length + 8);
    }
    template <class T>
    std::vector<T> values(std::size_t accessor) const {
        const Json& a = json["accessors"][accessor];
        const Json& view = json["bufferViews"][a["bufferView"].get<std::size_t>()];
        std::vector<T> out(a["count"].get<std::size_t>());
        std::memcpy(out.data(), binary.data() + view["byteOffset"].get<std::size_t>(), out.size() * sizeof(T));
        return out;
    }
    std::string view(std::size_t index) const {
        const Json& v = json["bufferViews"][index];
        return binary.substr(v["byteOffset"].get<std::size_t>(), v["byteLength"].get<std::size_t>());
    }
    std::size_t triangles(const Json& mesh) const {
        std::size_t sum = 0;
        for (const Json& p : mesh["primitives"])
            sum += json["accessors"][p["indices"].get<std::size_t>()]["count"].get<std::size_t>() / 3;
        return sum;
    }
    Rigid pose(const Json& node) const {
        Rigid out;
        if (node.contains("rotation")) {
            const Json& q = node["rotation"];
            out.rotation = matrix_of(Quatf{q[3], q[0], q[1], q[2]});
        }
        if (node.contains("translation"))
            out.translation = {node["translation"][0], node["translation"][1], node["translation"][2]};
        return out;
    }
    const Json& node(const std::string& name) const {
        for (const Json& n : json["nodes"])
            if (n["name"] == name) return n;
        throw Error("no node {}", name);
    }
};

TEST(RoomGlb, HasANodePerThingAndKeepsAllTriangles) {
    const Room room = bedroom();
    const Glb glb(room_glb_bytes(room, {.texels_per_metre = 16}, kQuiet));
    std::map<std::string, std::size_t> expected;
    const std::vector<std::string> ids = object_ids(room);
    std::size_t shell = 0;
    for (const Mesh& mesh : room.meshes)
        (mesh.object < 0 ? shell : expected[ids[static_cast<std::size_t>(mesh.object)]]) += mesh.triangles.size() / 3;
    std::set<std::string> seen;
    std::size_t shell_found = 0;
    for (const Json& node : glb.json["nodes"]) {
        if (!node.contains("extras")) continue;
        const std::string id = node["extras"]["id"];
        EXPECT_TRUE(seen.insert(id).second) << id;
        const std::size_t found = node.contains("mesh")
                                      ? glb.triangles(glb.json["meshes"][node["mesh"].get<std::size_t>()])
                                      : 0;
        if (node["extras"].contains("shell")) shell_found += found;
        else EXPECT_EQ(found, expected[id]) << id;
    }
    for (const std::string& id : ids) EXPECT_TRUE(seen.contains(id)) << id;
    EXPECT_EQ(shell_found, shell);
}

// What a reader of EXT_meshopt_compression finds: the same triangles, vertices within what the header says.
TEST(RoomGlb, CompressionKeepsTheMeshes) {
    const std::string plain = room_glb_bytes(bedroom(), {.texels_per_metre = 16}, kQuiet), small = with_meshopt(plain);
    EXPECT_EQ(with_meshopt(plain), small);
    const Glb before(plain), after(small);
    EXPECT_EQ(after.json["extensionsRequired"], Json::array({"EXT_meshopt_compression"}));
    std::size_t raw_bytes = 0, packed_bytes = 0;
    const auto decoded = [&](std::size_t accessor) {
        const Json& view = after
                               .json["bufferViews"][after.json["accessors"][accessor]["bufferView"].get<std::size_t>()];
        const Json& how = view["extensions"]["EXT_meshopt_compression"];
        const std::size_t count = how["count"], stride = how["byteStride"];
        const auto* bytes = reinterpret_cast<const unsigned char*>(after.binary.data()) +
                            how["byteOffset"].get<std::size_t>();
        std::string out(count * stride, '\0');
        const std::size_t length = how["byteLength"];
        raw_bytes += out.size(), packed_bytes += length;
        const int failed = how["mode"] == "TRIANGLES"
                               ? meshopt_decodeIndexBuffer(out.data(), count, stride, bytes, length)
                               : meshopt_decodeVertexBuffer(out.data(), count, stride, bytes, length);
        EXPECT_EQ(failed, 0) << accessor;
        if (how.contains("filter")) meshopt_decodeFilterExp(out.data(), count, stride);
        EXPECT_EQ(view["byteLength"].get<std::size_t>(), out.size());
        return out;
    };
    const auto triangles = [](const std::string& raw, bool shorts) {
        std::vector<std::uint32_t> k(raw.size() / (shorts ? 2 : 4));
        for (std::size_t i = 0; i < k.size(); ++i)
            std::memcpy(&k[i], raw.data() + (shorts ? 2 : 4) * i, shorts ? 2 : 4);
        std::multiset<std::array<std::uint32_t, 3>> out;
        for (std::size_t t = 0; t + 2 < k.size(); t += 3) {
            std::array<std::uint32_t, 3> one{k[t], k[t + 1], k[t + 2]};
            std::rotate(one.begin(), std::min_element(one.begin(), one.end()), one.end());  // the winding stays
            out.insert(one);
        }
        return out;
    };
    for (const Json& mesh : before.json["meshes"])
        for (const Json& p : mesh["primitives"]) {
            const std::size_t indices = p["indices"];
            const Json& accessor = before.json["accessors"][indices];
            const bool shorts = accessor["componentType"] == 5123;
            EXPECT_EQ(triangles(decoded(indices), shorts),
                      triangles(before.view(accessor["bufferView"].get<std::size_t>()), shorts));
            for (const auto& [name, at] : p["attributes"].items()) {
                const std::string found = decoded(at),
                                  wanted = before.view(
                                      before.json["accessors"][at.get<std::size_t>()]["bufferView"].get<std::size_t>());
                ASSERT_EQ(found.size(), wanted.size());
                const std::size_t numbers = found.size() / sizeof(float),
                                  width = name == "TEXCOORD_0" ? 2 : 3;  // components
                std::vector<float> f(numbers), w(numbers);
                std::memcpy(f.data(), found.data(), found.size()), std::memcpy(w.data(), wanted.data(), wanted.size());
                const float share = name == "NORMAL" ? 1.f / 4096 : 1.f / 65536;
                for (std::size_t i = 0; i < numbers; i += width) {
                    float largest = 1;
                    for (std::size_t c = 0; c < width; ++c) largest = std::max(largest, std::fabs(w[i + c]));
                    for (std::size_t c = 0; c < width; ++c) ASSERT_NEAR(f[i + c], w[i + c], share * largest) << name;
                }
            }
        }
    EXPECT_LT(2 * packed_bytes, raw_bytes);
    EXPECT_THROW(with_meshopt("no file"), Error);
}

// Every vertex lands at (-x, -y, z) of its world position: a half turn, so triangles keep their winding.
TEST(RoomGlb, TurnsTheWorldWithoutMirroringIt) {
    const Room room = bedroom();
    const Glb glb(room_glb_bytes(room, {.texels_per_metre = 16}, kQuiet));
    const std::vector<std::string> ids = object_ids(room);
    const Vec3f x = kGltfAxes.column(0), y = kGltfAxes.column(1), z = kGltfAxes.column(2);
    EXPECT_EQ(dot(cross(x, y), z), 1.f);
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const Json& node = glb.node(ids[i]);
        if (!node.contains("mesh")) continue;
        const Rigid pose = glb.pose(node);
        Vec3<double> found{}, wanted{};  // sums of vectors of areas: winding and pose at once
        Vec3f low{1e9f, 1e9f, 1e9f}, wanted_low = low;
        for (const Json& p : glb.json["meshes"][node["mesh"].get<std::size_t>()]["primitives"]) {
            const auto positions = glb.values<Vec3f>(p["attributes"]["POSITION"].get<std::size_t>());
            const Json& indices = glb.json["accessors"][p["indices"].get<std::size_t>()];
            std::vector<std::uint32_t> triangles;
            if (indices["componentType"] == 5123)
                for (const auto k : glb.values<std::uint16_t>(p["indices"].get<std::size_t>())) triangles.push_back(k);
            else triangles = glb.values<std::uint32_t>(p["indices"].get<std::size_t>());
            for (std::size_t t = 0; t < triangles.size(); t += 3) {
                const Vec3f a = pose * positions[triangles[t]], b = pose * positions[triangles[t + 1]],
                            c = pose * positions[triangles[t + 2]], n = cross(b, a) + cross(c, b) + cross(a, c);
                const float weight = a.x + 2 * b.y + 3 * c.z;
                found += Vec3<double>{n.x, n.y, n.z} * static_cast<double>(weight);
                for (std::size_t k = 0; k < 3; ++k) low[k] = std::min({low[k], a[k], b[k], c[k]});
            }
        }
        for (const Mesh& mesh : room.meshes) {
            if (mesh.object != static_cast<int>(i)) continue;
            const auto at = [&](std::size_t k) {
                const Vec3f p = mesh.positions[mesh.triangles[k]];
                return Vec3f{-p.x, -p.y, p.z};
            };
            for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
                const Vec3f a = at(t), b = at(t + 1), c = at(t + 2), n = cross(b, a) + cross(c, b) + cross(a, c);
                const float weight = a.x + 2 * b.y + 3 * c.z;
                wanted += Vec3<double>{n.x, n.y, n.z} * static_cast<double>(weight);
                for (std::size_t k = 0; k < 3; ++k) wanted_low[k] = std::min({wanted_low[k], a[k], b[k], c[k]});
            }
        }
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(low[k], wanted_low[k], 1e-3f) << ids[i];
            EXPECT_NEAR(found[k], wanted[k], 2e-3 * (1 + std::fabs(wanted[k]))) << ids[i];
        }
    }
}

struct Face {
    std::array<Vec3f, 3> corners;
    Vec3f normal;
    std::size_t mesh;
};
std::vector<Face> faces_of_the_shell(const Room& room) {
    std::vector<Face> faces;
    for (std::size_t m = 0; m < room.meshes.size(); ++m) {
        const Mesh& mesh = room.meshes[m];
        const std::string kind = mesh.object < 0 ? "" : room.objects[static_cast<std::size_t>(mesh.object)].kind;
        if (mesh.object >= 0 && kind != "window" && kind != "wainscoting") continue;
        for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
            const auto corner = [&](std::size_t i) { return mesh.positions[mesh.triangles[t + i]]; };
            const Vec3f normal = cross(corner(1) - corner(0), corner(2) - corner(0));
            if (length(normal) > 0) faces.push_back({{corner(0), corner(1), corner(2)}, normalize(normal), m});
        }
    }
    return faces;
}
// The middle of what two faces of two meshes have in common: in one plane, both seen from the same side.
std::optional<Vec3f> middle_of_overlap(const Face& one, const Face& other) {
    constexpr float kOnePlane_m = 1e-4f, kLeastArea_m2 = 1e-4f;
    if (one.mesh == other.mesh || dot(one.normal, other.normal) < 0.9999f ||
        std::fabs(dot(other.corners[0] - one.corners[0], one.normal)) > kOnePlane_m)
        return std::nullopt;
    std::vector<Vec3f> left(one.corners.begin(), one.corners.end());
    for (std::size_t side = 0; side < 3 && !left.empty(); ++side) {
        const Vec3f a = other.corners[side], along = other.corners[(side + 1) % 3] - a;
        const auto within = [&](Vec3f p) { return dot(cross(along, p - a), one.normal); };
        std::vector<Vec3f> kept;
        for (std::size_t i = 0; i < left.size(); ++i) {
            const Vec3f p = left[i], q = left[(i + 1) % left.size()];
            const float at_p = within(p), at_q = within(q);
            if (at_p >= 0) kept.push_back(p);
            if ((at_p < 0) != (at_q < 0)) kept.push_back(p + (q - p) * (at_p / (at_p - at_q)));
        }
        left = std::move(kept);
    }
    Vec3f sum{};
    float area = 0;
    for (std::size_t i = 0; i < left.size(); ++i) {
        sum += left[i];
        if (i >= 2) area += 0.5f * length(cross(left[i - 1] - left[0], left[i] - left[0]));
    }
    if (area < kLeastArea_m2) return std::nullopt;
    return sum / static_cast<float>(left.size());
}

// Where two faces lie in one plane, renderers show one, the other, or black: of walls, trim and sills.
TEST(RoomGlb, NoTwoFacesOfTheShellThatAreSeenLieInOnePlane) {
    for (const std::string text : {"a classic bedroom with a large window", "a victorian living room with wainscoting",
                                   "a cabin with a round window", "a library with an arched window"})
        for (const std::uint64_t seed : {1, 2}) {
            const Room room = room_from(text, seed);
            const TracedRoom traced(room);
            const std::vector<Face> faces = faces_of_the_shell(room);
            for (const Face& one : faces)
                for (const Face& other : faces)
                    if (const auto p = middle_of_overlap(one, other)) {
                        ASSERT_FALSE(traced.sees({}, *p)) << text << ": " << p->x << " " << p->y << " " << p->z;
                    }
        }
}

TEST(RoomGlb, SharesTheMeshOfEqualThings) {
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
    const Glb glb(room_glb_bytes(room, {}, kQuiet));
    EXPECT_EQ(glb.node("stool-1")["mesh"], glb.node("stool-2")["mesh"]);
    EXPECT_NE(glb.node("stool-1")["mesh"], glb.node("stool-3")["mesh"]);
}

// The texel under a vertex shows what the pattern says at its coordinates.
TEST(Bake, PutsThePatternWhereTheMeshShowsIt) {
    Room room;
    Material checker{.name = "tiles",
                     .pattern = Pattern::checker,
                     .color_a = {0.8f, 0.1f, 0.1f},
                     .color_b = {0.05f, 0.1f, 0.7f},
                     .scale_m = 0.5f};
    room.materials.push_back(checker);
    room.meshes.push_back(box_mesh({-1, -0.3f, -2}, {1, 0.3f, 2}, 0));
    const BakedRoom baked = bake(room, same_materials(room.materials), {.texels_per_metre = 200}, kQuiet);
    const ImageRgb8& texture = baked.materials[0].texture;
    const BakedMesh& mesh = baked.meshes[0];
    int compared = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); t += 3)
        for (const auto& [wa, wb] : {std::pair{0.2f, 0.3f}, {0.55f, 0.1f}, {0.13f, 0.71f}}) {
            const auto blend = [&](auto value) {
                return value(mesh.triangles[t]) * wa + value(mesh.triangles[t + 1]) * wb +
                       value(mesh.triangles[t + 2]) * (1 - wa - wb);
            };
            const Vec3f coords = blend([&](std::uint32_t v) { return room.meshes[0].coords[mesh.vertices[v]]; });
            const Vec2f uv = blend([&](std::uint32_t v) { return mesh.uv[v]; });
            const Vec3f n = room.meshes[0].normals[mesh.vertices[mesh.triangles[t]]];
            const Vec3f wanted = sample_texture(checker, {coords, flat_coords(coords, dominant_axis(n)), 0.005f})
                                     .albedo;
            const Rgb8 found = texture.at(static_cast<int>(uv.x * static_cast<float>(texture.width)),
                                          static_cast<int>(uv.y * static_cast<float>(texture.height)));
            // A sample beside a joint may differ.
            compared += length(linear_from_srgb8(found) - wanted) < 0.1f;
        }
    EXPECT_GE(compared, 33) << "of 36";
}

// A screen's picture is the texture of its light.
TEST(RoomGlb, AScreenShinesWithItsPicture) {
    const Room room = room_from("an office with a desk and a monitor");
    const RoomModel model = room_model(room, {.texels_per_metre = 64}, kQuiet);
    int pictures = 0;
    for (const ModelMaterial& m : model.materials) {
        if (m.shown < 0) continue;
        ++pictures;
        EXPECT_GT(max_component(m.emission), 0.f);
        const ImageRgb8& shown = model.textures.at(static_cast<std::size_t>(m.shown));
        const auto [dark, bright] = std::minmax_element(shown.pixels.begin(), shown.pixels.end(),
                                                        [](Rgb8 a, Rgb8 b) { return a.g < b.g; });
        EXPECT_GT(bright->g - dark->g, 100);
    }
    EXPECT_GT(pictures, 0);
    EXPECT_NE(room_glb_bytes(room, model).find("emissiveTexture"), std::string::npos);
}

TEST(Bake, MeanColorIsTheMaterials) {
    for (const Pattern pattern : {Pattern::wood, Pattern::planks, Pattern::fabric, Pattern::tile, Pattern::marble}) {
        Room room;
        room.materials.push_back(
            {.name = "x", .pattern = pattern, .color_a = {0.5f, 0.3f, 0.2f}, .color_b = {0.3f, 0.2f, 0.15f}});
        room.meshes.push_back(box_mesh({-2, -2, -2}, {2, 2, 2}, 0));
        const BakedRoom baked = bake(room, same_materials(room.materials), {.texels_per_metre = 64}, kQuiet);
        const Vec3f wanted = mean_albedo(room.materials[0]), found = baked.materials[0].color;
        for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[k], wanted[k], 0.05f) << static_cast<int>(pattern);
    }
}

TEST(Bake, StaysWithinTheTextureSize) {
    const Room room = bedroom();
    const BakedRoom baked = bake(room, same_materials(room.materials), {.texels_per_metre = 512, .texture_size = 256},
                                 kQuiet);
    int textures = 0;
    for (const BakedMaterial& m : baked.materials) {
        textures += !m.texture.empty();
        EXPECT_LE(std::max(m.texture.width, m.texture.height), 256);
    }
    EXPECT_GT(textures, 5);
    for (const BakedMesh& mesh : baked.meshes)
        for (const Vec2f uv : mesh.uv) EXPECT_TRUE(uv.x >= 0 && uv.y >= 0 && uv.x <= 1 && uv.y <= 1);
}

// More pieces than the texture has room for, even at a texel each.
TEST(Bake, NamesTheMaterialThatDoesNotFit) {
    Room room;
    room.materials.push_back({.name = "old oak", .pattern = Pattern::wood});
    for (int i = 0; i < 60; ++i) {
        const float place = 10.f * static_cast<float>(i);
        room.meshes.push_back(box_mesh({place, place, place}, {place + 1, place + 1, place + 1}, 0));
    }
    try {
        bake(room, same_materials(room.materials), {.texture_size = 64}, kQuiet);
        ADD_FAILURE();
    } catch (const UsageError& e) {
        EXPECT_NE(std::string(e.what()).find("--texture-size: expected room for the"), std::string::npos) << e.what();
        EXPECT_NE(std::string(e.what()).find("old oak"), std::string::npos) << e.what();
    }
    EXPECT_NO_THROW(bake(room, same_materials(room.materials), {.texture_size = 512}, kQuiet));
}

// Where one can stand no collider reaches into the body, and the floor is below the feet.
TEST(Collision, LeavesTheFloorFreeWhereOneCanStand) {
    const TracedRoom traced(bedroom());
    const StandableFloor floor = standable_floor(traced);
    const std::vector<Collider> all = colliders(traced.room(), floor.floor_y);
    std::size_t boxes = 0;
    for (const Collider& c : all) boxes += c.boxes.size();
    EXPECT_LE(boxes * 12, static_cast<std::size_t>(kMostColliderTriangles));
    const auto inside = [](const Collider& c, Vec3f world) {
        const Vec3f p = inverse(c.world_from_boxes) * world;
        return std::any_of(c.boxes.begin(), c.boxes.end(), [&](const Box& b) {
            return p.x > b.low.x && p.y > b.low.y && p.z > b.low.z && p.x < b.high.x && p.y < b.high.y &&
                   p.z < b.high.z;
        });
    };
    const std::vector<FloorCell> cells = standable_cells(floor);
    ASSERT_FALSE(cells.empty());
    for (const FloorCell cell : cells) {
        const Vec2f at = floor.center(cell.column, cell.row);
        EXPECT_TRUE(inside(all[0], {at.x, floor.floor_y + 0.01f, at.y}));
        for (const Collider& c : all)
            for (const float height : {0.1f, 0.5f, 1.f, 1.6f})
                EXPECT_FALSE(inside(c, {at.x, floor.floor_y - height, at.y})) << c.id << " at " << height;
    }
}

// Rays that end on a thing's surface end in its collider.
TEST(Collision, HoldsTheSurfaceOfThings) {
    const Room room = bedroom();
    const std::vector<std::string> ids = object_ids(room);
    for (const Collider& c : colliders(room, room.max_corner.y)) {
        const auto found = std::find(ids.begin(), ids.end(), c.id);
        if (found == ids.end()) continue;
        for (const Mesh& mesh : room.meshes) {
            if (mesh.object != found - ids.begin()) continue;
            for (const std::uint32_t v : mesh.triangles) {
                const Vec3f p = inverse(c.world_from_boxes) * mesh.positions[v];
                EXPECT_TRUE(std::any_of(c.boxes.begin(), c.boxes.end(), [&](const Box& b) {
                    constexpr float kSlack = 1e-3f;
                    return p.x > b.low.x - kSlack && p.y > b.low.y - kSlack && p.z > b.low.z - kSlack &&
                           p.x < b.high.x + kSlack && p.y < b.high.y + kSlack && p.z < b.high.z + kSlack;
                })) << c.id;
            }
        }
    }
}

// Every edge belongs to two faces that run along it in opposite directions, and the faces look outward.
TEST(Collision, IsClosed) {
    const Room room = bedroom();
    const Glb glb(collision_glb_bytes(room, room.max_corner.y));
    std::size_t triangles = 0;
    for (const Json& mesh : glb.json["meshes"]) {
        const Json& p = mesh["primitives"][0];
        const auto positions = glb.values<Vec3f>(p["attributes"]["POSITION"].get<std::size_t>());
        const auto indices = glb.values<std::uint16_t>(p["indices"].get<std::size_t>());
        std::map<std::pair<int, int>, int> edges;
        double volume = 0;
        for (std::size_t t = 0; t < indices.size(); t += 3) {
            for (std::size_t k = 0; k < 3; ++k) ++edges[{indices[t + k], indices[t + (k + 1) % 3]}];
            volume += static_cast<double>(
                dot(positions[indices[t]], cross(positions[indices[t + 1]], positions[indices[t + 2]])));
        }
        for (const auto& [edge, count] : edges) {
            EXPECT_EQ(count, 1);
            EXPECT_TRUE(edges.contains({edge.second, edge.first}));
        }
        EXPECT_GT(volume, 0) << mesh["name"];
        triangles += indices.size() / 3;
    }
    EXPECT_GT(triangles, 100u);
    EXPECT_LE(triangles, static_cast<std::size_t>(kMostColliderTriangles));
}

TEST(Labels, NameEveryThingAndWhatItStandsOn) {
    const TracedRoom traced(bedroom());
    const Json labels = labels_json(traced);
    ASSERT_EQ(labels["objects"].size(), traced.room().objects.size());
    bool bed = false;
    for (const Json& o : labels["objects"]) {
        EXPECT_GE(o["nyu40"].get<int>(), 0);
        if (o["class"] != "bed") continue;
        bed = true;
        EXPECT_EQ(o["nyu40"], 4);
        EXPECT_TRUE(o["stands_on"] == "floor" || o["stands_on"].get<std::string>().starts_with("rug"))
            << o["stands_on"];
    }
    EXPECT_TRUE(bed);
}

TEST(Labels, SpawnPointsLieWhereOneCanStand) {
    const TracedRoom traced(bedroom());
    const StandableFloor floor = standable_floor(traced);
    const Json walkable = walkable_floor_json(traced);
    ASSERT_FALSE(walkable["spawn_points_m"].empty());
    ASSERT_FALSE(walkable["polygons_m"].empty());
    for (const Json& p : walkable["spawn_points_m"]) {
        const float x = -p[0].get<float>(), z = p[2].get<float>();
        EXPECT_TRUE(floor.at(static_cast<int>((x - floor.corner_m.x) / floor.cell_m),
                             static_cast<int>((z - floor.corner_m.y) / floor.cell_m)));
        EXPECT_NEAR(p[1].get<float>(), -floor.floor_y, 1e-4f);
    }
}

TEST(Plan, SaysTheRoomsSizeAndItsThings) {
    PromptSpec spec = understand_prompt("a bedroom of 4 by 5 metres with a desk", false);
    ASSERT_EQ(spec.size_m.x * spec.size_m.z, 20.f);
    const std::string svg = plan_svg(TracedRoom(make_room(spec, kQuiet)));
    EXPECT_NE(svg.find(">4.00 m<"), std::string::npos);
    EXPECT_NE(svg.find(">5.00 m<"), std::string::npos);
    for (const char* name : {"bed", "desk", "window"})
        EXPECT_NE(svg.find(fmt::format("{}</text>", name)), std::string::npos) << name;
}

}  // namespace
}  // namespace fastscene

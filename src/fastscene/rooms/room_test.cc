// Whole rooms: what make_room promises whoever walks through them.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "fastscene/base/parallel.h"
#include "fastscene/base/random.h"
#include "fastscene/rooms/layout.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/rooms.h"
#include "fastscene/rooms/style.h"
#include "fastscene/rooms/validate.h"
#include "fastscene/scene/raised_floor.h"

namespace fastscene {
namespace {

// Furnished without a fault.
Room sound_room_of(const std::string& text, std::uint64_t seed, std::size_t& pieces) {
    PromptSpec spec = understand_prompt(text, true);
    const fastscene::Run run{seed, nullptr, {}};
    const FurnishedRoom furnished = furnish_room(spec, run);
    for (const Fault& fault : room_faults(furnished.plan, furnished.placed, furnished.camera))
        ADD_FAILURE() << fault.kind << ": " << fault.text;
    pieces = furnished.placed.size();
    return room_of(spec, furnished, run);
}

Room room_of(const std::string& text, std::uint64_t seed, PromptSpec* out = nullptr, bool strict = true) {
    PromptSpec spec = understand_prompt(text, strict);
    Run run;
    run.seed = seed;
    Room room = make_room(spec, run);
    if (out) *out = spec;
    return room;
}

std::size_t triangles_of(const Room& room) {
    std::size_t count = 0;
    for (const Mesh& m : room.meshes) count += m.triangles.size() / 3;
    return count;
}

float distance_to_triangle(Vec3f a, Vec3f b, Vec3f c) {
    // Of the origin. Inside the prism: the plane; else the nearest edge.
    const Vec3f n = cross(b - a, c - a);
    const float area = dot(n, n);
    const auto edge = [](Vec3f p, Vec3f q) {
        const Vec3f d = q - p;
        const float l = dot(d, d), t = l > 0 ? std::clamp(-dot(p, d) / l, 0.f, 1.f) : 0.f;
        return length(p + d * t);
    };
    if (area > 0 && dot(cross(b - a, -a), n) >= 0 && dot(cross(c - b, -b), n) >= 0 && dot(cross(a - c, -c), n) >= 0)
        return std::abs(dot(a, n)) / std::sqrt(area);
    return std::min({edge(a, b), edge(b, c), edge(c, a)});
}

bool ray_hits(Vec3f d, Vec3f a, Vec3f b, Vec3f c) {
    const Vec3f e1 = b - a, e2 = c - a, p = cross(d, e2);
    const float det = dot(e1, p);
    if (std::abs(det) < 1e-12f) return false;
    const float u = dot(-a, p) / det;
    if (u < -1e-5f || u > 1.00001f) return false;
    const Vec3f q = cross(-a, e1);
    const float v = dot(d, q) / det;
    return v >= -1e-5f && u + v <= 1.00001f && dot(e2, q) / det > 0;
}

bool through(const Portal& portal, Vec3f d) {
    const Vec3f a = portal.corner, b = a + portal.edge_u, c = b + portal.edge_v, e = a + portal.edge_v;
    return ray_hits(d, a, b, c) || ray_hits(d, a, c, e);
}

std::vector<Vec3f> directions(int count) {
    std::vector<Vec3f> out;
    for (int i = 0; i < count; ++i) {  // a spiral of even density
        const float y = 1 - 2 * (static_cast<float>(i) + 0.5f) / static_cast<float>(count), r = std::sqrt(1 - y * y),
                    a = 2.3999632f * static_cast<float>(i);
        out.push_back({r * std::cos(a), y, r * std::sin(a)});
    }
    return out;
}

// The share of directions in which one leaves the room without meeting a wall or a window.
int leaks(const Room& room, const std::vector<Vec3f>& rays) {
    int open = 0;
    for (const Vec3f d : rays) {
        bool hit = std::any_of(room.portals.begin(), room.portals.end(),
                               [&](const Portal& p) { return through(p, d); });
        for (std::size_t m = 0; m < room.meshes.size() && !hit; ++m) {
            const Mesh& mesh = room.meshes[m];
            if (mesh.object >= 0) continue;
            for (std::size_t t = 0; t < mesh.triangles.size() && !hit; t += 3)
                hit = ray_hits(d, mesh.positions[mesh.triangles[t]], mesh.positions[mesh.triangles[t + 1]],
                               mesh.positions[mesh.triangles[t + 2]]);
        }
        open += !hit;
    }
    return open;
}

void check_room(const Room& room, const std::vector<Vec3f>& rays) {
    EXPECT_LT(triangles_of(room), 300000u);
    EXPECT_GT(room.objects.size(), 4u);
    for (const RoomObject& o : room.objects) {
        const Mat3f& r = o.world_from_object.rotation;
        EXPECT_NEAR(dot(r.row0, cross(r.row1, r.row2)), 1.f, 1e-4f) << o.name;
        EXPECT_NEAR(r.row1.y, -1.f, 1e-4f) << o.name << ": the object's up is the world's -y";
    }
    float nearest = std::numeric_limits<float>::infinity(), floor = nearest;
    bool sound = true;
    int nearest_object = -1, outside = -2;
    for (const Mesh& m : room.meshes) {
        sound = sound && m.material >= 0 && static_cast<std::size_t>(m.material) < room.materials.size() &&
                m.object < static_cast<int>(room.objects.size()) && m.normals.size() == m.positions.size() &&
                m.coords.size() == m.positions.size();
        for (std::size_t t = 0; t < m.triangles.size(); t += 3) {
            const float far = distance_to_triangle(m.positions[m.triangles[t]], m.positions[m.triangles[t + 1]],
                                                   m.positions[m.triangles[t + 2]]);
            if (far < nearest) nearest = far, nearest_object = m.object;
        }
        for (const Vec3f p : m.positions) {
            sound = sound && std::isfinite(dot(p, p));
            // Nothing pokes out of the house (the next room does, and the tunnel about a carriage).
            for (std::size_t a = 0; a < 3; ++a)
                if (!(p[a] > room.min_corner[a] - 0.32f && p[a] < room.max_corner[a] + 0.32f)) outside = m.object;
        }
    }
    EXPECT_TRUE(sound);
    const bool next_room = std::any_of(room.objects.begin(), room.objects.end(),
                                       [](const RoomObject& o) { return o.kind == "doorway"; });
    const bool in_tunnel = room.portals.empty() && std::any_of(room.objects.begin(), room.objects.end(),
                                                               [](const RoomObject& o) { return o.kind == "window"; });
    if (!next_room && !in_tunnel) {
        EXPECT_EQ(outside, -2) << (outside < 0 ? "the shell" : room.objects[static_cast<std::size_t>(outside)].name)
                               << " reaches out of the house";
    }
    floor = floor_at(room, {0, 0});
    EXPECT_GT(floor, 1.2f);
    EXPECT_LT(floor, 1.8f);
    EXPECT_GE(nearest, 0.45f) << "of the camera: "
                              << (nearest_object < 0 ? "the shell"
                                                     : room.objects[static_cast<std::size_t>(nearest_object)].name);
    EXPECT_EQ(leaks(room, rays), 0) << "rays leave through a gap of the shell";
    for (const Portal& p : room.portals) {
        const Vec3f middle = p.corner + (p.edge_u + p.edge_v) * 0.5f;
        EXPECT_TRUE(next_room || dot(middle, cross(p.edge_u, p.edge_v)) < 0.f)
            << "the portal's normal points into the room";
    }
}

TEST(Room, EveryKindInEveryStyleIsSound) {
    const std::vector<Vec3f> rays = directions(2000);
    const std::vector<std::string> rooms = room_types();
    std::atomic<std::size_t> count = 0, pieces = 0;
    parallel_for(static_cast<std::int64_t>(rooms.size()), 1, [&](std::int64_t begin, std::int64_t) {
        const std::string& room = rooms[static_cast<std::size_t>(begin)];
        // Each style once. Types that name the styles that suit them come in those: they are many.
        const std::vector<std::string>& own = room_type(room).styles;
        const std::vector<std::string> all = own.empty() ? styles() : own;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const std::uint64_t seed = 1 + i % 2;
            SCOPED_TRACE(all[i] + " " + room + ", seed " + std::to_string(seed));
            std::size_t placed = 0;
            check_room(sound_room_of("a " + all[i] + " " + room_title(room), seed, placed), rays);
            ++count, pieces += placed;
        }
    });
    EXPECT_GE(count, 400u);
    EXPECT_GT(pieces, 15 * count) << "rooms are bare";
}

const char* const kWishes[] = {
    "a living room with a brown leather sofa, two blue armchairs and a tv",
    "a bedroom with a red armchair, a desk under the window and red curtains",
    "a kitchen with a kitchen island and three stools",
    "a dining room with a dining table, six chairs and a chandelier",
    "a study with a globe lamp, a fireplace and a green leather armchair",
    "a loft with a grand piano and a guitar",
    "a bathroom with a bathtub, a shower and a large mirror",
    "a kids room with a crib, a rocking horse and a toy box",
    "a small hallway with a bench, a coat rack and a piano",
    "a sunroom with four plants and a rattan armchair",
    "a laundry room with two washing machines and a basket",
    "a living room with an aquarium, a clock and three pictures",
    "a lamp on the desk, a vase on the table, a mirror above the fireplace",
    "a red door and two large windows in a study",
};

TEST(Room, WhatIsAskedForIsThereOrReported) {
    for (const char* text : kWishes)
        for (const std::uint64_t seed : {1u, 2u, 3u}) {
            SCOPED_TRACE(std::string(text) + ", seed " + std::to_string(seed));
            PromptSpec spec;
            const Room room = room_of(text, seed, &spec, false);
            for (const PromptObject& wish : spec.objects) {
                if (wish.forbidden || wish.kind == "wall" || wish.kind == "floor") continue;
                const auto there = std::count_if(room.objects.begin(), room.objects.end(), [&](const RoomObject& o) {
                    return o.kind == wish.kind && o.requested;
                });
                const auto reported = std::count_if(spec.not_placed.begin(), spec.not_placed.end(),
                                                    [&](const std::string& s) { return s.starts_with(wish.words); });
                EXPECT_GE(there + reported, wish.count) << wish.kind;
                if (wish.color.empty()) continue;
                for (const RoomObject& o : room.objects)
                    EXPECT_TRUE(o.kind != wish.kind || !o.requested || o.color == wish.color) << o.name;
            }
        }
}

TEST(Room, AReasonableWishIsNeverRefused) {
    // One or two pieces in a room of their own kind must always find their place.
    for (const char* text :
         {"a living room with a sofa and an armchair", "a bedroom with a bed and a wardrobe",
          "a study with a desk and a bookshelf", "a bathroom with a bathtub and a toilet",
          "a dining room with a dining table and four chairs", "a kitchen with a fridge", "a kids room with a toy box",
          "a living room with a fireplace", "a bedroom with two plants"})
        for (std::uint64_t seed = 0; seed < 4; ++seed) {
            PromptSpec spec;
            room_of(text, seed, &spec);
            EXPECT_TRUE(spec.not_placed.empty())
                << text << ", seed " << seed << ": " << (spec.not_placed.empty() ? "" : spec.not_placed.front());
        }
}

TEST(Room, LampsAreLitWhereTheLightIsDim) {
    for (const char* text : {"a dark moody bedroom", "a gloomy study", "a dimly lit living room", "a bedroom at night",
                             "a living room at dusk"}) {
        PromptSpec spec;
        const Room room = room_of(text, 1, &spec);
        EXPECT_TRUE(spec.time == "dusk" || spec.time == "night") << text;
        EXPECT_TRUE(std::any_of(room.materials.begin(), room.materials.end(), [](const Material& m) {
            return m.pattern != Pattern::screen && luminance(m.emission) > 0.5f;
        })) << text;
    }
}

TEST(Room, AnAirportLooksOutOnItsAirfield) {
    for (const std::uint64_t seed : {1u, 2u}) EXPECT_EQ(room_of("an airport hall", seed).sky.view, Sky::View::airfield);
    EXPECT_EQ(room_of("an airport hall with a view of the sea", 1).sky.view, Sky::View::sea);
}

// An arcade is open: columns and arches of stone, neither frames nor bars.
TEST(Room, ACloisterHasOpenArches) {
    const Room room = room_of("a cloister", 1);
    EXPECT_EQ(room.sky.view, Sky::View::court);
    int arches = 0;
    for (const RoomObject& o : room.objects) arches += o.kind == "window";
    EXPECT_GE(arches, 5);
    for (const Mesh& m : room.meshes)
        if (m.object >= 0 && room.objects[static_cast<std::size_t>(m.object)].kind == "window") {
            EXPECT_EQ(room.materials[static_cast<std::size_t>(m.material)].name, "carved stone");
        }
}

// Candles that were asked for burn by day too; where nobody lit one there is no flame to be seen.
TEST(Room, FlamesBurnOrAreNotThere) {
    const auto flames = [](const Room& room) {
        return std::count_if(room.meshes.begin(), room.meshes.end(),
                             [&](const Mesh& m) { return room.materials[static_cast<std::size_t>(m.material)].burns; });
    };
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        EXPECT_GT(flames(room_of("a bright living room with two candles in the morning", seed)), 0) << seed;
        EXPECT_EQ(flames(room_of("a bright living room with a sofa in the morning, no fireplace", seed)), 0) << seed;
    }
}

TEST(Room, ForbiddenThingsAreAbsent) {
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
        const Room room = room_of("a living room with a sofa, no curtains, no tv, no rug, no plants, no windows", seed);
        EXPECT_TRUE(room.portals.empty());
        for (const RoomObject& o : room.objects)
            EXPECT_TRUE(o.kind != "curtain" && o.kind != "tv" && o.kind != "rug" && o.kind != "plant" &&
                        o.kind != "window")
                << o.kind;
    }
}

TEST(Room, WindowsAskedForAreThere) {
    for (const int count : {1, 2, 3, 4})
        EXPECT_EQ(static_cast<int>(room_of(std::string("a living room with ") +
                                               (count == 1 ? "one window" : std::to_string(count) + " windows"),
                                           5)
                                       .portals.size()),
                  count);
}

TEST(Room, SameSeedSameRoomOtherSeedOtherRoom) {
    const std::string text = "a boho living room with a sofa";
    const Room a = room_of(text, 7), b = room_of(text, 7), c = room_of(text, 8);
    ASSERT_EQ(a.meshes.size(), b.meshes.size());
    for (std::size_t i = 0; i < a.meshes.size(); ++i) {
        EXPECT_EQ(a.meshes[i].positions, b.meshes[i].positions);
        EXPECT_EQ(a.meshes[i].triangles, b.meshes[i].triangles);
    }
    EXPECT_NE(length(a.max_corner - c.max_corner), 0.f);
}

TEST(Room, ARugAskedForLiesFlatOnTheFloor) {
    const Room room = room_of("a living room with a sofa and a red rug", 3);
    const auto rug = std::find_if(room.objects.begin(), room.objects.end(),
                                  [](const RoomObject& o) { return o.kind == "rug" && o.requested; });
    ASSERT_NE(rug, room.objects.end());
    EXPECT_LT(rug->size_m.y, 0.03f);
    EXPECT_NEAR(rug->world_from_object.translation.y, room.max_corner.y, 0.005f);
}

TEST(Room, NeonShinesInTwoColorsByNight) {
    PromptSpec spec;
    const Room room = room_of("a neon bedroom", 2, &spec);
    EXPECT_EQ(spec.time, "night");
    std::vector<Vec3f> colors;
    for (const Material& m : room.materials)
        if (m.name == "neon strip") colors.push_back(m.emission);
    ASSERT_EQ(colors.size(), 2u);
    EXPECT_GT(colors[0].x, colors[0].z);
    EXPECT_GT(colors[1].z, colors[1].x);
    for (const Material& m : room_of("a bedroom at night", 2).materials) EXPECT_NE(m.name, "neon strip");
}

TEST(Room, NeonIsOfTheColorThatWasSaid) {
    for (const auto& [text, channel] : {std::pair{"a bedroom with green neon lights", std::size_t{1}},
                                        {"a bedroom with red led strips", std::size_t{0}}}) {
        PromptSpec spec;
        const Room room = room_of(text, 2, &spec);
        EXPECT_EQ(spec.light, "neon") << text;
        EXPECT_TRUE(spec.colors.empty()) << text;
        int strips = 0;
        for (const Material& m : room.materials)
            if (m.name == "neon strip") {
                ++strips;
                EXPECT_EQ(m.emission[channel], max_component(m.emission)) << text;
            }
        EXPECT_GE(strips, 2) << text;  // four with a second room
    }
}

// The accent wall is the far one, tiles are all around.
TEST(Room, AColorOfNoPieceIsOnTheWalls) {
    const Vec3f pink = *color_named("pink");
    for (const char* text : {"a pink bathroom", "a pink study"})
        for (std::uint64_t seed = 0; seed < 3; ++seed) {
            const Room room = room_of(text, seed);
            const bool there = std::any_of(room.meshes.begin(), room.meshes.end(), [&](const Mesh& mesh) {
                const Vec3f c = room.materials[static_cast<std::size_t>(mesh.material)].color_a;
                return mesh.object == -1 && length(c - pink) < 1e-4f;
            });
            EXPECT_TRUE(there) << text << ' ' << seed;
        }
}

// Two colors of a room are not on one wall alone: cloth and rug wear them.
TEST(Room, ColorsOfTheRoomAreInItsCloth) {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        PromptSpec spec = understand_prompt("a bedroom in lavender and white", false);
        fastscene::Run run;
        run.seed = seed;
        const FurnishedRoom room = furnish_room(spec, run);
        const auto near = [](Vec3f a, Vec3f b) { return length(a - b) < 0.05f; };
        EXPECT_TRUE(near(room.plan.style.fabric2.color_a, *color_named("lavender")));
        EXPECT_TRUE(near(room.plan.style.fabric.color_a, *color_named("white")));
        EXPECT_TRUE(near(room.plan.style.rug.color_b, *color_named("lavender")));
    }
    // Pictures of a white room are not white.
    PromptSpec white = understand_prompt("a modern white living room", false);
    fastscene::Run run;
    const std::vector<Vec3f> palette = furnish_room(white, run).plan.style.palette;
    EXPECT_TRUE(std::equal(palette.begin(), palette.end(), style_named("modern").palette.begin(),
                           [](Vec3f a, Vec3f b) { return a == b; }));
}

TEST(Room, BathroomShelvesHoldNoBooks) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
        PromptSpec spec;
        const Room room = room_of("a bathroom with a shelf", seed, &spec);
        for (const Mesh& mesh : room.meshes)
            if (mesh.object >= 0 && room.objects[static_cast<std::size_t>(mesh.object)].kind == "shelf") {
                // Books show their spines.
                const std::string& name = room.materials[static_cast<std::size_t>(mesh.material)].name;
                EXPECT_EQ(name.find("spines"), std::string::npos) << name;
            }
    }
}

TEST(Room, JsonCountsVisiblePixels) {
    const Room room = room_of("a bedroom", 1);
    Image<std::int32_t> map(4, 2);
    std::fill(map.pixels.begin(), map.pixels.end(), -1);
    map.pixels[0] = map.pixels[5] = 1;
    const Json json = room_json(room, map);
    ASSERT_EQ(json["objects"].size(), room.objects.size());
    EXPECT_EQ(json["objects"][1]["visible_pixels"], 2);
    EXPECT_EQ(json["objects"][0]["visible_pixels"], 0);
    EXPECT_EQ(room_json(room, {})["objects"][1]["visible_pixels"], 0);
}

}  // namespace
}  // namespace fastscene

// The files for walking agree: a capsule dropped at each spawn point of walkable.json stands on the boxes of
// collision.glb, and walks from one to each other within the polygons.
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <map>

#include "fastscene/export/collision.h"
#include "fastscene/export/gltf.h"
#include "fastscene/export/labels.h"
#include "fastscene/export/test_rooms.h"
#include "fastscene/scene/raised_floor.h"
#include "fastscene/trace/standable.h"

namespace fastscene {
namespace {

// A person as a physics engine has it, who turns sideways where it is narrow. It steps over what is as high as a rug.
constexpr float kRadius_m = Body{}.pass_m, kHeight_m = Body{}.height_m, kStep_m = Body{}.step_over_m;
constexpr float kPath_m = 0.05f;  // grid that ways are looked for in

struct Capsule {
    const std::vector<Collider>& colliders;

    // Whether it overlaps a box with its feet at `feet` (world, y down) while it lifts them by `step`.
    std::string blocked_by(Vec3f feet, float step, float height_m = kHeight_m) const {
        for (const Collider& c : colliders) {
            const Rigid boxes_from_world = inverse(c.world_from_boxes);
            for (float height = step + kRadius_m; height <= height_m - kRadius_m; height += 0.08f) {
                const Vec3f p = boxes_from_world * (feet - Vec3f{0, height, 0});
                for (const Box& b : c.boxes) {
                    Vec3f off{};
                    for (std::size_t a = 0; a < 3; ++a) off[a] = p[a] - std::clamp(p[a], b.low[a], b.high[a]);
                    if (dot(off, off) < kRadius_m * kRadius_m * 0.999f) return c.id;
                }
            }
        }
        return "";
    }
    // Falls from `above` until something is below its feet: that height (world, y down). A slanted ceiling may be close
    // above, so only the lower half falls.
    float lands_at(Vec3f above) const {
        constexpr float kFall_m = 0.01f, kDeepest_m = 3;
        for (float fallen = 0; fallen < kDeepest_m; fallen += kFall_m)
            if (!blocked_by(above + Vec3f{0, fallen, 0}, 0, 0.5f * kHeight_m).empty())
                return above.y + fallen - kFall_m;
        return above.y + kDeepest_m;
    }
};

// Even-odd rule over all rings, as walkable.json says.
bool is_inside(const std::vector<std::vector<Vec2f>>& rings, Vec2f p) {
    bool inside = false;
    for (const auto& ring : rings)
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
            if ((ring[i].y > p.y) != (ring[j].y > p.y) &&
                p.x < (ring[j].x - ring[i].x) * (p.y - ring[i].y) / (ring[j].y - ring[i].y) + ring[i].x)
                inside = !inside;
    return inside;
}

using Cell = std::pair<int, int>;
Vec2f place_of(Cell c) { return {static_cast<float>(c.first) * kPath_m, static_cast<float>(c.second) * kPath_m}; }
Cell cell_of(Vec2f p) {
    return {static_cast<int>(std::lround(p.x / kPath_m)), static_cast<int>(std::lround(p.y / kPath_m))};
}

class Walk : public testing::TestWithParam<const char*> {};

TEST_P(Walk, FromEachSpawnPointToEachOther) {
    const TracedRoom traced(room_from(GetParam()));
    const Json file = walkable_floor_json(traced);
    const std::vector<Collider> boxes = colliders(traced.room(), standable_floor(traced).floor_y);
    const Capsule capsule{boxes};
    // From the file's axes back into the world's.
    std::vector<std::vector<Vec2f>> rings;
    for (const Json& ring : file["polygons_m"]) {
        rings.emplace_back();
        for (const Json& p : ring) rings.back().push_back({-p[0].get<float>(), p[1].get<float>()});
    }
    std::vector<Vec3f> spawns;
    for (const Json& p : file["spawn_points_m"])
        spawns.push_back(transpose(kGltfAxes) * Vec3f{p[0].get<float>(), p[1].get<float>(), p[2].get<float>()});
    ASSERT_GE(spawns.size(), 2u);
    // On tiers it climbs steps.
    constexpr float kClimb_m = 0.25f;
    const float step = has_raised_floor(traced.room()) ? kClimb_m : kStep_m;
    const auto feet = [&](Vec2f p) { return Vec3f{p.x, floor_at(traced.room(), p), p.y}; };
    constexpr float kDrop_m = 0.1f;
    for (const Vec3f spawn : spawns) {
        EXPECT_EQ(capsule.blocked_by(spawn, kStep_m), "") << "at " << spawn.x << " " << spawn.z;
        // On the floor, or on what it steps over.
        const float lands = capsule.lands_at(spawn - Vec3f{0, kDrop_m, 0});
        EXPECT_LT(lands, spawn.y + 0.02f) << "at " << spawn.x << " " << spawn.z;
        EXPECT_GT(lands, spawn.y - kStep_m - 0.01f) << "at " << spawn.x << " " << spawn.z;
    }
    // Breadth first over where the polygons say that one can walk, and the capsule goes too: no way may end because of
    // the boxes.
    std::map<Cell, bool> seen{{cell_of({spawns[0].x, spawns[0].z}), true}};
    std::deque<Cell> open{seen.begin()->first};
    for (; !open.empty(); open.pop_front())
        for (const auto& [dx, dz] : {Cell{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
            const Cell next{open.front().first + dx, open.front().second + dz};
            const Vec2f p = place_of(next);
            if (seen.contains(next) || !is_inside(rings, p)) continue;
            seen[next] = capsule.blocked_by(feet(p), step).empty();
            if (seen[next]) open.push_back(next);
        }
    std::map<std::string, int> blocked;
    for (const auto& [cell, free] : seen)
        if (!free) ++blocked[capsule.blocked_by(feet(place_of(cell)), step)];
    std::string by;
    for (const auto& [id, count] : blocked) by += fmt::format(" {} ({})", id, count);
    for (const Vec3f spawn : spawns) {
        const auto found = seen.find(cell_of({spawn.x, spawn.z}));
        EXPECT_TRUE(found != seen.end() && found->second)
            << "no way to " << spawn.x << " " << spawn.z << "; in the way are" << by;
    }
}

// However the grid lies over them: no gap at a step's edge.
TEST(Tiers, OneWalksUpEachFlightOfSteps) {
    for (std::uint64_t seed = 1; seed < 6; ++seed) {
        const TracedRoom traced(room_from(seed % 2 ? "a cinema" : "an auditorium", seed));
        const StandableFloor floor = passable_floor(traced);
        for (const RoomObject& object : traced.room().objects) {
            if (object.kind != kTierStep) continue;
            const float reach = object.size_m.z / 2 + 0.4f;
            for (float z = -reach; z < reach; z += 0.05f) {
                const Vec3f p = object.world_from_object * Vec3f{0, 0, z};
                const int column = static_cast<int>(std::floor((p.x - floor.corner_m.x) / floor.cell_m)),
                          row = static_cast<int>(std::floor((p.z - floor.corner_m.y) / floor.cell_m));
                EXPECT_TRUE(floor.at(column, row)) << seed << ": " << p.x << " " << p.z;
            }
        }
        EXPECT_GT(levels_of(floor).size(), 8u);
    }
}

INSTANTIATE_TEST_SUITE_P(Rooms, Walk,
                         testing::Values("a bedroom with two chairs and a desk", "a kitchen with an island",
                                         "a small bathroom with a bathtub", "an attic study with a slanted ceiling",
                                         "a living room with a sofa, two armchairs and a piano",
                                         "a large hall with many tables and chairs", "a cinema", "a lecture hall"),
                         [](const auto& room) { return fmt::format("Room{}", room.index); });

}  // namespace
}  // namespace fastscene

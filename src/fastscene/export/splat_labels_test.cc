// Labels of splats and maps of views, of a room whose surfaces are known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "fastscene/base/random.h"
#include "fastscene/export/splat_labels.h"
#include "fastscene/export/test_rooms.h"
#include "fastscene/export/view_maps.h"
#include "fastscene/image/encoded_maps.h"

namespace fastscene {
namespace {

// Points on the surfaces, moved by a few millimetres as training does, are labelled with the thing that they lie on,
// unless another one touches there.
TEST(SplatLabels, AreThoseOfTheSurfaceThatASplatLiesOn) {
    const TracedRoom traced(room_from("a bedroom with two chairs and a desk"));
    const Room& room = traced.room();
    const std::vector<std::uint16_t> by_mesh = instance_by_mesh(room);
    Random random(3, "points");
    Splats splats;
    std::vector<std::uint16_t> wanted;
    for (std::size_t m = 0; m < room.meshes.size(); ++m)
        for (std::size_t t = 0; t + 2 < room.meshes[m].triangles.size(); t += 3 * 7) {
            const auto corner = [&](std::size_t k) {
                return room.meshes[m].positions[room.meshes[m].triangles[t + k]];
            };
            // Slivers of leaves and pages are narrower than a splat.
            constexpr float kNarrowest = 0.006f;
            const Vec3f ab = corner(1) - corner(0), bc = corner(2) - corner(1), ca = corner(0) - corner(2);
            if (length(cross(ab, ca)) < kNarrowest * std::max({length(ab), length(bc), length(ca)})) continue;
            Vec3f p = (corner(0) + corner(1) + corner(2)) / 3.f;
            for (std::size_t a = 0; a < 3; ++a) p[a] += random.uniform(-0.002f, 0.002f);
            if (!traced.sees({}, p)) continue;
            splats.mean_m.push_back(p);
            wanted.push_back(by_mesh[m]);
        }
    // The view from the window.
    for (int k = 0; k < 5000 && wanted.back() != 0; ++k) {
        const Vec3f ray = normalize(Vec3f{random.normal(), 0.2f * random.normal(), random.normal()});
        if (!std::isinf(traced.distance({}, ray))) continue;
        splats.mean_m.push_back(ray * 400.f);
        wanted.push_back(0);
    }
    splats.resize(wanted.size());
    for (Vec3f& scale : splats.log_scale) scale = {-6, -6, -8};
    const std::vector<std::uint16_t> found = splat_labels(splats, traced, {{}}, {});
    ASSERT_EQ(found.size(), wanted.size());
    std::size_t equal = 0;
    for (std::size_t i = 0; i < found.size(); ++i) equal += found[i] == wanted[i];
    EXPECT_GT(wanted.size(), 1000u);
    EXPECT_GT(static_cast<double>(equal), 0.9 * static_cast<double>(wanted.size())) << equal << " of " << wanted.size();
    EXPECT_EQ(wanted.back(), 0);
    EXPECT_EQ(found.back(), 0);
}

TEST(ViewMaps, AgreeWithRaysThroughTheirPixels) {
    const TracedRoom traced(room_from("a bedroom with two chairs and a desk"));
    const Pinhole camera = Pinhole::with_fov(40, 30, 80);
    const Rigid world_from_camera{rotation_about(Vec3f{0, 1, 0}, 0.7f), {0.1f, 0.2f, 0}};
    const ViewMaps maps = view_maps(traced, camera, world_from_camera, {});
    const std::vector<Instance> instances = instances_of(traced.room());
    const ImageMask classes = class_map(maps.instance, instances);
    std::set<int> things;
    int turned_away = 0;  // as shading normals of round things may be
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const Vec3f ray = camera.direction_at({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
            const float range = traced.distance(world_from_camera.translation,
                                                normalize(world_from_camera.rotation * ray));
            const std::uint16_t instance = maps.instance.at(x, y);
            things.insert(instance);
            EXPECT_EQ(classes.at(x, y), instances.at(instance).nyu40);
            if (instance == 0) continue;
            EXPECT_NEAR(maps.depth_z.at(x, y) * length(ray), range, 1e-3f);
            turned_away += dot(maps.normal.at(x, y), ray) > 0.05f;
            EXPECT_NEAR(length(maps.normal.at(x, y)), 1, 1e-3f);
        }
    EXPECT_LT(turned_away, 0.02 * camera.width * camera.height) << "normals look at the camera";
    EXPECT_GT(things.size(), 4u);
    EXPECT_EQ(instances.at(instances.size() - 3).id, "floor");
}

TEST(ViewMaps, AsFiles) {
    ImageF depth(3, 1);
    depth.pixels = {1.2345f, 100.f, std::numeric_limits<float>::infinity()};
    EXPECT_EQ(millimetres(depth).pixels, (std::vector<std::uint16_t>{1235, 0, 0}));
    EXPECT_EQ(encoded_normal({}), (Rgb8{128, 128, 128}));
    EXPECT_EQ(encoded_normal({0, 0, -1}).b, 0);
}

TEST(Instances, AreFoundByIdAndClass) {
    const std::vector<Instance> all{{"outside", "outside", 0},
                                    {"armchair-1", "armchair", 5},
                                    {"sofa-1", "sofa", 6},
                                    {"office_chair-1", "office_chair", 5},
                                    {"floor", "floor", 2}};
    using Numbers = std::vector<std::uint16_t>;
    EXPECT_EQ(numbers_of(all, {"sofa-1"}, {}), Numbers{2});
    EXPECT_EQ(numbers_of(all, {}, {"chair"}), (Numbers{1, 3})) << "NYU40's label";
    EXPECT_EQ(numbers_of(all, {"floor"}, {"armchair"}), (Numbers{1, 4}));
    try {
        numbers_of(all, {}, {"sofs"});
        FAIL();
    } catch (const UsageError& e) {
        EXPECT_NE(std::string(e.what()).find("did you mean sofa?"), std::string::npos) << e.what();
        EXPECT_NE(std::string(e.what()).find("armchair"), std::string::npos) << e.what();
    }
    const std::vector<Instance> again = instances_from_json(instances_json(all), "x");
    ASSERT_EQ(again.size(), all.size());
    EXPECT_EQ(again[3].kind, "office_chair");
    EXPECT_THROW(instances_from_json(Json::parse(R"([{"instance": 0}])"), "x"), Error);
}

}  // namespace
}  // namespace fastscene

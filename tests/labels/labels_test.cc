// Labels of splats all the way: splats on what three viewpoints see of a room, labelled, rendered from elsewhere, and
// compared with the room itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fastscene/export/splat_labels.h"
#include "fastscene/export/view_maps.h"
#include "fastscene/metrics/seen_labels.h"
#include "fastscene/rooms/rooms.h"

namespace fastscene {
namespace {

const Run kSilent{7, nullptr, {}};

// A disc for each pixel of a small panorama, as training begins with.
void add_points(std::vector<SurfacePoint>& points, const TracedRoom& room, Vec3f eye) {
    constexpr EquirectSize kSize{360, 180};
    for (int y = 0; y < kSize.height; ++y)
        for (int x = 0; x < kSize.width; ++x) {
            const Vec3f ray = direction_of_pixel(x, y, kSize);
            const TracedRoom::Surface seen = room.surface(eye, ray);
            const float way = std::isinf(seen.distance) ? 400.f : seen.distance;
            points.push_back({eye + ray * way,
                              seen.mesh < 0 ? -ray : seen.normal,
                              {128, 128, 128},
                              way * 1.2f * kPi / static_cast<float>(kSize.width)});
        }
}

// The share of pixels whose class is found in the truth there or one pixel beside: untrained discs are a pixel wide, so
// outlines may be off by one.
double agreement_within_a_pixel(const Image<std::uint16_t>& seen, const Image<std::uint16_t>& truth,
                                const std::vector<int>& class_of) {
    const auto class_at = [&](const Image<std::uint16_t>& labels, int x, int y) {
        const std::size_t label = labels.at(x, y);
        return label < class_of.size() ? class_of[label] : -1;
    };
    int same = 0;
    for (int y = 0; y < truth.height; ++y)
        for (int x = 0; x < truth.width; ++x) {
            bool found = false;
            for (int v = std::max(0, y - 1); v <= std::min(y + 1, truth.height - 1); ++v)
                for (int u = std::max(0, x - 1); u <= std::min(x + 1, truth.width - 1); ++u)
                    found = found || class_at(seen, x, y) == class_at(truth, u, v);
            same += found;
        }
    return static_cast<double>(same) / truth.width / truth.height;
}

TEST(Labels, OfSplatsShowTheRoomsClasses) {
    PromptSpec spec = understand_prompt("a bedroom with two chairs and a desk", false);
    const TracedRoom room(make_room(spec, kSilent));
    const std::vector<Vec3f> eyes{{}, {0.4f, 0.1f, 0.3f}, {-0.4f, -0.1f, 0.2f}};
    std::vector<SurfacePoint> points;
    for (const Vec3f eye : eyes) add_points(points, room, eye);
    Splats splats = initial_splats(points, static_cast<int>(points.size()), {});
    for (float& logit : splats.opacity_logit) logit = 6;  // as if trained
    const std::vector<Instance> instances = instances_of(room.room());
    std::vector<int> class_of;
    for (const Instance& instance : instances) class_of.push_back(instance.nyu40);
    const Pinhole camera = Pinhole::with_fov(96, 96, 75);
    std::vector<LabelView> views;
    for (const float yaw : {0.3f, 2.f, 4.f})
        views.push_back({camera, {rotation_about(Vec3f{0, 1, 0}, yaw), {0.1f, 0.05f, -0.1f}}});
    const auto seen = seen_labels(splats, splat_labels(splats, room, eyes, {}), views, {}, {});
    for (std::size_t v = 0; v < views.size(); ++v) {
        const ViewMaps truth = view_maps(room, camera, views[v].world_from_camera, {});
        EXPECT_GT(agreement_within_a_pixel(seen[v], truth.instance, class_of), 0.97) << "view " << v;
    }
}

}  // namespace
}  // namespace fastscene

// A known room: the walk renders what panorama 0 did not see, instead of inpainting it.
#include <gtest/gtest.h>

#include <cmath>

#include "fastscene/depth/depth.h"
#include "fastscene/image/color.h"
#include "fastscene/scene/box.h"
#include "fastscene/trace/test_room.h"
#include "fastscene/trace/trace.h"
#include "fastscene/walk/walk.h"

namespace fastscene {
namespace {

// 4 x 2.6 x 5 m; a white screen in front of a blue and a red block that are hidden from the center.
Room room_with_a_screen() {
    Room room;
    room.min_corner = kLow;
    room.max_corner = kHigh;
    room.materials = {diffuse({0.75f, 0.72f, 0.68f}), diffuse({0.8f, 0.8f, 0.8f}, {9, 9, 9}),
                      diffuse({0.8f, 0.8f, 0.8f}), diffuse({0.05f, 0.2f, 0.7f}), diffuse({0.7f, 0.06f, 0.05f})};
    room.meshes = {box_mesh(kLow, kHigh, 0, -1, true), box_mesh({-0.4f, -1.09f, -0.4f}, {0.4f, -1.05f, 0.4f}, 1),
                   box_mesh({-0.7f, -0.5f, 1.2f}, {0.7f, 1.f, 1.25f}, 2),
                   box_mesh({-0.75f, -0.4f, 1.8f}, {-0.3f, 0.9f, 2.f}, 3),
                   box_mesh({0.3f, -0.4f, 1.8f}, {0.75f, 0.9f, 2.f}, 4)};
    return room;
}

struct Walks {
    TracedRoom room{room_with_a_screen()};
    EquirectSize size{512, 256};
    Panorama first;
    WalkParams params;
    int looks = 0, asked = 0;
    WalkAdvice advice;

    Walks() {
        TraceParams light;
        light.cell_m = 0.15f;
        light.cell_samples = 64;
        light.outside_detail = 0;
        room.gather_light(light, {});
        first.color = room.panorama({}, size, {.pixel_samples = 16}, {}).color;
        first.range = exact_range(room, size, {});
        params.viewpoints = 4;
        params.reach_m = 0.6f;
        params.inpainter = kLookIntoRoom;
        advice.room = [this](const Rigid& world_from_pano, const ImageMask& hole, const Run& run) {
            ++looks;
            for (const std::uint8_t h : hole.pixels) asked += h != 0;
            Shot shot = room.panorama(world_from_pano, size,
                                      {.mirrored_range = true, .pixel_samples = 16, .only = &hole}, run);
            return RoomSight{std::move(shot.color), std::move(shot.mirrored_range)};
        };
    }
};

TEST(RoomWalk, HolesAreWhatTheRoomHasThere) {
    Walks w;
    const Walked looked = walked_through(w.first, w.params, {}, w.advice);
    EXPECT_EQ(w.looks, 4);
    w.params.inpainter = "harmonic";
    const Walked painted = walked_through(w.first, w.params, {});
    ASSERT_EQ(looked.panoramas.size(), painted.panoramas.size());
    int all = 0;
    // range error in metres; squared sRGB errors where panorama 0 saw nothing
    double off = 0, looked_error = 0, painted_error = 0;
    for (std::size_t i = 1; i < looked.panoramas.size(); ++i) {
        const Panorama &one = looked.panoramas[i], &other = painted.panoramas[i];
        ASSERT_EQ(one.world_from_pano.translation, other.world_from_pano.translation);
        const Shot truth = w.room.panorama(one.world_from_pano, w.size, {.pixel_samples = 16}, {});
        const auto error_at = [&](const Panorama& p, std::size_t k) {
            double sum = 0;
            for (std::size_t c = 0; c < 3; ++c)
                sum += std::pow(static_cast<double>(srgb_from_linear(p.color.pixels[k][c]) -
                                                    srgb_from_linear(truth.color.pixels[k][c])),
                                2) /
                       3;
            return sum;
        };
        for (std::size_t k = 0; k < one.known.size(); ++k) {
            EXPECT_NE(one.known.pixels[k], Known::invented);
            if (one.known.pixels[k] == Known::looked)
                ++all, off += std::fabs(one.range.pixels[k] - truth.range.pixels[k]);
            if (one.known.pixels[k] == Known::original) continue;
            looked_error += error_at(one, k);
            painted_error += error_at(other, k);
        }
    }
    EXPECT_LT(looked_error, 0.2 * painted_error);
    EXPECT_EQ(all, w.asked);
    EXPECT_GT(all, 500);
    EXPECT_LT(off, 1e-3 * all) << "metres: as far as the room has it";
}

TEST(RoomWalk, NeedsARoomAndOurWay) {
    Walks w;
    EXPECT_THROW(walked_through(w.first, w.params, {}), UsageError);
    w.params.kind = "paper";
    EXPECT_THROW(walked_through(w.first, w.params, {}, w.advice), UsageError);
}

}  // namespace
}  // namespace fastscene

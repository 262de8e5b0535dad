// A mirror in a known room: the walk sees the mirrored room in it.
#include <gtest/gtest.h>

#include "fastscene/depth/depth.h"
#include "fastscene/image/color.h"
#include "fastscene/image/ssim.h"
#include "fastscene/scene/box.h"
#include "fastscene/trace/test_room.h"
#include "fastscene/trace/trace.h"
#include "fastscene/walk/walk.h"

namespace fastscene {
namespace {

// 4 x 2.6 x 5 m, a mirror on the wall in front (object 0), colored objects behind the camera.
Room room_with_a_mirror() {
    Room room;
    room.min_corner = kLow;
    room.max_corner = kHigh;
    Material mirror = diffuse({0.85f, 0.85f, 0.85f});
    mirror.mirror = 1;
    room.materials = {diffuse({0.75f, 0.72f, 0.68f}), diffuse({0.8f, 0.8f, 0.8f}, {9, 9, 9}),
                      diffuse({0.7f, 0.06f, 0.05f}), diffuse({0.05f, 0.2f, 0.7f}), mirror};
    room.objects.resize(1);
    room.meshes = {box_mesh(kLow, kHigh, 0, -1, true), box_mesh({-0.4f, -1.09f, -0.4f}, {0.4f, -1.05f, 0.4f}, 1),
                   box_mesh({-1.2f, 0.2f, -1.9f}, {-0.5f, 1.5f, -1.4f}, 2),
                   box_mesh({0.4f, -0.4f, -2.4f}, {1.3f, 1.5f, -2.f}, 3),
                   box_mesh({-0.8f, -0.6f, 2.4f}, {0.8f, 0.7f, 2.42f}, 4, 0)};
    return room;
}

TEST(MirrorWalk, WhatAMirrorShowsMovesAsItsImageDoes) {
    TracedRoom room(room_with_a_mirror());
    TraceParams light;
    light.cell_m = 0.15f;
    light.cell_samples = 64;
    light.outside_detail = 0;
    room.gather_light(light, {});
    const EquirectSize size{512, 256};
    Panorama first;
    first.color = room.panorama({}, size, {.pixel_samples = 16}, {}).color;
    first.range = exact_range(room, size, {});
    Panorama looking = first;
    looking.mirrored_range = exact_mirrored_range(room, size, {});
    ASSERT_FALSE(looking.mirrored_range.empty());

    WalkParams params;
    params.viewpoints = 4;
    params.reach_m = 0.5f;
    params.inpainter = "harmonic";
    const Walked on_glass = walked_through(first, params, {}), behind_it = walked_through(looking, params, {});
    ASSERT_EQ(on_glass.panoramas.size(), behind_it.panoramas.size());
    for (std::size_t i = 1; i < behind_it.panoramas.size(); ++i) {
        const Panorama& walked = behind_it.panoramas[i];
        EXPECT_EQ(walked.world_from_pano.translation, on_glass.panoramas[i].world_from_pano.translation)
            << "nobody steps into a mirror";
        const Shot truth = room.panorama(walked.world_from_pano, size, {.object = true, .pixel_samples = 16}, {});
        ImageMask glass(size.width, size.height), rest = glass;
        for (std::size_t k = 0; k < glass.size(); ++k) (truth.object.pixels[k] == 0 ? glass : rest).pixels[k] = 255;
        const auto likeness = [&](const Panorama& p, const ImageMask& mask) {
            return psnr(srgb8_from_linear(p.color), srgb8_from_linear(truth.color), mask);
        };
        EXPECT_GT(likeness(walked, glass), likeness(on_glass.panoramas[i], glass) + 6) << "viewpoint " << i;
        int invented = 0, seen = 0;
        for (std::size_t k = 0; k < glass.size(); ++k)
            if (glass.pixels[k]) ++seen, invented += walked.known.pixels[k] == Known::invented;
        EXPECT_LT(invented, seen / 10) << "what panorama 0 saw of the room need not be made up in a mirror";
        EXPECT_GT(likeness(walked, rest), likeness(on_glass.panoramas[i], rest) - 0.3) << "viewpoint " << i;
    }
}

}  // namespace
}  // namespace fastscene

// An edited room keeps its light, and its pictures their pixels, where the edit changes nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/image/color.h"
#include "fastscene/scene/box.h"
#include "fastscene/trace/changed_pixels.h"
#include "fastscene/trace/room_change.h"
#include "fastscene/trace/test_room.h"
#include "fastscene/trace/trace.h"

namespace fastscene {
namespace {

constexpr Vec3f kHallLow{-5, -1.1f, -5}, kHallHigh{5, 1.5f, 5};

// 10 x 10 m with a lamp in the middle, a block in a corner whose place and color vary, and one that stays.
Room hall(float block_x = 3.f, Vec3f block_color = {0.7f, 0.1f, 0.1f}, float lamp_x = 0.f) {
    Room room;
    room.min_corner = kHallLow;
    room.max_corner = kHallHigh;
    room.materials = {diffuse({0.7f, 0.68f, 0.66f}), diffuse({0.8f, 0.8f, 0.8f}, {90, 86, 82}), diffuse(block_color),
                      diffuse({0.2f, 0.3f, 0.6f})};
    room.objects.resize(2);
    room.meshes = {box_mesh(kHallLow, kHallHigh, 0, -1, true),
                   box_mesh({lamp_x - 0.2f, -1.08f, -0.2f}, {lamp_x + 0.2f, -1.04f, 0.2f}, 1),
                   box_mesh({block_x, 0.9f, 3}, {block_x + 0.6f, 1.5f, 3.6f}, 2, 0),
                   box_mesh({-3.6f, 0.7f, -3.6f}, {-3, 1.5f, -3}, 3, 1)};
    return room;
}

TraceParams coarse() {
    TraceParams p;
    p.cell_m = 0.2f;
    p.cell_samples = 128;
    p.pixel_samples = 16;
    p.outside_detail = 0;
    return p;
}

TracedRoom lit(Room room) {
    TracedRoom traced(std::move(room));
    traced.gather_light(coarse(), {});
    return traced;
}

ImageColor shot_of(const TracedRoom& room, Vec3f place = {}) {
    return room.panorama({{}, place}, {256, 128}, {.color = true, .range = false, .contacts = true}, {}).color;
}

double psnr_where(const ImageColor& a, const ImageColor& b, const ImageMask& mask, bool changed) {
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if ((mask.pixels[i] != 0) != changed) continue;
        for (std::size_t c = 0; c < 3; ++c) {
            const double d = srgb_from_linear(a.pixels[i][c]) - srgb_from_linear(b.pixels[i][c]);
            sum += d * d / 3;
        }
        ++count;
    }
    return -10 * std::log10(std::max(1e-10, sum / std::max(1., count)));
}

TEST(EditedLight, KeptLightGivesTheSamePictures) {
    const TracedRoom gathered = lit(hall());
    TracedRoom other(hall());
    ASSERT_TRUE(other.take_light(coarse(), gathered.light(), "light.bin"));
    const ImageColor a = shot_of(gathered), b = shot_of(other);
    for (std::size_t i = 0; i < a.size(); ++i) ASSERT_EQ(a.pixels[i], b.pixels[i]) << i;
    EXPECT_EQ(gathered.light(), other.light());
}

// A stop brighter or darker is just that, and light that was kept for another exposure is not taken for it.
TEST(EditedLight, ExposureIsCompensatedInStops) {
    const TracedRoom plain = lit(hall());
    TraceParams darker = coarse();
    darker.exposure_ev = -1;
    TracedRoom dim(hall());
    EXPECT_THROW((void)dim.take_light(darker, plain.light(), "light.bin"), Error);
    dim.gather_light(darker, {});
    EXPECT_NEAR(dim.room().look.exposure_ev, plain.room().look.exposure_ev - 1, 1e-4f);
}

TEST(EditedLight, LightOfAnotherRoomIsRefused) {
    const std::string light = lit(hall()).light();
    TracedRoom other(hall(2.f));
    const auto complaint = [&](const TraceParams& params, TracedRoom& room, std::string_view bytes) {
        try {
            room.take_light(params, bytes, "light.bin");
        } catch (const Error& e) {
            return std::string(e.what());
        }
        return std::string();
    };
    EXPECT_NE(complaint(coarse(), other, light).find("light.bin: expected the light of this room"), std::string::npos);
    TracedRoom same(hall());
    TraceParams finer = coarse();
    finer.cell_m = 0.1f;
    EXPECT_NE(complaint(finer, same, light).find("settings"), std::string::npos);
    for (const double share : {0., 0.1, 0.5, 0.99})
        EXPECT_NE(complaint(coarse(), same,
                            std::string_view(light).substr(
                                0, static_cast<std::size_t>(share * static_cast<double>(light.size())))),
                  "")
            << share;
    EXPECT_NE(complaint(coarse(), same, "something else altogether, as long as a header is"), "");
}

TEST(EditedLight, ChangeIsByContent) {
    Room reordered = hall();
    std::swap(reordered.meshes[2], reordered.meshes[3]);
    EXPECT_TRUE(change_between(hall(), reordered).surfaces.meshes.empty());
    const RoomChange moved = change_between(hall(), hall(2.f));
    EXPECT_EQ(moved.surfaces.meshes.size(), 2u) << "where it was and where it is";
    EXPECT_FALSE(moved.lights);
    EXPECT_EQ(change_between(hall(), hall(3.f, {0, 0.5f, 0})).surfaces.meshes.size(), 2u);
    EXPECT_TRUE(change_between(hall(), hall(3.f, {0.7f, 0.1f, 0.1f}, 1.f)).lights);
    Room night = hall();
    night.sky.time = Sky::Time::night;
    EXPECT_TRUE(change_between(hall(), night).lights);
}

// A block goes from one place to another: most of the hall keeps its light, and what is gathered again is right.
TEST(EditedLight, IsGatheredAgainWhereTheEditIs) {
    const TracedRoom before = lit(hall(3.f)), whole = lit(hall(-0.5f));
    TracedRoom again(hall(-0.5f));
    const double kept = again.gather_light_again(coarse(), {}, {Vec3f{}}, before);
    EXPECT_GT(kept, 0.5);
    EXPECT_LT(kept, 0.99);
    const Vec3f place{-0.2f, 0.3f, 1.5f};  // looks at the block's new place
    const ImageMask changed = ChangedPixels(before, whole, {}).in_panorama({{}, place}, {256, 128}, {});
    const ImageColor right = shot_of(whole, place), got = shot_of(again, place), old = shot_of(before, place);
    // The exposure is that of before, by up to 0.04 stops another: that alone is 41 dB.
    EXPECT_GT(psnr_where(got, right, changed, true), 34) << "the block, its shadow and its color on the floor";
    EXPECT_GT(psnr_where(got, right, changed, false), 39);
    EXPECT_NEAR(again.room().look.exposure_ev, whole.room().look.exposure_ev, 0.04);
    EXPECT_LT(psnr_where(old, right, changed, true), 30) << "what the room was like before would be seen";
}

TEST(EditedLight, OfOtherLampsIsGatheredWhole) {
    const TracedRoom before = lit(hall()), whole = lit(hall(3.f, {0.7f, 0.1f, 0.1f}, 1.f));
    TracedRoom again(hall(3.f, {0.7f, 0.1f, 0.1f}, 1.f));
    EXPECT_EQ(again.gather_light_again(coarse(), {}, {Vec3f{}}, before), 0);
    EXPECT_EQ(again.light(), whole.light());
}

// Outside of the mask the two rooms look alike; inside is every pixel that shows the block.
TEST(ChangedPixels, HoldWhatAnEditChanges) {
    const TracedRoom before = lit(hall(3.f));
    TracedRoom now(hall(2.2f, {0.1f, 0.5f, 0.1f}));
    now.gather_light_again(coarse(), {}, {Vec3f{}}, before);
    const EquirectSize size{256, 128};
    const ImageMask changed = ChangedPixels(before, now, {}).in_panorama({}, size, {});
    const auto share = static_cast<double>(std::count_if(changed.pixels.begin(), changed.pixels.end(),
                                                         [](std::uint8_t p) { return p != 0; })) /
                       static_cast<double>(changed.size());
    EXPECT_GT(share, 0.005);
    EXPECT_LT(share, 0.3);
    EXPECT_GT(psnr_where(shot_of(before), shot_of(now), changed, false), 45);
    for (const TracedRoom* room : {&before, static_cast<const TracedRoom*>(&now)}) {
        const Shot shot = room->panorama({}, size, {.color = false, .range = false, .object = true}, {});
        for (std::size_t i = 0; i < changed.size(); ++i) {
            if (shot.object.pixels[i] == 0) {
                EXPECT_NE(changed.pixels[i], 0) << i;
            }
        }
    }
}

TEST(ChangedPixels, AreNoneOfTheSameRoom) {
    const TracedRoom before = lit(hall());
    TracedRoom now(hall());
    EXPECT_EQ(now.gather_light_again(coarse(), {}, {Vec3f{}}, before), 1);
    const ImageMask changed = ChangedPixels(before, now, {}).in_panorama({}, {256, 128}, {});
    EXPECT_EQ(std::count(changed.pixels.begin(), changed.pixels.end(), 0), static_cast<std::ptrdiff_t>(changed.size()));
}

}  // namespace
}  // namespace fastscene

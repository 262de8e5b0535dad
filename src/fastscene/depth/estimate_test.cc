#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "fastscene/base/random.h"
#include "fastscene/depth/align.h"
#include "fastscene/depth/box_layout.h"
#include "fastscene/depth/estimator.h"
#include "fastscene/depth/metric_range.h"
#include "fastscene/depth/walls.h"
#include "fastscene/geometry/reproject.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/nn/egformer.h"

namespace fastscene {
namespace {

constexpr EquirectSize kSize{256, 128};

BoxLayout some_box() { return {0.4f, {2.1f, 3.4f, 1.7f, 2.6f}, 1.5f, 1.1f, 0}; }

// Each of the six sides in a different color.
ImageColor painted(const BoxLayout& box, EquirectSize size) {
    ImageColor color(size.width, size.height);
    const ImageF range = range_of_box(box, size);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const Vec3f p = direction_of_pixel(x, y, size) * range.at(x, y);
            const float ahead = p.z * std::cos(box.yaw) + p.x * std::sin(box.yaw),
                        right = p.x * std::cos(box.yaw) - p.z * std::sin(box.yaw);
            Vec3f c{0.3f, 0.2f, 0.1f};  // floor
            if (p.y < -0.999f * box.ceiling_m) c = {0.8f, 0.8f, 0.8f};
            else if (ahead > 0.999f * box.wall_m[0]) c = {0.5f, 0.5f, 0.4f};
            else if (right > 0.999f * box.wall_m[1]) c = {0.4f, 0.5f, 0.5f};
            else if (-ahead > 0.999f * box.wall_m[2]) c = {0.6f, 0.5f, 0.5f};
            else if (-right > 0.999f * box.wall_m[3]) c = {0.45f, 0.4f, 0.45f};
            color.at(x, y) = c;
        }
    return color;
}

double mean_relative_error(const ImageF& found, const ImageF& truth) {
    double sum = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) sum += std::abs(found.pixels[i] - truth.pixels[i]) / truth.pixels[i];
    return sum / static_cast<double>(truth.size());
}

TEST(BoxLayout, RangeLiesOnTheBox) {
    const BoxLayout box = some_box();
    const ImageF range = range_of_box(box, kSize);
    for (int y = 0; y < kSize.height; ++y)
        for (int x = 0; x < kSize.width; ++x) {
            const Vec3f p = direction_of_pixel(x, y, kSize) * range.at(x, y);
            const float ahead = p.z * std::cos(box.yaw) + p.x * std::sin(box.yaw),
                        right = p.x * std::cos(box.yaw) - p.z * std::sin(box.yaw);
            const float inside[6] = {box.wall_m[0] - ahead, box.wall_m[1] - right, box.wall_m[2] + ahead,
                                     box.wall_m[3] + right, box.floor_m - p.y,     box.ceiling_m + p.y};
            float nearest = 10;
            for (const float gap : inside) {
                EXPECT_GT(gap, -1e-4f);
                nearest = std::min(nearest, gap);
            }
            EXPECT_NEAR(nearest, 0, 1e-4f);
        }
}

TEST(BoxLayout, FindsAPaintedBox) {
    const BoxLayout box = some_box();
    const BoxLayout found = fit_box(painted(box, {512, 256}), box.floor_m);
    EXPECT_LT(mean_relative_error(range_of_box(found, kSize), range_of_box(box, kSize)), 0.06)
        << "yaw " << found.yaw << " ceiling " << found.ceiling_m;
}

TEST(BoxLayout, FindsNoNonsenseInAnEmptyPicture) {
    const BoxLayout found = fit_box(ImageColor(64, 32, {0.5f, 0.5f, 0.5f}), 1.6f);
    for (const float r : range_of_box(found, {64, 32}).pixels) EXPECT_TRUE(r > 0.1f && r < 40.f);
}

// Output of a perfect scale- and shift-invariant network for a furnished box.
ImageF relative_of(const ImageF& range, float scale, float shift, bool furniture) {
    ImageF relative = range;
    for (int y = 0; y < range.height; ++y)
        for (int x = 0; x < range.width; ++x) {
            float r = range.at(x, y);
            const bool table = furniture && x > 20 && x < 110 && y > 70 && y < 120;
            if (table) r *= 0.6f;
            relative.at(x, y) = (r - shift) / scale;
        }
    return relative;
}

TEST(MetricRange, FloorTellsScaleAndShift) {
    const BoxLayout box = some_box();
    const ImageF truth = range_of_box(box, kSize);
    for (const auto& [scale, shift] : {std::pair{8.f, 0.f}, {5.f, 0.8f}, {12.f, -0.5f}})
        for (const bool furniture : {false, true}) {
            const MetricFit fit = fit_metres(relative_of(truth, scale, shift, furniture), box.floor_m);
            EXPECT_TRUE(fit.sure);
            EXPECT_NEAR(fit.scale, scale, 0.02f * scale) << shift << furniture;
            EXPECT_NEAR(fit.shift, shift, 0.05f);
            EXPECT_NEAR(fit.ceiling_m, box.ceiling_m, 0.05f);
        }
}

TEST(MetricRange, FloorTellsScaleAlone) {
    const BoxLayout box = some_box();
    const ImageF truth = range_of_box(box, kSize);
    for (const bool furniture : {false, true}) {
        const MetricFit fit = fit_metres(relative_of(truth, 8, 0, furniture), box.floor_m, UnknownOfRange::scale);
        EXPECT_TRUE(fit.sure);
        EXPECT_NEAR(fit.scale, 8, 0.16);
        EXPECT_EQ(fit.shift, 0);
        EXPECT_NEAR(fit.ceiling_m, box.ceiling_m, 0.05f);
    }
    const ImageF shifted = relative_of(truth, 8, 0.5f, false);
    EXPECT_EQ(fit_metres(shifted, box.floor_m, UnknownOfRange::scale).shift, 0);
    EXPECT_NEAR(fit_metres(shifted, box.floor_m).shift, 0.5f, 0.05f);
}

TEST(MetricRange, ScalesWithTheCamera) {
    const ImageF relative = relative_of(range_of_box(some_box(), kSize), 8, 0, false);
    const MetricFit low = fit_metres(relative, 1.f), high = fit_metres(relative, 2.f);
    EXPECT_NEAR(high.scale / low.scale, 2, 0.02);
}

TEST(MetricRange, SaysWhenThereIsNoFloor) {
    ImageF noise(kSize.width, kSize.height);
    for (std::size_t i = 0; i < noise.size(); ++i) noise.pixels[i] = Random(5, "noise", i).uniform(0.05f, 1.f);
    const MetricFit fit = fit_metres(noise, 1.6f);
    EXPECT_FALSE(fit.sure);
    EXPECT_GT(fit.scale, 0);
    EXPECT_EQ(fit.shift, 0);
}

// Angle in degrees between two directions.
float apart_deg(float a, float b) { return std::abs(std::remainder(a - b, 2 * kPi)) * 180 / kPi; }

// A box as a network sees it: coarse, with errors of a few per cent, a sofa in front of one wall.
ImageF seen_of(const BoxLayout& box, EquirectSize size) {
    ImageF range = range_of_box(box, size);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const Vec3f d = direction_of_pixel(x, y, size);
            float& r = range.at(x, y);
            r *= 1 + 0.02f * std::sin(5 * d.x + 3 * d.z) * std::cos(7 * d.y) +
                 0.01f * (Random(6, "waver", static_cast<std::uint64_t>(y * size.width + x)).uniform() - 0.5f);
            if (x > size.width / 3 && x < size.width / 2 && y > size.height * 5 / 8 && y < size.height * 7 / 8)
                r *= 0.7f;
        }
    return range;
}

// Each wall of a box is found once, at its position, with about its share of the sphere, whatever is in front of it.
TEST(Walls, OfABoxAreFoundWhereTheyAre) {
    const BoxLayout box = some_box();
    for (const EquirectSize size :
         {EquirectSize{128, 64}, EquirectSize{1024, 512}}) {  // sizes of the built-in and the published network
        const std::vector<Wall> walls = upright_planes(seen_of(box, size), box.floor_m, box.ceiling_m);
        ASSERT_EQ(walls.size(), 4u) << size.width;
        float sum = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            const float yaw = box.yaw + static_cast<float>(i) * kPi / 2;
            const auto found = std::find_if(walls.begin(), walls.end(),
                                            [&](const Wall& w) { return apart_deg(w.yaw, yaw) < 4; });
            ASSERT_NE(found, walls.end()) << "wall " << i << " at " << size.width;
            EXPECT_NEAR(found->distance_m, box.wall_m[i], 0.03f * box.wall_m[i])
                << "wall " << i << " at " << size.width;
            sum += found->share;
        }
        EXPECT_TRUE(
            std::is_sorted(walls.begin(), walls.end(), [](const Wall& a, const Wall& b) { return a.share > b.share; }));
        EXPECT_GT(sum, 0.4f);  // for a room of 4 x 6 m, 2.6 m high
        EXPECT_LT(sum, 0.8f);
    }
}

TEST(Walls, WithoutLinesAreNotBelieved) {
    const BoxLayout box = some_box();
    const ImageF range = seen_of(box, {128, 64});
    const std::vector<Wall> sure = walls_with_lines(range, find_lines(painted(box, {512, 256})), box.floor_m,
                                                    box.ceiling_m);
    EXPECT_GE(sure.size(), 3u);
    for (const Wall& wall : sure) EXPECT_NEAR(wall.line_m, wall.distance_m, 0.06f * wall.distance_m);
    EXPECT_TRUE(
        walls_with_lines(range, find_lines(ImageColor(512, 256, {0.5f, 0.5f, 0.5f})), box.floor_m, box.ceiling_m)
            .empty());
    // Lines of a room a quarter larger: their distance is reported, the range map's values stay.
    BoxLayout larger = box;
    for (float& m : larger.wall_m) m *= 1.2f;
    const std::vector<Wall> longer = walls_with_lines(range, find_lines(painted(larger, {512, 256})), box.floor_m,
                                                      box.ceiling_m);
    ASSERT_FALSE(longer.empty());
    for (const Wall& wall : longer) EXPECT_NEAR(wall.line_m, 1.2f * wall.distance_m, 0.08f * wall.distance_m);
}

TEST(Walls, AreNotInvented) {
    const EquirectSize size{128, 64};
    EXPECT_TRUE(upright_planes(ImageF(size.width, size.height, 2.f), 1.6f, 1.f).empty());  // a sphere has none
    EXPECT_TRUE(
        upright_planes(ImageF(size.width, size.height, std::numeric_limits<float>::infinity()), 1.6f, 0).empty());
    ImageF noise(size.width, size.height);
    for (std::size_t i = 0; i < noise.size(); ++i) noise.pixels[i] = Random(7, "noise", i).uniform(0.5f, 5.f);
    EXPECT_TRUE(upright_planes(noise, 1.6f, 1.f).empty());
    BoxLayout shed = some_box();  // everything except the floor is a kilometre away
    for (float& m : shed.wall_m) m = 1000;
    EXPECT_TRUE(upright_planes(range_of_box(shed, size), shed.floor_m, shed.ceiling_m).empty());
}

// With all eight augmentations the result is equivariant to rotation and mirroring; with one it is not.
TEST(Egformer, EightLooksKnowNoBeginningAndNoHandedness) {
    const Egformer network = Egformer::shipped(kShippedDepth.back());
    const EquirectSize size{network.shape().width, network.shape().height};
    const ImageColor picture = painted(some_box(), size);
    ImageColor turned = picture, mirrored = picture;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            turned.at(wrap_column(x + size.width / 4, size.width), y) = picture.at(x, y);
            mirrored.at(size.width - 1 - x, y) = picture.at(x, y);
        }
    const auto unlike = [&](int augmentations) {
        const ImageF a = network.relative_depth(picture, augmentations),
                     b = network.relative_depth(turned, augmentations),
                     c = network.relative_depth(mirrored, augmentations);
        double turn = 0, mirror = 0;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                turn = std::max(
                    turn,
                    std::abs(static_cast<double>(b.at(wrap_column(x + size.width / 4, size.width), y)) - a.at(x, y)));
                mirror = std::max(mirror, std::abs(static_cast<double>(c.at(size.width - 1 - x, y)) - a.at(x, y)));
            }
        return std::pair{turn, mirror};
    };
    const auto [turn, mirror] = unlike(8);
    EXPECT_LT(turn, 1e-5);
    EXPECT_LT(mirror, 1e-5);
    EXPECT_GT(unlike(1).second, 1e-3);
}

// The built-in networks: the coarser one's map is aligned to the picture and averaged with the finer one's.
TEST(Egformer, TheMeanOfThoseThatShipLiesBetweenThem) {
    std::vector<Egformer> networks;
    for (const char* name : kShippedDepth) networks.push_back(Egformer::shipped(name));
    ASSERT_GT(networks[0].shape().height, networks[1].shape().height);
    const ImageColor picture = painted(some_box(), kSize);
    const fastscene::Run run;
    const ImageF one = mean_depth({&networks[0], 1}, picture, 2, run), both = mean_depth(networks, picture, 2, run);
    EXPECT_EQ(one, networks[0].relative_depth(picture, 2));
    const ImageF coarse = aligned_to_picture(networks[1].relative_depth(picture, 2),
                                             equirect_from_equirect(picture, {one.width, one.height}));
    ASSERT_TRUE(both.same_size(one));
    for (std::size_t i = 0; i < both.size(); ++i)
        EXPECT_NEAR(both.pixels[i] - one.pixels[i], coarse.pixels[i] - both.pixels[i], 1e-5f);
    EXPECT_EQ(make_depth_estimator({})->estimate(picture, run).assumptions.at("weights"),
              "egformer-rooms-256, egformer-rooms");
}

TEST(Align, SmoothStaysSmoothAndEdgesFollowThePicture) {
    // A near disc in front of a far wall, coarse in the network's map.
    const EquirectSize large{256, 128}, small{64, 32};
    ImageColor picture(large.width, large.height);
    ImageF truth(large.width, large.height);
    const auto is_near = [](Vec3f d) { return d.z > std::cos(0.5f); };
    for (int y = 0; y < large.height; ++y)
        for (int x = 0; x < large.width; ++x) {
            const bool near = is_near(direction_of_pixel(x, y, large));
            picture.at(x, y) = near ? Vec3f{0.6f, 0.1f, 0.1f} : Vec3f{0.2f, 0.3f, 0.4f};
            truth.at(x, y) = near ? 1.f : 3.f;
        }
    ImageF coarse(small.width, small.height);
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x) coarse.at(x, y) = is_near(direction_of_pixel(x, y, small)) ? 1.f : 3.f;
    const ImageF fine = aligned_to_picture(coarse, picture);
    int wrong = 0;
    for (std::size_t i = 0; i < fine.size(); ++i) wrong += std::abs(fine.pixels[i] - truth.pixels[i]) > 0.2f;
    EXPECT_LT(wrong, 12);  // nearest neighbours give about 150
    // A tilted plane under a uniform picture.
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x)
            coarse.at(x, y) = 2.f + std::sin((static_cast<float>(x) + 0.5f) * 2 * kPi / 64.f);
    const ImageF plane = aligned_to_picture(coarse, ImageColor(large.width, large.height, {0.5f, 0.5f, 0.5f}));
    for (int y = 8; y < 120; ++y)
        for (int x = 0; x < large.width; ++x)
            EXPECT_NEAR(plane.at(x, y), 2.f + std::sin((static_cast<float>(x) + 0.5f) * 2 * kPi / 256.f), 0.05f);
}

// The coarse map of a box is upsampled to the box: flat sides under a strong pattern, with sharp edges.
TEST(Align, PlanesStayPlanesWhateverIsPaintedOnThem) {
    const EquirectSize large{512, 256}, small{64, 32};
    const BoxLayout box = some_box();
    const ImageF truth = range_of_box(box, large);
    ImageColor picture = painted(box, large);
    for (int y = 0; y < large.height; ++y)
        for (int x = 0; x < large.width; ++x)
            if ((x / 6 + y / 6) % 2) picture.at(x, y) = picture.at(x, y) * 0.4f;
    const ImageF fine = aligned_to_picture(range_of_box(box, small), picture);
    EXPECT_LT(mean_relative_error(fine, truth), 0.010);  // 0.0295 with values in place of planes
    int crooked = 0, counted = 0;
    for (int y = large.height * 3 / 4; y < large.height - 8; ++y)  // mostly floor
        for (int x = 0; x < large.width; ++x) {
            const Vec3f p = direction_of_pixel(x, y, large) * fine.at(x, y);
            if (direction_of_pixel(x, y, large).y * truth.at(x, y) < 0.999f * box.floor_m) continue;
            ++counted, crooked += std::abs(p.y - box.floor_m) > 0.01f * box.floor_m;
        }
    EXPECT_GT(counted, 10000);
    EXPECT_EQ(crooked, 0);  // two fifths with values in place of planes
}

}  // namespace
}  // namespace fastscene

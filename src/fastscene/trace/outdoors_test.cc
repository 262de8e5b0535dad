#include "fastscene/trace/outdoors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/base/parallel.h"
#include "fastscene/trace/outdoors_plants.h"
#include "fastscene/trace/outdoors_site.h"
#include "fastscene/trace/outdoors_tracer.h"
#include "fastscene/trace/response.h"

namespace fastscene {
namespace {

using namespace outdoors;

constexpr Vec3f kRoomLow{-2.5f, -1.2f, -2.5f}, kRoomHigh{2.5f, 1.5f, 2.5f};

Sky day(Sky::View view, std::uint32_t seed = 7) {
    Sky sky;
    sky.view = view, sky.seed = seed;
    sky.zenith = {1.1f, 1.8f, 3.1f}, sky.horizon = {3.f, 3.3f, 3.7f}, sky.ground = {0.75f, 0.7f, 0.58f};
    sky.sun_irradiance = {11.f, 10.1f, 8.8f};
    sky.sun_dir = normalize(Vec3f{0.4f, -0.62f, 0.68f});
    return sky;
}
// A window two metres wide that looks to +z.
std::vector<Portal> one_window() { return {{{-1, -0.9f, 2.5f}, {0, 1.5f, 0}, {2, 0, 0}}}; }
Vec3f way(float azimuth, float up) {
    return {std::cos(up) * std::sin(azimuth), -std::sin(up), std::cos(up) * std::cos(azimuth)};
}
// Irradiance of the window's pane.
template <class Radiance>
Vec3f through_window(const Radiance& radiance) {
    constexpr int kSide = 160;
    Vec3f sum{};
    for (int k = 0; k < kSide * kSide; ++k)
        sum += radiance(cosine_direction({0, 0, 1}, {(static_cast<float>(k % kSide) + 0.5f) / kSide,
                                                     (static_cast<float>(k / kSide) + 0.5f) / kSide})) *
               (kPi / (kSide * kSide));
    return sum;
}

// A photographed outside is what windows show, in every direction, and what lights the room.
TEST(Outdoors, ShowsAPhotograph) {
    auto picture = std::make_shared<ImageColor>(512, 256);
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 512; ++x)
            picture->at(x, y) = {1 + static_cast<float>(x) / 512, 2 - static_cast<float>(y) / 256, 0.5f};
    Sky sky = day(Sky::View::garden);
    sky.picture = picture;
    const Outdoors outdoors(sky, one_window(), kRoomLow, kRoomHigh, 4);
    for (const float azimuth : {-0.8f, -0.1f, 0.4f, 2.f})
        for (const float up : {-0.7f, 0.f, 0.5f, 1.3f}) {
            const Vec3f wanted{1 + azimuth / (2 * kPi) + 0.5f, 2 - (0.5f - up / kPi), 0.5f};
            for (std::size_t a = 0; a < 3; ++a) {
                EXPECT_NEAR(outdoors.seen(way(azimuth, up))[a], wanted[a], 0.01f) << azimuth << " " << up;
                EXPECT_NEAR(outdoors.light(way(azimuth, up))[a], wanted[a], 0.01f) << azimuth << " " << up;
            }
        }
    const std::string bytes = outdoors.bytes();
    ByteReader in("outside", bytes);
    EXPECT_EQ(Outdoors::from_bytes(in, sky).seen(way(0.3f, 1.3f)), outdoors.seen(way(0.3f, 1.3f)));
}

// Scattering gives the sky its course around the sun, but neither takes nor adds light at any height.
TEST(SkyDome, IsBrighterTowardsTheSunAndKeepsItsMean) {
    Sky sky = day(Sky::View::garden);
    sky.clouds = 0;
    const SkyDome dome(sky);
    const float sunward = std::atan2(sky.sun_dir.x, sky.sun_dir.z);
    for (const float up : {0.05f, 0.3f, 0.7f, 1.2f}) {
        Vec3f mean{};
        constexpr int kAround = 720;
        for (int k = 0; k < kAround; ++k) mean += dome.at(way(2 * kPi * static_cast<float>(k) / kAround, up)) / kAround;
        const Vec3f asked = lerp(sky.horizon, sky.zenith, std::pow(std::sin(up), 0.45f));
        for (std::size_t a = 0; a < 3; ++a) EXPECT_NEAR(mean[a] / asked[a], 1.f, 0.02f) << up;
        EXPECT_GT(luminance(dome.at(way(sunward, up))), luminance(dome.at(way(sunward + kPi, up)))) << up;
        // The disc itself is sampled as a light.
        EXPECT_LT(luminance(dome.at(way(sunward, up))), 4 * luminance(asked)) << up;
    }
}

// What lights a room is what is seen from it, and about as bright as an open sky over flat ground.
TEST(Outdoors, LightIsTheMeanOfWhatIsSeen) {
    const Sky sky = day(Sky::View::garden);
    const Outdoors outdoors(sky, one_window(), kRoomLow, kRoomHigh, 3);
    const Vec3f light = through_window([&](Vec3f d) { return outdoors.light(d); }),
                seen = through_window([&](Vec3f d) { return outdoors.seen(d); }),
                open = through_window([&](Vec3f d) {
                    return d.y > 0 ? sky.ground : lerp(sky.horizon, sky.zenith, std::pow(-d.y, 0.45f));
                });
    for (std::size_t a = 0; a < 3; ++a) {
        EXPECT_NEAR(light[a] / seen[a], 1.f, 0.02f);
        EXPECT_GT(light[a], 0.6f * open[a]);
        EXPECT_LT(light[a], 1.25f * open[a]);
    }
}

TEST(Outdoors, AFileKeepsItToTheBit) {
    Sky night = day(Sky::View::city);
    night.time = Sky::Time::night;
    night.zenith = night.horizon = {0.002f, 0.003f, 0.006f}, night.ground = night.sun_irradiance = {};
    for (const Sky& sky : {day(Sky::View::sea), night}) {
        const Outdoors traced(sky, one_window(), kRoomLow, kRoomHigh, 1.5f);
        const std::string bytes = traced.bytes();
        ByteReader in("outside", bytes);
        const Outdoors read = Outdoors::from_bytes(in, sky);
        EXPECT_EQ(in.left(), 0u);
        EXPECT_EQ(read.bytes(), bytes);
        EXPECT_EQ(read.table(), traced.table());
        EXPECT_EQ(read.brightness(), traced.brightness());
        for (int i = 0; i < 200; ++i)
            for (int j = 0; j < 50; ++j) {
                const Vec3f d = way(0.03f * static_cast<float>(i), 0.06f * static_cast<float>(j - 25));
                ASSERT_EQ(read.seen(d), traced.seen(d));
                ASSERT_EQ(read.light(d), traced.light(d));
            }
        for (const std::size_t end : {bytes.size() - 1, bytes.size() / 2, std::size_t{9}}) {
            ByteReader cut("outside", std::string_view(bytes).substr(0, end));
            EXPECT_THROW(Outdoors::from_bytes(cut, sky), Error);
        }
    }
    const Outdoors none(night, {}, kRoomLow, kRoomHigh, 10);
    const std::string bytes = none.bytes();
    ByteReader in("outside", bytes);
    EXPECT_EQ(Outdoors::from_bytes(in, night).seen({0, 1, 0}), night.ground);
}

// What noise is left in the band stays in every picture, as a grain that nothing can be trained to hold.
TEST(Outdoors, FoliageIsSampledUntilItIsSmooth) {
    const Sky sky = day(Sky::View::forest);
    const Outdoors outdoors(sky, one_window(), kRoomLow, kRoomHigh, 2);
    const Outdoors::Band& band = outdoors.band();
    const Tracer tracer(sky, make_world(sky, main_outlook(one_window())));
    constexpr int kPixels = 300, kSamples = 128;
    Random random(1, "foliage");
    double error = 0, bright = 0;
    for (int k = 0; k < kPixels;) {
        const Vec2f corner{static_cast<float>(random.index(band.width)),
                           static_cast<float>(1 + random.index(band.height - 2))};
        if (!band.covers(corner + Vec2f{0.5f, 0.5f})) continue;
        float mean = 0;
        for (int s = 0; s < kSamples; ++s) {
            const Vec3f way = band.direction(corner + Vec2f{random.uniform(), random.uniform()});
            mean += luminance(tracer.sample(way, 2 * kPi / static_cast<float>(band.width), random).radiance) / kSamples;
        }
        const float off = luminance(band.at(corner + Vec2f{0.5f, 0.5f})) - mean;
        error += static_cast<double>(off * off) / kPixels, bright += static_cast<double>(mean) / kPixels;
        ++k;
    }
    EXPECT_LT(std::sqrt(error), 0.17 * bright);
}

// Who looks ahead in a bus sees along the road, with walks at its sides; from a house the road runs across.
TEST(Outdoors, AStreetRunsAhead) {
    constexpr float kFootprint = 0.1f, kAsphalt = 0.12f;  // metres; albedo
    const World street = make_world(day(Sky::View::street), 0), city = make_world(day(Sky::View::city), 0);
    EXPECT_LT(street.eye_m, 3.f);
    EXPECT_LT(street.ground({0.8f, 0, 20}, kFootprint).x, kAsphalt);
    EXPECT_GT(street.ground({5.f, 0, 20}, kFootprint).x, kAsphalt);
    EXPECT_GT(street.ground({-6.f, 0, 20}, kFootprint).x, kAsphalt);
    EXPECT_LT(city.ground({9.f, 0, 15.5f}, kFootprint).x, kAsphalt);
    EXPECT_GT(city.ground({9.f, 0, 19.f}, kFootprint).x, kAsphalt);
}

TEST(Outdoors, AnyNumberOfThreadsShowsTheSame) {
    const Sky sky = day(Sky::View::city);
    const auto pictured = [&](int threads) {
        set_threads(threads);
        const Outdoors outdoors(sky, one_window(), kRoomLow, kRoomHigh, 0);
        set_threads(0);
        std::vector<Vec3f> pixels;
        for (int i = 0; i < 120; ++i)
            for (int j = 0; j < 60; ++j)
                pixels.push_back(
                    outdoors.light(way(0.02f * static_cast<float>(i - 60), 0.02f * static_cast<float>(j - 30))));
        return pixels;
    };
    EXPECT_EQ(pictured(1), pictured(2));
}

TEST(Outdoors, WithoutWindowsThereIsBareSkyAndGround) {
    const Sky sky = day(Sky::View::forest);
    const Outdoors outdoors(sky, {}, kRoomLow, kRoomHigh, 10);
    EXPECT_EQ(outdoors.seen({0, 1, 0}), sky.ground);
    EXPECT_EQ(outdoors.seen({0, -1, 0}), SkyDome(sky).at({0, -1, 0}));
    EXPECT_TRUE(outdoors.table().empty());
}

// Every window onto a garden in daylight shows flowers: colors that lawn, paving, earth and leaves do not have.
TEST(Outdoors, AGardenIsInBloomAllAround) {
    Sky sky = day(Sky::View::garden, 3);
    // Neutral light.
    sky.zenith = sky.horizon = sky.sun_irradiance = {1, 1, 1};
    const Tracer tracer(sky, make_world(sky, 0));
    constexpr int kAround = 720, kSectors = 6, kDown = 60;
    std::array<int, kSectors> bloom{};
    for (int i = 0; i < kAround; ++i)
        for (int j = 0; j < kDown; ++j) {
            Random random(1, "bloom", static_cast<std::uint64_t>(i * kDown + j));
            const Vec3f c = tracer
                                .sample(way(2 * kPi * static_cast<float>(i) / kAround,
                                            -0.04f - 0.006f * static_cast<float>(j)),
                                        0.002f, random)
                                .radiance;
            bloom[static_cast<std::size_t>(i * kSectors / kAround)] += c.x > 2.f * c.y ||
                                                                       (c.x > 1.6f * c.z && c.x > 1.15f * c.y &&
                                                                        c.y > 1.5f * c.z) ||
                                                                       (c.z > 1.3f * c.y && c.x > 1.1f * c.y);
        }
    for (const int b : bloom) EXPECT_GT(b, kAround / kSectors * kDown / 500);
}

// Airliners stand before the windows of both sides of a terminal, clear of it, and nothing taller is near.
TEST(Outdoors, AnAirfieldHasAirlinersOnBothSides) {
    const Sky sky = day(Sky::View::airfield, 3);
    const outdoors::World world = make_world(sky, 0);
    const float eye_m = world.eye_m;
    const Tracer tracer(sky, make_world(sky, 0));
    for (const float facing : {0.f, kPi}) {
        int near = 0, grounds = 0;
        for (int i = -60; i <= 60; ++i)
            for (int j = -30; j <= 10; ++j) {
                const Vec3f d = way(facing + 0.012f * static_cast<float>(i), 0.006f * static_cast<float>(j));
                const float far = tracer.distance(d);
                EXPECT_GT(far, 8.f);
                if (!(far < 75)) continue;
                // Above the apron, so no part of it.
                (eye_m - d.y * far > 1.5f ? near : grounds) += 1;
            }
        EXPECT_GT(near, 300) << facing;
    }
}

// The farther away, the more a thing looks like the sky behind it.
TEST(Outdoors, HazeGrowsWithDistance) {
    Sky sky = day(Sky::View::garden);
    sky.sun_irradiance = {};
    sky.clouds = 0;
    const Vec3f d = way(0, 0);
    float last = 0;
    for (const float far : {20.f, 200.f, 1000.f, 4000.f}) {
        World world;
        world.paints = standard_paints();
        QuadMesh wall;
        const std::uint16_t black = world.add(Paint{Finish::matt, {}});
        wall.quad({-1e4f, -1e4f, far}, {1e4f, -1e4f, far}, {1e4f, 1e4f, far}, {-1e4f, 1e4f, far}, black);
        world.instances.push_back({world.add(std::move(wall)), {}, {}});
        const Tracer tracer(sky, std::move(world));
        Random random(1, "haze");
        EXPECT_NEAR(tracer.distance(d), far, 0.01f);
        const float bright = luminance(tracer.sample(d, 0.001f, random).radiance);
        EXPECT_GT(bright, last) << far;
        last = bright;
    }
    EXPECT_LT(last, luminance(sky.horizon));
}

TEST(Plants, ATreeFillsItsCrownAndNoTwoAreAlike) {
    const TreeKind kind{8.f, 2.f, 2.2f, Crown::round, 0.1f, 4000};
    const QuadMesh tree = grow_tree(kind, 5), again = grow_tree(kind, 5), other = grow_tree(kind, 6);
    EXPECT_EQ(tree.corners, again.corners);
    EXPECT_NE(tree.corners, other.corners);
    Vec3f low{1e9f, 1e9f, 1e9f}, high = -low;
    for (const Vec3f c : tree.corners)
        for (std::size_t a = 0; a < 3; ++a) {
            ASSERT_TRUE(std::isfinite(c[a]));
            low[a] = std::min(low[a], c[a]), high[a] = std::max(high[a], c[a]);
        }
    EXPECT_GT(low.y, -0.1f) << "stands on the ground";
    EXPECT_NEAR(high.y, kind.height_m, 0.2f * kind.height_m);
    for (const float half : {-low.x, high.x, -low.z, high.z}) {
        EXPECT_GT(half, 0.4f * kind.radius_m);
        EXPECT_LT(half, 1.3f * kind.radius_m);
    }
    // Leaves are borne by the crown, not by the trunk.
    for (std::size_t q = 0; q < tree.size(); ++q)
        if (tree.paint[q] == kLeaf) ASSERT_GT(tree.corners[4 * q].y, 0.6f * kind.bare_m);
    const QuadMesh bare = grow_tree(kind, 5, true);
    EXPECT_EQ(std::count(bare.paint.begin(), bare.paint.end(), kLeaf), 0);
}

}  // namespace
}  // namespace fastscene

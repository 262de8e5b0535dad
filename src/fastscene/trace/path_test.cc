#include "fastscene/trace/path.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>

#include "fastscene/scene/box.h"
#include "fastscene/trace/response.h"
#include "fastscene/trace/test_room.h"
#include "fastscene/trace/trace.h"

namespace fastscene {
namespace {

float mean_radiance(const Room& room, Vec3f direction, int paths, Vec3f from = {}) {
    const SceneBvh bvh(room);
    const Lights lights(room);
    double sum = 0;
    for (int i = 0; i < paths; ++i) {
        Sampler sampler(99, static_cast<std::uint32_t>(i));
        sum += static_cast<double>(luminance(path_radiance({room, bvh, lights}, from, direction, 0.01f, sampler)));
    }
    return static_cast<float>(sum / paths);
}

Room box_room(const Material& walls) {
    Room room;
    room.min_corner = kLow;
    room.max_corner = kHigh;
    room.materials = {walls};
    room.meshes = {box_mesh(kLow, kHigh, 0, -1, true)};
    return room;
}

// Closed room, albedo 1/2, emission 1/2: radiance 1 everywhere.
TEST(Path, Furnace) {
    EXPECT_NEAR(
        mean_radiance(box_room(diffuse({0.5f, 0.5f, 0.5f}, {0.5f, 0.5f, 0.5f})), normalize(Vec3f{0.3f, 0.2f, 1}), 4096),
        1.f, 0.01f);
}

// Statistics of irradiance samples at a point: mean, standard deviation, maximum.
struct Samples {
    double mean, deviation, largest;
};
Samples sampled_light(const Room& room, Vec3f place, Vec3f normal, int count, std::uint64_t seed) {
    const SceneBvh bvh(room);
    const Lights lights(room);
    double sum = 0, squares = 0, largest = 0;
    for (int i = 0; i < count; ++i) {
        Random random(seed, "samples of light", static_cast<std::uint64_t>(i));
        const double e = luminance(
            lights.sample(room, bvh, place, normal, random.uniform(), {random.uniform(), random.uniform()}).irradiance);
        sum += e, squares += e * e, largest = std::max(largest, e);
    }
    const double mean = sum / count;
    return {mean, std::sqrt(squares / count - mean * mean), largest};
}

// From the ceiling only a narrow side of the flat lamp below is visible, a twentieth of its area: most samples must go
// there, not to the underside.
TEST(Lights, AFlatLampLightsItsCeilingWithFewSamples) {
    Room room = box_room(diffuse({0, 0, 0}));
    room.materials.push_back(diffuse({0, 0, 0}, {10, 10, 10}));
    const float half = 0.2f, deep = 0.05f, ceiling = 1.4f;
    room.meshes.push_back(box_mesh({-2, ceiling, -2}, {2, 1.45f, 2}, 0, -1, false));
    room.meshes.push_back(box_mesh({-half, ceiling - deep, -half}, {half, ceiling - 0.001f, half}, 1, -1, false));
    const Samples light = sampled_light(room, {0.8f, ceiling, 0}, {0, -1, 0}, 4096, 3);
    // Reference: the lamp's side in parallel strips, by quadrature.
    double wanted = 0;
    constexpr int kStrips = 200;
    for (int i = 0; i < kStrips; ++i)
        for (int k = 0; k < kStrips; ++k) {
            const double y = 0.001 + (deep - 0.001) * (i + 0.5) / kStrips, z = 2 * half * ((k + 0.5) / kStrips - 0.5),
                         x = 0.8 - half;
            const double d2 = x * x + y * y + z * z;
            wanted += 10 * (y * x) / (d2 * d2) * (deep - 0.001) * 2 * half / (kStrips * kStrips);
        }
    EXPECT_NEAR(light.mean / wanted, 1, 0.03);
    EXPECT_LT(light.deviation / light.mean,
              1.5);  // sampling by power alone gives above 4
}

// The spotlights of a ceiling are one object. Below one of them, that one must dominate the samples; uniform sampling
// left blotchy walls.
TEST(Lights, OneSpotOfManyIsAskedFromBelowIt) {
    const auto deviation = [](int objects) {
        Room room = box_room(diffuse({0, 0, 0}));
        room.meshes.clear();
        room.materials.push_back(diffuse({0, 0, 0}, {50, 50, 50}));
        for (int i = 0; i < objects; ++i) room.objects.push_back({});
        constexpr int kRow = 5;
        for (int i = 0; i < kRow * kRow; ++i) {
            const Vec3f at{1.2f * static_cast<float>(i % kRow - kRow / 2), -1,
                           1.2f * static_cast<float>(i / kRow - kRow / 2)};
            room.meshes.push_back(
                box_mesh(at - Vec3f{0.03f, 5e-4f, 0.03f}, at + Vec3f{0.03f, 5e-4f, 0.03f}, 1, i % objects, false));
        }
        const Samples light = sampled_light(room, {0, -0.6f, 0}, {0, -1, 0}, 8192, 5);
        // All are small: area times two cosines over d2.
        double wanted = 0;
        for (int i = 0; i < kRow * kRow; ++i) {
            const double x = 1.2 * (i % kRow - kRow / 2), z = 1.2 * (i / kRow - kRow / 2), y = 0.3995,
                         d2 = x * x + y * y + z * z;
            wanted += 50 * 0.06 * 0.06 * (y / std::sqrt(d2)) * (y / std::sqrt(d2)) / d2;
        }
        EXPECT_NEAR(light.mean / wanted, 1, 0.03) << objects;
        return light.deviation / light.mean;
    };
    const double together = deviation(1), apart = deviation(25);
    EXPECT_LT(together, 0.6);  // uniform sampling gives above 4
    EXPECT_LT(together, 1.3 * apart + 0.05);
}

// Samples on the back of a thin screen lie too close behind the front to be blocked by it; counting them would add rare
// bright samples that leave blotches on far walls.
TEST(Lights, AThinScreenShinesFromItsFrontAlone) {
    Room room = box_room(diffuse({0, 0, 0}));
    room.materials.push_back(diffuse({0, 0, 0}, {1, 1, 1}));
    const float half = 0.15f, front = 1.2f;
    room.meshes.push_back(box_mesh({-half, -half, front}, {half, half, front + 0.001f}, 1, -1, false));
    const Samples light = sampled_light(room, {0, 0, -2}, {0, 0, 1}, 8192, 4);
    const double far = front + 2,
                 wanted = 4 * half * half / (far * far);  // form factor of a small square, times pi
    EXPECT_NEAR(light.mean / wanted, 1, 0.03);
    EXPECT_LT(light.largest, 2 * wanted);
}

// Cameras see a screen's picture; the room is lit as by its bright parts alone.
TEST(Path, AScreensPictureIsSeenAndLightsTheRoomAsItsBrightPartsWould) {
    const float half = 0.15f, front = 1.2f;
    const auto room_with = [&](const Material& screen, float right) {
        Room room = box_room(diffuse({0.5f, 0.5f, 0.5f}));
        room.materials.push_back(screen);
        room.meshes.push_back(box_mesh({-half, -half, front}, {right, half, front + 0.001f}, 1, -1, false));
        spread_picture(room.meshes.back());
        return room;
    };
    constexpr Vec3f kWhite{0.9f, 0.9f, 0.9f};
    const Room picture = room_with(half_lit_screen(kWhite), half), bright = room_with(diffuse({0, 0, 0}, kWhite), 0);
    for (const float y : {-0.08f, 0.08f}) {
        EXPECT_NEAR(mean_radiance(picture, normalize(Vec3f{-0.08f, y, front}), 256), 0.9f, 0.02f);
        EXPECT_NEAR(mean_radiance(picture, normalize(Vec3f{0.08f, y, front}), 256), 0.f, 0.02f);
    }
    const double far = front + 2, wanted = 0.5 * 0.9 * 4 * half * half / (far * far);  // form factor, times pi
    EXPECT_NEAR(sampled_light(picture, {0, 0, -2}, {0, 0, 1}, 8192, 4).mean / wanted, 1, 0.04);
    const Vec3f to_wall = normalize(Vec3f{0.1f, 0.1f, -1});
    EXPECT_NEAR(mean_radiance(picture, to_wall, 60'000) / mean_radiance(bright, to_wall, 60'000), 1, 0.05);
    // The same of one that is too large to be sampled.
    Room wide = box_room(diffuse({0.5f, 0.5f, 0.5f}));
    wide.materials.push_back(half_lit_screen(kWhite));
    wide.meshes.push_back(box_mesh({-1.2f, -0.8f, 2}, {1.2f, 0.8f, 2.01f}, 1, -1, false));
    spread_picture(wide.meshes.back());
    Room lamp = box_room(diffuse({0.5f, 0.5f, 0.5f}));
    lamp.materials.push_back(diffuse({0, 0, 0}, kWhite));
    lamp.meshes.push_back(box_mesh({-1.2f, -0.8f, 2}, {0, 0.8f, 2.01f}, 1, -1, false));
    EXPECT_NEAR(mean_radiance(wide, to_wall, 60'000) / mean_radiance(lamp, to_wall, 60'000), 1, 0.06);
}

// At night a town's windows provide most of the light: sampling must follow their radiance, not that of the dark sky.
TEST(Lights, ALitTownIsNoRareSpark) {
    Room room = box_room(diffuse({0, 0, 0}));
    room.sky.time = Sky::Time::night;
    room.sky.view = Sky::View::city;
    room.sky.horizon = room.sky.zenith = room.sky.ground = {1e-4f, 1e-4f, 1e-4f};
    room.materials.push_back(diffuse({0, 0, 0}, {0.2f, 0.2f, 0.2f}));
    room.meshes = {box_mesh({-0.1f, -1, -2}, {0.1f, -0.9f, -1.8f}, 1, -1, false)};  // a lamp; no walls
    room.portals.push_back({{-0.6f, -0.6f, 2.5f}, {0, 1.2f, 0}, {1.2f, 0, 0}});
    const SceneBvh bvh(room);
    const Lights lights(room);
    const Vec3f place{0, 0, -2}, ahead{0, 0, 1};
    ASSERT_LT(dot(cross(room.portals[0].edge_u, room.portals[0].edge_v), ahead), 0);
    double light = 0, from_town = 0, asked = 0;
    constexpr int kSamples = 20'000;
    for (int i = 0; i < kSamples; ++i) {
        Random random(6, "town", static_cast<std::uint64_t>(i));
        const Lights::LightSample drawn = lights.draw(room, place, ahead, random.uniform(),
                                                      {random.uniform(), random.uniform()});
        const float here = dot(drawn.direction, ahead);
        const double e = drawn.pdf > 0 && here > 0 ? luminance(drawn.radiance) * here / drawn.pdf : 0;
        light += e;
        if (drawn.far < kFar) continue;
        from_town += e;
        ++asked;
    }
    const double share = from_town / light;
    ASSERT_GT(share, 0.02);
    EXPECT_GT(asked / kSamples, 0.25 * share);
}

// MIS counts a lamp once: the floor under a square lamp in a black room has the closed form of a parallel rectangle
// (Howell, B-3).
TEST(Path, LightAskedAndFoundIsCountedOnce) {
    Room room = box_room(diffuse({0, 0, 0}));
    room.materials.push_back(diffuse({0, 0, 0}, {10, 10, 10}));
    room.materials.push_back(diffuse({0.6f, 0.6f, 0.6f}));
    const float half = 0.2f, height = 1.3f;
    room.meshes.push_back(box_mesh({-half, 1.48f - height, -half}, {half, 1.49f - height, half}, 1, -1, false));
    room.meshes.push_back(box_mesh({-2, 1.49f, -2}, {2, 1.5f, 2}, 2, -1, false));
    // View past the lamp's edge: the floor beside the point below its center.
    const float x = half / height, s = std::sqrt(1 + x * x);
    const float form = 4 * (x / s * std::atan(x / s) * 2) / (2 * kPi);
    const SceneBvh bvh(room);
    const Lights lights(room);
    double sum = 0;
    constexpr int kPaths = 8192;
    for (int i = 0; i < kPaths; ++i) {
        Sampler sampler(5, static_cast<std::uint32_t>(i));
        sum += static_cast<double>(path_radiance({room, bvh, lights}, {0, 1.3f, 0}, {0, 1, 0}, 0.01f, sampler).x);
    }
    // The lamp's lower face is 1.49 - (1.49 - height) above the floor.
    EXPECT_NEAR(sum / kPaths / (10 * 0.6 * static_cast<double>(form)), 1.0, 0.02);
}

// No surface reflects more than it receives: white glossy surfaces in uniform light stay below 1.
TEST(Path, SurfacesLoseEnergy) {
    for (const float roughness : {0.1f, 0.4f, 0.8f})
        for (const float metal : {0.f, 1.f}) {
            Material m = diffuse({0.8f, 0.8f, 0.8f});
            m.roughness = roughness;
            m.metal = metal;
            m.specular = 0.04f;
            m.emission = {0.1f, 0.1f, 0.1f};
            EXPECT_LT(mean_radiance(box_room(m), normalize(Vec3f{1, 0.1f, 0.4f}), 1024), 1.2f)
                << roughness << " " << metal;
        }
}

// Patterns vary roughness slightly (clouds in concrete): the transition from glossy to matt must not show as an
// outline.
TEST(Path, ASurfaceGrowsMattWithoutAStep) {
    Material m = diffuse({0.3f, 0.3f, 0.3f});
    m.specular = 0.04f;
    for (const float steep : {1.f, 0.4f, 0.15f}) {
        const Vec3f normal{0, -1, 0}, in = normalize(Vec3f{1, steep, 0});
        const auto at = [&](float r) {
            return response_of({.position = {},
                                .normal = normal,
                                .bumped = normal,
                                .material = &m,
                                .texture = {m.color_a, r, 1.f, m.metal}},
                               in);
        };
        const float glossy = at(0.3f).specular.x;
        EXPECT_GE(glossy, 0.04f);
        EXPECT_EQ(at(0.7f).specular.x, 0);
        for (float roughness = 0.3f; roughness < 0.7f; roughness += 0.005f) {
            const Response a = at(roughness), b = at(roughness + 0.005f);
            EXPECT_NEAR(a.specular.x, b.specular.x, 0.08f * glossy) << roughness;
            EXPECT_NEAR(a.diffuse.x + a.specular.x, b.diffuse.x + b.specular.x, 0.03f * glossy) << roughness;
        }
    }
}

TEST(Path, MirroredDirectionsHaveTheDensityTheyAreDrawnWith) {
    const Vec3f n{0, -1, 0}, in = normalize(Vec3f{0.5f, 1, 0.2f});
    // The pdf over the whole sphere integrates to one.
    for (const float alpha : {0.1f, 0.25f}) {
        double sum = 0;
        const int nt = 400, np = 800;
        for (int i = 0; i < nt; ++i)
            for (int k = 0; k < np; ++k) {
                const float t = kPi * (static_cast<float>(i) + 0.5f) / nt,
                            p = 2 * kPi * (static_cast<float>(k) + 0.5f) / np;
                const Vec3f out{std::sin(t) * std::cos(p), std::cos(t), std::sin(t) * std::sin(p)};
                sum += static_cast<double>(ggx_pdf(n, alpha, in, out) * std::sin(t)) * (kPi / nt) * (2 * kPi / np);
            }
        EXPECT_NEAR(sum, 1.0, 0.03) << alpha;
    }
}

TEST(Sampler, SixteenConsecutivePathsHitEveryCellOfFourByFour) {
    for (std::uint64_t key = 0; key < 20; ++key) {
        std::array<int, 16> hits{};
        for (std::uint32_t i = 16; i < 32; ++i) {
            Sampler sampler(key, i);
            sampler.next2();
            const Vec2f p = sampler.next2();
            ++hits[static_cast<std::size_t>(static_cast<int>(p.x * 4) + 4 * static_cast<int>(p.y * 4))];
        }
        for (const int h : hits) EXPECT_EQ(h, 1) << key;
    }
}

// Cached pictures match path traced ones, up to the cache's own error.
TEST(Path, CachedPicturesAgree) {
    Room room = box_room(diffuse({0.7f, 0.6f, 0.5f}));
    room.materials.push_back(diffuse({0.5f, 0.5f, 0.5f}, {9, 8, 7}));
    room.materials.push_back(diffuse({0.2f, 0.4f, 0.7f}));
    room.meshes.push_back(box_mesh({-0.2f, -1.05f, 0.8f}, {0.2f, -1.f, 1.2f}, 1, -1, false));
    room.meshes.push_back(box_mesh({0.7f, 0.5f, 1.2f}, {1.5f, 1.5f, 1.8f}, 2, -1, false));
    TracedRoom traced(std::move(room));
    traced.gather_light({.cell_m = 0.06f, .cell_samples = 128, .pixel_samples = 16},
                        {});  // larger cells blur the lamp's pool of light: +6 % at 12 cm
    const auto mean = [&](const ShotParts& parts) {
        const ImageColor image = traced.panorama({}, {32, 16}, parts, {}).color;
        double sum = 0;
        for (const Vec3f c : image.pixels) sum += static_cast<double>(std::min(4.f, luminance(c)));
        return sum / static_cast<double>(image.size());
    };
    const double cached = mean({.color = true, .range = false, .pixel_samples = 16, .radiance = true});
    const double paths = mean({.color = true, .range = false, .pixel_samples = 64, .paths = true, .radiance = true});
    EXPECT_NEAR(cached / paths, 1.0, 0.05);
}

// Relief is shaded by the light that falls on it: what pictures from the cache show of knitted cloth lit from one side
// is what path tracing shows.
TEST(Path, CachedPicturesShowReliefInItsLight) {
    const auto lit = [](float bump_m) {
        Room room = box_room(diffuse({0.5f, 0.5f, 0.5f}));
        Material cloth = diffuse({0.5f, 0.5f, 0.5f});
        cloth.pattern = Pattern::knit;
        cloth.color_b = cloth.color_c = cloth.color_a;
        cloth.scale_m = 0.6f;
        cloth.bump_m = bump_m;
        room.materials.push_back(diffuse({0.5f, 0.5f, 0.5f}, {9, 9, 9}));
        room.materials.push_back(cloth);
        room.meshes.push_back(box_mesh({-1.9f, -0.5f, 1.6f}, {-1.7f, 0.5f, 1.8f}, 1, -1, false));
        room.meshes.push_back(box_mesh({-1.5f, -1.2f, 2.4f}, {1.5f, 1.2f, 2.45f}, 2, -1, false));
        auto traced = std::make_unique<TracedRoom>(std::move(room));
        traced->gather_light({.cell_m = 0.06f, .cell_samples = 256, .pixel_samples = 16}, {});
        return traced;
    };
    const auto picture = [](const TracedRoom& traced, bool paths) {
        ShotParts parts{.color = true, .range = false, .pixel_samples = paths ? 640 : 32};
        parts.paths = paths;
        parts.radiance = true;
        return traced.perspective({}, Pinhole::with_fov(40, 40, 40), parts, {}).color;
    };
    const auto knitted = lit(0.05f), smooth = lit(0.f);  // one light for both pictures of the knitted one
    const ImageColor truth = picture(*knitted, true), cached = picture(*knitted, false), even = picture(*smooth, false);
    // Relative to the even surface; the truth has noise of its own.
    double t = 0, c = 0, tt = 0, tc = 0, cc = 0;
    const auto count = static_cast<double>(truth.size());
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const double base = luminance(even.pixels[i]), x = luminance(truth.pixels[i]) / base - 1,
                     y = luminance(cached.pixels[i]) / base - 1;
        t += x / count, c += y / count, tt += x * x / count, tc += x * y / count, cc += y * y / count;
    }
    const double covariance = tc - t * c;
    EXPECT_GT(covariance / std::sqrt((tt - t * t) * (cc - c * c)), 0.6);
    EXPECT_NEAR(covariance / (cc - c * c), 1, 0.3);
    EXPECT_NEAR(t, c, 0.1);
}

// Direct sun is compressed where the camera sees it, in mirrors too; its illumination of the room is not.
TEST(Path, TheSunIsSeenWithRestraintAndLightsInFull) {
    const auto room_of = [](float sun_seen) {
        Room room;
        room.min_corner = kLow, room.max_corner = kHigh;
        room.materials = {diffuse({0.5f, 0.5f, 0.5f}), diffuse({0.9f, 0.9f, 0.9f})};
        room.materials[1].mirror = 1;
        room.sky.sun_dir = {0, -1, 0};
        room.sky.sun_irradiance = {10, 10, 10};
        // No ceiling: the sun is above a floor, a wall lit by the floor only, and a mirror opposite.
        room.meshes = {box_mesh({-2, 1.5f, -2.5f}, {2, 1.6f, 2.5f}, 0, -1, false),
                       box_mesh({-2, -1.5f, 2.5f}, {2, 1.5f, 2.6f}, 0, -1, false),
                       box_mesh({-2, -1.5f, -2.6f}, {2, 1.5f, -2.5f}, 1, -1, false)};
        room.look.automatic = false;
        room.look.sun_seen = sun_seen;
        return room;
    };
    const Vec3f floor = normalize(Vec3f{0.3f, 1, 0.5f}), wall = normalize(Vec3f{0.3f, 0.1f, 1}),
                mirrored = normalize(Vec3f{0.1f, 0.25f, -1});
    const auto cached = [](const TracedRoom& room, Vec3f direction) {
        const Vec3f right = normalize(cross(Vec3f{0, 1, 0}, direction)), down = cross(direction, right);
        const ShotParts parts{.color = true, .range = false, .pixel_samples = 16, .radiance = true};
        return luminance(
            room.perspective({Mat3f::from_columns(right, down, direction), {}}, {1, 1, 100, 100, 0.5f, 0.5f}, parts, {})
                .color.at(0, 0));
    };
    TracedRoom full(room_of(1)), less(room_of(0.2f));
    for (TracedRoom* room : {&full, &less})
        room->gather_light({.cell_m = 0.1f, .cell_samples = 64, .pixel_samples = 16}, {});
    constexpr int kPaths = 2048;
    const float by_paths[3] = {mean_radiance(room_of(0.2f), floor, kPaths), mean_radiance(room_of(0.2f), wall, kPaths),
                               mean_radiance(room_of(0.2f), mirrored, kPaths)};
    const float in_full[3] = {mean_radiance(room_of(1), floor, kPaths), mean_radiance(room_of(1), wall, kPaths),
                              mean_radiance(room_of(1), mirrored, kPaths)};
    const Vec3f ways[3] = {floor, wall, mirrored};
    for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(cached(less, ways[k]) / by_paths[k], 1.f, 0.1f) << k;
        EXPECT_NEAR(cached(full, ways[k]) / in_full[k], 1.f, 0.1f) << k;
    }
    EXPECT_LT(by_paths[0], 0.4f * in_full[0]);
    EXPECT_NEAR(by_paths[1] / in_full[1], 1.f, 0.03f);
    EXPECT_NEAR(by_paths[2] / in_full[2], by_paths[0] / in_full[0], 0.1f) << "the mirror shows the floor as it looks";
}

// Clear glass between a lamp, the sun and a floor does not change the floor's illumination. Seen through the glass,
// path traced and cached pictures agree; colored and frosted glass still absorbs.
TEST(Path, LightPassesClearGlass) {
    const auto room_of = [](float roughness, bool pane) {
        Room room = box_room(diffuse({0.4f, 0.4f, 0.4f}));
        room.materials.push_back(diffuse({0.5f, 0.5f, 0.5f}, {9, 8, 7}));
        Material glass = diffuse({0.7f, 0.76f, 0.74f});
        glass.transmission = 0.92f;
        glass.roughness = roughness;
        glass.specular = 0.04f;
        room.materials.push_back(glass);
        room.meshes.push_back(box_mesh({-1.9f, -0.2f, 1.4f}, {-1.6f, 0.2f, 1.8f}, 1, -1, false));
        if (pane)
            room.meshes.push_back(
                box_mesh({0, -1.1f, 0.9f}, {0.01f, 1.5f, 2.5f}, 2, -1, false));  // from floor to ceiling
        return room;
    };
    const auto cached = [](const Room& room, Vec3f direction) {
        TracedRoom traced(room);
        traced.gather_light({.cell_m = 0.1f, .cell_samples = 96, .pixel_samples = 64}, {});
        const Vec3f right = normalize(cross(Vec3f{0, 1, 0}, direction)), down = cross(direction, right);
        const ShotParts parts{.color = true, .range = false, .pixel_samples = 64, .radiance = true};
        return luminance(
            traced
                .perspective({Mat3f::from_columns(right, down, direction), {}}, {1, 1, 100, 100, 0.5f, 0.5f}, parts, {})
                .color.at(0, 0));
    };
    // A point behind the pane, seen past it; and the wall behind it, seen through it.
    const Vec3f past = normalize(Vec3f{1.2f, 1.5f, 0.7f}), through = normalize(Vec3f{0.5f, 0.2f, 2.f});
    constexpr int kPaths = 8192;
    const float open = mean_radiance(room_of(0, false), past, kPaths);
    EXPECT_NEAR(mean_radiance(room_of(0.05f, true), past, kPaths) / open, 1.f, 0.05f);
    EXPECT_LT(mean_radiance(room_of(0.9f, true), past, kPaths) / open, 0.9f) << "frosted glass scatters it";
    EXPECT_NEAR(cached(room_of(0.05f, true), past) / cached(room_of(0.05f, false), past), 1.f, 0.05f);
    EXPECT_NEAR(cached(room_of(0.05f, true), through) / mean_radiance(room_of(0.05f, true), through, kPaths), 1.f,
                0.08f);
}

// Shingles that lean out from a wall into vertical sun that never reaches the wall; each is tessellated into `cut` x
// `cut` squares.
Room shingled_room(int cut) {
    Room room;
    room.min_corner = kLow, room.max_corner = kHigh;
    room.materials = {diffuse({0.6f, 0.6f, 0.6f}), diffuse({0, 0, 0})};
    room.sky.sun_dir = {0, -1, 0};
    room.sky.sun_irradiance = {10, 10, 10};
    room.meshes = {box_mesh({kLow.x, kLow.y - 3, kLow.z - 0.2f}, {kHigh.x, kHigh.y, kLow.z}, 0, -1, false),
                   box_mesh({-1.5f, -0.5f, 1}, {1.5f, 1, 1.1f}, 0, -1, false),  // lit by the shingles only
                   // Black surroundings except for the sky: points that see nothing would be taken for the outside of
                   // the room.
                   box_mesh({kLow.x, kHigh.y, kLow.z}, {kHigh.x, kHigh.y + 0.2f, kHigh.z}, 1, -1, false),
                   box_mesh({kLow.x - 0.2f, kLow.y, kLow.z}, {kLow.x, kHigh.y, kHigh.z}, 1, -1, false),
                   box_mesh({kHigh.x, kLow.y, kLow.z}, {kHigh.x + 0.2f, kHigh.y, kHigh.z}, 1, -1, false)};
    Mesh shingles;
    const float side = 0.03f / static_cast<float>(cut);
    const Vec3f normal = normalize(Vec3f{0, -0.6f, 1}), across{1, 0, 0}, up = cross(normal, across);
    for (float x = -1.5f; x < 1.5f; x += 0.06f)
        for (int i = 0; i < cut; ++i)
            for (int k = 0; k < cut; ++k) {
                const Vec3f at = Vec3f{x, 0.2f, kLow.z + 0.01f} + across * (side * static_cast<float>(i)) +
                                 up * (side * static_cast<float>(k));
                for (const Vec3f p : {at, at + across * side, at + up * side, at + up * side, at + across * side,
                                      at + across * side + up * side}) {
                    shingles.triangles.push_back(static_cast<std::uint32_t>(shingles.positions.size()));
                    shingles.positions.push_back(p);
                    shingles.normals.push_back(normal);
                    shingles.coords.push_back(p);
                }
            }
    room.meshes.push_back(std::move(shingles));
    return room;
}

// A cell's surfaces count by area: slivers along a sunlit edge must not make the whole cell sunny.
TEST(Path, LightDoesNotDependOnHowSurfacesAreCut) {
    const auto light_of_board = [](int cut) {
        TracedRoom traced(shingled_room(cut));
        traced.gather_light({.cell_m = 0.06f, .cell_samples = 256, .pixel_samples = 16}, {});
        const ImageColor image = traced
                                     .panorama({}, {64, 32},
                                               {.color = true, .range = false, .pixel_samples = 16, .radiance = true},
                                               {})
                                     .color;
        double sum = 0;
        for (int y = 14; y < 20; ++y)
            for (int x = 26; x < 38; ++x) sum += static_cast<double>(luminance(image.at(x, y)));
        return sum;
    };
    EXPECT_NEAR(light_of_board(12) / light_of_board(1), 1.0, 0.3);  // 1.44 if points counted equally
}

// A lacquered panel lit by the sun from behind the camera, and a floor shaded by a barrier: the floor must be much
// brighter where a mirror would send the sun than beside it.
TEST(Path, LacquerInTheSunLightsWhatAMirrorWould) {
    Room room;
    room.min_corner = kLow, room.max_corner = kHigh;
    room.materials = {diffuse({0.6f, 0.6f, 0.6f}), diffuse({0.1f, 0.1f, 0.1f}), diffuse({0, 0, 0})};
    Material& lacquer = room.materials[1];
    lacquer.roughness = 0.35f;
    lacquer.specular = 0.3f;
    room.sky.sun_dir = normalize(Vec3f{0, -1, -1});
    room.sky.sun_irradiance = {10, 10, 10};
    const float floor = 1.4f;
    room.meshes = {box_mesh({kLow.x, floor, kLow.z}, {kHigh.x, floor + 0.1f, 2.2f}, 0, -1, false),
                   box_mesh({-0.6f, -0.9f, 2}, {0.6f, floor, 2.1f}, 1, -1, false),
                   box_mesh({-1.9f, 0.3f, 0.8f}, {1.9f, floor, 0.85f}, 2, -1, false)};
    TracedRoom traced(room);
    traced.gather_light({.cell_m = 0.06f, .cell_samples = 512, .pixel_samples = 16}, {});
    // Looking straight down.
    const auto cached = [&](Vec3f from) {
        const ShotParts parts{.color = true, .range = false, .pixel_samples = 64, .radiance = true};
        const Mat3f turn = Mat3f::from_columns({1, 0, 0}, {0, 0, -1}, {0, 1, 0});
        return luminance(traced.perspective({turn, from}, {1, 1, 100, 100, 0.5f, 0.5f}, parts, {}).color.at(0, 0));
    };
    constexpr int kPaths = 20000;
    const Vec3f before{0, 1, 1.4f}, aside{1.3f, 1, 1.4f};
    const float wanted = mean_radiance(room, {0, 1, 0}, kPaths, before),
                wanted_aside = mean_radiance(room, {0, 1, 0}, kPaths, aside);
    EXPECT_GT(wanted, 6 * wanted_aside);
    EXPECT_NEAR(cached(before) / wanted, 1.f, 0.08f);
    EXPECT_NEAR(cached(aside) / wanted_aside, 1.f, 0.3f);
}

}  // namespace
}  // namespace fastscene

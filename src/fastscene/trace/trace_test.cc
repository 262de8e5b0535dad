#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/parallel.h"
#include "fastscene/base/random.h"
#include "fastscene/image/color.h"
#include "fastscene/image/ssim.h"
#include "fastscene/scene/box.h"
#include "fastscene/trace/film.h"
#include "fastscene/trace/irradiance.h"
#include "fastscene/trace/lights.h"
#include "fastscene/trace/response.h"
#include "fastscene/trace/scene_bvh.h"
#include "fastscene/trace/surface.h"
#include "fastscene/trace/test_room.h"
#include "fastscene/trace/texture.h"
#include "fastscene/trace/trace.h"

namespace fastscene {
namespace {

// A box; `inward`: seen from inside, as a room; else a solid.
Mesh box(Vec3f low, Vec3f high, bool inward, int material, int object = -1) {
    return box_mesh(low, high, material, object, inward);
}

Room empty_room(Material walls) {
    Room room;
    room.min_corner = kLow;
    room.max_corner = kHigh;
    room.materials = {walls};
    room.meshes = {box(kLow, kHigh, true, 0)};
    return room;
}

// A room with a lamp, a red box on the right and a metal box on the left.
Room furnished_room() {
    Room room = empty_room(diffuse({0.7f, 0.65f, 0.6f}));
    room.materials[0].pattern = Pattern::planks;
    Material lamp = diffuse({0.8f, 0.8f, 0.8f}), red = diffuse({0.7f, 0.05f, 0.04f}),
             metal = diffuse({0.8f, 0.75f, 0.6f});
    lamp.emission = {9, 8, 7};
    metal.metal = 1;
    metal.roughness = 0.25f;
    room.materials.insert(room.materials.end(), {lamp, red, metal});
    room.objects.resize(2);
    room.meshes.push_back(box({-0.2f, -1.05f, 0.8f}, {0.2f, -1.f, 1.2f}, false, 1));
    room.meshes.push_back(box({0.9f, 0.7f, 1.2f}, {1.5f, 1.5f, 1.8f}, false, 2, 0));
    room.meshes.push_back(box({-1.5f, 0.9f, 1.2f}, {-0.9f, 1.5f, 1.8f}, false, 3, 1));
    return room;
}

TraceParams quick() {
    TraceParams p;
    p.cell_m = 0.12f;
    p.cell_samples = 128;
    p.pixel_samples = 16;
    return p;
}

// The furnished room with its light, gathered once.
const TracedRoom& lit_room() {
    static const TracedRoom room = [] {
        TracedRoom out(furnished_room());
        out.gather_light(quick(), {});
        return out;
    }();
    return room;
}

// Furnace test: in a closed room with albedo 1/2 and emission 1/2, the radiance is 1 in all directions.
TEST(Trace, Furnace) {
    Material glowing = diffuse({0.5f, 0.5f, 0.5f});
    glowing.emission = {0.5f, 0.5f, 0.5f};
    const Room room = empty_room(glowing);
    const SceneBvh bvh(room);
    const Lights lights(room);
    TraceParams params = quick();
    params.cell_m = 0.25f;
    const IrradianceCache cache = IrradianceCache::gather(room, bvh, lights, params, {});
    double sum = 0;
    int count = 0;
    for (int i = 0; i < 400; ++i) {
        Random random(5, "furnace", static_cast<std::uint64_t>(i));
        const Vec3f direction = normalize(Vec3f{random.normal(), random.normal(), random.normal()});
        const RayHit hit = bvh.first_hit({}, direction);
        ASSERT_TRUE(hit);
        const float radiance = 0.5f + 0.5f * luminance(cache.at(direction * hit.distance, hit.normal)) /
                                          static_cast<float>(M_PI);
        EXPECT_NEAR(radiance, 1.f, 0.06f);
        sum += radiance;
        ++count;
    }
    EXPECT_NEAR(sum / count, 1.0, 0.02);
}

TEST(Trace, RangeOfABoxRoomIsItsClosedForm) {
    const TracedRoom room(empty_room(diffuse({0.5f, 0.5f, 0.5f})));
    const EquirectSize size{128, 64};
    const Shot shot = room.panorama({}, size, {.color = false, .range = true, .normal = true}, {});
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const Vec3f d = direction_of_pixel(x, y, size);
            float expected = 1e9f;
            for (std::size_t a = 0; a < 3; ++a)
                if (d[a] != 0) expected = std::min(expected, (d[a] > 0 ? kHigh[a] : kLow[a]) / d[a]);
            EXPECT_NEAR(shot.range.at(x, y), expected, 1e-4f * expected);
            EXPECT_LT(dot(shot.normal.at(x, y), d), 0) << "normals look at the viewer";
        }
}

// A flat mirror shows a virtual image at a fixed position; a curved one has no such image.
TEST(Trace, AFlatMirrorIsLookedInto) {
    Room room = empty_room(diffuse({0.5f, 0.5f, 0.5f}));
    Material mirror = diffuse({0.85f, 0.85f, 0.85f});
    mirror.mirror = 1;
    room.materials.push_back(mirror);
    room.objects.resize(2);
    constexpr float kGlass = 1.2f;
    room.meshes.push_back(box({-0.6f, -0.5f, kGlass}, {0.6f, 0.5f, kGlass + 0.02f}, false, 1, 0));
    room.meshes.push_back(box({1.f, -0.2f, -1.4f}, {1.4f, 0.2f, -1.f}, false, 1, 1));
    const TracedRoom traced(std::move(room));
    const EquirectSize size{256, 128};
    for (const Vec3f from : {Vec3f{}, Vec3f{0.4f, -0.2f, 0.3f}}) {
        const Shot shot = traced.panorama(
            {{}, from}, size, {.color = false, .range = true, .mirrored_range = true, .normal = true, .object = true},
            {});
        int mirrored = 0;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                const Vec3f d = direction_of_pixel(x, y, size);
                if (shot.object.at(x, y) != 0 || shot.normal.at(x, y).z > -0.99f) {
                    EXPECT_EQ(shot.mirrored_range.at(x, y), shot.range.at(x, y)) << "only the glass is looked into";
                    continue;
                }
                // The mirror image of the wall behind the camera lies as far behind the glass as the wall is in front
                // of it.
                float expected = (2 * kGlass - kLow.z - from.z) / d.z;
                for (std::size_t a = 0; a < 2; ++a)
                    expected = std::min(expected, ((d[a] > 0 ? kHigh[a] : kLow[a]) - from[a]) / d[a]);
                if (shot.mirrored_range.at(x, y) > 0.999f * expected) {
                    EXPECT_NEAR(shot.mirrored_range.at(x, y), expected, 1e-3f * expected);
                    ++mirrored;
                } else {  // the cube is seen in it
                    const Vec3f image = from + d * shot.mirrored_range.at(x, y);
                    EXPECT_NEAR(std::max({std::fabs(image.x - 1.2f), std::fabs(image.y),
                                          std::fabs(2 * kGlass - image.z + 1.2f)}),
                                0.2f, 2e-3f);
                }
            }
        EXPECT_GT(mirrored, 200);
    }
}

// A small patch under a square lamp: E = L times pi times the configuration factor of a parallel rectangle (Howell,
// B-3).
TEST(Trace, LightOfASquareLampIsItsFormFactor) {
    Room room = empty_room(diffuse({0, 0, 0}));
    Material lamp = diffuse({0, 0, 0});
    lamp.emission = {10, 10, 10};
    room.materials.push_back(lamp);
    const float half = 0.2f, height = 1.3f;  // below the limit of half a square metre, so it is sampled
    room.meshes.push_back(box({-half, 1.48f - height, -half}, {half, 1.5f - height, half}, false, 1));
    const SceneBvh bvh(room);
    const Lights lights(room);
    TraceParams params = quick();
    params.cell_m = 0.1f;
    params.cell_samples = 512;
    const IrradianceCache cache = IrradianceCache::gather(room, bvh, lights, params, {});
    const float x = half / height, s = std::sqrt(1 + x * x);
    const float quarter = (x / s * std::atan(x / s) * 2) / (2 * static_cast<float>(M_PI));
    const float expected = 10 * static_cast<float>(M_PI) * 4 * quarter;
    EXPECT_NEAR(cache.at({0, 1.5f, 0}, {0, -1, 0}).x / expected, 1.f, 0.06f);
}

// Mean of the light samples at a point of the floor below.
float sampled_light(const Room& room) {
    const SceneBvh bvh(room);
    const Lights lights(room, 0, &bvh);
    constexpr std::uint32_t kSamples = 20000;
    float sum = 0;
    Random random(7);
    for (std::uint32_t i = 0; i < kSamples; ++i) {
        const float which = (static_cast<float>(i) + random.uniform()) / kSamples;
        sum += lights.sample(room, bvh, {0.4f, 1.5f, 0.2f}, {0, -1, 0}, which, {random.uniform(), random.uniform()})
                   .irradiance.x;
    }
    return sum / kSamples;
}

TEST(Trace, AFlameAroundAnotherAddsItsLight) {
    const auto light_of = [](bool inner, bool outer) {
        Room room = empty_room(diffuse({0, 0, 0}));
        Material flame = diffuse({0, 0, 0}, {10, 10, 10});
        flame.burns = true;
        room.materials.push_back(flame);
        if (inner) room.meshes.push_back(box({-0.1f, 0.2f, -0.1f}, {0.1f, 0.4f, 0.1f}, false, 1));
        if (outer) room.meshes.push_back(box({-0.2f, 0.1f, -0.2f}, {0.2f, 0.5f, 0.2f}, false, 1));
        return sampled_light(room);
    };
    const float both = light_of(true, true), sum = light_of(true, false) + light_of(false, true);
    EXPECT_NEAR(both / sum, 1.f, 0.02f);
}

TEST(Trace, PathsAndTheCacheAgreeByTheLightOfAFlame) {
    Room room = empty_room(diffuse({0.5f, 0.5f, 0.5f}));
    Material flame = diffuse({0, 0, 0}, {20, 20, 20});
    flame.burns = true;
    room.materials.push_back(flame);
    room.meshes.push_back(box({-0.1f, 0.9f, -0.1f}, {0.1f, 1.2f, 0.1f}, false, 1));
    room.meshes.push_back(box({-0.05f, 0.95f, -0.05f}, {0.05f, 1.15f, 0.05f}, false, 1));
    TracedRoom traced(room);
    traced.gather_light(quick(), {});
    ShotParts parts{.pixel_samples = 64, .radiance = true};
    const auto mean_of = [&](const ShotParts& p) {
        const ImageColor picture = traced.panorama({}, {64, 32}, p, {}).color;
        double sum = 0;
        int n = 0;
        for (int y = 0; y < 16; ++y)  // above the horizon, where no flame is seen
            for (int x = 0; x < 64; ++x) sum += static_cast<double>(luminance(picture.at(x, y))), ++n;
        return sum / n;
    };
    const double cached = mean_of(parts);
    parts.paths = true;
    EXPECT_NEAR(cached / mean_of(parts), 1., 0.05);
}

TEST(Lights, AHiddenLampIsSampledLess) {
    Room room = empty_room(diffuse({0, 0, 0}));
    room.materials.push_back(diffuse({0, 0, 0}, {10, 10, 10}));
    room.meshes.push_back(box({-0.6f, 0.2f, -0.1f}, {-0.4f, 0.4f, 0.1f}, false, 1));
    room.meshes.push_back(box({0.4f, 0.2f, -0.1f}, {0.6f, 0.4f, 0.1f}, false, 1));
    room.meshes.push_back(box({0.35f, 0.15f, -0.15f}, {0.65f, 0.45f, 0.15f}, false, 0));  // its box
    const SceneBvh bvh(room);
    const Lights lights(room, 0, &bvh);
    int hidden = 0;
    constexpr int kDraws = 1000;
    for (int i = 0; i < kDraws; ++i) {
        const float u = (static_cast<float>(i) + 0.5f) / kDraws;
        const Lights::LightSample light = lights.draw(room, {0, 1.5f, 0}, {0, -1, 0}, u, {0.5f, 0.5f});
        hidden += light.pdf > 0 && light.direction.x > 0;
    }
    EXPECT_LT(hidden, kDraws / 5);
    EXPECT_GT(hidden, 0) << "it may still be seen through a gap";
}

// A sky of radiance 1 through a window: the wall opposite receives pi times the window's form factor.
TEST(Trace, WindowLetsTheSkyIn) {
    Room room = empty_room(diffuse({0, 0, 0}));
    // Replaces the two triangles of the wall at +x by four boxes around a hole.
    Mesh& shell = room.meshes[0];
    std::vector<std::uint32_t> kept;
    for (std::size_t t = 0; t < shell.triangles.size(); t += 3)
        if (shell.normals[shell.triangles[t]].x > -0.5f)
            kept.insert(kept.end(), {shell.triangles[t], shell.triangles[t + 1], shell.triangles[t + 2]});
    shell.triangles = kept;
    const float w = 0.4f;
    room.meshes.push_back(box({2, kLow.y, kLow.z}, {2.1f, kHigh.y, -w}, false, 0));
    room.meshes.push_back(box({2, kLow.y, w}, {2.1f, kHigh.y, kHigh.z}, false, 0));
    room.meshes.push_back(box({2, kLow.y, -w}, {2.1f, -w, w}, false, 0));
    room.meshes.push_back(box({2, w, -w}, {2.1f, kHigh.y, w}, false, 0));
    room.portals.push_back({{2.1f, -w, -w}, {0, 0, 2 * w}, {0, 2 * w, 0}});
    const Vec3f into = cross(room.portals[0].edge_u, room.portals[0].edge_v);
    if (into.x > 0) std::swap(room.portals[0].edge_u, room.portals[0].edge_v);
    room.sky.zenith = room.sky.horizon = room.sky.ground = {1, 1, 1};
    room.sky.clouds = 0;
    const SceneBvh bvh(room);
    const Lights lights(room);
    TraceParams params = quick();
    params.cell_samples = 512;
    params.cell_m = 0.06f;  // trees and flower beds outside make the light vary across the wall
    const IrradianceCache cache = IrradianceCache::gather(room, bvh, lights, params, {});
    // Reference by quadrature over directions, with what is actually outside.
    const Vec3f at{-2, 0, 0};
    double expected = 0;
    const int n = 200;
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < n; ++k) {
            const Vec3f target{2.1f, (2 * (static_cast<float>(i) + 0.5f) / n - 1) * w,
                               (2 * (static_cast<float>(k) + 0.5f) / n - 1) * w};
            const Vec3f to = target - at;
            const float d2 = dot(to, to), c = to.x / std::sqrt(d2);
            if (bvh.blocked(at + Vec3f{1e-3f, 0, 0}, normalize(to), 0, std::sqrt(d2) * 0.99f)) continue;
            expected += static_cast<double>(lights.outdoors().light(normalize(to)).x * c * c / d2) * (4 * w * w) /
                        (n * n);
        }
    EXPECT_NEAR(cache.at(at, {1, 0, 0}).x / expected, 1.0, 0.05);
}

TEST(Trace, RightIsRightAndThePanoramaAgreesWithThePerspective) {
    const TracedRoom& room = lit_room();
    const EquirectSize size{256, 128};
    const Shot shot = room.panorama({}, size, {.color = true, .range = true, .object = true}, {});
    // The red box at +x is right of the picture's center, the metal one left of it.
    std::array<double, 2> column{};
    std::array<int, 2> pixels{};
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            if (const int o = shot.object.at(x, y); o >= 0)
                column[static_cast<std::size_t>(o)] += x, ++pixels[static_cast<std::size_t>(o)];
    ASSERT_GT(pixels[0], 20);
    ASSERT_GT(pixels[1], 20);
    EXPECT_GT(column[0] / pixels[0], 128 + 10);
    EXPECT_LT(column[1] / pixels[1], 128 - 10);

    const Pinhole camera = Pinhole::with_fov(65, 65, 60);
    const Shot view = room.perspective({}, camera, {.color = true, .range = true}, {});
    for (int y = 4; y < 65; y += 9)
        for (int x = 4; x < 65; x += 9) {
            const Vec3f d = normalize(
                camera.direction_at({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}));
            EXPECT_NEAR(view.range.at(x, y), room.distance({}, d), 1e-4f);
        }
    // Columns at the seam are continuous.
    double across = 0, inside = 0;
    for (int y = 20; y < 108; ++y) {
        across += static_cast<double>(length(shot.color.at(0, y) - shot.color.at(255, y)));
        inside += static_cast<double>(length(shot.color.at(1, y) - shot.color.at(2, y)));
    }
    EXPECT_LT(across, 2 * inside + 0.5);
}

TEST(Trace, SameBytesForOneAndTwoThreads) {
    std::array<Shot, 2> shots;
    for (int threads = 1; threads <= 2; ++threads) {
        set_threads(threads);
        TracedRoom room(furnished_room());
        TraceParams params = quick();
        params.cell_samples = 32;
        params.pixel_samples = 4;
        room.gather_light(params, {});
        const ShotParts parts{.color = true, .range = true, .contacts = true, .denoise = true};
        shots[static_cast<std::size_t>(threads - 1)] = room.panorama({}, {96, 48}, parts, {});
    }
    set_threads(0);
    EXPECT_EQ(shots[0].color, shots[1].color);
    EXPECT_EQ(shots[0].range, shots[1].range);
}

// An object behind a pane keeps its color; the pane absorbs little, and is still reported as the first hit.
TEST(Trace, GlassIsSeenThrough) {
    const auto look = [](bool pane) {
        Room room = furnished_room();
        if (pane) {
            Material glass = diffuse({0.6f, 0.68f, 0.66f});
            glass.transmission = 0.8f;
            glass.roughness = 0.05f;
            glass.specular = 0.08f;
            room.materials.push_back(glass);
            room.objects.resize(3);
            room.meshes.push_back(
                box({0.5f, 0.3f, 0.9f}, {1.9f, 1.45f, 0.905f}, false, static_cast<int>(room.materials.size()) - 1, 2));
        }
        TracedRoom traced(std::move(room));
        traced.gather_light(quick(), {});
        return traced.perspective({}, Pinhole::with_fov(64, 64, 100),
                                  {.color = true, .range = false, .object = true, .contacts = true}, {});
    };
    const Shot clear = look(false), through = look(true);
    const Vec3f red = clear.color.at(58, 56), seen = through.color.at(58, 56);
    EXPECT_EQ(through.object.at(58, 56), 2);
    ASSERT_GT(red.x, 3 * red.y);
    EXPECT_GT(seen.x, 2 * seen.y);
    EXPECT_GT(luminance(seen), 0.5f * luminance(red));
    EXPECT_LT(luminance(seen), 1.75f * luminance(red));
}

// In a mirror too.
TEST(Trace, GlassIsSeenThroughInMirrors) {
    const auto look = [](bool pane) {
        Room room = furnished_room();
        Material mirror = diffuse({0.85f, 0.85f, 0.85f}), glass = diffuse({0.6f, 0.68f, 0.66f});
        mirror.mirror = 1;
        mirror.roughness = glass.roughness = 0.05f;
        glass.transmission = 0.8f;
        room.materials.push_back(mirror);
        room.materials.push_back(glass);
        const int last = static_cast<int>(room.materials.size()) - 1;
        room.meshes.push_back(box({-0.5f, -0.5f, 1.2f}, {0.5f, 0.5f, 1.22f}, false, last - 1));
        room.meshes.push_back(box({-0.6f, -0.6f, -1.4f}, {0.6f, 0.6f, -1.2f}, false, 2));  // red, behind the camera
        if (pane) room.meshes.push_back(box({-0.9f, -0.9f, -0.9f}, {0.9f, 0.9f, -0.895f}, false, last));
        TracedRoom traced(std::move(room));
        traced.gather_light(quick(), {});
        return traced
            .perspective({}, Pinhole::with_fov(32, 32, 60),
                         {.color = true, .range = false, .object = true, .contacts = true}, {})
            .color.at(16, 16);
    };
    const Vec3f red = look(false), seen = look(true);
    ASSERT_GT(red.x, 3 * red.y);
    EXPECT_GT(seen.x, 2 * seen.y);
    EXPECT_GT(luminance(seen), 0.4f * luminance(red));
}

// A mirror shows light as smooth as a direct view: no cell borders.
TEST(Trace, MirrorsShowNoCells) {
    Room room = empty_room(diffuse({0.7f, 0.7f, 0.7f}));
    Material mirror = diffuse({0.9f, 0.9f, 0.9f});
    mirror.mirror = 1;
    mirror.roughness = 0.05f;
    room.materials.insert(room.materials.end(), {mirror, diffuse({0, 0, 0}, {9, 9, 9})});
    room.meshes.push_back(box({-1, -0.5f, 1}, {1, 0.5f, 1.02f}, false, 1));
    room.meshes.push_back(box({-1.9f, -0.2f, -2}, {-1.7f, 0.2f, -1.8f}, false,
                              2));  // next to the wall behind the camera, out of view
    TracedRoom traced(std::move(room));
    traced.gather_light(quick(), {});
    const ShotParts parts{.color = true, .range = false, .pixel_samples = 8, .radiance = true, .contacts = true};
    const ImageColor seen = traced.perspective({}, Pinhole::with_fov(384, 8, 40), parts, {}).color;
    const auto first = luminance(seen.at(0, 4)), last = luminance(seen.at(383, 4));
    ASSERT_GT(std::max(first, last), 1.5f * std::min(first, last));  // precondition: the light varies along the wall
    for (int x = 0; x + 1 < seen.width; ++x)
        for (int y = 0; y < seen.height; ++y)
            EXPECT_NEAR(luminance(seen.at(x + 1, y)) / luminance(seen.at(x, y)), 1, 0.03) << x << " " << y;
}

// However few rays are requested, the denoiser gets a variance estimate.
TEST(Trace, FewRaysAreDenoisedToo) {
    const TracedRoom& room = lit_room();
    const Pinhole camera = Pinhole::with_fov(96, 96, 75);
    const auto picture = [&](int samples, bool denoised, std::uint64_t seed) {
        fastscene::Run run;
        run.seed = seed;
        return room
            .perspective(
                {}, camera,
                {.color = true, .range = false, .pixel_samples = samples, .contacts = true, .denoise = denoised}, run)
            .color;
    };
    const ImageColor truth = picture(256, false, 3);
    const auto error = [&](const ImageColor& color) {
        double sum = 0;
        for (std::size_t i = 0; i < truth.size(); ++i) {
            const double d = luminance(color.pixels[i]) - luminance(truth.pixels[i]);
            sum += d * d;
        }
        return std::sqrt(sum / static_cast<double>(truth.size()));
    };
    const double raw = error(picture(3, false, 5));
    for (const int samples : {1, 4, 8, 24})
        EXPECT_LT(error(picture(samples, true, 5)), 0.9 * raw) << samples << " rays";
}

// With two rays a pixel, what metal reflects has fewer specks, and what reflects nothing stays as it was.
TEST(Trace, ReflectionsAloneAreDenoised) {
    Room scene = furnished_room();
    for (Material& m : scene.materials)
        if (m.metal == 0) m.roughness = 1, m.specular = 0;
    TracedRoom room(std::move(scene));
    room.gather_light(quick(), {});
    const Pinhole camera = Pinhole::with_fov(96, 96, 75);
    const auto shot = [&](int samples, bool denoised, std::uint64_t seed) {
        fastscene::Run run;
        run.seed = seed;
        return room.perspective({}, camera,
                                {.color = true,
                                 .range = false,
                                 .object = true,
                                 .pixel_samples = samples,
                                 .frugal = true,
                                 .min_alpha = 0.3f,
                                 .denoise_reflections = denoised},
                                run);
    };
    const Shot truth = shot(256, false, 3), raw = shot(2, false, 5), denoised = shot(2, true, 5);
    double raw_error = 0, error = 0, changed = 0;
    for (std::size_t i = 0; i < truth.color.size(); ++i) {
        const auto squared = [&](const Shot& s) {
            const double d = luminance(s.color.pixels[i]) - luminance(truth.color.pixels[i]);
            return d * d;
        };
        if (truth.object.pixels[i] == 1) raw_error += squared(raw), error += squared(denoised);
        else changed += raw.color.pixels[i] == denoised.color.pixels[i] ? 0 : 1;
    }
    EXPECT_GT(raw_error, 0);
    EXPECT_LT(error, 0.5 * raw_error);
    EXPECT_LT(changed, 0.02 * static_cast<double>(truth.color.size())) << "only outlines of metal";
}

// A partial picture equals the full picture, up to the denoiser's context at the mask's border.
TEST(Trace, SomePixelsAreAsInTheWholePicture) {
    const TracedRoom& room = lit_room();
    const EquirectSize size{256, 128};
    ImageMask asked(size.width, size.height);
    for (int y = 50; y < 110; ++y)
        for (int x = 240; x < 330; ++x) asked.at(x % size.width, y) = 255;  // across the seam
    for (const bool denoised : {false, true}) {
        ShotParts parts{
            .mirrored_range = true, .pixel_samples = 32, .contacts = true, .denoise = denoised, .noise = 0.012f};
        const Shot whole = room.panorama({}, size, parts, {});
        parts.only = &asked;
        const Shot some = room.panorama({}, size, parts, {});
        EXPECT_GT(psnr(srgb8_from_linear(some.color), srgb8_from_linear(whole.color), asked), denoised ? 45 : 1000)
            << denoised;
        for (std::size_t i = 0; i < asked.size(); ++i)
            if (asked.pixels[i]) {
                EXPECT_EQ(some.range.pixels[i], whole.range.pixels[i]);
                EXPECT_EQ(some.mirrored_range.pixels[i], whole.mirrored_range.pixels[i]);
            }
        EXPECT_EQ(some.color.at(100, 20), Vec3f{}) << "what was not asked for is not traced";
    }
}

// A bar an eighth of a pixel wide is equally bright along its length, though the first rays of most of its pixels miss
// it.
TEST(Trace, ThinLinesDoNotBreak) {
    Room room = empty_room(diffuse({0, 0, 0}, {0.05f, 0.05f, 0.05f}));
    room.materials.push_back(diffuse({0, 0, 0}, {0.6f, 0.6f, 0.6f}));
    constexpr int kSide = 96;
    const float far = 2, pixel = 2 * far * std::tan(kPi / 6) / kSide;
    room.meshes.push_back(box({-1.9f, 0.2f, far}, {1.9f, 0.2f + 0.12f * pixel, far + 0.001f}, false, 1));
    TracedRoom traced(std::move(room));
    traced.gather_light(quick(), {});
    const float lean = 0.03f;
    const Rigid leaning{
        Mat3f::from_columns({std::cos(lean), std::sin(lean), 0}, {-std::sin(lean), std::cos(lean), 0}, {0, 0, 1}), {}};
    const ShotParts parts{
        .color = true, .range = false, .pixel_samples = 64, .radiance = true, .denoise = true, .noise = 0.012f};
    const ImageColor seen = traced.perspective(leaning, Pinhole::with_fov(kSide, kSide, 60), parts, {}).color;
    std::vector<float> columns;
    for (int x = 0; x < kSide; ++x) {
        float sum = 0;
        for (int y = 0; y < kSide; ++y) sum += luminance(seen.at(x, y)) - luminance(seen.at(x, 0));
        columns.push_back(sum);
    }
    std::vector<float> sorted = columns;
    std::sort(sorted.begin(), sorted.end());
    const float middle = sorted[kSide / 2];
    ASSERT_GT(middle, 0.008f);
    for (int x = 0; x < kSide; ++x) EXPECT_NEAR(columns[static_cast<std::size_t>(x)] / middle, 1, 0.6) << x;
}

// The soft shadow of a bar two metres above the floor. Trusting four rays that happened to agree left its edge ragged.
TEST(Trace, ShadowEdgesAreNotRagged) {
    Room room = empty_room(diffuse({0.6f, 0.6f, 0.6f}));
    const float floor = 1.1f;
    room.meshes = {box({-4, floor, -4}, {4, floor + 0.01f, 4}, false, 0),
                   box({-4, -1, 0.1f}, {4, -0.99f, 0.13f}, false, 0)};
    room.sky.sun_dir = normalize(Vec3f{0.1f, -1, 0.05f});
    room.sky.sun_irradiance = {3, 3, 3};
    TracedRoom traced(std::move(room));
    traced.gather_light(quick(), {});
    constexpr int kSide = 96;
    const float lean = 0.03f;
    const Rigid down{
        Mat3f::from_columns({std::cos(lean), 0, -std::sin(lean)}, {-std::sin(lean), 0, -std::cos(lean)}, {0, 1, 0}),
        {}};
    const ShotParts parts{
        .color = true, .range = false, .pixel_samples = 64, .radiance = true, .denoise = true, .noise = 0.012f};
    const ImageColor seen = traced.perspective(down, Pinhole::with_fov(kSide, kSide, 60), parts, {}).color;
    const ImageColor wanted = traced
                                  .perspective(down, Pinhole::with_fov(kSide, kSide, 60),
                                               {.color = true, .range = false, .pixel_samples = 256, .radiance = true},
                                               {})
                                  .color;
    double squares = 0, edge = 0;
    const float lit = luminance(wanted.at(kSide / 2, 0));
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const float is = luminance(seen.pixels[i]) / lit, should_be = luminance(wanted.pixels[i]) / lit;
        if (!(should_be < 0.95f)) continue;
        squares += (is - should_be) * (is - should_be);
        ++edge;
    }
    ASSERT_GT(edge, 2 * kSide);
    EXPECT_LT(std::sqrt(squares / edge), 0.05);  // 0.059 if they are trusted
}

// Texture edges on one evenly lit surface: pixels there hold the area-weighted mean of both colors.
TEST(Trace, EdgesOfPatternsAreNotRagged) {
    Material squares = diffuse({0.9f, 0.9f, 0.9f}, {1, 1, 1});
    squares.pattern = Pattern::checker;
    squares.color_b = {0.2f, 0.2f, 0.2f};
    squares.scale_m = 0.31f;
    TracedRoom traced(empty_room(squares));
    traced.gather_light(quick(), {});
    constexpr int kSide = 96;
    const float lean = 0.13f;
    const Rigid down{
        Mat3f::from_columns({std::cos(lean), 0, -std::sin(lean)}, {-std::sin(lean), 0, -std::cos(lean)}, {0, 1, 0}),
        {}};
    const auto picture = [&](const ShotParts& parts) {
        return traced.perspective(down, Pinhole::with_fov(kSide, kSide, 60), parts, {}).color;
    };
    const ImageColor
        seen = picture(
            {.color = true, .range = false, .pixel_samples = 64, .radiance = true, .denoise = true, .noise = 0.012f}),
        wanted = picture({.color = true, .range = false, .pixel_samples = 256, .radiance = true});
    float low = 1e9f, high = 0;
    for (const Vec3f& c : wanted.pixels) low = std::min(low, luminance(c)), high = std::max(high, luminance(c));
    double squared = 0, edge = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const float is = (luminance(seen.pixels[i]) - low) / (high - low),
                    should_be = (luminance(wanted.pixels[i]) - low) / (high - low);
        if (!(should_be > 0.05f && should_be < 0.9f)) continue;
        squared += (is - should_be) * (is - should_be);
        ++edge;
    }
    ASSERT_GT(edge, 2 * kSide);
    EXPECT_LT(std::sqrt(squared / edge), 0.04);  // 0.056 if first rays that agree are trusted
}

TEST(Trace, TwoSetsOfCameraRaysAgree) {
    const TracedRoom& room = lit_room();
    const Pinhole camera = Pinhole::with_fov(128, 128, 75);
    fastscene::Run other;
    other.seed = 77;
    const auto picture = [&](const fastscene::Run& run, const ShotParts& parts) {
        return srgb8_from_linear(room.perspective({}, camera, parts, run).color);
    };
    EXPECT_GT(psnr(picture({}, {}), picture(other, {})), 34);
    const ShotParts fine{.color = true, .range = false, .pixel_samples = 256, .noise = 0.006f};
    EXPECT_GT(psnr(picture({}, fine), picture(other, fine)), 42);
}

// The fast tree is not watertight: still no ray may escape between two triangles, not even when aimed at their common
// edge.
TEST(Trace, NoRayLeavesAClosedRoom) {
    const TracedRoom room(furnished_room());
    Random rng(8, "rays");
    int lost = 0;
    for (int i = 0; i < 400'000; ++i) {
        const Vec3f from{rng.uniform(-0.5f, 0.5f), rng.uniform(-0.5f, 0.5f), rng.uniform(-0.5f, 0.5f)};
        Vec3f to{rng.uniform(kLow.x, kHigh.x), rng.uniform(kLow.y, kHigh.y), rng.chance(0.5f) ? kLow.z : kHigh.z};
        if (i % 2) to.x = rng.chance(0.5f) ? kLow.x : kHigh.x;  // an edge of the room
        lost += std::isinf(room.distance(from, normalize(to - from)));
    }
    EXPECT_EQ(lost, 0);
}

// Rays that hit nothing are traced again in the watertight tree: a pane on the way to a window must not block light
// there either.
TEST(Trace, LightLeavesThroughPanes) {
    Material pane = diffuse({1, 1, 1});
    pane.transmission = 0.92f;
    pane.roughness = 0.05f;
    ASSERT_TRUE(is_clear(pane));
    Room room = empty_room(diffuse({0.5f, 0.5f, 0.5f}));
    room.materials.push_back(pane);
    room.meshes = {box({-2, 1.4f, -2.5f}, {2, 1.5f, 2.5f}, false, 0), box({-1, -1, 1}, {1, 1, 1.01f}, false, 1)};
    const SceneBvh bvh(room);
    const RayHit seen = bvh.first_hit({}, {0, 0, 1});
    ASSERT_TRUE(seen);
    EXPECT_EQ(seen.mesh, 1);
    EXPECT_FALSE(bvh.first_lit({}, {0, 0, 1}));
    EXPECT_EQ(bvh.first_lit({0, 0, 2}, normalize(Vec3f{0, 1, -1})).mesh, 0);
}

TEST(Trace, ClearanceIsZeroInsideAndTheDistanceOutside) {
    const TracedRoom room(furnished_room());
    EXPECT_EQ(room.clearance({1.2f, 1.1f, 1.5f}, 0.5f), 0.f);
    EXPECT_NEAR(room.clearance({0.6f, 1.1f, 1.5f}, 0.5f), 0.3f, 1e-4f);
    EXPECT_EQ(room.clearance({0, 0, 0}, 0.5f), 0.5f);
}

TEST(IsClosed, SolidsAreSheetsAreNot) {
    Mesh solid = box({0, 0, 0}, {1, 1, 1}, false, 0);
    EXPECT_TRUE(is_closed(solid));
    solid.triangles.resize(solid.triangles.size() - 3);
    EXPECT_FALSE(is_closed(solid));
}

TEST(Texture, EveryPatternIsInRangeAndRepeats) {
    for (int p = 0; p < static_cast<int>(Pattern::image); ++p) {
        Material m;
        m.pattern = static_cast<Pattern>(p);
        m.color_a = {0.6f, 0.4f, 0.2f};
        m.color_b = {0.2f, 0.3f, 0.5f};
        m.color_c = {0.8f, 0.8f, 0.7f};
        m.scale_m = 0.15f;
        for (int i = 0; i < 500; ++i) {
            Random random(9, "texture", static_cast<std::uint64_t>(i));
            TexturePoint point;
            point.coords = {random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)};
            point.plane = {point.coords.x, point.coords.y};
            point.footprint_m = random.uniform(0, 0.02f);
            const TextureValue v = sample_texture(m, point);
            for (std::size_t a = 0; a < 3; ++a) {
                ASSERT_GE(v.albedo[a], 0.f) << p;
                ASSERT_LE(v.albedo[a], 1.f) << p;
            }
            ASSERT_GE(v.roughness, 0.02f);
            m.bump_m = 0.002f, m.crease_m = 0.002f;
            ASSERT_LE(length(texture_with_slope(m, point, 2, true).slope), 0.71f) << p;
            ASSERT_EQ(sample_texture(m, point).albedo, v.albedo);
        }
    }
}

std::shared_ptr<const TextureImage> texture_of(Rgb8 color) {
    TextureImage texture;
    texture.levels.push_back(ImageRgb8(1, 1, color));
    return std::make_shared<const TextureImage>(std::move(texture));
}

// A quad in the plane z = 2 as seen from the origin, its u to the right (x) and its v up (-y).
TEST(Texture, MapsOfNormalsAndMetalAreThoseOfGltf) {
    Room room;
    Material m;
    m.pattern = Pattern::image;
    m.image = texture_of({188, 188, 188});
    m.metal = 0.5f, m.roughness = 0.8f;
    Mesh quad;
    quad.positions = {{-1, 1, 2}, {1, 1, 2}, {1, -1, 2}, {-1, -1, 2}};
    quad.normals.assign(4, {0, 0, -1});
    quad.coords = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    quad.triangles = {0, 2, 1, 0, 3, 2};
    room.meshes.push_back(quad);
    const auto seen = [&] {
        room.materials = {m};
        const SceneBvh bvh(room);
        const RayHit hit = bvh.first_hit({}, {0, 0, 1});
        EXPECT_TRUE(hit);
        return surface_at(room, hit, {}, {0, 0, 1}, 0.001f, true);
    };
    EXPECT_EQ(seen().bumped, (Vec3f{0, 0, -1}));
    EXPECT_EQ(seen().texture.metal, 0.5f);
    m.normals = texture_of({128, 128, 255});  // flat, as nearly as a byte can say it
    EXPECT_GT(dot(seen().bumped, Vec3f{0, 0, -1}), 0.9999f);
    // Tilted by asin(0.5) towards u, then towards v.
    m.normals = texture_of({191, 128, 238});
    EXPECT_NEAR(seen().bumped.x, 0.5f, 0.01f);
    EXPECT_NEAR(seen().bumped.y, 0, 0.01f);
    m.normals = texture_of({128, 191, 238});
    EXPECT_NEAR(seen().bumped.y, -0.5f, 0.01f);
    m.metallic_roughness = texture_of({0, 51, 102});
    EXPECT_NEAR(seen().texture.roughness, 0.8f * 0.2f, 1e-5f);
    EXPECT_NEAR(seen().texture.metal, 0.5f * 0.4f, 1e-5f);
    EXPECT_NEAR(mean_metal(m), 0.2f, 1e-5f);
}

// From a distance a pattern fades to its mean, so walls keep their color and bounced light matches what the camera
// sees. The cache's mean agrees, wherever the joints lie.
TEST(Texture, PatternsKeepTheirMeanFromAfar) {
    const auto mean = [](const Material& m, float footprint_m) {
        double sum = 0;
        constexpr int kPlaces = 6000;
        const float wide_m = 12 * std::max(m.scale_m, 0.1f);
        for (int i = 0; i < kPlaces; ++i) {
            Random random(5, "places", static_cast<std::uint64_t>(i));
            TexturePoint p;
            p.plane = Vec2f{random.uniform(), random.uniform()} * wide_m;
            p.coords = {p.plane.x, p.plane.y, random.uniform() * wide_m};
            p.footprint_m = footprint_m;
            sum += static_cast<double>(luminance(sample_texture(m, p).albedo));
        }
        return sum / kPlaces;
    };
    struct Case {
        Pattern pattern;
        float scale_m;
    };
    for (const auto& [pattern, scale_m] :
         {Case{Pattern::tile, 0.1f},    {Pattern::tile, 0.4f},        {Pattern::subway, 0.075f},
          {Pattern::checker, 0.3f},     {Pattern::brick, 0.065f},     {Pattern::marble, 0.5f},
          {Pattern::terrazzo, 0.03f},   {Pattern::stripes, 0.02f},    {Pattern::wicker, 0.02f},
          {Pattern::leather, 0.01f},    {Pattern::planks, 0.1f},      {Pattern::herringbone, 0.09f},
          {Pattern::concrete, 0.6f},    {Pattern::fabric, 0.002f},    {Pattern::knit, 0.012f},
          {Pattern::dots, 0.2f},        {Pattern::zigzag, 0.2f},      {Pattern::twill, 0.2f},
          {Pattern::geometric, 0.2f},   {Pattern::diamonds, 0.2f},    {Pattern::lattice, 0.2f},
          {Pattern::stars, 0.2f},       {Pattern::gingham, 0.2f},     {Pattern::plaid, 0.2f},
          {Pattern::houndstooth, 0.2f}, {Pattern::patchwork, 0.05f},  {Pattern::leopard, 0.2f},
          {Pattern::zebra, 0.2f},       {Pattern::camouflage, 0.2f},  {Pattern::paisley, 0.2f},
          {Pattern::encaustic, 0.2f},   {Pattern::laid_tiles, 0.05f}, {Pattern::peeling, 0.6f}}) {
        Material m = diffuse({});
        m.pattern = pattern;
        m.scale_m = scale_m;
        for (const bool dark : {false, true}) {
            m.color_a = dark ? Vec3f{0.1f, 0.1f, 0.1f} : Vec3f{0.6f, 0.6f, 0.6f};
            m.color_b = dark ? Vec3f{0.6f, 0.6f, 0.6f} : Vec3f{0.1f, 0.1f, 0.1f};
            m.color_c = {0.3f, 0.3f, 0.3f};
            const double near = mean(m, 0.0015f);
            for (const float far_m : {0.01f, 0.1f, 0.6f})
                EXPECT_NEAR(mean(m, far_m) / near, 1, 0.15) << static_cast<int>(pattern) << " of " << scale_m << " at "
                                                            << far_m << (dark ? ", dark" : ", light");
            EXPECT_NEAR(static_cast<double>(luminance(mean_albedo(m))) / near, 1, 0.15)
                << static_cast<int>(pattern) << " of " << scale_m << (dark ? ", dark" : ", light");
        }
    }
}

// A room with one albedo under one light, as automatic_look sees it.
Look look_of_room(Vec3f paint, Vec3f light) {
    ImageColor seen(32, 16), albedo(32, 16);
    for (std::size_t i = 0; i < seen.size(); ++i) seen.pixels[i] = paint * light, albedo.pixels[i] = paint;
    return automatic_look({}, {}, seen, albedo);
}

TEST(Film, DarkRoomsStayDarkAndWhiteOnesWhite) {
    const Vec3f white{0.8f, 0.8f, 0.8f}, green{0.03f, 0.08f, 0.05f}, light{0.2f, 0.2f, 0.2f};
    const float bright = luminance(develop(look_of_room(white, light), white * light)),
                dark = luminance(develop(look_of_room(green, light), green * light));
    EXPECT_GT(bright, 0.3f) << "well above middle gray";
    EXPECT_LT(bright, 0.5f) << "white walls keep room for sun patches and lamps";
    EXPECT_LT(dark, 0.25f);
    EXPECT_GT(dark, 0.03f);
}

TEST(Film, TheLightIsBalancedNotThePaint) {
    const Vec3f gray{0.5f, 0.5f, 0.5f}, pink{0.75f, 0.35f, 0.45f}, lamp{1.f, 0.62f, 0.35f}, day{1, 1, 1},
        neon{1.f, 0.2f, 0.9f};
    const auto red_over_blue = [](Vec3f c) { return c.x / c.z; };
    // Lamplight is balanced most of the way, never beyond white; gray in a pink room stays gray; neon stays neon.
    const Vec3f by_lamp = develop(look_of_room(gray, lamp), gray * lamp * 0.2f);
    EXPECT_LT(red_over_blue(by_lamp), 0.75f * red_over_blue(develop({}, gray * lamp * 0.2f)));
    EXPECT_GT(red_over_blue(by_lamp), 1.f);
    EXPECT_NEAR(red_over_blue(develop(look_of_room(pink, day), gray * 0.2f)), 1.f, 0.02f);
    const Look by_neon = look_of_room(gray, neon);
    EXPECT_GT(red_over_blue(by_neon.white), 0.8f);
    EXPECT_LT(red_over_blue(by_neon.white), 1.25f);
    EXPECT_LT(by_neon.white.x / by_neon.white.y, 1.6f);
}

TEST(Film, LampsKeepTheirHue) {
    Look look;
    look.exposure_ev = 4;
    const Vec3f flame{13, 3, 0.3f}, seen = lamp_as_seen(look, flame);
    EXPECT_LT(luminance(seen), luminance(flame) / 10);
    EXPECT_NEAR(seen.x / seen.y, flame.x / flame.y, 1e-3f);
    EXPECT_GT(luminance(seen) * 16, 1.f) << "brighter than white paper";
    EXPECT_EQ(lamp_as_seen({}, {0.4f, 0.4f, 0.4f}), (Vec3f{0.4f, 0.4f, 0.4f}))
        << "what is no brighter than white is seen as it is";
}

// A sunny garden must not look like dusk because the room is bright; a dim room shows it unchanged, and so does a sky
// without that setting.
TEST(Film, TheOutsideOfABrightRoomIsNoDusk) {
    const Vec3f gray{0.5f, 0.5f, 0.5f};
    Sky sky;
    sky.ground = {0.8f, 0.8f, 0.7f}, sky.zenith = sky.horizon = {2, 2.2f, 2.5f}, sky.seen = 0.13f,
    sky.ground_least = 0.55f;
    const auto ground_in = [&](float light) {
        ImageColor seen(32, 16, gray * light), albedo(32, 16, gray);
        const Look look = automatic_look({}, sky, seen, albedo);
        EXPECT_GE(look.outside_seen, 1.f);
        return std::pair{luminance(outside_as_seen(sky, look, sky.ground)) * std::exp2(look.exposure_ev),
                         look.outside_seen};
    };
    EXPECT_EQ(ground_in(0.05f).second, 1.f);
    EXPECT_GT(ground_in(1.5f).second, 1.5f);
    EXPECT_LT(ground_in(0.6f).first, 1.2f);
    sky.ground_least = 0;
    EXPECT_EQ(ground_in(1.5f).second, 1.f);
}

// However long a dim room is exposed, the night outside stays night; a well-lit room shows it unchanged.
TEST(Film, TheNightOutsideADimRoomIsNoDay) {
    const Vec3f gray{0.5f, 0.5f, 0.5f};
    Sky sky;
    sky.time = Sky::Time::night, sky.zenith = {0.0007f, 0.001f, 0.0022f}, sky.horizon = {0.003f, 0.0032f, 0.0045f},
    sky.ground = {0.0008f, 0.0008f, 0.001f}, sky.seen = 1;
    const auto horizon_in = [&](float light) {
        const Look look = automatic_look({}, sky, ImageColor(32, 16, gray * light), ImageColor(32, 16, gray));
        return luminance(sky.horizon) * sky.seen * look.outside_seen * std::exp2(look.exposure_ev);
    };
    for (const float light : {0.003f, 0.01f, 0.05f, 0.3f}) EXPECT_LT(horizon_in(light), 0.1f) << light;
    const Look lit = automatic_look({}, sky, ImageColor(32, 16, gray * 0.3f), ImageColor(32, 16, gray));
    EXPECT_EQ(lit.outside_seen, 1.f);
    sky.time = Sky::Time::dusk, sky.horizon = {0.085f, 0.078f, 0.115f}, sky.seen = 0.22f;
    for (const float light : {0.003f, 0.01f, 0.05f, 0.3f}) EXPECT_LT(horizon_in(light), 0.3f) << light;
}

// The sun may outshine a dim room a hundredfold: its patches stay brighter than anything lit by the room, and keep
// their textures.
TEST(Film, SunPatchesStaySunAndKeepTheirColors) {
    const Vec3f gray{0.5f, 0.5f, 0.5f}, navy{0.03f, 0.05f, 0.14f}, concrete{0.32f, 0.32f, 0.33f},
        white{0.8f, 0.8f, 0.8f};
    Sky sky;
    sky.sun_irradiance = {10, 10, 10};
    const auto in_light_of = [&](float light, float limit) {
        sky.sun_limit = limit;
        const Vec3f lit{light, light, light};
        ImageColor seen(32, 16), albedo(32, 16);
        for (std::size_t i = 0; i < seen.size(); ++i) seen.pixels[i] = gray * lit, albedo.pixels[i] = gray;
        return automatic_look({}, sky, seen, albedo);
    };
    const auto in_sun = [&](const Look& look, float light, Vec3f paint) {
        const float all = light + look.sun_seen * 10 / kPi;
        return develop(look, paint * all);
    };
    constexpr float kLimit = 3.5f;
    float before = 0;
    for (const float light : {1.f, 0.1f, 0.02f}) {
        const Look look = in_light_of(light, kLimit);
        EXPECT_EQ(look.exposure_ev, in_light_of(light, 0).exposure_ev) << "the room is exposed as ever";
        const float level = look.sun_seen * std::exp2(look.exposure_ev);
        EXPECT_GT(level, before) << "the more the sun outshines the room, the brighter it is";
        before = level;
        EXPECT_GT(luminance(in_sun(look, light, white)), luminance(develop(look, white * light)));
        EXPECT_LT(luminance(in_sun(look, light, concrete)), luminance(in_sun(look, light, white)) - 0.04f)
            << "concrete in the sun is no white paper";
        const Vec3f blue = in_sun(look, light, navy);
        EXPECT_GT(blue.z, 1.8f * blue.x) << "navy stays navy";
    }
    EXPECT_EQ(in_light_of(1.f, kLimit).sun_seen, 1.f) << "a bright room's sun is seen as it is";
    EXPECT_EQ(in_light_of(0.02f, 0).sun_seen, 1.f);
    sky.sun_irradiance = {};
    EXPECT_EQ(in_light_of(0.02f, kLimit).sun_seen, 1.f) << "there is no sun to hold back";
}

TEST(Film, KeepsOrderAndRange) {
    Look look;
    look.contrast = 1.12f;
    float before = -1;
    for (float v = 0; v < 50; v = v * 1.3f + 0.001f) {
        const Vec3f c = develop(look, {v, v, v});
        EXPECT_GE(c.x, before - 1e-6f);
        EXPECT_LE(c.x, 1.f);
        EXPECT_NEAR(c.x, c.z, 1e-6f) << "gray stays gray";
        before = c.x;
    }
    EXPECT_GT(before, 0.9f);
}

}  // namespace
}  // namespace fastscene

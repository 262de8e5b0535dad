// Laws of the further maps: albedo times shading is the light, and flow leads to the same surface in the other picture.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "fastscene/dataset/dataset.h"
#include "fastscene/dataset/flow.h"
#include "fastscene/dataset/set.h"
#include "fastscene/image/color.h"
#include "fastscene/io/image_io.h"
#include "fastscene/trace/film.h"

namespace fastscene::dataset {
namespace {

namespace fs = std::filesystem;

// A set on disk, made once for all tests here.
class DatasetMaps : public testing::TestWithParam<const char*> {
  protected:
    static fs::path folder(const std::string& camera) {
        return fs::temp_directory_path() / fmt::format("fastscene-maps-{}-{}", ::getpid(), camera);
    }
    static void SetUpTestSuite() {
        for (const char* camera : {"panorama", "perspective"}) {
            DatasetRequest r{6, 160, camera == std::string("panorama") ? 80 : 120, {}};
            r.params.camera = camera;
            r.params.film = "clean";
            r.params.channels = "intrinsics,flow";
            r.params.views = 3;
            r.params.trace = {.cell_m = 0.25f, .cell_samples = 8, .pixel_samples = 4, .outside_detail = 0};
            fastscene::Run run;
            run.seed = 12;
            make_dataset(r, folder(camera), run);
        }
    }
    static void TearDownTestSuite() {
        for (const char* camera : {"panorama", "perspective"}) fs::remove_all(folder(camera));
    }
};
INSTANTIATE_TEST_SUITE_P(Cameras, DatasetMaps, testing::Values("panorama", "perspective"),
                         [](const auto& info) { return info.param; });

Look look_of(const SetPicture& picture) {
    const Json& look = picture.about.at("look");
    Look out;
    out.automatic = false;
    out.contrast = look.at("contrast");
    out.saturation = look.at("saturation");
    return out;  // light of intrinsics is exposed and balanced already
}

float shade_of(Vec3f v) { return std::log(std::max(1e-4f, luminance(v))); }

TEST_P(DatasetMaps, AlbedoTimesShadingIsThePicture) {
    const DataSet set(folder(GetParam()), true);
    for (const SetPicture& picture : set.pictures()) {
        const ImageRgb8 color = load_rgb8(set.file(picture, "color")), albedo = load_rgb8(set.file(picture, "albedo"));
        const ImageColor shading = load_light(set.file(picture, "shading"));
        const Look look = look_of(picture);
        std::vector<float> errors;
        for (std::size_t i = 0; i < color.size(); ++i) {
            const Rgb8 a = albedo.pixels[i];
            const Vec3f light = a == Rgb8{} ? shading.pixels[i] : linear_from_srgb8(a) * shading.pixels[i];
            const Vec3f expected = unit_from_linear(develop(look, light)), found = unit_from_srgb8(color.pixels[i]);
            for (std::size_t k = 0; k < 3; ++k) errors.push_back(std::abs(expected[k] - found[k]));
        }
        std::sort(errors.begin(), errors.end());
        EXPECT_LT(errors[errors.size() / 2], 0.006f) << picture.name;
        // Where a pixel sees two surfaces, the film's curve is applied before they are averaged.
        EXPECT_LT(errors[errors.size() * 9 / 10], 0.06f) << picture.name;
    }
}

// Patterns are in the albedo, light is in the shading: between neighbours on one plane with different albedo, the
// shading differs less than the light does.
TEST_P(DatasetMaps, ShadingDoesNotShowPatterns) {
    const DataSet set(folder(GetParam()), true);
    double light_steps = 0, shading_steps = 0;
    int count = 0;
    for (const SetPicture& picture : set.pictures()) {
        const ImageRgb8 albedo = load_rgb8(set.file(picture, "albedo")),
                        normal = load_rgb8(set.file(picture, "normal"));
        const ImageF instance = load_float(set.file(picture, "instance"), 1.f);
        const ImageColor shading = load_light(set.file(picture, "shading"));
        for (int y = 0; y < albedo.height; ++y)
            for (int x = 0; x + 1 < albedo.width; ++x) {
                const Rgb8 a = albedo.at(x, y), b = albedo.at(x + 1, y);
                if (a == Rgb8{} || b == Rgb8{} || normal.at(x, y) != normal.at(x + 1, y) ||
                    instance.at(x, y) != instance.at(x + 1, y))
                    continue;
                const Vec3f la = linear_from_srgb8(a), lb = linear_from_srgb8(b);
                if (std::abs(shade_of(la) - shade_of(lb)) < 0.2f) continue;
                const Vec3f sa = shading.at(x, y), sb = shading.at(x + 1, y);
                light_steps += std::abs(shade_of(la * sa) - shade_of(lb * sb));
                shading_steps += std::abs(shade_of(sa) - shade_of(sb));
                ++count;
            }
    }
    EXPECT_GT(count, 300);
    EXPECT_LT(shading_steps, 0.6 * light_steps);
}

struct SeenThere {
    int valid = 0, same_range = 0, hidden = 0, nearer = 0;
    double moved_error = 0, still_error = 0;
};

// The least and the greatest range of a pixel and the eight around it: floors far away are slanted by more than a
// pixel.
struct Nearby {
    float nearest = 1e9f, farthest = 0;
};
Nearby nearby(const ImageF& range, int px, int py) {
    Nearby out;
    for (int y = std::max(0, py - 1); y <= std::min(range.height - 1, py + 1); ++y)
        for (int x = px - 1; x <= px + 1; ++x) {
            const float r = range.at(wrap_column(x, range.width), y);
            if (r > 0) out = {std::min(out.nearest, r), std::max(out.farthest, r)};
        }
    return out;
}

void follow(const DataSet& set, const SetPicture& picture, SeenThere& seen) {
    const SetPicture& next = set.pictures()[picture.about.at("flow_to").get<std::size_t>()];
    ASSERT_EQ(next.room, picture.room);
    const FlowMap flow = decoded_flow(load_png16(set.file(picture, "flow")), set.settings().at("flow_unit_px"));
    const ImageF range = load_float(set.file(picture, "range"), 0.001f),
                 other = load_float(set.file(next, "range"), 0.001f);
    const ImageRgb8 color = load_rgb8(set.file(picture, "color")), there = load_rgb8(set.file(next, "color"));
    const Camera from = set.camera(picture), to = set.camera(next);
    const auto difference = [](Rgb8 a, Rgb8 b) {
        return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b);
    };
    for (int y = 0; y < range.height; ++y)
        for (int x = 0; x < range.width; ++x) {
            if (range.at(x, y) <= 0) {
                EXPECT_FALSE(flow.at(x, y).valid) << "the outside";
                continue;
            }
            const Vec3f point = from.world_from_camera * (from.ray(x, y) * range.at(x, y));
            const float far = length(point - to.world_from_camera.translation);
            const std::optional<Vec2f> expected = to.seen_at(point);
            const FlowPixel f = flow.at(x, y);
            if (!expected) {
                EXPECT_FALSE(f.valid) << "outside of the other picture";
                continue;
            }
            const int px = wrap_column(static_cast<int>(f.valid ? static_cast<float>(x) + 0.5f + f.u : expected->x),
                                       range.width),
                      py = std::clamp(static_cast<int>(f.valid ? static_cast<float>(y) + 0.5f + f.v : expected->y), 0,
                                      range.height - 1);
            const Nearby there_at = nearby(other, px, py);
            if (!f.valid) {
                ++seen.hidden;
                seen.nearer += there_at.nearest < far - 0.002f;
                continue;
            }
            ++seen.valid;
            seen.same_range += far > 0.99f * there_at.nearest && far < 1.01f * there_at.farthest;
            seen.moved_error += difference(color.at(x, y), there.at(px, py));
            seen.still_error += difference(color.at(x, y), there.at(x, y));
        }
}

TEST_P(DatasetMaps, FlowLeadsToTheSameSurface) {
    const DataSet set(folder(GetParam()), true);
    SeenThere seen;
    for (const SetPicture& picture : set.pictures()) follow(set, picture, seen);
    EXPECT_GT(seen.valid, 2000);
    EXPECT_GT(seen.same_range, 0.98 * seen.valid);
    EXPECT_LT(seen.moved_error, 0.6 * seen.still_error) << "warped, the pictures agree";
    EXPECT_GT(seen.hidden, 50);
    EXPECT_GT(seen.nearer, 0.9 * seen.hidden) << "something stands before what is hidden";
}

TEST(DatasetFlow, CountsComeBack) {
    EXPECT_EQ(flow_unit_px(1024, 512, true), 1.f / 64);
    EXPECT_EQ(flow_unit_px(512, 512, false), 1.f / 64);
    EXPECT_EQ(flow_unit_px(640, 480, false), 1.f / 32) << "a pixel may move by the picture's width";
    EXPECT_EQ(flow_unit_px(8192, 4096, true), 1.f / 8);
    FlowMap flow(3, 1);
    flow.pixels = {{-511.5f, 0.25f, true}, {7, 7, false}, {511.5f, -100.f, true}};
    const FlowMap found = decoded_flow(encoded_flow(flow, 1.f / 64), 1.f / 64);
    for (const std::size_t i : {0u, 2u}) {
        EXPECT_EQ(found.pixels[i].u, flow.pixels[i].u);
        EXPECT_EQ(found.pixels[i].v, flow.pixels[i].v);
    }
    EXPECT_FALSE(found.pixels[1].valid);
    EXPECT_TRUE(found.pixels[2].valid);
}

}  // namespace
}  // namespace fastscene::dataset

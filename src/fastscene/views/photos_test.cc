// Captures on disk become views: a textured wall must look the same through every lens model.
#include "fastscene/views/photos.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>
#include <variant>

#include "fastscene/base/error.h"
#include "fastscene/base/events.h"
#include "fastscene/base/file.h"
#include "fastscene/base/random.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/image/color.h"
#include "fastscene/io/capture_io.h"
#include "fastscene/io/image_io.h"
#include "fastscene/views/spacing.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

fs::path scratch(const std::string& name) {
    const fs::path dir = fs::path(::testing::TempDir()) / "fastscene_photos_test" / name;
    fs::remove_all(dir);
    fs::create_directories(dir);
    return dir;
}

// A smooth color for each direction, sRGB-encoded.
Rgb8 color_of(Vec3d d) {
    d = normalize(d);
    const auto wave = [](double v) { return static_cast<std::uint8_t>(std::lround(127.5 + 100 * std::sin(v))); };
    return {wave(3 * d.x + 1), wave(4 * d.y + d.z), wave(2 * d.z - 3 * d.x)};
}

// Simulates a lens pixel by pixel; directions are found by inverting it with Newton's method, independently of the
// tested code.
ImageRgb8 photograph(const Lens& lens) {
    ImageRgb8 out(lens.width, lens.height);
    const double reach = lens.reach();
    for (int y = 0; y < lens.height; ++y)
        for (int x = 0; x < lens.width; ++x) {
            const Vec2d wanted{x + 0.5, y + 0.5};
            Vec2d at{(wanted.x - lens.cx) / lens.fx, (wanted.y - lens.cy) / lens.fy};
            for (int n = 0; n < 60; ++n) {
                const auto found = lens.pixel_of({at.x, at.y, 1}, reach);
                if (!found) break;
                at = at - Vec2d{(found->x - wanted.x) / lens.fx, (found->y - wanted.y) / lens.fy} * 0.8;
            }
            out.at(x, y) = color_of({at.x, at.y, 1});
        }
    return out;
}

struct Model {
    std::string name, parameters;
};
const std::vector<Model> kModels{
    {"SIMPLE_PINHOLE", "80 48 36"},
    {"PINHOLE", "80 82 47 37"},
    {"SIMPLE_RADIAL", "80 48 36 -0.12"},
    {"RADIAL", "80 48 36 -0.1 0.02"},
    {"OPENCV", "80 81 48.5 35 -0.1 0.02 0.002 -0.003"},
    {"OPENCV_FISHEYE", "80 81 48 36 0.02 -0.01 0.002 0"},
    {"FULL_OPENCV", "80 81 48 36 -0.1 0.02 0.001 0.002 0.001 0.01 0 0"},
    {"FOV", "80 81 48 36 0.6"},
    {"SIMPLE_RADIAL_FISHEYE", "80 48 36 0.01"},
    {"RADIAL_FISHEYE", "80 48 36 0.01 0.005"},
    {"THIN_PRISM_FISHEYE", "80 81 48 36 0.02 -0.01 0.003 -0.002 0.004 -0.001 0.01 -0.02"},
    {"RAD_TAN_THIN_PRISM_FISHEYE",
     "80 81 48 36 0.02 -0.01 0.004 -0.001 0.0005 -0.0002 0.003 -0.002 0.01 -0.02 0.005 0.004"},
    {"SIMPLE_DIVISION", "80 48 36 -0.2"},
    {"DIVISION", "80 81 48 36 0.1"},
    {"SIMPLE_FISHEYE", "80 48 36"},
    {"FISHEYE", "80 81 48 36"},
    {"EUCM", "80 81 48 36 0.6 1.1"}};

void write_colmap(const fs::path& dir, const Model& model, int width, int height, const ImageRgb8& picture) {
    fs::create_directories(dir / "sparse" / "0");
    fs::create_directories(dir / "images" / "sub");
    write_file(dir / "sparse/0/cameras.txt",
               fmt::format("# comment\n7 {} {} {} {}\n", model.name, width, height, model.parameters));
    write_file(dir / "sparse/0/images.txt",
               fmt::format("# comment\n3 0.70710678 0 0.70710678 0 1 2 3 7 sub/a b.png\n10.5 11.5 -1 3.5 2 4\n"));
    write_file(dir / "sparse/0/points3D.txt",
               std::string_view("# comment\n1 1 2 3 10 20 30 0.5 3 0\n2 1.1 2 3 10 20 30 0.5\n3 1 2.2 3 10 20 30 "
                                "0.5\n4 1 2 3.3 40 50 60 0.5 3 1 3 2\n"));
    save_png(dir / "images/sub/a b.png", picture);
}

// Maximum, over the channels, of the mean difference over the weighted pixels.
double difference_to_truth(const View& view) {
    double sum = 0, count = 0;
    for (int y = 0; y < view.camera.height; ++y)
        for (int x = 0; x < view.camera.width; ++x) {
            if (!view.weight.empty() && view.weight.at(x, y) < 255) continue;
            const Vec3f d = view.camera.direction_at({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
            const Rgb8 a = view.color.at(x, y), b = color_of({d.x, d.y, d.z});
            sum += std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b);
            count += 3;
        }
    return count > 0 ? sum / count : 1e9;
}

TEST(Photos, EveryLensIsStraightened) {
    for (const Model& model : kModels) {
        const fs::path dir = scratch("lens");
        write_colmap(dir, model, 96, 72, ImageRgb8(96, 72));
        Capture capture = load_colmap_capture(dir, {});
        ASSERT_EQ(capture.photos.size(), 1u);
        save_png(dir / "images/sub/a b.png", photograph(capture.photos[0].lens));
        const PhotoViews views = views_of_capture(capture, {}, fastscene::Run{});
        ASSERT_EQ(views.set.views.size(), 1u);
        const View& view = views.set.views[0];
        EXPECT_EQ(view.camera.width, 96);
        EXPECT_LT(difference_to_truth(view), 1.0) << model.name;
        if (!view.weight.empty()) {
            EXPECT_EQ(view.weight.at(48, 36), 255) << model.name;
        }
        EXPECT_EQ(views.set.points.size(), 4u);
        EXPECT_EQ(views.set.points[3].color, (Rgb8{40, 50, 60}));
    }
}

// Projection of the ray (0.3, -0.2, 1), computed from COLMAP's formulas independently of this program.
TEST(Photos, LensesAreColmaps) {
    const std::map<std::string, Vec2d> expected{{"OPENCV", {72.102512, 19.0683043}},
                                                {"FOV", {72.348280688, 19.564910536}},
                                                {"THIN_PRISM_FISHEYE", {71.109874117, 20.287672659}},
                                                {"RAD_TAN_THIN_PRISM_FISHEYE", {71.245982377, 20.411696813}},
                                                {"SIMPLE_DIVISION", {71.406481350, 20.395679100}},
                                                {"SIMPLE_FISHEYE", {71.034276056, 20.643815963}},
                                                {"FISHEYE", {71.034276056, 20.451863662}},
                                                {"EUCM", {71.044415638, 20.445019445}}};
    for (const Model& model : kModels) {
        if (!expected.contains(model.name)) continue;
        std::vector<double> parameters;
        std::istringstream words(model.parameters);
        for (double v = 0; words >> v;) parameters.push_back(v);
        const Lens lens = lens_of(*lens_model(model.name), 96, 72, parameters);
        const auto at = lens.pixel_of({0.3, -0.2, 1}, lens.reach());
        ASSERT_TRUE(at.has_value()) << model.name;
        EXPECT_NEAR(at->x, expected.at(model.name).x, 1e-6) << model.name;
        EXPECT_NEAR(at->y, expected.at(model.name).y, 1e-6) << model.name;
    }
    for (int id = 0; id <= 17; ++id) EXPECT_TRUE(lens_model(id).has_value()) << id;
    EXPECT_FALSE(lens_model(18).has_value());
}

TEST(Photos, UnknownLensesAreRefusedByName) {
    const fs::path dir = scratch("unknown");
    for (const auto& [model, named] :
         {std::pair{Model{"PLUMB_BOB", "80 48 36"}, "PLUMB_BOB"}, std::pair{Model{"EUCM", "80 81 48 36 1.5 1"}, "EUCM"},
          std::pair{Model{"EUCM", "80 81 48 36 0.5 -1"}, "EUCM"}}) {
        write_colmap(dir, model, 96, 72, ImageRgb8(96, 72));
        try {
            load_colmap_capture(dir, {});
            FAIL() << named;
        } catch (const Error& e) {
            EXPECT_NE(std::string(e.what()).find(named), std::string::npos) << e.what();
        }
    }
}

struct Warnings : EventSink {
    void tell(const Event& event) override {
        if (const auto* warning = std::get_if<WarningEvent>(&event)) text += warning->text + "\n";
    }
    std::string text;
};

Capture capture_of(const fs::path& dir, int count) {
    Capture capture;
    capture.source = dir.string();
    for (int i = 0; i < count; ++i) {
        Photo photo;
        photo.name = fmt::format("p{}.png", i);
        photo.file = dir / photo.name;
        photo.lens = lens_of(*lens_model("SIMPLE_PINHOLE"), 16, 16, {16, 8, 8});
        photo.world_from_camera.translation = {0.1 * i, 0, 0};
        save_png(photo.file, ImageRgb8(16, 16, {1, 2, 3}));
        capture.photos.push_back(photo);
    }
    for (int i = 0; i < 20; ++i) capture.points.push_back({{0.1 * i, 0.2, 2}, {}});
    return capture;
}

TEST(Photos, DamagedPicturesAreLeftOutAndNamed) {
    const fs::path dir = scratch("damaged");
    Capture capture = capture_of(dir, 5);
    const std::string whole = read_file(dir / "p0.png");
    write_file(dir / "p1.png", whole.substr(0, whole.size() / 2));
    save_png(dir / "p3.png", ImageRgb8(32, 16));  // aspect ratio differs from its camera's
    Warnings warnings;
    fastscene::Run run;
    run.events = &warnings;
    const PhotoViews views = views_of_capture(capture, {}, run);
    ASSERT_EQ(views.set.views.size(), 3u);
    EXPECT_EQ(views.set.views[1].name, "p2.png");
    EXPECT_NEAR(views.set.views[2].world_from_camera.translation.x - views.set.views[0].world_from_camera.translation.x,
                0.4f, 1e-4f);
    EXPECT_NE(warnings.text.find("2 of 5"), std::string::npos) << warnings.text;
    for (const char* name : {"p1.png", "p3.png"})
        EXPECT_NE(warnings.text.find((dir / name).string()), std::string::npos) << warnings.text;
    write_file(dir / "p4.png", std::string_view("no picture"));
    try {
        views_of_capture(capture, {}, run);
        FAIL();
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find("3 of 5"), std::string::npos) << e.what();
        EXPECT_NE(std::string(e.what()).find("p4.png"), std::string::npos) << e.what();
    }
    capture.photos[0].mask = dir / "p4.png";  // a damaged mask makes its picture unusable
    capture.photos.resize(3);
    EXPECT_THROW(views_of_capture(capture, {}, run), Error);
    capture.photos.push_back(capture.photos[2]);
    EXPECT_EQ(views_of_capture(capture, {}, run).set.views.size(), 2u);
}

// A mask may be smaller than its picture but must have the same aspect ratio; stretched, it would hide the wrong
// places. If only some pictures have masks, that is reported.
TEST(Photos, MasksHaveTheShapeOfTheirPictures) {
    const fs::path dir = scratch("mask_shape");
    Capture capture = capture_of(dir, 5);
    for (std::size_t i : {1u, 2u, 3u}) capture.photos[i].mask = dir / fmt::format("m{}.png", i);
    ImageMask half(8, 8, 255);
    half.at(0, 0) = 0;
    save_png(dir / "m1.png", half);
    save_png(dir / "m2.png", ImageMask(16, 8, 255));
    save_png(dir / "m3.png", ImageMask(16, 16, 255));
    Warnings warnings;
    fastscene::Run run;
    run.events = &warnings;
    const PhotoViews views = views_of_capture(capture, {}, run);
    ASSERT_EQ(views.set.views.size(), 4u);
    EXPECT_EQ(views.set.views[1].weight.at(1, 1), 0);
    EXPECT_EQ(views.set.views[1].weight.at(2, 1), 255);
    EXPECT_EQ(views.set.views[2].name, "p3.png");
    EXPECT_NE(
        warnings.text.find((dir / "m2.png").string() + ": expected the shape of its picture, 16 x 16, found 16 x 8"),
        std::string::npos)
        << warnings.text;
    EXPECT_NE(warnings.text.find("2 of 5 pictures have no mask and count whole, p0.png first"), std::string::npos)
        << warnings.text;
    for (std::size_t i = 0; i < 5; ++i) capture.photos[i].mask = dir / "m1.png";
    warnings.text.clear();
    views_of_capture(capture, {}, run);
    for (Photo& photo : capture.photos) photo.mask.clear();
    views_of_capture(capture, {}, run);
    EXPECT_EQ(warnings.text, "");
}

TEST(Photos, MemoryIsKnownBeforeTheyAreRead) {
    const fs::path dir = scratch("memory");
    Capture capture = capture_of(dir, 3);
    EXPECT_EQ(memory_of_photos(capture, {}, false).views, 3 * 16 * 16 * 3);
    capture.photos[1].mask = dir / "m.png";
    EXPECT_EQ(memory_of_photos(capture, {}, false).views, 16 * 16 * (3 + 4 + 3));
    for (Photo& photo : capture.photos) photo.lens = photo.lens.resized(4000, 4000);  // pictures are downsampled copies
    EXPECT_EQ(memory_of_photos(capture, {}, true).views, 16 * 16 * (3 + 4 + 3));
    PhotosParams params;
    params.max_size = 1000;
    EXPECT_EQ(memory_of_photos(capture, params, false).views, 1000 * 1000 * (3 + 4 + 3));
    params.downscale = 8;
    EXPECT_EQ(memory_of_photos(capture, params, false).views, 500 * 500 * (3 + 4 + 3));
    EXPECT_GE(memory_of_photos(capture, params, false).reading, std::int64_t{4000} * 4000 * 3);
    capture.photos[0].file = dir / "absent.png";
    EXPECT_EQ(memory_of_photos(capture, params, false).views, 500 * 500 * (4 + 3));
}

TEST(Photos, ColmapPosesAreWorldToCamera) {
    const fs::path dir = scratch("pose");
    write_colmap(dir, kModels[1], 96, 72, ImageRgb8(96, 72));
    const Rigidd pose = load_colmap_capture(dir, {}).photos[0].world_from_camera;
    // A quarter turn about y: camera x is world -z; t = (1, 2, 3) is the world's origin in camera coordinates.
    const Vec3d back = inverse(pose) * Vec3d{0, 0, 0};
    EXPECT_NEAR(back.x, 1, 1e-6);
    EXPECT_NEAR(back.z, 3, 1e-6);
    EXPECT_NEAR(length(pose.rotation * Vec3d{0, 0, 1} - Vec3d{-1, 0, 0}), 0, 1e-6);
}

TEST(Photos, OtherSizesScaleTheCamera) {
    const fs::path dir = scratch("size");
    write_colmap(dir, kModels[1], 96, 72, ImageRgb8(48, 36, {1, 2, 3}));
    const View small = views_of_capture(load_colmap_capture(dir, {}), {}, fastscene::Run{}).set.views[0];
    EXPECT_EQ(small.camera.width, 48);
    EXPECT_FLOAT_EQ(small.camera.fx, 40);
    EXPECT_FLOAT_EQ(small.camera.cy, 18.5);
    save_png(dir / "images/sub/a b.png", ImageRgb8(96, 72, {1, 2, 3}));
    PhotosParams params;
    params.max_size = 24;
    const View smaller = views_of_capture(load_colmap_capture(dir, {}), params, fastscene::Run{}).set.views[0];
    EXPECT_EQ(smaller.camera.width, 24);
    EXPECT_FLOAT_EQ(smaller.camera.fx, 20);
    EXPECT_EQ(smaller.color.at(3, 3), (Rgb8{1, 2, 3}));
    params = {};
    params.downscale = 4;
    fs::create_directories(dir / "images_4/sub");
    save_png(dir / "images_4/sub/a b.png", ImageRgb8(24, 18, {9, 9, 9}));
    CaptureFolders folders;
    folders.downscale = 4;
    EXPECT_EQ(views_of_capture(load_colmap_capture(dir, folders), params, fastscene::Run{}).set.views[0].color.at(0, 0),
              (Rgb8{9, 9, 9}));
    save_png(dir / "images/sub/a b.png", ImageRgb8(72, 96));
    EXPECT_THROW(views_of_capture(load_colmap_capture(dir, {}), {}, fastscene::Run{}), Error);
}

TEST(Photos, MasksAndMissingPictures) {
    const fs::path dir = scratch("mask");
    write_colmap(dir, kModels[1], 96, 72, ImageRgb8(96, 72, {1, 2, 3}));
    ImageMask mask(96, 72, 255);
    mask.at(5, 6) = 0;
    fs::create_directories(dir / "masks/sub");
    save_png(dir / "masks/sub/a b.png.png", mask);
    EXPECT_EQ(views_of_capture(load_colmap_capture(dir, {}), {}, fastscene::Run{}).set.views[0].weight.at(5, 6), 0);
    PhotosParams params;
    params.invert_masks = true;
    EXPECT_EQ(views_of_capture(load_colmap_capture(dir, {}), params, fastscene::Run{}).set.views[0].weight.at(5, 6),
              255);
    fs::remove(dir / "images/sub/a b.png");
    EXPECT_THROW(views_of_capture(load_colmap_capture(dir, {}), {}, fastscene::Run{}), Error);
}

TEST(Photos, ScenesFarOffAndWithStrayCamerasComeClose) {
    Capture capture;
    const fs::path dir = scratch("far");
    save_png(dir / "p.png", ImageRgb8(8, 8, {1, 2, 3}));
    Random random(1, "far");
    for (int i = 0; i < 11; ++i) {
        Photo photo;
        photo.name = photo.file = dir / "p.png";
        photo.lens = lens_of(*lens_model("SIMPLE_PINHOLE"), 8, 8, {8, 4, 4});
        photo.world_from_camera.translation = Vec3d{500000, 200000, -40} +
                                              Vec3d{random.normal(), random.normal(), random.normal()} * 50;
        if (i == 10) photo.world_from_camera.translation = {-1e9, 0, 0};
        capture.photos.push_back(photo);
    }
    for (int i = 0; i < 500; ++i)
        capture.points.push_back(
            {Vec3d{500000, 200000, -40} + Vec3d{random.normal(), random.normal(), random.normal()} * 100, {}});
    const PhotoViews views = views_of_capture(capture, {}, fastscene::Run{});
    int near = 0;
    for (const SurfacePoint& p : views.set.points) near += length(p.position_m) < 10;
    EXPECT_GT(near, 480);
    const Similarity back = inverse(views.world_from_capture);
    EXPECT_NEAR(back.translation.x, 500000, 200);
    for (const SurfacePoint& p : views.set.points) EXPECT_TRUE(p.radius_m > 0 && p.radius_m < 5);
}

TEST(Photos, OneCameraWithoutPoints) {
    const fs::path dir = scratch("one");
    write_colmap(dir, kModels[1], 96, 72, ImageRgb8(96, 72, {1, 2, 3}));
    fs::remove(dir / "sparse/0/points3D.txt");
    PhotosParams params;
    params.random_points = 300;
    const PhotoViews views = views_of_capture(load_colmap_capture(dir, {}), params, fastscene::Run{});
    ASSERT_EQ(views.set.points.size(), 300u);
    for (const SurfacePoint& p : views.set.points) {
        EXPECT_TRUE((inverse(views.set.views[0].world_from_camera) * p.position_m).z > 0);
        EXPECT_GT(p.radius_m, 0);
    }
}

TEST(Photos, NerfstudioCamerasLookAlongMinusZ) {
    const fs::path dir = scratch("nerf");
    save_png(dir / "r_0.png", ImageRgb8(40, 30, {1, 2, 3}));
    write_file(dir / "transforms.json",
               std::string_view(R"({"camera_angle_x": 1.5707963, "frames": [{"file_path": "./r_0",
        "transform_matrix": [[1,0,0,5],[0,1,0,6],[0,0,1,7],[0,0,0,1]]}]})"));
    const Capture capture = load_nerfstudio_capture(dir, {});
    ASSERT_EQ(capture.photos.size(), 1u);
    EXPECT_NEAR(capture.photos[0].lens.fx, 20, 1e-4);
    const Rigidd pose = capture.photos[0].world_from_camera;
    EXPECT_NEAR(length(pose.rotation * Vec3d{0, 0, 1} - Vec3d{0, 0, -1}), 0, 1e-9);  // forward
    EXPECT_NEAR(length(pose.rotation * Vec3d{0, 1, 0} - Vec3d{0, -1, 0}), 0, 1e-9);  // down
    EXPECT_NEAR(length(pose.translation - Vec3d{5, 6, 7}), 0, 1e-9);
    // Its up direction is +y, which the viewer must know.
    EXPECT_GT(views_of_capture(capture, {}, fastscene::Run{}).up.y, 0.99f);
}

// The trainer supports equirectangular pictures: they stay whole, with their masks, and are downsampled on request.
TEST(Photos, SpheresStayWhole) {
    const fs::path dir = scratch("sphere");
    ImageRgb8 sphere(128, 64);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 128; ++x) {
            const Vec3f d = direction_of_pixel(x, y, {128, 64});
            sphere.at(x, y) = color_of({d.x, d.y, d.z});
        }
    save_png(dir / "s.png", sphere);
    ImageMask mask(128, 64, 255);
    for (int x = 0; x < 128; ++x) mask.at(x, 63) = mask.at(x, 62) = 0;  // the tripod
    fs::create_directories(dir / "masks");
    save_png(dir / "masks/s.png", mask);
    write_file(
        dir / "transforms.json",
        std::string_view(R"({"camera_model": "EQUIRECTANGULAR", "w": 128, "h": 64, "frames": [{"file_path": "s.png",
        "transform_matrix": [[1,0,0,1],[0,-1,0,2],[0,0,-1,3],[0,0,0,1]]}]})"));
    const View whole = views_of_capture(load_nerfstudio_capture(dir, {}), {}, fastscene::Run{}).set.views.at(0);
    EXPECT_EQ(whole.model, CameraModel::equirectangular);
    EXPECT_EQ(whole.color.pixels, sphere.pixels);
    EXPECT_EQ(whole.weight.pixels, mask.pixels);
    EXPECT_EQ(whole.camera.width, 128);
    PhotosParams params;
    params.max_size = 32;  // equirectangular pictures may be twice as wide
    const PhotoViews smaller = views_of_capture(load_nerfstudio_capture(dir, {}), params, fastscene::Run{});
    const View& small = smaller.set.views.at(0);
    ASSERT_EQ(small.color.width, 64);
    ASSERT_EQ(small.color.height, 32);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x) {
            const Vec3f d = direction_of_pixel(x, y, {64, 32});
            EXPECT_NEAR(small.color.at(x, y).g, color_of({d.x, d.y, d.z}).g, 4);
        }
    EXPECT_EQ(small.weight.at(5, 31), 0);
    EXPECT_EQ(small.weight.at(5, 30), 255);
    // Generated points take the color that the views show there.
    for (const SurfacePoint& p : smaller.set.points) {
        const Vec3f d = inverse(small.world_from_camera) * p.position_m;
        EXPECT_NEAR(p.color.g, color_of({d.x, d.y, d.z}).g, 30);
    }
}

TEST(Photos, MasksOfAnyKindAndMasksOfNothing) {
    const fs::path dir = scratch("masks");
    write_colmap(dir, kModels[1], 96, 72, ImageRgb8(96, 72, {1, 2, 3}));
    fs::create_directories(dir / "masks/sub");
    ImageRgb8 jpeg(96, 72, {255, 255, 255});
    for (int y = 0; y < 72; ++y)
        for (int x = 0; x < 48; ++x) jpeg.at(x, y) = {0, 0, 0};
    for (const char* name : {"a b.jpg", "a b.png.jpg"}) {
        save_jpeg(dir / "masks/sub" / name, jpeg);
        const ImageMask weight =
            views_of_capture(load_colmap_capture(dir, {}), {}, fastscene::Run{}).set.views[0].weight;
        ASSERT_FALSE(weight.empty()) << name;
        EXPECT_LT(weight.at(5, 6), 5);
        EXPECT_GT(weight.at(80, 6), 250);
        fs::remove(dir / "masks/sub" / name);
    }
    save_png(dir / "masks/sub/a b.png", ImageMask(96, 72, 0));
    EXPECT_THROW(views_of_capture(load_colmap_capture(dir, {}), {}, fastscene::Run{}), Error);
    PhotosParams params;
    params.invert_masks = true;
    EXPECT_EQ(views_of_capture(load_colmap_capture(dir, {}), params, fastscene::Run{}).set.views.size(), 1u);
}

TEST(Photos, AModelWithoutLinesOfPointsIsRefusedNotHalved) {
    const fs::path dir = scratch("lines");
    write_colmap(dir, kModels[1], 96, 72, ImageRgb8(96, 72));
    const auto images = [&](std::string_view text) {
        write_file(dir / "sparse/0/images.txt", text);
        return load_colmap_capture(dir, {}).photos.size();
    };
    EXPECT_EQ(images("1 1 0 0 0 0 0 0 7 a.png\n\n2 1 0 0 0 0 0 0 7 b.png\n1 2 -1 3.5 4e1 7\n"), 2u);
    EXPECT_THROW(images("1 1 0 0 0 0 0 0 7 a.png\n2 1 0 0 0 0 0 0 7 b.png\n"), Error);
    EXPECT_THROW(images("1 1 0 0 0 0 0 0 7 a.png\n1 2 -1 5\n"), Error);
    write_file(dir / "sparse/0/cameras.txt", std::string_view("7 EQUIRECTANGULAR 128 64\n"));
    EXPECT_EQ(images("1 1 0 0 0 0 0 0 7 a.png\n\n"), 1u);
}

TEST(Photos, CamerasJsonComesBack) {
    const fs::path dir = scratch("cameras");
    write_colmap(dir, kModels[1], 96, 72, ImageRgb8(96, 72));
    std::vector<Photo> photos = load_colmap_capture(dir, {}).photos;
    photos.push_back(photos[0]);
    photos[1].lens.kind = LensKind::equirectangular;
    save_cameras_json(dir / "cameras.json", photos);
    const Capture back = load_cameras_json(dir / "cameras.json");
    ASSERT_EQ(back.photos.size(), 2u);
    EXPECT_EQ(back.photos[0].name, photos[0].name);
    EXPECT_EQ(back.photos[0].lens.fy, photos[0].lens.fy);
    EXPECT_EQ(back.photos[1].lens.kind, LensKind::equirectangular);
    EXPECT_NEAR(length(back.photos[0].world_from_camera.translation - photos[0].world_from_camera.translation), 0,
                1e-12);
    EXPECT_NEAR(length(back.photos[0].world_from_camera.rotation.row1 - photos[0].world_from_camera.rotation.row1), 0,
                1e-12);
    for (const char* bad : {"{}", "[1]", "[{\"img_name\": \"a\"}]",
                            R"([{"img_name":"a","width":2,"height":2,"fx":1,"fy":1,)"
                            R"("position":[0,0,0],"rotation":[[1,0,0],[0,1,0],[0,0,5]]}])",
                            R"([{"img_name":"a","width":1e30,"height":2,"fx":1,"fy":1,)"
                            R"("position":[0,0,0],"rotation":[[1,0,0],[0,1,0],[0,0,1]]}])"}) {
        write_file(dir / "cameras.json", std::string_view(bad));
        EXPECT_THROW(load_cameras_json(dir / "cameras.json"), Error) << bad;
    }
}

TEST(Photos, NerfstudioKnowsColmapsRadialLenses) {
    const fs::path dir = scratch("radial");
    for (const char* model : {"SIMPLE_RADIAL", "RADIAL"}) {
        write_file(
            dir / "transforms.json",
            fmt::format(
                R"({{"camera_model": "{}", "w": 40, "h": 30, "fl_x": 20, "k1": -0.1, "ply_file_path": "absent.ply",
                     "frames":
            [{{"file_path": "a.png", "transform_matrix": [[1,0,0,5],[0,1,0,6],[0,0,1,7],[0,0,0,1]]}}]}})",
                model));
        const Capture capture = load_nerfstudio_capture(dir, {});
        EXPECT_EQ(capture.photos.at(0).lens.k[0], -0.1);
        EXPECT_EQ(capture.missing_points, dir / "absent.ply");
    }
}

constexpr const char* kSomewhere = R"("transform_matrix": [[1,0,0,5],[0,1,0,6],[0,0,1,7],[0,0,0,1]])";

// Rigs of several cameras use the same file names, one folder per camera.
TEST(Photos, PicturesOfARigAreFoundByTheirFolders) {
    const fs::path dir = scratch("rig");
    std::string frames;
    for (const char* name : {"images/cam0/1.png", "images/cam1/1.png"}) {
        frames += fmt::format("{}{{\"file_path\": \"{}\", {}}}", frames.empty() ? "" : ",", name, kSomewhere);
        for (const std::string place : {"images", "images_2", "masks"}) {
            const fs::path file = dir / (place + fs::path(name).string().substr(6));
            fs::create_directories(file.parent_path());
            save_png(file, ImageRgb8(4, 2, {1, 2, 3}));
        }
    }
    write_file(dir / "transforms.json", fmt::format(R"({{"fl_x": 4, "w": 4, "h": 2, "frames": [{}]}})", frames));
    const auto files = [&](const CaptureFolders& folders) {
        std::vector<fs::path> out;
        for (const Photo& photo : load_nerfstudio_capture(dir, folders).photos) out.push_back(photo.file);
        return out;
    };
    const fs::path images = dir / "images", smaller = dir / "images_2";
    EXPECT_EQ(files({}), (std::vector<fs::path>{images / "cam0/1.png", images / "cam1/1.png"}));
    EXPECT_EQ(files({images, {}, 1}), (std::vector<fs::path>{images / "cam0/1.png", images / "cam1/1.png"}));
    EXPECT_EQ(files({{}, {}, 2}), (std::vector<fs::path>{smaller / "cam0/1.png", smaller / "cam1/1.png"}));
    for (const Photo& photo : load_nerfstudio_capture(dir, {}).photos)
        EXPECT_EQ(photo.mask, dir / "masks" / fs::path(photo.name).lexically_relative("images"));
    // A flat folder with one picture: ambiguous between both cameras.
    EXPECT_THROW(files({images / "cam0", {}, 1}), Error);
    // If neither camera has a picture at a position, it is skipped.
    fs::remove(images / "cam0/1.png"), fs::remove(images / "cam1/1.png");
    EXPECT_NO_THROW(files({images, {}, 1}));
}

TEST(Photos, InstantNgpsWordsForLenses) {
    const fs::path dir = scratch("ngp");
    const auto lens = [&](const std::string& words) {
        write_file(
            dir / "transforms.json",
            fmt::format(R"({{"w": 40, "h": 20, {}, "frames": [{{"file_path": "a.png", {}}}]}})", words, kSomewhere));
        return load_nerfstudio_capture(dir, {}).photos.at(0).lens;
    };
    EXPECT_EQ(lens(R"("fl_x": 20, "k1": 0.1, "k2": 0, "k3": 0, "k4": 0.01, "is_fisheye": true)").kind,
              LensKind::fisheye);
    EXPECT_EQ(lens(R"("fl_x": 20, "k1": 0.1, "k2": 0, "k3": 0, "k4": 0, "is_fisheye": false)").kind,
              LensKind::perspective);
    EXPECT_EQ(lens(R"("latlong": true)").kind, LensKind::equirectangular);
    EXPECT_NEAR(lens(R"("x_fov": 90, "y_fov": 53.13010235)").fx, 20, 1e-9);
    EXPECT_NEAR(lens(R"("x_fov": 90, "y_fov": 53.13010235)").fy, 20, 1e-7);
    // Unsupported camera models are refused: a fourth coefficient for a model with three, unknown model names.
    for (const char* odd :
         {R"("fl_x": 20, "k4": 0.01)", R"("fl_x": 20, "ftheta_p0": 1)", R"("fl_x": 20, "orthographic": true)",
          R"("fl_x": 20, "camera_model": 3)", R"("fl_x": 20, "camera_model": "FISHEYE624")"})
        EXPECT_THROW(lens(odd), Error) << odd;
}

// NeRF's synthetic sets do not record picture sizes; a missing or damaged picture must not invalidate the others.
TEST(Photos, SizesOfMissingPicturesAreThoseOfTheOthers) {
    const fs::path dir = scratch("sizeless");
    std::string frames;
    for (int i = 0; i < 5; ++i) {
        frames += fmt::format("{}{{\"file_path\": \"./train/r_{}\", {}}}", i ? "," : "", i, kSomewhere);
        fs::create_directories(dir / "train");
        if (i > 0) save_png(dir / fmt::format("train/r_{}.png", i), ImageRgb8(40, 30, {1, 2, 3}));
    }
    write_file(dir / "train/r_3.png", std::string_view("no picture"));
    write_file(dir / "transforms_train.json",
               fmt::format(R"({{"camera_angle_x": 1.5707963, "frames": [{}]}})", frames));
    const Capture capture = load_nerfstudio_capture(dir, {});
    ASSERT_EQ(capture.photos.size(), 5u);
    for (const Photo& photo : capture.photos) EXPECT_NEAR(photo.lens.fx, 20, 1e-4);
    EXPECT_EQ(views_of_capture(capture, {}, fastscene::Run{}).set.views.size(), 3u);
    fs::remove_all(dir / "train");
    EXPECT_THROW(load_nerfstudio_capture(dir, {}), Error);
}

TEST(Photos, TheLargestModelOfCOLMAPIsTaken) {
    const fs::path dir = scratch("models");
    write_colmap(dir, kModels[1], 96, 72, ImageRgb8(96, 72));
    EXPECT_TRUE(load_colmap_capture(dir, {}).warnings.empty());
    fs::copy(dir / "sparse/0", dir / "sparse/1");
    EXPECT_TRUE(load_colmap_capture(dir, {}).warnings.empty());
    write_file(dir / "sparse/1/images.txt", std::string_view("1 1 0 0 0 0 0 0 7 a.png\n\n2 1 0 0 0 0 0 0 7 b.png\n\n"));
    const Capture capture = load_colmap_capture(dir, {});
    EXPECT_EQ(capture.photos.size(), 2u);
    ASSERT_EQ(capture.warnings.size(), 1u);
    EXPECT_EQ(capture.warnings[0].find((dir / "sparse/1").string() + " of 2 models is used"), 0u)
        << capture.warnings[0];
    EXPECT_EQ(load_colmap_capture(dir / "sparse/0", {dir / "images", {}, 1, {}}).photos.size(), 1u);  // asked for
    write_file(dir / "sparse/1/images.txt", std::string_view("damaged"));
    EXPECT_TRUE(load_colmap_capture(dir, {}).warnings.empty());
}

TEST(Spacing, IsThatOfTheNearestThree) {
    Random random(5, "spacing");
    std::vector<Vec3f> points;
    for (int i = 0; i < 400; ++i) points.push_back({random.normal(), random.normal(), random.normal()});
    points.push_back(points[7]);
    const std::vector<float> found = spacings(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        std::vector<float> squares;
        for (std::size_t k = 0; k < points.size(); ++k)
            if (k != i) squares.push_back(dot(points[k] - points[i], points[k] - points[i]));
        std::sort(squares.begin(), squares.end());
        EXPECT_NEAR(found[i], std::sqrt((squares[0] + squares[1] + squares[2]) / 3), 1e-5);
    }
    EXPECT_EQ(spacings({{1, 2, 3}})[0], 0.f);
    EXPECT_TRUE(spacings({}).empty());
}

}  // namespace
}  // namespace fastscene

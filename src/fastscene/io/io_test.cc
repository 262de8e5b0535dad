#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limits>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/random.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/ply.h"
#include "fastscene/io/splat_io.h"
#include "fastscene/io/test_scratch.h"
#include "fastscene/io/test_splats.h"
#include "fastscene/io/view_io.h"
#include "fastscene/io/viewer.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

ImageRgb8 noise(int width, int height) {
    Random random(1, "noise");
    ImageRgb8 image(width, height);
    for (Rgb8& p : image.pixels)
        p = {static_cast<std::uint8_t>(random.index(256)), static_cast<std::uint8_t>(random.index(256)),
             static_cast<std::uint8_t>(random.index(256))};
    return image;
}
// Smooth, so that JPEG preserves it.
ImageRgb8 ramp(int width, int height) {
    ImageRgb8 image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.at(x, y) = {static_cast<std::uint8_t>(255 * x / width), static_cast<std::uint8_t>(255 * y / height),
                              90};
    return image;
}
TEST(Png, RoundTripsAreExactAndDeterministic) {
    for (const auto& [w, h] : {std::pair{1, 1}, std::pair{17, 5}, std::pair{64, 32}}) {
        const ImageRgb8 image = noise(w, h);
        save_png(scratch("a.png"), image);
        save_png(scratch("b.png"), image);
        EXPECT_EQ(load_rgb8(scratch("a.png")), image);
        EXPECT_EQ(read_file(scratch("a.png")), read_file(scratch("b.png")));
        EXPECT_EQ(picture_info(scratch("a.png")).width, w);
    }
    ImageMask mask(5, 3, 7);
    save_png(scratch("m.png"), mask);
    EXPECT_EQ(load_mask_png(scratch("m.png")), mask);
    EXPECT_EQ(load_rgb8(scratch("m.png")).at(2, 2), (Rgb8{7, 7, 7}));
    Image<std::uint16_t> deep(3, 2, 40000);
    save_png16(scratch("d.png"), deep);
    EXPECT_FLOAT_EQ(load_float(scratch("d.png"), 0.001f).at(1, 1), 40.f);
    EXPECT_EQ(load_rgb8(scratch("d.png")).at(0, 0).r, 156);  // 40000 / 65535 in 8 bits
}

TEST(Jpeg, RoundTripIsNear) {
    const ImageRgb8 image = ramp(64, 48);
    save_jpeg(scratch("a.jpg"), image);
    const ImageRgb8 back = load_rgb8(scratch("a.jpg"));
    ASSERT_TRUE(back.same_size(image));
    for (std::size_t i = 0; i < image.size(); ++i) EXPECT_NEAR(back.pixels[i].r, image.pixels[i].r, 8);
}

TEST(Pictures, FormatsThatAreNotReadAreNamed) {
    using namespace std::string_literals;
    for (const auto& [bytes, name] : {std::pair{"\0\0\0\x18"
                                                "ftypheic\0\0\0\0"s,
                                                "HEIC"},
                                      {"\0\0\0\x1c"
                                       "ftypavif\0\0\0\0"s,
                                       "AVIF"},
                                      {"GIF89a....."s, "GIF"},
                                      {"BM........"s, "BMP"},
                                      {"<!DOCTYPE html>"s, "web page"},
                                      {"version https://git-lfs.github.com/spec/v1\n"s, "Git LFS"},
                                      {""s, "an empty file"},
                                      {"hello"s, "something else"}}) {
        write_file(scratch("odd.jpg"), bytes);
        try {
            load_rgb8(scratch("odd.jpg"));
            ADD_FAILURE() << name;
        } catch (const Error& e) {
            EXPECT_NE(std::string(e.what()).find(name), std::string::npos) << e.what();
            EXPECT_NE(std::string(e.what()).find("odd.jpg"), std::string::npos) << e.what();
        }
    }
}

TEST(FloatMaps, RoundTripsKeepEveryBit) {
    ImageF map(7, 4);
    Random random(3, "map");
    for (float& v : map.pixels) v = random.uniform(0, 20);
    map.at(0, 0) = std::numeric_limits<float>::infinity();
    map.at(1, 0) = 0;
    save_exr(scratch("a.exr"), map);
    save_pfm(scratch("a.pfm"), map);
    EXPECT_EQ(load_float(scratch("a.exr")), map);
    EXPECT_EQ(load_float(scratch("a.pfm")), map);
}

// Every format, truncated and damaged everywhere: an Error or a picture, never a crash.
TEST(Pictures, DamagedFilesAreErrors) {
    save_png(scratch("f.png"), noise(16, 8));
    save_jpeg(scratch("f.jpg"), ramp(16, 8));
    save_exr(scratch("f.exr"), ImageF(16, 8, 1.f));
    save_pfm(scratch("f.pfm"), ImageF(16, 8, 1.f));
    Random random(4, "damage");
    for (const char* name : {"f.png", "f.jpg", "f.exr", "f.pfm"}) {
        const std::string whole = read_file(scratch(name));
        const fs::path broken = scratch("broken");
        const auto load = [&] {
            name[2] == 'p' && name[3] == 'n' ? (void)load_rgb8(broken)
            : name[2] == 'j'                 ? (void)load_rgb8(broken)
                                             : (void)load_float(broken);
        };
        for (std::size_t keep = 0; keep + 12 < whole.size(); keep += 1 + whole.size() / 60) {
            write_file(broken, whole.substr(0, keep));
            EXPECT_THROW(load(), Error) << name << " cut to " << keep;
        }
        for (int i = 0; i < 60; ++i) {
            std::string bytes = whole;
            bytes[static_cast<std::size_t>(random.index(static_cast<int>(bytes.size())))] ^= static_cast<char>(
                1 + random.index(255));
            write_file(broken, bytes);
            try {
                load();
            } catch (const Error&) {
            }
        }
    }
    write_file(scratch("text.png"), std::string_view("not a picture"));
    EXPECT_THROW(load_rgb8(scratch("text.png")), Error);
    EXPECT_THROW(load_rgb8(scratch("absent.png")), Error);
    EXPECT_THROW(save_png("/proc/none/a.png", noise(2, 2)), Error);
}

TEST(SplatPly, HasSixtyTwoFloatsAndRoundTrips) {
    for (const int degree : {0, 1, 3}) {
        const Splats splats = some_splats(37, degree);
        save_splat_ply(scratch("s.ply"), splats);
        const Ply ply(scratch("s.ply"));
        EXPECT_EQ(ply.element("vertex").stride, 62u * 4);
        EXPECT_EQ(load_splat_ply(scratch("s.ply")), splats);  // all-zero SH degrees are dropped
        save_splat_ply(scratch("s.ply"), splats, PlyBands::present);
        EXPECT_EQ(Ply(scratch("s.ply")).element("vertex").properties.size(),
                  17u + 3 * static_cast<std::size_t>(splats.rest_coefficients()));
        EXPECT_EQ(load_splat_ply(scratch("s.ply")), splats);
    }
}

TEST(SplatPly, DamagedFilesAreErrors) {
    save_splat_ply(scratch("s.ply"), some_splats(3, 0));
    const std::string whole = read_file(scratch("s.ply"));
    for (std::size_t keep = 0; keep < whole.size(); keep += 23) {
        write_file(scratch("t.ply"), whole.substr(0, keep));
        EXPECT_THROW(load_splat_ply(scratch("t.ply")), Error) << keep;
    }
    std::string lying = whole;
    lying.replace(lying.find("vertex 3"), 8, "vertex 9999999999");
    write_file(scratch("t.ply"), lying);
    EXPECT_THROW(load_splat_ply(scratch("t.ply")), Error);
}

// An independent decoder, written from the format's description.
TEST(CompressedPly, DecodesWithinTheFormatsSteps) {
    Splats splats = some_splats(700, 1);
    save_compressed_ply(scratch("c.ply"), splats);
    const Ply ply(scratch("c.ply"));
    const PlyElement &chunks = ply.element("chunk"), &vertices = ply.element("vertex");
    ASSERT_EQ(chunks.count, 3u);
    ASSERT_EQ(vertices.count, 700u);
    EXPECT_EQ(ply.element("sh").properties.size(), 9u);
    const auto bits = [](std::uint32_t v, int at, int n) {
        return static_cast<float>(v >> at & ((1u << n) - 1)) / static_cast<float>((1u << n) - 1);
    };
    std::vector<bool> used(splats.size());
    for (std::size_t i = 0; i < vertices.count; ++i) {
        const std::size_t chunk = i / 256;
        const auto bound = [&](const std::string& name) {
            return ply.number(chunks, chunk, ply.property(chunks, name));
        };
        const auto packed = [&](const char* name) {
            return static_cast<std::uint32_t>(ply.value(vertices, i, ply.property(vertices, name)));
        };
        const auto between = [&](const char* kind, const char* axis, float s) {
            const float low = bound(std::string("min_") + kind + axis), high = bound(std::string("max_") + kind + axis);
            return low + s * (high - low);
        };
        const std::uint32_t p = packed("packed_position"), c = packed("packed_color"), r = packed("packed_rotation");
        const Vec3f mean{between("", "x", bits(p, 21, 11)), between("", "y", bits(p, 11, 10)),
                         between("", "z", bits(p, 0, 11))};
        // Matched to the nearest original.
        std::size_t best = 0;
        for (std::size_t k = 1; k < splats.size(); ++k)
            if (length(splats.mean_m[k] - mean) < length(splats.mean_m[best] - mean)) best = k;
        EXPECT_LT(length(splats.mean_m[best] - mean), 0.005f);
        EXPECT_FALSE(used[best]);
        used[best] = true;
        EXPECT_NEAR(between("", "r", bits(c, 24, 8)), 0.5f + kSh0 * splats.sh0[best].x, 0.004f);
        EXPECT_NEAR(bits(c, 0, 8), 1 / (1 + std::exp(-splats.opacity_logit[best])), 0.0021f);
        const std::uint32_t s = packed("packed_scale");
        EXPECT_NEAR(between("scale_", "y", bits(s, 11, 10)), splats.log_scale[best].y, 0.004f);
        float q[4], sum = 0;
        const std::uint32_t largest = r >> 30;
        int at = 20;
        for (std::uint32_t k = 0; k < 4; ++k)
            if (k != largest) q[k] = (bits(r, at, 10) - 0.5f) * std::sqrt(2.f), sum += q[k] * q[k], at -= 10;
        q[largest] = std::sqrt(std::max(0.f, 1 - sum));
        const Quatf o = splats.rotation[best];
        const float n = std::sqrt(o.w * o.w + o.x * o.x + o.y * o.y + o.z * o.z);
        EXPECT_GT(std::abs(q[0] * o.w + q[1] * o.x + q[2] * o.y + q[3] * o.z) / n, 0.99999f);
    }
}

ViewSet some_views() {
    ViewSet set;
    for (int i = 0; i < 5; ++i) {
        View view;
        view.name = fmt::format("{:03}.png", i);
        view.camera = Pinhole::with_fov(12, 10, i < 3 ? 90.f : 75.f);
        view.world_from_camera = {
            rotation_about(normalize(Vec3f{1, 2, static_cast<float>(i)}), 0.7f * static_cast<float>(i)),
            {0.1f * static_cast<float>(i), -0.2f, 0.3f}};
        view.color = noise(12, 10);
        if (i == 2) view.weight = ImageMask(12, 10, 99);
        set.views.push_back(view);
    }
    for (int i = 0; i < 20; ++i)
        set.points.push_back({{static_cast<float>(i), 1, 2},
                              {0, -1, 0},
                              {1, 2, static_cast<std::uint8_t>(i)},
                              0.01f * static_cast<float>(i),
                              {0, 0, 0.5f}});
    return set;
}

TEST(Views, RoundTrip) {
    const ViewSet set = some_views();
    const fs::path dir = scratch("views");
    fs::remove_all(dir);
    save_views(dir, set);
    const ViewSet back = load_views(dir);
    ASSERT_EQ(back.views.size(), set.views.size());
    for (std::size_t i = 0; i < set.views.size(); ++i) {
        EXPECT_EQ(back.views[i].name, set.views[i].name);
        EXPECT_EQ(back.views[i].camera, set.views[i].camera);
        EXPECT_EQ(back.views[i].color, set.views[i].color);
        EXPECT_EQ(back.views[i].weight, set.views[i].weight);
        const Rigid difference = inverse(set.views[i].world_from_camera) * back.views[i].world_from_camera;
        EXPECT_LT(length(difference.translation), 1e-6f);
        EXPECT_GT(difference.rotation.row0.x + difference.rotation.row1.y + difference.rotation.row2.z, 3 - 1e-5f);
    }
    ASSERT_EQ(back.points.size(), set.points.size());
    EXPECT_EQ(back.points[7].position_m, set.points[7].position_m);
    EXPECT_EQ(back.points[7].radius_m, set.points[7].radius_m);
    EXPECT_EQ(back.points[7].edge, set.points[7].edge);
    EXPECT_EQ(back.points[7].color, set.points[7].color);
    // For loaders with fixed record sizes: a vertex has 27 bytes, and vertices come first.
    const std::string ply = read_file(dir / "sparse" / "0" / "points3D.ply");
    const std::size_t vertex = ply.find("end_header\n") + 11 + 27 * 7;
    float x = 0;
    std::memcpy(&x, ply.data() + vertex, 4);
    EXPECT_EQ(x, set.points[7].position_m.x);
}

TEST(Views, DamagedModelsAreErrors) {
    const fs::path dir = scratch("broken_views");
    fs::remove_all(dir);
    save_views(dir, some_views());
    for (const char* name : {"cameras.bin", "images.bin", "points3D.ply"}) {
        const fs::path file = dir / "sparse" / "0" / name;
        const std::string whole = read_file(file);
        for (std::size_t keep = 0; keep < whole.size(); keep += 1 + whole.size() / 40) {
            write_file(file, whole.substr(0, keep));
            EXPECT_THROW(load_views(dir), Error) << name << " cut to " << keep;
        }
        write_file(file, whole);
    }
    EXPECT_NO_THROW(load_views(dir));
}

TEST(Viewer, OtherVersionsOfThePageAreRefused) {
    const fs::path dir = scratch("viewer");
    fs::create_directories(dir);
    write_file(dir / "index.html", std::string_view("<html></html>"));
    write_file(dir / "index.css", std::string_view(""));
    write_file(dir / "index.js", std::string_view("export { createViewer };"));
    EXPECT_THROW(save_viewer_html(scratch("v.html"), some_splats(3, 0), {}, dir), Error);
}

TEST(Viewer, TheCameraIsTurnedIntoTheViewersFrame) {
    ViewerScene scene;
    scene.camera_position_m = {1, 2, 3};
    EXPECT_NE(viewer_settings(scene).find("\"position\":[-1.0,-2.0,3.0]"), std::string::npos);
}

// A minimal page with the patterns that the viewer patches, each once.
fs::path small_viewer(const std::string& script) {
    const fs::path dir = scratch("small_viewer");
    fs::create_directories(dir);
    const std::string_view page =
        R"(<link rel="stylesheet" href="./index.css" /><title>SuperSplat Viewer</title>)"
        R"(<script id="sse-bootstrap">null</script>)"
        R"(<script>import { createViewer } from './index.js'; noanim: url.searchParams.has('noanim')</script>)";
    write_file(dir / "index.html", page);
    write_file(dir / "index.css", std::string_view(""));
    write_file(dir / "index.js", script);
    return dir;
}
const std::string kControllers =
    "setCameraBasis(this._angles, forward$2, right$2, up$1);\nthis.update = (deltaTime, frame) => {\n"
    "controller.update(dt, frame, target);\nlastPosition.copy(this.camera.position);\nsource.navigateTo(position, "
    "speedMul);\nstate.cameraMode = state.hasAnimation ? 'anim' : 'fly';\n"
    "gsplat.radialSorting = true;\nparent.script.create(XrNavigation);\nparent.setPosition(cameraPosition.x, 0, "
    "cameraPosition.z);\nexport { "
    "createViewer };";

TEST(Viewer, TheWalkableAreaIsTurnedIntoTheViewersFrameAndHeldByTheScript) {
    ViewerScene scene;
    scene.walkable = WalkableArea{{{{1, 2}, {3, 2}, {3, 5}}}, -0.4f, 0.7f, 1.6f};
    const fs::path page = scratch("walk.html");
    save_viewer_html(page, some_splats(3, 0), scene, small_viewer(kControllers));
    const std::string text = read_file(page);
    const std::string_view bounds =
        R"({"rings":[[[-1.0,2.0],[-3.0,2.0],[-3.0,5.0]]],"low":-0.7,"high":0.4,"ground":-1.6})";
    EXPECT_NE(text.find("new WalkBounds(" + std::string(bounds) + ")"), std::string::npos);
    EXPECT_NE(text.find("class WalkBounds"), std::string::npos);
    EXPECT_NE(text.find("walkBounds.hold(state.cameraMode, controller, target, dt)"), std::string::npos);
    EXPECT_EQ(text.find("export {"), std::string::npos);
    EXPECT_EQ(text.find("setCameraBasis"), std::string::npos);

    scene.walkable.reset();
    save_viewer_html(page, some_splats(3, 0), scene, small_viewer(kControllers));
    EXPECT_EQ(read_file(page).find("walkBounds"), std::string::npos);
}

TEST(Viewer, SplatsAreSortedByDepthAsTheyAreTrained) {
    const fs::path page = scratch("sorted.html");
    save_viewer_html(page, some_splats(3, 0), {}, small_viewer(kControllers));
    EXPECT_NE(read_file(page).find("gsplat.radialSorting = false;"), std::string::npos);
}

TEST(Viewer, ATourWaitsForItsButton) {
    ViewerScene scene;
    EXPECT_TRUE(Json::parse(viewer_settings(scene))["animTracks"].empty());
    scene.tour = CameraPath{10, 75, 1280, 720, {{0, {}, 0, 0}, {2, {1, 0, 0}, 90, 0}}};
    const Json settings = Json::parse(viewer_settings(scene));
    EXPECT_EQ(settings["animTracks"][0]["keyframes"]["times"].size(), 21u);
    EXPECT_EQ(settings["startMode"], "animTrack");
    const fs::path page = scratch("tour.html");
    save_viewer_html(page, some_splats(3, 0), scene, small_viewer(kControllers));
    const std::string text = read_file(page);
    EXPECT_NE(text.find("state.hasAnimation && !global.config.noanim ? 'anim'"), std::string::npos);
    EXPECT_NE(text.find("noanim: !url.searchParams.has('anim')"), std::string::npos);
}

TEST(Viewer, AViewerWhoseCamerasCannotBeHeldIsRefused) {
    const ViewerScene free;
    ViewerScene held;
    held.walkable = WalkableArea{{{{0, 0}, {1, 0}, {1, 1}}}, -0.4f, 0.7f, 1.6f};
    const Splats splats = some_splats(3, 0);
    for (const std::string_view place : {"setCameraBasis", "this.update", "controller.update", "lastPosition",
                                         "navigateTo", "XrNavigation", "setPosition"}) {
        std::string script = kControllers;
        script.replace(script.find(place), place.size(), "another");
        const fs::path viewer = small_viewer(script);
        EXPECT_THROW(save_viewer_html(scratch("held.html"), splats, held, viewer), Error) << place;
        EXPECT_NO_THROW(save_viewer_html(scratch("free.html"), splats, free, viewer));
    }
}

}  // namespace
}  // namespace fastscene

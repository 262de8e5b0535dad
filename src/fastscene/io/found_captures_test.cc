// Captures as people meet them: six pictures of a wall, their cameras written by other programs, on other machines.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/json.h"
#include "fastscene/io/capture_io.h"
#include "fastscene/io/capture_parts.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/test_scratch.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

constexpr int kPictures = 6, kWidth = 64, kHeight = 48;
double right_of(int i) { return -0.5 + 0.2 * i; }

fs::path fresh(const std::string& name) {
    const fs::path dir = scratch(name);
    fs::remove_all(dir);
    fs::create_directories(dir);
    return dir;
}
void save_pictures(const fs::path& dir, const std::string& pattern) {
    for (int i = 0; i < kPictures; ++i) {
        const fs::path file = dir / fmt::format(fmt::runtime(pattern), i);
        fs::create_directories(file.parent_path());
        save_png(file, ImageRgb8(kWidth, kHeight, Rgb8{90, 120, 60}));
    }
}
// The wall, z = 4.
std::vector<Vec3d> wall() {
    std::vector<Vec3d> out;
    for (int i = 0; i < 60; ++i) out.push_back({-1.5 + 0.05 * i, -1 + 0.2 * (i % 10), 4});
    return out;
}
std::string ply_of(const std::vector<Vec3d>& points) {
    std::string text = fmt::format("ply\nformat ascii 1.0\nelement vertex {}\n", points.size());
    for (const char* name : {"x", "y", "z"}) text += fmt::format("property double {}\n", name);
    for (const char* name : {"red", "green", "blue"}) text += fmt::format("property uchar {}\n", name);
    text += "end_header\n";
    for (const Vec3d p : points) text += fmt::format("{} {} {} 120 90 80\n", p.x, p.y, p.z);
    return text;
}
struct Colmap {
    std::string names = "{}.png", cameras = "1 PINHOLE 64 48 50 50 32 24\n", sub = "sparse/0";
    int first = 0, last = kPictures;
    int other_camera_of = -1;  // this picture has camera 2
    int odd_pose_of = -1;
    Vec3d at = {};
};
void save_colmap_text(const fs::path& dir, const Colmap& c) {
    fs::create_directories(dir / c.sub);
    write_file(dir / c.sub / "cameras.txt", c.cameras);
    std::string images = "# images\n", points;
    for (int i = c.first; i < c.last; ++i)
        images += fmt::format("{} 1 0 0 0 {} {} {} {} {}\n\n", i + 1,
                              i == c.odd_pose_of ? "-1.#IND" : fmt::format("{}", -right_of(i) - c.at.x), -c.at.y,
                              -c.at.z, i == c.other_camera_of ? 2 : 1, fmt::format(fmt::runtime(c.names), i));
    int number = 0;
    for (const Vec3d p : wall())
        points += fmt::format("{} {} {} {} 120 90 80 0.5\n", ++number, p.x + c.at.x, p.y + c.at.y, p.z + c.at.z);
    write_file(dir / c.sub / "images.txt", images);
    write_file(dir / c.sub / "points3D.txt", points);
}

void expect_six(const Capture& capture, const std::string& what, std::size_t warnings = 0) {
    ASSERT_EQ(capture.photos.size(), 6u) << what;
    for (int i = 0; i < kPictures; ++i) {
        const Photo& photo = capture.photos[static_cast<std::size_t>(i)];
        EXPECT_TRUE(fs::is_regular_file(photo.file)) << what << ": " << photo.name << ' ' << photo.file;
        EXPECT_EQ(photo.file.stem().string().back(), static_cast<char>('0' + i)) << what;
        EXPECT_NEAR(photo.lens.fx, 50, 1e-6) << what;
        EXPECT_NEAR(photo.lens.cx, 32, 1e-6) << what;
    }
    EXPECT_GT(share_in_view(capture.photos, capture.points), 0.5) << what;
    const Vec3d apart = capture.photos[5].world_from_camera.translation -
                        capture.photos[0].world_from_camera.translation;
    EXPECT_NEAR(length(apart), 1, 1e-6) << what;
    EXPECT_EQ(capture.warnings.size(), warnings) << what << (capture.warnings.empty() ? "" : capture.warnings[0]);
}

TEST(FoundColmap, NamesWithBlanksUmlautsAndBackslashes) {
    const fs::path dir = fresh("blanks");
    save_pictures(dir / "images", "left/A shot (ü) {}.png");
    save_colmap_text(dir, {.names = "left/A shot (ü) {}.png"});
    expect_six(load_colmap_capture(dir, {}), "blanks");
    save_colmap_text(dir, {.names = "left\\A shot (ü) {}.png"});
    expect_six(load_colmap_capture(dir, {}), "backslashes");
}

TEST(FoundColmap, ThreeDigitExponentsAndNoEmptyLineAtTheEnd) {
    const fs::path dir = fresh("odd lines");
    save_pictures(dir / "images", "{}.png");
    save_colmap_text(dir, {});
    std::string cameras = "1 PINHOLE 64 48 5.000000000000000e+001 5.0e+001 3.2e+001 2.4e+001",
                images = read_file(dir / "sparse/0/images.txt");
    while (images.back() == '\n') images.pop_back();
    write_file(dir / "sparse/0/cameras.txt", cameras);
    write_file(dir / "sparse/0/images.txt", images);
    expect_six(load_colmap_capture(dir, {}), "odd lines");
}

TEST(FoundColmap, RigsAndMasksForSome) {
    const fs::path dir = fresh("rigs");
    std::string images = "# images\n";
    for (int i = 0; i < kPictures; ++i) {
        const fs::path file = dir / fmt::format("images/cam{}/{}.png", i / 3, i);
        fs::create_directories(file.parent_path());
        save_png(file, ImageRgb8(kWidth, kHeight));
        images += fmt::format("{} 1 0 0 0 {} 0 0 1 cam{}/{}.png\n\n", i + 1, -right_of(i), i / 3, i);
    }
    save_colmap_text(dir, {});
    write_file(dir / "sparse/0/images.txt", images);
    // COLMAP 4 keeps them beside the model; the poses stand in images.txt as before.
    write_file(dir / "sparse/0/rigs.txt", std::string_view("# rigs\n1 2 CAMERA 1 CAMERA 2 1 1 0 0 0 0.2 0 0\n"));
    write_file(dir / "sparse/0/frames.txt", std::string_view("# frames\n1 1 1 0 0 0 0 0 0 2 CAMERA 1 1 CAMERA 2 2\n"));
    fs::create_directories(dir / "masks/cam0");
    for (int i = 0; i < 3; ++i)
        save_png(dir / fmt::format("masks/cam0/{}.png.png", i), ImageMask(kWidth, kHeight, 255));
    const Capture capture = load_colmap_capture(dir, {});
    expect_six(capture, "rigs");
    EXPECT_EQ(
        std::count_if(capture.photos.begin(), capture.photos.end(), [](const Photo& p) { return !p.mask.empty(); }), 3);
}

TEST(FoundColmap, CamerasAndPosesThatAreNotFinite) {
    const fs::path dir = fresh("nan");
    save_pictures(dir / "images", "{}.png");
    const std::string two = "1 PINHOLE 64 48 50 50 32 24\n2 PINHOLE 64 48 -nan(ind) -nan(ind) 32 24\n";
    save_colmap_text(dir, {.cameras = two, .other_camera_of = 3, .odd_pose_of = 1});
    const Capture capture = load_colmap_capture(dir, {});
    EXPECT_EQ(capture.photos.size(), 4u);
    ASSERT_EQ(capture.warnings.size(), 1u);
    EXPECT_NE(capture.warnings[0].find("2 of 6 pictures are left out: 1.png (its pose is not finite); 3.png (camera 2"),
              std::string::npos)
        << capture.warnings[0];
    save_colmap_text(dir, {.cameras = "1 PINHOLE 64 48 nan nan 32 24\n"});
    EXPECT_THROW(load_colmap_capture(dir, {}), Error);
}

TEST(FoundColmap, OtherEndingsAndLetterCase) {
    const fs::path dir = fresh("endings");
    save_pictures(dir / "images", "IMG_{}.PNG");
    for (const char* names : {"IMG_{}.jpg", "img_{}.png", "Img_{}.JPG"}) {
        save_colmap_text(dir, {.names = names});
        expect_six(load_colmap_capture(dir, {}), names, 1);
    }
    // Two that fit: none is taken.
    fs::copy(dir / "images/IMG_2.PNG", dir / "images/IMG_2.webp");
    const Capture capture = load_colmap_capture(dir, {});
    EXPECT_FALSE(fs::is_regular_file(capture.photos[2].file));
    EXPECT_TRUE(fs::is_regular_file(capture.photos[3].file));
}

TEST(FoundColmap, TheLargestOfSeveralModels) {
    const fs::path dir = fresh("several");
    save_pictures(dir / "images", "{}.png");
    save_colmap_text(dir, {.last = 2});
    save_colmap_text(dir, {.sub = "sparse/1", .first = 2});
    const Capture capture = load_colmap_capture(dir, {});
    EXPECT_EQ(capture.photos.size(), 4u);
    ASSERT_EQ(capture.warnings.size(), 1u);
    EXPECT_NE(capture.warnings[0].find("sparse/1 of 2 models is used"), std::string::npos) << capture.warnings[0];
}

TEST(FoundColmap, FarFromTheOrigin) {
    const fs::path dir = fresh("far");
    save_pictures(dir / "images", "{}.png");
    save_colmap_text(dir, {.at = {4512345.25, 654321.5, 120}});
    const Capture capture = load_colmap_capture(dir, {});
    expect_six(capture, "far", 1);
    EXPECT_EQ(capture.offset, (Vec3d{4512000, 654000, 0}));
    EXPECT_NEAR(capture.photos[0].world_from_camera.translation.x, 345.25 + right_of(0), 1e-6);
    EXPECT_NEAR(capture.points[0].position.z, 124, 1e-9);
}

Json frame(const std::string& file, int i) {
    const auto row = [](double a, double b, double c, double d) { return Json{a, b, c, d}; };
    return {{"file_path", file},
            {"transform_matrix", {row(1, 0, 0, right_of(i)), row(0, -1, 0, 0), row(0, 0, -1, 0), row(0, 0, 0, 1)}}};
}
Json with_lens(Json owner) {
    owner.update({{"w", kWidth}, {"h", kHeight}, {"fl_x", 50}, {"fl_y", 50}, {"cx", 32}, {"cy", 24}});
    return owner;
}
Json frames_named(const std::string& pattern, bool lenses) {
    Json frames = Json::array();
    for (int i = 0; i < kPictures; ++i) {
        Json one = frame(fmt::format(fmt::runtime(pattern), i), i);
        frames.push_back(lenses ? with_lens(one) : one);
    }
    return frames;
}

TEST(FoundTransforms, LensesPerFrameBackslashesAndOtherMachines) {
    const fs::path dir = fresh("transforms");
    save_pictures(dir / "images", "{}.png");
    write_file(dir / "sparse.ply", ply_of(wall()));
    write_json(dir / "transforms.json",
               {{"ply_file_path", ".\\sparse.ply"}, {"frames", frames_named("images/{}.png", true)}});
    expect_six(load_nerfstudio_capture(dir, {}), "lenses per frame");
    for (const char* names : {".\\images\\{}.png", "C:\\data\\images\\{}.png", "/home/other/images/{}.png"}) {
        Json json = with_lens({{"ply_file_path", "sparse.ply"}});
        json["frames"] = frames_named(names, false);
        write_json(dir / "transforms.json", json);
        expect_six(load_nerfstudio_capture(dir, {}), names);
    }
    Json json = with_lens({{"ply_file_path", "sparse.ply"}});
    json["frames"] = frames_named("images/{}.JPG", false);
    write_json(dir / "transforms.json", json);
    expect_six(load_nerfstudio_capture(dir, {}), "another ending", 1);
}

TEST(FoundTransforms, ACloudInTheOriginalFrame) {
    const fs::path dir = fresh("applied");
    save_pictures(dir / "images", "{}.png");
    // The frames' world is that of the cloud after the transform, which exchanges axes.
    std::vector<Vec3d> original;
    for (const Vec3d p : wall()) original.push_back({p.y, p.z, p.x});
    Json json = with_lens({{"ply_file_path", "sparse.ply"}, {"frames", frames_named("images/{}.png", false)}});
    json["applied_transform"] = Json{Json{0, 0, 1, 0}, Json{1, 0, 0, 0}, Json{0, 1, 0, 0}};
    write_json(dir / "transforms.json", json);
    write_file(dir / "sparse.ply", ply_of(original));
    const Capture moved = load_nerfstudio_capture(dir, {});
    expect_six(moved, "original frame", 1);
    EXPECT_LT(length(moved.points[7].position - wall()[7]), 1e-9);
    write_file(dir / "sparse.ply", ply_of(wall()));  // nerfstudio's own: already there
    expect_six(load_nerfstudio_capture(dir, {}), "transformed");
}

TEST(FoundTransforms, SpheresNeedNoFocalLength) {
    const fs::path dir = fresh("spheres");
    for (int i = 0; i < kPictures; ++i) save_png(dir / fmt::format("{}.png", i), ImageRgb8(64, 32));
    Json frames = frames_named("{}.png", false);
    frames[0].update({{"camera_model", "OPENCV"}, {"fl_x", 50}, {"w", 64}, {"h", 32}});  // one that is none
    write_json(dir / "transforms.json", {{"camera_model", "equirectangular"}, {"frames", frames}});
    const Capture capture = load_nerfstudio_capture(dir, {});
    ASSERT_EQ(capture.photos.size(), 6u);
    EXPECT_EQ(capture.photos[0].lens.kind, LensKind::perspective);
    EXPECT_EQ(capture.photos[1].lens.kind, LensKind::equirectangular);
    EXPECT_EQ(capture.photos[1].lens.width, 64);
}

// A world with z up, as photogrammetry has it: x right, y forward.
Vec3d z_up(Vec3d p) { return {p.x, p.z, -p.y}; }
std::vector<Vec3d> wall_z_up() {
    std::vector<Vec3d> out;
    for (const Vec3d p : wall()) out.push_back(z_up(p));
    return out;
}

TEST(FoundRealityScan, CsvAndPoints) {
    const fs::path dir = fresh("realityscan");
    save_pictures(dir / "images/day 1", "IMG_{}.png");
    write_file(dir / "cloud.ply", ply_of(wall_z_up()));
    // 50 of 64 pixels are 28.125 of 36 mm. A pitch of 90 degrees looks at the horizon.
    std::string csv = "\xef\xbb\xbf#name,x,y,alt,heading,pitch,roll,f,px,py,k1,k2,k3,k4,t1,t2\r\n";
    for (int i = 0; i < kPictures; ++i)
        csv += fmt::format("IMG_{}.JPG,{},0,0,0,90,0,28.125,0,0,0,0,0,0,0,0\r\n", i, right_of(i));
    write_file(dir / "cameras.csv", csv);
    const CaptureFolders folders{.images = {}, .masks = {}, .downscale = 1, .points = dir / "cloud.ply"};
    const Capture capture = load_realityscan_capture(dir / "cameras.csv", folders);
    expect_six(capture, "RealityScan");
    const Rigidd pose = capture.photos[0].world_from_camera;
    EXPECT_LT(length(pose.rotation.column(2) - Vec3d{0, 1, 0}), 1e-9);   // looks along y
    EXPECT_LT(length(pose.rotation.column(1) - Vec3d{0, 0, -1}), 1e-9);  // down is down
    // Heading turns clockwise, as a compass does: at 90 degrees the camera looks along x.
    write_file(dir / "east.csv",
               "#name,x,y,alt,heading,pitch,roll,f,px,py,k1,k2,k3,k4,t1,t2\n"
               "IMG_1.JPG,0,0,0,90,90,0,28.125,0.1,-0.05,0,0,0,0,0,0\n");
    const Photo east = load_realityscan_capture(dir / "east.csv", folders).photos[0];
    EXPECT_LT(length(east.world_from_camera.rotation.column(2) - Vec3d{1, 0, 0}), 1e-9);
    EXPECT_NEAR(east.lens.cx, 32 + 6.4, 1e-9);
    EXPECT_NEAR(east.lens.cy, 24 - 3.2, 1e-9);
    write_file(dir / "other.csv", std::string_view("name,x,y,z\n1,2,3,4\n"));
    EXPECT_THROW(load_realityscan_capture(dir / "other.csv", folders), Error);
}

std::string metashape(const std::string& cameras) {
    return R"(<?xml version="1.0" encoding="UTF-8"?>
<document version="2.1.0"><chunk label="Chunk 1" enabled="true"><sensors next_id="2">
<sensor id="0" label="X" type="frame"><resolution width="64" height="48"/>
<calibration type="frame" class="initial"><f>40</f></calibration>
<calibration type="frame" class="adjusted"><resolution width="64" height="48"/><f>50</f><cx>0</cx><cy>0</cy>
<k1>-0.1</k1><p1>0.002</p1><p2>0.003</p2></calibration></sensor>
<sensor id="1" label="Y" type="frame"><resolution width="64" height="48"/></sensor></sensors>
<components next_id="1"><component id="0" label="Component 1"><transform>
<rotation locked="false">1 0 0 0 0 1 0 -1 0</rotation><translation locked="false">10 20 30</translation>
<scale locked="false">2</scale></transform></component></components>
<cameras next_id="9"><group id="0" label="g">)" +
           cameras + "</group></cameras></chunk></document>\n";
}

TEST(FoundMetashape, XmlAndPoints) {
    const fs::path dir = fresh("metashape");
    save_pictures(dir, "DJI_{}.png");
    // In the component a unit is two metres.
    std::string cameras;
    for (int i = 0; i < kPictures; ++i)
        cameras += fmt::format(
            "<camera id=\"{0}\" sensor_id=\"0\" component_id=\"0\" label=\"DJI_{0}\"><transform>1 0 "
            "0 {1} 0 1 0 0 0 0 1 0 0 0 0 1</transform></camera>\n",
            i, right_of(i) / 2);
    cameras += "<camera id=\"7\" sensor_id=\"0\" label=\"lost\"/><camera id=\"8\" sensor_id=\"1\" label=\"raw\"/>";
    write_file(dir / "cameras.xml", metashape(cameras));
    std::vector<Vec3d> points;
    for (const Vec3d p : wall_z_up()) points.push_back(p + Vec3d{10, 20, 30});
    write_file(dir / "cloud.ply", ply_of(points));
    const Capture capture = load_metashape_capture(
        dir / "cameras.xml", {.images = {}, .masks = {}, .downscale = 1, .points = dir / "cloud.ply"});
    expect_six(capture, "Metashape", 1);
    EXPECT_NE(capture.warnings[0].find("2 of 8 pictures have no pose"), std::string::npos) << capture.warnings[0];
    EXPECT_LT(length(capture.photos[0].world_from_camera.rotation.column(2) - Vec3d{0, 1, 0}), 1e-9);
    EXPECT_NEAR(capture.photos[0].lens.k[0], -0.1, 1e-12);
    EXPECT_NEAR(capture.photos[0].lens.p2, 0.002, 1e-12);  // its p1 is OpenCV's p2
    EXPECT_NEAR(capture.photos[0].lens.p1, 0.003, 1e-12);
}

TEST(FoundPolycam, RawData) {
    const fs::path dir = fresh("polycam");
    save_pictures(dir / "keyframes/corrected_images", "90000{}.png");
    fs::create_directories(dir / "keyframes/corrected_cameras");
    for (int i = 0; i < kPictures; ++i) {
        Json json{{"width", kWidth}, {"height", kHeight}, {"fx", 50}, {"fy", 50}, {"cx", 32}, {"cy", 24}};
        // Looks along -z with y up.
        const double m[3][4] = {{1, 0, 0, right_of(i)}, {0, 1, 0, 0}, {0, 0, 1, 0}};
        for (int r = 0; r < 3; ++r)
            for (int c = 0; c < 4; ++c) json[fmt::format("t_{}{}", r, c)] = m[r][c];
        write_json(dir / "keyframes/corrected_cameras" / fmt::format("90000{}.json", i), json);
    }
    std::vector<Vec3d> points;
    for (const Vec3d p : wall()) points.push_back({p.x, -p.y, -p.z});
    write_file(dir / "cloud.ply", ply_of(points));
    expect_six(load_polycam_capture(dir, {.images = {}, .masks = {}, .downscale = 1, .points = dir / "cloud.ply"}),
               "Polycam");
    EXPECT_THROW(load_polycam_capture(dir / "keyframes/corrected_images", {}), Error);
}

TEST(CaptureKinds, AreFoundByName) {
    for (const CaptureKind& kind : capture_kinds()) EXPECT_EQ(capture_kind(kind.name).load, kind.load);
    EXPECT_THROW(capture_kind("other"), Error);
}

}  // namespace
}  // namespace fastscene

// Parts of panoramas and other spheres: each must show the same directions as the whole, and nothing where it has
// nothing.
#include "fastscene/panorama/sphere_part.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/geometry/cubemap.h"
#include "fastscene/io/image_io.h"
#include "fastscene/panorama/picture_file.h"

namespace fastscene {
namespace {

constexpr double kTest = std::numbers::pi / 180;

// A smooth color for each direction.
Rgb8 color_of(Vec3d d) {
    d = normalize(d);
    const auto wave = [](double v) { return static_cast<std::uint8_t>(std::lround(127.5 + 100 * std::sin(v))); };
    return {wave(2 * d.x + 1), wave(2 * d.y + d.z), wave(2 * d.z - d.x)};
}
ImageRgb8 sphere(int width, const Mat3d& level_from_picture = {}) {
    ImageRgb8 out(width, width / 2);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < width; ++x)
            out.at(x, y) = color_of(level_from_picture *
                                    direction_at(Vec2d{x + 0.5, y + 0.5}, EquirectSize{width, width / 2}));
    return out;
}
ImageRgb8 cut(const ImageRgb8& whole, int left, int top, int width, int height) {
    ImageRgb8 out(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) out.at(x, y) = whole.at(wrap_column(left + x, whole.width), top + y);
    return out;
}

// Share of the sphere that is missing; all else must have its direction's color.
double checked_missing(const WholeSphere<Rgb8>& whole, double within, const std::string& what) {
    const EquirectSize size{whole.color.width, whole.color.height};
    EXPECT_EQ(size.width, 2 * size.height) << what;
    double missing = 0, all = 0, worst = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            all += pixel_solid_angle(y, size);
            if (!whole.missing.empty() && whole.missing.at(x, y)) {
                missing += pixel_solid_angle(y, size);
                continue;
            }
            const Rgb8 a = whole.color.at(x, y), b = color_of(direction_at(Vec2d{x + 0.5, y + 0.5}, size));
            worst = std::max(
                {worst, std::fabs(double(a.r) - b.r), std::fabs(double(a.g) - b.g), std::fabs(double(a.b) - b.b)});
        }
    EXPECT_LT(worst, within) << what;
    return missing / all;
}

GPano crop_of(double full, double left, double top, double width, double height) {
    GPano g;
    g.full_width = full, g.full_height = full / 2, g.left = left, g.top = top;
    g.cropped_width = width, g.cropped_height = height;
    return g;
}
SpherePart part_of(const ImageRgb8& picture, const std::optional<GPano>& gpano, const PictureLayout& layout = {}) {
    return sphere_part("a.png", {picture.width, picture.height}, gpano, layout);
}
std::string refusal(const ImageRgb8& picture, const std::optional<GPano>& gpano = {},
                    const PictureLayout& layout = {}) {
    try {
        part_of(picture, gpano, layout);
    } catch (const Error& e) {
        return e.what();
    }
    return "";
}

TEST(SpherePart, CropsOfTheXmp) {
    const ImageRgb8 whole = sphere(256);
    const auto placed = [&](int left, int top, int width, int height) {
        const ImageRgb8 picture = cut(whole, left, top, width, height);
        return whole_sphere(picture, part_of(picture, crop_of(256, left, top, width, height)));
    };
    EXPECT_NEAR(checked_missing(placed(0, 24, 256, 80), 3, "band"), 1 - std::sin(56.25 * kTest), 0.02);
    // 2:1 itself: a half of each axis, not the whole sphere.
    EXPECT_NEAR(checked_missing(placed(64, 32, 128, 64), 4, "half"), 1 - 0.5 * std::sin(45 * kTest), 0.02);
    EXPECT_NEAR(checked_missing(placed(200, 0, 100, 60), 4, "across the seam"), 0.81, 0.03);
    // Scaled down after it was cropped.
    const ImageRgb8 fine = sphere(512), half = cut(sphere(256), 0, 24, 256, 80);
    EXPECT_NEAR(checked_missing(whole_sphere(half, part_of(half, crop_of(512, 0, 48, 512, 160))), 3, "scaled"),
                1 - std::sin(56.25 * kTest), 0.02);
}

TEST(SpherePart, CropsThatMakeNoSenseAreIgnoredAndSaid) {
    const ImageRgb8 whole = sphere(256);
    for (const GPano& g : {crop_of(128, 0, 0, 256, 128), crop_of(256, 0, 100, 256, 128), crop_of(256, 0, 0, 200, 30)}) {
        const SpherePart part = part_of(whole, g);
        EXPECT_TRUE(part.is_whole());
        ASSERT_EQ(part.remarks.size(), 1u);
        EXPECT_EQ(part.remarks[0].find("its XMP is ignored"), 0u) << part.remarks[0];
    }
    EXPECT_NE(refusal(cut(whole, 0, 0, 256, 60), crop_of(100, 0, 0, 256, 60)).find("--panorama-fov-deg"),
              std::string::npos);
}

TEST(SpherePart, AWholeSphereIsNotTouched) {
    const ImageRgb8 whole = sphere(256);
    const SpherePart part = part_of(whole, {});
    EXPECT_TRUE(part.is_whole());
    EXPECT_EQ(whole_sphere(whole, part).color, whole);
    EXPECT_TRUE(part.remarks.empty());
}

TEST(SpherePart, AlmostTwoToOneIsResampled) {
    for (const auto& [w, h] : {std::pair{256, 129}, {257, 128}, {254, 128}}) {
        ImageRgb8 picture(w, h);
        for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x)
                picture.at(x, y) = color_of(
                    direction_at(Vec2d{(x + 0.5) / w * 256, (y + 0.5) / h * 128}, EquirectSize{256, 128}));
        const SpherePart part = part_of(picture, {});
        EXPECT_EQ(checked_missing(whole_sphere(picture, part), 4, "almost"), 0);
        ASSERT_EQ(part.remarks.size(), 1u);
        EXPECT_NE(part.remarks[0].find("almost 2:1"), std::string::npos);
    }
    EXPECT_NE(refusal(ImageRgb8(256, 140)).find("found 256 x 140"), std::string::npos);
}

TEST(SpherePart, CylindersAndAnglesByFlag) {
    // A cylinder all around, 90 degrees high.
    const int w = 512, h = static_cast<int>(std::lround(w / std::numbers::pi));
    const double focal = w / (2 * std::numbers::pi);
    ImageRgb8 cylinder(w, h);
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            const double lon = ((x + 0.5) / w - 0.5) * 2 * std::numbers::pi;
            cylinder.at(x, y) = color_of({std::sin(lon), (y + 0.5 - h / 2.0) / focal, std::cos(lon)});
        }
    const SpherePart round = part_of(cylinder, {}, {.projection = "cylinder"});
    EXPECT_NEAR(checked_missing(whole_sphere(cylinder, round), 3, "cylinder"), 1 - std::sin(45 * kTest), 0.01);
    GPano g;
    g.projection = "cylindrical";
    EXPECT_EQ(part_of(cylinder, g).kind, SpherePart::Kind::cylinder);
    // A part of a sphere: 180 x 90 degrees.
    const ImageRgb8 part = cut(sphere(512), 128, 64, 256, 128);
    const PictureLayout angles{.projection = "auto", .fov_deg = 180, .vertical_fov_deg = 90};
    EXPECT_NEAR(checked_missing(whole_sphere(part, part_of(part, {}, angles)), 3, "angles"),
                1 - 0.5 * std::sin(45 * kTest), 0.01);
    // The vertical angle alone: all around.
    const ImageRgb8 band = cut(sphere(512), 0, 64, 512, 128);
    EXPECT_NEAR(checked_missing(whole_sphere(band, part_of(band, {}, {.vertical_fov_deg = 90})), 3, "vertical"),
                1 - std::sin(45 * kTest), 0.01);
}

TEST(SpherePart, LeveledByPitchAndRoll) {
    // A camera that looks up by 20 degrees, and leans to its right by 10.
    const Mat3d level_from_picture = rotation_about(Vec3d{1, 0, 0}, 20 * kTest) *
                                     rotation_about(Vec3d{0, 0, 1}, 10 * kTest);
    EXPECT_LT((level_from_picture * Vec3d{0, 0, 1}).y, -0.3);  // up is -y
    const ImageRgb8 tilted = sphere(512, level_from_picture);
    GPano g;
    g.pitch_deg = 20, g.roll_deg = 10;
    const SpherePart part = part_of(tilted, g);
    EXPECT_EQ(checked_missing(whole_sphere(tilted, part), 3, "tilted"), 0);
    EXPECT_NE(part.remarks.back().find("pitch 20.0, roll 10.0"), std::string::npos);
    EXPECT_TRUE(part_of(tilted, g, {.keep_tilt = true}).is_whole());
}

ImageRgb8 face_picture(CubeFace face, int side) {
    const Pinhole camera = Pinhole::with_fov(side, side, 90);
    const Mat3f turn = pano_from_face(face);
    ImageRgb8 out(side, side);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const Vec3f d = turn * camera.direction_at({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
            out.at(x, y) = color_of({d.x, d.y, d.z});
        }
    return out;
}
void lay(const ImageRgb8& face, int column, int row, ImageRgb8& to) {
    for (int y = 0; y < face.height; ++y)
        for (int x = 0; x < face.width; ++x) to.at(column * face.width + x, row * face.height + y) = face.at(x, y);
}

TEST(SpherePart, Cubes) {
    constexpr int kSide = 64;
    using Face = CubeFace;
    const std::pair<Face, const char*> row[] = {{Face::right, "px"}, {Face::left, "nx"},  {Face::up, "py"},
                                                {Face::down, "ny"},  {Face::front, "pz"}, {Face::back, "nz"}};
    ImageRgb8 strip(6 * kSide, kSide), cross(4 * kSide, 3 * kSide), column(kSide, 6 * kSide);
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "fastscene-cube";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    for (int i = 0; i < 6; ++i) {
        const ImageRgb8 face = face_picture(row[i].first, kSide);
        lay(face, i, 0, strip), lay(face, 0, i, column);
        save_png(folder / fmt::format("room_{}.png", row[i].second), face);
    }
    lay(face_picture(Face::up, kSide), 1, 0, cross), lay(face_picture(Face::down, kSide), 1, 2, cross);
    lay(face_picture(Face::left, kSide), 0, 1, cross), lay(face_picture(Face::front, kSide), 1, 1, cross);
    lay(face_picture(Face::right, kSide), 2, 1, cross), lay(face_picture(Face::back, kSide), 3, 1, cross);
    for (const ImageRgb8& picture : {strip, cross, column}) {
        const SpherePart part = part_of(picture, {});
        EXPECT_TRUE(part.is_cube());
        EXPECT_EQ(checked_missing(whole_sphere(picture, part), 6, fmt::format("{} wide", picture.width)), 0);
    }
    EXPECT_TRUE(has_blank_corners(cross));
    EXPECT_FALSE(has_blank_corners(cut(sphere(1024), 0, 0, 256, 192)));
    EXPECT_EQ(checked_missing({picture_file_of_faces(folder).rgb, {}}, 6, "folder"), 0);
    std::filesystem::remove(folder / "room_ny.png");
    try {
        picture_file_of_faces(folder);
        FAIL() << "expected an error";
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find("found no down"), std::string::npos) << e.what();
    }
    EXPECT_NE(refusal(ImageRgb8(100, 90), {}, {.projection = "cube"}).find("faces of a cube"), std::string::npos);
}

TEST(SpherePart, AnOrdinaryPhotographIsNoCube) {
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "fastscene-photo.png";
    save_png(file, cut(sphere(1024), 0, 0, 256, 192));
    EXPECT_THROW(picture_file_from(read_file(file), file), Error);
}

TEST(SpherePart, TwoFisheyesAreRefusedByName) {
    ImageRgb8 two(512, 256);
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 512; ++x)
            if (std::hypot(x % 256 - 127.5, y - 127.5) < 124) two.at(x, y) = {120, 130, 90};
    EXPECT_TRUE(looks_like_two_fisheyes(two));
    EXPECT_FALSE(looks_like_two_fisheyes(sphere(512)));
    ImageRgb8 dark_poles = sphere(512);
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 512; ++x)
            if (y < 70 || y > 186) dark_poles.at(x, y) = {};
    EXPECT_FALSE(looks_like_two_fisheyes(dark_poles));
    const auto said = [&](const char* name, const ImageRgb8& picture) -> std::string {
        const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / name;
        save_png(file, picture);
        try {
            picture_file_from(read_file(file), file);
        } catch (const Error& e) {
            return e.what();
        }
        return "";
    };
    EXPECT_NE(said("fastscene-two.png", two).find("stitch it first"), std::string::npos);
    EXPECT_NE(said("fastscene-raw.insp", sphere(256)).find("Insta360 Studio"), std::string::npos);
}

TEST(SpherePart, BlackBordersAndTransparencyAreMissing) {
    ImageRgb8 picture = sphere(256);
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 256; ++x)
            if (y < 20 || y >= 110) picture.at(x, y) = {1, 0, 2};
    const ImageMask missing = black_borders(picture);
    ASSERT_FALSE(missing.empty());
    EXPECT_TRUE(missing.at(7, 19) && missing.at(7, 110) && !missing.at(7, 20) && !missing.at(7, 109));
    EXPECT_TRUE(black_borders(sphere(256)).empty());
    EXPECT_TRUE(black_borders(ImageRgb8(256, 128)).empty());  // told apart: the picture is black
    const ImageMask reduced = reduced_missing(missing, 64);
    EXPECT_EQ(reduced.width, 64);
    EXPECT_TRUE(reduced.at(3, 4) && !reduced.at(3, 5) && reduced.at(3, 27) && !reduced.at(3, 26));
}

}  // namespace
}  // namespace fastscene

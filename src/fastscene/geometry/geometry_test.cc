#include <gtest/gtest.h>

#include <algorithm>

#include "fastscene/base/random.h"
#include "fastscene/geometry/test_pictures.h"
#include "fastscene/geometry/cubemap.h"
#include "fastscene/geometry/range_edges.h"

namespace fastscene {
namespace {

constexpr EquirectSize kSize{512, 256};

Vec3f random_direction(Random& r) { return normalize(Vec3f{r.normal(), r.normal(), r.normal()}); }
// A band-limited picture: a low-order polynomial of the direction.
Vec3f soft_color(Vec3f d) { return {0.5f + 0.4f * d.x * d.y, 0.5f + 0.3f * d.z, 0.5f + 0.4f * d.y * d.z * d.x}; }
ImageColor soft_equirect(EquirectSize size) {
    ImageColor out(size.width, size.height);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) out.at(x, y) = soft_color(direction_of_pixel(x, y, size));
    return out;
}

TEST(Sphere, AxesLieWhereTheConventionSays) {
    const EquirectSize size{64, 32};
    const Vec2f center = pixel_of_direction(Vec3f{0, 0, 1}, size), right = pixel_of_direction(Vec3f{1, 0, 0}, size);
    EXPECT_FLOAT_EQ(center.x, 32);
    EXPECT_FLOAT_EQ(center.y, 16);
    EXPECT_FLOAT_EQ(right.x, 48);
    EXPECT_FLOAT_EQ(pixel_of_direction(Vec3f{0, -1, 0}, size).y, 0);
    EXPECT_FLOAT_EQ(pixel_of_direction(Vec3f{0, 1, 0}, size).y, 32);
}

TEST(Sphere, PixelAndDirectionUndoEachOther) {
    Random r(1, "sphere");
    for (int i = 0; i < 2000; ++i) {
        const Vec3f d = random_direction(r);
        EXPECT_LT(length(direction_at(pixel_of_direction(d, kSize), kSize) - d), 2e-6f);
    }
    EXPECT_LT(length(direction_at(Vec2f{0, 77.f}, kSize) - direction_at(Vec2f{512, 77.f}, kSize)), 1e-6f);
    EXPECT_EQ(wrap_column(-1, 512), 511);
    EXPECT_EQ(wrap_column(1025, 512), 1);
}

TEST(Sphere, PixelsCoverTheSphereOnce) {
    double sum = 0;
    for (int y = 0; y < kSize.height; ++y) sum += pixel_solid_angle(y, kSize) * kSize.width;
    EXPECT_NEAR(sum, 4 * std::numbers::pi, 1e-9);
}

TEST(Reproject, SamplingKnowsTheSeamAndThePoles) {
    const ImageColor picture = soft_equirect(kSize);
    Random r(2, "reproject");
    for (int i = 0; i < 2000; ++i) {
        Vec3f d = random_direction(r);
        if (i % 3 == 0) d = normalize(Vec3f{0.01f * d.x, d.y, 0.01f * d.z});  // near the poles
        if (i % 3 == 1) d = normalize(Vec3f{0.003f * d.x, d.y, -1});          // near the seam
        EXPECT_LT(length(sample_equirect(picture, pixel_of_direction(d, kSize)) - soft_color(d)), 2e-3f);
    }
}

TEST(Cubemap, RoundTripKeepsSoftPictures) {
    const ImageColor picture = soft_equirect(kSize);
    for (const float fov : {90.f, 104.f}) {
        const Pinhole camera = Pinhole::with_fov(192, 192, fov);
        std::array<ImageColor, 6> faces;
        for (const CubeFace face : kCubeFaces)
            faces[static_cast<std::size_t>(face)] = face_from_equirect(picture, face, camera);
        const ImageColor back = equirect_from_faces(faces, camera, kSize);
        EXPECT_LT(greatest_difference(back, picture), 0.0056f);  // 45 dB everywhere
    }
}

TEST(Cubemap, FacesLookWhereTheirNamesSay) {
    const auto axis = [](CubeFace f) { return pano_from_face(f) * Vec3f{0, 0, 1}; };
    EXPECT_EQ(axis(CubeFace::front), (Vec3f{0, 0, 1}));
    EXPECT_EQ(axis(CubeFace::right), (Vec3f{1, 0, 0}));
    EXPECT_EQ(axis(CubeFace::up), (Vec3f{0, -1, 0}));
    EXPECT_EQ(axis(CubeFace::down), (Vec3f{0, 1, 0}));
    for (const CubeFace f : kCubeFaces) {
        const Mat3f m = pano_from_face(f);
        EXPECT_EQ(cross(m.column(0), m.column(1)), m.column(2)) << name_of(f);  // no reflections
        EXPECT_EQ(face_of_direction(axis(f)), f);
    }
}

TEST(Reproject, ShrinkingAveragesInsteadOfSkipping) {
    ImageColor stripes(1024, 512);
    for (int y = 0; y < 512; ++y)
        for (int x = 0; x < 1024; ++x) stripes.at(x, y) = (x & 1) ? Vec3f{1, 1, 1} : Vec3f{};
    const ImageColor small = equirect_from_equirect(stripes, {64, 32});
    for (const Vec3f& c : small.pixels) EXPECT_NEAR(c.x, 0.5f, 0.02f);
}

TEST(RangeEdges, SlantedPlanesHoldTogetherAndJumpsAreCut) {
    // A floor 1.4 m below, to the horizon at 40 m; in front a pillar at 2 m.
    ImageF range(512, 256, 40.f);
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 512; ++x) {
            const Vec3f d = direction_of_pixel(x, y, kSize);
            if (d.y > 0) range.at(x, y) = std::min(40.f, 1.4f / d.y);
            if (x >= 200 && x < 210) range.at(x, y) = std::min(range.at(x, y), 2.f);
        }
    const ImageMask cuts = range_edges(range);
    for (int y = 140; y < 250; ++y) {
        EXPECT_EQ(cuts.at(300, y) & (kCutRight | kCutDown), 0) << y;
        if (range.at(300, y) > 2.5f) {
            EXPECT_TRUE(cuts.at(199, y) & kCutRight);
            EXPECT_TRUE(cuts.at(199, y) & kFarSide);
            EXPECT_TRUE(cuts.at(200, y) & kNearSide);
        }
    }
}

}  // namespace
}  // namespace fastscene

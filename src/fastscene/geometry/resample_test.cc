#include "fastscene/geometry/resample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "fastscene/base/parallel.h"
#include "fastscene/base/random.h"
#include "fastscene/geometry/test_pictures.h"

namespace fastscene {
namespace {

// A band-limited picture: spherical waves of a few cycles per turn.
Vec3f wavy_color(Vec3f d) {
    return {0.5f + 0.3f * std::sin(5 * d.x + 2 * d.y) * std::cos(4 * d.z), 0.5f + 0.4f * std::sin(6 * d.z + d.x),
            0.5f + 0.4f * d.y * std::cos(7 * d.x)};
}
ImageColor painted(const SpherePicture& p) {
    ImageColor out(p.width, p.height);
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x) {
            const Vec2f at{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
            Vec3f d;
            if (p.kind == SpherePicture::Kind::equirect) d = direction_at(at, EquirectSize{p.width, p.height});
            else if (p.kind == SpherePicture::Kind::perspective) d = p.camera.direction_at(at);
            else {
                const int face = y / p.width;
                d = pano_from_face(kCubeFaces[static_cast<std::size_t>(face)]) *
                    p.camera.direction_at({at.x, at.y - static_cast<float>(face * p.width)});
            }
            out.at(x, y) = wavy_color(p.world_from_picture * normalize(d));
        }
    return out;
}
double psnr_between(const ImageColor& a, const ImageColor& b, const ImageMask* mask = nullptr) {
    double sum = 0;
    std::int64_t n = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (mask && !mask->pixels[i]) continue;
        const Vec3f d = a.pixels[i] - b.pixels[i];
        sum += static_cast<double>(dot(d, d)) / 3;
        ++n;
    }
    return -10 * std::log10(sum / static_cast<double>(n) + 1e-20);
}
const Mat3f kTilted = rotation_about(normalize(Vec3f{1, 2, -0.5f}), 1.1f);

TEST(Resample, EveryKindFromEveryOther) {
    const SpherePicture pictures[] = {equirect_picture({192, 96}), equirect_picture({180, 90}, kTilted),
                                      cube_picture(56), cube_picture(70, 100, kTilted),
                                      perspective_picture(Pinhole::with_fov(90, 60, 80), kTilted)};
    for (const SpherePicture& source : pictures)
        for (const SpherePicture& target : pictures)
            for (const Filter filter : {Filter::bilinear, Filter::bicubic, Filter::area}) {
                const ResamplePlan plan(source, target, filter);
                const ImageMask covered = plan.covered();
                if (source.kind != SpherePicture::Kind::perspective) {
                    EXPECT_EQ(std::count(covered.pixels.begin(), covered.pixels.end(), 0), 0);
                }
                EXPECT_GT(psnr_between(plan.apply(painted(source)), painted(target), &covered),
                          filter == Filter::bicubic ? 45 : 36)
                    << static_cast<int>(source.kind) << ' ' << static_cast<int>(target.kind) << ' '
                    << static_cast<int>(filter);
            }
}

TEST(Resample, RoundTripThroughTheCubeKeepsBandLimitedPictures) {
    for (const auto& [width, face, fov] : {std::tuple{512, 128, 90.f}, {512, 150, 104.f}, {300, 100, 100.f}})
        for (const float feather : {0.f, 4.f}) {
            if (feather > 0 && fov == 90.f) continue;
            const SpherePicture pano = equirect_picture({width, width / 2}), cube = cube_picture(face, fov);
            const ImageColor picture = painted(pano);
            for (const Filter filter : {Filter::bilinear, Filter::bicubic}) {
                const ImageColor back = ResamplePlan(cube, pano, filter, feather)
                                            .apply(ResamplePlan(pano, cube, filter).apply(picture));
                EXPECT_GT(psnr_between(back, picture), 45) << width << ' ' << face << ' ' << feather;
                EXPECT_LT(greatest_difference(back, picture), 0.02f);  // including seams, corners and poles
            }
        }
}

TEST(Resample, SeamAndPolesAreExact) {
    const SpherePicture source = equirect_picture({256, 128});
    const ImageColor picture = painted(source);
    // A camera facing the seam, and one at each pole.
    for (const Vec3f forward : {Vec3f{0, 0, -1}, Vec3f{0, 1, 0}, Vec3f{0, -1, 0}}) {
        const Vec3f right = std::fabs(forward.y) > 0.5f ? Vec3f{1, 0, 0} : Vec3f{-1, 0, 0};
        const SpherePicture view = perspective_picture(Pinhole::with_fov(120, 120, 30),
                                                       Mat3f::from_columns(right, cross(forward, right), forward));
        EXPECT_LT(greatest_difference(ResamplePlan(source, view, Filter::bicubic).apply(picture), painted(view)),
                  0.004f);
    }
    // Identity: same size and orientation.
    EXPECT_LT(greatest_difference(ResamplePlan(source, source, Filter::bicubic).apply(picture), picture), 2e-4f);
}

TEST(Resample, ShrinkingNeverSkips) {
    ImageColor stripes(1024, 512);
    for (int y = 0; y < 512; ++y)
        for (int x = 0; x < 1024; ++x) stripes.at(x, y) = ((x ^ y) & 1) ? Vec3f{1, 1, 1} : Vec3f{};
    const SpherePicture pano = equirect_picture({1024, 512});
    for (const SpherePicture& target : {equirect_picture({64, 32}), equirect_picture({100, 50}), cube_picture(24),
                                        perspective_picture(Pinhole::with_fov(30, 20, 90))})
        for (const Filter filter : {Filter::bilinear, Filter::bicubic, Filter::area})
            for (const Vec3f& c : ResamplePlan(pano, target, filter).apply(stripes).pixels)
                ASSERT_NEAR(c.x, 0.5f, 0.1f) << static_cast<int>(filter);
    // Integer factors are plain means.
    Random r(3, "resample");
    ImageColor noise(128, 64);
    for (Vec3f& c : noise.pixels) c = {r.uniform(), r.uniform(), r.uniform()};
    const ImageColor small = ResamplePlan(equirect_picture({128, 64}), equirect_picture({32, 16}), Filter::area)
                                 .apply(noise);
    for (int y = 4; y < 12; ++y)
        for (int x = 0; x < 32; ++x) {
            Vec3f mean;
            for (int j = 0; j < 4; ++j)
                for (int i = 0; i < 4; ++i) mean += noise.at(4 * x + i, 4 * y + j) / 16.f;
            EXPECT_LT(length(small.at(x, y) - mean), 0.02f);
        }
}

TEST(Resample, AnySizeMakesAnyOther) {
    const auto pictures = [] {
        std::vector<SpherePicture> out;
        for (const EquirectSize size : {EquirectSize{1, 1}, {3, 2}, {17, 9}, {60, 11}, {5, 34}})
            out.push_back(equirect_picture(size, kTilted));
        for (const int face : {1, 2, 9}) out.push_back(cube_picture(face, face == 2 ? 90.f : 120.f));
        out.push_back(perspective_picture(Pinhole::with_fov(9, 7, 179.5f)));
        return out;
    }();
    for (const SpherePicture& source : pictures)
        for (const SpherePicture& target : pictures)
            for (const Filter filter : {Filter::bilinear, Filter::bicubic, Filter::point, Filter::area}) {
                const ResamplePlan plan(source, target, filter,
                                        source.camera.fx > 0 && filter == Filter::bilinear ? 5.f : 0.f);
                const ImageMask covered = plan.covered();
                const ImageColor out = plan.apply(ImageColor(source.width, source.height, Vec3f{0.25f, 0.5f, 1.f}));
                for (std::size_t i = 0; i < out.size(); ++i)  // a uniform picture stays uniform
                    ASSERT_LT(length(out.pixels[i] - (covered.pixels[i] ? Vec3f{0.25f, 0.5f, 1.f} : Vec3f{})), 1e-4f)
                        << source.width << 'x' << source.height << " to " << target.width << 'x' << target.height
                        << " pixel " << i;
                if (source.kind == SpherePicture::Kind::perspective) continue;
                ASSERT_EQ(std::count(covered.pixels.begin(), covered.pixels.end(), 0), 0);
            }
}

TEST(Resample, BicubicNeighbourhoodsStayInThePicture) {
    // The identity of a rotated picture: positions lie on pixel centers but for rounding.
    const SpherePicture picture = equirect_picture({17, 9}, kTilted);
    const ResamplePlan plan(picture, picture, Filter::bicubic);
    int inner = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const Vec2f at = plan.place(x, y);
            if (std::isnan(at.x)) continue;  // taps of its own
            ++inner;
            EXPECT_TRUE(at.x >= 1.5f && at.y >= 1.5f && at.x < 15.5f && at.y < 7.5f) << x << ' ' << y;
        }
    EXPECT_GT(inner, 0);
}

TEST(Resample, WholeFactorsArePlainMeansAtThePolesToo) {
    Random r(5, "resample");
    for (const auto& [across, down] : {std::pair{2, 2}, {4, 4}, {3, 3}, {5, 2}, {1, 3}, {8, 1}, {40, 20}, {70, 70}}) {
        const EquirectSize small{12, 6}, large{small.width * across, small.height * down};
        ImageColor noise(large.width, large.height);
        for (Vec3f& c : noise.pixels) c = {r.uniform(), r.uniform(), r.uniform()};
        const ImageColor out = ResamplePlan(equirect_picture(large), equirect_picture(small), Filter::area)
                                   .apply(noise);
        for (int y = 0; y < small.height; ++y)
            for (int x = 0; x < small.width; ++x) {
                Vec3d mean{};
                for (int j = 0; j < down; ++j)
                    for (int i = 0; i < across; ++i) {
                        const Vec3f c = noise.at(across * x + i, down * y + j);
                        mean = mean + Vec3d{c.x, c.y, c.z} / static_cast<double>(across * down);
                    }
                const Vec3f m{static_cast<float>(mean.x), static_cast<float>(mean.y), static_cast<float>(mean.z)};
                ASSERT_LT(length(out.at(x, y) - m), 0.02f) << across << 'x' << down << ": " << x << ", " << y;
            }
    }
}

// Stripes one pixel wide must be averaged out by any downscaling, also near the poles.
TEST(Resample, ShrinkingSkipsNoColumns) {
    for (const EquirectSize size : {EquirectSize{400, 200}, {700, 60}, {150, 300}}) {
        ImageColor stripes(size.width, size.height);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) stripes.at(x, y) = x & 1 ? Vec3f{1, 1, 1} : Vec3f{};
        for (const SpherePicture& target :
             {equirect_picture({40, 20}), equirect_picture({33, 9}), cube_picture(9), equirect_picture({3, 2})})
            for (const Filter filter : {Filter::bilinear, Filter::bicubic, Filter::area}) {
                const ImageColor out = ResamplePlan(equirect_picture(size), target, filter).apply(stripes);
                for (std::size_t i = 0; i < out.size(); ++i)
                    ASSERT_NEAR(out.pixels[i].x, 0.5f, 0.2f)
                        << size.width << 'x' << size.height << " to " << target.width << 'x' << target.height
                        << ", filter " << static_cast<int>(filter) << ", pixel " << i;
            }
    }
}

TEST(Resample, OddColumnsGoOnOverThePoleToo) {
    for (const float down : {-1.f, 1.f}) {
        const SpherePicture view = perspective_picture(Pinhole::with_fov(60, 60, 8),
                                                       Mat3f::from_columns({1, 0, 0}, {0, 0, -down}, {0, down, 0}));
        for (const int width : {200, 201}) {
            const SpherePicture source = equirect_picture({width, 100});
            EXPECT_LT(
                greatest_difference(ResamplePlan(source, view, Filter::bilinear).apply(painted(source)), painted(view)),
                0.004f)
                << width;
        }
    }
}

TEST(Resample, TheSkyOfARangeMapStaysTheSky) {
    const float sky = std::numeric_limits<float>::infinity();
    ImageF range(64, 32, 3.f);
    for (int y = 0; y < 11; ++y)
        for (int x = 0; x < 64; ++x) range.at(x, y) = sky;
    range.at(20, 25) = std::nanf("");
    for (const SpherePicture& target :
         {equirect_picture({64, 32}), equirect_picture({90, 45}, kTilted), equirect_picture({16, 8}), cube_picture(20)})
        for (const Filter filter : {Filter::bilinear, Filter::bicubic, Filter::area}) {
            std::size_t skies = 0, unknown = 0;
            const ImageF out = ResamplePlan(equirect_picture({64, 32}), target, filter).apply(range);
            for (const float r : out.pixels) {
                skies += r == sky;
                unknown += std::isnan(r);
                ASSERT_TRUE(!std::isfinite(r) || std::fabs(r - 3.f) < 1e-4f) << r;
            }
            EXPECT_GT(skies, out.size() / 5);
            EXPECT_LT(skies, out.size() / 2);
            EXPECT_LE(unknown, 4u);  // one pixel's worth, not its whole neighbourhood
        }
    EXPECT_TRUE(std::isnan(ResamplePlan(equirect_picture({64, 32}), equirect_picture({64, 32}), Filter::bilinear)
                               .apply(range)
                               .at(20, 25)));
}

TEST(Resample, CamerasThatCannotBeAreRefused) {
    const SpherePicture pano = equirect_picture({64, 32});
    EXPECT_THROW(ResamplePlan(pano, perspective_picture(Pinhole::with_fov(20, 20, 180)), Filter::bilinear),
                 CheckFailed);
    EXPECT_THROW(ResamplePlan(perspective_picture(Pinhole::with_fov(20, 20, 200)), pano, Filter::bilinear),
                 CheckFailed);
    EXPECT_THROW(ResamplePlan(cube_picture(20, 80), pano, Filter::bilinear), CheckFailed);  // would leave gaps
    EXPECT_THROW(ResamplePlan(pano, pano, Filter::bilinear).apply(ImageColor(32, 16)), CheckFailed);
}

TEST(Resample, FeatheringBlendsWhereFacesDisagree) {
    const SpherePicture cube = cube_picture(100, 110), pano = equirect_picture({400, 200});
    ImageColor faces(cube.width, cube.height);
    for (int y = 0; y < faces.height; ++y)
        for (int x = 0; x < faces.width; ++x)
            faces.at(x, y) = Vec3f{1, 1, 1} * (static_cast<float>(y / 100) / 5.f);  // a different gray for each face
    const auto steepest = [&](float feather) {
        const ImageColor out = ResamplePlan(cube, pano, Filter::bilinear, feather).apply(faces);
        float most = 0;
        for (int x = 0; x + 1 < out.width; ++x)
            most = std::max(most, std::fabs(out.at(x + 1, 100).x - out.at(x, 100).x));
        return most;
    };
    EXPECT_GT(steepest(0), 0.15f);
    EXPECT_LT(steepest(8), 0.1f);
}

TEST(Resample, RangeMapsToo) {
    ImageF range(64, 32, 3.f);
    for (const float r :
         ResamplePlan(equirect_picture({64, 32}), cube_picture(20), Filter::bilinear).apply(range).pixels)
        ASSERT_NEAR(r, 3.f, 1e-5f);
}

TEST(Resample, SameBytesForAnyNumberOfThreads) {
    const SpherePicture pano = equirect_picture({200, 100}), cube = cube_picture(70);
    const ImageColor picture = painted(pano);
    set_threads(1);
    const ImageColor one = ResamplePlan(pano, cube, Filter::bilinear).apply(picture);
    set_threads(3);
    const ImageColor three = ResamplePlan(pano, cube, Filter::bilinear).apply(picture);
    set_threads(0);
    EXPECT_EQ(one, three);
}

}  // namespace
}  // namespace fastscene

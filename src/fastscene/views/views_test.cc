#include "fastscene/views/views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "fastscene/geometry/sphere.h"
#include "fastscene/image/color.h"
#include "fastscene/scene/synthetic.h"
#include "fastscene/views/points.h"

namespace fastscene {
namespace {

constexpr EquirectSize kSize{512, 256};

SyntheticWorld room() { return SyntheticWorld::furnished(SyntheticPaint::smooth, SyntheticPaint::smooth); }
ViewsParams small_params() {
    ViewsParams params;
    params.size = 64;
    params.points = 5000;
    return params;
}

TEST(Views, CoverTheWholeSphereAndShowTheRoom) {
    const ViewSet set = project_views({render_synthetic(room(), {}, kSize, 1)}, small_params(), {});
    ASSERT_EQ(set.views.size(), 14u);
    std::set<std::string> names;
    for (const View& view : set.views) {
        names.insert(view.name);
        EXPECT_TRUE(view.weight.empty());
        const Mat3f& m = view.world_from_camera.rotation;
        EXPECT_LT(length(cross(m.column(0), m.column(1)) - m.column(2)), 1e-5f);
        double error = 0;
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) {
                const Vec3f d = normalize(
                    m * view.camera.direction_at({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}));
                const Rgb8 wanted = srgb8_from_linear(trace_synthetic(room(), {}, d).color);
                error += std::abs(wanted.g - view.color.at(x, y).g);
            }
        EXPECT_LT(error / (64 * 64), 2.5) << view.name;
    }
    EXPECT_EQ(names.size(), 14u);
    EXPECT_EQ(*names.begin(), "000_00.png");
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x) {
            const Vec3f d = direction_of_pixel(x, y, {64, 32});
            EXPECT_TRUE(std::any_of(set.views.begin(), set.views.end(), [&](const View& view) {
                const auto at = view.camera.project(transpose(view.world_from_camera.rotation) * d);
                return at && at->x >= 0 && at->x <= 64 && at->y >= 0 && at->y <= 64;
            }));
        }
}

// Stripes four columns wide at the panorama's own scale: bilinear resampling is off by 18 of 255, which the splats
// would learn.
TEST(Views, FineStripesStaySharp) {
    const auto stripes = [](float column) { return 0.5f + 0.4f * std::sin(0.5f * std::numbers::pi_v<float> * column); };
    Panorama panorama = render_synthetic(room(), {}, kSize, 1);
    for (int y = 0; y < kSize.height; ++y)
        for (int x = 0; x < kSize.width; ++x) {
            const float v = linear_from_srgb(stripes(static_cast<float>(x) + 0.5f));
            panorama.color.at(x, y) = {v, v, v};
        }
    ViewsParams params = small_params();
    params.size = 163;  // 512 columns per turn are 81.5 per radian
    const ViewSet set = project_views({panorama}, params, {});
    double squares = 0, count = 0;
    const View& front = set.views[0];
    for (int y = 70; y < 93; ++y)
        for (int x = 50; x < 113; ++x) {
            const Vec3f d = front.world_from_camera.rotation *
                            front.camera.direction_at({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
            const double off = static_cast<double>(front.color.at(x, y).g) -
                               255 * static_cast<double>(stripes(pixel_of_direction(d, kSize).x));
            squares += off * off;
            ++count;
        }
    RecordProperty("rms", fmt::format("{:.2f}", std::sqrt(squares / count)));
    EXPECT_LT(std::sqrt(squares / count), 9);
}

TEST(Views, InventedPixelsCountLess) {
    Panorama panorama = render_synthetic(room(), {0.2f, 0, 0}, kSize, 1);
    panorama.known = Image<Known>(kSize.width, kSize.height, Known::invented);
    const ViewsParams params = small_params();
    const ViewSet set = project_views({render_synthetic(room(), {}, kSize, 1), panorama}, params, {});
    ASSERT_EQ(set.views.size(), 28u);
    EXPECT_TRUE(set.views[0].weight.empty());
    for (const std::uint8_t w : set.views[14].weight.pixels) EXPECT_LE(w, params.weight_invented);
}

TEST(Points, LieOnTheSurfacesTheyName) {
    const ViewSet set = project_views({render_synthetic(room(), {}, kSize, 1)}, small_params(), {});
    EXPECT_NEAR(static_cast<double>(set.points.size()), 5000, 10);
    double area = 0;
    for (const SurfacePoint& p : set.points) {
        const Vec3f d = normalize(p.position_m);
        EXPECT_NEAR(trace_synthetic(room(), {}, d).range, length(p.position_m), 0.02f * length(p.position_m));
        EXPECT_NEAR(length(p.normal), 1, 1e-4);
        EXPECT_LT(dot(p.normal, d), 0);
        area += static_cast<double>(p.radius_m * p.radius_m);
    }
    // The sum of squared spacings is the visible surface: about that of the room.
    EXPECT_GT(area, 60);
    EXPECT_LT(area, 140);
}

// A surface seen by two panoramas is sampled once: their points together cover no more than the room, and each surface
// comes from the nearer panorama.
TEST(Points, OfOverlappingPanoramasComeFromTheFinestView) {
    const Vec3f aside{1.2f, 0, -1.f};
    const std::vector<Panorama> both{render_synthetic(room(), {}, kSize, 1), render_synthetic(room(), aside, kSize, 1)};
    const auto area = [](const ViewSet& set) {
        double sum = 0;
        for (const SurfacePoint& p : set.points) sum += static_cast<double>(p.radius_m * p.radius_m);
        return sum;
    };
    const double one = area(project_views({both[0]}, small_params(), {})),
                 two = area(project_views(both, small_params(), {}));
    EXPECT_GT(two, 0.98 * one);
    EXPECT_LT(two, 1.35 * one) << "what only one of them sees comes on top";
}

TEST(Points, ABackdropClosesTheSphereBehindEverything) {
    ViewsParams params = small_params();
    params.backdrop = 500;
    const ViewSet set = project_views({render_synthetic(room(), {}, kSize, 1)}, params, {});
    const ViewSet without = project_views({render_synthetic(room(), {}, kSize, 1)}, small_params(), {});
    ASSERT_EQ(set.points.size(), without.points.size() + 500);
    for (int i = 0; i < 200; ++i) {
        const Vec3f d = direction_of_pixel(i * 37 % 64, i * 11 % 32, {64, 32});
        float nearest = -1;
        for (std::size_t k = without.points.size(); k < set.points.size(); ++k) {
            const SurfacePoint& p = set.points[k];
            EXPECT_GT(length(p.position_m), 300.f);
            nearest = std::max(nearest, dot(normalize(p.position_m), d));
        }
        EXPECT_GT(nearest, std::cos(0.16f)) << "a gap in the backdrop";
    }
}

TEST(Points, TheBackdropShowsTheOutsideWhereItIsKnown) {
    const std::vector<Panorama> panoramas{render_synthetic(room(), {}, kSize, 1)};
    const Vec3f green{0, 1, 0};
    Outside outside{ImageColor(64, 32, green), ImageMask(64, 32, 0)};
    for (int y = 16; y < 32; ++y)
        for (int x = 0; x < 64; ++x) outside.seen.at(x, y) = 255;  // the lower half; y points down
    for (const SurfacePoint& p : backdrop_points(panoramas, 6000, &outside)) {
        const float elevation = std::asin(normalize(p.position_m).y);
        if (elevation > 0) EXPECT_EQ(p.color, srgb8_from_linear(green));
        if (elevation < -0.3f) EXPECT_NE(p.color, srgb8_from_linear(green)) << "nobody can look there";
    }
}

int of_color(const ViewSet& set, Rgb8 color) {
    return static_cast<int>(
        std::count_if(set.points.begin(), set.points.end(), [&](const SurfacePoint& p) { return p.color == color; }));
}

TEST(Points, ComeFromEveryGivenPanorama) {
    const Panorama first = render_synthetic(room(), {}, kSize, 1);
    Panorama second = render_synthetic(room(), {0.4f, 0, 0}, kSize, 1);
    std::fill(second.color.pixels.begin(), second.color.pixels.end(), Vec3f{1, 0, 0});
    second.known = Image<Known>(kSize.width, kSize.height, Known::original);
    EXPECT_GT(of_color(project_views({first, second}, small_params(), {}), {255, 0, 0}), 1000);
    second.known.at(3, 3) = Known::carried;  // walked: repeats what the first has seen
    EXPECT_EQ(of_color(project_views({first, second}, small_params(), {}), {255, 0, 0}), 0);
}

// A strip of the outside next to a window frame, visible past it for the first time.
TEST(Points, NarrowPaintedStripsHaveTheirOwn) {
    const Panorama first = render_synthetic(room(), {}, kSize, 1);
    Panorama walked = first;
    walked.known = Image<Known>(kSize.width, kSize.height, Known::carried);
    for (int y = kSize.height / 4; y < kSize.height * 3 / 4; ++y) {
        walked.known.at(20, y) = Known::invented;
        walked.range.at(20, y) = std::numeric_limits<float>::infinity();
        walked.color.at(20, y) = {0, 1, 0};
    }
    EXPECT_GT(of_color(project_views({first, walked}, small_params(), {}), {0, 255, 0}), 2);
}

// Windows: a twentieth of the sphere, but distant, so they used to take half of all points, many at the same position.
TEST(Points, TheOutsideHasPointsByItsSolidAngleWhateverTheRoomHas) {
    Panorama panorama = render_synthetic(room(), {}, kSize, 1);
    double square_degrees = 0;
    for (int y = kSize.height * 3 / 8; y < kSize.height * 5 / 8; ++y)
        for (int x = 0; x < kSize.width / 8; ++x) {
            panorama.range.at(x, y) = std::numeric_limits<float>::infinity();
            square_degrees += pixel_solid_angle(y, kSize) * 180 * 180 / (std::numbers::pi * std::numbers::pi);
        }
    const auto far_points = [&](int points, int most) {
        ViewsParams params = small_params();
        params.points = points, params.outside_density = 1, params.outside_points = most;
        int far = 0;
        for (const SurfacePoint& p : project_views({panorama}, params, {}).points) far += length(p.position_m) > 20;
        return far;
    };
    // Some continue behind the edges of the opening.
    EXPECT_GT(far_points(1000, 100'000), square_degrees);
    EXPECT_LT(far_points(1000, 100'000), 1.6 * square_degrees);
    EXPECT_NEAR(far_points(20'000, 100'000), far_points(1000, 100'000), 10);
    EXPECT_NEAR(far_points(1000, 500), 500, 10);
}

// A step sideways reveals what a frame hid; it must not be black.
TEST(Points, TheOutsideGoesOnBehindFrames) {
    Panorama panorama = render_synthetic(room(), {}, kSize, 1);
    for (int y = kSize.height * 3 / 8; y < kSize.height * 5 / 8; ++y)
        for (int x = 0; x < kSize.width / 8; ++x) {
            const bool frame = x > 30 && x < 35;
            panorama.range.at(x, y) = frame ? 2.f : std::numeric_limits<float>::infinity();
            panorama.color.at(x, y) = frame ? Vec3f{0.01f, 0.01f, 0.01f} : Vec3f{0.3f, 0.5f, 0.9f};
        }
    int behind = 0;
    ViewsParams params = small_params();
    params.points = 40000;
    for (const SurfacePoint& p : project_views({panorama}, params, {}).points) {
        if (length(p.position_m) < 300) continue;
        const Vec2f at = pixel_of_direction(p.position_m, kSize);
        behind += at.x > 31 && at.x < 35 && std::fabs(at.y - 0.5f * kSize.height) < 0.1f * kSize.height;
        EXPECT_GT(p.color.b, p.color.r + 20);  // the sky's color, never the frame's or the wall's
    }
    EXPECT_GT(behind, 2);
}

// How far the outside continues behind a wall depends on how far a step shifts the wall.
TEST(Points, NearWallsHideMoreOfTheOutsideThanFarOnes) {
    const auto points_behind = [](float wall_m) {
        Panorama panorama = render_synthetic(room(), {}, kSize, 1);
        std::fill(panorama.range.pixels.begin(), panorama.range.pixels.end(), wall_m);
        for (int y = kSize.height * 7 / 16; y < kSize.height * 9 / 16; ++y)
            for (int x = 0; x < kSize.width / 16; ++x) panorama.range.at(x, y) = std::numeric_limits<float>::infinity();
        ViewsParams params = small_params();
        params.points = 40000;
        std::array<int, 2> counts{};  // 8 to 28 degrees above the window, and beyond
        for (const SurfacePoint& p : project_views({panorama}, params, {}).points) {
            if (length(p.position_m) < 300) continue;
            const Vec2f at = pixel_of_direction(p.position_m, kSize);
            const float above = 180 * (static_cast<float>(kSize.height * 7 / 16) - at.y) /
                                static_cast<float>(kSize.height);
            if (at.x < 0 || at.x > static_cast<float>(kSize.width) / 16) continue;
            counts[above < 28 ? 0 : 1] += above > 8;
        }
        return counts;
    };
    const auto near = points_behind(2.f), far = points_behind(8.f);
    EXPECT_GT(near[0], 3);
    EXPECT_LE(near[1], 2) << "a step of a metre moves a wall 2 m away by 27 degrees";
    EXPECT_EQ(far[0] + far[1], 0);
}

TEST(Points, NothingStandsBehindTheSky) {
    const Panorama first = render_synthetic(room(), {}, kSize, 1);
    Panorama walked = first;
    walked.known = Image<Known>(kSize.width, kSize.height, Known::invented);
    for (float& r : walked.range.pixels) r = 2569.f;
    for (const SurfacePoint& p : project_views({first, walked}, small_params(), {}).points)
        EXPECT_LE(length(p.position_m), 400.1f);
}

// The sky has no parallax: half a metre sideways must not move it by a pixel of a 2048 column panorama.
TEST(Points, SkyStandsTooFarToMove) {
    Panorama panorama = render_synthetic(room(), {}, {64, 32}, 1);
    for (float& r : panorama.range.pixels) r = std::numeric_limits<float>::infinity();
    for (const SurfacePoint& p : project_views({panorama}, small_params(), {}).points) {
        EXPECT_LT(0.5f / length(p.position_m), 0.5f * 2 * std::numbers::pi_v<float> / 2048);
        EXPECT_LT(length(p.position_m), 990);  // viewers clip at a thousand metres
    }
}

// A cube of 4 m with a dark upright joint, one pixel wide, in the wall ahead.
Panorama jointed_room(float deep_m) {
    Panorama out;
    out.color = ImageColor(kSize.width, kSize.height);
    out.range = ImageF(kSize.width, kSize.height);
    const int joint = kSize.width / 2 + 20;
    for (int y = 0; y < kSize.height; ++y)
        for (int x = 0; x < kSize.width; ++x) {
            const Vec3f d = direction_of_pixel(x, y, kSize);
            const float most = std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
            const bool in_joint = x == joint && d.z == most;
            out.range.at(x, y) = (in_joint ? 2 + deep_m : 2.f) / most;
            out.color.at(x, y) = in_joint ? Vec3f{0.02f, 0.02f, 0.02f} : Vec3f{0.6f, 0.6f, 0.6f};
        }
    return out;
}

// A narrow joint is a line on the wall: its points lie on the wall, face as it does, and are aligned with the joint.
TEST(Points, AJointIsALineOnItsWall) {
    ViewsParams params = small_params();
    params.points = 40000;
    for (const float deep_m : {0.004f, 0.05f}) {
        int found = 0;
        for (const SurfacePoint& p : sample_points({jointed_room(deep_m)}, params, {})) {
            if (!(p.position_m.z > 1.9f) || std::fabs(p.position_m.y) > 1.8f || p.color.g > 80) continue;
            ++found;
            EXPECT_NEAR(p.position_m.z, 2, 2e-3f);
            EXPECT_LT(p.normal.z, -0.99f);
            EXPECT_GT(std::fabs(p.edge.y), 0.8f);
        }
        EXPECT_GT(found, 40) << deep_m;
    }
    // A deep gap shows something else behind, in mixed colors.
    for (const SurfacePoint& p : sample_points({jointed_room(0.5f)}, params, {})) {
        EXPECT_GT(p.color.g, 80);
    }
}

}  // namespace
}  // namespace fastscene

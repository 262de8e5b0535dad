#include "fastscene/walk/walk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "fastscene/base/parallel.h"
#include "fastscene/base/random.h"
#include "fastscene/geometry/grown.h"
#include "fastscene/image/color.h"
#include "fastscene/image/ssim.h"
#include "fastscene/io/image_io.h"
#include "fastscene/scene/synthetic.h"
#include "fastscene/walk/coarse_view.h"
#include "fastscene/walk/openings.h"
#include "fastscene/walk/repeats.h"

namespace fastscene {
namespace {

constexpr EquirectSize kSize{512, 256};
const Vec3f kElsewhere{0.35f, -0.15f, 0.25f};

WarpSource source_of(const Panorama& p) {
    return make_warp_source(p.color, p.range, {}, {}, p.world_from_pano.translation);
}

// Nonzero where a window of +-`reach` pixels contains a range edge.
ImageMask near_edges(const ImageF& range, int reach) {
    const ImageMask cuts = range_edges(range);
    ImageMask out(range.width, range.height);
    for (int y = 0; y < range.height; ++y)
        for (int x = 0; x < range.width; ++x)
            if (cuts.at(x, y) & (kFarSide | kNearSide))
                for (int j = std::max(0, y - reach); j <= std::min(range.height - 1, y + reach); ++j)
                    for (int i = x - reach; i <= x + reach; ++i) out.at(wrap_column(i, range.width), j) = 1;
    return out;
}

// Pixels of a true panorama at `position` whose surface is hidden from the origin.
ImageMask true_holes(const SyntheticWorld& world, const Panorama& truth, Vec3f position) {
    ImageMask out(truth.color.width, truth.color.height);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            const Vec3f p = position + direction_of_pixel(x, y, truth.size()) * truth.range.at(x, y);
            out.at(x, y) = trace_synthetic(world, {}, normalize(p)).range < length(p) * 0.995f - 0.003f;
        }
    return out;
}

double share_inside(const ImageMask& a, const ImageMask& b) {
    double all = 0, inside = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a.pixels[i]) {
            ++all;
            inside += b.pixels[i] != 0;
        }
    return all > 0 ? inside / all : 1;
}

TEST(CoarseView, AgreesWithTruthOnSmoothSurfaces) {
    const SyntheticWorld world = SyntheticWorld::furnished(SyntheticPaint::smooth, SyntheticPaint::smooth);
    const Panorama first = render_synthetic(world, {}, kSize), truth = render_synthetic(world, kElsewhere, kSize);
    const CoarseView view = coarse_view({source_of(first)}, kSize, kElsewhere);
    ImageMask counts = near_edges(truth.range, 2);
    for (std::size_t i = 0; i < counts.size(); ++i)
        counts.pixels[i] = !counts.pixels[i] && view.cover.pixels[i] == Cover::front;
    const double db = psnr(srgb8_from_linear(view.color), srgb8_from_linear(truth.color), counts);
    RecordProperty("psnr", std::to_string(db));
    EXPECT_GE(db, 38);
    std::vector<float> errors;
    for (std::size_t i = 0; i < counts.size(); ++i)
        if (counts.pixels[i])
            errors.push_back(std::fabs(view.range.pixels[i] - truth.range.pixels[i]) / truth.range.pixels[i]);
    std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(errors.size() * 99 / 100),
                     errors.end());
    EXPECT_LT(errors[errors.size() * 99 / 100], 0.01f);
}

TEST(CoarseView, HolesAreDisocclusions) {
    const SyntheticWorld world = SyntheticWorld::furnished(SyntheticPaint::plain, SyntheticPaint::plain);
    const Panorama first = render_synthetic(world, {}, kSize), truth = render_synthetic(world, kElsewhere, kSize);
    const CoarseView view = coarse_view({source_of(first)}, kSize, kElsewhere);
    ImageMask found(kSize.width, kSize.height);
    for (std::size_t i = 0; i < found.size(); ++i) found.pixels[i] = view.cover.pixels[i] != Cover::front;
    const ImageMask wanted = true_holes(world, truth, kElsewhere);
    EXPECT_GE(share_inside(found, grown(wanted, 1, true)), 0.95);  // precision
    EXPECT_GE(share_inside(wanted, grown(found, 1, true)), 0.95);  // recall
}

TEST(CoarseView, AnEmptyRoomHasNoHoleAnywhere) {
    SyntheticWorld world = SyntheticWorld::furnished(SyntheticPaint::plain, SyntheticPaint::plain);
    world.boxes.clear();
    const Panorama first = render_synthetic(world, {}, kSize, 1);
    for (const Vec3f position :
         {Vec3f{}, Vec3f{0.7f, 0, 0}, Vec3f{0, 0.6f, 0}, Vec3f{0, -0.6f, 0}, Vec3f{-0.4f, 0.3f, -0.9f}}) {
        const CoarseView view = coarse_view({source_of(first)}, kSize, position);
        EXPECT_EQ(std::count(view.cover.pixels.begin(), view.cover.pixels.end(), Cover::hole), 0)
            << position.x << ' ' << position.y << ' ' << position.z;
        EXPECT_EQ(std::count(view.cover.pixels.begin(), view.cover.pixels.end(), Cover::back), 0);
    }
}

TEST(CoarseView, PackedSourcesShowTheSame) {
    const SyntheticWorld world = SyntheticWorld::furnished(SyntheticPaint::smooth, SyntheticPaint::smooth);
    std::vector<WarpSource> sources;
    std::vector<PackedSource> packed;
    for (const Vec3f position : {Vec3f{}, Vec3f{0.2f, 0.1f, 0}}) {
        const Panorama first = render_synthetic(world, position, kSize, 1);
        ImageMask used(kSize.width, kSize.height);  // a few intervals per row, different for each picture
        std::size_t count = 0;
        for (int y = 0; y < kSize.height; ++y)
            for (int x = 0; x < kSize.width; ++x)
                count += used.at(x, y) = (x * 7 + y * 3) % 90 < (sources.empty() ? 50 : 20) || y == 0;
        Image<std::int16_t> plane(kSize.width, kSize.height);
        for (std::size_t i = 0; i < plane.size(); ++i) plane.pixels[i] = static_cast<std::int16_t>(i % 5);
        sources.push_back(make_warp_source(first.color, first.range, plane, used, position));
        packed.emplace_back(sources.back());
        EXPECT_EQ(packed.back().pixels(), count);
    }
    const CoarseView wanted = coarse_view(sources, kSize, kElsewhere), found = coarse_view(packed, kSize, kElsewhere);
    EXPECT_EQ(found.color.pixels, wanted.color.pixels);
    EXPECT_EQ(found.range.pixels, wanted.range.pixels);
    EXPECT_EQ(found.plane.pixels, wanted.plane.pixels);
    EXPECT_EQ(found.cover.pixels, wanted.cover.pixels);
    EXPECT_GT(std::count(found.cover.pixels.begin(), found.cover.pixels.end(), Cover::front),
              kSize.width * kSize.height / 4);
}

TEST(Viewpoints, StayInFreeSpaceNearEarlierOnes) {
    const SyntheticWorld world = SyntheticWorld::furnished(SyntheticPaint::plain, SyntheticPaint::plain);
    const Panorama first = render_synthetic(world, {}, kSize, 1);
    for (const int count : {0, 1, 5, 8, 14, 20}) {
        WalkParams params;
        params.viewpoints = count;
        const std::vector<Vec3f> points = choose_viewpoints(first, params);
        ASSERT_EQ(static_cast<int>(points.size()), count);
        for (std::size_t i = 0; i < points.size(); ++i) {
            EXPECT_LE(length(points[i]), params.reach_m * 1.001f);
            EXPECT_LE(length(points[i]),
                      params.clearance * trace_synthetic(world, {}, normalize(points[i])).range * 1.02f);
            float nearest = length(points[i]);
            for (std::size_t j = 0; j < i; ++j) nearest = std::min(nearest, length(points[i] - points[j]));
            EXPECT_LE(nearest, params.reach_m * 1.001f);
        }
    }
}

// Naive hole filling: extends the farther end of each row's gap.
ImageColor naive_fill(const CoarseView& view) {
    ImageColor out = view.color;
    const int w = out.width;
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < w; ++x) {
            if (view.cover.at(x, y) == Cover::front) continue;
            int left = x - 1, right = x + 1;
            while (left > x - w && view.cover.at(wrap_column(left, w), y) != Cover::front) --left;
            while (right < x + w && view.cover.at(wrap_column(right, w), y) != Cover::front) ++right;
            const int a = wrap_column(left, w), b = wrap_column(right, w);
            out.at(x, y) = view.color.at(view.range.at(a, y) > view.range.at(b, y) ? a : b, y);
        }
    return out;
}

TEST(Walk, FillsHolesBetterThanTheFarSideAndKeepsItsWord) {
    const SyntheticWorld world = SyntheticWorld::furnished(SyntheticPaint::plain, SyntheticPaint::planks);
    const Panorama first = render_synthetic(world, {}, kSize);
    WalkParams params;
    params.viewpoints = 4;
    const std::vector<Panorama> walked = walked_through(first, params, {}).panoramas;
    ASSERT_EQ(walked.size(), 5u);
    EXPECT_EQ(walked[0].color, first.color);
    EXPECT_EQ(walked[0].range, first.range);
    double ours = 0, naive = 0;
    for (std::size_t k = 1; k < walked.size(); ++k) {
        const Panorama& panorama = walked[k];
        const Vec3f position = panorama.world_from_pano.translation;
        const Panorama truth = render_synthetic(world, position, kSize);
        const CoarseView alone = coarse_view({source_of(first)}, kSize, position);
        const ImageMask edges = near_edges(panorama.range, 0);
        ImageMask holes(kSize.width, kSize.height), silhouettes(kSize.width, kSize.height);
        for (std::size_t i = 0; i < holes.size(); ++i) {
            holes.pixels[i] = panorama.known.pixels[i] != Known::original;
            silhouettes.pixels[i] = !holes.pixels[i] && edges.pixels[i];
            ASSERT_GT(panorama.range.pixels[i], 0.f);
            if (holes.pixels[i]) continue;
            // Observed pixels equal the warp's, bit for bit, except for antialiased silhouettes.
            ASSERT_EQ(panorama.range.pixels[i], alone.range.pixels[i]);
            if (!silhouettes.pixels[i]) {
                ASSERT_EQ(panorama.color.pixels[i], alone.color.pixels[i]);
            }
        }
        const auto beside = [&](const ImageColor& color) {
            return psnr(srgb8_from_linear(color), srgb8_from_linear(truth.color), silhouettes);
        };
        EXPECT_GT(beside(panorama.color), beside(alone.color) + 1) << k;
        ours += mean_squared_error(srgb8_from_linear(panorama.color), srgb8_from_linear(truth.color), holes) / 4;
        naive += mean_squared_error(srgb8_from_linear(naive_fill(alone)), srgb8_from_linear(truth.color), holes) / 4;
        if (const char* folder = std::getenv("FASTSCENE_TEST_PICTURES")) {
            const auto name = [&](const char* what) { return fmt::format("{}/walk_{}_{}.png", folder, k, what); };
            save_png(name("ours"), srgb8_from_linear(panorama.color));
            save_png(name("truth"), srgb8_from_linear(truth.color));
            ImageColor coarse = alone.color;
            for (std::size_t i = 0; i < coarse.size(); ++i)
                if (holes.pixels[i])
                    coarse.pixels[i] = alone.cover.pixels[i] == Cover::back ? Vec3f{0, 0, 1} : Vec3f{1, 0, 1};
            save_png(name("coarse"), srgb8_from_linear(coarse));
        }
    }
    std::printf("PSNR in holes: ours %.2f dB, naive far side %.2f dB\n", psnr_of_mse(ours), psnr_of_mse(naive));
    EXPECT_GT(psnr_of_mse(ours), psnr_of_mse(naive) + 2);
}

TEST(Walk, AWallAndFloorBehindABoxContinue) {
    SyntheticWorld world = SyntheticWorld::furnished(SyntheticPaint::plain, SyntheticPaint::plain);
    world.boxes = {
        {{-0.5f, 0.3f, 1.5f}, {0.5f, 1.5f, 1.55f}, {0.6f, 0.1f, 0.1f}, SyntheticPaint::plain}};  // a thin screen
    const Panorama first = render_synthetic(world, {}, kSize);
    WalkParams params;
    params.viewpoints = 3;
    for (const Panorama& panorama : walked_through(first, params, {}).panoramas) {
        const Panorama truth = render_synthetic(world, panorama.world_from_pano.translation, kSize);
        const ImageMask edges = near_edges(truth.range, 2);
        int good = 0, all = 0;
        for (std::size_t i = 0; i < edges.size(); ++i) {
            if (edges.pixels[i] || panorama.known.pixels[i] == Known::original) continue;
            const bool near = std::fabs(panorama.range.pixels[i] - truth.range.pixels[i]) <
                              0.03f * truth.range.pixels[i];
            good += near && length(panorama.color.pixels[i] - truth.color.pixels[i]) < 0.03f;
            ++all;
        }
        EXPECT_GE(good, all * 95 / 100) << all;
    }
}

// In a hall, too, walls continue behind a screen, in the color around it: at 100 m normals are accurate only to several
// centimetres.
TEST(Walk, AHallsWallsContinueBehindAScreen) {
    SyntheticWorld world;
    world.room = {{-100, -100, -100}, {100, 100, 100}, {0.5f, 0.5f, 0.5f}, SyntheticPaint::plain};
    world.boxes = {{{12, -100, 99.9f}, {100, 100, 100}, {0.1f, 0.1f, 0.6f}, SyntheticPaint::plain},  // blue beyond 12 m
                   {{20, -30, 40}, {40, 20, 41}, {0.6f, 0.1f, 0.1f}, SyntheticPaint::plain}};
    const Panorama first = render_synthetic(world, {}, kSize);
    WalkParams params;
    params.viewpoints = 3;
    params.reach_m = 10;
    params.inpainter = "harmonic";
    int good = 0, all = 0;
    for (const Panorama& panorama : walked_through(first, params, {}).panoramas) {
        const Panorama truth = render_synthetic(world, panorama.world_from_pano.translation, kSize);
        const ImageMask edges = near_edges(truth.range, 2);
        for (std::size_t i = 0; i < edges.size(); ++i) {
            if (edges.pixels[i] || panorama.known.pixels[i] == Known::original) continue;
            const bool near = std::fabs(panorama.range.pixels[i] - truth.range.pixels[i]) <
                              0.03f * truth.range.pixels[i];
            good += near && length(panorama.color.pixels[i] - truth.color.pixels[i]) < 0.03f;
            ++all;
        }
    }
    EXPECT_GT(all, 200);
    EXPECT_GE(good, all * 95 / 100) << all;
}

// A brown door 5 cm in front of a pale wall that a wardrobe hides: above the wardrobe, other viewpoints must see wall.
TEST(Walk, ADoorIsNotWhereTheRoomEnds) {
    SyntheticWorld world = SyntheticWorld::furnished(SyntheticPaint::plain, SyntheticPaint::plain);
    const float wall = world.room.high.z, floor = world.room.high.y;
    world.boxes = {
        {{1.5f, floor - 2.f, wall - 0.05f}, {2.4f, floor, wall + 0.1f}, {0.1f, 0.04f, 0.02f}, SyntheticPaint::plain},
        {{-1.8f, floor - 1.9f, wall - 0.9f}, {0.6f, floor, wall - 0.1f}, {0.5f, 0.3f, 0.1f}, SyntheticPaint::plain}};
    const Panorama first = render_synthetic(world, {}, kSize);
    WalkParams params;
    params.viewpoints = 8;
    params.inpainter = "harmonic";
    params.reach_m = 1;
    int good = 0, all = 0;
    for (const Panorama& panorama : walked_through(first, params, {}).panoramas) {
        const Vec3f from = panorama.world_from_pano.translation;
        const Panorama truth = render_synthetic(world, from, kSize);
        const ImageMask edges = near_edges(truth.range, 2);
        for (int y = 0; y < kSize.height; ++y)
            for (int x = 0; x < kSize.width; ++x) {
                if (edges.at(x, y) || panorama.known.at(x, y) != Known::invented) continue;
                const Vec3f there = from + direction_of_pixel(x, y, kSize) * truth.range.at(x, y);
                if (there.z < wall - 0.01f) continue;
                good += length(panorama.color.at(x, y) - truth.color.at(x, y)) < 0.05f;
                ++all;
            }
    }
    EXPECT_GT(all, 50);
    EXPECT_GE(good, all * 95 / 100) << all;
}

bool evenly_colored(const ImageColor& color, int x, int y) {
    for (const int dx : {-1, 1})
        if (length(color.at(wrap_column(x + dx, color.width), y) - color.at(x, y)) > 0.02f) return false;
    return true;
}

// Among the pixels that a walk invents where the true surface is the wall at z = `wall`: how many, and how many have
// its color.
struct WallPainted {
    int all = 0, right = 0;
};
WallPainted invented_wall(const SyntheticWorld& world, float wall, float reach_m) {
    WalkParams params;
    params.viewpoints = 8;
    params.inpainter = "harmonic";
    params.reach_m = reach_m;
    WallPainted out;
    for (const Panorama& panorama : walked_through(render_synthetic(world, {}, kSize), params, {}).panoramas) {
        const Vec3f from = panorama.world_from_pano.translation;
        const Panorama truth = render_synthetic(world, from, kSize);
        const ImageMask edges = near_edges(truth.range, 2);
        for (int y = 0; y < kSize.height; ++y)
            for (int x = 0; x < kSize.width; ++x) {
                if (edges.at(x, y) || panorama.known.at(x, y) == Known::original) continue;
                if ((from + direction_of_pixel(x, y, kSize) * truth.range.at(x, y)).z < wall - 0.01f) continue;
                if (!evenly_colored(truth.color, x, y))
                    continue;  // a corner where a side meets the wall: mixed pixels without a range edge
                ++out.all;
                out.right += length(panorama.color.at(x, y) - truth.color.at(x, y)) < 0.05f;
            }
    }
    return out;
}

// Dark tiles as wide as the wall end behind cupboards; above those a strip of pale wall is visible, 5 cm behind the
// tiles.
TEST(Walk, TheWallAboveItsTilesGoesOnBehindACupboard) {
    SyntheticWorld world = SyntheticWorld::furnished(SyntheticPaint::plain, SyntheticPaint::plain);
    const float wall = world.room.high.z, floor = world.room.high.y, side = world.room.high.x;
    world.boxes = {
        {{-side, floor - 1.5f, wall - 0.05f}, {side, floor, wall + 0.1f}, {0.05f, 0.1f, 0.3f}, SyntheticPaint::plain},
        {{-1.6f, floor - 2.25f, wall - 0.9f},
         {0.7f, floor - 1.4f, wall + 0.1f},
         {0.5f, 0.3f, 0.1f},
         SyntheticPaint::plain}};
    const WallPainted painted = invented_wall(world, wall, 1);
    EXPECT_GT(painted.all, 150);
    EXPECT_GE(painted.right, painted.all * 9 / 10) << painted.all;
}

// Between a cupboard and the recessed hood beside it, the wall is visible: so the hood ends there, and behind the
// cupboard's edge is wall.
TEST(Walk, AFaceDoesNotGoOnBeyondAGapThatWasLookedThrough) {
    SyntheticWorld world = SyntheticWorld::furnished(SyntheticPaint::plain, SyntheticPaint::plain);
    const float wall = world.room.high.z;
    world.boxes = {
        {{0.2f, -0.8f, wall - 0.8f}, {1.f, 0.8f, wall + 0.1f}, {0.5f, 0.3f, 0.1f}, SyntheticPaint::plain},
        {{1.38f, -0.8f, wall - 0.25f}, {2.1f, 0.8f, wall + 0.1f}, {0.1f, 0.04f, 0.02f}, SyntheticPaint::plain}};
    const WallPainted painted = invented_wall(world, wall, 0.8f);
    EXPECT_GT(painted.all, 60);
    EXPECT_GE(painted.right, painted.all * 9 / 10) << painted.all;
}

// A bench whose tall side hides the air beyond it just as it would hide more bench: the bench must end there.
TEST(Walk, ASeatEndsWhereItIsNoLongerSeen) {
    SyntheticWorld world = SyntheticWorld::furnished(SyntheticPaint::plain, SyntheticPaint::plain);
    const Vec3f seat{0.5f, 0.05f, 0.05f};
    world.boxes = {{{0.1f, 0.5f, 1.f}, {0.75f, 0.55f, 1.3f}, seat, SyntheticPaint::plain},
                   {{0.7f, 0.1f, 1.f}, {0.75f, 0.5f, 1.3f}, {0.05f, 0.1f, 0.3f}, SyntheticPaint::plain}};
    WalkParams params;
    params.viewpoints = 8;
    params.inpainter = "harmonic";
    params.reach_m = 1.5f;
    int all = 0, bench = 0;
    for (const Panorama& panorama : walked_through(render_synthetic(world, {}, kSize), params, {}).panoramas) {
        const Panorama truth = render_synthetic(world, panorama.world_from_pano.translation, kSize);
        const ImageMask edges = near_edges(truth.range, 2);
        for (std::size_t i = 0; i < edges.size(); ++i) {
            if (edges.pixels[i] || panorama.known.pixels[i] == Known::original ||
                length(truth.color.pixels[i] - seat) < 0.1f)
                continue;
            ++all;
            bench += length(panorama.color.pixels[i] - seat) < 0.1f;
        }
    }
    std::printf("%d pixels, %d of them bench\n", all, bench);
    EXPECT_GT(all, 100);
    EXPECT_LE(bench, all / 400);
}

// A rug whose two halves have the same non-repeating pattern, on a floor; `grain`: noise on both, as in a photograph. 1
// cm per pixel.
ImageColor picture_of_rug(float grain) {
    ImageColor out(320, 240);
    Random random(1, "walk/test-rug");
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            const float a = 0.3f, px = 0.01f * static_cast<float>(x) - 1.6f, py = 0.01f * static_cast<float>(y) - 1.2f;
            const float u = std::fabs(std::cos(a) * px + std::sin(a) * py), v = std::cos(a) * py - std::sin(a) * px;
            const bool rug = u < 1 && std::fabs(v)<0.6f, rim = u> 0.9f || std::fabs(v) > 0.5f;
            const bool dark = std::sin(18 * u + 9 * u * u) + std::sin(14 * v + 5 * v * v + 2 * u) > 0.3f;
            const Vec3f c = !rug   ? Vec3f{0.3f, 0.2f, 0.1f}
                            : rim  ? Vec3f{0.6f, 0.1f, 0.05f}
                            : dark ? Vec3f{0.05f, 0.1f, 0.3f}
                                   : Vec3f{0.8f, 0.75f, 0.6f};
            out.at(x, y) = c + Vec3f{1, 1, 1} * (grain * (random.uniform() - 0.5f));
        }
    return out;
}

// Fills a round hole from repeats: most of it, far better than smooth interpolation, and nothing else changes.
void expect_filled(const ImageColor& truth, int x0, int y0, float radius, float metres_per_pixel) {
    ImageColor color = truth;
    ImageMask hole(truth.width, truth.height);
    for (int y = 0; y < hole.height; ++y)
        for (int x = 0; x < hole.width; ++x)
            if (std::hypot(static_cast<float>(x - x0), static_cast<float>(y - y0)) < radius)
                hole.at(x, y) = 1, color.at(x, y) = {};
    const ImageMask before = hole;
    const ImageColor smooth = make_inpainter("harmonic")->fill(color, hole, {});
    fill_from_repeats(color, hole, metres_per_pixel);
    double ours = 0, theirs = 0;
    int all = 0, left = 0;
    for (std::size_t i = 0; i < hole.size(); ++i) {
        if (!before.pixels[i]) {
            ASSERT_FALSE(hole.pixels[i]);
            ASSERT_EQ(color.pixels[i], truth.pixels[i]);
            continue;
        }
        ++all, left += hole.pixels[i] != 0;
        if (hole.pixels[i]) continue;
        const Vec3f a = color.pixels[i] - truth.pixels[i], b = smooth.pixels[i] - truth.pixels[i];
        ours += static_cast<double>(dot(a, a)), theirs += static_cast<double>(dot(b, b));
    }
    std::printf("%d of %d pixels left, error %.2f of the smoothest fill's\n", left, all, ours / theirs);
    EXPECT_LE(left, all / 4);
    EXPECT_LT(ours, 0.3 * theirs);
}

TEST(Repeats, ARugsHiddenEndIsTheMirrorImageOfItsOther) { expect_filled(picture_of_rug(0.05f), 240, 150, 45, 0.01f); }

// A 0.6 m motif without mirror symmetry, repeated; also with larger pixels, as in a hall.
TEST(Repeats, AWallpapersMotifIsThatOfItsNeighbour) {
    for (const int period : {60, 24}) {
        Random random(5, "walk/test-wallpaper");
        ImageColor motif(period, period);
        const int patch = period / 6;
        for (int y = 0; y < period; y += patch)
            for (int x = 0; x < period; x += patch) {
                const Vec3f c{random.uniform(), random.uniform(), random.uniform()};
                for (int j = y; j < y + patch; ++j)
                    for (int i = x; i < x + patch; ++i) motif.at(i, j) = c;
            }
        ImageColor wall(5 * period, 4 * period);
        for (int y = 0; y < wall.height; ++y)
            for (int x = 0; x < wall.width; ++x) wall.at(x, y) = motif.at(x % period, y % period);
        expect_filled(wall, 2 * period + 10, 2 * period - 5, 0.6f * static_cast<float>(period),
                      0.6f / static_cast<float>(period));
    }
}

TEST(Repeats, WhatHasNoPatternIsLeft) {
    for (const float grain : {0.f, 0.05f, 0.8f}) {  // a uniform floor, its grain, and gravel
        ImageColor color(200, 200);
        Random random(2, "walk/test-gravel");
        for (Vec3f& c : color.pixels)
            c = Vec3f{0.5f, 0.4f, 0.3f} + Vec3f{1, 1, 1} * (grain * (random.uniform() - 0.5f));
        ImageMask hole(200, 200);
        for (int y = 70; y < 130; ++y)
            for (int x = 70; x < 130; ++x) hole.at(x, y) = 1;
        const ImageMask before = hole;
        fill_from_repeats(color, hole, 0.01f);
        EXPECT_EQ(hole, before) << grain;
    }
}

// A box room with a window in its far wall (0.25 m thick, with a crossbar); the outside's color encodes the direction.
struct Seen {
    Vec3f color;
    float range;
};
Vec3f outside_color(Vec3f d) { return d.y < 0 ? Vec3f{0.5f, 0.6f, 0.9f} : Vec3f{0.2f, 0.7f, 0.2f}; }
Seen look_at_window_room(Vec3f from, Vec3f d) {
    const float inf = std::numeric_limits<float>::infinity();
    const auto reach = [&](float p, float v, float low, float high) {
        return v > 0 ? (high - p) / v : v < 0 ? (low - p) / v : inf;
    };
    const float tx = reach(from.x, d.x, -2, 2), ty = reach(from.y, d.y, -1.2f, 1.4f), tz = reach(from.z, d.z, -2, 2);
    const float t = std::min({tx, ty, tz});
    const Vec3f wall{0.7f, 0.4f, 0.3f}, p = from + d * t;
    if (t < tz || d.z < 0) return {t == ty ? Vec3f{0.5f, 0.4f, 0.3f} : wall, t};
    if (std::fabs(p.x) > 1 || std::fabs(p.y) > 0.7f) return {wall, t};
    const float through = reach(from.z, d.z, -2, 2.25f), rx = reach(from.x, d.x, -1, 1),
                ry = reach(from.y, d.y, -0.7f, 0.7f);
    if (std::min(rx, ry) < through) return {wall, std::min(rx, ry)};
    if (std::fabs(from.x + d.x * through) < 0.03f) return {Vec3f{0.9f, 0.9f, 0.9f}, through};
    return {outside_color(d), inf};
}
Panorama panorama_of_window_room(Vec3f from) {
    Panorama out{ImageColor(kSize.width, kSize.height), ImageF(kSize.width, kSize.height), {}, {{}, from}};
    for (int y = 0; y < kSize.height; ++y)
        for (int x = 0; x < kSize.width; ++x) {
            const Seen seen = look_at_window_room(from, direction_of_pixel(x, y, kSize));
            out.color.at(x, y) = seen.color;
            out.range.at(x, y) = seen.range;
        }
    return out;
}

// Surfaces invented between a frame and the outside used to float in mid-air, and appeared as scratches on the panes
// from other viewpoints.
TEST(Walk, NothingStandsBetweenAFrameAndTheOutside) {
    WalkParams params;
    params.viewpoints = 8;
    params.inpainter = "harmonic";
    int floating = 0, outside = 0;
    for (const Panorama& panorama : walked_through(panorama_of_window_room({}), params, {}).panoramas)
        for (int y = 0; y < kSize.height; ++y)
            for (int x = 0; x < kSize.width; ++x) {
                const float range = panorama.range.at(x, y);
                const float beyond = (panorama.world_from_pano.translation + direction_of_pixel(x, y, kSize) * range)
                                         .z -
                                     2.25f;
                outside += std::isinf(range);
                floating += std::isfinite(range) && beyond > 0.2f;
            }
    EXPECT_GT(outside, 1000);
    EXPECT_EQ(floating, 0);
}

// Single pixels without range: an outside in which no pixel is clear of other surfaces.
TEST(Walk, AnOutsideOfSpecksIsWalkedToo) {
    WalkParams params;
    params.viewpoints = 2;
    params.inpainter = "harmonic";
    Panorama panorama = render_synthetic(SyntheticWorld::furnished(SyntheticPaint::plain, SyntheticPaint::plain), {},
                                         kSize);
    for (int y = 2; y < kSize.height; y += 5)
        for (int x = 2; x < kSize.width; x += 5) panorama.range.at(x, y) = std::numeric_limits<float>::infinity();
    for (const Panorama& walked : walked_through(panorama, params, {}).panoramas)
        for (const Vec3f c : walked.color.pixels) ASSERT_TRUE(std::isfinite(c.x + c.y + c.z));
}

TEST(Walk, ThroughAWindowHolesAreTheOutside) {
    WalkParams params;
    params.viewpoints = 8;
    params.inpainter = "harmonic";
    int holes = 0, right = 0, sky = 0;
    for (const Panorama& panorama : walked_through(panorama_of_window_room({}), params, {}).panoramas) {
        const Panorama truth = panorama_of_window_room(panorama.world_from_pano.translation);
        const ImageMask edges = near_edges(truth.range, 2);
        for (std::size_t i = 0; i < edges.size(); ++i) {
            if (edges.pixels[i] || panorama.known.pixels[i] == Known::original) continue;
            ++holes;
            const bool outside = std::isinf(truth.range.pixels[i]);
            sky += outside;
            right += outside == std::isinf(panorama.range.pixels[i]) &&
                     length(panorama.color.pixels[i] - truth.color.pixels[i]) < 0.05f;
        }
    }
    std::printf("%d holes, %d of them sky, %d right\n", holes, sky, right);
    EXPECT_GT(sky, 1000);
    EXPECT_GE(right, holes * 9 / 10);
}

TEST(CoarseView, AFoldStaysClosedButADeepJumpOpens) {
    for (const float depth : {0.1f, 1.f}) {  // a wall in two halves, the right one `depth` farther back
        Panorama first{
            ImageColor(kSize.width, kSize.height, Vec3f{0.5f, 0.5f, 0.5f}), ImageF(kSize.width, kSize.height), {}, {}};
        for (int y = 0; y < kSize.height; ++y)
            for (int x = 0; x < kSize.width; ++x) {
                const Vec3f d = direction_of_pixel(x, y, kSize);
                first.range.at(x, y) = d.z > 0.3f ? (d.x < 0 ? 2.f : 2.f + depth) / d.z : 5.f;
            }
        const CoarseView view = coarse_view({source_of(first)}, kSize, {0.6f, 0, 0});
        int holes = 0;
        for (int x = kSize.width * 3 / 8; x < kSize.width / 2; ++x)
            holes += view.cover.at(x, kSize.height / 2) == Cover::hole;
        if (depth < 0.2f) EXPECT_EQ(holes, 0);
        else EXPECT_GT(holes, 3);
    }
}

TEST(Walk, SameBytesForAnyNumberOfThreads) {
    const SyntheticWorld world = SyntheticWorld::furnished(SyntheticPaint::checker, SyntheticPaint::planks);
    const Panorama first = render_synthetic(world, {}, {128, 64}, 1);
    WalkParams params;
    params.viewpoints = 2;
    set_threads(1);
    const auto one = walked_through(first, params, {}).panoramas;
    set_threads(2);
    const auto two = walked_through(first, params, {}).panoramas;
    set_threads(0);
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_EQ(one[i].color, two[i].color);
        EXPECT_EQ(one[i].range, two[i].range);
        EXPECT_EQ(one[i].known, two[i].known);
    }
}

// Records the library's events.
struct Heard : EventSink {
    std::string warnings;
    void tell(const Event& event) override {
        if (const auto* warning = std::get_if<WarningEvent>(&event)) warnings += warning->text + "\n";
    }
};
std::string error_of(const Panorama& first) {
    try {
        WalkParams params;
        params.viewpoints = 1;
        params.inpainter = "harmonic";
        walked_through(first, params, {});
        return "";
    } catch (const Error& e) {
        return e.what();
    }
}

TEST(Walk, RefusesWhatIsNoRoom) {
    const Panorama good = render_synthetic(SyntheticWorld::furnished(SyntheticPaint::plain, SyntheticPaint::plain), {},
                                           {64, 32}, 1);
    Panorama first = good;
    first.range = {};
    EXPECT_NE(error_of(first).find("expected a range map of the panorama's size 64 x 32"), std::string::npos);
    first.range = ImageF(32, 16, 1.f);
    EXPECT_NE(error_of(first).find("found 32 x 16"), std::string::npos);
    first.range = ImageF(64, 32, std::nanf(""));
    EXPECT_NE(error_of(first).find("no range in any"), std::string::npos);
    first.range = ImageF(64, 32, 0.03f);  // a camera inside a cushion
    EXPECT_NE(error_of(first).find("inside an object"), std::string::npos);
    first.color = ImageColor(60, 32);
    first.range = ImageF(60, 32, 1.f);
    EXPECT_NE(error_of(first).find("twice as wide as high"), std::string::npos);
    EXPECT_EQ(error_of(good), "");
}

TEST(Walk, WhatHasNoRangeIsFarBackground) {
    Panorama first = render_synthetic(SyntheticWorld::furnished(SyntheticPaint::plain, SyntheticPaint::plain), {},
                                      {128, 64}, 1);
    // 1e-45 to 5e-4 are failed measurements, not surfaces in front of the lens that would end every step.
    const float nothing[] = {0.f,    -1.f,   std::nanf(""), std::numeric_limits<float>::infinity(),
                             1e-45f, 1e-30f, 5e-4f,         -0.f};
    for (int y = 20; y < 28; ++y)
        for (int x = 40; x < 56; ++x) first.range.at(x, y) = nothing[(x + y) % 8];
    for (const char* kind : {"ours", "paper", "paper-direct", "paper-far"}) {
        WalkParams params;
        params.kind = kind;
        params.viewpoints = 2;
        params.steps = 2;
        params.inpainter = "harmonic";
        Heard heard;
        const auto walked = walked_through(first, params, {0, &heard, {}}).panoramas;
        EXPECT_NE(heard.warnings.find("112 pixels of the range map have no range"), std::string::npos)
            << kind << heard.warnings;
        EXPECT_TRUE(std::isinf(walked[0].range.at(48, 24))) << kind;
        EXPECT_GT(length(walked[1].world_from_pano.translation), 0.04f) << kind;
        for (const Panorama& panorama : walked) {
            int sky = 0;
            for (const float r : panorama.range.pixels) {
                ASSERT_GT(r, 0.f) << kind;
                sky += std::isinf(r);
            }
            EXPECT_GT(sky, 60) << kind;
            EXPECT_LT(sky, 400) << kind;
        }
    }
}

// Panoramas need not be kept: each is handed over before the next viewpoint starts, even if the walk is stopped there.
TEST(Walk, HandsOverEachPanoramaWhenItIsComplete) {
    const Panorama first = render_synthetic(SyntheticWorld::furnished(SyntheticPaint::plain, SyntheticPaint::plain), {},
                                            {128, 64}, 1);
    for (const char* kind : {"ours", "paper-far"}) {
        WalkParams params;
        params.kind = kind;
        params.viewpoints = 4;
        params.inpainter = "harmonic";
        const std::vector<Panorama> wanted = walked_through(first, params, {}).panoramas;
        std::vector<Panorama> taken;
        struct Enough {};
        EXPECT_THROW(walk_through(first, params, {},
                                  [&](Panorama one) {
                                      taken.push_back(std::move(one));
                                      if (taken.size() == 3) throw Enough{};
                                  }),
                     Enough)
            << kind;
        ASSERT_EQ(taken.size(), 3u) << kind;
        for (std::size_t i = 0; i < taken.size(); ++i) {
            EXPECT_EQ(taken[i].color.pixels, wanted[i].color.pixels) << kind << ' ' << i;
            EXPECT_EQ(taken[i].range.pixels, wanted[i].range.pixels) << kind << ' ' << i;
            EXPECT_EQ(taken[i].world_from_pano.translation, wanted[i].world_from_pano.translation) << kind << ' ' << i;
        }
    }
}

TEST(Walk, TinyAndHugeRoomsAndStepsThatAreTooLong) {
    for (const float width : {0.5f, 200.f}) {
        SyntheticWorld world;
        world.room = {{-0.5f * width, -0.4f * width, -0.6f * width},
                      {0.5f * width, 0.5f * width, 0.5f * width},
                      {0.5f, 0.5f, 0.5f},
                      SyntheticPaint::smooth};
        const Panorama first = render_synthetic(world, {}, {128, 64}, 1);
        for (const char* kind : {"ours", "paper"}) {
            WalkParams params;
            params.kind = kind;
            params.viewpoints = 4;
            params.reach_m = 10;
            params.step = 0.5f;
            params.steps = 3;
            params.inpainter = "harmonic";
            Heard heard;
            for (const Panorama& panorama : walked_through(first, params, {0, &heard, {}}).panoramas) {
                const Vec3f p = panorama.world_from_pano.translation;
                for (std::size_t c = 0; c < 3; ++c) {
                    EXPECT_GT(p[c], world.room.low[c]) << kind << ' ' << width;
                    EXPECT_LT(p[c], world.room.high[c]) << kind << ' ' << width;
                }
                for (const float r : panorama.range.pixels) ASSERT_TRUE(r > 0.f && std::isfinite(r));
            }
            EXPECT_EQ(heard.warnings.find("clipped") != std::string::npos, width < 1 || params.kind == "paper")
                << kind << ' ' << width << heard.warnings;
        }
    }
}

}  // namespace
}  // namespace fastscene

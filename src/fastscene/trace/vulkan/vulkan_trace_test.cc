// Path tracing on graphics cards against Embree's, sample by sample: both draw the same random numbers. Without a card
// it runs on Mesa's lavapipe. The validation layer watches all of it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <optional>

#include "fastscene/trace/path.h"
#include "fastscene/trace/trace.h"
#include "fastscene/trace/vulkan/card_gatherer.h"
#include "fastscene/trace/vulkan/card_pixels.h"
#include "fastscene/trace/vulkan/test_rooms.h"
#include "fastscene/trace/vulkan/tracer.h"

namespace fastscene::vulkan {
namespace {

std::string device_name() {
    setenv("FASTSCENE_VULKAN_VALIDATION", "1", 0);
    return gpu::has_card() ? "auto" : "llvmpipe";
}

// Everything that one room needs on both sides.
struct Both {
    explicit Both(Room r)
        : room(std::move(r)), bvh(room), lights(room, 2, &bvh), card(device_name(), "--device", room, lights) {}
    ~Both() { EXPECT_EQ(card.device().validation_messages(), std::vector<std::string>{}); }
    Room room;
    SceneBvh bvh;
    Lights lights;
    Tracer card;
};
class VulkanTrace : public ::testing::Test {
  protected:
    static void SetUpTestSuite() { everything_ = new Both(everything_room()); }
    static void TearDownTestSuite() { light_on_card_.reset(), furnace_.reset(), delete everything_; }
    static Both& everything() { return *everything_; }

    // A closed room with albedo 1/2 and emission 1/2. Made once: lavapipe compiles its shaders anew for each room.
    static Both& furnace() {
        if (furnace_) return *furnace_;
        Room room;
        room.min_corner = kLow, room.max_corner = kHigh;
        room.materials = {diffuse({0.5f, 0.5f, 0.5f}, {0.5f, 0.5f, 0.5f})};
        room.meshes = {box_mesh(kLow, kHigh, 0, -1, true)};
        room.look.automatic = false, room.look.exposure_ev = -4;  // lamps are not compressed
        furnace_ = std::make_unique<Both>(std::move(room));
        return *furnace_;
    }

    // Its light, gathered on the card once.
    static const IrradianceCache& light_on_card() {
        if (!light_on_card_) light_on_card_ = gathered_on_card(*everything_);
        return *light_on_card_;
    }
    static TraceParams light_params() {
        TraceParams params;
        params.cell_m = 0.12f, params.cell_samples = 48;
        return params;
    }
    static IrradianceCache gathered_on_card(Both& both) {
        CardGatherer gatherer(both.card);
        return IrradianceCache::gather(both.room, both.bvh, both.lights, light_params(), kRun, {Vec3f{}}, &gatherer);
    }
    static inline const fastscene::Run kRun{3, nullptr, {}};

  private:
    static inline Both* everything_ = nullptr;
    static inline std::unique_ptr<Both> furnace_;
    static inline std::optional<IrradianceCache> light_on_card_;
};

// PSNR of linear pictures, of peak 1.
double psnr(const ImageColor& a, const ImageColor& b) {
    double squares = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Vec3f d = a.pixels[i] - b.pixels[i];
        squares += static_cast<double>(dot(d, d));
    }
    return -10 * std::log10(std::max(1e-12, squares / (3 * static_cast<double>(a.size()))));
}
Vec3d mean_of(const ImageColor& a) {
    Vec3d sum{};
    for (const Vec3f c : a.pixels) sum += Vec3d{c.x, c.y, c.z};
    return sum / static_cast<double>(a.size());
}

TEST_F(VulkanTrace, RaysMeetWhatEmbreesMeet) {
    Both& both = everything();
    std::vector<std::uint32_t> first_triangle;
    std::uint32_t count = 0;
    for (const Mesh& m : both.room.meshes)
        first_triangle.push_back(count), count += static_cast<std::uint32_t>(m.triangles.size() / 3);
    std::vector<Tracer::Query> rays;
    Random random(4, "test.rays");
    for (int i = 0; i < 40000; ++i) {
        Tracer::Query q;
        q.origin = {random.uniform(-1.9f, 1.9f), random.uniform(-1.f, 1.4f), random.uniform(-2.3f, 2.3f)};
        q.direction = normalize(Vec3f{random.normal(), random.normal(), random.normal()});
        if (i % 8 == 0) q.direction = {0, i % 16 ? 1.f : -1.f, 0};  // along an axis
        q.lit = i % 2;
        if (i % 5 == 0) q.far_m = random.uniform(0.2f, 2.f);
        rays.push_back(q);
    }
    const std::vector<RayHit> found = both.card.hits(rays);
    int others = 0, hits = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Tracer::Query& q = rays[i];
        RayHit truth = q.lit ? both.bvh.first_lit(q.origin, q.direction)
                             : both.bvh.first_hit(q.origin, q.direction, 0.f, q.far_m);
        if (truth.distance >= q.far_m) truth = RayHit{};
        const RayHit& mine = found[i];
        hits += truth ? 1 : 0;
        const bool same = mine.mesh == truth.mesh &&
                          (!truth ||
                           mine.triangle ==
                               static_cast<int>(first_triangle[static_cast<std::size_t>(truth.mesh)]) + truth.triangle);
        if (!same) {
            ++others;
            // An edge hit by one and missed by the other, or two triangles at one place.
            continue;
        }
        if (!truth) continue;
        ASSERT_NEAR(mine.distance, truth.distance, 2e-5f * (1 + truth.distance));
        ASSERT_NEAR(mine.u, truth.u, 2e-3f);
        ASSERT_NEAR(mine.v, truth.v, 2e-3f);
        ASSERT_EQ(mine.back, truth.back);
    }
    EXPECT_GT(hits, 20000);
    EXPECT_LT(others, 20);
}

TEST_F(VulkanTrace, NoRayLeavesAClosedRoomThroughItsEdges) {
    std::vector<Tracer::Query> rays;
    for (int i = 0; i < 30000; ++i) {  // at points of the edges and diagonals
        Random random(1, "test.edges", static_cast<std::uint64_t>(i));
        Vec3f to{random.chance(0.5f) ? kLow.x : kHigh.x, random.chance(0.5f) ? kLow.y : kHigh.y,
                 random.chance(0.5f) ? kLow.z : kHigh.z};
        const Vec3f other{random.chance(0.5f) ? kLow.x : kHigh.x, random.chance(0.5f) ? kLow.y : kHigh.y, to.z};
        to = lerp(to, other, random.uniform());
        rays.push_back({{}, normalize(to), kFar, false});
    }
    for (const RayHit& hit : furnace().card.hits(rays)) ASSERT_TRUE(hit);
}

// The radiance is 1 in all directions.
TEST_F(VulkanTrace, Furnace) {
    const ImageColor sums = furnace().card.path_sums(panorama_camera({}, {32, 16}), {}, 64, {});
    const Vec3d mean = mean_of(sums) / 64.;
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(mean[k], 1, 0.01);
}

TEST_F(VulkanTrace, PathsAreThoseOfTheProcessor) {
    Both& both = everything();
    const fastscene::Run run{7, nullptr, {}};
    for (const bool panorama : {true, false}) {
        const RayCamera camera = panorama ? panorama_camera({}, {48, 24})
                                          : perspective_camera({}, Pinhole::with_fov(32, 24, 80));
        constexpr int kSamples = 24;
        ImageColor mine = both.card.path_sums(camera, {}, kSamples, run);
        for (Vec3f& c : mine.pixels) c = c / static_cast<float>(kSamples);
        const ImageColor truth = path_traced_picture({both.room, both.bvh, both.lights}, camera, {}, kSamples, nullptr,
                                                     run);
        // A path that rounding sends elsewhere differs wholly: most pixels must not.
        std::vector<double> off;
        for (std::size_t i = 0; i < mine.size(); ++i)
            off.push_back(
                static_cast<double>(length(mine.pixels[i] - truth.pixels[i]) / (0.01f + length(truth.pixels[i]))));
        std::sort(off.begin(), off.end());
        EXPECT_LT(off[off.size() / 2], 1e-4);
        EXPECT_LT(off[off.size() * 9 / 10], 1e-2);
        const Vec3d a = mean_of(mine), b = mean_of(truth);
        for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(a[k] / b[k], 1, 0.01);
    }
    EXPECT_LT(both.card.longest_submission_s(), 0.9);
}

// How far two caches of a room are apart.
struct Apart {
    int others = 0;                            // cells that only one of them has: the last hidden, the first in sight
    int unlike = 0;                            // cells whose light differs by more than 2 percent
    double light = 0, sun = 0, direction = 0;  // mean relative differences
    double level = 1;                          // all light, relative
};
Apart apart(const IrradianceCache& mine, const IrradianceCache& truth) {
    Apart out;
    const auto a = mine.tables(), b = truth.tables();
    double mine_light = 0, light = 0, sun = 0;
    std::size_t i = 0, k = 0;
    while (i < a.keys.size() && k < b.keys.size()) {
        if (a.keys[i] != b.keys[k]) {
            ++out.others, ++(a.keys[i] < b.keys[k] ? i : k);
            continue;
        }
        const auto &p = a.cells[i++], &q = b.cells[k++];
        const Vec3f e = p.direct + p.indirect, f = q.direct + q.indirect;
        out.unlike += length(e - f) > 0.02f * (length(f) + 0.05f);
        mine_light += static_cast<double>(luminance(e)), light += static_cast<double>(luminance(f));
        out.light += static_cast<double>(std::fabs(luminance(e - f)));
        sun += static_cast<double>(luminance(q.sun)),
            out.sun += static_cast<double>(std::fabs(luminance(p.sun - q.sun)));
        out.direction += static_cast<double>(length(p.directed.gradient() - q.directed.gradient()));
    }
    out.light /= light, out.level = mine_light / light, out.direction /= static_cast<double>(k);
    if (sun > 0) out.sun /= sun;
    return out;
}

// The same random numbers give the same sums. Where the sun shines, one cell more or less shifts which patch is asked,
// and the sums are as far apart as those of two seeds.
TEST_F(VulkanTrace, TheCacheIsThatOfTheProcessor) {
    Room dull = everything_room();
    dull.sky.sun_irradiance = {};
    Both without_sun(std::move(dull));
    for (Both* both : {&without_sun, &everything()}) {
        const bool sunny = both != &without_sun;
        SCOPED_TRACE(sunny);
        const IrradianceCache truth = IrradianceCache::gather(both->room, both->bvh, both->lights, light_params(),
                                                              kRun);
        const Apart found = apart(sunny ? light_on_card() : gathered_on_card(*both), truth);
        const auto cells = static_cast<double>(truth.size());
        EXPECT_GT(cells, 5000);
        EXPECT_LT(found.others, 0.002 * cells);
        EXPECT_NEAR(found.level, 1, 2e-3);
        EXPECT_LT(found.sun, 1e-3);
        EXPECT_LT(found.light, sunny ? 0.02 : 1.5e-3);
        EXPECT_LT(found.unlike, (sunny ? 0.2 : 0.01) * cells);
        EXPECT_LT(found.direction, sunny ? 0.02 : 2e-3);
    }
}

TEST_F(VulkanTrace, CachedPicturesAreThoseOfTheProcessor) {
    Both& both = everything();
    const IrradianceCache& light = light_on_card();
    struct Case {
        const char* name;
        ShotParts parts;
        bool panorama, develops;
    };
    const Case cases[] = {
        {"final", final_parts(32), true, true},
        {"contacts, radiance", {.pixel_samples = 4, .contacts = true}, true, false},
        {"frugal, blunt", {.pixel_samples = 8, .frugal = true, .min_alpha = 0.3f}, false, true},
        {"adaptive", {.pixel_samples = 32, .noise = 0.02f}, false, true},
    };
    Look look;
    look.automatic = false, look.exposure_ev = 0.5f, look.white = {1.1f, 1, 0.9f}, look.saturation = 1.1f;
    Room seen = both.room;
    seen.look = look;
    both.card.set_look(look, seen.sky);
    for (const Case& c : cases) {
        SCOPED_TRACE(c.name);
        const RayCamera camera = c.panorama ? panorama_camera({}, {64, 32})
                                            : perspective_camera({}, Pinhole::with_fov(48, 36, 80));
        const ShadeScene scene{seen, both.bvh, both.lights, light, c.parts.contacts, c.parts.frugal, c.parts.min_alpha};
        const ShadeOptions options{c.parts.contacts, c.parts.frugal, c.parts.min_alpha};
        const MakePixelTracer make = [&](const PixelPlan& plan) {
            return std::make_unique<CardPixels>(both.card, options, plan);
        };
        ImageColor truth_albedo, albedo;
        const Look* const shown = c.develops ? &look : nullptr;
        const ImageColor truth = cached_picture(scene, camera, c.parts, c.parts.pixel_samples, shown, &truth_albedo,
                                                kRun),
                         mine = cached_picture(scene, camera, c.parts, c.parts.pixel_samples, shown, &albedo, kRun,
                                               make);
        EXPECT_GT(psnr(mine, truth), 50);
        EXPECT_GT(psnr(albedo, truth_albedo), 50);
        // Again: the same bytes.
        const ImageColor again = cached_picture(scene, camera, c.parts, c.parts.pixel_samples, shown, &albedo, kRun,
                                                make);
        EXPECT_EQ(again.pixels, mine.pixels);
    }
    both.card.set_look(both.room.look, both.room.sky);
}

// As users get there: by the settings.
TEST(TraceBackend, ARoomOnACardLooksAsOnTheProcessor) {
    TraceParams params;
    params.cell_m = 0.2f, params.cell_samples = 32;
    params.outside_detail = 1;  // as many pixels as the picture has; the outside is traced anew for each
    const fastscene::Run run{5, nullptr, {}};
    ImageColor pictures[2], paths[2];
    for (const bool on_card : {false, true}) {
        TracedRoom room(everything_room());
        if (on_card) params.backend = {"vulkan", device_name()};
        room.gather_light(params, run);
        EXPECT_EQ(room.device().empty(), !on_card);
        EXPECT_TRUE(!on_card || gpu::has_card() || room.device().find("llvmpipe") != std::string::npos)
            << room.device();
        pictures[on_card] = room.eye_panorama({}, {64, 32}, 0.03f, {.pixel_samples = 8, .contacts = true}, run).color;
        paths[on_card] = room.perspective({}, Pinhole::with_fov(24, 16, 70), {.pixel_samples = 8, .paths = true}, run)
                             .color;
    }
    EXPECT_GT(psnr(pictures[1], pictures[0]), 38);  // sun patches are asked differently: two seeds' noise of the light
    EXPECT_GT(psnr(paths[1], paths[0]), 38);        // the exposure differs by as much
}

TEST(TraceBackend, UnknownOnesAreNamed) {
    TraceParams params;
    const auto refusal = [&](const std::string& name, const std::string& device) {
        params.backend = {name, device}, params.outside_detail = 0;
        TracedRoom room(everything_room());
        try {
            room.gather_light(params, {});
        } catch (const UsageError& e) {
            return std::string(e.what());
        }
        return std::string("none");
    };
    EXPECT_EQ(refusal("cuda", "auto"), "--trace-backend: expected cpu or vulkan, found \"cuda\"");
    EXPECT_NE(refusal("vulkan", "voodoo").find("--trace-device voodoo: expected"), std::string::npos);
}

}  // namespace
}  // namespace fastscene::vulkan

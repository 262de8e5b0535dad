#include "fastscene/inpaint/inpaint.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "fastscene/base/error.h"
#include "fastscene/base/parallel.h"
#include "fastscene/base/random.h"
#include "fastscene/image/color.h"
#include "fastscene/inpaint/crops.h"
#include "fastscene/nn/hashed_aotgan.h"
#include "fastscene/weights/safetensors.h"

namespace fastscene {
namespace {

struct Picture {
    ImageColor color;
    ImageMask hole;
};
Picture noisy_picture(int w, int h) {
    Picture p{ImageColor(w, h), ImageMask(w, h)};
    Random r(3, "inpaint");
    for (Vec3f& c : p.color.pixels) c = {r.uniform(0.2f, 0.4f), r.uniform(), 0.5f};
    for (int y = h / 4; y < h / 2; ++y)
        for (int x = w / 3; x < w; ++x) p.hole.at(x, y) = 255;
    return p;
}

// A small network with hashed weights, as a file.
const std::filesystem::path& small_weights() {
    static const std::filesystem::path path = [] {
        const auto file = std::filesystem::temp_directory_path() /
                          ("fastscene-inpaint-test-" + std::to_string(::getpid()) + ".safetensors");
        save_safetensors(file, hashed_aotgan(4, 2));
        return file;
    }();
    return path;
}
struct RemoveWeights : testing::Environment {
    void TearDown() override { std::filesystem::remove(small_weights()); }
};
[[maybe_unused]] const auto* const remove_weights = testing::AddGlobalTestEnvironment(new RemoveWeights);

TEST(Inpainters, AllKeepTheContract) {
    const Picture p = noisy_picture(97, 61);
    for (const std::string& name : registered_names<InpaintBackend>()) {
        if (registered_entry<InpaintBackend>("inpainter", name).runs_code) continue;  // torchscript_test.cc
        const auto inpainter = make_inpainter(name, small_weights());
        const ImageColor out = inpainter->fill(p.color, p.hole, {});
        ASSERT_TRUE(out.same_size(p.color)) << name;
        for (std::size_t i = 0; i < out.size(); ++i) {
            if (!p.hole.pixels[i]) {
                ASSERT_EQ(out.pixels[i], p.color.pixels[i]) << name;
            }
            ASSERT_TRUE(std::isfinite(out.pixels[i].x + out.pixels[i].y + out.pixels[i].z)) << name;
        }
        EXPECT_EQ(out, inpainter->fill(p.color, p.hole, {})) << name;
        // The content under the mask must not matter.
        ImageColor other = p.color;
        for (std::size_t i = 0; i < other.size(); ++i)
            if (p.hole.pixels[i]) other.pixels[i] = {9, 9, 9};
        EXPECT_EQ(out, inpainter->fill(other, p.hole, {})) << name;
        EXPECT_EQ(p.color, inpainter->fill(p.color, ImageMask(97, 61), {})) << name;
        (void)inpainter->fill(p.color, ImageMask(97, 61, std::uint8_t{1}), {});  // nothing known: must not crash
    }
}

TEST(Harmonic, StaysWithinTheRim) {
    const Picture p = noisy_picture(200, 120);
    const ImageColor out = make_inpainter("harmonic")->fill(p.color, p.hole, {});
    for (std::size_t i = 0; i < out.size(); ++i) {
        EXPECT_GE(out.pixels[i].x, 0.2f);
        EXPECT_LE(out.pixels[i].x, 0.4f);
        EXPECT_EQ(out.pixels[i].z, 0.5f);
    }
}

TEST(Harmonic, ContinuesARampExactly) {
    ImageColor color(128, 128);
    ImageMask hole(128, 128);
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x) {
            color.at(x, y) = {static_cast<float>(x) / 128.f, static_cast<float>(y) / 128.f, 0};
            hole.at(x, y) = x > 30 && x < 100 && y > 40 && y < 90;
        }
    const ImageColor out = make_inpainter("harmonic")->fill(color, hole, {});
    for (std::size_t i = 0; i < out.size(); ++i) EXPECT_LT(length(out.pixels[i] - color.pixels[i]), 0.02f);
}

TEST(Inpainters, AnUnknownNameIsToldTheNames) {
    try {
        make_inpainter("crayon");
        FAIL() << "expected an error";
    } catch (const UsageError& e) {
        EXPECT_EQ(std::string(e.what()),
                  "--walk-inpainter: expected aotgan, harmonic or torchscript, found \"crayon\"");
    }
}

// Boards and discs of uniform color, slightly out of focus, with holes like those of walks: a band along an edge,
// cracks one pixel wide.
Picture torn_boards(std::uint64_t seed) {
    constexpr int kSize = 192;
    Picture p{ImageColor(kSize, kSize, Vec3f{0.5f, 0.45f, 0.4f}), ImageMask(kSize, kSize)};
    Random r(seed, "torn boards");
    for (int k = 0; k < 14; ++k) {
        const Vec3f color{r.uniform(0.02f, 0.9f), r.uniform(0.02f, 0.9f), r.uniform(0.02f, 0.9f)};
        const float cx = r.uniform(0, kSize), cy = r.uniform(0, kSize), turn = r.uniform(0, 3), a = r.uniform(10, 50),
                    b = r.uniform(6, 40);
        const bool disc = r.chance(0.3f);
        for (int y = 0; y < kSize; ++y)
            for (int x = 0; x < kSize; ++x) {
                const float dx = static_cast<float>(x) - cx, dy = static_cast<float>(y) - cy;
                const float u = dx * std::cos(turn) + dy * std::sin(turn),
                            v = dy * std::cos(turn) - dx * std::sin(turn);
                const float out = disc ? std::hypot(u, v) - a : std::max(std::fabs(u) - a, std::fabs(v) - b);
                p.color.at(x, y) = lerp(color, p.color.at(x, y), std::clamp(out / 2 + 0.5f, 0.f, 1.f));
            }
    }
    for (int k = 0; k < 12; ++k) {
        const float slope = r.uniform(-1.5f, 1.5f), at = r.uniform(0, kSize), width = k < 3 ? 5 : 1;
        const bool across = r.chance(0.5f);
        for (int y = 0; y < kSize; ++y)
            for (int x = 0; x < kSize; ++x) {
                const float along = static_cast<float>(across ? x : y), aside = static_cast<float>(across ? y : x);
                if (std::fabs(aside - at - slope * (along - kSize / 2)) < width) p.hole.at(x, y) = 255;
            }
    }
    return p;
}

double psnr_in_holes(const Picture& p, const ImageColor& made) {
    double squares = 0, count = 0;
    for (std::size_t i = 0; i < made.size(); ++i)
        if (p.hole.pixels[i]) {
            const Vec3f d = srgb_from_linear(made.pixels[i]) - srgb_from_linear(p.color.pixels[i]);
            squares += static_cast<double>(dot(d, d));
            count += 3;
        }
    return -10 * std::log10(squares / count);
}

// Only learned structure can improve on the fill it starts from: edges must continue through the holes.
TEST(ShippedAotgan, CarriesEdgesThroughHoles) {
    const auto aotgan = make_inpainter("aotgan"), harmonic = make_inpainter("harmonic");
    double gain = 0;
    constexpr int kPictures = 6;
    for (int i = 0; i < kPictures; ++i) {
        const Picture p = torn_boards(static_cast<std::uint64_t>(i));
        gain += (psnr_in_holes(p, aotgan->fill(p.color, p.hole, {})) -
                 psnr_in_holes(p, harmonic->fill(p.color, p.hole, {}))) /
                kPictures;
    }
    RecordProperty("gain_db", fmt::format("{:.2f}", gain));
    EXPECT_GT(gain, 0.8);
}

TEST(ShippedAotgan, SameBytesForAnyThreads) {
    const Picture p = torn_boards(9);
    const auto aotgan = make_inpainter("aotgan");
    set_threads(1);
    const ImageColor one = aotgan->fill(p.color, p.hole, {});
    set_threads(2);
    EXPECT_EQ(one, aotgan->fill(p.color, p.hole, {}));
    set_threads(0);
}

std::string refusal(const Weights& weights) {
    const auto file = std::filesystem::temp_directory_path() /
                      ("fastscene-inpaint-refused-" + std::to_string(::getpid()) + ".safetensors");
    save_safetensors(file, weights);
    std::string text;
    try {
        (void)make_inpainter("aotgan", file);
    } catch (const Error& e) {
        text = e.what();
    }
    std::filesystem::remove(file);
    return text;
}

TEST(Aotgan, WeightsThatDoNotFitAreNamed) {
    Weights weights = hashed_aotgan(4, 1);
    EXPECT_EQ(refusal(weights), "");
    Weights lacking = weights;
    lacking.tensors.erase("middle.0.gate.1.bias");
    EXPECT_NE(refusal(lacking).find("middle.0.gate.1.bias"), std::string::npos);
    Weights bent = weights;
    bent.tensors["decoder.4.weight"] = weights.at("decoder.0.conv.weight");
    EXPECT_NE(refusal(bent).find("decoder.4.weight: expected shape [3, 4, 3, 3]"), std::string::npos) << refusal(bent);
    EXPECT_NE(refusal({{}, {{"x", weights.at("encoder.1.bias")}}, {}, {}}).find("encoder.1.weight"), std::string::npos);
}

// The result matches the known pixels: in a uniform picture no seam is higher than a fraction of the difference between
// network and picture.
TEST(Aotgan, SeamsAreFeathered) {
    ImageColor color(192, 128, Vec3f{0.5f, 0.2f, 0.05f});
    ImageMask hole(192, 128);
    for (int y = 40; y < 90; ++y)
        for (int x = 60; x < 130; ++x) hole.at(x, y) = 1;
    const ImageColor out = make_inpainter("aotgan", small_weights())->fill(color, hole, {});
    EXPECT_LT(length(out.at(60, 65) - color.at(60, 65)), 0.12f);
    EXPECT_LT(length(out.at(95, 40) - color.at(95, 40)), 0.12f);
    EXPECT_GT(length(out.at(95, 65) - color.at(95, 65)), 1e-4f);  // … and inside it is the network's output
}

// Every hole pixel is in a crop; sizes respect their limits; small holes do not cost the whole picture.
TEST(Crops, CoverEveryHole) {
    Random r(5, "crops");
    for (int round = 0; round < 60; ++round) {
        ImageMask hole(40 + r.index(1200), 40 + r.index(700));
        for (int k = r.index(6); k >= 0; --k) {
            const int left = r.index(hole.width), top = r.index(hole.height), w = 1 + r.index(hole.width),
                      h = 1 + r.index(hole.height);
            for (int y = top; y < std::min(hole.height, top + h); ++y)
                for (int x = left; x < std::min(hole.width, left + w); ++x) hole.at(x, y) = 1;
        }
        ImageMask covered(hole.width, hole.height);
        for (const Crop& crop : crops_around(hole, 48, 8, 64, 512)) {
            EXPECT_TRUE(crop.width % 8 == 0 && crop.height % 8 == 0 && crop.width >= 64 && crop.height >= 64 &&
                        crop.width <= 512 && crop.height <= 512);
            EXPECT_TRUE(crop.x >= 0 && crop.y >= 0);
            for (int y = crop.y; y < std::min(hole.height, crop.y + crop.height); ++y)
                for (int x = crop.x; x < std::min(hole.width, crop.x + crop.width); ++x) covered.at(x, y) = 1;
        }
        for (std::size_t i = 0; i < hole.size(); ++i) ASSERT_TRUE(!hole.pixels[i] || covered.pixels[i]) << round;
    }
    ImageMask one(1024, 512);
    one.at(500, 250) = 1;
    const auto crops = crops_around(one, 48, 8, 64, 512);
    ASSERT_EQ(crops.size(), 1u);
    EXPECT_LE(crops[0].width, 104);
    EXPECT_TRUE(crops_around(ImageMask(1024, 512), 48, 8, 64, 512).empty());
}

}  // namespace
}  // namespace fastscene

// DA-2 besides what the golden outputs hold: sizes, angles, its file, the seam.
#include "fastscene/nn/da2.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fastscene/base/error.h"
#include "fastscene/nn/da2_net.h"
#include "fastscene/nn/hashed_da2.h"
#include "fastscene/nn/libtorch.h"
#include "fastscene/weights/safetensors.h"
#include "fastscene/nn/tiny_model.h"
#include "fastscene/nn/turned_passes.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;
using at::Tensor;

TEST(Da2, SeesPicturesAtThePublishedSizes) {
    struct {
        std::int64_t width, height, seen_width, seen_height;
        double sphere_width;
    } const cases[] = {{1092, 546, 1092, 546, 1092},
                       {1024, 512, 1078, 546, 1148.6},
                       {1920, 960, 1120, 560, 633.3},
                       {2048, 1024, 1120, 560, 593.7}};
    for (const auto& c : cases) {
        const nn::Da2Size size = nn::da2_size(c.height, c.width);
        EXPECT_EQ(size.width, c.seen_width);
        EXPECT_EQ(size.height, c.seen_height);
        EXPECT_NEAR(size.sphere.width, c.sphere_width, 0.05);
        EXPECT_NEAR(size.sphere.height, c.sphere_width / 2, 0.05);
    }
}

TEST(Da2, AnglesSpanTheSphereAtTheEvaluatedSizeOnly) {
    const auto angles = [](std::int64_t height, std::int64_t width, const nn::SphereSize& sphere) {
        return nn::sphere_angles(nn::sphere_directions(height, width, sphere)).view({height, width, 2});
    };
    const Tensor whole = angles(546, 1092, {1092, 546});
    EXPECT_NEAR(whole[0][0][0].item<double>(), -1.568, 1e-3);
    EXPECT_NEAR(whole[545][0][0].item<double>(), 1.568, 1e-3);
    EXPECT_NEAR(whole[273][0][1].item<double>(), -3.139, 1e-3);
    EXPECT_NEAR(whole[273][1091][1].item<double>(), 3.139, 1e-3);
    // Of a picture twice as large the sphere is half the network's: columns half a picture apart have one azimuth.
    const Tensor folded = angles(560, 1120, nn::da2_size(1024, 2048).sphere);
    EXPECT_LT(folded.select(2, 0).abs().max().item<double>(), std::numbers::pi / 2);
    EXPECT_NEAR(folded[100][20][1].item<double>(), folded[100][20 + 594][1].item<double>(), 0.01);
}

// A net that is right but for its unit, which varies from call to call, and a slope that shows at the borders.
TEST(TurnedPasses, CloseTheSeamAndKeepTheShape) {
    const std::int64_t h = 32, w = 64;
    const Tensor azimuth = (at::arange(w, at::kFloat) + 0.5) * (2 * std::numbers::pi / w);
    const Tensor truth = (2 + azimuth.cos()).view({1, 1, w}).expand({1, h, w}).contiguous();
    const Tensor color = at::stack({truth, truth, truth}, 1).contiguous();
    int calls = 0;
    const nn::DistanceNet net = [&](const Tensor& seen) {
        const Tensor slope = at::exp(0.2 * (at::arange(w, at::kFloat) / w - 0.5)).view({1, 1, w});
        return seen.select(1, 0) * slope * (1.f + 0.5f * static_cast<float>(calls++));
    };
    const auto seam = [w](const Tensor& found) {
        const Tensor log = found.log();
        return (log.select(2, 0) - log.select(2, w - 1)).abs().max().item<double>();
    };
    EXPECT_NEAR(seam(nn::over_turns(color, 1, net)), 0.2, 0.01);
    for (const int turns : {2, 3, 4}) {
        calls = 0;
        const Tensor found = nn::over_turns(color, turns, net);
        EXPECT_EQ(calls, turns);
        EXPECT_LT(seam(found), 0.02) << turns;
        const Tensor off = (found / truth).log();
        EXPECT_LT((off - off.mean()).abs().max().item<double>(), 0.075) << turns;
    }
}

class Da2File : public testing::Test {
  protected:
    void SetUp() override { fs::create_directories(folder_); }
    void TearDown() override { fs::remove_all(folder_); }
    fs::path saved(const Weights& weights) const {
        save_safetensors(folder_ / "da2.safetensors", weights);
        return folder_ / "da2.safetensors";
    }
    static Weights tiny() { return hashed_da2(64, 4, 64); }
    const fs::path folder_ = fs::temp_directory_path() / ("fastscene-da2-" + std::to_string(::getpid()));
};

TEST_F(Da2File, TheErrorNamesAllThatDoesNotFit) {
    Weights weights = tiny();
    weights.tensors["dino.norm.scale"] = weights.tensors.at("dino.norm.weight");
    weights.tensors.erase("dino.norm.weight");
    weights.tensors.at("dino.blocks.3.attn.proj.bias") = weights.tensors.at("dino.blocks.3.attn.qkv.bias");
    const fs::path file = saved(weights);
    const std::string text = message_of([&] { Da2::load(file); });
    EXPECT_NE(text.find(file.string()), std::string::npos) << text;
    EXPECT_NE(text.find("missing: dino.norm.weight [64]"), std::string::npos) << text;
    EXPECT_NE(text.find("other shapes: dino.blocks.3.attn.proj.bias (expected [64], found [192])"), std::string::npos)
        << text;
    EXPECT_NE(text.find("unexpected: dino.norm.scale"), std::string::npos) << text;
}

TEST_F(Da2File, WithoutMetadataItIsThePublishedNetwork) {
    Weights weights = tiny();
    weights.metadata.clear();
    const std::string text = message_of([&] { Da2::load(saved(weights)); });
    EXPECT_NE(text.find("missing: dino.blocks.10."), std::string::npos) << text;
    EXPECT_NE(text.find("dino.blocks.0.attn.proj.bias (expected [1024], found [64])"), std::string::npos) << text;
    std::size_t tensors = 0;
    std::int64_t numbers = 0;
    for (const nn::NamedShapes& shapes : {nn::da2_parameters({}), nn::da2_unused({})})
        for (const auto& [name, shape] : shapes) ++tensors, numbers += c10::multiply_integers(shape);
    EXPECT_EQ(tensors, 464u);  // of the published file
    EXPECT_EQ(numbers, 344615682);
}

TEST_F(Da2File, WhatIsNeverUsedMayBeLeftOut) {
    Weights weights = tiny();
    weights.tensors.erase("dino.mask_token");
    Da2::load(saved(weights));
    weights.tensors.at("dino.register_tokens") = weights.tensors.at("dino.norm.bias");
    const std::string text = message_of([&] { Da2::load(saved(weights)); });
    EXPECT_NE(text.find("dino.register_tokens"), std::string::npos) << text;
}

TEST_F(Da2File, IsRecognizedByItsNames) {
    EXPECT_TRUE(Da2::is_in(saved(tiny())));
    EXPECT_FALSE(Da2::is_in(folder_ / "absent.safetensors"));
    EXPECT_FALSE(Da2::is_in(fs::path(FASTSCENE_SOURCE_DIR) / "models/egformer-rooms.safetensors"));
}

ImageColor painted(int width) {
    ImageColor color(width, width / 2);
    for (int y = 0; y < color.height; ++y)
        for (int x = 0; x < width; ++x) {
            const float turn = 6.2831853f * static_cast<float>(x) / static_cast<float>(width);
            color.at(x, y) = {0.5f + 0.4f * std::sin(turn), 0.5f + 0.4f * std::cos(3 * turn),
                              static_cast<float>(y) / static_cast<float>(color.height)};
        }
    return color;
}

TEST_F(Da2File, GivesRelativeRangeOfEitherSize) {
    const Da2 network = Da2::load(saved(tiny()));
    const fastscene::Run run;
    const ImageColor picture = painted(160);
    const ImageF evaluated = network.relative_range(picture, Da2Resize::evaluation, 1, run),
                 inferred = network.relative_range(picture, Da2Resize::inference, 1, run);
    EXPECT_EQ(evaluated.width, 1092);
    EXPECT_EQ(evaluated.height, 546);
    EXPECT_TRUE(inferred.same_size(ImageF(160, 80)));
    std::vector<float> sorted = evaluated.pixels;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_GT(sorted[0], 0);
    EXPECT_NEAR(sorted[sorted.size() * 98 / 100], 1, 1e-3);
    EXPECT_EQ(network.relative_range(picture, Da2Resize::evaluation, 1, run), evaluated);

    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(network.relative_range(picture, Da2Resize::evaluation, 1, {0, nullptr, stop.get_token()}), Stopped);
}

// Rounding to 8 bits of mantissa in every product, on a network that amplifies nothing.
TEST_F(Da2File, InBfloat16IsAsNearAsItsRounding) {
    if (!Da2::gains_by_bf16({"cpu", ""})) GTEST_SKIP() << "this processor does not multiply bfloat16";
    const fs::path file = saved(tiny());
    const ImageColor picture = painted(160);
    const ImageF exact = Da2::load(file, {"cpu", ""}).relative_range(picture, Da2Resize::evaluation, 1, {}),
                 rounded = Da2::load(file, {"cpu", ""}, true).relative_range(picture, Da2Resize::evaluation, 1, {});
    double sum = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) sum += std::abs(std::log(rounded.pixels[i] / exact.pixels[i]));
    const double mean = sum / static_cast<double>(exact.size());
    EXPECT_GT(mean, 0);
    EXPECT_LT(mean, 0.03);
}

}  // namespace
}  // namespace fastscene

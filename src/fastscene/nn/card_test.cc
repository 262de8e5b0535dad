// What networks do otherwise on a graphics card. Where there is none, what leads there: choices, fallbacks, layers that
// must compute the same on both.
#include <ATen/ATen.h>
#include <c10/core/InferenceMode.h>
#include <gtest/gtest.h>

#include <limits>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/nn/aotgan.h"
#include "fastscene/nn/circular.h"
#include "fastscene/nn/egformer.h"
#include "fastscene/nn/fused.h"
#include "fastscene/nn/hashed.h"
#include "fastscene/nn/hashed_aotgan.h"
#include "fastscene/nn/layers.h"
#include "fastscene/nn/libtorch.h"
#include "fastscene/nn/replay.h"
#include "fastscene/weights/safetensors.h"
#include "fastscene/nn/sd_model.h"
#include "fastscene/weights/shipped.h"
#include "fastscene/nn/weights_torch.h"

namespace fastscene {
namespace {

using at::Tensor;
using nn::Scope;

std::string usage_message(const std::function<void()>& ask) {
    try {
        ask();
    } catch (const UsageError& error) {
        return error.what();
    }
    return "nothing was thrown";
}

TEST(Card, NetworksNameTheFlagOfACardThatIsNotThere) {
    if (at::hasCUDA()) GTEST_SKIP() << "there is a card";
    EXPECT_NE(usage_message([] {
                  Egformer::shipped("egformer-rooms", {"cuda", "--depth-device"});
              }).find("--depth-device: expected cpu"),
              std::string::npos);
    EXPECT_NE(usage_message([] {
                  Aotgan::of(shipped_weights("aotgan-rooms"), {"cuda", "--walk-device"});
              }).find("--walk-device: expected cpu"),
              std::string::npos);
}

TEST(Card, WhatOverflowsInHalvesIsMadeInFloats) {
    const c10::InferenceMode inference;
    const auto folder = std::filesystem::temp_directory_path() / "fastscene-card-test";
    make_directories(folder);
    Weights saved;
    saved.tensors["weight"] = nn::weight_of(at::full({2}, 300.f));
    save_safetensors(folder / "w.safetensors", saved);
    auto weights = std::make_unique<nn::FileWeights>(folder / "w.safetensors", at::kHalf);
    int made = 0;
    const auto squared = [&](const Scope& s, at::ScalarType type) {
        ++made;
        const Tensor weight = s.parameter("weight", {2});
        EXPECT_EQ(weight.scalar_type(), type);
        return (weight.to(at::kFloat).square()).to(type);  // 90000: no half
    };
    EXPECT_EQ(nn::without_overflow(weights, {}, squared)[0].item<float>(), 90000);
    EXPECT_EQ(made, 2);
    EXPECT_EQ(weights->type(), at::kFloat);
    (void)nn::without_overflow(weights, {}, squared);  // the floats stay
    EXPECT_EQ(made, 3);
    std::filesystem::remove_all(folder);
}

TEST(Card, ReplayOnACpuRunsTheNetworkEachTime) {
    const c10::InferenceMode inference;
    nn::Replay replay;
    int runs = 0;
    for (int i = 0; i < 4; ++i) {
        const Tensor out = replay({at::full({2}, static_cast<float>(i))}, [&](const std::vector<Tensor>& in) {
            ++runs;
            return in[0] * 2;
        });
        EXPECT_EQ(out[1].item<float>(), 2.f * static_cast<float>(i));
    }
    EXPECT_EQ(runs, 4);
}

TEST(Card, BlendsAtOnceAsColumnByColumn) {
    const c10::InferenceMode inference;
    const Tensor a = at::randn({1, 3, 5, 40}), b = at::randn({1, 3, 5, 36});
    for (const std::int64_t count : {1, 3, 7, 32, 36}) {
        const Tensor one_by_one = b.clone();
        for (std::int64_t i = 0; i < count; ++i) {
            const double share = static_cast<double>(i) / static_cast<double>(count);
            one_by_one.select(3, i).copy_(a.select(3, 40 - count + i) * (1 - share) + b.select(3, i) * share);
        }
        EXPECT_TRUE(at::equal(nn::blend_columns(a, b.clone(), count), one_by_one)) << count;
    }
}

// The largest difference, relative to the deviation of what is expected.
double difference(const Tensor& found, const Tensor& expected) {
    const Tensor there = expected.to(at::kFloat);
    return ((found.to(at::kCPU, at::kFloat) - there).abs().max() / there.std()).item<double>();
}

class OnACard : public ::testing::TestWithParam<at::ScalarType> {
  protected:
    void SetUp() override {
        if (!at::hasCUDA()) GTEST_SKIP() << "no graphics card, or a libtorch without CUDA";
    }
    at::TensorOptions there() const { return at::TensorOptions(at::kCUDA).dtype(GetParam()); }
    double tolerance() const { return GetParam() == at::kFloat ? 1e-4 : GetParam() == at::kHalf ? 5e-3 : 5e-2; }
};

TEST_P(OnACard, FusedLayersAreLibtorchs) {
    const c10::InferenceMode inference;
    for (const auto& [channels, groups, side] : {std::tuple{320, 32, 33}, {128, 32, 100}, {2560, 32, 3}, {64, 8, 1}}) {
        const Tensor x = at::randn({2, channels, side, side + 1}) + 0.5, weight = at::randn({channels}),
                     bias = at::randn({channels});
        for (const bool silu : {false, true}) {
            const Tensor fused = nn::fused_group_norm(x.to(there()), weight.to(there()), bias.to(there()), groups, 1e-5,
                                                      silu);
            if (!fused.defined()) GTEST_SKIP() << "no kernels in this build";
            const Tensor norm = at::group_norm(x, groups, weight, bias, 1e-5);
            EXPECT_LT(difference(fused, silu ? at::silu(norm) : norm), tolerance()) << channels << " " << silu;
        }
    }
    const Tensor both = at::randn({3, 50, 2 * 640});
    EXPECT_LT(difference(nn::fused_gated_gelu(both.to(there())), nn::gated_gelu(both)), tolerance());
}

TEST_P(OnACard, AttentionIsTheCpus) {
    const c10::InferenceMode inference;
    const Tensor q = at::randn({2, 300, 8 * 40}), k = at::randn({2, 77, 8 * 40}), v = at::randn({2, 77, 8 * 40});
    const Tensor found = nn::attention(q.to(there()), k.to(there()), v.to(there()), 8);
    EXPECT_LT(difference(found, nn::attention(q, k, v, 8)), 2 * tolerance());
}

TEST_P(OnACard, AReplayedNetworkIsTheNetwork) {
    const c10::InferenceMode inference;
    nn::HashedWeights weights(there());
    const auto net = [&](const std::vector<Tensor>& in) {
        return nn::group_norm_silu(Scope(weights) / "norm", nn::conv(Scope(weights) / "conv", in[0], 64) + in[1], 8,
                                   1e-5);
    };
    nn::Replay replay;
    for (int i = 0; i < 5; ++i)
        for (const std::int64_t side : {16, 24}) {  // two records
            const Tensor x = at::randn({2, 8, side, side}).to(there()), add = at::randn({64, 1, 1}).to(there());
            EXPECT_LT(difference(replay({x, add}, net), net({x, add}).to(at::kCPU)), 1e-3);
        }
}

INSTANTIATE_TEST_SUITE_P(Types, OnACard, ::testing::Values(at::kFloat, at::kHalf, at::kBFloat16));

TEST(Card, DepthAndInpaintingAreTheCpus) {
    if (!at::hasCUDA()) GTEST_SKIP() << "no graphics card, or a libtorch without CUDA";
    ImageColor picture(256, 128);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            picture.at(x, y) = {static_cast<float>(x) / 256, static_cast<float>(y) / 128, 0.3f};
    const ImageF here = Egformer::shipped("egformer-rooms", {"cpu"}).relative_depth(picture),
                 there = Egformer::shipped("egformer-rooms", {"cuda"}).relative_depth(picture);
    for (std::size_t i = 0; i < here.size(); ++i) ASSERT_NEAR(here.pixels[i], there.pixels[i], 1e-2);
    ImageMask hole(256, 128);
    for (int x = 100; x < 130; ++x) hole.at(x, 60) = 1;
    const auto painted = [&](const char* device) {
        return Aotgan::of(shipped_weights("aotgan-rooms"), {device}).paint({{picture, hole}}, {})[0];
    };
    const ImageColor ours = painted("cpu"), theirs = painted("cuda");
    for (std::size_t i = 0; i < ours.size(); ++i) ASSERT_NEAR(ours.pixels[i][0], theirs.pixels[i][0], 2e-2);
}

}  // namespace
}  // namespace fastscene

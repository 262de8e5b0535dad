// Networks must run on other devices than the CPU. No GPU is needed for the test: libtorch's "meta" device tracks
// shapes and types without data, and complains like CUDA about a tensor left on the CPU.
#include <ATen/ATen.h>
#include <c10/core/InferenceMode.h>
#include <gtest/gtest.h>
#include <torch/library.h>
#include <torch/version.h>

#include "fastscene/base/error.h"
#include "fastscene/nn/precision.h"
#include "fastscene/nn/rrdbnet.h"
#include "fastscene/nn/scope.h"
#include "fastscene/nn/sd_model.h"
#include "fastscene/nn/small_unet.h"
#include "fastscene/nn/vae.h"

namespace fastscene {
namespace {

using nn::Scope;

#if TORCH_VERSION_MAJOR < 2
// Layers for which libtorch 1.13 lacks a meta kernel.
void expect_same(const at::Tensor& x, const at::Tensor& weight, const c10::optional<at::Tensor>& bias) {
    TORCH_CHECK(
        x.is_meta() && weight.is_meta() && (!bias || bias->is_meta()) && x.scalar_type() == weight.scalar_type(),
        "expected all tensors on the same device and of the same type");
}
at::Tensor convolution_elsewhere(const at::Tensor& x, const at::Tensor& weight, const c10::optional<at::Tensor>& bias,
                                 at::IntArrayRef stride, at::IntArrayRef padding, at::IntArrayRef dilation, bool,
                                 at::IntArrayRef, std::int64_t) {
    expect_same(x, weight, bias);
    std::vector<std::int64_t> shape{x.size(0), weight.size(0)};
    for (std::size_t i = 0; i < 2; ++i) {
        const auto side = static_cast<std::int64_t>(i) + 2;
        shape.push_back((x.size(side) + 2 * padding[i] - dilation[i] * (weight.size(side) - 1) - 1) / stride[i] + 1);
    }
    return at::empty(shape, x.options());
}
std::tuple<at::Tensor, at::Tensor, at::Tensor> group_norm_elsewhere(const at::Tensor& x,
                                                                    const c10::optional<at::Tensor>& weight,
                                                                    const c10::optional<at::Tensor>& bias,
                                                                    c10::SymInt n, c10::SymInt, c10::SymInt,
                                                                    std::int64_t groups, double) {
    expect_same(x, *weight, bias);
    const at::Tensor of_groups = at::empty({n.expect_int(), groups}, x.options());
    return {at::empty_like(x), of_groups, of_groups};
}
std::tuple<at::Tensor, at::Tensor, at::Tensor> layer_norm_elsewhere(const at::Tensor& x, c10::SymIntArrayRef,
                                                                    const c10::optional<at::Tensor>& weight,
                                                                    const c10::optional<at::Tensor>& bias, double) {
    expect_same(x, *weight, bias);
    return {at::empty_like(x), at::empty_like(x), at::empty_like(x)};
}
TORCH_LIBRARY_IMPL(aten, Meta, library) {
    library.impl("convolution_overrideable", convolution_elsewhere);
    library.impl("native_group_norm", group_norm_elsewhere);
    library.impl("native_layer_norm", layer_norm_elsewhere);
}
#endif

class WeightsElsewhere final : public nn::WeightSource {
  public:
    explicit WeightsElsewhere(at::TensorOptions options) : options_(options) {}
    at::Tensor get(const std::string&, at::IntArrayRef shape) override { return at::empty(shape, options_); }
    bool has(const std::string&) const override { return true; }

  private:
    at::TensorOptions options_;
};

class NetworksElsewhere : public ::testing::TestWithParam<at::ScalarType> {
  protected:
    at::TensorOptions there = at::TensorOptions(at::kMeta).dtype(GetParam());
    WeightsElsewhere weights{there};
    Scope scope{weights};
    at::Tensor picture(std::int64_t channels, std::int64_t side) const {
        return at::empty({1, channels, side, side}, there);
    }
    void expect_there(const at::Tensor& x) const {
        EXPECT_TRUE(x.device() == at::Device(at::kMeta));
        EXPECT_EQ(x.scalar_type(), GetParam());
    }
};

TEST_P(NetworksElsewhere, DenoiserAndControl) {
    const c10::InferenceMode inference;
    const nn::UNetConfig config = nn::small_unet(12);
    nn::UNetConfig holding = config;
    holding.picture_widths = {4, 4, 8, 8};
    const at::Tensor text = at::empty({1, 7, 12}, there);
    const nn::Residuals held = nn::controlnet(scope, holding, picture(4, 8), 3, text, picture(3, 64));
    const at::Tensor noise = nn::unet(scope, config, picture(4, 8), 3, text, &held);
    EXPECT_EQ(noise.sizes(), at::IntArrayRef({1, 4, 8, 8}));
    expect_there(noise);
}

TEST_P(NetworksElsewhere, Pictures) {
    const c10::InferenceMode inference;
    nn::VaeConfig config;
    config.channels = {8, 8};
    config.layers = 1;
    config.groups = 4;
    expect_there(nn::vae_decode(scope, config, picture(4, 4)));
    expect_there(nn::vae_encode(scope, config, picture(3, 8)).mean);
    nn::RrdbConfig larger;
    larger.features = 4, larger.growth = 2, larger.blocks = 1, larger.scale = 2;
    expect_there(nn::rrdbnet(scope, larger, picture(3, 8)));
}

INSTANTIATE_TEST_SUITE_P(Types, NetworksElsewhere, ::testing::Values(at::kFloat, at::kBFloat16, at::kHalf));

TEST(Device, WhatIsNotThereIsToldWithTheFlag) {
    const auto message = [](const auto& ask) -> std::string {
        try {
            ask();
        } catch (const UsageError& error) {
            return error.what();
        }
        return "";
    };
    if (!at::hasCUDA()) {
        EXPECT_TRUE(nn::device_named("auto", "--panorama-device").is_cpu());
        EXPECT_NE(
            message([] { nn::device_named("cuda", "--panorama-device"); }).find("--panorama-device: expected cpu"),
            std::string::npos);
    }
    EXPECT_TRUE(nn::device_named("cpu", "--panorama-device").is_cpu());
    EXPECT_NE(message([] { nn::type_of_precision("fp16", at::kCPU); }).find("--panorama-device cuda"),
              std::string::npos);
    EXPECT_EQ(nn::type_of_precision("fp16", at::kCUDA), at::kHalf);
}

TEST(Device, AFullGraphicsCardIsToldInOurWords) {
    const auto full = []() -> ImageRgb8 {
        throw c10::OutOfMemoryError({"here", "here.cc", 1}, "CUDA out of memory. Tried to allocate 2.00 GiB");
    };
    try {
        nn::fitting_the_card(full);
        FAIL() << "nothing was thrown";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("--panorama-low-memory"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("2.00 GiB"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace fastscene

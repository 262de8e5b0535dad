// A widened generator computes the same function, and its copies can learn different things.
#include "fastscene/nn/libtorch.h"
#include "fastscene/nn/aotgan_widen.h"

#include <gtest/gtest.h>

#include "fastscene/base/error.h"
#include "fastscene/nn/hashed.h"
#include "fastscene/nn/weights_torch.h"

namespace fastscene::nn {
namespace {

struct Narrow {
    AotganShape shape;
    Weights weights{"narrow", {}, {{"holes", "harmonic"}}, {}};
    at::Tensor picture, mask, painted;
    explicit Narrow(bool skips) : shape{4, 2, {1, 2, 4, 8}, skips} {
        const at::NoGradGuard no_gradients;
        at::manual_seed(3);
        picture = at::rand({1, 3, 64, 64}) * 2 - 1;
        mask = (at::rand({1, 1, 64, 64}) < 0.2).to(at::kFloat);
        HashedWeights hashed;
        painted = aotgan_generator(Scope(hashed), shape, picture, mask);
        for (const auto& [key, tensor] : hashed.seen()) weights.tensors[key] = weight_of(tensor);
    }
};

TEST(AotganWidened, PaintsWhatTheNarrowOnePaints) {
    for (const bool skips : {false, true})
        for (const int times : {1, 2, 3}) {
            const Narrow narrow(skips);
            const Weights wide = widened(narrow.weights, narrow.shape, times, 7);
            const AotganShape shape = aotgan_shape(wide);
            EXPECT_EQ(shape.width, 4 * times);
            EXPECT_EQ(shape.skips, skips);
            EXPECT_EQ(wide.metadata.at("holes"), "harmonic");
            const at::NoGradGuard no_gradients;
            LoadedWeights source(wide);
            const at::Tensor painted = aotgan_generator(Scope(source), shape, narrow.picture, narrow.mask);
            EXPECT_LT((painted - narrow.painted).abs().max().item<double>(), 2e-4) << skips << " " << times;
            EXPECT_GT(narrow.painted.std().item<double>(), 1e-3);
        }
}

// Copies with equal outgoing weights would receive equal gradients forever.
TEST(AotganWidened, CopiesAreReadDifferently) {
    const Narrow narrow(true);
    const Weights wide = widened(narrow.weights, narrow.shape, 2, 7);
    for (const char* key : {"encoder.3.weight", "middle.1.fuse.1.weight", "middle.0.gate.1.weight",
                            "decoder.2.conv.weight", "decoder.4.weight"}) {
        const at::Tensor kernel = tensor_of(wide.at(key));
        const std::int64_t sources = std::string(key).find("fuse") != std::string::npos ? 4
                                     : std::string(key).starts_with("decoder")          ? 2
                                                                                        : 1;
        const at::Tensor copies = kernel.reshape({kernel.size(0), sources, 2, -1});
        EXPECT_GT((copies.select(2, 0) - copies.select(2, 1)).abs().mean().item<double>(),
                  0.1 * kernel.abs().mean().item<double>())
            << key;
    }
}

TEST(AotganWidened, WhatIsMissingIsNamed) {
    Narrow narrow(false);
    narrow.weights.tensors.erase("middle.1.fuse.1.bias");
    try {
        (void)widened(narrow.weights, narrow.shape, 2, 7);
        FAIL() << "no complaint";
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find("middle.1.fuse.1.bias"), std::string::npos) << e.what();
    }
}

}  // namespace
}  // namespace fastscene::nn

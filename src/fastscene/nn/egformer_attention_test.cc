// Fused CPU kernels against libtorch's operators in double precision: values and gradients.
#include <ATen/ATen.h>
#include <gtest/gtest.h>

#include <vector>

#include "fastscene/base/parallel.h"
#include "fastscene/nn/libtorch.h"
#include "fastscene/nn/deformable_attention.h"
#include "fastscene/nn/runtime.h"
#include "fastscene/nn/window_attention.h"

namespace fastscene::nn {
namespace {

using at::Tensor;

double gap_of(const Tensor& a, const Tensor& b) {
    return (a.to(at::kDouble) - b.to(at::kDouble)).abs().max().item<double>();
}
Tensor leaf(const Tensor& x, at::ScalarType type) { return x.detach().to(type).clone().requires_grad_(true); }

struct GridShape {
    std::int64_t n, height, width, heads, d;
};

class OfWindows : public testing::TestWithParam<std::tuple<GridShape, Windows>> {};

TEST_P(OfWindows, SayAndLearnWhatOperatorsDo) {
    const auto& [shape, windows] = GetParam();
    const auto& [n, h, w, heads, d] = shape;
    const bool columns = windows == Windows::columns;
    const std::int64_t c = heads * d, length = columns ? h : w;
    at::manual_seed(c + length);
    const Tensor numbers = at::randn({n, h * w, 3 * c}), bias = at::randn({columns ? 1 : h, length, length}),
                 back = at::randn({n, h * w, c}), loud = at::randn({n, columns ? w : h});
    const auto run = [&](at::ScalarType type, auto&& attention) {
        const Tensor qkv = leaf(numbers, type);
        const WindowAttention found = attention(qkv, bias.to(type), Grid{h, w}, heads, windows);
        ((found.said * back.to(type)).sum() + (found.loudness * loud.to(type)).sum()).backward();
        return std::vector<Tensor>{found.said.detach(), found.loudness.detach(), qkv.grad()};
    };
    const auto fused = run(at::kFloat, window_attention), exact = run(at::kDouble, window_attention_by_operators);
    for (std::size_t i = 0; i < fused.size(); ++i)
        EXPECT_LT(gap_of(fused[i], exact[i]), 2e-6 * (1 + exact[i].abs().max().item<double>())) << i;
}

INSTANTIATE_TEST_SUITE_P(OfAnySize, OfWindows,
                         testing::Combine(testing::Values(GridShape{1, 1, 2, 1, 1}, GridShape{2, 3, 6, 16, 16},
                                                          GridShape{2, 12, 24, 4, 12}, GridShape{1, 48, 96, 1, 16},
                                                          GridShape{1, 20, 40, 3, 33}),
                                          testing::Values(Windows::rows, Windows::columns)));

// All-zero scores have no direction: the output is zero, and no gradient is NaN.
TEST(WindowAttention, OfNothingIsNothing) {
    const Tensor qkv = leaf(at::zeros({1, 8, 6}), at::kFloat);
    const WindowAttention found = window_attention(qkv, at::zeros({1, 2, 2}), Grid{2, 4}, 1, Windows::columns);
    (found.said.sum() + found.loudness.sum()).backward();
    EXPECT_EQ(found.said.abs().max().item<float>(), 0.f);
    EXPECT_EQ(qkv.grad().abs().max().item<float>(), 0.f);
}

class OfPoints : public testing::TestWithParam<GridShape> {};

TEST_P(OfPoints, MixAndLearnWhatOperatorsDo) {
    const auto& [n, h, w, heads, d] = GetParam();
    const std::int64_t c = heads * d;
    at::manual_seed(c + w);
    // Sample points all over the grid and slightly beyond; none at pixel boundaries, where the gradient is
    // discontinuous.
    const Tensor patch = (at::rand({h * w, kTaps, 2}) * at::tensor({h + 2., w + 2.}, at::kFloat)).floor() - 1;
    const Tensor values = at::randn({n, h * w, c}), offsets = 0.2 + 0.2 * at::rand({n, h * w, heads * kTaps * 2}),
                 weights = at::rand({n, h * w, heads * kTaps}), back = at::randn({n, h * w, c});
    const auto run = [&](at::ScalarType type, auto&& mix) {
        const Tensor value = leaf(values, type), offset = leaf(offsets, type), weight = leaf(weights, type);
        const Tensor mixed = mix(value, offset, weight, patch.to(type), Grid{h, w}, heads);
        (mixed * back.to(type)).sum().backward();
        return std::vector<Tensor>{mixed.detach(), value.grad(), offset.grad(), weight.grad()};
    };
    const auto fused = run(at::kFloat, deformable_mix), exact = run(at::kDouble, deformable_mix_by_operators);
    for (std::size_t i = 0; i < fused.size(); ++i)
        EXPECT_LT(gap_of(fused[i], exact[i]), 2e-5 * (1 + exact[i].abs().max().item<double>())) << i;
}

INSTANTIATE_TEST_SUITE_P(OfAnySize, OfPoints,
                         testing::Values(GridShape{1, 2, 4, 1, 1}, GridShape{2, 12, 24, 2, 8},
                                         GridShape{1, 32, 64, 1, 16}, GridShape{2, 9, 10, 3, 33}));

TEST(DeformableMix, ReadsNothingBeyondItsGrid) {
    const Tensor value = at::ones({1, 8, 4}), weight = at::full({1, 8, kTaps}, 1. / kTaps),
                 patch = at::zeros({8, kTaps, 2});
    const Tensor nowhere = at::full({1, 8, kTaps * 2}, std::numeric_limits<double>::quiet_NaN()).to(at::kFloat);
    EXPECT_TRUE(deformable_mix(value, nowhere, weight, patch, Grid{2, 4}, 1).isnan().all().item<bool>());
    EXPECT_EQ(deformable_mix(value, at::full({1, 8, kTaps * 2}, 1e30).to(at::kFloat), weight, patch, Grid{2, 4}, 1)
                  .abs()
                  .max()
                  .item<float>(),
              0.f);
}

TEST(EgformerAttention, IsTheSameForAnyNumberOfThreads) {
    const at::NoGradGuard no_gradients;
    at::manual_seed(3);
    const Tensor qkv = at::randn({2, 200, 96}), bias = at::randn({1, 10, 10}), patch = 9 * at::rand({200, kTaps, 2}),
                 offset = at::randn({2, 200, 2 * kTaps * 2}), weight = at::rand({2, 200, 2 * kTaps});
    const auto both = [&](int threads) {
        set_threads(threads);
        use_our_threads();
        return at::cat({window_attention(qkv, bias, Grid{10, 20}, 2, Windows::columns).said,
                        deformable_mix(qkv.narrow(2, 0, 32), offset, weight, patch, Grid{10, 20}, 2)},
                       2);
    };
    const Tensor one = both(1), four = both(4);
    set_threads(0);
    use_our_threads();
    EXPECT_TRUE(at::equal(one, four));
}

}  // namespace
}  // namespace fastscene::nn

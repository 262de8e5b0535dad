#include "fastscene/nn/libtorch.h"
#include "fastscene/nn/attention.h"

#include <ATen/ATen.h>
#include <gtest/gtest.h>

#include <cmath>

#include "fastscene/nn/layers.h"

namespace fastscene::nn {
namespace {

using at::Tensor;

Tensor plain(const Tensor& q, const Tensor& k, const Tensor& v) {
    const Tensor a = q.to(at::kDouble), b = k.to(at::kDouble).transpose(1, 2), c = v.to(at::kDouble);
    return at::bmm(at::softmax(at::bmm(a, b) / std::sqrt(static_cast<double>(q.size(2))), -1), c);
}
double farthest(const Tensor& a, const Tensor& b) {
    return (a.to(at::kDouble) - b.to(at::kDouble)).abs().max().item<double>();
}

// Tolerances are at least ten times the differences between instruction sets (sse4, avx2, avx512).
constexpr double kAsGood = 1e-4, kAsGoodFarInBfloat16 = 0.08;  // observed: 5e-6 and 0.008

struct Shape {
    std::int64_t n, l, m, d;
};
constexpr Shape kShapes[] = {{1, 1, 1, 1},     {2, 37, 53, 7},    {3, 130, 481, 40},
                             {1, 64, 77, 160}, {1, 65, 960, 512}, {2, 200, 1000, 64}};

TEST(TiledAttention, IsSoftmaxOfProductsForAnyShape) {
    const at::NoGradGuard no_gradients;
    for (const auto& [n, l, m, d] : kShapes) {
        at::manual_seed(n + l + m + d);
        const Tensor q = 3 * at::randn({n, l, d}), k = 3 * at::randn({n, m, d}), v = at::randn({n, m, d});
        EXPECT_LT(farthest(tiled_attention(q, k, v), plain(q, k, v)), kAsGood) << l << " x " << m << " x " << d;
    }
}

// Inputs are exactly representable in bfloat16, so the only error is the rounding of weights and result.
TEST(TiledAttention, OfBfloat16IsAsNearAsItsRounding) {
    const at::NoGradGuard no_gradients;
    for (const auto& [n, l, m, d] : kShapes) {
        at::manual_seed(n + l + m + d);
        const auto drawn = [n = n, d = d](std::int64_t rows, double by) {
            return (by * at::randn({n, rows, d})).to(at::kBFloat16);
        };
        const Tensor q = drawn(l, 3), k = drawn(m, 3), v = drawn(m, 1), half = tiled_attention(q, k, v);
        EXPECT_EQ(half.scalar_type(), at::kBFloat16);
        EXPECT_LT(farthest(half, plain(q, k, v)), 0.02) << l << " x " << m << " x " << d;
        EXPECT_LT((half.to(at::kDouble) - plain(q, k, v)).square().mean().sqrt().item<double>(), 0.004)
            << l << " x " << m << " x " << d;
    }
    const Tensor far = (200 * at::randn({1, 700, 16})).to(at::kBFloat16), v = at::randn({1, 700, 16}).to(at::kBFloat16);
    EXPECT_LT(farthest(tiled_attention(far.narrow(1, 0, 20), far, v), plain(far.narrow(1, 0, 20), far, v)),
              kAsGoodFarInBfloat16);
}

TEST(TiledAttention, SurvivesScoresThatExpCannotHold) {
    const at::NoGradGuard no_gradients;
    at::manual_seed(1);
    const Tensor q = 200 * at::randn({1, 20, 16}), k = 200 * at::randn({1, 700, 16}), v = at::randn({1, 700, 16});
    EXPECT_LT(farthest(tiled_attention(q, k, v), plain(q, k, v)), 2e-3);
    const Tensor same = tiled_attention(at::zeros({1, 3, 16}), k, v);  // equal weights: the mean
    EXPECT_LT(farthest(same, v.mean(1, true).expand({1, 3, 16})), 1e-5);
}

TEST(TiledAttention, IsWhatLayersTakeWithoutGradientsAndGivesTheSame) {
    at::manual_seed(2);
    const Tensor q = at::randn({2, 90, 80}), k = at::randn({2, 77, 80}), v = at::randn({2, 77, 80});
    const Tensor with_gradients = attention(q, k, v, 8);
    const at::NoGradGuard no_gradients;
    EXPECT_LT(farthest(attention(q, k, v, 8), with_gradients), 1e-5);
    const Tensor half = attention(q.to(at::kBFloat16), k.to(at::kBFloat16), v.to(at::kBFloat16), 8);
    EXPECT_EQ(half.scalar_type(), at::kBFloat16);
    EXPECT_LT(farthest(half, with_gradients), 0.02);
}

}  // namespace
}  // namespace fastscene::nn

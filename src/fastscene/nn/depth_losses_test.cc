#include "fastscene/nn/depth_losses.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fastscene::nn {
namespace {

using at::Tensor;

// A smooth map with an edge in it.
Tensor some_depth() {
    Tensor map = at::linspace(1, 3, 32).view({1, 1, 1, 32}) + at::linspace(0, 1, 16).view({1, 1, 16, 1}).square();
    map = map.clone();
    map.narrow(3, 20, 6).add_(1.5);
    return map / 8;
}
double value(const Tensor& t) { return t.item<double>(); }

TEST(DepthLoss, KnowsNeitherScaleNorShift) {
    const Tensor truth = some_depth(), all = at::ones_like(truth);
    for (const double scale : {0.3, 1., 4.})
        for (const double shift : {-0.2, 0., 0.5})
            EXPECT_NEAR(value(depth_loss(truth * scale + shift, truth, all)), 0, 1e-6);
}

TEST(DepthLoss, AlignmentIsLeastSquares) {
    at::manual_seed(3);
    const Tensor truth = some_depth(), found = truth * 0.5 + 0.1 + 0.02 * at::randn_like(truth),
                 mask = (at::rand_like(truth) > 0.3).to(at::kFloat);
    const auto square = [&](const Tensor& x) { return value(((x - truth).square() * mask).sum()); };
    const Tensor aligned = aligned_depth(found, truth, mask);
    for (const double d : {-0.01, 0.01}) {
        EXPECT_GT(square(aligned + d), square(aligned));
        EXPECT_GT(square(aligned * (1 + d)), square(aligned));
    }
}

TEST(DepthLoss, EachPictureOfABatchIsAlignedAlone) {
    const Tensor truth = some_depth(), both = at::cat({truth * 2 + 1, truth * 0.1}), twice = at::cat({truth, truth});
    EXPECT_NEAR(value(depth_loss(both, twice, at::ones_like(twice))), 0, 1e-6);
}

TEST(DepthLoss, UnknownPixelsHaveNoSay) {
    const Tensor truth = some_depth(), found = truth * 2;
    Tensor mask = at::ones_like(truth), wrong = truth.clone();
    mask.narrow(2, 4, 5).zero_();
    wrong.narrow(2, 4, 5).fill_(100);
    EXPECT_NEAR(value(depth_loss(found, wrong, mask)), 0, 1e-5);
    EXPECT_EQ(value(depth_loss(found, wrong, at::zeros_like(mask))), 0);
}

TEST(DepthLoss, AConstantPictureIsJudgedAsItIs) {
    const Tensor truth = some_depth(), flat = at::full_like(truth, 0.25);
    EXPECT_NEAR(value(invariant_loss(aligned_depth(flat, truth, at::ones_like(truth)), truth, at::ones_like(truth))),
                value((truth - 0.25).abs().mean()), 1e-6);
}

TEST(DepthLoss, DirectCountsFactors) {
    const Tensor truth = some_depth(), mask = at::ones_like(truth);
    EXPECT_NEAR(value(direct_loss(truth, truth, mask)), 0, 1e-7);
    EXPECT_NEAR(value(direct_loss(truth * 2, truth, mask)), std::log(2.), 1e-5);
    EXPECT_NEAR(value(direct_loss(truth / 2, truth, mask)), std::log(2.), 1e-5);
}

// Closed form: one step of height 1 between two columns of 8, at four scales.
TEST(DepthLoss, GradientsCountEdgesAtEachScale) {
    Tensor truth = at::zeros({1, 1, 16, 16}), found = truth.clone();
    found.narrow(3, 8, 8).fill_(1);
    // At scale s there are 16/s rows, each with one jump among (16/s)^2 pixels.
    const double expected = 1. / 16 + 1. / 8 + 1. / 4 + 1. / 2;
    EXPECT_NEAR(value(gradient_loss(found, truth, at::ones_like(truth))), expected, 1e-6);
}

TEST(DepthLoss, GradientsFlowAndAgreeWithDifferences) {
    at::manual_seed(5);
    const Tensor truth = some_depth(), mask = at::ones_like(truth);
    Tensor found = (truth + 0.05 * at::randn_like(truth)).to(at::kDouble).set_requires_grad(true);
    const Tensor t = truth.to(at::kDouble), m = mask.to(at::kDouble);
    depth_loss(found, t, m).backward();
    const Tensor gradient = found.grad();
    for (const std::int64_t i : {7, 100, 333}) {
        const double h = 1e-6;
        Tensor up = found.detach().clone(), down = up.clone();
        up.view(-1)[i] += h, down.view(-1)[i] -= h;
        EXPECT_NEAR(value(gradient.view(-1)[i]),
                    (value(depth_loss(up, t, m)) - value(depth_loss(down, t, m))) / (2 * h), 1e-6);
    }
}

}  // namespace
}  // namespace fastscene::nn

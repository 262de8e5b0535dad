#include "fastscene/nn/panorama_loops.h"

#include <gtest/gtest.h>

#include "fastscene/nn/hashed.h"
#include "fastscene/nn/small_unet.h"

namespace fastscene {
namespace {

TEST(PanoramaLoops, WithGuidanceOneOnlyThePromptIsComputed) {
    const nn::UNetConfig config = nn::small_unet(32);
    const at::Tensor latents = nn::hashed_input("latents", {1, 4, 8, 16}),
                     text = nn::hashed_input("text", {2, 3, config.text_width});
    nn::HashedWeights weights;
    std::vector<std::int64_t> batches;
    const nn::Listener listener = [&](const std::string& name, const at::Tensor& output) {
        if (name == "conv_in") batches.push_back(output.size(0));
    };
    const auto made = [&](double guidance) {
        nn::TextToPanorama how;
        how.guidance = guidance;
        how.blend_columns = 1;
        const auto scheduler = nn::make_scheduler(nn::Sampler::ddim, {}, 2);
        return nn::text_to_panorama(nn::Scope(weights, "", &listener), config, *scheduler, latents, text, how);
    };
    const at::Tensor alone = made(1), both = made(1 + 1e-9);
    EXPECT_EQ(batches, (std::vector<std::int64_t>{1, 1, 2, 2}));
    EXPECT_LT((alone - both).abs().max().item<double>(), 1e-4) << "the same prompt leads";
    EXPECT_GT((alone - made(0)).abs().max().item<double>(), 1e-3) << "the negative one leads elsewhere";
}

}  // namespace
}  // namespace fastscene

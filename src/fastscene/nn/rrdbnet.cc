#include "fastscene/nn/rrdbnet.h"

#include "fastscene/nn/layers.h"
#include "fastscene/nn/unet_blocks.h"

namespace fastscene::nn {

using at::Tensor;

namespace {

Tensor leaky(const Tensor& x) { return at::leaky_relu(x, 0.2); }

// Five convolutions, each with the concatenation of all previous outputs as its input.
Tensor dense_block(const Scope& s, const Tensor& x, const RrdbConfig& config) {
    std::vector<Tensor> seen{x};
    for (int i = 1; i <= 4; ++i)
        seen.push_back(leaky(conv(s / ("conv" + std::to_string(i)), at::cat(seen, 1), config.growth)));
    return s.out(conv(s / "conv5", at::cat(seen, 1), config.features) * 0.2 + x);
}

Tensor block(const Scope& s, const Tensor& x, const RrdbConfig& config) {
    Tensor y = x;
    for (const char* name : {"rdb1", "rdb2", "rdb3"}) y = dense_block(s / name, y, config);
    return s.out(y * 0.2 + x);
}

}  // namespace

Tensor rrdbnet(const Scope& s, const RrdbConfig& config, const Tensor& x) {
    const Tensor first = conv(
        s / "conv_first", config.scale == 4 ? x : at::pixel_unshuffle(x, config.scale == 2 ? 2 : 4), config.features);
    Tensor y = first;
    for (std::int64_t i = 0; i < config.blocks; ++i) y = block(s / "body" / i, y, config);
    y = first + conv(s / "conv_body", y, config.features);
    for (const char* name : {"conv_up1", "conv_up2"}) y = leaky(conv(s / name, doubled(y), config.features));
    return conv(s / "conv_last", leaky(conv(s / "conv_hr", y, config.features)), 3);
}

}  // namespace fastscene::nn

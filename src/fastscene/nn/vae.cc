#include "fastscene/nn/vae.h"

#include <algorithm>

#include "fastscene/nn/config_fields.h"
#include "fastscene/nn/layers.h"
#include "fastscene/nn/unet_blocks.h"

namespace fastscene::nn {

using at::Tensor;

namespace {

constexpr double kEps = 1e-6;

// Single-head self-attention over all positions.
Tensor look_around(const Scope& s, const Tensor& x, const VaeConfig& config) {
    const std::int64_t c = x.size(1);
    const Tensor rows = group_norm(s / "group_norm", x, config.groups, kEps).flatten(2).transpose(1, 2);
    const Tensor y = attention(linear(s / "to_q", rows, c), linear(s / "to_k", rows, c), linear(s / "to_v", rows, c),
                               1);
    return s.out(linear(s / "to_out" / 0, y, c).transpose(1, 2).reshape(x.sizes()) + x);
}

Tensor block(const Scope& s, const Tensor& x, std::int64_t out, const VaeConfig& config) {
    return resnet(s, x, out, config.groups, kEps);
}

Tensor middle(const Scope& s, Tensor x, const VaeConfig& config) {
    const std::int64_t c = x.size(1);
    x = look_around(s / "attentions" / 0, block(s / "resnets" / 0, x, c, config), config);
    return s.out(block(s / "resnets" / 1, x, c, config));
}

Tensor head(const Scope& s, const Tensor& x, std::int64_t out, const VaeConfig& config) {
    return conv(s / "conv_out", group_norm_silu(s / "conv_norm_out", x, config.groups, kEps), out);
}

Tensor halved(const Scope& s, const Tensor& x) {  // padded on the right and at the bottom only
    return s.out(conv(s / "conv", at::constant_pad_nd(x, {0, 1, 0, 1}), x.size(1), {3, 2, 0}));
}

}  // namespace

VaeConfig vae_config(const Json& json, const std::string& where) {
    const ConfigFields f(json, where);
    VaeConfig c;
    if (const Json* act = f.find("act_fn"); act && *act != "silu" && *act != "swish")
        throw f.wrong("act_fn", "\"silu\"", *act);
    if (!f.flag("mid_block_add_attention", true)) throw f.wrong("mid_block_add_attention", "true", false);
    c.channels = f.list("block_out_channels");
    c.layers = f.whole("layers_per_block", 1);
    c.latent_channels = f.whole("latent_channels", 4);
    c.groups = f.whole("norm_num_groups", 32);
    c.sample_size = f.whole("sample_size", 512);
    c.scale = f.number("scaling_factor", 0.18215);
    if (!(c.scale > 0)) throw Error("{}: expected \"scaling_factor\" > 0, found {}", where, c.scale);
    if (c.latent_channels < 1) throw Error("{}: expected \"latent_channels\" from 1, found 0", where);
    const std::size_t down = f.kinds("down_block_types", "DownEncoderBlock2D", "DownEncoderBlock2D").size();
    const std::size_t up = f.kinds("up_block_types", "UpDecoderBlock2D", "UpDecoderBlock2D").size();
    if (down != c.channels.size() || up != c.channels.size())
        throw Error("{}: expected as many blocks as \"block_out_channels\" has entries ({}), found {} down and {} up",
                    where, c.channels.size(), down, up);
    if (c.groups < 1 ||
        std::any_of(c.channels.begin(), c.channels.end(), [&](std::int64_t n) { return n % c.groups != 0; }))
        throw Error("{}: expected \"block_out_channels\" to be multiples of \"norm_num_groups\", found {} groups",
                    where, c.groups);
    // Tiles overlap by a quarter, in whole latents.
    if (c.sample_size < 4 * c.factor() || c.sample_size % (4 * c.factor()))
        throw Error("{}: expected \"sample_size\" to be a multiple of {} pixels (four latents), found {}", where,
                    4 * c.factor(), c.sample_size);
    return c;
}

Tensor vae_decode(const Scope& root, const VaeConfig& config, const Tensor& z) {
    const Scope s = root / "decoder";
    Tensor x = conv(root / "post_quant_conv", z, config.latent_channels, {1, 1, 0});
    x = middle(s / "mid_block", conv(s / "conv_in", x, config.channels.back()), config);
    for (std::size_t i = 0; i < config.channels.size(); ++i) {
        const Scope up = s / "up_blocks" / static_cast<std::int64_t>(i);
        const std::int64_t c = config.channels[config.channels.size() - 1 - i];
        for (std::int64_t k = 0; k <= config.layers; ++k) x = block(up / "resnets" / k, x, c, config);
        if (i + 1 < config.channels.size()) x = conv(up / "upsamplers" / 0 / "conv", doubled(x), c);
        x = up.out(x);
    }
    return head(s, x, 3, config);
}

Gaussian vae_encode(const Scope& root, const VaeConfig& config, const Tensor& picture) {
    const Scope s = root / "encoder";
    Tensor x = conv(s / "conv_in", picture, config.channels[0]);
    for (std::size_t i = 0; i < config.channels.size(); ++i) {
        const Scope down = s / "down_blocks" / static_cast<std::int64_t>(i);
        for (std::int64_t k = 0; k < config.layers; ++k) x = block(down / "resnets" / k, x, config.channels[i], config);
        if (i + 1 < config.channels.size()) x = halved(down / "downsamplers" / 0, x);
        x = down.out(x);
    }
    x = head(s, middle(s / "mid_block", x, config), 2 * config.latent_channels, config);
    const std::vector<Tensor> halves = conv(root / "quant_conv", x, 2 * config.latent_channels, {1, 1, 0}).chunk(2, 1);
    return {halves[0], at::clamp(halves[1], -30, 20)};
}

}  // namespace fastscene::nn

#include "fastscene/nn/unet.h"

#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/nn/layers.h"
#include "fastscene/nn/unet_blocks.h"

namespace fastscene::nn {

using at::Tensor;

namespace {

Tensor time_embedding(const Scope& s, const Tensor& waves, const UNetConfig& config) {
    const std::int64_t width = 4 * config.channels[0];
    return s.out(linear(s / "linear_2", at::silu(linear(s / "linear_1", waves, width)), width));
}

TransformerShape transformer_shape(const UNetConfig& config, std::size_t level) {
    return {config.heads[level], config.groups, config.linear_projection, config.attention_in_float};
}

// The encoder: every block's output is kept for the skip connections.
std::vector<Tensor> way_down(const Scope& s, const UNetConfig& config, const Tensor& first, const Tensor& time,
                             const Tensor& text) {
    std::vector<Tensor> kept{first};
    for (std::size_t level = 0; level < config.channels.size(); ++level) {
        const Scope block = s / "down_blocks" / static_cast<std::int64_t>(level);
        for (std::int64_t i = 0; i < config.layers; ++i) {
            Tensor x = resnet(block / "resnets" / i, kept.back(), config.channels[level], config.groups, config.eps,
                              time);
            if (config.down_attention[level])
                x = transformer(block / "attentions" / i, x, text, transformer_shape(config, level));
            kept.push_back(x);
        }
        if (level + 1 == config.channels.size()) break;
        const Scope down = block / "downsamplers" / 0;
        kept.push_back(down.out(conv(down / "conv", kept.back(), config.channels[level], {3, 2, config.down_pad})));
    }
    return kept;
}

Tensor middle(const Scope& s, const UNetConfig& config, const Tensor& x, const Tensor& time, const Tensor& text) {
    const std::size_t last = config.channels.size() - 1;
    const std::int64_t width = config.channels[last];
    Tensor y = resnet(s / "resnets" / 0, x, width, config.groups, config.eps, time);
    y = transformer(s / "attentions" / 0, y, text, transformer_shape(config, last));
    return s.out(resnet(s / "resnets" / 1, y, width, config.groups, config.eps, time));
}

Tensor way_up(const Scope& s, const UNetConfig& config, Tensor x, std::vector<Tensor>& kept, const Tensor& time,
              const Tensor& text) {
    const std::size_t levels = config.channels.size();
    for (std::size_t i = 0; i < levels; ++i) {
        const std::size_t level = levels - 1 - i;
        const Scope block = s / "up_blocks" / static_cast<std::int64_t>(i);
        for (std::int64_t k = 0; k <= config.layers; ++k) {
            x = resnet(block / "resnets" / k, at::cat({x, kept.back()}, 1), config.channels[level], config.groups,
                       config.eps, time);
            kept.pop_back();
            if (config.up_attention[i])
                x = transformer(block / "attentions" / k, x, text, transformer_shape(config, level));
        }
        if (level == 0) break;
        // Upsamples to the size of the next skip connection: exactly double, except if a side was odd on the way down.
        const Scope up = block / "upsamplers" / 0;
        x = up.out(
            conv(up / "conv", resized_nearest(x, {kept.back().size(2), kept.back().size(3)}), config.channels[level]));
    }
    return x;
}

// The conditioning picture, downsampled by 8 to the latent's size.
Tensor picture_embedding(const Scope& s, const UNetConfig& config, const Tensor& picture) {
    const std::vector<std::int64_t>& widths = config.picture_widths;
    Tensor x = at::silu(conv(s / "conv_in", config.picture_reversed ? picture.flip({1}) : picture, widths[0]));
    for (std::size_t i = 0; i + 1 < widths.size(); ++i) {
        const auto block = static_cast<std::int64_t>(2 * i);
        x = at::silu(conv(s / "blocks" / block, x, widths[i]));
        x = at::silu(conv(s / "blocks" / (block + 1), x, widths[i + 1], {3, 2, 1}));
    }
    return s.out(conv(s / "conv_out", x, config.channels[0]));
}

}  // namespace

// Sinusoidal timestep embedding (Vaswani et al. 2017), in single precision whatever the network's type.
Tensor waves_of_time(double t, const UNetConfig& config, const Tensor& like) {
    const std::int64_t width = config.channels[0], half = width / 2;
    const Tensor exponent = at::arange(half, at::kFloat) *
                            (-std::log(10000.0) / (static_cast<double>(half) - config.frequency_shift));
    const Tensor angles = (at::exp(exponent) * static_cast<float>(t)).unsqueeze(0);
    const Tensor waves = config.cos_first ? at::cat({at::cos(angles), at::sin(angles)}, 1)
                                          : at::cat({at::sin(angles), at::cos(angles)}, 1);
    // Without waiting for what a graphics card is at.
    return waves.expand({like.size(0), width}).to(like.options(), /*non_blocking=*/true);
}

Tensor unet(const Scope& s, const UNetConfig& config, const Tensor& latent, const Tensor& waves, const Tensor& text,
            const Residuals* add) {
    const Tensor time = time_embedding(s / "time_embedding", waves, config);
    std::vector<Tensor> kept = way_down(s, config, conv(s / "conv_in", latent, config.channels[0]), time, text);
    Tensor x = middle(s / "mid_block", config, kept.back(), time, text);
    if (add) {
        for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = kept[i] + add->down[i];
        x = x + add->middle;
    }
    x = way_up(s, config, x, kept, time, text);
    return conv(s / "conv_out", group_norm_silu(s / "conv_norm_out", x, config.groups, config.eps),
                config.out_channels);
}

Tensor unet(const Scope& s, const UNetConfig& config, const Tensor& latent, double t, const Tensor& text,
            const Residuals* add) {
    return unet(s, config, latent, waves_of_time(t, config, latent), text, add);
}

Residuals controlnet(const Scope& s, const UNetConfig& config, const Tensor& latent, const Tensor& waves,
                     const Tensor& text, const Tensor& picture, double strength) {
    const Tensor time = time_embedding(s / "time_embedding", waves, config);
    const Tensor first = conv(s / "conv_in", latent, config.channels[0]) +
                         picture_embedding(s / "controlnet_cond_embedding", config, picture);
    const std::vector<Tensor> kept = way_down(s, config, first, time, text);
    const Tensor x = middle(s / "mid_block", config, kept.back(), time, text);
    Residuals out;
    for (std::size_t i = 0; i < kept.size(); ++i)
        out.down.push_back(
            conv(s / "controlnet_down_blocks" / static_cast<std::int64_t>(i), kept[i], kept[i].size(1), {1, 1, 0}) *
            strength);
    out.middle = conv(s / "controlnet_mid_block", x, x.size(1), {1, 1, 0}) * strength;
    return out;
}

Residuals controlnet(const Scope& s, const UNetConfig& config, const Tensor& latent, double t, const Tensor& text,
                     const Tensor& picture, double strength) {
    return controlnet(s, config, latent, waves_of_time(t, config, latent), text, picture, strength);
}

}  // namespace fastscene::nn

#include "fastscene/nn/egformer_net.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "fastscene/base/check.h"
#include "fastscene/nn/egformer_tables.h"
#include "fastscene/nn/deformable_attention.h"
#include "fastscene/nn/layers.h"
#include "fastscene/nn/window_attention.h"

namespace fastscene::nn {
namespace {

using at::Tensor;

Tensor table_tensor(std::vector<float> values, at::IntArrayRef shape) {
    return at::from_blob(values.data(), shape, at::kFloat).clone();
}

Grid grid_of(const EgformerShape& shape, int level) {
    return {shape.height >> (level + 1), shape.width >> (level + 1)};
}

Tensor picture_from_tokens(const Tensor& tokens, Grid grid) {
    return tokens.transpose(1, 2).reshape({tokens.size(0), tokens.size(2), grid.height, grid.width});
}
Tensor tokens_from_picture(const Tensor& picture) { return picture.flatten(2).transpose(1, 2).contiguous(); }

// ---- PanoFormer block: attention to nine points of the tangent patch, each displaced by a learned offset ----

// -> [N, h, w, C]
Tensor deformable_attention(const Scope& s, const Tensor& x, Grid grid, std::int64_t heads, const Tensor& patch) {
    const std::int64_t n = x.size(0), c = x.size(2), tokens = x.size(1);
    const Tensor query = linear(s / "q_proj", x, c), offset = linear(s / "offset_proj", query, 2 * kTaps * heads);
    const Tensor weight = at::softmax(linear(s / "A_proj", query, kTaps * heads).view({n, tokens, heads, kTaps}), -1)
                              .flatten(2);
    const Tensor mixed = deformable_mix(linear(s / "k_proj", x, c), offset, weight, patch, grid, heads)
                             .view({n, grid.height, grid.width, c});
    return s.out(linear(s / "wm_proj", mixed, c));
}

// Feed-forward network with a depthwise 3 x 3 convolution, circular padding horizontally.
Tensor local_feed_forward(const Scope& s, const Tensor& x, Grid grid) {
    const std::int64_t c = x.size(2), wide = 4 * c;
    const Tensor picture = picture_from_tokens(exact_gelu(linear(s / "linear1" / 0, x, wide)), grid);
    const Tensor round = at::cat({picture.narrow(3, grid.width - 1, 1), picture, picture.narrow(3, 0, 1)}, 3);
    const Scope depthwise = s / "dwconv" / 0;
    const Tensor mixed = at::conv2d(round, depthwise.parameter("weight", {wide, 1, 3, 3}),
                                    depthwise.parameter("bias", {wide}), 1, {1, 0}, 1, wide);
    return s.out(linear(s / "linear2" / 0, tokens_from_picture(exact_gelu(mixed)), c));
}

Tensor panoformer_layer(const Scope& s, Tensor x, Grid grid, std::int64_t heads, const Tensor& patch) {
    for (int i = 0; i < 2; ++i) {
        const Scope block = s / "blocks" / i;
        x = x + deformable_attention(block / "dattn", layer_norm(block / "norm1", x), grid, heads, patch).flatten(1, 2);
        x = block.out(x + local_feed_forward(block / "mlp", layer_norm(block / "norm2", x), grid));
    }
    return s.out(x);
}

// ---- EGformer block: attention within one row or column, biased by spherical geometry ----

// qkv [N, L, 3C]; x: the block's input [N, L, C]; bias: spherical distance between two tokens of a window (ERPE).
Tensor equirect_attention(const Scope& s, const Tensor& qkv, const Tensor& x, Grid grid, std::int64_t heads,
                          Windows windows, const Tensor& bias) {
    const std::int64_t n = x.size(0), c = x.size(2), h = grid.height, w = grid.width;
    const bool columns = windows == Windows::columns;
    const std::int64_t count = columns ? w : h, length = columns ? h : w;
    const auto [said, loudness] = window_attention(qkv, 0.1 * bias, grid, heads,
                                                   windows);  // no 1 / sqrt(d), as published
    // The weight of a window, relative to the picture's strongest one.
    const Tensor strength = at::clamp_min(loudness / loudness.amax(1, true), 0.5);
    const Tensor of_token = columns ? strength.view({n, 1, w, 1}) : strength.view({n, h, 1, 1});
    const Tensor raster = (said.view({n, h, w, c}) * of_token).view({n, h * w, c});
    // The remainder comes from the input (EaAR). As published, the input is divided in raster order into chunks of a
    // window's length even where windows are columns: the weights were trained that way.
    const Tensor rest = x.reshape({n, count, length, c}) * (1 - strength).view({n, count, 1, 1});
    return (s / "attns" / 0).out(raster + rest.view({n, h * w, c}));
}

Tensor equirect_block(const Scope& s, const Tensor& x, Grid grid, std::int64_t heads, Windows windows,
                      const Tensor& bias) {
    const std::int64_t c = x.size(2);
    const Tensor qkv = linear(s / "qkv", layer_norm(s / "norm1", x), 3 * c);
    const Tensor y = x + linear(s / "proj", equirect_attention(s, qkv, x, grid, heads, windows, bias), c);
    const Tensor fed = linear(s / "mlp" / "fc2",
                              exact_gelu(linear(s / "mlp" / "fc1", layer_norm(s / "norm2", y), 4 * c)), c);
    return s.out(y + fed);
}

// ---- the U-shaped network ----

// Number of heads of PanoFormer's attention (0: not used in this stage) and of EGformer's.
struct Stage {
    const char* name;
    int level;
    std::int64_t deformable_heads, heads;
};
constexpr Stage kDown[] = {{"stage1", 0, 1, 1}, {"stage2", 1, 2, 2}, {"stage3", 2, 0, 4}, {"stage4", 3, 0, 8}};
constexpr Stage kBottleneck = {"bottleneck", 4, 0, 16};
constexpr Stage kUp[] = {
    {"dec_stage5", 3, 0, 8}, {"dec_stage6", 2, 0, 4}, {"dec_stage7", 1, 4, 2}, {"dec_stage8", 0, 2, 1}};

// Two blocks: the first is PanoFormer's at high resolution and row attention at low resolution; the second is column
// attention.
Tensor run_stage(const Scope& root, const Stage& stage, const Tensor& x, const EgformerConstants& k) {
    const Scope s = root / stage.name;
    const Grid grid = grid_of(k.shape, stage.level);
    const auto level = static_cast<std::size_t>(stage.level);
    const Tensor first = stage.deformable_heads
                             ? panoformer_layer(s / 0, x, grid, stage.deformable_heads, k.patch[level])
                             : equirect_block(s / 0, x, grid, stage.heads, Windows::rows, k.row_bias[level]);
    return equirect_block(s / 1, first, grid, stage.heads, Windows::columns, k.column_bias[level]);
}

// conv3x3, GELU, LayerNorm -> tokens.
Tensor merged(const Scope& s, const Tensor& picture, std::int64_t channels, std::int64_t stride) {
    return layer_norm(s / "norm",
                      tokens_from_picture(exact_gelu(conv(s / "conv", picture, channels, {.stride = stride}))));
}
Tensor doubled_nearest(const Tensor& picture) {
    return at::upsample_nearest2d(picture, {2 * picture.size(2), 2 * picture.size(3)});
}

}  // namespace

EgformerConstants::EgformerConstants(const EgformerShape& of, at::Device device) : shape(of) {
    FASTSCENE_CHECK(shape.height % 32 == 0 && shape.width % 32 == 0 && shape.channels % 4 == 0);
    for (int level = 0; level < 5; ++level) {
        const auto i = static_cast<std::size_t>(level);
        const Grid g = grid_of(shape, level);
        const int h = static_cast<int>(g.height), w = static_cast<int>(g.width);
        if (level < 2) patch[i] = table_tensor(tangent_patch_table(h, w), {h * w, kTaps, 2}).to(device);
        column_bias[i] = table_tensor(vertical_chord_table(h), {1, h, h}).to(device);
        if (level >= 2) {
            // Rows near the poles are shorter circles.
            const Tensor shrink = at::sin(at::arange(h, at::kFloat) * (std::numbers::pi / h)).view({h, 1, 1});
            row_bias[i] = (table_tensor(horizontal_chord_table(w), {1, w, w}) * shrink).to(device);
        }
    }
}

Tensor egformer(const Scope& s, const EgformerConstants& k, const Tensor& color) {
    const std::int64_t c = k.shape.channels;
    FASTSCENE_CHECK(color.size(2) == k.shape.height && color.size(3) == k.shape.width);
    const Scope embed = s / "patch_embed";
    Tensor x = embed.out(layer_norm(embed / 2, tokens_from_picture(conv(embed / 0, color, c, {.stride = 2}))));

    std::array<Tensor, 4> seen;
    for (int i = 0; i < 4; ++i) {
        seen[static_cast<std::size_t>(i)] = x = run_stage(s, kDown[i], x, k);
        const Scope down = s / ("downsample" + std::to_string(i + 1));
        x = down.out(merged(down, picture_from_tokens(x, grid_of(k.shape, i)), c << (i + 1), 2));
    }
    x = run_stage(s, kBottleneck, x, k);
    for (int i = 0; i < 4; ++i) {
        const int level = kUp[i].level;
        const Grid grid = grid_of(k.shape, level);
        const Scope up = s / ("upsample" + std::to_string(i + 5)), tune = s / ("tune" + std::to_string(i + 5));
        x = up.out(merged(up, doubled_nearest(picture_from_tokens(x, grid_of(k.shape, level + 1))), c << level, 1));
        x = run_stage(s, kUp[i], x, k);
        const Tensor joined = at::cat(
            {picture_from_tokens(seen[static_cast<std::size_t>(level)], grid), picture_from_tokens(x, grid)}, 1);
        x = merged(tune, joined, c << level, 1);
        tune.out(picture_from_tokens(x, grid));
    }
    const Scope final_tune = s / "tune_final";
    Tensor picture = final_tune.out(picture_from_tokens(
        merged(final_tune, picture_from_tokens(x, grid_of(k.shape, 0)), c, 1), grid_of(k.shape, 0)));

    const Scope out = s / "output_conv";
    picture = conv(out / 0, picture, c);
    picture = (out / 1).out(at::upsample_bilinear2d(picture, {k.shape.height, k.shape.width}, true));
    picture = at::relu(conv(out / 2, picture, c));
    Tensor logits = conv(out / 4, picture, 1, {.kernel = 1, .pad = 0});
    if (k.shape.latitude_prior)
        logits = logits +
                 at::upsample_bilinear2d(s.parameter(kLatitudePrior, {1, 1, 32, 1}), {k.shape.height, 1}, false);
    return at::sigmoid(logits);
}

}  // namespace fastscene::nn

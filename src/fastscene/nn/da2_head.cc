#include "fastscene/nn/da2_head.h"

#include <vector>

#include "fastscene/nn/layers.h"
#include "fastscene/nn/precision.h"

namespace fastscene::nn {
namespace {

using at::Tensor;

constexpr std::int64_t kCrossHeadWidth = 64;
constexpr double kSlope = 0.01;  // of the leaky ReLUs

// x [1, N, C] attends once to the embedding of the viewing angles.
Tensor look_around(const Scope& s, const Tensor& x, const Tensor& embedding) {
    const std::int64_t c = x.size(2);
    const Tensor q = linear(s / "q", layer_norm(s / "norm_attnx", x), c, false);
    const std::vector<Tensor> kv = linear(s / "kv", layer_norm(s / "norm_attnctx", embedding), 2 * c, false)
                                       .chunk(2, -1);
    const Tensor seen = x + linear(s / "out", attention(q, kv[0], kv[1], c / kCrossHeadWidth), c, false);
    const Scope mlp = s / "mlp";
    return seen +
           mlp.out(linear(mlp / "proj2", exact_gelu(linear(mlp / "proj1", layer_norm(mlp / "norm", seen), 4 * c)), c));
}

// A transposed convolution whose kernel is its stride: each pixel becomes a block.
Tensor spread(const Scope& s, const Tensor& x, std::int64_t out, std::int64_t factor) {
    return s.out(at::conv_transpose2d(x, s.parameter("weight", {x.size(1), out, factor, factor}),
                                      s.parameter("bias", {out}), factor));
}

// x + gamma conv(leaky(conv(leaky(x))))
Tensor residual(const Scope& s, const Tensor& x) {
    const std::int64_t c = x.size(1);
    const Tensor inner = at::leaky_relu(conv(s / "conv1", at::leaky_relu(x, kSlope), c), kSlope);
    return s.out(at::addcmul(x, s.parameter("gamma", {1, c, 1, 1}), conv(s / "conv2", inner, c)));
}

// [1, C, h, w] -> [1, out, 2 h, 2 w]
Tensor upsampled(const Scope& s, Tensor x, std::int64_t out) {
    for (int i = 0; i < 2; ++i) x = residual(s / "convs" / i, x);
    x = conv(s / "up" / 0, x, out, {.kernel = 1, .pad = 0});
    return s.out(at::upsample_bilinear2d(x, {2 * x.size(2), 2 * x.size(3)}, false));
}

Tensor conv_reflected(const Scope& s, const Tensor& x, std::int64_t out) {
    const Tensor padded = at::reflection_pad2d(x, {1, 1, 1, 1});
    return s.out(at::conv2d(padded, s.parameter("weight", {out, x.size(1), 3, 3}), s.parameter("bias", {out})));
}

// Norm and linear layer over the channels of every pixel.
Tensor mixed_channels(const Scope& s, const Tensor& x) {
    const Tensor pixels = layer_norm(s / 0, x.permute({0, 2, 3, 1}));
    return s.out(linear(s / 1, pixels, x.size(1))).permute({0, 3, 1, 2}).contiguous();
}

// -> [1, features / 4, 8 rows, 8 columns]
Tensor upsampled_features(const Scope& root, std::int64_t features, const std::array<Tensor, 4>& maps,
                          const Tensor& embedding) {
    const Scope outer = root / "vit_w_esphere", s = outer / "_vit_w_esphere";
    const std::int64_t rows = maps[0].size(1), columns = maps[0].size(2);
    std::array<Tensor, 4> seen;  // [1, N, features]
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const auto index = static_cast<std::int64_t>(i);
        const Tensor aligned = linear(outer / "dim_aligner" / "aligners" / index, maps[i], features);
        const Scope camera = s / "prompt_camera" / index;
        seen[i] = camera.out(
            look_around(camera / "layers" / 0, aligned.flatten(1, 2).to(embedding.scalar_type()), embedding));
    }
    const auto picture = [&](const Tensor& tokens) {
        return tokens.transpose(1, 2).reshape({1, features, rows, columns});
    };
    Tensor x = picture(linear(s / "to_latents", seen[0], features));
    constexpr std::int64_t kFactors[] = {1, 2, 4};
    const std::int64_t in[] = {features, features, features / 2}, out[] = {features, features / 2, features / 4};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto index = static_cast<std::int64_t>(i);
        x = x + spread(s / "process_features" / index, picture(seen[i + 1]), in[i], kFactors[i]);
        x = upsampled(s / "up_sampler" / index, x, out[i]);
    }
    return x;
}

}  // namespace

Tensor da2_head(const Scope& root, std::int64_t features, const std::array<Tensor, 4>& maps, const Tensor& embedding,
                std::int64_t height, std::int64_t width, bool bf16) {
    const Tensor rough =
        [&] {
            const Autocast autocast(embedding.device(), bf16);
            return upsampled_features(root, features, maps, embedding);
        }()
            .to(embedding.scalar_type());
    const Scope s = root / "vit_w_esphere" / "_vit_w_esphere";
    Tensor x = conv_reflected(s / "to_depth_lr", mixed_channels(s / "pred_head" / 2, rough), features / 8);
    x = at::upsample_bilinear2d(x, {height, width}, true);
    const Scope fine = s / "to_depth_hr";
    x = at::leaky_relu(conv_reflected(fine / 0, x, features / 16), kSlope);
    return fine.out(conv(fine / 2, x, 1, {.kernel = 1, .pad = 0}));
}

}  // namespace fastscene::nn

#include "fastscene/nn/dinov2.h"

#include <vector>

#include "fastscene/base/check.h"
#include "fastscene/nn/layers.h"

namespace fastscene::nn {
namespace {

using at::Tensor;

constexpr std::int64_t kTableSide = 37;  // of the position table: pictures of 518 x 518 in DINOv2's training

// [1, rows columns + 1, C]; the first entry is the class token's.
Tensor positions(const Scope& s, std::int64_t width, std::int64_t rows, std::int64_t columns) {
    const Tensor table = s.parameter("pos_embed", {1, kTableSide * kTableSide + 1, width});
    const Tensor square =
        table.narrow(1, 1, kTableSide * kTableSide).transpose(1, 2).reshape({1, width, kTableSide, kTableSide});
    const Tensor grid = at::upsample_bicubic2d(square, {rows, columns}, false).flatten(2).transpose(1, 2);
    return (s / "positions").out(at::cat({table.narrow(1, 0, 1), grid}, 1));
}

Tensor self_attention(const Scope& s, const Tensor& x) {
    const std::int64_t c = x.size(2);
    const std::vector<Tensor> qkv = linear(s / "qkv", x, 3 * c).chunk(3, -1);
    return s.out(linear(s / "proj", attention(qkv[0], qkv[1], qkv[2], c / kDinoHeadWidth), c));
}

Tensor feed_forward(const Scope& s, const Tensor& x) {
    const std::int64_t c = x.size(2);
    return s.out(linear(s / "fc2", exact_gelu(linear(s / "fc1", x, 4 * c)), c));
}

// x + gamma y (LayerScale)
Tensor plus_scaled(const Scope& s, const Tensor& x, const Tensor& y) {
    return at::addcmul(x, s.parameter("gamma", {x.size(2)}), y);
}

Tensor block(const Scope& s, const Tensor& x) {
    const Tensor seen = plus_scaled(s / "ls1", x, self_attention(s / "attn", layer_norm(s / "norm1", x)));
    return s.out(plus_scaled(s / "ls2", seen, feed_forward(s / "mlp", layer_norm(s / "norm2", seen))));
}

}  // namespace

std::array<Tensor, 4> dino_features(const Scope& root, const DinoShape& shape, const Tensor& picture) {
    FASTSCENE_CHECK(picture.size(2) % kDinoPatch == 0 && picture.size(3) % kDinoPatch == 0 && shape.blocks % 4 == 0);
    const std::int64_t rows = picture.size(2) / kDinoPatch, columns = picture.size(3) / kDinoPatch;
    const Scope s = root / "dino", embed = s / "patch_embed";
    const Tensor patches = conv(embed / "proj", picture, shape.width,
                                {.kernel = kDinoPatch, .stride = kDinoPatch, .pad = 0});
    Tensor x = at::cat({s.parameter("cls_token", {1, 1, shape.width}), embed.out(patches.flatten(2).transpose(1, 2))},
                       1);
    x = (s / "tokens").out(x + positions(s, shape.width, rows, columns));
    std::array<Tensor, 4> features;
    for (std::int64_t i = 0; i < shape.blocks; ++i) {
        x = block(s / "blocks" / i, x);
        if (const std::int64_t done = i + 1; done % (shape.blocks / 4) == 0) {
            const std::int64_t which = done / (shape.blocks / 4) - 1;
            features[static_cast<std::size_t>(which)] = (s / "features" / which)
                                                            .out(layer_norm(s / "norm", x)
                                                                     .narrow(1, 1, rows * columns)
                                                                     .reshape({1, rows, columns, shape.width}));
        }
    }
    return features;
}

}  // namespace fastscene::nn

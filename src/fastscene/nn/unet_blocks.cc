#include "fastscene/nn/unet_blocks.h"

#include "fastscene/nn/layers.h"

namespace fastscene::nn {

using at::Tensor;

namespace {

Tensor attend(const Scope& s, const Tensor& x, const Tensor& context, const TransformerShape& shape) {
    const std::int64_t width = x.size(2);
    const Tensor q = linear(s / "to_q", x, width, false), k = linear(s / "to_k", context, width, false),
                 v = linear(s / "to_v", context, width, false);
    const Tensor seen = (s / "attention").out(attention(q, k, v, shape.heads, {}, shape.in_float));
    return s.out(linear(s / "to_out" / 0, seen, width));
}

// GEGLU
Tensor feed_forward(const Scope& s, const Tensor& x) {
    const std::int64_t width = x.size(2);
    const Tensor inner = (s / "net" / 0).out(gated_gelu(linear(s / "net" / 0 / "proj", x, 8 * width)));
    return s.out(linear(s / "net" / 2, inner, width));
}

Tensor transformer_block(const Scope& s, Tensor x, const Tensor& text, const TransformerShape& shape) {
    Tensor y = layer_norm(s / "norm1", x);
    x = attend(s / "attn1", y, y, shape) + x;
    x = attend(s / "attn2", layer_norm(s / "norm2", x), text, shape) + x;
    return s.out(feed_forward(s / "ff", layer_norm(s / "norm3", x)) + x);
}

}  // namespace

Tensor resnet(const Scope& s, const Tensor& x, std::int64_t out, std::int64_t groups, double eps, const Tensor& time) {
    Tensor h = conv(s / "conv1", group_norm_silu(s / "norm1", x, groups, eps), out);
    if (time.defined()) h = h + linear(s / "time_emb_proj", at::silu(time), out).unsqueeze(-1).unsqueeze(-1);
    h = conv(s / "conv2", group_norm_silu(s / "norm2", h, groups, eps), out);
    return s.out((x.size(1) == out ? x : conv(s / "conv_shortcut", x, out, {1, 1, 0})) + h);
}

Tensor transformer(const Scope& s, const Tensor& x, const Tensor& text, const TransformerShape& shape) {
    const std::int64_t n = x.size(0), c = x.size(1), h = x.size(2), w = x.size(3);
    const auto rows = [](const Tensor& t) { return t.flatten(2).transpose(1, 2); };  // [N, HW, C]
    const auto picture = [&](const Tensor& t) { return t.transpose(1, 2).reshape({n, c, h, w}); };
    Tensor y = group_norm(s / "norm", x, shape.groups, 1e-6);
    y = shape.linear_projection ? linear(s / "proj_in", rows(y), c) : rows(conv(s / "proj_in", y, c, {1, 1, 0}));
    y = transformer_block(s / "transformer_blocks" / 0, y, text, shape);
    y = shape.linear_projection ? picture(linear(s / "proj_out", y, c))
                                : conv(s / "proj_out", picture(y), c, {1, 1, 0});
    return s.out(y + x);
}

Tensor doubled(const Tensor& x) { return resized_nearest(x, {2 * x.size(2), 2 * x.size(3)}); }

Tensor resized_nearest(const Tensor& x, at::IntArrayRef height_width) {
    return at::upsample_nearest2d(x, height_width);
}

}  // namespace fastscene::nn

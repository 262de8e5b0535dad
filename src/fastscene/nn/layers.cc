#include "fastscene/nn/layers.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fastscene/base/check.h"
#include "fastscene/nn/attention.h"
#include "fastscene/nn/fused.h"
#include "fastscene/nn/libtorch.h"

namespace fastscene::nn {

using at::Tensor;

// More rows at once exceed the caches: 1024 rows take 1.9 times as long for a 64 x 128 latent. A GPU prefers large
// blocks.
constexpr std::int64_t kAttentionRows = 256, kAttentionRowsCuda = 4096;

Tensor conv(const Scope& s, const Tensor& x, std::int64_t out, Conv shape) {
    const Tensor weight = s.parameter("weight", {out, x.size(1), shape.kernel, shape.kernel});
    const Tensor bias = shape.bias ? s.parameter("bias", {out}) : Tensor();
    return s.out(at::conv2d(x, weight, bias, shape.stride, shape.pad));
}

Tensor linear(const Scope& s, const Tensor& x, std::int64_t out, bool bias) {
    const Tensor weight = s.parameter("weight", {out, x.size(-1)});
    return s.out(bias ? at::linear(x, weight, s.parameter("bias", {out})) : at::linear(x, weight));
}

Tensor group_norm(const Scope& s, const Tensor& x, std::int64_t groups, double eps) {
    const std::int64_t channels = x.size(1);
    const Tensor weight = s.parameter(
        "weight", {channels});  // the accumulation type, even if a preceding convolution used lower precision
    const Tensor bias = s.parameter("bias", {channels}), given = x.to(weight.scalar_type());
    const Tensor fused = fused_group_norm(given, weight, bias, groups, eps, false);
    return s.out(fused.defined() ? fused : at::group_norm(given, groups, weight, bias, eps));
}

Tensor group_norm_silu(const Scope& s, const Tensor& x, std::int64_t groups, double eps) {
    if (s.is_heard()) return at::silu(group_norm(s, x, groups, eps));  // the norm's own output is asked for
    const std::int64_t channels = x.size(1);
    const Tensor weight = s.parameter("weight", {channels}), bias = s.parameter("bias", {channels});
    const Tensor given = x.to(weight.scalar_type());
    const Tensor fused = fused_group_norm(given, weight, bias, groups, eps, true);
    return fused.defined() ? fused : at::silu(at::group_norm(given, groups, weight, bias, eps));
}

Tensor gated_gelu(const Tensor& x) {
    const Tensor fused = fused_gated_gelu(x);
    if (fused.defined()) return fused;
    const std::vector<Tensor> halves = x.chunk(2, -1);
    return halves[0] * at::gelu(halves[1]);
}

Tensor layer_norm(const Scope& s, const Tensor& x, double eps) {
    const std::int64_t channels = x.size(-1);
    return s.out(
        at::layer_norm(x, {channels}, s.parameter("weight", {channels}), s.parameter("bias", {channels}), eps));
}

namespace {

Tensor split_heads(const Tensor& x, std::int64_t heads) {  // [N, L, heads d] -> [N heads, L, d]
    const std::int64_t n = x.size(0), l = x.size(1), d = x.size(2) / heads;
    return x.reshape({n, l, heads, d}).permute({0, 2, 1, 3}).reshape({n * heads, l, d});
}
Tensor join_heads(const Tensor& x, std::int64_t heads) {
    const std::int64_t n = x.size(0) / heads, l = x.size(1), d = x.size(2);
    return x.reshape({n, heads, l, d}).permute({0, 2, 1, 3}).reshape({n, l, heads * d});
}

}  // namespace

Tensor attention(const Tensor& q, const Tensor& k, const Tensor& v, std::int64_t heads, const Tensor& mask,
                 bool in_float) {
    FASTSCENE_CHECK(heads > 0 && q.size(2) % heads == 0);
    if (!mask.defined() && q.device().is_cpu() && q.scalar_type() != at::kDouble && !at::GradMode::is_enabled()) {
        const at::ScalarType type = q.scalar_type() == at::kBFloat16 ? at::kBFloat16 : at::kFloat;
        const auto rows = [heads, type](const Tensor& x) { return split_heads(x, heads).to(type); };
        return join_heads(tiled_attention(rows(q), rows(k), rows(v)), heads).to(v.scalar_type());
    }
    if (!mask.defined() && q.is_cuda()) {
        const auto by_head = [heads](const Tensor& x) {  // a view: [N, L, heads d] -> [N, heads, L, d]
            return x.reshape({x.size(0), x.size(1), heads, x.size(2) / heads}).transpose(1, 2);
        };
        const Tensor seen = fused_attention(by_head(q), by_head(k), by_head(v));
        if (seen.defined()) return seen.transpose(1, 2).reshape(q.sizes());
    }
    const Tensor scaled = split_heads(q, heads) * (1 / std::sqrt(static_cast<double>(q.size(2) / heads)));
    const Tensor keys = split_heads(k, heads).transpose(1, 2), values = split_heads(v, heads);
    std::vector<Tensor> rows;
    const std::int64_t most = q.is_cuda() ? kAttentionRowsCuda : kAttentionRows;
    for (std::int64_t from = 0; from < scaled.size(1); from += most) {
        const std::int64_t count = std::min(most, scaled.size(1) - from);
        const Tensor some = scaled.narrow(1, from, count);
        Tensor weights = in_float ? at::bmm(some.to(at::kFloat), keys.to(at::kFloat)) : at::bmm(some, keys);
        if (mask.defined()) weights = weights + mask.narrow(0, from, count);
        rows.push_back(at::bmm(at::softmax(weights, -1).to(values.scalar_type()), values));
    }
    return join_heads(rows.size() == 1 ? rows[0] : at::cat(rows, 1), heads);
}

}  // namespace fastscene::nn

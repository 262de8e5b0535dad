#include "fastscene/nn/deformable_attention.h"

#include <ATen/ATen.h>
#include <ATen/Parallel.h>
#include <torch/csrc/autograd/custom_function.h>

#include <array>
#include <cmath>

namespace fastscene::nn {
namespace {

using at::Tensor;

// A bilinear sample and its derivative with respect to the position.
struct SampledPoint {
    std::array<std::int64_t, 4> token;  // top left, top right, bottom left, bottom right; 0 outside the grid
    std::array<float, 4> share, by_column, by_row;

    SampledPoint(float row, float column, Grid grid) {
        const auto w = static_cast<float>(grid.width), h = static_cast<float>(grid.height);
        const float x = column * (w / (w - 1)) - 0.5f, y = row * (h / (h - 1)) - 0.5f, left = std::floor(x),
                    up = std::floor(y), right = x - left, down = y - up;
        for (int corner = 0; corner < 4; ++corner) {
            const auto i = static_cast<std::size_t>(corner);
            const float cx = left + static_cast<float>(corner % 2), cy = up + static_cast<float>(corner / 2);
            const bool inside = cx >= 0 && cx < w && cy >= 0 && cy < h;  // also false for NaN
            const float across = corner % 2 ? right : 1 - right, along = corner / 2 ? down : 1 - down,
                        here = inside ? 1.f : 0.f;
            token[i] = inside ? static_cast<std::int64_t>(cy) * grid.width + static_cast<std::int64_t>(cx) : 0;
            share[i] = here * across * along;
            by_column[i] = here * along * (corner % 2 ? w : -w) / (w - 1);
            by_row[i] = here * across * (corner / 2 ? h : -h) / (h - 1);
        }
    }
};

struct MixSizes {
    Grid grid;
    std::int64_t n, tokens, channels, heads, d;
    MixSizes(const Tensor& value, Grid of, std::int64_t of_heads)
        : grid(of),
          n(value.size(0)),
          tokens(value.size(1)),
          channels(value.size(2)),
          heads(of_heads),
          d(channels / heads) {}
};

// For each token and head from `begin` on, calls body(first channel of the head, first tap). Indices run over pictures
// and tokens.
void for_each_head(const MixSizes& at, std::int64_t begin, std::int64_t end, const auto& body) {
    for (std::int64_t token = begin; token < end; ++token)
        for (std::int64_t head = 0; head < at.heads; ++head)
            body(token, token * at.channels + head * at.d, (token * at.heads + head) * kTaps);
}

class MixFunction : public torch::autograd::Function<MixFunction> {
  public:
    static Tensor forward(torch::autograd::AutogradContext* context, const Tensor& value, const Tensor& offset,
                          const Tensor& weight, const Tensor& patch, std::int64_t height, std::int64_t width,
                          std::int64_t heads) {
        const MixSizes at(value, {height, width}, heads);
        context->save_for_backward({value, offset, weight, patch});
        context->saved_data["height"] = height, context->saved_data["width"] = width,
        context->saved_data["heads"] = heads;
        const Tensor mixed = at::zeros_like(value);
        const float *values = value.data_ptr<float>(), *offsets = offset.data_ptr<float>(),
                    *weights = weight.data_ptr<float>(), *points = patch.data_ptr<float>();
        float* out = mixed.data_ptr<float>();
        at::parallel_for(0, at.n * at.tokens, 256, [&](std::int64_t begin, std::int64_t end) {
            for_each_head(at, begin, end, [&](std::int64_t token, std::int64_t channel, std::int64_t tap) {
                const float* of = values + token / at.tokens * at.tokens * at.channels + channel % at.channels;
                for (std::int64_t i = 0; i < kTaps; ++i) {
                    const float *point = points + (token % at.tokens * kTaps + i) * 2, *moved = offsets + (tap + i) * 2;
                    const SampledPoint sampled(point[0] + moved[0], point[1] + moved[1], at.grid);
                    for (std::size_t corner = 0; corner < 4; ++corner) {
                        const float* from = of + sampled.token[corner] * at.channels;
                        const float share = weights[tap + i] * sampled.share[corner];
                        for (std::int64_t c = 0; c < at.d; ++c) out[channel + c] += share * from[c];
                    }
                }
            });
        });
        return mixed;
    }

    static torch::autograd::tensor_list backward(torch::autograd::AutogradContext* context,
                                                 torch::autograd::tensor_list gradients) {
        const auto saved = context->get_saved_variables();
        const Tensor &value = saved[0], &offset = saved[1], &weight = saved[2], back = gradients[0].contiguous();
        const MixSizes at(value, {context->saved_data["height"].toInt(), context->saved_data["width"].toInt()},
                          context->saved_data["heads"].toInt());
        const Tensor to_value = at::zeros_like(value), to_offset = at::empty_like(offset),
                     to_weight = at::empty_like(weight);
        const float *values = value.data_ptr<float>(), *offsets = offset.data_ptr<float>(),
                    *weights = weight.data_ptr<float>(), *points = saved[3].data_ptr<float>(),
                    *arrived = back.data_ptr<float>();
        float *value_out = to_value.data_ptr<float>(), *offset_out = to_offset.data_ptr<float>(),
              *weight_out = to_weight.data_ptr<float>();
        // Parallel over pictures, since the tokens of one picture accumulate into the same values.
        at::parallel_for(0, at.n, 1, [&](std::int64_t begin, std::int64_t end) {
            for_each_head(
                at, begin * at.tokens, end * at.tokens,
                [&](std::int64_t token, std::int64_t channel, std::int64_t tap) {
                    const std::int64_t first = token / at.tokens * at.tokens * at.channels + channel % at.channels;
                    const float* g = arrived + channel;
                    for (std::int64_t i = 0; i < kTaps; ++i) {
                        const float *point = points + (token % at.tokens * kTaps + i) * 2,
                                    *moved = offsets + (tap + i) * 2;
                        const SampledPoint sampled(point[0] + moved[0], point[1] + moved[1], at.grid);
                        float by_weight = 0, by_row = 0, by_column = 0;
                        for (std::size_t corner = 0; corner < 4; ++corner) {
                            const std::int64_t from = first + sampled.token[corner] * at.channels;
                            const float share = weights[tap + i] * sampled.share[corner];
                            float along = 0;
                            for (std::int64_t c = 0; c < at.d; ++c) {
                                along += g[c] * values[from + c];
                                value_out[from + c] += share * g[c];
                            }
                            by_weight += sampled.share[corner] * along, by_row += sampled.by_row[corner] * along,
                                by_column += sampled.by_column[corner] * along;
                        }
                        weight_out[tap + i] = by_weight;
                        offset_out[(tap + i) * 2] = weights[tap + i] * by_row;
                        offset_out[(tap + i) * 2 + 1] = weights[tap + i] * by_column;
                    }
                });
        });
        return {to_value, to_offset, to_weight, Tensor(), Tensor(), Tensor(), Tensor()};
    }
};

}  // namespace

Tensor deformable_mix_by_operators(const Tensor& value, const Tensor& offset, const Tensor& weight, const Tensor& patch,
                                   Grid grid, std::int64_t heads) {
    const std::int64_t n = value.size(0), c = value.size(2), h = grid.height, w = grid.width;
    const Tensor pictures =
        value.view({n, h, w, heads, c / heads}).permute({0, 3, 4, 1, 2}).reshape({n * heads, c / heads, h, w});
    const Tensor point = patch.view({1, 1, h, w, kTaps, 2}) +
                         offset.view({n, h, w, heads, kTaps, 2}).permute({0, 3, 1, 2, 4, 5});
    const Tensor column = 2 * point.select(-1, 1) / static_cast<double>(w - 1) - 1;
    const Tensor row = 2 * point.select(-1, 0) / static_cast<double>(h - 1) - 1;
    const Tensor where = at::stack({column, row}, -1).reshape({n * heads, h, w * kTaps, 2});
    const Tensor sampled = at::grid_sampler(pictures, where, 0, 0, false)
                               .view({n * heads, c / heads, h, w, kTaps});  // bilinear, zero padding
    const Tensor shares =
        weight.view({n, h, w, heads, kTaps}).permute({0, 3, 1, 2, 4}).reshape({n * heads, 1, h, w, kTaps});
    return (sampled * shares).sum(-1).view({n, c, h * w}).transpose(1, 2);
}

Tensor deformable_mix(const Tensor& value, const Tensor& offset, const Tensor& weight, const Tensor& patch, Grid grid,
                      std::int64_t heads) {
    if (!value.is_cpu() || value.scalar_type() != at::kFloat)
        return deformable_mix_by_operators(value, offset, weight, patch, grid, heads);
    return MixFunction::apply(value.contiguous(), offset.contiguous(), weight.contiguous(), patch, grid.height,
                              grid.width, heads);
}

}  // namespace fastscene::nn

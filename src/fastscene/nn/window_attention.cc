#include "fastscene/nn/window_attention.h"

#include <ATen/ATen.h>
#include <ATen/Parallel.h>
#include <torch/csrc/autograd/custom_function.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "fastscene/nn/lane_products.h"

namespace fastscene::nn {
namespace {

using at::Tensor;

constexpr float kShortest = 1e-12f;  // lower limit of a row's length when normalizing
constexpr float kQuarterTurn = std::numbers::pi_v<float> / 2;

// How tokens are arranged in windows, and the padded matrix sizes.
struct WindowLayout {
    std::int64_t n, channels, heads, count, length;  // `count` windows of `length` tokens
    std::int64_t step, next;                         // stride between tokens of a window, and between windows
    std::int64_t d, wide, rows, columns;             // of a head; padded: values, a matrix's rows and columns

    WindowLayout(const Tensor& qkv, Grid grid, std::int64_t of_heads, Windows windows)
        : n(qkv.size(0)), channels(qkv.size(2) / 3), heads(of_heads) {
        const bool upright = windows == Windows::columns;
        count = upright ? grid.width : grid.height, length = upright ? grid.height : grid.width;
        step = upright ? grid.width : 1, next = upright ? 1 : grid.width;
        d = channels / heads, wide = rounded_up(d, kLanes), rows = rounded_up(length, kRows),
        columns = rounded_up(length, kLanes);
    }
    std::int64_t first_token(std::int64_t picture, std::int64_t window) const {
        return picture * count * length + window * next;
    }
};

// to [rows, columns] = left [rows, depth] right [depth, columns], padded; `left` may be transposed.
void product(const float* left, std::int64_t row_stride, std::int64_t depth_stride, const float* right,
             std::int64_t depth, float* to, std::int64_t rows, std::int64_t columns) {
    for (std::int64_t r = 0; r < rows; r += kRows) {
        const float* of = left + r * row_stride;
        float* into = to + r * columns;
        std::int64_t c = 0;
        for (; c + 2 * kLanes <= columns; c += 2 * kLanes)
            multiply<2, false>(of, row_stride, depth_stride, right + c, columns, depth, into + c, columns);
        if (c < columns) multiply<1, false>(of, row_stride, depth_stride, right + c, columns, depth, into + c, columns);
    }
}

// sin(x) and cos(x) for |x| <= pi / 4 (Taylor, the last term below 4e-8).
Lanes sine_of(Lanes x) {
    const Lanes y = x * x;
    return x * (all(1.f) + y * (all(-1.f / 6) + y * (all(1.f / 120) + y * (all(-1.f / 5040) + y * all(1.f / 362880)))));
}
Lanes cosine_of(Lanes x) {
    const Lanes y = x * x;
    return all(1.f) + y * (all(-0.5f) + y * (all(1.f / 24) + y * (all(-1.f / 720) + y * all(1.f / 40320))));
}

// One window and head at a time: a thread's scratch memory.
struct WindowBench {
    const WindowLayout& at;
    Floats q{token()}, k{token()}, v{token()}, keys_across{across()},
        values_across{across()};                     // [tokens, wide], and keys and values as [d, tokens]
    Floats score{square()}, inverse_length{side()};  // [tokens, tokens]; of each token's row of scores
    // Weights and gradients of scores; output, and its gradient.
    Floats weight{square()}, gradient{square()}, said{token()}, back{token()};

    explicit WindowBench(const WindowLayout& layout) : at(layout) {}
    std::int64_t side() const { return std::max(at.rows, at.columns); }
    std::int64_t token() const { return side() * at.wide; }
    std::int64_t across() const { return at.d * at.columns; }
    std::int64_t square() const { return side() * at.columns; }

    // `from`: the head's first value of the window's first token; `stride` between tokens.
    void fetch(const float* from, std::int64_t stride, Floats& to, float* across) const {
        for (std::int64_t i = 0; i < at.length; ++i) {
            std::copy_n(from + i * stride, at.d, to.data() + i * at.wide);
            if (across)
                for (std::int64_t p = 0; p < at.d; ++p) across[p * at.columns + i] = from[i * stride + p];
        }
    }
    void give(const Floats& from, float* to, std::int64_t stride) const {
        for (std::int64_t i = 0; i < at.length; ++i) std::copy_n(from.data() + i * at.wide, at.d, to + i * stride);
    }

    // Computes scores, the norms of their rows and the resulting weights. Returns the sum of absolute scores.
    double weigh(const float* qkv, const float* bias) {
        const std::int64_t stride = 3 * at.channels * at.step;
        fetch(qkv, stride, q, nullptr);
        fetch(qkv + at.channels, stride, k, keys_across.data());
        fetch(qkv + 2 * at.channels, stride, v, values_across.data());
        product(q.data(), at.wide, 1, keys_across.data(), at.d, score.data(), at.rows, at.columns);
        double loud = 0;
        for (std::int64_t i = 0; i < at.length; ++i) {
            float *s = score.data() + i * at.columns, *w = weight.data() + i * at.columns;
            const float* b = bias + i * at.columns;
            Lanes squares{}, magnitudes{};
            for (std::int64_t j = 0; j < at.columns; j += kLanes) {
                const Lanes x = load(s + j) + load(b + j);
                store(s + j, x);
                squares += x * x;
                magnitudes += x > Lanes{} ? x : -x;
            }
            float square = 0;
            for (int lane = 0; lane < kLanes; ++lane)
                square += squares[lane], loud += static_cast<double>(magnitudes[lane]);
            inverse_length[i] = 1.f / std::max(std::sqrt(square), kShortest);
            const Lanes half = all(0.5f * kQuarterTurn * inverse_length[i]);
            for (std::int64_t j = 0; j < at.columns; j += kLanes) {
                const Lanes sine = sine_of(load(s + j) * half);
                store(w + j, all(2.f) * sine * sine);  // 1 - cos
            }
        }
        return loud;
    }

    // After weigh(): `back` is the output's gradient, `per_score` the gradient with respect to a score's magnitude.
    // Computes the gradient of the scores.
    void weigh_back(float per_score) {
        product(back.data(), at.wide, 1, values_across.data(), at.d, gradient.data(), at.rows, at.columns);
        for (std::int64_t i = 0; i < at.length; ++i) {
            const float *s = score.data() + i * at.columns, inverse = inverse_length[i];
            float* g = gradient.data() + i * at.columns;
            const Lanes half = all(0.5f * kQuarterTurn * inverse);
            Lanes along{};
            for (std::int64_t j = 0; j < at.columns; j += kLanes) {
                const Lanes x = load(s + j), angle = x * half,
                            slope = load(g + j) * sine_of(angle) * cosine_of(angle) * all(2 * kQuarterTurn);
                store(g + j, slope);
                along += slope * x;
            }
            float sum = 0;
            for (int lane = 0; lane < kLanes; ++lane) sum += along[lane];
            // The component along the row itself changes only its length, which is normalized away.
            const Lanes stretch = all(inverse < 1 / kShortest ? sum * inverse * inverse : 0.f);
            for (std::int64_t j = 0; j < at.columns; j += kLanes) {
                const Lanes x = load(s + j), sign = x > Lanes{}   ? all(per_score)
                                                    : x < Lanes{} ? all(-per_score)
                                                                  : Lanes{};
                store(g + j, (load(g + j) - stretch * x) * all(inverse) + sign);
            }
        }
    }
};

class WindowFunction : public torch::autograd::Function<WindowFunction> {
  public:
    // bias: padded, [windows or 1, L, columns]. -> output, loudness
    static torch::autograd::tensor_list forward(torch::autograd::AutogradContext* context, const Tensor& qkv,
                                                const Tensor& bias, std::int64_t height, std::int64_t width,
                                                std::int64_t heads, bool columns) {
        const WindowLayout at(qkv, {height, width}, heads, columns ? Windows::columns : Windows::rows);
        context->save_for_backward({qkv, bias});
        context->saved_data["height"] = height, context->saved_data["width"] = width,
        context->saved_data["heads"] = heads;
        context->saved_data["columns"] = columns;
        const Tensor said = at::empty({at.n, height * width, at.channels}, qkv.options()),
                     loudness = at::empty({at.n, at.count}, qkv.options());
        for_each_window(at, [&](WindowBench& bench, std::int64_t picture, std::int64_t window) {
            const std::int64_t token = at.first_token(picture, window);
            double loud = 0;
            for (std::int64_t head = 0; head < at.heads; ++head) {
                loud += bench.weigh(qkv.data_ptr<float>() + 3 * token * at.channels + head * at.d,
                                    bias_of(bias, window));
                product(bench.weight.data(), at.columns, 1, bench.v.data(), at.length, bench.said.data(), at.rows,
                        at.wide);
                bench.give(bench.said, said.data_ptr<float>() + token * at.channels + head * at.d,
                           at.channels * at.step);
            }
            loudness.data_ptr<float>()[picture * at.count + window] = static_cast<float>(
                loud / static_cast<double>(at.heads * at.length * at.length));
        });
        return {said, loudness};
    }

    static torch::autograd::tensor_list backward(torch::autograd::AutogradContext* context,
                                                 torch::autograd::tensor_list gradients) {
        const auto saved = context->get_saved_variables();
        const Tensor &qkv = saved[0], &bias = saved[1], back = gradients[0].contiguous(),
                     loud = gradients[1].contiguous(), out = at::empty_like(qkv);
        const WindowLayout at(qkv, {context->saved_data["height"].toInt(), context->saved_data["width"].toInt()},
                              context->saved_data["heads"].toInt(),
                              context->saved_data["columns"].toBool() ? Windows::columns : Windows::rows);
        for_each_window(at, [&](WindowBench& bench, std::int64_t picture, std::int64_t window) {
            const std::int64_t token = at.first_token(picture, window), stride = 3 * at.channels * at.step;
            const float per_score = loud.data_ptr<float>()[picture * at.count + window] /
                                    static_cast<float>(at.heads * at.length * at.length);
            for (std::int64_t head = 0; head < at.heads; ++head) {
                const std::int64_t first = 3 * token * at.channels + head * at.d;
                bench.weigh(qkv.data_ptr<float>() + first, bias_of(bias, window));
                bench.fetch(back.data_ptr<float>() + token * at.channels + head * at.d, at.channels * at.step,
                            bench.back, nullptr);
                bench.weigh_back(per_score);
                float* to = out.data_ptr<float>() + first;
                product(bench.gradient.data(), at.columns, 1, bench.k.data(), at.length, bench.said.data(), at.rows,
                        at.wide);
                bench.give(bench.said, to, stride);
                product(bench.gradient.data(), 1, at.columns, bench.q.data(), at.length, bench.said.data(), at.rows,
                        at.wide);
                bench.give(bench.said, to + at.channels, stride);
                product(bench.weight.data(), 1, at.columns, bench.back.data(), at.length, bench.said.data(), at.rows,
                        at.wide);
                bench.give(bench.said, to + 2 * at.channels, stride);
            }
        });
        return {out, Tensor(), Tensor(), Tensor(), Tensor(), Tensor()};
    }

  private:
    static const float* bias_of(const Tensor& bias, std::int64_t window) {
        return bias.data_ptr<float>() + (bias.size(0) > 1 ? window * bias.size(1) * bias.size(2) : 0);
    }
    static void for_each_window(const WindowLayout& at, const auto& body) {
        at::parallel_for(0, at.n * at.count, 1, [&](std::int64_t begin, std::int64_t end) {
            WindowBench bench(at);
            for (std::int64_t i = begin; i < end; ++i) body(bench, i / at.count, i % at.count);
        });
    }
};

}  // namespace

WindowAttention window_attention_by_operators(const Tensor& qkv, const Tensor& bias, Grid grid, std::int64_t heads,
                                              Windows windows) {
    const std::int64_t n = qkv.size(0), c = qkv.size(2) / 3, h = grid.height, w = grid.width, d = c / heads;
    const bool columns = windows == Windows::columns;
    const std::int64_t count = columns ? w : h, length = columns ? h : w;
    const Tensor split = qkv.view({n, h, w, 3, heads, d});
    const Tensor of_window = (columns ? split.permute({3, 0, 2, 4, 1, 5}) : split.permute({3, 0, 1, 4, 2, 5}))
                                 .reshape({3, n, count, heads, length, d});
    const Tensor score = at::matmul(of_window[0], of_window[1].transpose(-2, -1)) +
                         bias.view({1, bias.size(0), 1, length, length});
    const Tensor normalised = score / score.norm(2, -1, true).clamp_min(kShortest);
    const Tensor said = at::matmul(1 - at::cos(normalised * (std::numbers::pi / 2)), of_window[2]);
    return {(columns ? said.permute({0, 3, 1, 2, 4}) : said.permute({0, 1, 3, 2, 4})).reshape({n, h * w, c}),
            score.abs().mean(std::vector<std::int64_t>{2, 3, 4})};
}

WindowAttention window_attention(const Tensor& qkv, const Tensor& bias, Grid grid, std::int64_t heads,
                                 Windows windows) {
    if (!qkv.is_cpu() || qkv.scalar_type() != at::kFloat)
        return window_attention_by_operators(qkv, bias, grid, heads, windows);
    const std::int64_t length = bias.size(2);
    const Tensor padded = at::constant_pad_nd(bias, {0, rounded_up(length, kLanes) - length}).contiguous();
    const auto found = WindowFunction::apply(qkv.contiguous(), padded, grid.height, grid.width, heads,
                                             windows == Windows::columns);
    return {found[0], found[1]};
}

}  // namespace fastscene::nn

#include "fastscene/nn/aotgan_net.h"

#include "fastscene/nn/libtorch.h"
#include "fastscene/base/check.h"
#include "fastscene/base/error.h"
#include "fastscene/base/json.h"
#include "fastscene/nn/layers.h"

namespace fastscene::nn {
namespace {

using at::Tensor;

// Reflection padding in channels-last order, for which at::reflection_pad2d is slow on a CPU.
Tensor reflected_by_pixels(const Tensor& x, std::int64_t by) {
    const std::int64_t h = x.size(2), w = x.size(3);
    const Tensor out = at::empty({x.size(0), x.size(1), h + 2 * by, w + 2 * by},
                                 x.options().memory_format(at::MemoryFormat::ChannelsLast));
    const Tensor rows = out.narrow(2, by, h);
    rows.narrow(3, by, w).copy_(x);
    for (std::int64_t i = 1; i <= by; ++i) {
        rows.select(3, by - i).copy_(x.select(3, i));
        rows.select(3, by + w - 1 + i).copy_(x.select(3, w - 1 - i));
    }
    for (std::int64_t i = 1; i <= by; ++i) {
        out.select(2, by - i).copy_(out.select(2, by + i));
        out.select(2, by + h - 1 + i).copy_(out.select(2, by + h - 1 - i));
    }
    return out;
}

// libtorch 1.13 lacks at::reflection_pad2d for bfloat16, and autocast does not cover it.
Tensor reflected(const Tensor& x, std::int64_t by) {
    FASTSCENE_CHECK(by < x.size(2) && by < x.size(3));
    if (!at::GradMode::is_enabled() && x.is_cpu() && x.is_contiguous(at::MemoryFormat::ChannelsLast))
        return reflected_by_pixels(x, by);
    if (x.scalar_type() != at::kBFloat16) return at::reflection_pad2d(x, {by, by, by, by});
    return at::reflection_pad2d(x.to(at::kFloat), {by, by, by, by}).to(at::kBFloat16);
}

// conv3x3 with reflection padding.
Tensor reflected_conv(const Scope& s, const Tensor& x, std::int64_t out, std::int64_t dilation = 1) {
    const Scope conv = s / 1;  // 0 is the padding
    return at::conv2d(reflected(x, dilation), conv.parameter("weight", {out, x.size(1), 3, 3}),
                      conv.parameter("bias", {out}), at::IntArrayRef{1}, at::IntArrayRef{0}, at::IntArrayRef{dilation});
}

// The published "layer norm": normalizes each channel of each picture to mean 0 and standard deviation 2 (N - 1 in the
// denominator), then (x - 1) * 5.
Tensor contrast(const Tensor& x) {
    const Tensor mean = x.mean({2, 3}, true),
                 deviation = at::std(x, at::IntArrayRef{2, 3}, /*unbiased=*/true, /*keepdim=*/true) + 1e-9;
    return 5 * (2 * (x - mean) / deviation - 1);
}

// Aggregates context at several dilations, and blends it in through a learned gate.
Tensor aot_block(const Scope& s, const AotganShape& shape, const Tensor& x) {
    const std::int64_t channels = x.size(1), branches = static_cast<std::int64_t>(shape.rates.size());
    std::vector<Tensor> gathered;
    for (std::int64_t i = 0; i < branches; ++i) {
        const Scope branch = s / ("block" + std::string(i < 10 ? "0" : "") + std::to_string(i));
        gathered.push_back(branch.out(
            at::relu(reflected_conv(branch, x, channels / branches, shape.rates[static_cast<std::size_t>(i)]))));
    }
    const Scope fuse = s / "fuse", gate = s / "gate";
    const Tensor fused = fuse.out(reflected_conv(fuse, at::cat(gathered, 1), channels));
    const Tensor open = at::sigmoid(contrast(gate.out(reflected_conv(gate, x, channels)).to(at::kFloat)))
                            .to(x.scalar_type());
    return s.out(x * (1 - open) + fused * open);
}

Tensor twice_as_large(const Tensor& x) {
    return at::upsample_bilinear2d(x, {2 * x.size(2), 2 * x.size(3)}, /*align_corners=*/true);  // align_corners = true
}

// conv3x3 over concatenated maps without concatenating them: each map is convolved with its part of the kernel, and the
// outputs are summed.
Tensor conv_of(const Scope& s, const std::vector<Tensor>& maps, std::int64_t out) {
    std::int64_t channels = 0;
    for (const Tensor& map : maps) channels += map.size(1);
    const Tensor kernel = s.parameter("weight", {out, channels, 3, 3}), bias = s.parameter("bias", {out});
    Tensor sum;
    std::int64_t first = 0;
    for (const Tensor& map : maps) {
        const Tensor part = at::conv2d(map, kernel.narrow(1, first, map.size(1)), sum.defined() ? Tensor() : bias, 1,
                                       1);
        sum = sum.defined() ? sum + part : part;
        first += map.size(1);
    }
    return sum;
}

Tensor unit_vector(const Tensor& x) { return x / x.norm().clamp_min(1e-12); }

// Spectral normalization: the kernel divided by its largest singular value.
Tensor spectral_kernel(const Scope& s, at::IntArrayRef shape, bool power_iteration) {
    const Tensor kernel = s.parameter("weight_orig", shape), matrix = kernel.reshape({shape[0], -1});
    Tensor u = s.parameter("weight_u", {shape[0]}), v = s.parameter("weight_v", {matrix.size(1)});
    if (power_iteration) {
        const at::NoGradGuard no_gradients;
        v.copy_(unit_vector(at::mv(matrix.t(), u)));
        u.copy_(unit_vector(at::mv(matrix, v)));
        u = u.clone();  // the next call changes u and v while this call's gradient still needs them
        v = v.clone();
    }
    return kernel / at::dot(u, at::mv(matrix, v));
}

}  // namespace

AotganShape aotgan_shape(const Weights& weights) {
    const auto& first = weights.at("encoder.1.weight").shape;
    if (first.size() != 4 || first[0] < 1 || first[0] > 1024 || first[1] != 4)
        throw Error("{}: encoder.1.weight: expected shape [width, 4, 7, 7], found {}", weights.path.string(),
                    text_of_shape(first));
    AotganShape shape{first[0], 0, {}};
    if (weights.has("decoder.4.weight")) {
        const auto& last = weights.at("decoder.4.weight").shape;
        shape.skips = last.size() == 4 && last[1] == 2 * shape.width;
    }
    while (weights.has("middle." + std::to_string(shape.blocks) + ".fuse.1.weight")) ++shape.blocks;
    for (std::int64_t i = 0; i < 10 && weights.has(fmt::format("middle.0.block0{}.1.weight", i)); ++i)
        shape.rates.push_back(std::int64_t{1} << i);
    if (shape.blocks == 0 || shape.rates.empty() ||
        4 * shape.width % static_cast<std::int64_t>(shape.rates.size()) != 0)
        throw Error("{}: expected AOT-GAN's blocks (middle.0.block00.1.weight …), found {} blocks of {} branches",
                    weights.path.string(), shape.blocks, shape.rates.size());
    if (const auto said = weights.metadata.find("rates"); said != weights.metadata.end()) {
        const Json list = Json::parse(said->second, nullptr, false);
        if (!list.is_array() || list.size() != shape.rates.size())
            throw Error("{}: rates: expected {} numbers, found {}", weights.path.string(), shape.rates.size(),
                        said->second);
        for (std::size_t i = 0; i < list.size(); ++i) {
            if (!list[i].is_number_integer() || list[i] < 1 || list[i] > 64)
                throw Error("{}: rates: expected numbers from 1 to 64, found {}", weights.path.string(), said->second);
            shape.rates[i] = list[i];
        }
    }
    return shape;
}

Tensor aotgan_generator(const Scope& s, const AotganShape& shape, const Tensor& picture, const Tensor& mask) {
    const Scope encoder = s / "encoder", decoder = s / "decoder";
    Tensor x = (encoder / 0).out(reflected(at::cat({picture, mask}, 1), 3));
    const Tensor whole = at::relu(conv(encoder / 1, x, shape.width, {7, 1, 0}));
    const Tensor half = at::relu(conv(encoder / 3, whole, 2 * shape.width, {4, 2, 1}));
    x = at::relu(conv(encoder / 5, half, 4 * shape.width, {4, 2, 1}));
    for (std::int64_t i = 0; i < shape.blocks; ++i) x = aot_block(s / "middle" / i, shape, x);
    const auto beside = [&](const Tensor& made, const Tensor& seen) {
        return shape.skips ? std::vector{made, seen} : std::vector{made};
    };
    const auto larger = [&](const Scope& part, const std::vector<Tensor>& maps, std::int64_t out) {
        std::vector<Tensor> large;
        for (const Tensor& map : maps) large.push_back(twice_as_large(map));
        return at::relu(part.out(conv_of(part / "conv", large, out)));
    };
    x = larger(decoder / 0, {x}, 2 * shape.width);
    x = larger(decoder / 2, beside(x, half), shape.width);
    return at::tanh((decoder / 4).out(conv_of(decoder / 4, beside(x, whole), 3)));
}

Tensor aotgan_discriminator(const Scope& s, std::int64_t width, const Tensor& picture, bool power_iteration) {
    Tensor x = picture;
    std::int64_t out = width;
    for (const int layer : {0, 2, 4, 6}) {
        const Scope here = s / "conv" / layer;
        const Tensor kernel = spectral_kernel(here, {out, x.size(1), 4, 4}, power_iteration);
        x = at::leaky_relu(here.out(at::conv2d(x, kernel, {}, layer == 6 ? 1 : 2, 1)), 0.2);
        out *= 2;
    }
    return conv(s / "conv" / 8, x, 1, {4, 1, 1});
}

}  // namespace fastscene::nn

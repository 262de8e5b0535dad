#include "fastscene/nn/weights_torch.h"

#include <cstring>
#include <set>

#include <fmt/ranges.h>

#include "fastscene/nn/libtorch.h"

namespace fastscene::nn {
namespace {

constexpr std::size_t kMostInMessage = 4;

std::string list_text(at::IntArrayRef shape) { return text_of_shape(shape.vec()); }

// "a, b, c, d and 12 more"
std::string some_of(const std::vector<std::string>& all) {
    const std::vector<std::string> first(
        all.begin(), all.begin() + static_cast<std::ptrdiff_t>(std::min(all.size(), kMostInMessage)));
    return fmt::format("{}{}", fmt::join(first, ", "),
                       all.size() > kMostInMessage ? fmt::format(" and {} more", all.size() - kMostInMessage) : "");
}

}  // namespace

at::ScalarType scalar_type(NumberType type) {
    switch (type) {
        case NumberType::f64: return at::kDouble;
        case NumberType::f32: return at::kFloat;
        case NumberType::f16: return at::kHalf;
        case NumberType::bf16: return at::kBFloat16;
        case NumberType::i64: return at::kLong;
        case NumberType::i32: return at::kInt;
        case NumberType::i16: return at::kShort;
        case NumberType::i8: return at::kChar;
        case NumberType::u8: return at::kByte;
        case NumberType::boolean: return at::kBool;
    }
    return at::kFloat;
}

at::Tensor tensor_of(const WeightTensor& weight) {
    const at::ScalarType type = scalar_type(weight.type);
    const std::size_t size = bytes_of(weight.type);
    if (weight.count() == 0) return at::empty(weight.shape, type);
    if (reinterpret_cast<std::uintptr_t>(weight.bytes.data()) % size == 0)
        return at::from_blob(
            const_cast<std::byte*>(weight.bytes.data()), weight.shape, [owner = weight.owner](void*) {}, type);
    at::Tensor copy = at::empty(weight.shape, type);
    std::memcpy(copy.data_ptr(), weight.bytes.data(), weight.bytes.size());
    return copy;
}

at::Tensor placed(const at::Tensor& stored, const at::TensorOptions& options) {
    if (!options.device().is_cuda()) return stored.to(options);
    const at::Tensor there = stored.to(options.device(), stored.scalar_type(), /*non_blocking=*/true)
                                 .to(c10::typeMetaToScalarType(options.dtype()));
    return there.dim() == 4 ? there.contiguous(at::MemoryFormat::ChannelsLast) : there;
}

WeightTensor weight_of(const at::Tensor& tensor) {
    const at::Tensor plain = tensor.detach().to(at::kCPU).contiguous();
    NumberType type = NumberType::f32;
    for (int i = 0; i <= static_cast<int>(NumberType::boolean); ++i)
        if (scalar_type(static_cast<NumberType>(i)) == plain.scalar_type()) type = static_cast<NumberType>(i);
    FASTSCENE_CHECK(scalar_type(type) == plain.scalar_type());
    const auto owner = std::make_shared<const at::Tensor>(plain);
    return {type, plain.sizes().vec(), {static_cast<const std::byte*>(plain.data_ptr()), plain.nbytes()}, owner};
}

at::Tensor LoadedWeights::get(const std::string& key, at::IntArrayRef shape) {
    const auto ready = ready_.find(key);
    if (ready != ready_.end()) return ready->second;
    const WeightTensor& weight = weights_.at(key);
    if (at::IntArrayRef(weight.shape) != shape)
        throw Error("{}: {}: expected shape {}, found {}", weights_.path.string(), key, list_text(shape),
                    text_of_shape(weight.shape));
    const at::Tensor tensor = tensor_of(weight);
    if (tensor.is_floating_point() && !at::isfinite(tensor).all().item<bool>())
        throw Error("{}: {}: expected numbers, found NaN or infinity among its {}", weights_.path.string(), key,
                    tensor.numel());
    return ready_[key] = placed(tensor, options_);
}

void check_fits(const NamedShapes& needed, const Weights& weights, const NamedShapes& unused, bool extra_allowed) {
    std::vector<std::string> missing, shapes, extra;
    const auto compare = [&](const std::string& name, const std::vector<std::int64_t>& shape,
                             const WeightTensor& found) {
        if (found.shape != shape)
            shapes.push_back(
                fmt::format("{} (expected {}, found {})", name, text_of_shape(shape), text_of_shape(found.shape)));
    };
    for (const auto& [name, shape] : needed) {
        const auto found = weights.tensors.find(name);
        if (found == weights.tensors.end()) missing.push_back(name + " " + text_of_shape(shape));
        else compare(name, shape, found->second);
    }
    for (const auto& [name, tensor] : weights.tensors) {
        if (needed.contains(name)) continue;
        if (const auto known = unused.find(name); known != unused.end()) compare(name, known->second, tensor);
        else if (!extra_allowed) extra.push_back(name);
    }
    std::vector<std::string> problems;
    if (!missing.empty()) problems.push_back("missing: " + some_of(missing));
    if (!shapes.empty()) problems.push_back("other shapes: " + some_of(shapes));
    if (!extra.empty()) problems.push_back("unexpected: " + some_of(extra));
    if (!problems.empty())
        throw Error("{}: these weights do not fit the network; {}", weights.path.string(), fmt::join(problems, "; "));
}

void load_into(const NamedTensors& targets, const Weights& weights, bool extra_allowed) {
    NamedShapes needed;
    for (const auto& [name, target] : targets) needed[name] = target.sizes().vec();
    check_fits(needed, weights, {}, extra_allowed);
    const at::NoGradGuard no_gradients;
    for (const auto& [name, target] : targets) at::Tensor(target).copy_(tensor_of(weights.tensors.at(name)));
}

}  // namespace fastscene::nn

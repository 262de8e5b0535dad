#include "fastscene/nn/hashed.h"

#include <cmath>

#include "fastscene/base/check.h"
#include "fastscene/base/parallel.h"
#include "fastscene/base/random.h"

namespace fastscene::nn {
namespace {

constexpr std::int64_t kGrain = 1 << 16;

template <class Value>
at::Tensor filled(const std::string& name, at::IntArrayRef shape, Value&& value) {
    at::Tensor out = at::empty(shape, at::kFloat);
    const std::uint64_t hash = hash_name(name);
    float* to = out.data_ptr<float>();
    parallel_for(out.numel(), kGrain, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) to[i] = value(hashed_number(hash, static_cast<std::uint64_t>(i)));
    });
    return out;
}

}  // namespace

float hashed_number(std::uint64_t name_hash, std::uint64_t index) {
    // mix64 advances the sequence once before mixing, so element i is i + 1 steps after the name's hash.
    return static_cast<float>(static_cast<double>(mix64(name_hash + index * 0x9e3779b97f4a7c15ull) >> 40) * 0x1p-23 -
                              1);
}

at::Tensor hashed_input(const std::string& name, at::IntArrayRef shape) {
    return filled(name, shape, [](float u) { return u; });
}

at::Tensor hashed_parameter(const std::string& key, at::IntArrayRef shape) {
    const double numel = static_cast<double>(c10::multiply_integers(shape));
    if (shape.size() >= 2) {
        const double scale = std::sqrt(3.0 / (numel / static_cast<double>(shape[0])));
        return filled(key, shape, [scale](float u) { return static_cast<float>(u * scale); });
    }
    if (key.ends_with("running_var"))
        return filled(key, shape,
                      [](float u) { return static_cast<float>(1.0 + 0.1 * std::abs(static_cast<double>(u))); });
    if (key.ends_with("weight")) return filled(key, shape, [](float u) { return static_cast<float>(1.0 + 0.1 * u); });
    return filled(key, shape, [](float u) { return static_cast<float>(0.1 * u); });
}

at::Tensor HashedWeights::get(const std::string& key, at::IntArrayRef shape) {
    at::Tensor& tensor = seen_[key];
    if (!tensor.defined()) tensor = hashed_parameter(salt_ + key, shape).to(options_);
    FASTSCENE_CHECK(tensor.sizes() == shape);
    return tensor;
}

}  // namespace fastscene::nn

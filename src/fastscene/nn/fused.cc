#include "fastscene/nn/fused.h"

#include "fastscene/nn/libtorch.h"

#ifdef FASTSCENE_KERNELS
#include <c10/cuda/CUDAStream.h>

#include <cstdlib>
#include <limits>
#include <string_view>

#include "fastscene/nn/kernels.h"
#endif

namespace fastscene::nn {

using at::Tensor;

#ifdef FASTSCENE_KERNELS

namespace {

bool are_wanted() {
    const char* value = std::getenv("FASTSCENE_CUDA_KERNELS");
    return !value || std::string_view(value) != "0";
}

bool fits(const Tensor& x) {
    const at::ScalarType type = x.scalar_type();
    return x.is_cuda() && x.numel() > 0 && !at::GradMode::is_enabled() && are_wanted() &&
           (type == at::kFloat || type == at::kHalf || type == at::kBFloat16);
}

kernels::Number number_of(const Tensor& x) {
    return x.scalar_type() == at::kFloat  ? kernels::Number::f32
           : x.scalar_type() == at::kHalf ? kernels::Number::f16
                                          : kernels::Number::bf16;
}

void* stream_of(const Tensor& x) { return c10::cuda::getCurrentCUDAStream(x.device().index()).stream(); }

}  // namespace

Tensor fused_group_norm(const Tensor& given, const Tensor& weight, const Tensor& bias, std::int64_t groups, double eps,
                        bool silu) {
    if (!fits(given) || given.dim() != 4 || given.size(2) * given.size(3) > std::numeric_limits<int>::max()) return {};
    const kernels::NormShape shape{static_cast<int>(given.size(0)), static_cast<int>(given.size(2) * given.size(3)),
                                   static_cast<int>(given.size(1)), static_cast<int>(groups)};
    if (!kernels::is_norm_shape(shape)) return {};
    const Tensor x = given.contiguous(at::MemoryFormat::ChannelsLast), y = at::empty_like(x);
    const Tensor scratch = at::empty({static_cast<std::int64_t>(kernels::group_norm_scratch(shape))},
                                     x.options().dtype(at::kFloat));
    kernels::group_norm(number_of(x), x.data_ptr(), weight.data_ptr(), bias.data_ptr(), y.data_ptr(),
                        scratch.data_ptr<float>(), shape, static_cast<float>(eps), silu, stream_of(x));
    return y;
}

Tensor fused_gated_gelu(const Tensor& given) {
    const std::int64_t width = given.size(-1) / 2;
    if (!fits(given) || width % 8 != 0 || width > std::numeric_limits<int>::max()) return {};
    const Tensor x = given.contiguous();
    std::vector<std::int64_t> sizes = x.sizes().vec();
    sizes.back() = width;
    const Tensor out = at::empty(sizes, x.options());
    kernels::gated_gelu(number_of(x), x.data_ptr(), out.data_ptr(), static_cast<std::size_t>(out.numel() / width),
                        static_cast<int>(width), stream_of(x));
    return out;
}

#else

Tensor fused_group_norm(const Tensor&, const Tensor&, const Tensor&, std::int64_t, double, bool) { return {}; }
Tensor fused_gated_gelu(const Tensor&) { return {}; }

#endif

}  // namespace fastscene::nn

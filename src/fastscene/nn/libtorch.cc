#include "fastscene/nn/libtorch.h"

#include <ATen/autocast_mode.h>

#ifdef FASTSCENE_CUDA
#include <c10/cuda/CUDAFunctions.h>
#endif

namespace fastscene::nn {

#if TORCH_VERSION_MAJOR > 2 || (TORCH_VERSION_MAJOR == 2 && TORCH_VERSION_MINOR >= 4)
bool is_autocast_on(at::DeviceType device) { return at::autocast::is_autocast_enabled(device); }
void set_autocast(at::DeviceType device, bool on) {
    at::autocast::set_autocast_dtype(device, at::kBFloat16);
    at::autocast::set_autocast_enabled(device, on);
}
#else
bool is_autocast_on(at::DeviceType device) {
    return device == at::kCUDA ? at::autocast::is_enabled() : at::autocast::is_cpu_enabled();
}
void set_autocast(at::DeviceType device, bool on) {
    if (device == at::kCUDA) {
        at::autocast::set_autocast_gpu_dtype(at::kBFloat16);
        at::autocast::set_enabled(on);
    } else {
        at::autocast::set_autocast_cpu_dtype(at::kBFloat16);
        at::autocast::set_cpu_enabled(on);
    }
}
#endif

#if TORCH_VERSION_MAJOR >= 2
at::Tensor fused_attention(const at::Tensor& q, const at::Tensor& k, const at::Tensor& v) {
    return at::scaled_dot_product_attention(q, k, v);
}
#else
at::Tensor fused_attention(const at::Tensor&, const at::Tensor&, const at::Tensor&) { return {}; }
#endif

#ifdef FASTSCENE_CUDA
void wait_for(at::Device device) {
    if (device.is_cuda()) c10::cuda::device_synchronize();
}
#else
void wait_for(at::Device) {}
#endif

}  // namespace fastscene::nn

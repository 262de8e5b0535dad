#include "fastscene/nn/precision.h"

#include <ATen/Context.h>
#include <ATen/autocast_mode.h>

#include "fastscene/base/error.h"
#include "fastscene/base/isa.h"
#include "fastscene/nn/libtorch.h"

namespace fastscene::nn {
namespace {

bool cpu_has_bf16() {
#if defined(__x86_64__)
    return isa() >= Isa::avx512 && __builtin_cpu_supports("avx512bf16");
#else
    return false;
#endif
}

// libtorch asks the processor whether oneDNN supports bfloat16, but oneDNN refuses if FASTSCENE_ISA forbids it. In that
// case oneDNN is disabled for the rest of the run, including backward passes, as on a processor without the
// instructions.
void leave_bf16_to_libtorch(at::DeviceType device) {
    if (device == at::kCPU && isa() < processor_isa()) at::globalContext().setUserEnabledMkldnn(false);
}

}  // namespace

at::Device device_named(const std::string& name, const std::string& flag) {
    if (name == "cuda" && !at::hasCUDA())
        throw UsageError("{}: expected cpu, since this libtorch has no CUDA, found cuda", flag);
    return name == "cuda" || (name == "auto" && at::hasCUDA()) ? at::Device(at::kCUDA) : at::Device(at::kCPU);
}

at::Device training_device(const TrainingParams& params) { return device_named(params.device, "--device"); }

bool multiplies_bf16(at::Device device) { return device.is_cuda() || cpu_has_bf16(); }

bool trains_in_bf16(const TrainingParams& params) {
    if (params.precision != "auto") return params.precision == "bf16";
    return multiplies_bf16(training_device(params));
}

Autocast::Autocast(at::Device device, bool on) : device_(device.type()), on_(on) {
    if (!on_) return;
    leave_bf16_to_libtorch(device_);
    before_ = is_autocast_on(device_);
    set_autocast(device_, true);
}
Autocast::~Autocast() {
    if (!on_) return;
    at::autocast::clear_cache();  // it caches converted parameters, which the next step changes
    set_autocast(device_, before_);
}

}  // namespace fastscene::nn

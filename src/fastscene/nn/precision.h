// Devices and number types for networks. Compatible with libtorch 1.13 and 2.x. Private to nn/ (torch).
#pragma once

#include <ATen/ATen.h>

#include "fastscene/nn/training_params.h"

namespace fastscene::nn {

// `name`: cpu, cuda or auto (CUDA if this libtorch supports it). Throws UsageError naming `flag` if CUDA is requested
// but unavailable.
at::Device device_named(const std::string& name, const std::string& flag);
at::Device training_device(const TrainingParams& params);
// Whether products of bfloat16 are faster there than of floats: on CUDA, or on a CPU with AVX-512 BF16.
bool multiplies_bf16(at::Device device);
// Whether "auto" resolves to bf16: where multiplies_bf16.
bool trains_in_bf16(const TrainingParams& params);

// During its lifetime, convolutions and matrix products on `device` use bfloat16, numerically sensitive operations
// single precision ("autocast").
class Autocast {
  public:
    Autocast(at::Device device, bool on);
    ~Autocast();
    Autocast(const Autocast&) = delete;
    Autocast& operator=(const Autocast&) = delete;

  private:
    at::DeviceType device_;
    bool on_, before_ = false;
};

}  // namespace fastscene::nn

// Where networks are computed, and with which numbers. One source for libtorch 1.13 and 2.x. Private to nn/ (torch).
#pragma once

#include <ATen/ATen.h>

#include "fastscene/nn/training_params.h"

namespace fastscene::nn {

// `name`: cpu, cuda, or auto (CUDA where this libtorch has it). Throws UsageError naming `flag` when CUDA is asked for
// and there is none.
at::Device device_named(const std::string& name, const std::string& flag);
at::Device training_device(const TrainingParams& params);
// bf16 for "auto" where the device computes with it: CUDA, or a CPU with AVX-512 BF16.
bool trains_in_bf16(const TrainingParams& params);

// While it lives, convolutions and matrix products on `device` run in bfloat16, everything delicate in single precision
// ("autocast").
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

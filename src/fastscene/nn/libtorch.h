// What differs between the versions and builds of libtorch that the networks run on: 1.13 and 2.x, with and without
// CUDA, with and without Gloo. Nothing else asks for a version. Private to nn/ (torch).
#pragma once

#include <ATen/ATen.h>
#include <ATen/core/grad_mode.h>  // ATen.h brings it in 1.13 only
#include <torch/version.h>

// Training by several processes talks through Gloo, which official builds of libtorch lack.
#if defined(USE_C10D_GLOO) && __has_include(<torch/csrc/distributed/c10d/ProcessGroupGloo.hpp>) && \
    __has_include(<gloo/transport/tcp/device.h>)
#define FASTSCENE_GLOO
#endif

namespace fastscene::nn {

// Autocast to bfloat16: whether it is on for a kind of device, and switching it.
bool is_autocast_on(at::DeviceType device);
void set_autocast(at::DeviceType device, bool on);

// softmax(q k' / sqrt(d)) v in one kernel that never stores the weights, accumulated in single precision: q
// [N, heads, L, d], k and v [N, heads, M, d] -> [N, heads, L, d]. Undefined where this libtorch has none (1.13).
at::Tensor fused_attention(const at::Tensor& q, const at::Tensor& k, const at::Tensor& v);

// Waits until a graphics card has finished all submitted work; does nothing on a CPU.
void wait_for(at::Device device);

}  // namespace fastscene::nn

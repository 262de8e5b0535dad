// The compute kernels of splatting, compiled for one device.
#pragma once

#include "fastscene/gpu/device.h"

namespace fastscene::splat::vulkan {

struct Kernels {
    explicit Kernels(gpu::Device& device);
    gpu::Kernel project, radix_count, radix_scatter, pairs_count, pairs_write, tiles, forward, ssim, loss_grad,
        backward, update;
    gpu::Kernel density_sum, density_scan, density_sample, density_rank, density_split, density_finish;
};

}  // namespace fastscene::splat::vulkan

// A generator of AOT-GAN made wider without forgetting: what a narrow one learnt is where a wide one begins. Private to
// nn/ (torch).
#pragma once

#include <cstdint>

#include "fastscene/nn/aotgan_net.h"

namespace fastscene::nn {

// The weights of a generator of `times` as many channels throughout that paints what `narrow` (of the given shape,
// unwrapped) paints: each channel stands there `times` times, and who reads it takes shares of its copies that sum to
// one (Chen, Goodfellow, Shlens, "Net2Net", ICLR 2016). The shares are drawn by the seed, so that copies learn
// different things from then on. float32 throughout; metadata and path are those of `narrow`. Throws Error when a
// tensor is missing or has another shape.
Weights widened(const Weights& narrow, const AotganShape& shape, std::int64_t times, std::uint64_t seed);

}  // namespace fastscene::nn

// Widens an AOT-GAN generator without changing its function: a wide network starts from a trained narrow one. Private
// to nn/ (torch).
#pragma once

#include <cstdint>

#include "fastscene/nn/aotgan_net.h"

namespace fastscene::nn {

// Weights of a generator with `times` as many channels that computes the same function as `narrow` (of the given shape,
// unwrapped): each channel is replicated `times` times, and its consumers' weights are divided among the copies (Chen,
// Goodfellow, Shlens, "Net2Net", ICLR 2016). The division is random by `seed`, which breaks the symmetry so that copies
// can diverge in training. float32 throughout; metadata and path are those of `narrow`. Throws Error if a tensor is
// missing or has another shape.
Weights widened(const Weights& narrow, const AotganShape& shape, std::int64_t times, std::uint64_t seed);

}  // namespace fastscene::nn

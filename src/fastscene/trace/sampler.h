// Sampler: low-discrepancy numbers in [0, 1) for the paths of a pixel (kernel/sampler.h).
#pragma once

#include "fastscene/trace/kernel/sampler.h"

namespace fastscene {

using kernel::power_heuristic;

class Sampler {
  public:
    // Paths of one pixel share `key` and differ in `index`.
    Sampler(std::uint64_t key, std::uint32_t index) : state_{key, index, 0} {}
    Vec2f next2() { return kernel::next2(state_); }
    float next() { return kernel::next(state_); }

  private:
    kernel::Sampler state_;
};

}  // namespace fastscene

// A DA-2 with hashed weights, for tests and benchmarks.
#pragma once

#include "fastscene/weights/weights.h"

namespace fastscene {

// Everything that the published file has. Sizes as in Da2Shape (1024, 24, 512 published); others are said in the
// metadata, as Da2::load reads them.
Weights hashed_da2(int width, int blocks, int features);

}  // namespace fastscene

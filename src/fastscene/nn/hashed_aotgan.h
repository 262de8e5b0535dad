// An AOT-GAN generator with hashed weights, for tests and as a reproducible initialization.
#pragma once

#include "fastscene/weights/weights.h"

namespace fastscene {

// width: channels of the first layer (64 in the official network); `blocks` blocks of four branches.
Weights hashed_aotgan(int width, int blocks);

}  // namespace fastscene

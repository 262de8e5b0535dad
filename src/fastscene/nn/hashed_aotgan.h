// A generator of AOT-GAN with weights made from their names: for tests, and as a beginning that is the same everywhere.
#pragma once

#include "fastscene/nn/weights.h"

namespace fastscene {

// width: channels of the first layer (64 in the official network); `blocks` blocks of four branches.
Weights hashed_aotgan(int width, int blocks);

}  // namespace fastscene

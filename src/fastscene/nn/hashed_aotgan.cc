#include "fastscene/nn/hashed_aotgan.h"

#include <c10/core/InferenceMode.h>

#include "fastscene/nn/aotgan_net.h"
#include "fastscene/nn/hashed.h"
#include "fastscene/nn/weights_torch.h"

namespace fastscene {

Weights hashed_aotgan(int width, int blocks) {
    const c10::InferenceMode inference;
    nn::HashedWeights hashed;
    // A forward pass requests all parameters.
    (void)nn::aotgan_generator(nn::Scope(hashed), {width, blocks, {1, 2, 4, 8}}, at::zeros({1, 3, 64, 64}),
                               at::zeros({1, 1, 64, 64}));
    Weights out{"hashed weights", {}, {}, {}};
    for (const auto& [key, tensor] : hashed.seen()) out.tensors[key] = nn::weight_of(tensor);
    return out;
}

}  // namespace fastscene

#include "fastscene/nn/hashed_da2.h"

#include "fastscene/nn/da2_net.h"
#include "fastscene/nn/hashed.h"
#include "fastscene/nn/libtorch.h"
#include "fastscene/nn/weights_torch.h"

namespace fastscene {

Weights hashed_da2(int width, int blocks, int features) {
    const at::NoGradGuard no_gradients;
    const nn::Da2Shape shape{{width, blocks}, features}, published;
    Weights out{"hashed weights", {}, {}, {}};
    for (const nn::NamedShapes& shapes : {nn::da2_parameters(shape), nn::da2_unused(shape)})
        for (const auto& [key, sizes] : shapes) out.tensors[key] = nn::weight_of(nn::hashed_parameter(key, sizes));
    if (width != published.dino.width || blocks != published.dino.blocks || features != published.features)
        out.metadata = {{"width", std::to_string(width)},
                        {"blocks", std::to_string(blocks)},
                        {"features", std::to_string(features)}};
    return out;
}

}  // namespace fastscene

#include "fastscene/nn/lpips.h"

#include "fastscene/nn/layers.h"

namespace fastscene::nn {

using at::Tensor;

namespace {

// What precedes a convolution, and whether its ReLU output is compared.
struct BackboneStep {
    int index = 0;  // index in torchvision's features
    std::int64_t channels = 0;
    Conv shape;
    bool pool_before = false, compare = false;
};
const std::vector<BackboneStep>& steps_of(LpipsNet net) {
    static const std::vector<BackboneStep> alex{{0, 64, {11, 4, 2}, false, true},
                                                {3, 192, {5, 1, 2}, true, true},
                                                {6, 384, {}, true, true},
                                                {8, 256, {}, false, true},
                                                {10, 256, {}, false, true}};
    static const std::vector<BackboneStep> vgg{
        {0, 64, {}, false, false},  {2, 64, {}, false, true},   {5, 128, {}, true, false},
        {7, 128, {}, false, true},  {10, 256, {}, true, false}, {12, 256, {}, false, false},
        {14, 256, {}, false, true}, {17, 512, {}, true, false}, {19, 512, {}, false, false},
        {21, 512, {}, false, true}, {24, 512, {}, true, false}, {26, 512, {}, false, false},
        {28, 512, {}, false, true}};
    return net == LpipsNet::alex ? alex : vgg;
}

std::vector<Tensor> maps_of(const Scope& s, LpipsNet net, const Tensor& x) {
    const auto constant = [&](double r, double g, double b) {
        return at::tensor(std::vector<double>{r, g, b}, x.options()).reshape({1, 3, 1, 1});
    };
    Tensor y = (x - constant(-.030, -.088, -.188)) / constant(.458, .448, .450);
    std::vector<Tensor> out;
    for (const BackboneStep& step : steps_of(net)) {
        if (step.pool_before) y = net == LpipsNet::alex ? at::max_pool2d(y, 3, 2) : at::max_pool2d(y, 2, 2);
        y = at::relu(conv(s / "features" / step.index, y, step.channels, step.shape));
        if (step.compare) out.push_back(y);
    }
    return out;
}

Tensor unit_length(const Tensor& x) { return x / (at::sqrt((x * x).sum(1, true)) + 1e-10); }

}  // namespace

Lpips lpips(const Scope& backbone, const Scope& heads, LpipsNet net, const Tensor& a, const Tensor& b) {
    Lpips out;
    out.first_maps = maps_of(backbone, net, a);
    const std::vector<Tensor> others = maps_of(backbone, net, b);
    for (std::size_t i = 0; i < others.size(); ++i) {
        const Tensor difference = unit_length(out.first_maps[i]) - unit_length(others[i]);
        const Scope head = heads / ("lin" + std::to_string(i)) / "model" / 1;
        const Tensor map = at::conv2d(difference * difference, head.parameter("weight", {1, difference.size(1), 1, 1}));
        out.layers.push_back(map.mean({1, 2, 3}));
        const Tensor large = at::upsample_bilinear2d(map, {a.size(2), a.size(3)}, false);
        out.map = i == 0 ? large : out.map + large;
        out.distance = i == 0 ? out.layers[0] : out.distance + out.layers[i];
    }
    return out;
}

}  // namespace fastscene::nn

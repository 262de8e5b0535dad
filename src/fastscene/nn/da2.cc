#include "fastscene/nn/da2.h"

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

#include "fastscene/base/check.h"
#include "fastscene/image/color.h"
#include "fastscene/nn/da2_net.h"
#include "fastscene/nn/libtorch.h"
#include "fastscene/nn/precision.h"
#include "fastscene/nn/runtime.h"
#include "fastscene/nn/stoppable.h"
#include "fastscene/nn/turned_passes.h"

namespace fastscene {

using at::Tensor;

struct Da2::State {
    at::Device device;
    bool bf16;
    nn::Da2Shape shape;
    mutable nn::LoadedWeights weights;
};

namespace {

constexpr std::int64_t kEvaluatedHeight = 546, kEvaluatedWidth = 1092;
constexpr const char* kFirstKey = "dino.patch_embed.proj.weight";

// The published file has no metadata; smaller networks of ours say their shape there.
nn::Da2Shape da2_shape(const Weights& weights) {
    nn::Da2Shape shape;
    const auto read = [&](const char* name, std::int64_t unit, std::int64_t& value) {
        const auto found = weights.metadata.find(name);
        if (found == weights.metadata.end()) return;
        value = std::atoll(found->second.c_str());
        if (value < unit || value > 4096 || value % unit != 0)
            throw Error("{}: metadata \"{}\": expected a multiple of {} up to 4096, found \"{}\"",
                        weights.path.string(), name, unit, found->second);
    };
    read("width", nn::kDinoHeadWidth, shape.dino.width);
    read("blocks", 4, shape.dino.blocks);
    read("features", nn::kDinoHeadWidth, shape.features);
    return shape;
}

// [1, 3, height, width], sRGB in 0..1, quantized to 8 bits as in a file.
Tensor srgb_planes(const ImageColor& color) {
    const Tensor out = at::empty({1, 3, color.height, color.width});
    float* planes = out.data_ptr<float>();
    for (std::size_t i = 0; i < color.size(); ++i) {
        const Rgb8 c = srgb8_from_linear(color.pixels[i]);
        planes[i] = static_cast<float>(c.r) / 255.f;
        planes[color.size() + i] = static_cast<float>(c.g) / 255.f;
        planes[2 * color.size() + i] = static_cast<float>(c.b) / 255.f;
    }
    return out;
}

}  // namespace

Da2::Da2(std::unique_ptr<State> state) : state_(std::move(state)) {}
Da2::Da2(Da2&&) noexcept = default;
Da2& Da2::operator=(Da2&&) noexcept = default;
Da2::~Da2() = default;

bool Da2::is_in(const std::filesystem::path& file) {
    try {
        return unwrapped(load_weights(file), kFirstKey).has(kFirstKey);
    } catch (const Error&) {
        return false;  // who reads it says why
    }
}

bool Da2::gains_by_bf16(const DeviceChoice& device) {
    return nn::multiplies_bf16(nn::device_named(device.name, device.flag));
}

Da2 Da2::load(const std::filesystem::path& file, const DeviceChoice& choice, bool bf16) {
    const at::NoGradGuard no_gradients;
    use_our_threads();
    Weights weights = unwrapped(load_weights(file), kFirstKey);
    const nn::Da2Shape shape = da2_shape(weights);
    const at::Device device = nn::device_named(choice.name, choice.flag);
    nn::check_fits(nn::da2_parameters(shape), weights, nn::da2_unused(shape));
    return Da2(std::make_unique<State>(State{
        device, bf16, shape, nn::LoadedWeights(std::move(weights), at::TensorOptions(device).dtype(at::kFloat))}));
}

ImageF Da2::relative_range(const ImageColor& color, Da2Resize resize, int turns, const Run& run) const {
    FASTSCENE_CHECK(turns >= 1);
    const at::NoGradGuard no_gradients;
    use_our_threads();
    Tensor seen = srgb_planes(color);
    if (resize == Da2Resize::evaluation)
        seen = at::_upsample_bilinear2d_aa(seen, {kEvaluatedHeight, kEvaluatedWidth}, false);
    seen = seen.to(state_->device);
    Progress progress(run, "range", turns * static_cast<std::int64_t>(nn::da2_parameters(state_->shape).size()));
    nn::StoppableWeights weights(state_->weights, run, &progress);
    const Tensor found = nn::over_turns(seen, turns,
                                        [&](const Tensor& turned) {
                                            return nn::da2(nn::Scope(weights), state_->shape, turned, {}, state_->bf16);
                                        })
                             .contiguous()
                             .cpu();
    ImageF out(static_cast<int>(found.size(2)), static_cast<int>(found.size(1)));
    std::copy_n(found.data_ptr<float>(), out.size(), out.pixels.begin());
    return out;
}

}  // namespace fastscene

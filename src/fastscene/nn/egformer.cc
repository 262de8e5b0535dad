#include "fastscene/nn/egformer.h"

#include <utility>

#include "fastscene/nn/libtorch.h"
#include "fastscene/geometry/reproject.h"
#include "fastscene/image/color.h"
#include "fastscene/nn/egformer_net.h"
#include "fastscene/nn/precision.h"
#include "fastscene/nn/runtime.h"
#include "fastscene/weights/shipped.h"
#include "fastscene/nn/weights_torch.h"

namespace fastscene {

struct Egformer::State {
    at::Device device;
    mutable nn::LoadedWeights weights;
    nn::EgformerConstants constants;
};

namespace {

// The width of the first stage follows from the file; our files also state the training resolution.
EgformerShape egformer_shape(const Weights& weights) {
    const WeightTensor& first = weights.at("patch_embed.0.weight");
    if (first.shape.size() != 4 || first.shape[0] < 4 || first.shape[0] > 256 || first.shape[0] % 4 != 0)
        throw Error("{}: patch_embed.0.weight: expected the shape [C, 3, 3, 3] with C a multiple of 4, found {}",
                    weights.path.string(), text_of_shape(first.shape));
    EgformerShape shape;
    shape.channels = static_cast<int>(first.shape[0]);
    shape.latitude_prior = weights.has(nn::kLatitudePrior);
    if (const auto height = weights.metadata.find("height"); height != weights.metadata.end()) {
        shape.height = std::atoi(height->second.c_str());
        if (shape.height < 32 || shape.height > 4096 || shape.height % 32 != 0)
            throw Error("{}: metadata \"height\": expected a multiple of 32 up to 4096, found \"{}\"",
                        weights.path.string(), height->second);
        shape.width = 2 * shape.height;
    }
    return shape;
}

// Requests every parameter once on a tiny picture, so that an incomplete file is refused before any work.
void check_all_keys(nn::LoadedWeights& weights, EgformerShape shape, at::Device device) {
    shape.height = 32;
    shape.width = 64;
    const nn::EgformerConstants tiny(shape, device);
    nn::egformer(nn::Scope(weights), tiny, at::zeros({1, 3, 32, 64}, device));
}

}  // namespace

Egformer::Egformer(std::unique_ptr<State> state) : state_(std::move(state)) {}
Egformer::Egformer(Egformer&&) noexcept = default;
Egformer& Egformer::operator=(Egformer&&) noexcept = default;
Egformer::~Egformer() = default;

Egformer Egformer::load(const std::filesystem::path& path, const DeviceChoice& device) {
    return of(unwrapped(load_weights(path), "patch_embed.0.weight"), device);
}
Egformer Egformer::shipped(std::string_view name, const DeviceChoice& device) {
    return of(shipped_weights(name), device);
}

Egformer Egformer::of(Weights weights, const DeviceChoice& choice) {
    const at::NoGradGuard no_gradients;
    use_our_threads();
    const EgformerShape shape = egformer_shape(weights);
    const at::Device device = nn::device_named(choice.name, choice.flag);
    auto state = std::make_unique<State>(
        State{device, nn::LoadedWeights(std::move(weights), at::TensorOptions(device).dtype(at::kFloat)),
              nn::EgformerConstants(shape, device)});
    check_all_keys(state->weights, shape, device);
    return Egformer(std::move(state));
}

const EgformerShape& Egformer::shape() const { return state_->constants.shape; }

ImageF Egformer::relative_depth(const ImageColor& color, int augmentations) const {
    FASTSCENE_CHECK(augmentations >= 1 && augmentations <= 8);
    const at::NoGradGuard no_gradients;
    use_our_threads();
    const EgformerShape& size = shape();
    const ImageColor seen = equirect_from_equirect(color, {size.width, size.height});
    at::Tensor input = at::empty({1, 3, size.height, size.width});
    float* planes = input.data_ptr<float>();
    for (std::size_t i = 0; i < seen.size(); ++i) {
        // Quantized to 8 bits, like the network's training data.
        const Rgb8 c = srgb8_from_linear(seen.pixels[i]);
        planes[i] = static_cast<float>(c.r) / 255.f;
        planes[seen.size() + i] = static_cast<float>(c.g) / 255.f;
        planes[2 * seen.size() + i] = static_cast<float>(c.b) / 255.f;
    }
    input = input.to(state_->device);
    at::Tensor sum;
    for (int k = 0; k < augmentations; ++k) {
        const std::int64_t turn = k / 2 * (size.width / 4);
        const bool mirrored = k % 2 == 1;
        const at::Tensor turned = input.roll(turn, 3);
        const at::Tensor found = nn::egformer(nn::Scope(state_->weights), state_->constants,
                                              mirrored ? turned.flip(3) : turned.contiguous());
        const at::Tensor back = (mirrored ? found.flip(3) : found).roll(-turn, 3);
        sum = k == 0 ? back : sum + back;
    }
    const at::Tensor depth = (augmentations == 1 ? sum : sum / augmentations).contiguous().cpu();
    ImageF out(size.width, size.height);
    std::copy_n(depth.data_ptr<float>(), out.size(), out.pixels.begin());
    return out;
}

}  // namespace fastscene

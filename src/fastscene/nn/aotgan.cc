#include "fastscene/nn/aotgan.h"

#include <c10/core/InferenceMode.h>

#include <mutex>

#include "fastscene/base/check.h"
#include "fastscene/nn/aotgan_net.h"
#include "fastscene/nn/precision.h"
#include "fastscene/nn/runtime.h"
#include "fastscene/nn/weights_torch.h"

namespace fastscene {

struct Aotgan::State {
    nn::AotganShape shape;
    bool adds_to_fill = false;
    at::Device device;
    nn::LoadedWeights weights;
    std::mutex one_at_a_time;  // parameters are created on first use, so calls are serialized
};

Aotgan::Aotgan(std::unique_ptr<State> state) : state_(std::move(state)) {}
Aotgan::Aotgan(Aotgan&&) noexcept = default;
Aotgan& Aotgan::operator=(Aotgan&&) noexcept = default;
Aotgan::~Aotgan() = default;

Aotgan Aotgan::load(const std::filesystem::path& path, const DeviceChoice& device) {
    return of(load_weights(path), device);
}

Aotgan Aotgan::of(Weights found, const DeviceChoice& choice) {
    Weights weights = unwrapped(std::move(found), "encoder.1.weight");
    const nn::AotganShape shape = nn::aotgan_shape(weights);
    const std::string holes = weights.metadata.contains("holes") ? weights.metadata.at("holes") : "white";
    if (holes != "white" && holes != "harmonic")
        throw Error("{}: holes: expected white or harmonic in the metadata, found \"{}\"", weights.path.string(),
                    holes);
    const at::Device device = nn::device_named(choice.name, choice.flag);
    Aotgan out(std::unique_ptr<State>(
        new State{shape,
                  holes == "harmonic",
                  device,
                  nn::LoadedWeights(std::move(weights), at::TensorOptions(device).dtype(at::kFloat)),
                  {}}));
    // A trial run on the smallest picture reports mismatched weights now instead of in the middle of a walk.
    (void)out.paint({{ImageColor(kSmallest, kSmallest), ImageMask(kSmallest, kSmallest)}}, {});
    return out;
}

bool Aotgan::adds_to_fill() const { return state_->adds_to_fill; }

std::vector<ImageColor> Aotgan::paint(const std::vector<Picture>& pictures, const Run& run) const {
    if (pictures.empty()) return {};
    const int w = pictures[0].color.width, h = pictures[0].color.height;
    FASTSCENE_CHECK(w % kMultiple == 0 && h % kMultiple == 0 && w >= kSmallest && h >= kSmallest);
    run.check_stop();
    const std::lock_guard lock(state_->one_at_a_time);
    use_our_threads();
    const c10::InferenceMode inference;
    const auto n = static_cast<std::int64_t>(pictures.size());
    // With few channels, the channels-last memory format is faster (docs/benchmarks.md).
    const at::TensorOptions by_pixels = at::TensorOptions(at::kFloat).memory_format(at::MemoryFormat::ChannelsLast);
    at::Tensor input = at::empty({n, 3, h, w}, by_pixels), mask = at::empty({n, 1, h, w}, by_pixels);
    auto in = input.accessor<float, 4>(), hole = mask.accessor<float, 4>();
    for (std::int64_t i = 0; i < n; ++i) {
        const Picture& picture = pictures[static_cast<std::size_t>(i)];
        FASTSCENE_CHECK(picture.color.width == w && picture.color.height == h && picture.hole.same_size(picture.color));
        for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x) {
                const bool open = picture.hole.at(x, y) != 0;
                hole[i][0][y][x] = open ? 1.f : 0.f;
                for (int c = 0; c < 3; ++c)
                    in[i][c][y][x] = open && !adds_to_fill()
                                         ? 1.f
                                         : 2 * picture.color.at(x, y)[static_cast<std::size_t>(c)] - 1;
            }
    }
    input = input.to(state_->device), mask = mask.to(state_->device);
    at::Tensor out = nn::aotgan_generator(nn::Scope(state_->weights), state_->shape, input, mask);
    if (adds_to_fill()) out = (input + out * mask).clamp(-1, 1);
    out = out.contiguous().cpu();
    const auto painted = out.accessor<float, 4>();
    std::vector<ImageColor> result;
    for (std::int64_t i = 0; i < n; ++i) {
        ImageColor& image = result.emplace_back(w, h);
        for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x)
                image.at(x,
                         y) = (Vec3f{painted[i][0][y][x], painted[i][1][y][x], painted[i][2][y][x]} + Vec3f{1, 1, 1}) *
                              0.5f;
    }
    return result;
}

}  // namespace fastscene

#include "fastscene/nn/aotgan_training.h"

#include <algorithm>
#include <cmath>

#include "fastscene/nn/libtorch.h"
#include "fastscene/nn/aotgan_losses.h"
#include "fastscene/nn/aotgan_net.h"
#include "fastscene/nn/aotgan_widen.h"
#include "fastscene/nn/precision.h"
#include "fastscene/weights/safetensors.h"
#include "fastscene/nn/training.h"

namespace fastscene {
namespace {

using namespace nn;
using at::Tensor;

constexpr std::int64_t kSmallest = 64;  // picture size of a new network's trial run
constexpr std::size_t kRowsOfSheet = 8;
constexpr std::size_t kLookTogether = 8;
constexpr int kPyramidLevels = 4;

// Inputs of a step: pictures [N, 3, H, W] in -1..1, masks [N, 1, H, W] with 1 = hole.
struct Pictures {
    Tensor truth, shown, hole;  // `shown`: the network's input, with white or the harmonic fill in the holes
};

// Stacks examples into a batch.
Batch batch_of(const std::vector<const InpaintExample*>& examples, bool harmonic) {
    const int w = examples[0]->truth.width, h = examples[0]->truth.height;
    const auto n = static_cast<std::int64_t>(examples.size());
    const Tensor truth = at::empty({n, 3, h, w}), shown = at::empty({n, 3, h, w}), hole = at::empty({n, 1, h, w});
    auto t = truth.accessor<float, 4>(), s = shown.accessor<float, 4>(), m = hole.accessor<float, 4>();
    for (std::int64_t i = 0; i < n; ++i) {
        const InpaintExample& e = *examples[static_cast<std::size_t>(i)];
        FASTSCENE_CHECK(e.truth.width == w && e.truth.height == h && e.hole.same_size(e.truth) &&
                        (!harmonic || e.filled.same_size(e.truth)));
        for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x) {
                const Rgb8 c = e.truth.at(x, y);
                const std::uint8_t rgb[] = {c.r, c.g, c.b};
                const bool open = e.hole.at(x, y) != 0;
                m[i][0][y][x] = open ? 1.f : 0.f;
                for (int k = 0; k < 3; ++k) {
                    t[i][k][y][x] = static_cast<float>(rgb[k]) / 127.5f - 1;
                    s[i][k][y][x] = !open      ? t[i][k][y][x]
                                    : harmonic ? 2 * e.filled.at(x, y)[static_cast<std::size_t>(k)] - 1
                                               : 1.f;
                }
            }
    }
    return {truth, shown, hole};
}

Batch batch_of(const std::vector<InpaintExample>& examples, std::size_t begin, std::size_t end, bool harmonic) {
    std::vector<const InpaintExample*> some;
    for (std::size_t i = begin; i < end; ++i) some.push_back(&examples[i]);
    return batch_of(some, harmonic);
}

// L1 distance over a Laplacian pyramid (Burt and Adelson 1983). Replaces the perceptual loss when VGG19 is unavailable:
// unlike plain L1, it penalizes wrong edges and textures early in training.
Tensor pyramid_loss(Tensor difference) {
    Tensor sum = at::zeros({}, difference.options());
    for (int level = 0; level < kPyramidLevels; ++level) {
        const Tensor coarse = at::avg_pool2d(difference, 2),
                     back = at::upsample_bilinear2d(coarse, difference.sizes().slice(2), false);
        sum = sum + (difference - back).abs().mean();
        difference = coarse;
    }
    return sum;
}

Tensor mean_in_holes(const Tensor& values, const Tensor& hole) {
    return (values * hole).sum() / (hole.sum() * values.size(1)).clamp_min(1);
}

// -PSNR / 10 in the holes, averaged over pictures. A mean squared error would be dominated by a few unpredictable
// pictures; this loss weights the relative error of each picture equally.
Tensor lacking_psnr(const Tensor& difference, const Tensor& hole) {
    constexpr double kRounding = 1e-5;  // 8-bit quantization error, squared, in units of -1..1
    const std::vector<std::int64_t> picture{1, 2, 3};
    const Tensor square = (difference.square() * hole).sum(picture) /
                          (hole.sum(picture) * difference.size(1)).clamp_min(1);
    return (square / 4 + kRounding).log10().mean();
}

class Trainer {
  public:
    Trainer(const AotganTrainingParams& params, const InpaintExamples& examples, std::filesystem::path folder,
            std::uint64_t seed)
        : params_(params),
          examples_(examples),
          folder_(std::move(folder)),
          device_(training_device(params.training)),
          bf16_(trains_in_bf16(params.training)),
          generator_(
              "generator", first_generator(params, seed), at::TensorOptions(device_).dtype(at::kFloat),
              [&](const Scope& s) {
                  (void)aotgan_generator(s, shape(), at::zeros({1, 3, kSmallest, kSmallest}, device_),
                                         at::zeros({1, 1, kSmallest, kSmallest}, device_));
              },
              settings()) {
        if (params.adversarial > 0)
            discriminator_ = std::make_unique<Learner>(
                "discriminator", start_normal(seed, 0.02), at::TensorOptions(device_).dtype(at::kFloat),
                [&](const Scope& s) {
                    (void)aotgan_discriminator(s, params_.width, at::zeros({1, 3, kSmallest, kSmallest}, device_),
                                               false);
                },
                settings());
        if (!params.vgg.empty())
            vgg_ = std::make_unique<LoadedWeights>(load_weights(params.vgg),
                                                   at::TensorOptions(device_).dtype(at::kFloat));
    }

    TrainingTask task() {
        TrainingTask out;
        out.learners = {&generator_};
        if (discriminator_) out.learners.push_back(discriminator_.get());
        out.draw = [this](Random& rng) { return draw(rng); };
        out.step = [this](const Batch& batch, std::int64_t step, double learning_rate) {
            return this->step(on_device(batch), step, learning_rate);
        };
        out.evaluate = [this] { return evaluate(); };
        out.held_out = static_cast<int>(examples_.held_out.size());
        out.held_out_together = static_cast<int>(kLookTogether);
        AotganTrainingParams network = params_;
        network.training = {};
        out.settings = fields_json(network);
        const Json loop = fields_json(TrainingParams{});
        for (const auto& [name, value] : loop.items()) out.settings.erase(name);  // train() records those itself
        out.settings["examples"] = examples_.about;
        return out;
    }

  private:
    AotganShape shape() const { return {params_.width, params_.blocks, {1, 2, 4, 8}, params_.skips}; }
    bool harmonic() const { return params_.holes == "harmonic"; }
    LearnerSettings settings() const {
        return {{.learning_rate = params_.training.learning_rate, .beta1 = 0.5, .beta2 = 0.999},
                params_.training.ema_decay,
                params_.training.clip};
    }

    // A network that adds to the harmonic fill is initialized to add nothing.
    static Start first_generator(const AotganTrainingParams& params, std::uint64_t seed) {
        const Start kernels = params.holes == "harmonic" ? start_he(seed) : start_normal(seed, 0.02);
        const bool nothing = params.holes == "harmonic";
        const Start fresh = [kernels, nothing](const std::string& key, at::IntArrayRef shape) {
            return nothing && key == "decoder.4.weight" ? at::zeros(shape) : kernels(key, shape);
        };
        if (params.start.empty()) return fresh;
        return start_from(as_wide(unwrapped(load_weights(params.start), "encoder.1.weight"), params.width, seed),
                          "encoder.1.weight", fresh);
    }
    // Widens a narrower generator if the widths divide evenly; others are rejected later with their mismatch.
    static Weights as_wide(Weights weights, std::int64_t width, std::uint64_t seed) {
        if (!weights.has("encoder.1.weight")) return weights;
        const AotganShape found = aotgan_shape(weights);
        return found.width < width && width % found.width == 0 ? widened(weights, found, width / found.width, seed)
                                                               : weights;
    }

    Batch draw(Random& rng) const {
        std::vector<InpaintExample> drawn;
        for (int i = 0; i < params_.training.batch; ++i) drawn.push_back(examples_.draw(rng));
        return batch_of(drawn, 0, drawn.size(), harmonic());
    }
    Pictures on_device(const Batch& batch) const {
        return {batch[0].to(device_), batch[1].to(device_), batch[2].to(device_)};
    }

    Tensor painted(const Scope& generator, const Pictures& p) const {
        const Tensor out = aotgan_generator(generator, shape(), p.shown, p.hole).to(at::kFloat);
        return harmonic() ? p.shown + out * p.hole : out;  // its output at known pixels is never used
    }

    Numbers step(const Pictures& p, std::int64_t step, double learning_rate) {
        const Autocast autocast(device_, bf16_);
        Numbers numbers;
        Tensor loss = at::zeros({}, at::TensorOptions(device_).dtype(at::kFloat));
        const auto add = [&](const char* name, double weight, const Tensor& value) {
            numbers.emplace_back(name, value.item<double>());
            loss = loss + weight * value;
        };
        const Tensor made = painted(generator_.scope(), p), difference = made - p.truth;
        add("l1", params_.l1, difference.abs().mean());
        add("l1 in holes", params_.l1_holes, mean_in_holes(difference.abs(), p.hole));
        add("l2 in holes", params_.l2_holes, mean_in_holes(difference.square(), p.hole));
        add("minus psnr / 10", params_.psnr, lacking_psnr(difference, p.hole));
        if (vgg_) {
            const Maps a = vgg19_maps(Scope(*vgg_), made), b = vgg19_maps(Scope(*vgg_), p.truth);
            add("style", params_.style, style_loss(a, b));
            add("perceptual", params_.perceptual, perceptual_loss(a, b));
        } else {
            add("pyramid", params_.pyramid, pyramid_loss(difference));
        }
        if (discriminator_) {
            const Tensor composed = p.truth * (1 - p.hole) + made * p.hole;
            const Adversarial said = soft_mask_loss(discriminator_->scope(), params_.width, composed, p.truth, p.hole);
            add("adversarial", step >= params_.adversarial_from ? params_.adversarial : 0, said.generator);
            loss.backward();
            discriminator_->forget_gradients();  // gradients of the generator's loss must not train the discriminator
            said.discriminator.backward();
            numbers.emplace_back("discriminator", said.discriminator.item<double>());
            discriminator_->update(learning_rate);
        } else {
            loss.backward();
        }
        numbers.emplace_back("gradient", generator_.update(learning_rate));
        return numbers;
    }

    Evaluation evaluate() {
        const at::NoGradGuard no_gradients;
        double psnr = 0, psnr_fill = 0, l1 = 0;
        std::vector<ImageRgb8> rows;
        for (std::size_t begin = 0; begin < examples_.held_out.size(); begin += kLookTogether) {
            const std::size_t end = std::min(examples_.held_out.size(), begin + kLookTogether);
            const Pictures p = on_device(batch_of(examples_.held_out, begin, end, harmonic()));
            const Tensor made = p.truth * (1 - p.hole) + painted(generator_.ema(), p).clamp(-1, 1) * p.hole;
            for (std::int64_t i = 0; i < made.size(0); ++i) {
                psnr += psnr_in_holes(made[i], p.truth[i], p.hole[i]);
                psnr_fill += psnr_in_holes(p.shown[i], p.truth[i], p.hole[i]);
                l1 += mean_in_holes((made[i] - p.truth[i]).abs().unsqueeze(0), p.hole[i].unsqueeze(0)).item<double>();
                if (rows.size() < kRowsOfSheet)
                    rows.push_back(picture_of(
                        at::cat({p.shown[i] * (1 - p.hole[i]) + p.hole[i], p.shown[i], made[i], p.truth[i]}, 2)));
            }
        }
        keep();
        const double n = std::max<double>(1, static_cast<double>(examples_.held_out.size()));
        return {{{"psnr", psnr / n},
                 {harmonic() ? "psnr of the harmonic fill" : "psnr of white", psnr_fill / n},
                 {"l1", l1 / n}},
                stacked(rows)};
    }

    static double psnr_in_holes(const Tensor& a, const Tensor& b, const Tensor& hole) {
        const auto bytes = [](const Tensor& x) { return ((x + 1) * 127.5).round(); };
        const double square = mean_in_holes((bytes(a) - bytes(b)).square().unsqueeze(0), hole.unsqueeze(0))
                                  .item<double>();
        return 10 * std::log10(255.0 * 255.0 / std::max(square, 1e-3));
    }

    static ImageRgb8 picture_of(const Tensor& x) {
        const Tensor bytes = ((x + 1) * 127.5).round().clamp(0, 255).to(at::kCPU).contiguous();
        const auto v = bytes.accessor<float, 3>();
        ImageRgb8 out(static_cast<int>(x.size(2)), static_cast<int>(x.size(1)));
        for (int row = 0; row < out.height; ++row)
            for (int col = 0; col < out.width; ++col)
                out.at(col, row) = {static_cast<std::uint8_t>(v[0][row][col]),
                                    static_cast<std::uint8_t>(v[1][row][col]),
                                    static_cast<std::uint8_t>(v[2][row][col])};
        return out;
    }
    static ImageRgb8 stacked(const std::vector<ImageRgb8>& rows) {
        ImageRgb8 out;
        for (const ImageRgb8& row : rows) {
            out.width = row.width;
            out.height += row.height;
            out.pixels.insert(out.pixels.end(), row.pixels.begin(), row.pixels.end());
        }
        return out;
    }

    void keep() const {
        Weights weights = generator_.kept();
        weights.metadata = {
            {"holes", params_.holes}, {"rates", "[1, 2, 4, 8]"}, {"steps", std::to_string(generator_.steps())}};
        save_safetensors(folder_ / "generator.safetensors", weights, SaveAs::f16);
    }

    const AotganTrainingParams& params_;
    const InpaintExamples& examples_;
    std::filesystem::path folder_;
    at::Device device_;
    bool bf16_;
    Learner generator_;
    std::unique_ptr<Learner> discriminator_;
    std::unique_ptr<LoadedWeights> vgg_;
};

}  // namespace

std::vector<std::pair<std::string, double>> train_aotgan(const AotganTrainingParams& params,
                                                         const InpaintExamples& examples,
                                                         const std::filesystem::path& folder, const Run& run) {
    FASTSCENE_CHECK(examples.draw != nullptr && !examples.held_out.empty());
    Trainer trainer(params, examples, folder, run.seed);
    return train(trainer.task(), params.training, folder, run).held_out;
}

}  // namespace fastscene

#include "fastscene/nn/egformer_training.h"

#include <algorithm>
#include <cmath>

#include "fastscene/nn/libtorch.h"
#include "fastscene/image/color.h"
#include "fastscene/image/colormap.h"
#include "fastscene/image/label.h"
#include "fastscene/nn/depth_losses.h"
#include "fastscene/nn/egformer_net.h"
#include "fastscene/nn/precision.h"
#include "fastscene/weights/safetensors.h"
#include "fastscene/nn/training.h"

namespace fastscene {
namespace {

using at::Tensor;

constexpr float kUnit = 16.f;  // metres per unit of the network's output

// color [N, 3, H, W] in 0..1, truth and mask [N, 1, H, W].
nn::Batch batch_of(const std::vector<DepthExample>& examples, const EgformerShape& shape) {
    const auto n = static_cast<std::int64_t>(examples.size());
    const std::size_t pixels = static_cast<std::size_t>(shape.width) * static_cast<std::size_t>(shape.height);
    const Tensor color = at::empty({n, 3, shape.height, shape.width}),
                 truth = at::zeros({n, 1, shape.height, shape.width}), mask = at::zeros_like(truth);
    for (std::size_t i = 0; i < examples.size(); ++i) {
        const DepthExample& e = examples[i];
        FASTSCENE_CHECK(e.color.width == shape.width && e.color.height == shape.height && e.range.same_size(e.color));
        float* c = color.data_ptr<float>() + 3 * pixels * i;
        float *t = truth.data_ptr<float>() + pixels * i, *m = mask.data_ptr<float>() + pixels * i;
        for (std::size_t p = 0; p < pixels; ++p) {
            const Vec3f v = unit_from_srgb8(e.color.pixels[p]);
            c[p] = v.x, c[pixels + p] = v.y, c[2 * pixels + p] = v.z;
            const float range = e.range.pixels[p];
            if (!(range > 0.f && range < kFarthestTaught_m)) continue;
            t[p] = range / kUnit;
            m[p] = 1;
        }
    }
    return {color, truth, mask};
}

double logit(double p) { return std::log(p / (1 - p)); }

// The initial network predicts the mean range at each latitude; its last layer starts near zero.
nn::Start start_of(const EgformerTraining& training, std::uint64_t seed) {
    nn::Start random = nn::start_he(seed, 1);
    if (!training.start.empty()) random = nn::start_from(load_weights(training.start), "patch_embed.0.weight", random);
    const std::vector<float> means = training.mean_range_m;
    const bool fresh = training.start.empty();
    return [=](const std::string& key, at::IntArrayRef shape) {
        const Tensor made = random(key, shape);
        if (!fresh) return made;
        if (key == "output_conv.4.weight") return made * 0.1;
        if (key != nn::kLatitudePrior || means.empty()) return made;
        const Tensor prior = at::empty(shape, at::kFloat);
        float* to = prior.data_ptr<float>();
        for (std::int64_t i = 0; i < prior.numel(); ++i) {
            const std::size_t row = std::min(
                means.size() - 1,
                static_cast<std::size_t>((static_cast<double>(i) + 0.5) * static_cast<double>(means.size()) /
                                         static_cast<double>(prior.numel())));
            to[i] = static_cast<float>(logit(std::clamp(means[row] / kUnit, 0.01f, 0.99f)));
        }
        return prior;
    };
}

struct Figures {
    double abs_rel = 0, delta1 = 0;
};
Figures figures_of(const Tensor& aligned, const Tensor& truth, const Tensor& mask) {
    const Tensor known = mask > 0.5;
    const Tensor a = aligned.masked_select(known).clamp_min(1e-3), t = truth.masked_select(known);
    return {((a - t).abs() / t).mean().item<double>(),
            (at::maximum(a / t, t / a) < 1.25).to(at::kFloat).mean().item<double>()};
}

ImageF picture_of(const Tensor& map) {  // [1, 1, H, W]
    ImageF out(static_cast<int>(map.size(3)), static_cast<int>(map.size(2)));
    std::copy_n(map.to(at::kCPU).contiguous().data_ptr<float>(), out.size(), out.pixels.begin());
    return out;
}

// Preview: color, ground truth and prediction, one example per row.
class Sheet {
  public:
    Sheet(const EgformerShape& shape, int rows) : shape_(shape), image_(3 * shape.width, rows * shape.height) {}
    void add(const DepthExample& example, const Tensor& aligned, const Tensor& truth, double abs_rel) {
        const int y = row_++ * shape_.height;
        paste(image_, example.color, 0, y);
        paste(image_, colored(picture_of(truth), 0, 0.5f), shape_.width, y);
        paste(image_, colored(picture_of(aligned), 0, 0.5f), 2 * shape_.width, y);
        draw_label(image_, fmt::format("{:.3f}", abs_rel), 2 * shape_.width + 4, y + 4, {255, 255, 255});
    }
    const ImageRgb8& image() const { return image_; }

  private:
    EgformerShape shape_;
    ImageRgb8 image_;
    int row_ = 0;
};

}  // namespace

EgformerTrained train_egformer(const EgformerTraining& training, const std::filesystem::path& folder, const Run& run) {
    const EgformerShape& shape = training.shape;
    const at::Device device = nn::training_device(training.training);
    // On a CPU, libtorch 1.13 lacks a bfloat16 layer norm with single precision parameters.
    if (training.training.precision == "bf16" && device.is_cpu())
        throw UsageError("--precision bf16: expected for this network with --device cuda only, found a CPU");
    const bool bf16 = device.is_cuda() && nn::trains_in_bf16(training.training);
    const nn::EgformerConstants constants(shape, device), tiny({32, 64, shape.channels, shape.latitude_prior}, device);
    nn::Learner network("egformer", start_of(training, run.seed), at::TensorOptions(device),
                        [&](const nn::Scope& s) {
                            nn::egformer(s, tiny, at::zeros({1, 3, 32, 64}, device));
                        },
                        {.adam = {}, .ema_decay = training.training.ema_decay, .clip = training.training.clip});
    EgformerTrained trained{0, 0, 0, folder / "egformer.safetensors"};

    const auto evaluate = [&] {
        const at::NoGradGuard no_gradients;
        Sheet sheet(shape, std::min<int>(6, static_cast<int>(training.held_out.size())));
        Figures mean;
        double loss = 0;
        for (std::size_t i = 0; i < training.held_out.size(); ++i) {
            run.check_stop();
            nn::Batch one = batch_of({training.held_out[i]}, shape);
            for (Tensor& t : one) t = t.to(device);
            const Tensor aligned = nn::aligned_depth(nn::egformer(network.ema(), constants, one[0]), one[1], one[2]);
            const Figures f = figures_of(aligned, one[1], one[2]);
            mean.abs_rel += f.abs_rel, mean.delta1 += f.delta1;
            loss += 0.5 * (nn::invariant_loss(aligned, one[1], one[2]) + nn::gradient_loss(aligned, one[1], one[2]))
                              .item<double>();
            if (i < 6) sheet.add(training.held_out[i], aligned, one[1], f.abs_rel);
        }
        const double n = std::max<double>(1, static_cast<double>(training.held_out.size()));
        trained.abs_rel = mean.abs_rel / n, trained.delta1 = mean.delta1 / n;
        Weights kept = network.kept();
        kept.metadata["height"] = std::to_string(shape.height);
        save_safetensors(trained.weights, kept, SaveAs::f16);
        return nn::Evaluation{{{"loss", loss / n}, {"abs_rel", trained.abs_rel}, {"delta1", trained.delta1}},
                              sheet.image()};
    };
    const auto step = [&](const nn::Batch& batch, std::int64_t, double learning_rate) -> nn::Numbers {
        const Tensor color = batch[0].to(device), truth = batch[1].to(device), mask = batch[2].to(device);
        Tensor found;
        {
            const nn::Autocast quick(device, bf16);
            found = nn::egformer(network.scope(), constants, color).to(at::kFloat);
        }
        const Tensor loss = nn::depth_loss(found, truth, mask), direct = nn::direct_loss(found, truth, mask);
        (loss + training.direct * direct).backward();
        const double length = network.update(learning_rate);
        return {{"loss", loss.item<double>()}, {"direct", direct.item<double>()}, {"gradient", length}};
    };
    const auto draw = [&](Random& rng) {
        std::vector<DepthExample> examples;
        for (int i = 0; i < training.training.batch; ++i) examples.push_back(training.draw(rng));
        return batch_of(examples, shape);
    };
    Json settings = training.settings;
    settings["network"] = {{"name", "egformer"}, {"height", shape.height}, {"channels", shape.channels}};
    settings["direct"] = training.direct;
    trained.steps = nn::train({.learners = {&network},
                               .draw = draw,
                               .step = step,
                               .evaluate = evaluate,
                               .held_out = static_cast<int>(training.held_out.size()),
                               .settings = settings},
                              training.training, folder, run)
                        .steps;
    return trained;
}

}  // namespace fastscene

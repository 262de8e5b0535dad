#include "fastscene/nn/aotgan_losses.h"

#include "fastscene/nn/layers.h"

namespace fastscene::nn {
namespace {

using at::Tensor;

// Layers of torchvision's VGG19 up to relu5_2: channels, position in `features`, name of the rectified output.
struct Step {
    int index;
    std::int64_t channels;
    const char* name;
    bool pool_before;
};
constexpr Step kVgg19[] = {{0, 64, "relu1_1", false},   {2, 64, "relu1_2", false},   {5, 128, "relu2_1", true},
                           {7, 128, "relu2_2", false},  {10, 256, "relu3_1", true},  {12, 256, "relu3_2", false},
                           {14, 256, "relu3_3", false}, {16, 256, "relu3_4", false}, {19, 512, "relu4_1", true},
                           {21, 512, "relu4_2", false}, {23, 512, "relu4_3", false}, {25, 512, "relu4_4", false},
                           {28, 512, "relu5_1", true},  {30, 512, "relu5_2", false}};

// ImageNet's mean and standard deviation.
constexpr double kMean[] = {0.485, 0.456, 0.406}, kDeviation[] = {0.229, 0.224, 0.225};

Tensor color(const double (&values)[3], const Tensor& like) {
    return at::tensor(std::vector<double>{values[0], values[1], values[2]}, like.options()).reshape({1, 3, 1, 1});
}

Tensor mean_square(const Tensor& a, const Tensor& b) { return (a - b).square().mean(); }

Tensor at_size_of(const Tensor& x, const Tensor& mask) {
    if (x.sizes().slice(2) == mask.sizes().slice(2)) return x;
    return at::upsample_bilinear2d(x, {mask.size(2), mask.size(3)}, /*align_corners=*/true);
}

// Blurred hole mask: a patch that is partly inside a hole counts as partly fake.
Tensor softened(const Tensor& mask) { return gaussian_blur(mask, 71, 10); }

// The three discriminator calls of a step, in the published order; each performs one power iteration of the spectral
// norm.
struct Verdicts {
    Tensor of_fake, of_fake_detached, of_real;
};
Verdicts verdicts(const Scope& s, std::int64_t width, const Tensor& fake, const Tensor& real, const Tensor& mask) {
    const Tensor a = aotgan_discriminator(s, width, fake, true),
                 b = aotgan_discriminator(s, width, fake.detach(), true),
                 c = aotgan_discriminator(s, width, real, true);
    return {at_size_of(a, mask), at_size_of(b, mask), at_size_of(c, mask)};
}

}  // namespace

Maps vgg19_maps(const Scope& s, const Tensor& picture) {
    Tensor x = ((picture + 1) / 2 - color(kMean, picture)) / color(kDeviation, picture);
    Maps out;
    for (const Step& step : kVgg19) {
        if (step.pool_before) x = at::max_pool2d(x, 2, 2);
        x = at::relu(conv(s / "features" / step.index, x, step.channels));
        out[step.name] = x;
    }
    return out;
}

Tensor gram(const Tensor& map) {
    const Tensor rows = map.flatten(2);
    return at::bmm(rows, rows.transpose(1, 2)) / static_cast<double>(map.size(1) * map.size(2) * map.size(3));
}

Tensor perceptual_loss(const Maps& a, const Maps& b) {
    Tensor sum;
    for (const char* name : {"relu1_1", "relu2_1", "relu3_1", "relu4_1", "relu5_1"}) {
        const Tensor loss = at::l1_loss(a.at(name), b.at(name));
        sum = sum.defined() ? sum + loss : loss;
    }
    return sum;
}

Tensor style_loss(const Maps& a, const Maps& b) {
    Tensor sum;
    for (const char* name : {"relu2_2", "relu3_4", "relu4_4", "relu5_2"}) {
        const Tensor loss = at::l1_loss(gram(a.at(name)), gram(b.at(name)));
        sum = sum.defined() ? sum + loss : loss;
    }
    return sum;
}

Tensor gaussian_blur(const Tensor& x, std::int64_t size, double sigma) {
    const Tensor at_x = at::arange(size, x.options()) - static_cast<double>(size / 2);
    Tensor row = at::exp(-at_x.square() / (2 * sigma * sigma));
    row = row / row.sum();
    const std::int64_t channels = x.size(1), pad = size / 2;
    const Tensor across = row.reshape({1, 1, 1, size}).expand({channels, 1, 1, size}),
                 down = row.reshape({1, 1, size, 1}).expand({channels, 1, size, 1});
    const Tensor blurred = at::conv2d(x, across, {}, 1, at::IntArrayRef{0, pad}, 1, channels);
    return at::conv2d(blurred, down, {}, 1, at::IntArrayRef{pad, 0}, 1, channels);
}

Adversarial soft_mask_loss_as_published(const Scope& s, std::int64_t width, const Tensor& fake, const Tensor& real,
                                        const Tensor& mask) {
    const Verdicts v = verdicts(s, width, fake, real, mask);
    const Tensor discriminator = mean_square(v.of_fake_detached, softened(mask)) +
                                 mean_square(v.of_real, at::zeros_like(v.of_real));
    const Tensor generator = (mean_square(v.of_fake, at::ones_like(v.of_fake)) * mask / mask.mean()).mean();
    return {discriminator, generator};
}

Adversarial soft_mask_loss(const Scope& s, std::int64_t width, const Tensor& fake, const Tensor& real,
                           const Tensor& mask) {
    const Verdicts v = verdicts(s, width, fake, real, mask);
    // Outside the picture nothing is fake: blur the known part, not the zeros of its complement.
    const Tensor discriminator = mean_square(v.of_fake_detached, 1 - softened(mask)) +
                                 mean_square(v.of_real, at::ones_like(v.of_real));
    const Tensor generator = ((v.of_fake - 1).square() * mask).sum() / mask.sum().clamp_min(1);
    return {discriminator, generator};
}

Adversarial plain_loss(const Scope& s, std::int64_t width, const Tensor& fake, const Tensor& real) {
    const Tensor of_fake = aotgan_discriminator(s, width, fake.detach(), true),
                 of_real = aotgan_discriminator(s, width, real, true);
    const Tensor discriminator = at::softplus(-of_real).mean() + at::softplus(of_fake).mean();
    return {discriminator, at::softplus(-aotgan_discriminator(s, width, fake, true)).mean()};
}

}  // namespace fastscene::nn

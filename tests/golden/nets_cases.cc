// AOT-GAN: generator, discriminator, losses and the published training step.
#include <ATen/core/grad_mode.h>

#include <regex>
#include <torch/csrc/autograd/autograd.h>

#include "fastscene/nn/adam.h"
#include "fastscene/nn/aotgan_losses.h"
#include "golden.h"

namespace fastscene::golden {
namespace {

using at::Tensor;
using nn::Adversarial;
using nn::AotganShape;
using nn::HashedWeights;
using nn::Scope;

// mask[y, x] = whether the raw number of its 8 x 8 block exceeds the threshold.
Tensor mask_of(const Case& c) {
    const auto shape = c.shape();
    const Tensor blocks = raw(c.input() + "/mask", {1, 1, shape[2] / 8, shape[3] / 8});
    return (blocks > c.json().at("mask_threshold").get<double>())
        .to(at::kFloat)
        .repeat_interleave(8, 2)
        .repeat_interleave(8, 3);
}

// Dimension 0 of parameter `key` in the manifest's list; `fallback` if it is not listed.
std::int64_t first_side(const Json& manifest, const std::string& key, std::int64_t fallback) {
    if (manifest.contains("state_dict"))
        for (const Json& entry : manifest["state_dict"])
            if (entry.at(0) == key) return entry.at(1).at(0);
    return fallback;
}

// Width and blocks from the parameter list, rates from the call's text.
AotganShape generator_shape(const Json& manifest) {
    AotganShape shape;
    shape.width = first_side(manifest, "encoder.1.weight", 64);
    if (manifest.contains("state_dict"))
        for (shape.blocks = 0; first_side(manifest, fmt::format("middle.{}.fuse.1.weight", shape.blocks), -1) > 0;)
            ++shape.blocks;
    std::smatch match;
    const std::string call = manifest.value("call", "");
    if (std::regex_search(call, match, std::regex(R"(rates=\[([0-9, ]+)\])"))) {
        shape.rates.clear();
        const std::string list = match[1];
        const std::regex number("[0-9]+");
        for (std::sregex_iterator it(list.begin(), list.end(), number), end; it != end; ++it)
            shape.rates.push_back(std::stoi(it->str()));
    }
    return shape;
}

void check_generator(Case& c) {
    HashedWeights weights;
    const nn::Listener listener = c.listener();
    const Tensor image = raw(c.input(), c.shape()), mask = mask_of(c);
    const Tensor out = nn::aotgan_generator(Scope(weights, "", &listener), generator_shape(c.network().json()),
                                            image * (1 - mask) + mask, mask);
    c.tensor("output", out);
    c.tensor("postprocess_uint8", ((out.clamp(-1, 1) + 1) / 2 * 255).to(at::kByte)[0].permute({1, 2, 0}));
}

void check_discriminator(Case& c) {
    HashedWeights weights;
    const std::int64_t width = first_side(c.network().json(), "conv.0.weight_orig", 64);
    const Tensor x = raw(c.input(), c.shape());
    std::smatch match;
    const bool training = c.name().find("train") != std::string::npos;
    int iterations = training ? 1 : 0;
    if (std::regex_search(c.name(), match, std::regex(R"((\d+)_power_iteration)"))) iterations = std::stoi(match[1]);
    for (int i = training ? 1 : 0; i < iterations; ++i) (void)nn::aotgan_discriminator(Scope(weights), width, x, true);
    const nn::Listener listener = c.listener();
    c.tensor("output", nn::aotgan_discriminator(Scope(weights, "", &listener), width, x, training));
    for (const auto& [key, tensor] : weights.seen()) c.tensor(key + " after", tensor);
}

// Enables gradients for the parameters.
void want_gradients(HashedWeights& weights) {
    for (const auto& [key, tensor] : weights.seen())
        if (!key.ends_with("weight_u") && !key.ends_with("weight_v")) tensor.set_requires_grad(true);
}
Tensor gradient_of(const Tensor& loss, const Tensor& by) {
    return torch::autograd::grad({loss}, {by}, {}, true, false, true)[0];
}

void check_losses(Case& c) {
    const at::AutoGradMode gradients(true);
    HashedWeights vgg, weights;
    const Tensor real = raw(c.input(), c.shape()), mask = mask_of(c);
    const Tensor made = raw(c.input() + "/pred", c.shape()).clone().set_requires_grad(true);
    const nn::Maps a = nn::vgg19_maps(Scope(vgg), made), b = nn::vgg19_maps(Scope(vgg), real);
    for (const auto& [name, map] : a) {
        c.tensor("vgg19(pred)." + name, map.detach());
        c.tensor("gram " + name + "(pred)", nn::gram(map).detach());
    }
    const auto both = [&](const std::string& name, const Tensor& loss) {
        c.value(name, loss.item<double>());
        c.tensor("d" + name + "/dpred", gradient_of(loss, made));
    };
    both("L1", at::l1_loss(made, real));
    both("Style", nn::style_loss(a, b));
    both("Perceptual", nn::perceptual_loss(a, b));
    c.tensor("gaussian_blur(mask,71,10)", nn::gaussian_blur(mask, 71, 10));

    const Tensor composed = (1 - mask) * real + mask * made;
    const Scope judge(weights);
    const std::int64_t width = 64;
    {
        HashedWeights first;  // all parameters must exist before gradients are enabled
        const at::NoGradGuard no_gradients;
        (void)nn::aotgan_discriminator(Scope(first), width, real, false);
        for (const auto& [key, tensor] : first.seen()) weights.set(key, tensor);
    }
    want_gradients(weights);
    const Adversarial loss = nn::soft_mask_loss_as_published(judge, width, composed, real, mask);
    c.value("smgan dis_loss", loss.discriminator.item<double>());
    c.value("smgan gen_loss", loss.generator.item<double>());
    c.tensor("dgen/dpred", gradient_of(loss.generator, made));
    for (const auto& [key, tensor] : weights.seen()) {
        if (tensor.requires_grad()) c.tensor("ddis/d" + key, gradient_of(loss.discriminator, tensor));
        c.tensor(key + " after 3 calls", tensor.detach());
    }
    HashedWeights fresh;
    const Adversarial plain = nn::plain_loss(Scope(fresh), width, composed, real);
    c.value("nsgan dis_loss (not used by FastScene)", plain.discriminator.item<double>());
    c.value("nsgan gen_loss (not used)", plain.generator.item<double>());
}

nn::NamedTensors trained(const HashedWeights& weights) {
    nn::NamedTensors out;
    for (const auto& [key, tensor] : weights.seen())
        if (tensor.requires_grad()) out.emplace_back(key, tensor);
    return out;
}

// The gate's normalization cancels a constant added before it, so that bias has an exact gradient of 0, and both
// programs have rounding noise. It must be small relative to the gradient of the gate's kernel (`beside`); nothing more
// can be required.
void compare_gradient(Case& c, const std::string& name, const Tensor& gradient, const Tensor& beside) {
    if (beside.defined() && gradient.abs().max().item<double>() < 1e-5 * beside.abs().max().item<double>())
        return c.leave_out(name, "exactly 0 but for rounding, in both programs");
    c.tensor(name, gradient);
}

// Two iterations of the published trainer.
void check_training(Case& c) {
    HashedWeights vgg, g, d;
    const AotganShape shape = generator_shape(c.network().json());
    const Tensor real = raw(c.input(), c.shape()), mask = mask_of(c);
    (void)nn::aotgan_generator(Scope(g), shape, real, mask);
    (void)nn::aotgan_discriminator(Scope(d), 64, real, false);
    want_gradients(g);
    want_gradients(d);
    nn::Adam optimize_g(trained(g), {}), optimize_d(trained(d), {});
    const at::AutoGradMode gradients(true);
    for (int i = 1; i <= 2; ++i) {
        optimize_g.forget_gradients();
        optimize_d.forget_gradients();
        const Tensor made = nn::aotgan_generator(Scope(g), shape, real * (1 - mask) + mask, mask);
        const nn::Maps a = nn::vgg19_maps(Scope(vgg), made), b = nn::vgg19_maps(Scope(vgg), real);
        const Adversarial adversarial = nn::soft_mask_loss_as_published(Scope(d), 64, (1 - mask) * real + mask * made,
                                                                        real, mask);
        const Tensor l1 = at::l1_loss(made, real), style = 250 * nn::style_loss(a, b),
                     perceptual = 0.1 * nn::perceptual_loss(a, b), advg = 0.01 * adversarial.generator;
        (l1 + style + perceptual + advg).backward({}, true);
        adversarial.discriminator.backward();
        for (const auto& [name, loss] : {std::pair{"L1", l1},
                                         {"Style", style},
                                         {"Perceptual", perceptual},
                                         {"advg", advg},
                                         {"advd", adversarial.discriminator}})
            c.value(fmt::format("iter{} {} (weighted)", i, name), loss.item<double>());
        if (i == 1) {
            for (const auto& [key, tensor] : d.seen())
                if (tensor.requires_grad()) c.tensor("grad D." + key, tensor.grad());
            for (const auto& [key, tensor] : g.seen())
                compare_gradient(c, "grad " + key, tensor.grad(),
                                 key.ends_with("gate.1.bias")
                                     ? g.seen().at(key.substr(0, key.size() - 4) + "weight").grad()
                                     : Tensor());
        }
        optimize_g.step();
        optimize_d.step();
    }
    for (const auto& [key, tensor] : g.seen()) c.tensor("after2 " + key, tensor.detach());
    c.leave_out("note", "a remark, no number");
}

void check_losses_or_training(Case& c) { c.name().starts_with("train") ? check_training(c) : check_losses(c); }

}  // namespace

void add_nets_checkers(Checkers& checkers) {
    checkers.emplace_back("aotgan_generator*", check_generator);
    checkers.emplace_back("aotgan_discriminator*", check_discriminator);
    checkers.emplace_back("aotgan_losses*", check_losses_or_training);
}

}  // namespace fastscene::golden

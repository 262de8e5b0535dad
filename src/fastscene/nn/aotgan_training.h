// Training of AOT-GAN (paper: "we retrain AOT-GAN on our synthesized dataset"): settings and examples in, a generator
// file out. The interface is free of libtorch.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "fastscene/base/random.h"
#include "fastscene/base/run.h"
#include "fastscene/image/image.h"
#include "fastscene/nn/training_params.h"

namespace fastscene {

struct AotganTrainingParams {
    int width = 64, blocks = 8;
    bool skips = false;
    std::string holes = "white";
    std::string start, vgg;
    double l1 = 1, l1_holes = 0, l2_holes = 0, psnr = 0, style = 250, perceptual = 0.1, pyramid = 1, adversarial = 0.01;
    int adversarial_from = 0;
    TrainingParams training{.clip = 0};
};
template <class V>
void visit_fields(AotganTrainingParams& p, V&& v) {
    v("width", p.width, Bounds{4, 256}, "Channels of the generator's first layer; the official network has 64.");
    v("blocks", p.blocks, Bounds{1, 32}, "Number of AOT blocks; the official network has 8.");
    v("skips", p.skips, "Add skip connections from encoder to decoder (the official network has none).");
    v("holes", p.holes, Choices{{"white", "harmonic"}},
      "Network input in holes: white, as published; or the harmonic fill, to which the network's output is added.");
    v("start", p.start,
      "Initial weights (G*.pt, .safetensors); a generator whose width divides --width is widened without changing its "
      "output. Empty: random.");
    v("vgg", p.vgg,
      "VGG19's weights (torchvision's vgg19-*.pth, .safetensors) for the style and perceptual loss; empty: --pyramid "
      "is used instead.");
    v("l1", p.l1, Bounds{0, 1e6}, "Weight of the L1 loss over all pixels.");
    v("l1-holes", p.l1_holes, Bounds{0, 1e6}, "Weight of the L1 loss in the holes; 0 as published.");
    v("l2-holes", p.l2_holes, Bounds{0, 1e6}, "Weight of the L2 loss in the holes; 0 as published.");
    v("psnr", p.psnr, Bounds{0, 1e6}, "Weight of the negative PSNR / 10 in each picture's holes; 0 as published.");
    v("style", p.style, Bounds{0, 1e6}, "Weight of the style loss.");
    v("perceptual", p.perceptual, Bounds{0, 1e6}, "Weight of the perceptual loss.");
    v("pyramid", p.pyramid, Bounds{0, 1e6}, "Without --vgg: weight of the L1 loss over a Laplacian pyramid.");
    v("adversarial", p.adversarial, Bounds{0, 1e6}, "Weight of the adversarial loss; 0: no discriminator.");
    v("adversarial-from", p.adversarial_from, Bounds{0, 2e9},
      "First step with the adversarial loss; before, the discriminator is only trained.");
    visit_fields(p.training, v);
}

struct InpaintExample {
    ImageRgb8 truth;    // sRGB; sides multiples of 8, all examples of one size
    ImageMask hole;     // nonzero = inpaint
    ImageColor filled;  // sRGB in 0..1, harmonic fill in the holes; empty if the network expects white there
};
struct InpaintExamples {
    std::function<InpaintExample(Random& rng)> draw;  // may be called on another thread
    std::vector<InpaintExample> held_out;             // validation examples
    Json about;                                       // must match for a training to be resumed
};

// Trains in `folder` (files: see nn/training.h), and writes the generator's EMA weights to generator.safetensors (f16),
// which the program can load. Throws what train() throws. Returns metrics on the held-out examples by name: "psnr" (dB,
// 8 bit, in the holes, mean over the examples), "psnr of the harmonic fill", "l1".
std::vector<std::pair<std::string, double>> train_aotgan(const AotganTrainingParams& params,
                                                         const InpaintExamples& examples,
                                                         const std::filesystem::path& folder, const Run& run);

}  // namespace fastscene

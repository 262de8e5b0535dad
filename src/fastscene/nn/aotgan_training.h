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
    v("width", p.width, Bounds{4, 256},
      "Channels of the generator's first layer; the official network has 64, a slim one fewer.");
    v("blocks", p.blocks, Bounds{1, 32}, "Blocks in the middle; the official network has 8.");
    v("skips", p.skips, "The decoder sees the encoder's maps of its own size too (the official network's does not).");
    v("holes", p.holes, Choices{{"white", "harmonic"}},
      "What the network finds in holes: white, as published, and it paints the picture; or the harmonic fill, and it "
      "paints what that lacks.");
    v("start", p.start,
      "Weights to begin from (G*.pt, .safetensors); those of a generator whose width divides --width are made wider "
      "without a change in what it paints. Empty: random ones.");
    v("vgg", p.vgg,
      "VGG19's weights (torchvision's vgg19-*.pth, .safetensors) for the style and the perceptual loss; empty: "
      "--pyramid stands in for them.");
    v("l1", p.l1, Bounds{0, 1e6}, "Weight of the mean absolute difference of all pixels.");
    v("l1-holes", p.l1_holes, Bounds{0, 1e6}, "Weight of that of the holes' pixels; 0 as published.");
    v("l2-holes", p.l2_holes, Bounds{0, 1e6}, "Weight of the mean square of their differences; 0 as published.");
    v("psnr", p.psnr, Bounds{0, 1e6},
      "Weight of the decibels lacking in each picture's holes (minus PSNR / 10); 0 as published.");
    v("style", p.style, Bounds{0, 1e6}, "Weight of the style loss.");
    v("perceptual", p.perceptual, Bounds{0, 1e6}, "Weight of the perceptual loss.");
    v("pyramid", p.pyramid, Bounds{0, 1e6},
      "Without --vgg: weight of the mean absolute differences of a Laplacian pyramid.");
    v("adversarial", p.adversarial, Bounds{0, 1e6}, "Weight of what the discriminator says; 0: there is none.");
    v("adversarial-from", p.adversarial_from, Bounds{0, 2e9},
      "The first step in which the discriminator is listened to; until then it only learns.");
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

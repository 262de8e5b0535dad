// Sampling loops of Diffusion360 (Feng et al. 2023; its repository where the report is silent): text to panorama
// latents, and tiled refinement of a finished panorama. Private to nn/ (torch).
#pragma once

#include <functional>
#include <optional>

#include "fastscene/nn/clip.h"
#include "fastscene/nn/replay.h"
#include "fastscene/nn/scheduler.h"
#include "fastscene/nn/tokenizer.h"
#include "fastscene/nn/unet.h"

namespace fastscene::nn {

struct PromptEmbedding {
    at::Tensor states;   // [1, chunks * 77 (one chunk) or chunks * 75 + 2, width], weighted, rescaled to keep the mean
    at::Tensor plain;    // the same without prompt weights
    double rescale = 1;  // the rescaling factor
};
PromptEmbedding embed_prompt(const Scope& s, const ClipTower& tower, const WeightedTokens& tokens);

// Called after every step, before the ends are blended: step index, timestep, latents.
using StepListener = std::function<void(int, double, const at::Tensor&)>;
// Standard normal noise of step i, shaped like its argument.
using NoiseSource = std::function<at::Tensor(int, const at::Tensor&)>;

enum class Seam {
    // the repository's text pipeline: the left columns become a copy of the right ones (reference behavior, for
    // comparison)
    published,
    closed,  // as in the report and its image pipeline: the latents are padded circularly and blended
};

// A ControlNet conditioned on a picture [1, channels, 8 H, 8 W] in [0, 1].
struct Control {
    Scope scope;
    UNetConfig config;
    at::Tensor picture;
    double strength = 1;
};

struct TextToPanorama {
    double guidance = 7.5;
    Seam seam = Seam::closed;
    std::int64_t blend_columns = 4;  // width in pixels / 8 / 32
    std::optional<Control> control;  // Diffusion360's outpainting of a photo
    bool noised =
        false;  // the latents already contain the first step's noise (from a photo) instead of being pure noise
    NoiseSource noise;
    StepListener listener;
    Listener first_outputs;    // receives the networks' outputs in the first step: "control", "unet"
    StepListener preview;      // receives the predicted clean latents, [1, 4, H, W]
    Replay* replay = nullptr;  // of the networks at these shapes and these weights, on a graphics card
};
// Samples on the text's device. With guidance 1 the negative prompt has no effect and is not computed. latents [1, 4,
// H, W] of unit variance (or noised); text [2, L, C]: negative prompt, prompt. -> [1, 4, H, W].
at::Tensor text_to_panorama(const Scope& s, const UNetConfig& config, Scheduler& scheduler, at::Tensor latents,
                            const at::Tensor& text, const TextToPanorama& how);

struct RefinePanorama {
    double guidance = 15, control = 1;
    std::int64_t tile = 96;  // in latent columns and rows; tiles overlap by half
    int first_step = 0;      // index into the scheduler's steps: strength 0.8 of 7 steps starts at 2
    std::int64_t batch = 0;  // tiles per network batch; 0 = a row of tiles, as published. Does not affect the result.
    StepListener listener;
    Listener first_outputs;    // receives the networks' outputs for the first tile: "control", "unet"
    Replay* replay = nullptr;  // as above
};
// Samples on the text's device. latents [1, 4, H, W] with the noise of first_step, picture [1, 3, 8 H, 8 W] in [0, 1]
// that conditions the ControlNet.
at::Tensor refine_panorama(const Scope& unet_scope, const UNetConfig& config, const Scope& control_scope,
                           const UNetConfig& control_config, const Scheduler& scheduler, at::Tensor latents,
                           const at::Tensor& picture, const at::Tensor& text, const RefinePanorama& how);

}  // namespace fastscene::nn

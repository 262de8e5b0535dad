// Diffusion360's loops (Feng et al. 2023; its repository where the report is silent): text to a panorama's latents, and
// a finished panorama made finer tile by tile. Private to nn/ (torch).
#pragma once

#include <functional>
#include <optional>

#include "fastscene/nn/clip.h"
#include "fastscene/nn/scheduler.h"
#include "fastscene/nn/tokenizer.h"
#include "fastscene/nn/unet.h"

namespace fastscene::nn {

struct PromptEmbedding {
    at::Tensor states;   // [1, chunks * 77 (one chunk) or chunks * 75 + 2, width], weighted, its mean kept
    at::Tensor plain;    // the same without weights
    double rescale = 1;  // what kept the mean
};
PromptEmbedding embed_prompt(const Scope& s, const ClipTower& tower, const WeightedTokens& tokens);

// Called after every step, before the ends are blended: step index, time step, latents.
using StepListener = std::function<void(int, double, const at::Tensor&)>;
// Unit normal noise of step i, shaped like its argument.
using NoiseSource = std::function<at::Tensor(int, const at::Tensor&)>;

enum class Seam {
    published,  // the repository's text path: the left columns become a copy of the right ones (reference behavior, for
                // comparison)
    closed,     // as the report and its image path have it: the latents are continued by their own left end, which then
                // blends in
};

// A ControlNet that holds on to a picture [1, channels, 8 H, 8 W] in [0, 1].
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
    std::optional<Control> control;  // Diffusion360's way from one photo
    bool noised =
        false;  // the latents have the first step's noise already (from a photo), instead of being nothing else
    NoiseSource noise;
    StepListener listener;
    Listener first_outputs;  // hears what the first step's networks put out: "control", "unet"
    StepListener preview;    // is given the clean latents that the step implies, [1, 4, H, W]
};
// With guidance 1 the negative prompt does not count, and is not computed.
// latents [1, 4, H, W] of unit variance (or noised); text [2, L, C]: negative prompt, prompt. -> [1, 4, H, W].
at::Tensor text_to_panorama(const Scope& s, const UNetConfig& config, Scheduler& scheduler, at::Tensor latents,
                            const at::Tensor& text, const TextToPanorama& how);

struct RefinePanorama {
    double guidance = 15, control = 1;
    std::int64_t tile = 96;  // in latent columns and rows; tiles overlap by half
    int first_step = 0;      // of the scheduler: strength 0.8 of 7 steps starts at 2
    std::int64_t batch =
        0;  // tiles that go through the network at once; 0 = a row of tiles, as published. The result is the same.
    StepListener listener;
    Listener first_outputs;  // hears what the first tile's networks put out: "control", "unet"
};
// latents [1, 4, H, W] with the noise of first_step, picture [1, 3, 8 H, 8 W] in [0, 1] that the ControlNet holds on
// to.
at::Tensor refine_panorama(const Scope& unet_scope, const UNetConfig& config, const Scope& control_scope,
                           const UNetConfig& control_config, const Scheduler& scheduler, at::Tensor latents,
                           const at::Tensor& picture, const at::Tensor& text, const RefinePanorama& how);

}  // namespace fastscene::nn

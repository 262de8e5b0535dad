// CLIP checkpoints in OpenAI's format (ViT-B-32.pt, ViT-L-14.pt): a single file whose tensor shapes determine the
// configuration. Private to nn/ (torch).
#pragma once

#include "fastscene/nn/clip.h"
#include "fastscene/weights/weights.h"

namespace fastscene::nn {

struct OpenAiClip {
    ClipConfig config;
    Weights weights;  // renamed to transformers' keys, as clip.h expects
};
// `weights`: the published TorchScript archive, or its state_dict. Assumes heads of width 64 and quick GELU, as in all
// of OpenAI's models. Throws Error naming the file, the tensor, expected and actual; also for ResNet image towers (RN50
// …).
OpenAiClip openai_clip(const Weights& weights);

}  // namespace fastscene::nn

// CLIP as OpenAI publishes it (ViT-B-32.pt, ViT-L-14.pt): one file of weights under OpenAI's names, from whose shapes
// follows what else there is to know. Private to nn/ (torch).
#pragma once

#include "fastscene/nn/clip.h"
#include "fastscene/nn/weights.h"

namespace fastscene::nn {

struct OpenAiClip {
    ClipConfig config;
    Weights weights;  // under transformers' names, as clip.h wants them
};
// `weights`: the TorchScript archive as published, or its state_dict. Heads are 64 wide and the activation is x
// sigmoid(1.702 x), as in all of OpenAI's; files of others with these names are read alike. Throws Error naming the
// file, the tensor, what was expected and found; so for a picture tower that is a ResNet (RN50 …).
OpenAiClip openai_clip(const Weights& weights);

}  // namespace fastscene::nn

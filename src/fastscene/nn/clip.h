// CLIP (Radford et al. 2021): embeds text and pictures as vectors whose angle measures how well they match. Stable
// Diffusion uses its text encoder. Keys as in transformers' CLIPModel and CLIPTextModel. Private to nn/ (torch).
#pragma once

#include <string>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/nn/scope.h"

namespace fastscene::nn {

struct ClipTower {
    std::int64_t width = 512, inner = 2048, layers = 12, heads = 8;
    bool quick_gelu = true;  // x sigmoid(1.702 x) instead of GELU
    double eps = 1e-5;
    std::int64_t vocabulary = 49408, positions = 77;  // text tower
    std::int64_t image_size = 224, patch = 32;        // image tower
};
// Parses one tower's object of config.json: a whole text_encoder/config.json, or text_config or vision_config of a
// CLIPModel. Omitted values get transformers' defaults, those of ViT-B/32, which differ between the towers. Throws
// Error naming `where`, the key, the expected and the actual value.
ClipTower clip_text_tower(const Json& json, const std::string& where);
ClipTower clip_vision_tower(const Json& json, const std::string& where);

// Both towers and their joint embedding space.
struct ClipConfig {
    ClipTower text, vision;
    std::int64_t dimension = 512;
};
// Parses a CLIPModel's config.json. Older files also have text_config_dict and vision_config_dict, which take
// precedence, as in transformers.
ClipConfig clip_config(const Json& json, const std::string& where);

struct ClipText {
    at::Tensor states;  // [N, L, width], after the final layer norm
    at::Tensor pooled;  // [N, width]: the state at the first end token (the largest token id)
};
// ids [N, L] int64, L <= positions. Causal attention; padding is not masked, as in training.
ClipText clip_text(const Scope& s, const ClipTower& tower, const at::Tensor& ids);
// pixels [N, 3, image_size, image_size], normalized -> [N, width] after the final layer norm.
at::Tensor clip_vision(const Scope& s, const ClipTower& tower, const at::Tensor& pixels);

// Projections into the joint space, not normalized: [N, dimension].
at::Tensor clip_text_features(const Scope& s, const ClipTower& tower, const at::Tensor& ids, std::int64_t dimension);
at::Tensor clip_image_features(const Scope& s, const ClipTower& tower, const at::Tensor& pixels,
                               std::int64_t dimension);

}  // namespace fastscene::nn

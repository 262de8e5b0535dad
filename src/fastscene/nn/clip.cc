#include "fastscene/nn/clip.h"

#include <limits>
#include <utility>

#include "fastscene/nn/config_fields.h"
#include "fastscene/nn/layers.h"

namespace fastscene::nn {

using at::Tensor;

namespace {

// Queries are the first `asked` tokens only; keys are all.
Tensor self_attention(const Scope& s, const Tensor& x, std::int64_t asked, const ClipTower& tower, const Tensor& mask) {
    const std::int64_t w = tower.width;
    const Tensor q = linear(s / "q_proj", x.narrow(1, 0, asked), w), k = linear(s / "k_proj", x, w),
                 v = linear(s / "v_proj", x, w);
    return linear(s / "out_proj", attention(q, k, v, tower.heads, mask), w);
}

Tensor perceptron(const Scope& s, const Tensor& x, const ClipTower& tower) {
    Tensor inner = linear(s / "fc1", x, tower.inner);
    return linear(s / "fc2", tower.quick_gelu ? quick_gelu(std::move(inner)) : at::gelu(inner), tower.width);
}

// `wanted`: the last layer computes only its first `wanted` tokens.
Tensor layers(const Scope& s, Tensor x, std::int64_t wanted, const ClipTower& tower, const Tensor& mask) {
    for (std::int64_t i = 0; i < tower.layers; ++i) {
        const Scope layer = s / "layers" / i;
        const std::int64_t asked = i + 1 == tower.layers ? wanted : x.size(1);
        x = x.narrow(1, 0, asked) +
            self_attention(layer / "self_attn", layer_norm(layer / "layer_norm1", x, tower.eps), asked, tower, mask);
        x = layer.out(x + perceptron(layer / "mlp", layer_norm(layer / "layer_norm2", x, tower.eps), tower));
    }
    return x;
}

// `t`: default values for what the file omits.
ClipTower tower_of(const Json& json, const std::string& where, ClipTower t) {
    const ConfigFields f(json, where);
    t.width = f.whole("hidden_size", t.width);
    t.inner = f.whole("intermediate_size", t.inner);
    t.layers = f.whole("num_hidden_layers", t.layers);
    t.heads = f.whole("num_attention_heads", t.heads);
    if (t.layers < 1) throw Error("{}: expected \"num_hidden_layers\" from 1, found {}", where, t.layers);
    if (t.width < 1 || t.heads < 1 || t.width % t.heads)
        throw Error("{}: expected \"hidden_size\" to divide among the heads, found {} among {}", where, t.width,
                    t.heads);
    const std::string act = f.text("hidden_act", "quick_gelu");
    if (act != "quick_gelu" && act != "gelu") throw f.wrong("hidden_act", "\"quick_gelu\" or \"gelu\"", act);
    t.quick_gelu = act == "quick_gelu";
    t.eps = f.number("layer_norm_eps", t.eps);
    t.vocabulary = f.whole("vocab_size", t.vocabulary);
    t.positions = f.whole("max_position_embeddings", t.positions);
    t.image_size = f.whole("image_size", t.image_size);
    t.patch = f.whole("patch_size", t.patch);
    if (t.patch < 1 || t.image_size < t.patch || t.image_size % t.patch)
        throw Error("{}: expected \"image_size\" to be a multiple of \"patch_size\", found {} and {}", where,
                    t.image_size, t.patch);
    return t;
}

// The tower's JSON object, overridden by the `…_dict` entry; empty if the file has neither.
Json tower_json(const ConfigFields& file, const std::string& key) {
    Json out = Json::object();
    for (const std::string& name : {key, key + "_dict"})
        if (const Json* part = file.find(name.c_str())) {
            if (!part->is_object()) throw file.wrong(name.c_str(), "an object", *part);
            for (const auto& [field, value] : part->items()) out[field] = value;
        }
    return out;
}

}  // namespace

ClipTower clip_text_tower(const Json& json, const std::string& where) { return tower_of(json, where, {}); }
ClipTower clip_vision_tower(const Json& json, const std::string& where) {
    return tower_of(json, where, {.width = 768, .inner = 3072, .layers = 12, .heads = 12});
}

ClipConfig clip_config(const Json& json, const std::string& where) {
    const ConfigFields f(json, where);
    const bool whole = f.text("model_type", "") == "clip";  // a text encoder alone may omit both towers
    const auto part = [&](const std::string& key) {
        Json tower = tower_json(f, key);
        if (tower.empty() && !whole) throw Error("{}: expected \"{}\" (a CLIPModel), found none", where, key);
        return tower;
    };
    return {clip_text_tower(part("text_config"), where + ": text_config"),
            clip_vision_tower(part("vision_config"), where + ": vision_config"), f.whole("projection_dim", 512)};
}

ClipText clip_text(const Scope& root, const ClipTower& tower, const Tensor& tokens) {
    const Scope s = root / "text_model";
    const std::int64_t length = tokens.size(1);
    const Tensor words = (s / "embeddings" / "token_embedding").parameter("weight", {tower.vocabulary, tower.width});
    const Tensor ids = tokens.to(words.device());
    const Tensor places = (s / "embeddings" / "position_embedding").parameter("weight", {tower.positions, tower.width});
    const Tensor x = (s / "embeddings").out(at::embedding(words, ids) + places.narrow(0, 0, length));
    const Tensor later = at::full({length, length}, -std::numeric_limits<float>::infinity(), x.options()).triu(1);
    const Tensor states = layer_norm(s / "final_layer_norm", layers(s / "encoder", x, length, tower, later), tower.eps);
    const Tensor end = ids.argmax(1).reshape({-1, 1, 1}).expand({ids.size(0), 1, tower.width});
    return {states, states.gather(1, end).squeeze(1)};
}

Tensor clip_vision(const Scope& root, const ClipTower& tower, const Tensor& pixels) {
    const Scope s = root / "vision_model", embeddings = s / "embeddings";
    const std::int64_t n = pixels.size(0), side = tower.image_size / tower.patch, count = side * side + 1;
    const Tensor patches = conv(embeddings / "patch_embedding", pixels, tower.width,
                                {tower.patch, tower.patch, 0, false})
                               .flatten(2)
                               .transpose(1, 2);
    const Tensor first = embeddings.parameter("class_embedding", {tower.width}).expand({n, 1, tower.width});
    const Tensor places = (embeddings / "position_embedding").parameter("weight", {count, tower.width});
    const Tensor x = layer_norm(s / "pre_layrnorm", at::cat({first, patches}, 1) + places,
                                tower.eps);  // "pre_layrnorm" [sic]: CLIP's own spelling
    const std::int64_t wanted =
        s.is_heard() ? count
                     : 1;  // the first token's state represents the picture; with a listener all tokens are computed
    return layer_norm(s / "post_layernorm", layers(s / "encoder", x, wanted, tower, {}).select(1, 0), tower.eps);
}

Tensor clip_text_features(const Scope& s, const ClipTower& tower, const Tensor& ids, std::int64_t dimension) {
    return linear(s / "text_projection", clip_text(s, tower, ids).pooled, dimension, false);
}
Tensor clip_image_features(const Scope& s, const ClipTower& tower, const Tensor& pixels, std::int64_t dimension) {
    return linear(s / "visual_projection", clip_vision(s, tower, pixels), dimension, false);
}

}  // namespace fastscene::nn

#include "fastscene/nn/clip_openai.h"

#include <cmath>
#include <cstring>

#include "fastscene/base/error.h"

namespace fastscene::nn {
namespace {

constexpr std::int64_t kHeadWidth = 64;

const WeightTensor& tensor_of_rank(const Weights& w, const std::string& name, std::size_t rank) {
    const WeightTensor& tensor = w.at(name);
    if (tensor.shape.size() != rank || tensor.count() < 1)
        throw Error("{}: {}: expected {} sides, found shape {}", w.path.string(), name, rank,
                    text_of_shape(tensor.shape));
    return tensor;
}

// Query, key and value projections are stacked in one matrix.
WeightTensor third_of(const Weights& w, const std::string& name, std::size_t rank, std::size_t which) {
    WeightTensor part = tensor_of_rank(w, name, rank);
    if (part.shape[0] % 3)
        throw Error("{}: {}: expected three parts of equal height, found shape {}", w.path.string(), name,
                    text_of_shape(part.shape));
    part.shape[0] /= 3;
    const std::size_t size = part.bytes.size() / 3;
    part.bytes = part.bytes.subspan(which * size, size);
    return part;
}

// OpenAI stores matrices for right multiplication.
WeightTensor transposed(const Weights& w, const std::string& name) {
    const WeightTensor& from = tensor_of_rank(w, name, 2);
    const auto rows = static_cast<std::size_t>(from.shape[0]), columns = static_cast<std::size_t>(from.shape[1]),
               size = bytes_of(from.type);
    auto bytes = std::make_shared<std::vector<std::byte>>(from.bytes.size());
    for (std::size_t y = 0; y < rows; ++y)
        for (std::size_t x = 0; x < columns; ++x)
            std::memcpy(bytes->data() + (x * rows + y) * size, from.bytes.data() + (y * columns + x) * size, size);
    return {from.type, {from.shape[1], from.shape[0]}, *bytes, bytes};
}

struct Renaming {
    const Weights& from;
    Weights& to;

    void move(const std::string& theirs, const std::string& ours) const { to.tensors[ours] = from.at(theirs); }
    void move_both(const std::string& theirs, const std::string& ours) const {
        for (const char* part : {".weight", ".bias"}) move(theirs + part, ours + part);
    }
    void layer(const std::string& theirs, const std::string& ours) const {
        move_both(theirs + ".ln_1", ours + ".layer_norm1");
        move_both(theirs + ".ln_2", ours + ".layer_norm2");
        move_both(theirs + ".mlp.c_fc", ours + ".mlp.fc1");
        move_both(theirs + ".mlp.c_proj", ours + ".mlp.fc2");
        move_both(theirs + ".attn.out_proj", ours + ".self_attn.out_proj");
        constexpr const char* names[] = {".self_attn.q_proj", ".self_attn.k_proj", ".self_attn.v_proj"};
        for (std::size_t i = 0; i < 3; ++i) {
            to.tensors[ours + names[i] + ".weight"] = third_of(from, theirs + ".attn.in_proj_weight", 2, i);
            to.tensors[ours + names[i] + ".bias"] = third_of(from, theirs + ".attn.in_proj_bias", 1, i);
        }
    }
};

std::int64_t layers_in(const Weights& w, const std::string& blocks) {
    std::int64_t count = 0;
    while (w.has(blocks + std::to_string(count) + ".ln_1.weight")) ++count;
    return count;
}

// What is derived in the same way for both towers: the width of the first MLP and the number of layers.
ClipTower tower_of(const Weights& w, const std::string& blocks, std::int64_t width) {
    const std::int64_t inner = tensor_of_rank(w, blocks + "0.mlp.c_fc.weight", 2).shape[0];
    if (width % kHeadWidth)
        throw Error("{}: expected a width of whole heads of {}, found {}", w.path.string(), kHeadWidth, width);
    return {.width = width, .inner = inner, .layers = layers_in(w, blocks), .heads = width / kHeadWidth};
}

constexpr const char* kTextBlocks = "transformer.resblocks.";
constexpr const char* kPictureBlocks = "visual.transformer.resblocks.";

ClipConfig config_of(const Weights& w) {
    const std::vector<std::int64_t>& words = tensor_of_rank(w, "token_embedding.weight", 2).shape;
    const std::vector<std::int64_t>& patches = tensor_of_rank(w, "visual.conv1.weight", 4).shape;
    ClipConfig out{tower_of(w, kTextBlocks, words[1]), tower_of(w, kPictureBlocks, patches[0]),
                   tensor_of_rank(w, "text_projection", 2).shape[1]};
    out.text.vocabulary = words[0];
    out.text.positions = tensor_of_rank(w, "positional_embedding", 2).shape[0];
    const std::int64_t places = tensor_of_rank(w, "visual.positional_embedding", 2).shape[0] - 1;
    const auto side = static_cast<std::int64_t>(std::lround(std::sqrt(static_cast<double>(places))));
    if (side < 1 || side * side != places)
        throw Error("{}: visual.positional_embedding: expected one place more than a square of patches, found {}",
                    w.path.string(), places + 1);
    out.vision.patch = patches[3];
    out.vision.image_size = side * patches[3];
    return out;
}

}  // namespace

OpenAiClip openai_clip(const Weights& weights) {
    const Weights w = unwrapped(weights, "token_embedding.weight");
    if (w.has("visual.layer1.0.conv1.weight"))
        throw Error("{}: expected CLIP with a vision transformer (ViT-B-32.pt, ViT-L-14.pt), found one with a ResNet",
                    w.path.string());
    OpenAiClip out{config_of(w), {w.path, {}, {}, {}}};
    const Renaming names{w, out.weights};
    names.move("token_embedding.weight", "text_model.embeddings.token_embedding.weight");
    names.move("positional_embedding", "text_model.embeddings.position_embedding.weight");
    names.move_both("ln_final", "text_model.final_layer_norm");
    names.move("visual.class_embedding", "vision_model.embeddings.class_embedding");
    names.move("visual.conv1.weight", "vision_model.embeddings.patch_embedding.weight");
    names.move("visual.positional_embedding", "vision_model.embeddings.position_embedding.weight");
    names.move_both("visual.ln_pre", "vision_model.pre_layrnorm");
    names.move_both("visual.ln_post", "vision_model.post_layernorm");
    out.weights.tensors["text_projection.weight"] = transposed(w, "text_projection");
    out.weights.tensors["visual_projection.weight"] = transposed(w, "visual.proj");
    for (std::int64_t i = 0; i < out.config.text.layers; ++i)
        names.layer(kTextBlocks + std::to_string(i), "text_model.encoder.layers." + std::to_string(i));
    for (std::int64_t i = 0; i < out.config.vision.layers; ++i)
        names.layer(kPictureBlocks + std::to_string(i), "vision_model.encoder.layers." + std::to_string(i));
    return out;
}

}  // namespace fastscene::nn

#include "fastscene/nn/file_weights.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <set>

#include "fastscene/base/error.h"
#include "fastscene/base/json.h"
#include "fastscene/nn/weights_torch.h"

namespace fastscene::nn {

namespace fs = std::filesystem;

namespace {

// The shards listed in an index.
std::vector<fs::path> parts_of(const fs::path& index) {
    const Json json = read_json(index);
    if (!json.contains("weight_map") || !json["weight_map"].is_object())
        throw Error("{}: expected \"weight_map\", found none", index.string());
    std::set<fs::path> parts;
    for (const auto& [key, part] : json["weight_map"].items()) {
        if (!part.is_string() || fs::path(part.get<std::string>()).has_parent_path())
            throw Error("{}: expected file names in \"weight_map\", found {}", index.string(), part.dump());
        parts.insert(index.parent_path() / part.get<std::string>());
    }
    for (const fs::path& part : parts)
        if (!fs::exists(part))
            throw Error("{}: expected the part {} that the index names, found none", index.string(),
                        part.filename().string());
    return {parts.begin(), parts.end()};
}

// Weight files in a component's folder, by the names that diffusers and transformers use.
std::vector<fs::path> files_of(const fs::path& component) {
    if (!fs::exists(component)) throw Error("{}: expected a model's folder or file, found none", component.string());
    if (!fs::is_directory(component)) return {component};
    using Stems = std::array<std::string, 2>;
    for (const auto& [ending, stems] : {std::pair{".safetensors", Stems{"diffusion_pytorch_model", "model"}},
                                        std::pair{".bin", Stems{"diffusion_pytorch_model", "pytorch_model"}}})
        for (const std::string variant : {"", ".fp16"})
            for (const std::string& stem : stems) {
                if (const fs::path whole = component / (stem + variant + ending); fs::exists(whole)) return {whole};
                // diffusers inserts the variant after "index", other programs before the extension.
                for (const std::string& index :
                     {stem + ending + ".index" + variant + ".json", stem + variant + ending + ".index.json"})
                    if (fs::exists(component / index)) return parts_of(component / index);
            }
    throw Error("{}: expected diffusion_pytorch_model or model (.safetensors or .bin), found neither",
                component.string());
}

// Older names of the VAE's attention layers.
std::string older_name(std::string key) {
    for (const auto& [now, then] :
         {std::pair{".to_q.", ".query."}, {".to_k.", ".key."}, {".to_v.", ".value."}, {".to_out.0.", ".proj_attn."}})
        if (const std::size_t at = key.find(now); at != std::string::npos)
            return key.replace(at, std::strlen(now), then);
    return key;
}

}  // namespace

FileWeights::FileWeights(const fs::path& component, at::TensorOptions options, bool keep, std::string_view expected)
    : component_(component), options_(options), keep_(keep) {
    for (const fs::path& file : files_of(component)) parts_.push_back(load_weights(file));
    if (parts_.size() == 1 && !expected.empty()) parts_[0] = unwrapped(std::move(parts_[0]), expected);
}

std::unique_ptr<FileWeights> FileWeights::in_type(at::ScalarType type) const {
    auto out = std::make_unique<FileWeights>(*this);
    out->options_ = options_.dtype(type);
    out->ready_.clear();
    return out;
}

const WeightTensor* FileWeights::find(const std::string& key) const {
    for (const std::string& name : {key, older_name(key)})
        for (const Weights& part : parts_)
            if (const auto found = part.tensors.find(name); found != part.tensors.end()) return &found->second;
    return nullptr;
}

void FileWeights::expect_none_beyond(const std::set<std::string>& asked, const std::vector<std::string>& parts) const {
    std::set<std::string> known = asked;
    for (const std::string& key : asked) known.insert(older_name(key));
    std::size_t count = 0;
    std::string first;
    for (const Weights& part : parts_)
        for (const auto& [key, tensor] : part.tensors) {
            const bool is_layer = std::any_of(parts.begin(), parts.end(),
                                              [&](const std::string& begin) { return key.starts_with(begin); });
            if (is_layer && !known.contains(key) && count++ == 0) first = key;
        }
    if (count > 0)
        throw Error(
            "{}: expected the layers that config.json tells of, found {} tensors of others, such as {} (another "
            "model's config.json?)",
            component_.string(), count, first);
}

std::vector<fs::path> FileWeights::files() const {
    std::vector<fs::path> out;
    for (const Weights& part : parts_) out.push_back(part.path);
    return out;
}

std::vector<std::int64_t> FileWeights::shape_of(const std::string& key) const {
    const WeightTensor* tensor = find(key);
    return tensor ? tensor->shape : std::vector<std::int64_t>{};
}

std::int64_t FileWeights::bytes() const {
    std::int64_t sum = 0;
    for (const Weights& part : parts_)
        for (const auto& [key, tensor] : part.tensors)
            sum += tensor.count() * static_cast<std::int64_t>(options_.dtype().itemsize());
    return sum;
}

std::int64_t FileWeights::largest_bytes() const {
    std::int64_t most = 0;
    for (const Weights& part : parts_)
        for (const auto& [key, tensor] : part.tensors)
            most = std::max(most, tensor.count() * static_cast<std::int64_t>(options_.dtype().itemsize()));
    return most;
}

std::int64_t FileWeights::kept_bytes() const {
    std::int64_t sum = 0;
    for (const auto& [key, tensor] : ready_) sum += static_cast<std::int64_t>(tensor.nbytes());
    return sum;
}

const WeightTensor& FileWeights::checked(const std::string& key, at::IntArrayRef shape) const {
    const WeightTensor* tensor = find(key);
    if (!tensor) {
        if (parts_.size() == 1) parts_[0].at(key);  // throws, suggesting similar names
        throw Error("{}: expected the tensor \"{}\" {}, found none", component_.string(), key,
                    text_of_shape(shape.vec()));
    }
    // Old VAEs store 1 x 1 convolutions in place of matrices.
    const at::IntArrayRef found(tensor->shape);
    const bool fits = found == shape || (found.size() == shape.size() + 2 && found.slice(0, shape.size()) == shape &&
                                         found[shape.size()] == 1 && found.back() == 1);
    if (!fits)
        throw Error("{}: {}: expected shape {}, found {}", component_.string(), key, text_of_shape(shape.vec()),
                    text_of_shape(tensor->shape));
    return *tensor;
}

at::Tensor FileWeights::get(const std::string& key, at::IntArrayRef shape) {
    const auto ready = ready_.find(key);
    if (ready != ready_.end()) return ready->second;
    const at::Tensor tensor = placed(tensor_of(checked(key, shape)).reshape(shape), options_);
    if (keep_) ready_[key] = tensor;
    return tensor;
}

}  // namespace fastscene::nn

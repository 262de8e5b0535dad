// Weights of a network as they lie in a file: named tensors, not yet of any library. Read: .safetensors, and what
// torch.save writes
// (.pt .pth .pkl .ckpt .bin: the zip of PyTorch 1.6 and later, and the older form). Nothing in a file is ever executed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fastscene {

enum class NumberType { f64, f32, f16, bf16, i64, i32, i16, i8, u8, boolean };
std::string_view name_of(NumberType type);  // as safetensors calls it: "F32", "BF16", "BOOL" …
std::size_t bytes_of(NumberType type);      // of one number
std::string text_of_shape(const std::vector<std::int64_t>& shape);  // "[64, 4, 7, 7]"

// Elements in C order, little endian. The bytes belong to `owner` (a mapped file, or memory) and need not be aligned.
struct WeightTensor {
    NumberType type = NumberType::f32;
    std::vector<std::int64_t> shape;
    std::span<const std::byte> bytes;
    std::shared_ptr<const void> owner;

    std::int64_t count() const;
    // As float32, whatever the type.
    std::vector<float> floats() const;
};

struct Weights {
    std::filesystem::path path;                   // for messages
    std::map<std::string, WeightTensor> tensors;  // by name; nested dictionaries joined with "."
    std::map<std::string, std::string> metadata;  // of safetensors: "__metadata__"
    std::map<std::string, double> numbers;        // loose numbers of a pickle ("epoch", "optimizer.param_groups.0.lr")

    // Throws Error naming the file, the key, and the nearest names that are there.
    const WeightTensor& at(const std::string& name) const;
    bool has(const std::string& name) const { return tensors.contains(name); }
    // The part below a dictionary's name, without that name: of_part("netG"). Throws Error when there is none.
    Weights of_part(std::string_view name) const;
};

// Chooses by the file's first bytes. Throws Error naming the file, the offset where it stops making sense, what was
// expected and found.
Weights load_weights(const std::filesystem::path& path);

// What data-parallel training puts before every name ("module.encoder.1.weight") goes away, and so does one dictionary
// around everything that carries a customary name (state_dict, params_ema, model, netG, generator …) when a tensor
// `expected` is found inside of it. Without a match the weights come back as they are.
Weights unwrapped(Weights weights, std::string_view expected);

}  // namespace fastscene

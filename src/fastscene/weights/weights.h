// Weights of a network as stored in a file: named tensors, independent of any library. Formats: .safetensors, and
// torch.save (.pt .pth .pkl .ckpt .bin: the zip of PyTorch 1.6 and later, and the legacy format). Nothing in a file is
// ever executed.
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
std::string_view name_of(NumberType type);                          // safetensors' names: "F32", "BF16", "BOOL" …
std::size_t bytes_of(NumberType type);                              // of one element
std::string text_of_shape(const std::vector<std::int64_t>& shape);  // "[64, 4, 7, 7]"

// Elements in C order, little endian. The bytes belong to `owner` (a mapped file, or memory) and may be unaligned.
struct WeightTensor {
    NumberType type = NumberType::f32;
    std::vector<std::int64_t> shape;
    std::span<const std::byte> bytes;
    std::shared_ptr<const void> owner;

    std::int64_t count() const;
    // Converted to float32 from any type.
    std::vector<float> floats() const;
};

struct Weights {
    std::filesystem::path path;                   // for messages
    std::map<std::string, WeightTensor> tensors;  // by name; nested dictionaries joined with "."
    std::map<std::string, std::string> metadata;  // "__metadata__" of a safetensors file
    std::map<std::string, double> numbers;        // plain numbers of a pickle ("epoch", "optimizer.param_groups.0.lr")

    // Throws Error naming the file, the key, and similar existing names.
    const WeightTensor& at(const std::string& name) const;
    bool has(const std::string& name) const { return tensors.contains(name); }
    // The contents of a nested dictionary, without its prefix: of_part("netG"). Throws Error if there is none.
    Weights of_part(std::string_view name) const;
};

// Recognizes the format by its first bytes. Throws Error naming the file, the offset of the problem, expected and
// actual.
Weights load_weights(const std::filesystem::path& path);

// Removes the prefix added by data-parallel training ("module.encoder.1.weight"), and an enclosing dictionary with a
// customary name (state_dict, params_ema, model, netG, generator …) if the tensor `expected` is found inside. Otherwise
// returns the weights unchanged.
Weights unwrapped(Weights weights, std::string_view expected);

}  // namespace fastscene

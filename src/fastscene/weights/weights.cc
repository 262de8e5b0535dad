#include "fastscene/weights/weights.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <numeric>

#include <fmt/ranges.h>

#include "fastscene/base/error.h"
#include "fastscene/math/half.h"
#include "fastscene/weights/mapped_file.h"
#include "fastscene/weights/pickle.h"
#include "fastscene/weights/safetensors.h"

namespace fastscene {
namespace {

static_assert(std::endian::native == std::endian::little, "weights are read as they lie in the file");

struct TypeInfo {
    std::string_view name;
    std::size_t bytes;
};
constexpr TypeInfo kTypes[] = {{"F64", 8}, {"F32", 4}, {"F16", 2}, {"BF16", 2}, {"I64", 8},
                               {"I32", 4}, {"I16", 2}, {"I8", 1},  {"U8", 1},   {"BOOL", 1}};

template <class T, class Convert>
void convert(std::span<const std::byte> bytes, std::vector<float>& out, Convert&& to_float) {
    for (std::size_t i = 0; i < out.size(); ++i) {
        T value;
        std::memcpy(&value, bytes.data() + i * sizeof(T), sizeof(T));
        out[i] = to_float(value);
    }
}

// Existing names that share the longest prefix or suffix with a missing one, for error messages.
std::string neighbours(const std::map<std::string, WeightTensor>& tensors, const std::string& name) {
    std::vector<std::pair<std::size_t, std::string>> scored;
    for (const auto& [other, tensor] : tensors) {
        const auto [a, b] = std::mismatch(name.begin(), name.end(), other.begin(), other.end());
        const auto [c, d] = std::mismatch(name.rbegin(), name.rend(), other.rbegin(), other.rend());
        scored.emplace_back(static_cast<std::size_t>((a - name.begin()) + (c - name.rbegin())), other);
    }
    std::stable_sort(scored.begin(), scored.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<std::string> best;
    for (std::size_t i = 0; i < std::min<std::size_t>(3, scored.size()); ++i) best.push_back(scored[i].second);
    return best.empty() ? "no tensor at all"
                        : fmt::format("{} others such as {}", tensors.size(), fmt::join(best, ", "));
}

}  // namespace

std::string_view name_of(NumberType type) { return kTypes[static_cast<std::size_t>(type)].name; }
std::size_t bytes_of(NumberType type) { return kTypes[static_cast<std::size_t>(type)].bytes; }
std::string text_of_shape(const std::vector<std::int64_t>& shape) {
    return fmt::format("[{}]", fmt::join(shape, ", "));
}

std::int64_t WeightTensor::count() const {
    return std::accumulate(shape.begin(), shape.end(), std::int64_t{1}, std::multiplies<>());
}

std::vector<float> WeightTensor::floats() const {
    std::vector<float> out(static_cast<std::size_t>(count()));
    const auto cast = [](auto v) { return static_cast<float>(v); };
    switch (type) {
        case NumberType::f64: convert<double>(bytes, out, cast); break;
        case NumberType::f32: convert<float>(bytes, out, cast); break;
        case NumberType::f16: convert<std::uint16_t>(bytes, out, float_from_half); break;
        case NumberType::bf16: convert<std::uint16_t>(bytes, out, float_from_bfloat); break;
        case NumberType::i64: convert<std::int64_t>(bytes, out, cast); break;
        case NumberType::i32: convert<std::int32_t>(bytes, out, cast); break;
        case NumberType::i16: convert<std::int16_t>(bytes, out, cast); break;
        case NumberType::i8: convert<std::int8_t>(bytes, out, cast); break;
        case NumberType::u8:
        case NumberType::boolean: convert<std::uint8_t>(bytes, out, cast); break;
    }
    return out;
}

const WeightTensor& Weights::at(const std::string& name) const {
    const auto found = tensors.find(name);
    if (found == tensors.end())
        throw Error("{}: expected the tensor \"{}\", found {}", path.string(), name, neighbours(tensors, name));
    return found->second;
}

Weights Weights::of_part(std::string_view name) const {
    const std::string prefix = std::string(name) + ".";
    Weights part{path, {}, metadata, {}};
    for (const auto& [key, tensor] : tensors)
        if (key.starts_with(prefix)) part.tensors[key.substr(prefix.size())] = tensor;
    for (const auto& [key, number] : numbers)
        if (key.starts_with(prefix)) part.numbers[key.substr(prefix.size())] = number;
    if (part.tensors.empty())
        throw Error("{}: expected a dictionary \"{}\", found {}", path.string(), name, neighbours(tensors, prefix));
    return part;
}

Weights load_weights(const std::filesystem::path& path) {
    const auto file = std::make_shared<const MappedFile>(path);
    const std::string_view text = file->text();
    if (text.starts_with("PK\x03\x04") || text.starts_with("PK\x05\x06")) return load_torch_zip(file);
    if (text.size() > 2 && text[0] == '\x80' && static_cast<unsigned char>(text[1]) <= 5)
        return load_torch_legacy(file);
    // safetensors: a header length below 2^32, then "{".
    if (text.size() > 8 && text[8] == '{') return load_safetensors(file);
    if (text.starts_with("version https://git-lfs.github.com/"))
        throw Error(
            "{}: expected weights, found a pointer of Git LFS that stands for them ({} bytes): fetch the file itself "
            "(git lfs pull, or download it)",
            path.string(), text.size());
    if (text.starts_with("<!") || text.starts_with("<html"))
        throw Error("{}: expected weights, found a web page: was the download refused?", path.string());
    throw Error("{}: expected weights (.safetensors, or a file of torch.save), found {} bytes that begin otherwise",
                path.string(), text.size());
}

Weights unwrapped(Weights weights, std::string_view expected) {
    const std::string name(expected);
    // EMA weights first, if a file holds both; including names from multi-GPU training, wrapped once or twice.
    for (const char* dictionary : {"", "params_ema.", "ema.", "g_ema.", "netG_ema.", "state_dict.", "model_state_dict.",
                                   "params.", "model.", "netG.", "generator.", "G.", "net.", "weights."})
        for (const char* module : {"", "module.", "module.module."}) {
            const std::string prefix = std::string(dictionary) + module;
            if (weights.has(prefix + name))
                return prefix.empty() ? weights : weights.of_part(prefix.substr(0, prefix.size() - 1));
        }
    return weights;
}

}  // namespace fastscene

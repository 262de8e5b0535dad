#include "fastscene/weights/safetensors.h"

#include <algorithm>
#include <cstring>
#include <optional>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/json.h"
#include "fastscene/math/half.h"

namespace fastscene {
namespace {

constexpr std::uint64_t kLargestHeader = std::uint64_t{100} << 20;  // the reference implementation's limit

std::optional<NumberType> type_named(std::string_view name) {
    for (int i = 0; i <= static_cast<int>(NumberType::boolean); ++i)
        if (name_of(static_cast<NumberType>(i)) == name) return static_cast<NumberType>(i);
    return std::nullopt;
}

// Byte size of a tensor of this shape; none if it exceeds any memory.
std::optional<std::uint64_t> bytes_of_shape(const std::vector<std::int64_t>& shape, NumberType type) {
    std::uint64_t bytes = bytes_of(type);
    for (const std::int64_t side : shape)
        if (side < 0 || __builtin_mul_overflow(bytes, static_cast<std::uint64_t>(side), &bytes)) return std::nullopt;
    return bytes;
}

WeightTensor tensor_of(const Json& entry, const std::string& key, const std::shared_ptr<const MappedFile>& file,
                       std::size_t base) {
    const std::string where = file->path().string() + ": " + key;
    WeightTensor tensor;
    std::uint64_t begin = 0, end = 0;
    try {
        const std::string dtype = entry.at("dtype");
        const auto type = type_named(dtype);
        if (!type) throw Error("{}: expected a known number type, found \"{}\"", where, dtype);
        tensor.type = *type;
        if (entry.at("data_offsets").size() != 2)
            throw Error("{}: expected two data_offsets, found {}", where, entry["data_offsets"].size());
        for (const Json& side : entry.at("shape"))
            if (!side.is_number_integer())
                throw Error("{}: expected whole numbers as shape, found {}", where, entry["shape"].dump());
        for (const Json& offset : entry.at("data_offsets"))
            if (!offset.is_number_unsigned())
                throw Error("{}: expected whole numbers as data_offsets, found {}", where,
                            entry["data_offsets"].dump());
        tensor.shape = entry.at("shape").get<std::vector<std::int64_t>>();
        begin = entry["data_offsets"][0].get<std::uint64_t>();
        end = entry["data_offsets"][1].get<std::uint64_t>();
    } catch (const nlohmann::json::exception&) {
        throw Error("{}: expected dtype, shape and data_offsets, found {}", where,
                    entry.dump(-1, ' ', false, Json::error_handler_t::replace).substr(0, 120));
    }
    const auto bytes = bytes_of_shape(tensor.shape, tensor.type);
    const std::uint64_t payload = file->bytes().size() - base;
    if (end > payload || begin > end)
        throw Error("{}: expected offsets within {} bytes of data, found {} to {} (cut off?)", where, payload, begin,
                    end);
    if (!bytes || end - begin != *bytes)
        throw Error("{}: expected the bytes of {} {}, found {} bytes", where, name_of(tensor.type),
                    text_of_shape(tensor.shape), end - begin);
    tensor.bytes = file->bytes().subspan(base + begin, *bytes);
    tensor.owner = file;
    return tensor;
}

bool is_floating(NumberType type) { return type <= NumberType::bf16; }
NumberType saved_type(NumberType type, SaveAs as) {
    if (as == SaveAs::unchanged || !is_floating(type)) return type;
    return as == SaveAs::f32 ? NumberType::f32 : as == SaveAs::f16 ? NumberType::f16 : NumberType::bf16;
}

// The bytes to write; conversions are stored in `kept`.
std::string_view saved_bytes(const WeightTensor& tensor, NumberType type, std::string& kept) {
    if (type == tensor.type) return {reinterpret_cast<const char*>(tensor.bytes.data()), tensor.bytes.size()};
    kept.clear();
    for (const float value : tensor.floats()) {
        const std::uint16_t half = type == NumberType::f16 ? half_from_float(value) : bfloat_from_float(value);
        kept.append(
            type == NumberType::f32 ? reinterpret_cast<const char*>(&value) : reinterpret_cast<const char*>(&half),
            bytes_of(type));
    }
    return kept;
}

}  // namespace

Weights load_safetensors(std::shared_ptr<const MappedFile> file) {
    const std::string path = file->path().string();
    const std::string_view text = file->text();
    std::uint64_t length = 0;
    if (text.size() >= 8) std::memcpy(&length, text.data(), 8);
    if (text.size() < 8 || length < 2 || length > kLargestHeader || length > text.size() - 8)
        throw Error("{}: expected a safetensors header, found {} bytes that announce one of {}", path, text.size(),
                    length);
    const std::string_view header = text.substr(8, length);
    Json json;
    try {
        json = Json::parse(header);
    } catch (const nlohmann::json::exception& e) {
        throw Error("{}: expected a JSON header, found: {}", path, e.what());
    }
    if (!json.is_object()) throw Error("{}: expected a JSON object as header, found {}", path, json.type_name());
    Weights out{file->path(), {}, {}, {}};
    for (const auto& [key, entry] : json.items()) {
        if (key != "__metadata__") {
            out.tensors[key] = tensor_of(entry, key, file, 8 + length);
            continue;
        }
        if (!entry.is_object()) throw Error("{}: expected texts as __metadata__, found {}", path, entry.type_name());
        for (const auto& [name, value] : entry.items())
            if (value.is_string()) out.metadata[name] = value.get<std::string>();
    }
    return out;
}

void save_safetensors(const std::filesystem::path& path, const Weights& weights, SaveAs as) {
    // Wide types first: keeps every tensor aligned without padding, which the format forbids.
    std::vector<const std::pair<const std::string, WeightTensor>*> order;
    for (const auto& entry : weights.tensors) order.push_back(&entry);
    const auto width = [&](const auto* entry) { return bytes_of(saved_type(entry->second.type, as)); };
    std::stable_sort(order.begin(), order.end(), [&](const auto* a, const auto* b) { return width(a) > width(b); });
    Json header = Json::object();
    if (!weights.metadata.empty()) header["__metadata__"] = weights.metadata;
    std::size_t end = 0;
    for (const auto* entry : order) {
        const auto& [key, tensor] = *entry;
        const NumberType type = saved_type(tensor.type, as);
        const std::size_t begin = end;
        end += static_cast<std::size_t>(tensor.count()) * bytes_of(type);
        header[key] = {{"dtype", name_of(type)}, {"shape", tensor.shape}, {"data_offsets", {begin, end}}};
    }
    std::string text = header.dump();
    text.resize((text.size() + 7) / 8 * 8, ' ');
    const std::uint64_t length = text.size();
    write_pieces(path, [&](const auto& put) {
        put({reinterpret_cast<const char*>(&length), 8});
        put(text);
        std::string kept;
        for (const auto* entry : order) put(saved_bytes(entry->second, saved_type(entry->second.type, as), kept));
    });
}

}  // namespace fastscene

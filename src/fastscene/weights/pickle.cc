#include "fastscene/weights/pickle.h"

#include <cstring>
#include <map>
#include <optional>

#include "fastscene/base/error.h"
#include "fastscene/weights/pickle_machine.h"
#include "fastscene/weights/zip_directory.h"

namespace fastscene {
namespace {

using pickle::Value;

constexpr int kDeepest = 16;  // maximum nesting of dictionaries
constexpr std::size_t kMostVisits = 1 << 22;
constexpr std::size_t kMostNumbers = 1 << 16;  // maximum count of plain numbers: a long loss history is not needed
constexpr std::size_t kMostTensors = 1 << 17;  // maximum count; one tensor may have several names
constexpr std::size_t kLongestName = 1024;

std::optional<NumberType> type_of_storage(std::string_view name) {
    static const std::map<std::string_view, NumberType> types{
        {"DoubleStorage", NumberType::f64},    {"FloatStorage", NumberType::f32}, {"HalfStorage", NumberType::f16},
        {"BFloat16Storage", NumberType::bf16}, {"LongStorage", NumberType::i64},  {"IntStorage", NumberType::i32},
        {"ShortStorage", NumberType::i16},     {"CharStorage", NumberType::i8},   {"ByteStorage", NumberType::u8},
        {"BoolStorage", NumberType::boolean}};
    const auto found = types.find(name);
    return found == types.end() ? std::nullopt : std::optional(found->second);
}

// The bytes of a storage, by its key.
struct StorageBytes {
    std::span<const std::byte> bytes;
    std::shared_ptr<const void> owner;
};
using Storages = std::map<std::string, StorageBytes>;

bool is_c_order(const pickle::Tensor& tensor) {
    std::int64_t step = 1;
    for (std::size_t i = tensor.shape.size(); i-- > 0;) {
        if (tensor.shape[i] != 1 && tensor.stride[i] != step) return false;
        step *= tensor.shape[i];
    }
    return true;
}

// Copies a transposed or otherwise strided tensor into C order.
std::shared_ptr<std::vector<std::byte>> gathered(const pickle::Tensor& tensor, std::span<const std::byte> from,
                                                 std::size_t size, std::int64_t count) {
    auto out = std::make_shared<std::vector<std::byte>>(static_cast<std::size_t>(count) * size);
    std::vector<std::int64_t> index(tensor.shape.size(), 0);
    for (std::int64_t i = 0; i < count; ++i) {
        std::int64_t at = 0;
        for (std::size_t d = 0; d < index.size(); ++d) at += index[d] * tensor.stride[d];
        std::memcpy(out->data() + static_cast<std::size_t>(i) * size, from.data() + static_cast<std::size_t>(at) * size,
                    size);
        for (std::size_t d = index.size(); d-- > 0;) {
            if (++index[d] < tensor.shape[d]) break;
            index[d] = 0;
        }
    }
    return out;
}

class Collector {
  public:
    Collector(Weights& out, const Storages& storages) : out_(out), storages_(storages) {
        for (const auto& [key, storage] : storages) total_ += storage.bytes.size();
    }

    void collect(const Value& value, const std::string& name, int depth) {
        if (++visited_ > kMostVisits)
            throw Error("{}: expected a checkpoint, found more than {} values in it", out_.path.string(), kMostVisits);
        if (depth > kDeepest || name.size() > kLongestName) return;
        if (const auto* tensor = value.as<pickle::Tensor>()) return add(*tensor, name);
        if (out_.numbers.size() < kMostNumbers) {
            if (const auto* number = value.as<double>()) out_.numbers[name] = *number;
            if (const auto* number = value.as<std::int64_t>()) out_.numbers[name] = static_cast<double>(*number);
        }
        const auto* module = value.as<pickle::Module>();
        const Value& attributes = module && module->state ? *module->state : value;
        if (const auto* dictionary = attributes.as<pickle::Dictionary>())
            for (const auto& [key, item] : dictionary->items) collect(*item, joined(name, *key), depth + 1);
        if (const auto* list = value.as<pickle::Sequence>())
            for (std::size_t i = 0; i < list->items.size(); ++i)
                collect(*list->items[i], joined(name, std::to_string(i)), depth + 1);
    }

  private:
    static std::string joined(const std::string& name, const std::string& key) {
        return name.empty() ? key : name + "." + key;
    }
    static std::string joined(const std::string& name, const Value& key) {
        if (const auto* text = key.as<pickle::Text>()) return joined(name, std::string(text->bytes));
        if (const auto* number = key.as<std::int64_t>()) return joined(name, std::to_string(*number));
        return joined(name, std::string("?"));
    }
    [[noreturn]] void fail(const std::string& name, const std::string& what) const {
        throw Error("{}: {}: {}", out_.path.string(), name, what);
    }

    void add(const pickle::Tensor& tensor, const std::string& name) {
        const auto type = type_of_storage(tensor.storage.dtype);
        if (!type) return;  // complex and quantized types: not used by any of our networks
        if (out_.tensors.size() >= kMostTensors)
            throw Error("{}: expected a checkpoint, found more than {} tensors in it", out_.path.string(),
                        kMostTensors);
        const auto found = storages_.find(tensor.storage.key);
        if (found == storages_.end())
            fail(name, fmt::format("expected the storage \"{}\", found none", tensor.storage.key));
        const std::size_t size = bytes_of(*type);
        if (tensor.stride.size() != tensor.shape.size())
            fail(name, fmt::format("expected as many strides as sides, found {} and {}", tensor.stride.size(),
                                   tensor.shape.size()));

        // The last element must lie within the storage; computed without overflow.
        const auto have = static_cast<std::int64_t>(found->second.bytes.size() / size);
        __int128 count = 1, last = static_cast<__int128>(tensor.offset) + static_cast<__int128>(tensor.storage.offset);
        const bool begins_inside = tensor.offset >= 0 && last <= have;
        bool good = begins_inside;
        for (std::size_t i = 0; good && i < tensor.shape.size(); ++i) {
            good = tensor.shape[i] >= 0 && tensor.stride[i] >= 0;
            count *= tensor.shape[i];
            good = good && count <= have;
            if (tensor.shape[i] > 0) last += static_cast<__int128>(tensor.shape[i] - 1) * tensor.stride[i];
        }
        if (!good || (count > 0 && last >= have))
            fail(name, fmt::format("expected a tensor within its storage of {} numbers, found {} strides {} from {}",
                                   have, text_of_shape(tensor.shape), text_of_shape(tensor.stride), tensor.offset));

        const auto numbers = static_cast<std::int64_t>(count);
        const auto from = found->second.bytes.subspan(
            static_cast<std::size_t>(tensor.offset + static_cast<std::int64_t>(tensor.storage.offset)) * size);
        if (numbers == 0 || is_c_order(tensor)) {
            out_.tensors[name] = {*type, tensor.shape, from.first(static_cast<std::size_t>(numbers) * size),
                                  found->second.owner};
            return;
        }
        // Each such tensor takes memory of its own: limit the total, so that thousands of them cannot refer to one
        // storage.
        gathered_ += static_cast<std::size_t>(numbers) * size;
        if (gathered_ > 4 * total_) fail(name, "expected a checkpoint, found one storage spread over and over");
        const auto bytes = gathered(tensor, from, size, numbers);
        out_.tensors[name] = {*type, tensor.shape, *bytes, bytes};
    }

    Weights& out_;
    const Storages& storages_;
    std::size_t visited_ = 0, gathered_ = 0, total_ = 0;
};

Weights collected(const pickle::Pickle& pickle, const Storages& storages, const std::filesystem::path& path) {
    Weights out{path, {}, {}, {}};
    Collector(out, storages).collect(*pickle.root, "", 0);
    if (out.tensors.empty()) throw Error("{}: expected tensors, found none", path.string());
    return out;
}

}  // namespace

Weights load_torch_zip(std::shared_ptr<const MappedFile> file) {
    const auto records = zip_records(*file);
    // "archive/data.pkl": the folder's name is arbitrary.
    std::string root;
    const ZipRecord* program = nullptr;
    for (const auto& [name, record] : records)
        if (name == "data.pkl" || name.ends_with("/data.pkl")) {
            program = &record;
            root = name.substr(0, name.size() - std::string_view("data.pkl").size());
            break;
        }
    if (!program) throw Error("{}: expected a file of torch.save, found a zip without data.pkl", file->path().string());
    const auto stored = [&](const ZipRecord& record, std::string_view name) {
        if (record.packed)
            throw Error("{}: {}: expected a stored entry as torch.save writes it, found a packed one",
                        file->path().string(), name);
        return file->text().substr(record.begin, record.size);
    };
    const auto order = records.find(root + "byteorder");
    if (order != records.end() && stored(order->second, order->first) == "big")
        throw Error("{}: expected little endian numbers, found big endian ones", file->path().string());
    Storages storages;
    for (const auto& [name, record] : records)
        if (name.starts_with(root + "data/")) {
            (void)stored(record, name);
            storages[name.substr(root.size() + 5)] = {file->bytes().subspan(record.begin, record.size), file};
        }
    const auto pickle = pickle::read_pickle(stored(*program, root + "data.pkl"), 0, program->begin, file->path());
    return collected(pickle, storages, file->path());
}

Weights load_torch_legacy(std::shared_ptr<const MappedFile> file) {
    const std::string_view text = file->text();
    const auto next = [&](std::size_t begin) { return pickle::read_pickle(text, begin, 0, file->path()); };
    // magic number, protocol, machine, the values, the storage keys; then count and bytes of each storage.
    std::size_t at = next(0).end;
    for (int i = 0; i < 2; ++i) at = next(at).end;
    const auto values = next(at);
    const auto keys = next(values.end);
    at = keys.end;
    // The storages' number types are recorded with the values.
    std::map<std::string, std::string> types;
    for (const Value& value : values.values)
        if (const auto* storage = value.as<pickle::Storage>()) types[storage->key] = storage->dtype;

    const auto* list = keys.root->as<pickle::Sequence>();
    if (!list)
        throw Error("{}: byte {}: expected the list of storages, found another value", file->path().string(),
                    values.end);
    Storages storages;
    for (const pickle::Ref& item : list->items) {
        const auto* key = item->as<pickle::Text>();
        if (!key) throw Error("{}: byte {}: expected names of storages", file->path().string(), values.end);
        const auto type = type_of_storage(types[std::string(key->bytes)]);
        if (!type)
            throw Error("{}: storage {}: expected a known number type, found \"{}\"", file->path().string(), key->bytes,
                        types[std::string(key->bytes)]);
        std::uint64_t count = 0;
        if (text.size() - at >= 8) std::memcpy(&count, text.data() + at, 8);
        if (text.size() - at < 8 || count > (text.size() - at - 8) / bytes_of(*type))
            throw Error("{}: byte {}: storage {}: expected {} numbers of {} bytes, found {} bytes (cut off?)",
                        file->path().string(), at, key->bytes, count, bytes_of(*type), text.size() - at);
        const std::size_t size = count * bytes_of(*type);
        storages[std::string(key->bytes)] = {file->bytes().subspan(at + 8, size), file};
        at += 8 + size;
    }
    return collected(values, storages, file->path());
}

}  // namespace fastscene

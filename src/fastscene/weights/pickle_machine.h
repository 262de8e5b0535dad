// The stack machine of Python's pickle format (protocols 0 to 5, the subset that torch.save uses). Private to the
// weights loader.
#pragma once

#include <cstdint>
#include <filesystem>
#include <deque>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace fastscene::pickle {

struct Value;
using Ref = Value*;  // owned by the Pickle: values may be shared and cyclic, as in Python

struct None {};
struct Opaque {};  // any type that is not supported
struct Text {
    std::string_view bytes;  // view into the file
};
struct Global {
    std::string name;  // "collections.OrderedDict"
};
struct Sequence {  // list, tuple, set
    std::vector<Ref> items;
};
struct Dictionary {
    std::vector<std::pair<Ref, Ref>> items;
};
struct Module {           // an object of a TorchScript class
    Ref state = nullptr;  // its attribute dictionary; null until BUILD
};
struct Storage {
    std::string key;    // "0": key of its bytes
    std::string dtype;  // "FloatStorage"
    std::uint64_t count = 0;
    std::uint64_t offset = 0;  // offset of a view into it, in elements (legacy)
};
struct Tensor {
    Storage storage;
    std::int64_t offset = 0;  // in elements
    std::vector<std::int64_t> shape, stride;
};
struct Value {
    std::variant<None, Opaque, bool, std::int64_t, double, Text, Global, Sequence, Dictionary, Module, Storage, Tensor>
        held;
    template <class T>
    const T* as() const {
        return std::get_if<T>(&held);
    }
};

struct Pickle {
    std::deque<Value> values;
    Ref root = nullptr;
    std::size_t end = 0;  // offset after the pickle
};

// Reads one pickle, from `begin` of `bytes`, which must outlive the result. Memory is bounded in proportion to the
// pickle's length. Throws Error naming the file and the offset in it (`bytes` starts at `base`).
Pickle read_pickle(std::string_view bytes, std::size_t begin, std::size_t base, const std::filesystem::path& path);

}  // namespace fastscene::pickle

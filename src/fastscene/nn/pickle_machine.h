// The stack machine of Python's pickles (protocols 0 to 5, the part that torch.save uses). Private to the weights'
// loader.
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
using Ref = Value*;  // owned by the Pickle: values may share and contain each other, as in Python

struct None {};
struct Opaque {};  // anything that is not allowed to be more
struct Text {
    std::string_view bytes;  // in the file
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
    Ref state = nullptr;  // the dictionary of its attributes; none until BUILD
};
struct Storage {
    std::string key;    // "0": the name of its bytes
    std::string dtype;  // "FloatStorage"
    std::uint64_t count = 0;
    std::uint64_t offset = 0;  // of a view into it, in elements (legacy)
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
    std::size_t end = 0;  // the place behind it
};

// One pickle, from `begin` of `bytes`, which must outlive it. Memory stays in proportion to the length of the pickle,
// whatever it says. Throws Error naming the file and the offset in it (`bytes` being at `base`).
Pickle read_pickle(std::string_view bytes, std::size_t begin, std::size_t base, const std::filesystem::path& path);

}  // namespace fastscene::pickle

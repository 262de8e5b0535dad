#include "fastscene/nn/shipped.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <span>

#include "fastscene/base/error.h"
#include "fastscene/nn/safetensors.h"

namespace fastscene {

// Written by cmake/shipped.cmake.
struct ShippedFile {
    std::string_view name, bytes;
};
std::span<const ShippedFile> shipped_files();

std::vector<std::string> shipped_names() {
    std::vector<std::string> names;
    for (const ShippedFile& file : shipped_files()) names.emplace_back(file.name);
    return names;
}

bool is_shipped(std::string_view name) {
    const auto files = shipped_files();
    return std::any_of(files.begin(), files.end(), [&](const ShippedFile& file) { return file.name == name; });
}

Weights shipped_weights(std::string_view name) {
    for (const ShippedFile& file : shipped_files())
        if (file.name == name)
            return load_safetensors(
                std::make_shared<MappedFile>(fmt::format("models/{}.safetensors", name), file.bytes));
    throw Error("expected weights that come with the program ({}), found \"{}\"", fmt::join(shipped_names(), ", "),
                name);
}

}  // namespace fastscene

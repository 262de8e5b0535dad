// A registry: all entries of a kind (splat formats, depth backends, inpainters …), one source file each. The build
// collects them from a folder (cmake/registry.cmake), so that an entry is added with its file alone; flags, --help,
// errors and the contract tests take their lists from here. An entry is plain data with a `name` and an `about`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fastscene/base/error.h"

namespace fastscene {

// Sorted by the names of the entries' files.
template <class Entry>
const std::vector<Entry>& registered();

template <class Entry>
std::vector<std::string> registered_names() {
    std::vector<std::string> names;
    for (const Entry& entry : registered<Entry>()) names.emplace_back(entry.name);
    return names;
}

// "a, b or c".
inline std::string any_of(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i)
        text += (i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + names[i];
    return text;
}

// Null if there is none.
template <class Entry>
const Entry* find_registered(std::string_view name) {
    for (const Entry& entry : registered<Entry>())
        if (entry.name == name) return &entry;
    return nullptr;
}

// Throws UsageError with the names that there are. `flag` is where the name came from: "--depth-backend".
template <class Entry>
const Entry& registered_entry(std::string_view flag, std::string_view name) {
    if (const Entry* entry = find_registered<Entry>(name)) return *entry;
    throw UsageError("{}: expected {}, found \"{}\"", flag, any_of(registered_names<Entry>()), name);
}

}  // namespace fastscene

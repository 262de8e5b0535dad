// The builders of furniture by kind. The table is generated from the catalogue (cmake/catalogue.cmake): the row [dog]
// asks for a function build_dog, which stands in some source under furniture/.
#pragma once

#include <span>
#include <string_view>

namespace fastscene::furniture {

struct Kit;

using Builder = void (*)(Kit&);

struct BuilderEntry {
    std::string_view kind;
    Builder build;
};

// Sorted by kind.
std::span<const BuilderEntry> builders();

// Null: nothing builds such things.
Builder builder_of(std::string_view kind);

}  // namespace fastscene::furniture

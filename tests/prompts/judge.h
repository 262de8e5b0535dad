// Judge: whether things stand where a sentence asks for them, from the poses in room.json alone. It shares no code with
// the layout, so that the layout cannot be its own witness.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fastscene/base/json.h"

namespace judge {

// "lamp 2 on desk": so many of these classes (any of them will do) in this relation to one of those. Relations: on,
// above, under, before, behind, next, left, right, opposite, facing, around, sides, foot, between (two places), corner,
// middle.
struct Demand {
    std::vector<std::string> what;
    int count = 1;
    std::string relation;
    std::vector<std::vector<std::string>> places;
    std::string text;
};
struct Sentence {
    std::string text;
    std::vector<Demand> demands;
};

// Lines "prompt | demand; demand"; # begins a comment. Throws fastscene::Error with file and line.
std::vector<Sentence> read_sentences(const std::filesystem::path& file);

// Empty: it holds. Else what is wrong, for people.
std::string complaint(const fastscene::Json& room, const Demand& demand);

}  // namespace judge

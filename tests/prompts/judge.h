// Judge: whether objects are where a sentence asks for them, based on the poses in room.json alone. Shares no code with
// the layout, to be independent of it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fastscene/base/json.h"

namespace judge {

// "lamp 2 on desk": at least that many objects of these classes in this relation to one of those. Relations: on, above,
// under, before, behind, next, left, right, opposite, facing, around, sides, foot, between (two places), corner,
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

// Lines "prompt
// demand; demand"; # starts a comment. Throws fastscene::Error with file and line.
std::vector<Sentence> read_sentences(const std::filesystem::path& file);

// Empty if satisfied, else a description of the problem.
std::string complaint(const fastscene::Json& room, const Demand& demand);

}  // namespace judge

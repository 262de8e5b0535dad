// The scenes of a batch, as lists describe them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace fastscene {

struct BatchScene {
    std::string name;  // of its folder
    std::string prompt;
    std::uint64_t seed = 0;
    std::string quality;             // empty: the batch's
    std::vector<std::string> flags;  // of `make`
};
struct SceneList {
    std::vector<BatchScene> scenes;
    std::vector<std::string> problems;  // "list.txt:7: expected …, found …": lines that give no scene
};

// A text file has a prompt a line; empty lines and lines that begin with # are skipped. A file that ends in .jsonl has
// a JSON object a line: prompt, and optionally seed, name, quality, flags (a list of texts). Scenes without a name or a
// seed get them from their place in the list. Throws Error if the file cannot be read.
SceneList read_scene_list(const std::filesystem::path& file, std::uint64_t first_seed);

// `count` different sentences about rooms of all types and styles. The first sentences do not depend on how many there
// are.
SceneList varied_scenes(int count, std::uint64_t seed);

}  // namespace fastscene

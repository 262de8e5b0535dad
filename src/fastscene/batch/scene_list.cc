#include "fastscene/batch/scene_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>

#include "fastscene/base/error.h"
#include "fastscene/base/json.h"
#include "fastscene/pipeline/run_folder.h"

namespace fastscene {
namespace {

constexpr std::size_t kLongestPrompt = 4000;  // bytes: longer lines are data of another kind
const char* const kKeys[] = {"prompt", "seed", "name", "quality", "flags"};

// What is wrong with a line; the caller adds file and line.
struct Problem {
    std::string text;
};

std::string name_at(std::size_t place, const std::string& prompt) {
    return fmt::format("{:05}-{}", place, slug_of(prompt));
}

void check_name(const std::string& name) {
    if (name.empty() || name.front() == '.' || name.find_first_of("/\\") != std::string::npos || name.size() > 200)
        throw Problem{fmt::format("name: expected the name of a folder, found \"{}\"", name)};
}
void check_prompt(const std::string& prompt) {
    if (prompt.find_first_not_of(" \t\r") == std::string::npos)
        throw Problem{"prompt: expected a sentence, found none"};
    if (prompt.size() > kLongestPrompt)
        throw Problem{fmt::format("prompt: expected at most {} bytes, found {}", kLongestPrompt, prompt.size())};
}

template <class T>
T value_of(const Json& json, const char* key, const char* expected) {
    try {
        return json.get<T>();
    } catch (const Json::exception&) {
        throw Problem{fmt::format("{}: expected {}, found {}", key, expected, json.dump())};
    }
}

BatchScene scene_of_json(const std::string& line) {
    Json json;
    try {
        json = Json::parse(line);
    } catch (const Json::exception&) {
        throw Problem{"expected a JSON object, found other text"};
    }
    if (!json.is_object()) throw Problem{fmt::format("expected a JSON object, found {}", json.type_name())};
    for (const auto& [key, value] : json.items())
        if (std::find(std::begin(kKeys), std::end(kKeys), key) == std::end(kKeys))
            throw Problem{fmt::format("expected the keys {}, found \"{}\"", fmt::join(kKeys, ", "), key)};
    BatchScene scene;
    if (!json.contains("prompt")) throw Problem{"expected a prompt, found none"};
    scene.prompt = value_of<std::string>(json["prompt"], "prompt", "a text");
    if (json.contains("seed")) {
        if (!json["seed"].is_number_unsigned())
            throw Problem{fmt::format("seed: expected a whole number, found {}", json["seed"].dump())};
        scene.seed = json["seed"].get<std::uint64_t>();
    }
    if (json.contains("name")) scene.name = value_of<std::string>(json["name"], "name", "a text");
    if (json.contains("quality")) scene.quality = value_of<std::string>(json["quality"], "quality", "a text");
    if (json.contains("flags"))
        scene.flags = value_of<std::vector<std::string>>(json["flags"], "flags", "a list of texts");
    if (json.contains("name")) check_name(scene.name);
    return scene;
}

// Takes lines in order, and keeps names unique.
class Collector {
  public:
    Collector(std::string file, std::uint64_t first_seed) : file_(std::move(file)), first_seed_(first_seed) {}
    void add(int line, BatchScene scene, bool has_seed) {
        const std::size_t place = place_++;
        check_prompt(scene.prompt);
        if (!has_seed) scene.seed = first_seed_ + place;
        if (scene.name.empty()) scene.name = name_at(place, scene.prompt);
        if (const auto [found, is_new] = lines_.try_emplace(scene.name, line); !is_new)
            throw Problem{fmt::format("name: expected a unique one, found \"{}\", the name in line {}", scene.name,
                                      found->second)};
        list.scenes.push_back(std::move(scene));
    }
    void refuse(int line, const Problem& problem) {
        list.problems.push_back(fmt::format("{}:{}: {}", file_, line, problem.text));
    }
    SceneList list;

  private:
    std::string file_;
    std::uint64_t first_seed_;
    std::size_t place_ = 0;
    std::map<std::string, int> lines_;  // of names
};

}  // namespace

SceneList read_scene_list(const std::filesystem::path& file, std::uint64_t first_seed) {
    std::ifstream in(file);
    if (!in || std::filesystem::is_directory(file))
        throw Error("{}: expected a list of prompts (.txt or .jsonl), cannot be read", file.string());
    const bool is_json = file.extension() == ".jsonl";
    Collector collector(file.string(), first_seed);
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
        if (!line.empty() && line.back() == '\r') line.pop_back();
        if (line.find_first_not_of(" \t") == std::string::npos || line.front() == '#') continue;
        try {
            if (!is_json) {
                collector.add(number, BatchScene{{}, line, 0, {}, {}}, false);
                continue;
            }
            BatchScene scene = scene_of_json(line);
            const bool has_seed = Json::parse(line).contains("seed");
            collector.add(number, std::move(scene), has_seed);
        } catch (const Problem& problem) {
            collector.refuse(number, problem);
        }
    }
    return std::move(collector.list);
}

}  // namespace fastscene

// Prompt benchmark: for the sentences in a file, how many words are understood, and how many of the requested objects
// are placed and visible. bench_prompts tests/data/prompts_held_back.txt. One JSON document on stdout: the figures, and
// the problems of each sentence.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <fstream>
#include <iostream>

#include "fastscene/base/json.h"
#include "fastscene/rooms/layout.h"
#include "fastscene/rooms/pack.h"
#include "fastscene/rooms/rooms.h"
#include "fastscene/rooms/validate.h"
#include "fastscene/trace/trace.h"

using namespace fastscene;

namespace {

constexpr std::int64_t kSeen = 8;  // pixels of 512 x 256: a mug on a table four metres away

struct Figures {
    int prompts = 0, words = 0, understood = 0, approximated = 0, not_placed = 0, not_understood = 0;
    int wishes = 0, there = 0, reported = 0, seen = 0, faults = 0;
};

Json read_one(const std::string& text, std::uint64_t seed, const std::shared_ptr<const FurniturePack>& pack,
              Figures& sum) {
    Run run;
    run.seed = seed;
    PromptSpec spec = understand_prompt(text, false, pack);
    const FurnishedRoom furnished = furnish_room(spec, run);
    const std::vector<Fault> faults = room_faults(furnished.plan, furnished.placed, furnished.camera);
    spec = understand_prompt(text, false, pack);
    const TracedRoom room(make_room(spec, run));
    const Json report = to_json(spec);
    Json out{{"prompt", text}};
    for (const char* list : {"approximated", "not_placed", "not_understood"}) out[list] = report[list];
    ++sum.prompts;
    sum.words += static_cast<int>(spec.words.size());
    sum.understood += static_cast<int>(report["understood"].size());
    sum.approximated += static_cast<int>(report["approximated"].size());
    sum.not_placed += static_cast<int>(report["not_placed"].size());
    sum.not_understood += static_cast<int>(report["not_understood"].size());
    sum.faults += static_cast<int>(faults.size());
    for (const Fault& fault : faults) out["faults"].push_back(fault.text);
    const Shot shot = room.panorama({}, {512, 256}, {.color = false, .range = false, .object = true}, run);
    const Json objects = room_json(room.room(), shot.object)["objects"];
    for (const Json& object : objects) {
        if (!object["requested"].get<bool>()) continue;
        const bool seen = object["visible_pixels"].get<std::int64_t>() >= kSeen;
        ++sum.there;
        sum.seen += seen;
        out[seen ? "seen" : "hidden"].push_back(object["name"]);
    }
    for (const PromptObject& wish : spec.objects) {
        if (wish.forbidden) continue;
        ++sum.wishes;
        sum.reported += wish.placed > 0 ||
                        std::any_of(spec.not_placed.begin(), spec.not_placed.end(),
                                    [&](const std::string& line) { return line.starts_with(wish.words + ": "); });
    }
    return out;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("How prompts are read, furnished and seen.", "bench_prompts");
    std::string file, assets = "cc0";
    std::uint64_t seed = 1;
    app.add_option("file", file, "One prompt a line; # begins a comment.")->required()->check(CLI::ExistingFile);
    app.add_option("--seed", seed);
    app.add_option("--assets", assets)->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    try {
        std::vector<std::string> complaints;
        const auto pack = FurniturePack::open(FurniturePack::default_folder(), assets_named(assets), complaints);
        Figures sum;
        Json prompts = Json::array();
        std::ifstream lines(file);
        for (std::string line; std::getline(lines, line);)
            if (!line.empty() && line[0] != '#') prompts.push_back(read_one(line, seed, pack, sum));
        std::cout << Json{{"figures",
                           {{"prompts", sum.prompts},
                            {"words", sum.words},
                            {"understood", sum.understood},
                            {"approximated", sum.approximated},
                            {"not_placed", sum.not_placed},
                            {"not_understood", sum.not_understood},
                            {"wishes", sum.wishes},
                            {"wishes_there_or_reported", sum.reported},
                            {"objects_there", sum.there},
                            {"objects_seen", sum.seen},
                            {"layout_faults", sum.faults},
                            {"pack", pack != nullptr}}},
                          {"prompts", prompts}}
                         .dump(1)
                  << std::endl;
    } catch (const std::exception& e) {
        std::cerr << "bench_prompts: " << e.what() << std::endl;
        return 1;
    }
}

// Relations benchmark: for sentences that state positions, how many rooms satisfy them. Judged from room.json by
// tests/prompts/judge.h. bench_relations tests/data/relations.txt --seeds 3. One JSON document on stdout: the shares,
// and the problems of each sentence.
#include <CLI/CLI.hpp>
#include <iostream>
#include <map>

#include "fastscene/rooms/layout.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/pack.h"
#include "fastscene/rooms/rooms.h"
#include "fastscene/rooms/style.h"
#include "fastscene/rooms/validate.h"
#include "tests/prompts/judge.h"

using namespace fastscene;

namespace {

// The rooms of the validator's test: all types and styles in turn.
Json anneal_rooms(int count, const AnnealParams& annealing) {
    const std::vector<std::string> types = room_types(), all = styles();
    double before = 0, after = 0, seconds = 0, longest = 0;
    int better = 0, faults = 0;
    for (int i = 0; i < count; ++i) {
        const auto n = static_cast<std::size_t>(i);
        PromptSpec spec = understand_prompt(
            "a " + all[(n + n / 60) % all.size()] + " " + room_title(types[n % types.size()]), false);
        const FurnishedRoom room = furnish_room(spec, {n, nullptr, {}}, annealing);
        before += room.annealed.before, after += room.annealed.after, seconds += room.annealed.seconds;
        longest = std::max(longest, room.annealed.seconds);
        better += room.annealed.after < room.annealed.before;
        faults += static_cast<int>(room_faults(room.plan, room.placed, room.camera).size());
    }
    const double n = std::max(1, count);
    return {{"rooms", count},           {"cost_before", before / n}, {"cost_after", after / n},
            {"rooms_improved", better}, {"cpu_s_mean", seconds / n}, {"cpu_s_longest", longest},
            {"layout_faults", faults}};
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("How many rooms keep what a sentence says of where things stand.", "bench_relations");
    std::string file, assets = "cc0";
    int seeds = 3, rooms = 0, steps = AnnealParams{}.steps;
    app.add_option("file", file, "Lines 'prompt | demands'; # begins a comment.")->required()->check(CLI::ExistingFile);
    app.add_option("--seeds", seeds, "Rooms a sentence.")->capture_default_str()->check(CLI::PositiveNumber);
    app.add_option("--assets", assets)->capture_default_str();
    app.add_option("--rooms", rooms,
                   "So many rooms without wishes too: the annealer's cost and time, and the validator.")
        ->capture_default_str();
    app.add_option("--steps", steps, "Of the annealer; 0: pieces stay in their slots.")->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    try {
        std::vector<std::string> complaints;
        const auto pack = FurniturePack::open(FurniturePack::default_folder(), assets_named(assets), complaints);
        AnnealParams annealing;
        annealing.steps = steps;
        int asked = 0, kept = 0, wishes = 0, placed = 0, faults = 0;
        std::map<std::string, std::pair<int, int>> by_relation;
        Json missing = Json::array();
        for (const judge::Sentence& sentence : judge::read_sentences(file))
            for (int seed = 1; seed <= seeds; ++seed) {
                Run run;
                run.seed = static_cast<std::uint64_t>(seed);
                PromptSpec spec = understand_prompt(sentence.text, false, pack);
                const FurnishedRoom furnished = furnish_room(spec, run, annealing);
                faults += static_cast<int>(room_faults(furnished.plan, furnished.placed, furnished.camera).size());
                const Json room = room_json(room_of(spec, furnished, run), {});
                for (const PromptObject& o : spec.objects)
                    if (!o.forbidden) wishes += o.count, placed += std::min(o.count, o.placed);
                for (const judge::Demand& demand : sentence.demands) {
                    const std::string complaint = judge::complaint(room, demand);
                    ++asked, ++by_relation[demand.relation].second;
                    if (complaint.empty()) ++kept, ++by_relation[demand.relation].first;
                    else
                        missing.push_back({{"prompt", sentence.text},
                                           {"seed", seed},
                                           {"complaint", complaint},
                                           {"report", to_json(spec)["approximated"]}});
                }
            }
        Json relations;
        for (const auto& [name, share] : by_relation)
            relations[name] = std::to_string(share.first) + " of " + std::to_string(share.second);
        std::cout << Json{{"annealing", anneal_rooms(rooms, annealing)},
                          {"figures",
                           {{"relations", asked},
                            {"kept", kept},
                            {"share", static_cast<double>(kept) / std::max(1, asked)},
                            {"pieces_asked", wishes},
                            {"pieces_placed", placed},
                            {"layout_faults", faults},
                            {"pack", pack != nullptr}}},
                          {"by_relation", relations},
                          {"missing", missing}}
                         .dump(1)
                  << std::endl;
    } catch (const std::exception& e) {
        std::cerr << "bench_relations: " << e.what() << std::endl;
        return 1;
    }
}

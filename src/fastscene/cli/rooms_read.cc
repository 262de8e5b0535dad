#include "fastscene/cli/flags.h"
#include "fastscene/cli/rooms.h"
#include "fastscene/rooms/pack.h"
#include "fastscene/rooms/rooms.h"

namespace fastscene::cli {
namespace {

// "understood      blue velvet sofa: object: sofa, color blue", one line per word.
std::string as_text(const Json& report) {
    std::string text;
    for (const char* list : {"understood", "approximated", "not_placed", "not_understood"})
        for (const Json& word : report[list]) {
            const std::string words = word.is_string() ? word.get<std::string>() : word["words"].get<std::string>();
            const std::string what = word.is_string() ? std::string()
                                                      : word.value("meaning", word.value("reason", std::string()));
            text += fmt::format("{:<15} {}{}{}\n", list, words, what.empty() ? "" : ": ", what);
        }
    for (const Json& choice : report["assumed"])
        text += fmt::format("{:<15} {}: {}\n", "assumed", choice["what"].get<std::string>(),
                            choice["value"].get<std::string>());
    if (!text.empty()) text.pop_back();
    return text;
}

}  // namespace

Verb add_rooms_read(CLI::App& rooms) {
    struct Flags {
        std::string prompt, seed = "0", assets = "cc0";
    };
    auto flags = std::make_shared<Flags>();
    CLI::App* verb = rooms.add_subcommand(
        "read", "Shows how a prompt is understood, and how the room is furnished; makes no picture.");
    verb->add_option("prompt", flags->prompt, "The sentence.")->required()->type_name("PROMPT");
    verb->add_option("--seed", flags->seed, "Seed of the room.")->type_name("N")->capture_default_str();
    verb->add_option("--assets", flags->assets,
                     "A folder of your own models; or of the furniture pack none, public domain (cc0), or all.")
        ->type_name("DIR|none|cc0|all")
        ->capture_default_str();
    return {verb, [flags](const Session& session) {
                std::vector<std::string> complaints;
                const auto pack = FurniturePack::open(flags->assets, complaints);
                const fastscene::Run run = session.run(number_from<std::uint64_t>("--seed", flags->seed));
                for (const std::string& complaint : complaints) run.warn(complaint);
                PromptSpec spec = understand_prompt(flags->prompt, false, pack);
                make_room(spec, run);
                const Json report = to_json(spec);
                session.print(as_text(report), report);
            }};
}

}  // namespace fastscene::cli

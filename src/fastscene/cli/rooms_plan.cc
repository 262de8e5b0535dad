#include "fastscene/base/writable.h"
#include "fastscene/cli/flags.h"
#include "fastscene/cli/rooms.h"
#include "fastscene/rooms/document.h"
#include "fastscene/rooms/pack.h"

namespace fastscene::cli {
namespace {

struct PlanFlags {
    std::string prompt, room, out = "room.json", seed = "0", assets = "cc0";
};

RoomDocument planned(const PlanFlags& flags, const std::shared_ptr<const FurniturePack>& pack, const Run& run) {
    if (flags.prompt.empty() == flags.room.empty())
        throw UsageError("rooms plan: expected either a prompt in quotes or --room FILE, found {}",
                         flags.prompt.empty() ? "neither" : "both");
    if (!flags.room.empty()) return completed(load_document(flags.room), flags.room, pack, run);
    PromptSpec spec = understand_prompt(flags.prompt, false, pack);
    return plan_document(spec, run);
}

}  // namespace

Verb add_rooms_plan(CLI::App& rooms) {
    auto flags = std::make_shared<PlanFlags>();
    CLI::App* verb = rooms.add_subcommand(
        "plan", "Furnishes a room and writes it as a document, to be edited and built with `make --room`.");
    verb->add_option("prompt", flags->prompt, "The sentence.")->type_name("PROMPT");
    verb->add_option("--room", flags->room, "Complete this document instead: whatever it leaves open is chosen.")
        ->type_name("FILE");
    verb->add_option("-o,--out", flags->out, "The document to write.")->type_name("FILE")->capture_default_str();
    verb->add_option("--seed", flags->seed, "Seed of the room.")->type_name("N")->capture_default_str();
    verb->add_option("--assets", flags->assets,
                     "A folder of your own models; or of the furniture pack none, public domain (cc0), or all.")
        ->type_name("DIR|none|cc0|all")
        ->capture_default_str();
    return {verb, [flags](const Session& session) {
                check_writable(flags->out);
                std::vector<std::string> complaints;
                const auto pack = FurniturePack::open(flags->assets, complaints);
                const fastscene::Run run = session.run(number_from<std::uint64_t>("--seed", flags->seed));
                const RoomDocument document = planned(*flags, pack, run);
                const Json json = document_json(document);
                write_json(flags->out, json);
                session.print(fmt::format("{}: {} {}, {} things", flags->out, document.style, document.type,
                                          document.things.size()),
                              json);
            }};
}

Verb add_rooms_schema(CLI::App& rooms) {
    CLI::App* verb = rooms.add_subcommand("schema", "Prints the JSON Schema of room documents.");
    return {verb, [](const Session& session) { session.print(document_schema().dump(2), document_schema()); }};
}

}  // namespace fastscene::cli

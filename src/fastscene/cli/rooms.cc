#include "fastscene/cli/rooms.h"

namespace fastscene::cli {

Verb add_rooms(CLI::App& app) {
    CLI::App* verb = app.add_subcommand("rooms",
                                        "Furnished rooms: documents, contact sheets, checks, prompts, datasets.");
    verb->require_subcommand(1);
    verb->footer(
        "Examples:\n  fastscene rooms read \"a loft with brick walls and two sofas\"\n  fastscene rooms plan \"a loft "
        "with brick walls\" -o room.json\n  fastscene rooms dataset "
        "--count 1000 --size 512x256 -o data/rooms");
    const std::vector<Verb> parts{add_rooms_sheet(*verb), add_rooms_check(*verb),  add_rooms_read(*verb),
                                  add_rooms_plan(*verb),  add_rooms_schema(*verb), add_rooms_dataset(*verb)};
    for (const Verb& part : parts) part.app->fallthrough();  // common flags belong to `rooms`
    return {verb, [parts](const Session& session) {
                for (const Verb& part : parts)
                    if (part.app->parsed()) part.act(session);
            }};
}

}  // namespace fastscene::cli

#include "fastscene/cli/flags.h"
#include "fastscene/cli/rooms.h"
#include "fastscene/pipeline/contact_sheet.h"

namespace fastscene::cli {

Verb add_rooms_sheet(CLI::App& rooms) {
    struct Flags {
        std::string out, seed = "0";
        std::vector<std::string> rooms, styles;
        std::shared_ptr<Given> given = std::make_shared<Given>();
    };
    auto flags = std::make_shared<Flags>();
    CLI::App* verb = rooms.add_subcommand("sheet",
                                          "A picture of every room in every style, and all of them on one sheet.");
    verb->add_option("-o,--out", flags->out, "Folder of the pictures and sheets. Existing pictures are kept.")
        ->type_name("DIR")
        ->required();
    verb->add_option("--rooms", flags->rooms, "Only these rooms, comma-separated: living, bedroom, kids …")
        ->type_name("NAMES")
        ->delimiter(',');
    verb->add_option("--styles", flags->styles, "Only these styles, comma-separated: modern, \"art deco\" …")
        ->type_name("NAMES")
        ->delimiter(',');
    verb->add_option("--seed", flags->seed, "Seed: gives other rooms of the same kinds.")
        ->type_name("N")
        ->capture_default_str();
    add_fields(*verb, "", SheetParams{}, flags->given, "Settings of the pictures");
    return {verb, [flags](const Session& session) {
                SheetParams params;
                apply_fields("", params, *flags->given);
                const auto made = make_contact_sheet(flags->out, flags->rooms, flags->styles, params,
                                                     session.run(number_from<std::uint64_t>("--seed", flags->seed)));
                Json sheets = Json::array();
                for (const auto& path : made) sheets.push_back(path.string());
                session.print(made.back().string(), {{"sheets", sheets}});
            }};
}

}  // namespace fastscene::cli

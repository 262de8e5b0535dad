#include "fastscene/cli/dataset.h"
#include "fastscene/dataset/card.h"
#include "fastscene/dataset/statistics.h"

namespace fastscene::cli {

Verb add_dataset_stats(CLI::App& app) {
    auto folder = std::make_shared<std::string>();
    CLI::App* verb = app.add_subcommand(
        "stats", "Statistics of a dataset, complete or not: rooms, styles, classes, ranges, bytes.");
    verb->add_option("set", *folder, "Folder of a dataset.")->type_name("DIR")->required();
    verb->footer("Example:\n  fastscene dataset stats data/rooms --json");
    return {verb, [folder](const Session& session) {
                const dataset::Statistics statistics = dataset::statistics_of(dataset::DataSet(*folder, false));
                session.print(dataset::to_text(statistics), dataset::to_json(statistics));
            }};
}

Verb add_dataset_card(CLI::App& app) {
    struct Flags {
        std::string folder, license;
    };
    auto flags = std::make_shared<Flags>();
    CLI::App* verb = app.add_subcommand("card",
                                        "Rewrites the data card, README.md, of a complete dataset; exports copy it.");
    verb->add_option("set", flags->folder, "Folder of a dataset.")->type_name("DIR")->required();
    verb->add_option("--license", flags->license, "The licence under which you publish the dataset: \"cc-by-4.0\".")
        ->type_name("NAME");
    verb->footer("Example:\n  fastscene dataset card data/rooms --license cc-by-4.0");
    return {verb, [flags](const Session& session) {
                if (!flags->license.empty()) dataset::choose_license(flags->folder, flags->license);
                const std::string path = dataset::write_card(flags->folder).string();
                session.print(path, {{"file", path}});
            }};
}

}  // namespace fastscene::cli

#include "fastscene/cli/dataset.h"

namespace fastscene::cli {

Verb add_dataset(CLI::App& app) {
    CLI::App* verb = app.add_subcommand(
        "dataset", "Datasets of `rooms dataset`: export to training formats, checks, statistics, data cards.");
    verb->require_subcommand(1);
    verb->footer(
        "Examples:\n  fastscene rooms dataset --count 1000 --size 512x256 -o data/rooms\n  fastscene dataset export "
        "data/rooms --format webdataset -o data/shards\n  fastscene dataset verify data/rooms --repair");
    const std::vector<Verb> parts{add_dataset_export(*verb), add_dataset_verify(*verb), add_dataset_stats(*verb),
                                  add_dataset_card(*verb)};
    for (const Verb& part : parts) part.app->fallthrough();  // common flags belong to `dataset`
    return {verb, [parts](const Session& session) {
                for (const Verb& part : parts)
                    if (part.app->parsed()) part.act(session);
            }};
}

}  // namespace fastscene::cli

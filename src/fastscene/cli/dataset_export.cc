#include "fastscene/cli/checks.h"
#include "fastscene/cli/dataset.h"
#include "fastscene/cli/flags.h"
#include "fastscene/dataset/export.h"
#include "fastscene/dataset/statistics.h"

namespace fastscene::cli {
namespace {

struct ExportSetFlags {
    std::string set, out, format, splits = "0.8,0.1,0.1", samples, megabytes;
};

std::string formats_text() {
    std::string text;
    for (const DatasetFormat& format : registered<DatasetFormat>())
        text += fmt::format("{}  {}  {}{}; read by {}", text.empty() ? "" : "\n", format.name, format.about,
                            format.panoramas ? "" : " (perspective pictures only)", format.readers);
    return text;
}

dataset::ExportSettings export_settings(const ExportSetFlags& flags) {
    dataset::ExportSettings settings;
    settings.splits = dataset::split_shares(flags.splits);
    const bool is_sharded = registered_entry<DatasetFormat>("--format", flags.format).sharded;
    const auto number = [&](const char* flag, const std::string& text, int usual) {
        if (text.empty()) return usual;
        if (!is_sharded) throw UsageError("{}: expected with --format webdataset, found {}", flag, flags.format);
        const int value = number_from<int>(flag, text);
        if (value < 1) throw UsageError("{}: expected at least 1, found {}", flag, value);
        return value;
    };
    settings.shard_samples = number("--shard-samples", flags.samples, settings.shard_samples);
    constexpr std::uint64_t kMegabyte = 1000 * 1000;
    settings.shard_bytes = kMegabyte *
                           static_cast<std::uint64_t>(number("--shard-mb", flags.megabytes,
                                                             static_cast<int>(settings.shard_bytes / kMegabyte)));
    return settings;
}

}  // namespace

Verb add_dataset_export(CLI::App& app) {
    auto flags = std::make_shared<ExportSetFlags>();
    CLI::App* verb = app.add_subcommand("export", "Exports a dataset in a common training format.");
    const std::vector<std::string> names = registered_names<DatasetFormat>();
    verb->add_option("set", flags->set, "Folder of a complete dataset.")->type_name("DIR")->required();
    verb->add_option("--format", flags->format, "Format to write.")
        ->type_name(fmt::format("{}", fmt::join(names, "|")))
        ->check(one_of(names))
        ->required();
    verb->add_option("-o,--out", flags->out,
                     "Output folder: new, empty, or an export with the same settings, which is made again.")
        ->type_name("DIR")
        ->required();
    verb->add_option("--splits", flags->splits,
                     "Shares of rooms for training, validation and testing. All pictures of a room are in one split.")
        ->type_name("TRAIN,VAL,TEST")
        ->capture_default_str();
    const dataset::ExportSettings usual;
    verb->add_option("--shard-samples", flags->samples, "webdataset: maximum number of pictures per archive.")
        ->type_name("N")
        ->default_str(std::to_string(usual.shard_samples));
    verb->add_option("--shard-mb", flags->megabytes, "webdataset: maximum size of an archive in megabytes.")
        ->type_name("N")
        ->default_str(std::to_string(usual.shard_bytes / 1000000));
    verb->footer("Formats:\n" + formats_text() +
                 "\nExample:\n  fastscene dataset export data/rooms --format coco --splits 0.9,0.1,0 -o data/coco");
    return {verb, [flags](const Session& session) {
                const Json done = dataset::export_dataset(flags->set, flags->format, export_settings(*flags),
                                                          flags->out, session.run(0));
                std::string splits;
                for (const auto& [name, count] : done.at("splits").items())
                    splits += fmt::format("{}{} {}", splits.empty() ? "" : ", ", name, count.get<std::int64_t>());
                session.print(
                    fmt::format("{}: {} pictures ({}), {} files, {}", flags->out,
                                done.at("pictures").get<std::int64_t>(), splits, done.at("files").get<std::int64_t>(),
                                dataset::bytes_in_words(done.at("bytes").get<std::uint64_t>())),
                    done);
            }};
}

}  // namespace fastscene::cli

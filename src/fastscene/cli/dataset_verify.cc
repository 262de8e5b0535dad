#include "fastscene/cli/dataset.h"
#include "fastscene/dataset/dataset.h"
#include "fastscene/dataset/set.h"
#include "fastscene/dataset/verify.h"

namespace fastscene::cli {
namespace {

using dataset::VerifyReport;

constexpr std::size_t kListedFaults = 50;  // on a screen; --json has all

std::string report_text(const std::string& folder, const VerifyReport& report) {
    if (report.faults.empty()) return fmt::format("{}: {} files, all intact", folder, report.files);
    std::string text = fmt::format("{}: {} of {} files are missing or damaged", folder, report.faults.size(),
                                   report.files);
    for (std::size_t i = 0; i < std::min(kListedFaults, report.faults.size()); ++i)
        text += fmt::format("\n  {}: {}", report.faults[i].file, report.faults[i].fault);
    if (report.faults.size() > kListedFaults)
        text += fmt::format("\n  and {} more: --json lists them", report.faults.size() - kListedFaults);
    return text;
}

Json report_json(const std::string& folder, const VerifyReport& report, int made) {
    Json faults = Json::array();
    for (const dataset::FoundFault& f : report.faults) faults.push_back({{"file", f.file}, {"fault", f.fault}});
    return {{"folder", folder},
            {"files", report.files},
            {"whole", report.faults.empty()},
            {"faults", faults},
            {"made", made}};
}

int repair(const std::string& folder, const VerifyReport& report, const Session& session) {
    dataset::forget_damaged(folder, report);
    const dataset::MadeFrom from = dataset::made_from(dataset::read_set_settings(folder), folder);
    return make_dataset(from.request, folder, session.run(from.seed)).made;
}

}  // namespace

Verb add_dataset_verify(CLI::App& app) {
    struct Flags {
        std::string folder;
        bool quick = false, repair = false;
    };
    auto flags = std::make_shared<Flags>();
    CLI::App* verb = app.add_subcommand(
        "verify",
        "Finds missing, truncated and damaged files of a dataset or an export; exit code 1 if there are any.");
    verb->add_option("folder", flags->folder, "Folder of a dataset, or of an export.")->type_name("DIR")->required();
    verb->add_flag("--quick", flags->quick, "Check names and sizes only, not contents.");
    verb->add_flag("--repair", flags->repair, "Regenerate what is missing or damaged, then check again.");
    verb->footer("Example:\n  fastscene dataset verify data/rooms --repair");
    return {verb, [flags](const Session& session) {
                VerifyReport report = dataset::verify(flags->folder, flags->quick, session.run(0));
                if (flags->repair && report.is_export)
                    throw UsageError(
                        "--repair: expected a set of `fastscene rooms dataset`, found an export: `fastscene "
                        "dataset export` with the same flags makes it again");
                int made = 0;
                if (flags->repair && !report.faults.empty()) {
                    made = repair(flags->folder, report, session);
                    report = dataset::verify(flags->folder, flags->quick, session.run(0));
                }
                const std::string repaired = flags->repair ? fmt::format("; {} pictures regenerated", made) : "";
                session.print(report_text(flags->folder, report) + repaired, report_json(flags->folder, report, made));
                if (!report.faults.empty())
                    throw Error("{}: {} of {} files are missing, truncated or damaged", flags->folder,
                                report.faults.size(), report.files);
            }};
}

}  // namespace fastscene::cli

#include "fastscene/cli/metrics.h"

#include "fastscene/cli/flags.h"
#include "fastscene/pipeline/pipeline.h"
#include "fastscene/pipeline/truth.h"

namespace fastscene::cli {

namespace {

// Flags of `metrics DIR --truth` would be silently ignored by another measure, above all a second folder.
void refuse_own(const CLI::App& verb, const Given& given, const std::string& part) {
    if (const CLI::Option* folder = verb.get_option("folder"); folder->count())
        throw UsageError("metrics {}: expected no further argument, found \"{}\"", part, folder->as<std::string>());
    for (const char* flag : {"--truth", "--seed"})
        if (verb.get_option(flag)->count())
            throw UsageError("metrics {}: expected no {}, which belongs to `metrics DIR --truth`", part, flag);
    if (!given.empty())
        throw UsageError("metrics {}: expected no {}, which belongs to `metrics DIR --truth`", part,
                         given.begin()->first);
}

}  // namespace

Verb add_metrics(CLI::App& app) {
    struct Flags {
        std::string folder;
        bool truth = false;
        std::string seed = "0";
        std::shared_ptr<Given> given = std::make_shared<Given>();
    };
    auto flags = std::make_shared<Flags>();
    CLI::App* verb = app.add_subcommand(
        "metrics", "Compares a scene with its ground truth, the traced room, at poses never trained on.");
    verb->add_option("folder", flags->folder, "Folder of a finished run.")->type_name("DIR");
    verb->add_flag("--truth", flags->truth, "Trace the prompt's room as ground truth and compare.");
    verb->add_option("--seed", flags->seed, "Seed of the poses.")->type_name("N")->capture_default_str();
    add_fields(*verb, "", TruthParams{}, flags->given, "Settings of --truth");
    add_fields(*verb, "", SplatBackend{}, flags->given, "Settings of --truth");
    verb->footer(
        "Examples:\n  fastscene metrics out/bedroom --truth --views 30\n  fastscene metrics images renders --reference "
        "truth");
    const std::vector<Verb> parts{add_metrics_depth(*verb), add_metrics_images(*verb), add_metrics_labels(*verb),
                                  add_niqe_fit(*verb)};
    for (const Verb& part : parts) part.app->fallthrough();  // common flags belong to `metrics`
    return {verb, [verb, flags, parts](const Session& session) {
                for (const Verb& part : parts)
                    if (part.app->parsed()) {
                        refuse_own(*verb, *flags->given, part.app->get_name());
                        return part.act(session);
                    }
                if (flags->folder.empty())
                    throw UsageError(
                        "metrics: expected the folder of a finished run, or a measure of its own: depth, images, "
                        "labels, niqe-fit");
                if (!flags->truth) throw UsageError("metrics: expected --truth, the only measure of runs so far");
                TruthParams params;
                if (flags->given->count("--radius")) params.where = "near";  // --radius implies poses near panorama 0
                apply_fields("", params, *flags->given);
                check_fields("", params);
                SplatBackend backend;
                apply_fields("", backend, *flags->given);
                check_fields("", backend);
                if (params.where != "near" && flags->given->count("--radius"))
                    throw UsageError("--radius: expected with --where near, found --where {}", params.where);
                const Json report = measure_run(
                    flags->folder, params, session.run(number_from<std::uint64_t>("--seed", flags->seed)), backend);
                session.print((RunFolder{flags->folder}.metrics() / "report.json").string(), report);
            }};
}

}  // namespace fastscene::cli

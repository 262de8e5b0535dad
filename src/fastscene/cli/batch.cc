// Many scenes from a list of prompts.
#include "fastscene/batch/batch.h"

#include "fastscene/cli/checks.h"
#include "fastscene/cli/flags.h"
#include "fastscene/cli/request.h"
#include "fastscene/cli/verb.h"
#include "fastscene/pipeline/quality.h"

namespace fastscene::cli {
namespace {

struct BatchFlags {
    std::string list, out, seed = "0", stage = "make";
    std::shared_ptr<RequestFlags> scene = std::make_shared<RequestFlags>();  // settings of all scenes
    int count = 0, jobs = 0, tries = 2;
    bool strict = false, status = false;
    CLI::App* verb = nullptr;
};

std::string status_text(const Json& s) {
    std::string text = fmt::format("{} of {} scenes done, {} failed; {:.0f} s each", s.at("done").get<int>(),
                                   s.at("total").get<int>(), s.at("failed").get<int>(),
                                   s.at("seconds_a_scene").get<double>());
    for (const Json& f : s.at("failures"))
        text += fmt::format("\n  {}: {}", f.at("name").get<std::string>(), f.at("error").get<std::string>());
    return text;
}

SceneList scenes_of(const BatchFlags& flags) {
    const auto seed = number_from<std::uint64_t>("--seed", flags.seed);
    if (flags.count > 0) return varied_scenes(flags.count, seed);
    return read_scene_list(flags.list, seed);
}

// The settings given for all scenes, as the command line of one. Throws UsageError if one is out of bounds.
std::vector<std::string> scene_flags(const BatchFlags& flags) {
    SceneParams params = params_of_quality(flags.scene->quality);
    apply_param_flags(params, *flags.scene->given);
    check_params(params);
    std::vector<std::string> out;
    for (const auto& [name, text] : *flags.scene->given) {
        if (flags.stage == "panorama" && !name.starts_with("--panorama"))
            throw UsageError("{}: expected with --stage make, found --stage panorama", name);
        out.push_back(name);
        if (flags.verb->get_option(name)->get_items_expected_max() > 0) out.push_back(text);
    }
    return out;
}

void act(const BatchFlags& flags, const Session& session) {
    if (flags.status) {
        const Json status = batch_status(flags.out);
        return session.print(status_text(status), status);
    }
    if (flags.list.empty() == (flags.count == 0))
        throw UsageError("batch: expected a list of prompts or --count N, found {}", flags.count ? "both" : "neither");
    const SceneList list = scenes_of(flags);
    const Run run = session.run(0);
    for (const std::string& problem : list.problems) {
        if (flags.strict) throw UsageError("{}", problem);
        run.warn(problem + "; left out");
    }
    if (list.scenes.empty()) throw UsageError("{}: expected prompts, found none", flags.list);
    BatchParams params;
    params.program = std::filesystem::read_symlink("/proc/self/exe");
    params.stage = flags.stage, params.quality = flags.scene->quality, params.flags = scene_flags(flags);
    params.jobs = flags.jobs, params.tries = flags.tries, params.threads = session.common.threads;
    const std::vector<BatchRecord> records = run_batch(list.scenes, flags.out, params, run);
    Json status = batch_status(flags.out);
    status["index"] = (std::filesystem::path(flags.out) / "index.html").string();
    session.print(status_text(status) + "\n" + status["index"].get<std::string>(), status);
    if (status.at("failed").get<int>() > 0)
        throw Error("{} of {} scenes failed: see their .log files in {}", status.at("failed").get<int>(),
                    records.size(), flags.out);
}

}  // namespace

Verb add_batch(CLI::App& app) {
    auto flags = std::make_shared<BatchFlags>();
    CLI::App* verb = app.add_subcommand(
        "batch",
        "Makes many scenes, each in a process of its own; what failed or was stopped is made by the same command.");
    verb->add_option("list", flags->list,
                     "A prompt a line; or .jsonl: objects with prompt, and optionally seed, name, quality, flags.")
        ->type_name("FILE");
    verb->add_option("-o,--out", flags->out, "Folder of the scenes; index.html shows them all.")
        ->type_name("DIR")
        ->required();
    verb->add_option("--count", flags->count, "Instead of a list: so many made-up prompts of all rooms and styles.")
        ->type_name("N")
        ->check(whole_number_within(1, 1000000));
    verb->add_option("--seed", flags->seed, "Seed of the first scene; the others follow.")
        ->type_name("N")
        ->capture_default_str();
    verb->add_option("--stage", flags->stage, "make: scenes; panorama: their panoramas alone.")
        ->type_name("make|panorama")
        ->check(one_of({"make", "panorama"}))
        ->capture_default_str();
    verb->add_option("--jobs", flags->jobs, "Scenes at a time; 0: as many as cores and memory allow.")
        ->type_name("N")
        ->check(whole_number_within(0, 4096))
        ->capture_default_str();
    verb->add_option("--tries", flags->tries, "How often a scene is tried.")
        ->type_name("N")
        ->check(whole_number_within(1, 100))
        ->capture_default_str();
    verb->add_flag("--strict", flags->strict, "Stop at a line that gives no scene, instead of leaving it out.");
    verb->add_flag("--status", flags->status, "Only tell how far the batch in --out is.");
    add_param_flags(*verb, flags->scene, "splat");
    verb->footer(
        "Examples:\n  fastscene batch prompts.txt -o out/rooms "
        "--quality draft\n  fastscene batch --count 100 -o out/hundred --splat-steps 800\n  fastscene batch --status "
        "-o "
        "out/rooms");
    flags->verb = verb;
    return {verb, [flags](const Session& session) { act(*flags, session); }};
}

}  // namespace fastscene::cli

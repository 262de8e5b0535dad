// Many scenes from a list of prompts.
#include "fastscene/batch/batch.h"

#include <algorithm>

#include "fastscene/batch/manifest.h"
#include "fastscene/batch/slurm.h"
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
    std::string engine = "local", slurm_arguments, scratch;
    int count = 0, jobs = 0, tries = 2, chunk = -1, chunk_scenes = 0;
    bool strict = false, status = false, cancel = false;
    CLI::App* verb = nullptr;
};

// {"RUNNING": 3, "PENDING": 4} as "4 PENDING, 3 RUNNING".
std::string counts_text(const Json& counts) {
    std::string text;
    for (const auto& [word, count] : counts.items())
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count.get<int>(), word);
    return text;
}

// Tasks of a job array, and what to do if they ended without a result.
std::string slurm_text(const Json& status) {
    const Json& slurm = status.at("slurm");
    const std::string tasks = counts_text(slurm.at("tasks")), source = slurm.at("source");
    const bool is_active = source == "squeue" && !tasks.empty();
    std::string text = fmt::format("\nSlurm job {}: {}", slurm.at("job").get<std::string>(),
                                   !tasks.empty()      ? "tasks " + tasks
                                   : source == "files" ? "squeue does not answer"
                                                       : "ended");
    if (slurm.contains("reasons")) text += "; wait for " + counts_text(slurm.at("reasons"));
    if (const int requeues = slurm.at("requeues").get<int>(); requeues > 0)
        text += fmt::format(
            "\ntasks reached their time limit and were requeued {} times; --slurm-args=--time=MINUTES raises it",
            requeues);
    const int missing = status.at("total").get<int>() - status.at("done").get<int>() - status.at("failed").get<int>();
    if (missing > 0 && source != "files" && !is_active)
        text += fmt::format(
            "\n{} scenes have no result: see slurm/*.out; the command that submitted them submits them again", missing);
    return text;
}

std::string status_text(const Json& s) {
    std::string text = fmt::format("{} of {} scenes done, {} failed; {:.0f} s each", s.at("done").get<int>(),
                                   s.at("total").get<int>(), s.at("failed").get<int>(),
                                   s.at("seconds_a_scene").get<double>());
    if (s.contains("slurm")) text += slurm_text(s);
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

SceneList checked_scenes(const BatchFlags& flags, const Run& run) {
    if (flags.list.empty() == (flags.count == 0))
        throw UsageError("batch: expected a list of prompts or --count N, found {}", flags.count ? "both" : "neither");
    SceneList list = scenes_of(flags);
    for (const std::string& problem : list.problems) {
        if (flags.strict) throw UsageError("{}", problem);
        run.warn(problem + "; skipped");
    }
    if (list.scenes.empty()) throw UsageError("{}: expected prompts, found none", flags.list);
    return list;
}

void throw_if_failed(const std::vector<BatchRecord>& records, const std::string& folder) {
    const auto failed = std::count_if(records.begin(), records.end(), [](const auto& r) { return !r.done; });
    if (failed > 0) throw Error("{} of {} scenes failed: see their .log files in {}", failed, records.size(), folder);
}

void make_here(const BatchFlags& flags, const BatchParams& params, const Session& session, const Run& run) {
    const std::vector<BatchRecord> records = run_batch(checked_scenes(flags, run).scenes, flags.out, params, run);
    Json status = batch_status(flags.out);
    status["index"] = (std::filesystem::path(flags.out) / "index.html").string();
    session.print(status_text(status) + "\n" + status["index"].get<std::string>(), status);
    throw_if_failed(records, flags.out);
}

void make_chunk(const BatchFlags& flags, const BatchParams& params, const Session& session, const Run& run) {
    const std::vector<BatchRecord> records = run_chunk(flags.out, flags.chunk, params, run);
    session.print(fmt::format("chunk {}: {} scenes", flags.chunk, records.size()),
                  {{"chunk", flags.chunk}, {"scenes", records.size()}});
    throw_if_failed(records, flags.out);
}

void submit(const BatchFlags& flags, const BatchParams& params, const Session& session, const Run& run) {
    const SlurmJob job = submit_to_slurm(checked_scenes(flags, run).scenes, flags.out, params,
                                         {flags.slurm_arguments, flags.scratch, flags.chunk_scenes, flags.jobs}, run);
    const Json json{{"job", job.id}, {"scenes", job.scenes}, {"tasks", job.tasks}};
    if (job.id.empty()) return session.print("nothing to do: all scenes are done", json);
    session.print(fmt::format("Slurm job {}: {} scenes in {} tasks\nfastscene batch {} --status", job.id, job.scenes,
                              job.tasks, flags.out),
                  json);
}

void prepare(const BatchFlags& flags, const BatchParams& params, const Session& session, const Run& run) {
    const ChunkPlan plan = prepare_chunks(checked_scenes(flags, run).scenes, flags.out, params, flags.chunk_scenes);
    session.print(fmt::format("{} scenes in {} chunks; run them in any order:\n"
                              "fastscene batch --chunk NUMBER -o {}    # 0 to {}",
                              plan.scenes, plan.chunks(), flags.out, plan.chunks() - 1),
                  {{"scenes", plan.scenes}, {"chunks", plan.chunks()}});
}

// Flags that another engine or action would silently ignore.
void check_engine(const BatchFlags& flags) {
    const auto refuse = [&](const char* flag, const char* where) {
        throw UsageError("{}: expected with {}, found --engine {}", flag, where, flags.engine);
    };
    if (!flags.slurm_arguments.empty() && flags.engine != "slurm") refuse("--slurm-args", "--engine slurm");
    if (flags.chunk_scenes > 0 && flags.engine == "local") refuse("--chunk-scenes", "--engine slurm or manual");
    if (!flags.scratch.empty() && flags.engine == "manual" && flags.chunk < 0)
        refuse("--scratch", "--chunk or --engine slurm");
}

void act(BatchFlags flags, const Session& session) {
    const bool is_question = flags.status || flags.cancel || flags.chunk >= 0;
    if (is_question && flags.out.empty()) std::swap(flags.out, flags.list);  // batch DIR --status
    if (flags.out.empty()) throw UsageError("--out: expected the folder of the scenes, found none");
    if (flags.cancel) {
        const int tasks = cancel_in_slurm(flags.out);
        return session.print(fmt::format("{} tasks cancelled; finished scenes are kept", tasks),
                             {{"cancelled", tasks}});
    }
    if (flags.status) {
        const Json status = batch_status(flags.out);
        return session.print(status_text(status), status);
    }
    check_engine(flags);
    const Run run = session.run(0);
    BatchParams params;
    params.program = std::filesystem::read_symlink("/proc/self/exe");
    params.stage = flags.stage, params.quality = flags.scene->quality, params.flags = scene_flags(flags);
    params.jobs = flags.jobs, params.tries = flags.tries, params.threads = session.common.threads;
    if (flags.engine != "slurm") params.scratch = flags.scratch;
    if (flags.chunk >= 0) return make_chunk(flags, params, session, run);
    if (flags.engine == "slurm") return submit(flags, params, session, run);
    if (flags.engine == "manual") return prepare(flags, params, session, run);
    make_here(flags, params, session, run);
}

void add_cluster_flags(CLI::App& verb, const std::shared_ptr<BatchFlags>& flags) {
    verb.add_option("--engine", flags->engine,
                    "local: on this machine; slurm: as a job array; manual: only prepare chunks for a scheduler.")
        ->type_name("local|slurm|manual")
        ->check(one_of({"local", "slurm", "manual"}))
        ->capture_default_str();
    verb.add_option("--slurm-args", flags->slurm_arguments,
                    "Flags for sbatch; they override the estimates: \"--partition=long --time=120\".")
        ->type_name("TEXT");
    verb.add_option("--chunk-scenes", flags->chunk_scenes,
                    "Scenes per chunk; 0: as few as the limit on job arrays allows.")
        ->type_name("N")
        ->check(whole_number_within(0, 1000000))
        ->capture_default_str();
    verb.add_option("--scratch", flags->scratch, "Folder on a local disk: scenes are made there, then moved to --out.")
        ->type_name("DIR");
    verb.add_option("--chunk", flags->chunk, "Only make this chunk of the batch in --out; for schedulers to call.")
        ->type_name("N")
        ->check(whole_number_within(0, 1000000));
    verb.add_flag("--cancel", flags->cancel, "Only cancel the Slurm tasks of the batch in --out.");
}

}  // namespace

Verb add_batch(CLI::App& app) {
    auto flags = std::make_shared<BatchFlags>();
    CLI::App* verb = app.add_subcommand(
        "batch", "Makes many scenes, each in its own process; the same command resumes, and retries what failed.");
    verb->add_option("list", flags->list,
                     "One prompt per line; or .jsonl: objects with prompt and, optionally, seed, name, quality, flags.")
        ->type_name("FILE");
    verb->add_option("-o,--out", flags->out, "Folder of the scenes; index.html shows them all.")->type_name("DIR");
    verb->add_option("--count", flags->count, "Instead of a list: N generated prompts, covering all rooms and styles.")
        ->type_name("N")
        ->check(whole_number_within(1, 1000000));
    verb->add_option("--seed", flags->seed, "Seed of the first scene; it grows by 1 from scene to scene.")
        ->type_name("N")
        ->capture_default_str();
    verb->add_option("--stage", flags->stage, "make: scenes; panorama: only their panoramas.")
        ->type_name("make|panorama")
        ->check(one_of({"make", "panorama"}))
        ->capture_default_str();
    verb->add_option("--jobs,--parallel", flags->jobs,
                     "Scenes at a time, with Slurm tasks; 0: as many as cores and memory allow, with Slurm no limit.")
        ->type_name("N")
        ->check(whole_number_within(0, 100000))
        ->capture_default_str();
    verb->add_option("--tries", flags->tries, "Attempts per scene.")
        ->type_name("N")
        ->check(whole_number_within(1, 100))
        ->capture_default_str();
    verb->add_flag("--strict", flags->strict, "Stop at an invalid line instead of skipping it.");
    verb->add_flag("--status", flags->status, "Only report the progress of the batch in --out.");
    add_cluster_flags(*verb, flags);
    add_param_flags(*verb, flags->scene, "splat");
    verb->footer(
        "Examples:\n  fastscene batch prompts.txt -o out/rooms "
        "--quality draft\n  fastscene batch --count 100 -o out/hundred --splat-steps 800\n  fastscene batch "
        "prompts.txt -o /shared/rooms --engine slurm --slurm-args=--partition=long\n  fastscene batch /shared/rooms "
        "--status");
    flags->verb = verb;
    return {verb, [flags](const Session& session) { act(*flags, session); }};
}

}  // namespace fastscene::cli

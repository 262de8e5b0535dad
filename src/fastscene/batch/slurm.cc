#include "fastscene/batch/slurm.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <sstream>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/hash.h"
#include "fastscene/base/program.h"
#include "fastscene/batch/task_cost.h"
#include "fastscene/batch/manifest.h"
#include "fastscene/pipeline/run_folder.h"

namespace fastscene {

extern const std::string_view kSlurmScript;  // cluster/slurm/batch.sh

namespace {

namespace fs = std::filesystem;

constexpr int kTaskCores = 4;  // without --threads: more hardly speed up one scene
// Slurm reads both as text that it may split or replace.
constexpr const char* kBadInFolder = "\"\\\n%";
constexpr const char* kBadInScratch = "\"\\\n`";

struct Answer {
    int code = 0;
    std::string text;  // stdout and stderr
};

// Nothing if there is no such program.
std::optional<Answer> ask(const std::string& name, const std::vector<std::string>& arguments) {
    static std::atomic<int> count{0};
    const auto program = find_program(name);
    if (!program) return {};
    const fs::path log = fs::temp_directory_path() / fmt::format("fastscene-{}-{}-{}.log", name, ::getpid(), ++count);
    Answer answer;
    answer.code = run_program(*program, arguments, {log, {}, {}});
    answer.text = read_file(log);
    fs::remove(log);
    return answer;
}

std::string one_line(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

// Throws Error with Slurm's message if the command fails.
std::string demand(const std::string& name, const std::vector<std::string>& arguments) {
    const auto answer = ask(name, arguments);
    if (!answer) throw Error("--engine slurm: expected Slurm's programs on PATH, found no {}", name);
    if (answer->code != 0) throw Error("{}: {}", name, one_line(answer->text));
    return answer->text;
}

// By which tasks are found, those of a script that the user submitted as well.
std::string job_name(const fs::path& folder) {
    return "fastscene-" + Hash().add(fs::canonical(folder).string()).hex().substr(0, 12);
}

// How often each word occurs as the `place`th of a line.
std::map<std::string, int> words_of(const std::string& text, int place = 0) {
    std::map<std::string, int> out;
    std::istringstream lines(text);
    for (std::string line, word; std::getline(lines, line);) {
        std::istringstream words(line);
        int at = 0;
        while (at <= place && words >> word) ++at;
        if (at > place) ++out[word];
    }
    return out;
}

struct Queue {
    std::map<std::string, int> states, reasons;
};

// Nothing if squeue is not there or does not answer.
std::optional<Queue> queue_of(const fs::path& folder) {
    const auto answer = ask("squeue", {"--noheader", "--array", "--name=" + job_name(folder), "--format=%T %r"});
    if (!answer || answer->code != 0) return {};
    Queue queue{words_of(answer->text), words_of(answer->text, 1)};
    queue.reasons.erase("None");
    return queue;
}

int sum_of(const std::map<std::string, int>& counts) {
    int sum = 0;
    for (const auto& [state, count] : counts) sum += count;
    return sum;
}

int most_tasks() {
    std::istringstream lines(demand("scontrol", {"show", "config"}));
    for (std::string line, name, sign; std::getline(lines, line);) {
        int value = 0;
        std::istringstream words(line);
        if (!(words >> name >> sign >> value) || name != "MaxArraySize") continue;
        if (value < 2) throw Error("scontrol: expected a cluster with job arrays, found MaxArraySize = {}", value);
        return value - 1;  // the largest index
    }
    throw Error("scontrol show config: expected MaxArraySize, found none");
}

std::string shell_quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + "'";
}

std::string replaced(std::string text, const std::string& mark, const std::string& value) {
    for (std::size_t at = 0; (at = text.find(mark, at)) != std::string::npos; at += value.size())
        text.replace(at, mark.size(), value);
    return text;
}

std::string script_of(const std::vector<BatchScene>& scenes, const fs::path& folder, const BatchParams& params,
                      const SlurmParams& slurm, const ChunkPlan& plan) {
    const int cores = params.threads > 0 ? params.threads : kTaskCores;
    const TaskCost cost = task_cost(scenes, params.quality, plan.of_chunk);
    const std::string limit = slurm.tasks_at_a_time > 0 ? fmt::format("%{}", slurm.tasks_at_a_time) : "";
    const std::map<std::string, std::string> values{
        {"@NAME@", job_name(folder)},
        {"@ARRAY@", fmt::format("0-{}{}", plan.chunks() - 1, limit)},
        {"@CORES@", std::to_string(cores)},
        {"@MEMORY_MIB@", std::to_string(cost.memory_mib)},
        {"@MINUTES@", std::to_string(cost.minutes(cores))},
        {"@EXTRA@", slurm.arguments.empty() ? "" : "#SBATCH " + slurm.arguments + "\n"},
        {"@PROGRAM@", shell_quoted(params.program.string())},
        {"@FOLDER@", folder.string()},
        {"@FOLDER_QUOTED@", shell_quoted(folder.string())},
        {"@SCRATCH@", slurm.scratch}};
    std::string text(kSlurmScript);
    for (const auto& [mark, value] : values) text = replaced(std::move(text), mark, value);
    return text;
}

void check_texts(const fs::path& folder, const SlurmParams& slurm) {
    if (folder.string().find_first_of(kBadInFolder) != std::string::npos)
        throw UsageError("--out: expected a path without quotes, backslashes and percent signs, found {}",
                         folder.string());
    if (slurm.scratch.find_first_of(kBadInScratch) != std::string::npos)
        throw UsageError("--scratch: expected a path without quotes and backslashes, found {}", slurm.scratch);
    const std::size_t first = slurm.arguments.find_first_not_of(' ');
    if (slurm.arguments.find('\n') != std::string::npos ||
        (first != std::string::npos && slurm.arguments[first] != '-'))
        throw UsageError("--slurm-args: expected flags of sbatch, such as \"--partition=long\", found \"{}\"",
                         slurm.arguments);
}

// "17" or "17;cluster" on a line of its own, among warnings.
std::string job_id_in(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const std::string id = line.substr(0, line.find(';'));
        if (!id.empty() && std::all_of(id.begin(), id.end(), [](char c) { return c >= '0' && c <= '9'; })) return id;
    }
    throw Error("sbatch: expected the number of a job, found {}", one_line(text));
}

int requeues_in(const fs::path& folder) {
    int lines = 0;
    if (!fs::exists(folder / "tasks")) return 0;
    for (const auto& entry : fs::directory_iterator(folder / "tasks"))
        if (entry.path().extension() == ".requeues") {
            const std::string text = read_file(entry.path());
            lines += static_cast<int>(std::count(text.begin(), text.end(), '\n'));
        }
    return lines;
}

Json settings_of(const fs::path& folder) {
    const fs::path file = folder / "batch.json";
    return fs::exists(file) ? read_json(file) : Json::object();
}

}  // namespace

bool is_submitted(const fs::path& folder) { return settings_of(folder).contains("slurm_job"); }

std::optional<int> tasks_in_slurm(const fs::path& folder) {
    const auto queue = queue_of(folder);
    if (!queue) return {};
    return sum_of(queue->states);
}

SlurmJob submit_to_slurm(const std::vector<BatchScene>& scenes, const fs::path& given, const BatchParams& params,
                         const SlurmParams& slurm, const Run& run) {
    const fs::path folder = fs::absolute(given).lexically_normal();
    check_texts(folder, slurm);
    const int most = most_tasks();
    make_directories(folder);
    const FolderLock lock(folder);
    if (const int tasks = tasks_in_slurm(folder).value_or(0); tasks > 0)
        throw Error("{}: {} tasks of this batch are pending or running in Slurm; wait for them, or use --cancel",
                    folder.string(), tasks);
    const ChunkPlan plan = write_manifest(scenes, folder, params, slurm.chunk_scenes, most);
    SlurmJob job{{}, plan.scenes, plan.chunks()};
    if (plan.scenes == 0) return job;
    run.note(fmt::format("batch: {} scenes, {} already done; {} tasks of {} scenes", scenes.size(),
                         static_cast<int>(scenes.size()) - plan.scenes, plan.chunks(), plan.of_chunk));
    make_directories(folder / "slurm");
    make_directories(folder / "tasks");
    const fs::path script = folder / "slurm" / "batch.sh";
    write_file(script, std::string_view(script_of(scenes, folder, params, slurm, plan)));
    fs::permissions(script, fs::perms::owner_exec, fs::perm_options::add);
    job.id = job_id_in(demand("sbatch", {"--parsable", script.string()}));
    Json settings = settings_of(folder);
    settings["slurm_job"] = job.id;
    write_json(folder / "batch.json", settings);
    return job;
}

std::optional<Json> slurm_status(const fs::path& folder) {
    const Json settings = settings_of(folder);
    if (!settings.contains("slurm_job")) return {};
    const std::string id = settings.at("slurm_job");
    Json out{{"job", id}, {"source", "files"}, {"tasks", Json::object()}, {"requeues", requeues_in(folder)}};
    const auto queue = queue_of(folder);
    if (!queue) return out;
    out["source"] = "squeue", out["tasks"] = queue->states;
    if (!queue->reasons.empty()) out["reasons"] = queue->reasons;
    if (!queue->states.empty()) return out;
    // The queue forgets what has ended; the accounts, where a cluster keeps them, do not.
    const auto accounts = ask("sacct", {"--noheader", "--allocations", "--jobs=" + id, "--format=State%20"});
    if (accounts && accounts->code == 0) out["source"] = "sacct", out["tasks"] = words_of(accounts->text);
    return out;
}

int cancel_in_slurm(const fs::path& folder) {
    if (!is_submitted(folder))
        throw UsageError("{}: expected a batch that was submitted with --engine slurm, found none", folder.string());
    const std::string name = "--name=" + job_name(folder);
    const auto tasks = sum_of(words_of(demand("squeue", {"--noheader", "--array", name, "--format=%T"})));
    if (tasks > 0) demand("scancel", {name});
    return tasks;
}

}  // namespace fastscene

#include "fastscene/batch/batch.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "fastscene/base/file.h"
#include "fastscene/base/hash.h"
#include "fastscene/base/memory.h"
#include "fastscene/base/parallel.h"
#include "fastscene/base/program.h"
#include "fastscene/batch/index_page.h"
#include "fastscene/batch/manifest.h"
#include "fastscene/batch/slurm.h"
#include "fastscene/batch/workspace.h"
#include "fastscene/pipeline/build_info.h"
#include "fastscene/pipeline/run_folder.h"
#include "fastscene/pipeline/scene_cost.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

constexpr double kMemoryShare = 0.85;        // of the free memory that scenes may take
constexpr double kLongestWaitSeconds = 900;  // for another process that makes the scene: the longest at `standard`
constexpr double kIndexEverySeconds = 20;    // least time between two writes of the page

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

std::string quality_of(const BatchScene& scene, const BatchParams& params) {
    return scene.quality.empty() ? params.quality : scene.quality;
}

std::string key_of(const BatchScene& scene, const BatchParams& params) {
    Hash hash;
    hash.add(scene.prompt).add(scene.seed).add(quality_of(scene, params)).add(params.stage).add(program_version());
    for (const auto* flags : {&params.flags, &scene.flags})
        for (const std::string& flag : *flags) hash.add(flag);
    return hash.hex();
}

std::vector<std::string> arguments_of(const BatchScene& scene, const fs::path& out_folder, const BatchParams& params,
                                      int threads) {
    std::vector<std::string> out{params.stage, scene.prompt,
                                 "--seed",     std::to_string(scene.seed),
                                 "--quality",  quality_of(scene, params),
                                 "-o",         out_folder.string(),
                                 "--threads",  std::to_string(threads),
                                 "--progress", "none"};
    out.insert(out.end(), params.flags.begin(), params.flags.end());
    out.insert(out.end(), scene.flags.begin(), scene.flags.end());
    return out;
}

// The last line of the program's output that reports an error.
std::string error_in(const fs::path& log) {
    const std::string text = fs::exists(log) ? read_file(log) : "";
    std::string last, error;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        if (end > at) last = text.substr(at, end - at);
        if (last.starts_with("fastscene: ")) error = last.substr(11);
        at = end + 1;
    }
    return error.empty() ? last : error;
}

// Processes of a batch that was killed live on, and finish their scenes.
bool is_taken(const std::string& error) { return error.ends_with("another fastscene is working on this folder"); }

// The scenes of a batch in work, or those of a chunk.
class Engine {
  public:
    Engine(const std::vector<BatchScene>& scenes, fs::path folder, BatchJournal journal, const BatchParams& params,
           const Run& run)
        : folder_(std::move(folder)), params_(params), run_(run), journal_(std::move(journal)) {
        for (const BatchScene& scene : scenes)
            if (is_done(scene, params, journal_)) ++done_before_;
            else waiting_.push_back(&scene);
    }
    // Called with all records from time to time.
    std::function<void(const std::vector<BatchRecord>&)> show = [](const auto&) {};

    std::vector<BatchRecord> go() {
        const int jobs = std::min<int>(params_.jobs > 0 ? params_.jobs : jobs_that_fit(params_),
                                       std::max<int>(1, static_cast<int>(waiting_.size())));
        const int threads = std::max(1, (params_.threads > 0 ? params_.threads : thread_count()) / jobs);
        run_.note(fmt::format("batch: {} scenes, {} already done; {} at a time, {} threads each",
                              waiting_.size() + done_before_, done_before_, jobs, threads));
        progress_.emplace(run_, "batch", static_cast<std::int64_t>(waiting_.size()));
        {
            std::vector<std::jthread> workers;
            for (int i = 0; i < jobs; ++i) workers.emplace_back([this, threads] { work(threads); });
        }
        show(journal_.records());
        if (failure_) std::rethrow_exception(failure_);
        run_.check_stop();
        return journal_.records();
    }

  private:
    void work(int threads) try {
        for (std::size_t i = next_++; i < waiting_.size() && !run_.stop.stop_requested() && !failure_; i = next_++)
            note(make(*waiting_[i], threads));
    } catch (const Stopped&) {
    } catch (...) {
        const std::lock_guard lock(mutex_);
        if (!failure_) failure_ = std::current_exception();
    }

    BatchRecord make(const BatchScene& scene, int threads) {
        BatchRecord record{scene.name, scene.prompt, key_of(scene, params_), false, 0, 0, {}};
        const double start = seconds();
        Workspace space(folder_ / scene.name, params_.scratch);
        try {
            try_to_make(scene, space.path(), threads, record);
        } catch (const Stopped&) {
            space.bring_home();  // another machine may resume it
            throw;
        }
        space.bring_home();
        record.seconds = seconds() - start;
        return record;
    }

    void try_to_make(const BatchScene& scene, const fs::path& out_folder, int threads, BatchRecord& record) {
        const fs::path log = folder_ / (scene.name + ".log");
        const double start = seconds();
        while (!record.done && record.tries < params_.tries) {
            ++record.tries;
            std::error_code none;
            fs::remove(log, none);
            const int code = run_program(params_.program, arguments_of(scene, out_folder, params_, threads),
                                         {log, {}, run_.stop});
            record.done = code == 0;
            record.error = record.done ? "" : error_in(log);
            if (is_taken(record.error) && seconds() - start < kLongestWaitSeconds) {
                --record.tries;
                wait_a_moment();
                continue;
            }
            if (code != 2) continue;
            break;  // the request itself is wrong: a second attempt would fail the same way
        }
    }

    void wait_a_moment() const {
        run_.check_stop();
        std::this_thread::sleep_for(std::chrono::seconds(1));
    }

    void note(const BatchRecord& record) {
        const std::lock_guard lock(mutex_);
        journal_.add(record);
        if (!record.done) run_.warn(fmt::format("{}: {}", record.name, record.error));
        progress_->advance();
        if (seconds() - indexed_s_ < kIndexEverySeconds) return;
        indexed_s_ = seconds();
        show(journal_.records());
    }

    fs::path folder_;
    const BatchParams& params_;
    const Run& run_;
    BatchJournal journal_;
    std::vector<const BatchScene*> waiting_;
    std::size_t done_before_ = 0;
    std::optional<Progress> progress_;
    std::atomic<std::size_t> next_{0};
    std::mutex mutex_;  // of the journal
    std::exception_ptr failure_;
    double indexed_s_ = 0;
};

}  // namespace

int jobs_that_fit(const BatchParams& params) {
    const int cores = params.threads > 0 ? params.threads : thread_count();
    const std::int64_t free = available_memory();
    if (free <= 0) return cores;
    const double fit = kMemoryShare * static_cast<double>(free) / (scene_cost(params.quality).gib * (1 << 30));
    return std::clamp(static_cast<int>(fit), 1, cores);
}

bool is_done(const BatchScene& scene, const BatchParams& params, const BatchJournal& journal) {
    const BatchRecord* known = journal.find(scene.name);
    return known && known->done && known->key == key_of(scene, params);
}

std::vector<BatchRecord> run_batch(const std::vector<BatchScene>& scenes, const fs::path& folder,
                                   const BatchParams& params, const Run& run) {
    make_directories(folder);
    const FolderLock lock(folder);
    if (is_submitted(folder) && tasks_in_slurm(folder).value_or(0) > 0)
        throw Error("{}: tasks of this batch are pending or running in Slurm; wait for them, or use --cancel",
                    folder.string());
    collect_journals(folder);
    write_json(folder / "batch.json", batch_settings(static_cast<int>(scenes.size()), params));
    Engine engine(scenes, folder, BatchJournal(folder), params, run);
    engine.show = [&](const std::vector<BatchRecord>& records) { save_index(records, folder); };
    return engine.go();
}

std::vector<BatchRecord> run_chunk(const fs::path& folder, int number, const BatchParams& settings, const Run& run) {
    Chunk chunk = read_chunk(folder, number);
    chunk.params.program = settings.program, chunk.params.threads = settings.threads;
    chunk.params.scratch = settings.scratch;
    chunk.params.jobs = 1;  // the scheduler decides how much is done at a time
    make_directories(folder / "tasks");
    return Engine(chunk.scenes, folder, BatchJournal(folder / "tasks", fmt::format("{:06}.jsonl", number)),
                  chunk.params, run)
        .go();
}

Json batch_status(const fs::path& folder) {
    if (!fs::exists(folder / "batch.json"))
        throw UsageError("{}: expected the folder of a batch, found no batch.json", folder.string());
    const Json settings = read_json(folder / "batch.json");
    const std::vector<BatchRecord> records = all_records(folder).all();
    if (settings.contains("chunks") && ::access(folder.c_str(), W_OK) == 0) save_index(records, folder);
    int done = 0;
    double spent = 0;
    Json failures = Json::array();
    for (const BatchRecord& r : records) {
        done += r.done, spent += r.seconds;
        if (!r.done) failures.push_back({{"name", r.name}, {"error", r.error}});
    }
    Json out{{"done", done},
             {"failed", failures.size()},
             {"total", settings.value("scenes", -1)},
             {"seconds_a_scene", records.empty() ? 0 : spent / static_cast<double>(records.size())},
             {"failures", failures}};
    if (const auto slurm = slurm_status(folder)) out["slurm"] = *slurm;
    return out;
}

}  // namespace fastscene

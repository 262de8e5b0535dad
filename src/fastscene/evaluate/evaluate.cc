#include "fastscene/evaluate/evaluate.h"

#include <algorithm>

#include "fastscene/base/file.h"
#include "fastscene/evaluate/columns.h"
#include "fastscene/evaluate/job_events.h"
#include "fastscene/evaluate/measures.h"
#include "fastscene/evaluate/peers.h"
#include "fastscene/evaluate/rows.h"
#include "fastscene/evaluate/write.h"
#include "fastscene/metrics/images.h"
#include "fastscene/pipeline/build_info.h"
#include "fastscene/pipeline/stage_cache.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

struct Job {
    const SuiteVariant* variant;
    const SuiteScene* scene;
    std::uint64_t seed;
    fs::path place;     // below scenes/ and measured/
    double weight;      // of the time, in scenes made from nothing
    fs::path folder(const fs::path& out) const { return out / "scenes" / place; }
};

std::vector<Job> jobs_of(const Suite& suite, const EvaluateOptions& options, std::string_view last_stage) {
    std::vector<Job> jobs;
    const std::size_t scenes = options.scenes > 0 ? std::min<std::size_t>(suite.scenes.size(), static_cast<std::size_t>(options.scenes)) : suite.scenes.size();
    for (const SuiteVariant& variant : suite.variants)
        for (std::size_t i = 0; i < scenes; ++i)
            for (const std::uint64_t seed : suite.scenes[i].seeds) {
                const fs::path place = fs::path(slug_of(variant.name)) / fmt::format("{}-{}", suite.scenes[i].name, seed);
                const bool made = finished_stage(options.out / "scenes" / place, last_stage).has_value();
                jobs.push_back({&variant, &suite.scenes[i], seed, place, made ? 0.3 : 1});
            }
    return jobs;
}

// Variants of one scene mostly share its beginning: a finished stage of a sibling is tried first. Its key decides whether it fits.
void start_from_sibling(const std::vector<Job>& jobs, const Job& job, const fs::path& out) {
    const fs::path to = job.folder(out);
    if (fs::exists(to / "run.json")) return;
    for (const Job& other : jobs) {
        const fs::path from = other.folder(out);
        if (&other == &job || other.scene != job.scene || other.seed != job.seed || !finished_stage(from, "depth")) continue;
        make_directories(to);
        for (const std::string_view name : {"panorama", "depth"}) fs::copy(from / name, to / name, fs::copy_options::recursive);
        fs::copy_file(from / "run.json", to / "run.json");
        return;
    }
}

Sample cost_of(const Json& report) {
    return {"", "", {}, {{"minutes", report.at("seconds").get<double>() / 60}, {"cpu_minutes", report.at("cpu_seconds").get<double>() / 60},
                 {"memory_gb", report.at("peak_memory_bytes").get<double>() / 1e9}}, {}};
}

class Evaluation {
  public:
    Evaluation(const Suite& suite, const EvaluateOptions& options, const Run& run) : suite_(suite), options_(options), run_(run) {
        if (options_.weights.empty()) options_.weights = default_metrics_weights();
        const bool only_holes = suite.measures == std::vector<std::string>{"holes"};
        last_stage_ = only_holes ? "depth" : "splat";
        jobs_ = jobs_of(suite_, options_, last_stage_);
        for (const Job& job : jobs_) total_ += job.weight;
    }

    Json go() {
        std::vector<SuitePeer> peers = suite_.peers;
        peers.insert(peers.end(), options_.peers.begin(), options_.peers.end());
        for (const SuitePeer& peer : peers) check_peer(peer, suite_);
        std::size_t number = 0;
        for (const Job& job : jobs_) {
            run_.check_stop();
            JobEvents events(fmt::format("{} of {}", ++number, jobs_.size()), done_ / total_, job.weight / total_, run_.events);
            records_.push_back(record_of(job, Run{job.seed, &events, run_.stop}));
            done_ += job.weight;
            write();
        }
        for (const SuitePeer& peer : peers)
            for (Json& record : peer_records(peer, suite_, options_.out, options_.weights, run_)) records_.push_back(std::move(record));
        return write();
    }

  private:
    // Rows that differ in what comes after the panorama are judged by the same true pictures; another preset lights its room otherwise.
    std::filesystem::path truth_of(const Job& job) const { return options_.out / "truth" / fmt::format("{}-{}-{}", job.scene->name, job.seed, job.variant->quality); }

    Json record_of(const Job& job, const Run& run) {
        const RunFolder folder{job.folder(options_.out)};
        Json record{{"variant", job.variant->name}, {"kind", "ours"}, {"scene", job.scene->name}, {"seed", job.seed}, {"quality", job.variant->quality},
                    {"prompt", job.scene->source.prompt}, {"folder", fs::relative(folder.root, options_.out).generic_string()}};
        if (!job.scene->source.picture.empty()) record["picture"] = job.scene->source.picture.string();
        try {
            start_from_sibling(jobs_, job, options_.out);
            SceneRequest request{job.scene->source, job.variant->quality, job.variant->params, last_stage_, false};
            if (!request.source.picture.empty()) request.params.panorama.backend = "image";
            if (!request.source.weights.empty()) request.params.panorama.backend = "diffusion360";
            const Json report = make_scene(request, folder, run);
            const MeasureInputs inputs{&suite_, options_.out, options_.out / "measured" / job.place, truth_of(job), job.variant->bounds, options_.weights, job.scene->source.prompt};
            Measured measured = measure_scene(inputs, folder, run);
            measured.samples.push_back(cost_of(report));
            record.update(json_of(measured));
            record["panorama"] = fs::relative(folder.panorama_color(), options_.out).generic_string();
        } catch (const Error& e) {
            record["failed"] = e.what();
            run.warn(fmt::format("{}, seed {}: {}; the other scenes go on", job.scene->name, job.seed, e.what()));
        }
        return record;
    }

    Json write() const {
        Json results{{"suite", suite_.name}, {"title", suite_.title}, {"about", suite_.about}, {"notes", suite_.notes}, {"versions", build_json()},
                     {"scenes_done", records_.size()}, {"scenes_all", jobs_.size()}};
        Json shown = Json::array();
        for (const std::string& key : suite_.columns) {
            const Column& c = column_of(key);
            shown.push_back({{"key", c.key}, {"label", c.label}, {"unit", c.unit}, {"digits", c.digits}, {"about", c.about},
                             {"better", c.better == Better::higher ? "higher" : c.better == Better::lower ? "lower" : "neither"}});
        }
        results["columns"] = shown;
        results["rows"] = table_rows(suite_, records_);
        results["records"] = records_;
        write_results(options_.out, results);
        return results;
    }

    const Suite& suite_;
    EvaluateOptions options_;
    const Run& run_;
    std::string last_stage_;
    std::vector<Job> jobs_;
    double total_ = 0, done_ = 0;
    std::vector<Json> records_;
};

}  // namespace

Json evaluate(const Suite& suite, const EvaluateOptions& options, const Run& run) {
    make_directories(options.out);
    const FolderLock lock(options.out);
    return Evaluation(suite, options, run).go();
}

}  // namespace fastscene

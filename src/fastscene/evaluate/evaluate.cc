#include "fastscene/evaluate/evaluate.h"

#include <algorithm>
#include <optional>

#include "fastscene/base/file.h"
#include "fastscene/evaluate/columns.h"
#include "fastscene/evaluate/failure.h"
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
    fs::path place;  // relative to scenes/ and measured/
    double weight;   // relative duration, in scenes made from scratch
    fs::path folder(const fs::path& out) const { return scene->run.empty() ? out / "scenes" / place : scene->run; }
};

std::vector<Job> jobs_of(const Suite& suite, const fs::path& out, std::string_view last_stage) {
    std::vector<Job> jobs;
    for (const SuiteVariant& variant : suite.variants)
        for (const SuiteScene& scene : suite.scenes) {
            if (!scene.run.empty() && scene.variant != variant.name) continue;
            for (const std::uint64_t seed : scene.seeds) {
                Job job{&variant, &scene, seed,
                        fs::path(folder_name_of(variant.name)) / fmt::format("{}-{}", scene.name, seed), 1};
                if (finished_stage(job.folder(out), last_stage)) job.weight = 0.3;
                jobs.push_back(std::move(job));
            }
        }
    return jobs;
}

Suite first_scenes(Suite suite, int count) {
    if (count > 0 && static_cast<std::size_t>(count) < suite.scenes.size())
        suite.scenes.resize(static_cast<std::size_t>(count));
    return suite;
}

// Variants of a scene often share their first stages: a sibling's finished stages are copied first, and their keys
// decide whether they are valid.
void start_from_sibling(const std::vector<Job>& jobs, const Job& job, const fs::path& out) {
    const fs::path to = job.folder(out);
    if (fs::exists(to / "run.json")) return;
    for (const Job& other : jobs) {
        const fs::path from = other.folder(out);
        if (&other == &job || other.scene != job.scene || other.seed != job.seed || !finished_stage(from, "depth"))
            continue;
        make_directories(to);
        for (const std::string_view name : {"panorama", "depth"}) {
            fs::remove_all(to / name);  // left over from an interrupted copy
            fs::copy(from / name, to / name, fs::copy_options::recursive);
        }
        write_file(to / "run.json", read_file(from / "run.json"));  // last: its presence marks the copy as complete
        return;
    }
}

Sample cost_of(const Json& report) {
    Sample sample;
    sample.values = {{"minutes", report.at("seconds").get<double>() / 60},
                     {"cpu_minutes", report.at("cpu_seconds").get<double>() / 60},
                     {"memory_gb", report.at("peak_memory_bytes").get<double>() / 1e9}};
    return sample;
}

// For a run made elsewhere.
Json cost_of_stages(const RunFolder& folder) {
    Cost total;
    for (const std::string_view stage : kStages)
        if (const auto record = finished_stage(folder.root, stage)) {
            total.seconds += record->cost.seconds;
            total.cpu_seconds += record->cost.cpu_seconds;
            total.peak_memory_bytes = std::max(total.peak_memory_bytes, record->cost.peak_memory_bytes);
        }
    return {
        {"seconds", total.seconds}, {"cpu_seconds", total.cpu_seconds}, {"peak_memory_bytes", total.peak_memory_bytes}};
}

class Evaluation {
  public:
    Evaluation(const Suite& suite, const EvaluateOptions& options, const Run& run)
        : suite_(first_scenes(suite, options.scenes)),
          options_(options),
          run_(run),
          last_stage_(last_stage_of(suite)),
          peers_(suite.peers) {
        options_.weights = metrics_weights(options_.weights);
        jobs_ = jobs_of(suite_, options_.out, last_stage_);
        for (const Job& job : jobs_) total_ += job.weight;
        peers_.insert(peers_.end(), options_.peers.begin(), options_.peers.end());
        check_peers(peers_, suite_);
    }

    Json go() {
        std::size_t number = 0;
        for (const Job& job : jobs_) {
            run_.check_stop();
            JobEvents events(fmt::format("{} of {}", ++number, jobs_.size()), done_ / total_, job.weight / total_,
                             run_.events);
            records_.push_back(record_of(job, Run{job.seed, &events, run_.stop}));
            done_ += job.weight;
            write();
        }
        const PeerInputs inputs{suite_, options_.out, options_.weights,
                                [&](const SuiteScene& scene) { return own_run(scene); }};
        for (const SuitePeer& peer : peers_)
            for (Json& record : peer_records(peer, inputs, run_)) records_.push_back(std::move(record));
        return write();
    }

  private:
    // Rows that differ only after the panorama share the same ground truth; other presets light the room differently.
    fs::path truth_of(const Job& job) const {
        const std::string quality = job.scene->run.empty() ? job.variant->quality
                                                           : recorded_run({job.scene->run}).request.quality;
        return options_.out / "truth" / fmt::format("{}-{}-{}", job.scene->name, job.seed, quality);
    }
    std::optional<OwnRun> own_run(const SuiteScene& scene) const {
        for (const Job& job : jobs_)
            if (job.scene == &scene && finished_stage(job.folder(options_.out), last_stage_))
                return OwnRun{{job.folder(options_.out)}, truth_of(job)};
        return std::nullopt;
    }

    // Makes or resumes the scene; existing runs listed in the suite are left unchanged. Returns the cost report.
    Json make(const Job& job, const RunFolder& folder, const Run& run) const {
        if (!job.scene->run.empty()) return cost_of_stages(folder);
        start_from_sibling(jobs_, job, options_.out);
        SceneRequest request{job.scene->source, job.variant->quality, job.variant->params, last_stage_, false};
        request.params.panorama.backend = panorama_backend(request.source);
        return make_scene(request, folder, run);
    }

    Json record_of(const Job& job, const Run& run) {
        const RunFolder folder{job.folder(options_.out)};
        const bool given = !job.scene->run.empty();
        Json record{{"variant", job.variant->name},
                    {"kind", "ours"},
                    {"scene", job.scene->name},
                    {"seed", job.seed},
                    {"quality", job.variant->quality},
                    {"prompt", prompt_of(job.scene->source)},
                    {"folder", fs::relative(folder.root, options_.out).generic_string()}};
        if (const fs::path picture = picture_of(job.scene->source); !picture.empty())
            record["picture"] = picture.string();
        try {
            if (given) record["quality"] = recorded_run(folder).request.quality;
            const Json report = make(job, folder, run);
            const MeasureInputs inputs{
                &suite_, options_.out,     options_.out / "measured" / job.place, truth_of(job), job.variant->bounds,
                given,   options_.weights, prompt_of(job.scene->source)};
            Measured measured = measure_scene(inputs, folder, run);
            measured.samples.push_back(cost_of(report));
            record.update(json_of(measured));
            record["panorama"] = fs::relative(folder.panorama_color(), options_.out).generic_string();
        } catch (const Stopped&) {
            throw;
        } catch (const std::exception& e) {
            record["failed"] = failure_text(e);
            run.warn(
                fmt::format("{}, seed {}: {}; the other scenes go on", job.scene->name, job.seed, failure_text(e)));
        }
        return record;
    }

    Json write() const {
        Json results{{"suite", suite_.name},      {"title", suite_.title},
                     {"about", suite_.about},     {"notes", suite_.notes},
                     {"versions", build_json()},  {"scenes_done", std::min(records_.size(), jobs_.size())},
                     {"scenes_all", jobs_.size()}};
        Json shown = Json::array();
        for (const std::string& key : suite_.columns) {
            const Column& c = column_of(key);
            shown.push_back({{"key", c.key},
                             {"label", c.label},
                             {"unit", c.unit},
                             {"digits", c.digits},
                             {"about", c.about},
                             {"better", c.better == Better::higher  ? "higher"
                                        : c.better == Better::lower ? "lower"
                                                                    : "neither"}});
        }
        results["columns"] = shown;
        results["rows"] = table_rows(suite_, records_);
        results["parameters"] = parameters_used(suite_, records_);
        results["records"] = records_;
        write_results(options_.out, results);
        return results;
    }

    const Suite suite_;  // restricted to the selected scenes
    EvaluateOptions options_;
    const Run& run_;
    std::string last_stage_;
    std::vector<SuitePeer> peers_;
    std::vector<Job> jobs_;
    double total_ = 0, done_ = 0;
    std::vector<Json> records_;
};

}  // namespace

Json evaluate(const Suite& suite, const EvaluateOptions& options, const Run& run) {
    Evaluation evaluation(suite, options, run);  // validates before anything is written
    make_directories(options.out);
    const FolderLock lock(options.out);
    return evaluation.go();
}

}  // namespace fastscene

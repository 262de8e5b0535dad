#include "fastscene/pipeline/pipeline.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "fastscene/base/file.h"
#include "fastscene/base/hash.h"
#include "fastscene/base/parallel.h"
#include "fastscene/base/writable.h"
#include "fastscene/depth/estimator.h"
#include "fastscene/weights/weights.h"
#include "fastscene/pipeline/edited_run.h"
#include "fastscene/pipeline/find_earlier_run.h"
#include "fastscene/pipeline/earlier_splats.h"
#include "fastscene/pipeline/fit_report.h"
#include "fastscene/pipeline/health.h"
#include "fastscene/pipeline/build_info.h"
#include "fastscene/panorama/diffusion360.h"
#include "fastscene/rooms/pack.h"
#include "fastscene/pipeline/claim.h"
#include "fastscene/pipeline/resolve.h"
#include "fastscene/pipeline/run_files.h"
#include "fastscene/pipeline/share.h"
#include "fastscene/pipeline/source_check.h"
#include "fastscene/pipeline/splat_settings.h"
#include "fastscene/pipeline/stage_cache.h"
#include "fastscene/pipeline/stage_depth.h"
#include "fastscene/pipeline/stage_events.h"
#include "fastscene/pipeline/stage_panorama.h"
#include "fastscene/pipeline/stage_splat.h"
#include "fastscene/pipeline/stage_views.h"
#include "fastscene/pipeline/stage_walk.h"
#include "fastscene/pipeline/training_picture.h"
#include "fastscene/scene/walkable_json.h"
#include "fastscene/splat/backend.h"
#include "fastscene/trace/backend.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

// The stages in order: each depends on the results of all before it; stops after the last one requested.
class Stream {
  public:
    Stream(const RunFolder& folder, const SceneRequest& request, const std::string& identity, const Run& run)
        : folder_(folder), last_stage_(request.last_stage), run_(run), inputs_{identity} {
        // Another furniture pack gives another room.
        if (!std::holds_alternative<PictureSource>(request.source))
            if (const auto pack = furniture_pack(request.params.panorama)) inputs_.push_back(pack->fingerprint());
        const std::string& to = request.params.panorama.diffusion.upscale;
        if (const fs::path weights = weights_of(request.source); !weights.empty() && to != "none")
            inputs_.push_back(enlarger_identity(weights, to));
    }

    // `make` writes the stage's files into the given directory.
    void stage(std::string_view name, const Json& params,
               const std::function<void(const fs::path& out, const Run& run)>& make) {
        if (!done_.empty() && done_.back().name == last_stage_) return;
        StageEvents events(name, last_stage_, run_.events);
        const Run stage_run{run_.seed, &events, run_.stop};
        done_.push_back(run_stage(folder_.root, name, stage_key(name, params, inputs_, run_.seed), stage_run,
                                  [&](const fs::path& out) { make(out, stage_run); }));
        inputs_.push_back(done_.back().result);
        if (done_.back().skipped) run_.note(fmt::format("{}: already made", name));
    }
    const std::vector<StageRecord>& done() const { return done_; }

  private:
    const RunFolder& folder_;
    std::string last_stage_;
    const Run& run_;
    std::vector<std::string> inputs_;
    std::vector<StageRecord> done_;
};

Json report_of(const std::vector<StageRecord>& stages, const SceneRequest& request, const RunFolder& folder,
               const Run& run) {
    Json report;
    report["prompt"] = prompt_of(request.source);
    if (const fs::path picture = picture_of(request.source); !picture.empty()) report["picture"] = picture.string();
    report["seed"] = run.seed;
    report["quality"] = request.quality;
    report["versions"] = build_json();
    report["threads"] = thread_count();
    Cost total;
    Json costs = Json::object();
    for (const StageRecord& stage : stages) {
        costs[stage.name] = {{"seconds", stage.cost.seconds},
                             {"cpu_seconds", stage.cost.cpu_seconds},
                             {"peak_memory_bytes", stage.cost.peak_memory_bytes},
                             {"hash", stage.result}};
        total.seconds += stage.cost.seconds;
        total.cpu_seconds += stage.cost.cpu_seconds;
        total.peak_memory_bytes = std::max(total.peak_memory_bytes, stage.cost.peak_memory_bytes);
    }
    report["seconds"] = total.seconds;
    report["cpu_seconds"] = total.cpu_seconds;
    report["peak_memory_bytes"] = total.peak_memory_bytes;
    if (const std::string device = device_of_fit(folder.stage("splat")); !device.empty() && costs.contains("splat"))
        costs["splat"]["device"] = device;
    for (const char* const stage : {"panorama", "walk"})
        if (const std::string device = device_of_stage(folder.stage(stage)); !device.empty() && costs.contains(stage))
            costs[stage]["device"] = device;
    report["stages"] = costs;
    Json made = Json::array();
    for (const std::string& name : RunFolder::owned())
        if (name != "metrics" && (name == "report.json" || fs::exists(folder.root / name))) made.push_back(name);
    report["made"] = made;
    if (const auto area = walkable_in(folder)) report["walkable"] = walkable_json(*area);
    return report;
}

// The viewer and preview depend on the splats only; they are made again if those changed or a file is missing.
bool is_shared(const RunFolder& folder, const StageRecord& splat) {
    for (const fs::path& path :
         {folder.report_json(), folder.viewer_html(), folder.preview_jpg(), folder.credits_txt()})
        if (!fs::exists(path)) return false;
    try {
        return read_json(folder.report_json()).at("stages").at("splat").at("hash") == splat.result;
    } catch (const std::exception&) {
        return false;
    }
}

// As the last report says, if it is of the same files.
Json health_of_run(const Json& report, const RunFolder& folder, const Run& run) {
    const auto hashes = [](const Json& stages) {
        Json out;
        for (const auto& [name, stage] : stages.items()) out[name] = stage.at("hash");
        return out;
    };
    try {
        const Json last = fs::exists(folder.report_json()) ? read_json(folder.report_json()) : Json::object();
        if (last.contains("health") && hashes(last.at("stages")) == hashes(report.at("stages"))) {
            for (const Json& problem : last.at("health").at("problems")) run.warn(problem.get<std::string>());
            return last.at("health");
        }
    } catch (const std::exception&) {
        // foreign or damaged: looked at again
    }
    return check_health(folder, run);
}

// Checks files and memory needed by later stages: better to fail now than after an hour.
void check_later_stages(const SceneRequest& request, const RunFolder& folder) {
    const SceneParams& params = request.params;
    const auto reaches = [&](std::string_view stage) {
        return std::find(std::begin(kStages), std::end(kStages), stage) <=
               std::find(std::begin(kStages), std::end(kStages), request.last_stage);
    };
    // Finished stages may come from a machine with another card.
    const auto is_made = [&](const char* stage) {
        return reaches(stage) && (request.start_over || !fs::exists(folder.stage(stage)));
    };
    const TraceBackend& tracer = params.panorama.trace.backend;
    if (tracer.device == "list" || (has_room(request.source) && is_made("panorama")))
        check_device(tracer, "--panorama-trace-device");
    if (params.splat.backend.device == "list" || is_made("splat")) check_device(params.splat.backend, "--splat-device");
    if (reaches("depth") && !params.depth.weights.empty() && is_estimated(request.source, params.depth) &&
        !depth_backends_with_models(params.depth).empty())
        load_weights(params.depth.weights);
    if (reaches("walk")) check_walk(request.source, params.depth, params.walk);
    if (reaches("walk") && !params.walk.inpaint_weights.empty()) {
        const std::string name = walk_of(request.source, params.depth, params.walk).inpainter;
        const auto* inpainter = find_registered<InpaintBackend>(name);
        if (inpainter && !inpainter->model.empty()) load_weights(params.walk.inpaint_weights);
    }
    if (const std::string name = walk_of(request.source, params.depth, params.walk).inpainter; reaches("walk"))
        if (const auto* inpainter = find_registered<InpaintBackend>(name); inpainter && inpainter->runs_code)
            inpainter->make(params.walk.inpaint_weights, params.walk.device, params.walk.trusted);
    if (!reaches("splat")) return;
    check_splat_params(params.splat);
    if (!params.splat.checkpoint.empty()) check_writable(params.splat.checkpoint);
    // Existing splats may come from a machine with more memory.
    if (params.splat.per_m2 == 0 && (request.start_over || !fs::exists(folder.stage("splat"))))
        check_splat_memory(splat_of(request.source, params.depth, params.walk, params.splat),
                           static_cast<std::size_t>(params.views.points));
}

void claim(const RunFolder& folder, const SceneRequest& request, const Json& wanted) {
    const auto clash = [&](const Json& recorded) -> std::optional<std::string> {
        if (recorded.value("identity", "") == wanted.at("identity") &&
            recorded.value("seed", std::uint64_t{0}) == wanted.at("seed"))
            return {};
        return describe(recorded, wanted);
    };
    const Json recorded = fs::exists(folder.run_json()) ? read_json(folder.run_json()) : Json::object();
    claim_folder(folder, wanted, request.start_over, clash, describe(wanted, recorded));
}

Filler filler_of(const SceneRequest& request) {
    const WalkParams walk = walk_of(request.source, request.params.depth, request.params.walk);
    return {walk.inpainter, walk.inpaint_weights, walk.device, walk.trusted};
}

// The walk's inpainter fills what a partial panorama lacks, and only that.
Json panorama_settings(const SceneRequest& request, SourceFiles& files, const RunFolder& folder) {
    Json json = fields_json(request.params.panorama);
    const fs::path picture = picture_of(request.source);
    const bool partial = !picture.empty() && (files.has_picture(picture) ? !files.picture(picture).missing.empty()
                                                                         : fs::exists(folder.panorama_missing()));
    if (partial) {
        const Filler filler = filler_of(request);
        json["filled_by"] = {filler.inpainter, filler.weights};
    }
    return json;
}

}  // namespace

Json make_scene(const SceneRequest& request, const RunFolder& folder, const Run& run) {
    check_params(request.params);
    SourceFiles files(request.params.panorama.layout);
    const auto gone = request.start_over ? std::nullopt : gone_source(folder, request.source, files);
    if (gone) {
        depth_backend(request.source, request.params.depth);
        run.note(fmt::format("{} is missing: the run continues from what was made of it", gone->file.string()));
    } else {
        check_source(request.source, request.params, request.last_stage, files, run);
    }
    check_later_stages(request, folder);
    make_directories(folder.root);
    const FolderLock lock(folder.root);
    resume_finishing_edit(folder);
    const Json wanted = json_of_request(request, run.seed, files, gone);
    claim(folder, request, wanted);
    files.drop_bytes();

    const SceneSource& source = request.source;
    const SceneParams& params = request.params;
    Stream stream(folder, request, wanted.at("identity").get<std::string>(), run);
    std::shared_ptr<const TracedRoom> room;          // kept for a walk that renders the room again
    std::optional<std::optional<EarlierRun>> found;  // looked for by the first stage that is made
    const auto earlier = [&](const Run& r) {
        if (!found) found = find_earlier_run(request, r);
        return *found ? &**found : nullptr;
    };
    stream.stage("panorama", panorama_settings(request, files, folder), [&](const fs::path& out, const Run& r) {
        auto made = make_panorama(source, params.panorama, filler_of(request), files, earlier(r), out, r);
        if (looks_into_room(walk_of(source, params.depth, params.walk))) room = std::move(made);
    });
    files.drop_pictures();
    stream.stage("depth", fields_json(params.depth), [&](const fs::path& out, const Run& r) {
        make_depth(source, params.panorama, params.depth, files, folder, out, r);
    });
    stream.stage("walk", fields_json(params.walk), [&](const fs::path& out, const Run& r) {
        make_walk(source, params.panorama, params.depth, folder, params.walk, std::move(room), earlier(r), out, r);
    });
    stream.stage("views", fields_json(params.views),
                 [&](const fs::path& out, const Run& r) { make_views(folder, params.views, out, r); });
    const SplatParams splat = splat_of(source, params.depth, params.walk, params.splat);
    stream.stage("splat", fields_json(splat), [&](const fs::path& out, const Run& r) {
        const BeginSplats begin = [&](const std::vector<SurfacePoint>& points, const SplatParams& sized) {
            std::optional<Splats> splats;
            if (const EarlierRun* before = earlier(r)) splats = earlier_splats(*before, folder, points, sized, r);
            found.reset();  // its room's memory is needed for training
            return splats;
        };
        make_splat(folder, splat, begin, out, r,
                   pictures_of_training(folder, preview_camera(folder, kTrainingWidth, kTrainingHeight), r));
    });

    const std::vector<StageRecord>& done = stream.done();
    if (done.back().name == "splat" && !is_shared(folder, done.back())) {
        run.check_stop();
        share_scene(folder, title_of(source), run);
    } else if (done.back().name != "splat" && fs::exists(folder.room_json())) {
        write_credits(folder);
    }
    Json report = report_of(done, request, folder, run);
    report["health"] = health_of_run(report, folder, run);
    write_json(folder.report_json(), report);
    return report;
}

}  // namespace fastscene

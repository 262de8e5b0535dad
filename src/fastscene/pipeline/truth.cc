#include "fastscene/pipeline/truth.h"

#include <algorithm>

#include "fastscene/base/file.h"
#include "fastscene/image/color.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/splat_io.h"
#include "fastscene/pipeline/request.h"
#include "fastscene/pipeline/room_of_run.h"
#include "fastscene/pipeline/run_files.h"
#include "fastscene/pipeline/splat_settings.h"
#include "fastscene/pipeline/stage_cache.h"

namespace fastscene {
namespace {

Json previous_report(const std::filesystem::path& path) {
    if (!std::filesystem::exists(path)) return Json::object();
    try {
        return read_json(path);
    } catch (const Error&) {
        return Json::object();  // an invalid report is replaced
    }
}

}  // namespace

struct RunTruth::Impl {
    RunFolder folder;
    std::filesystem::path kept;
    const Run& run;
    RecordedRun recorded;
    StageRecord walk;
    std::shared_ptr<const TracedRoom> room;
    int lit_samples = 0;

    // The room, lit as for the panorama; with more samples if the ground truth asks for them. Never with the light that
    // the run keeps: an edited run's is only nearly that of its room.
    const TracedRoom& lit_room(int samples) {
        if (!room || lit_samples != samples) {
            room = newly_lit_room_of_run(folder, recorded, samples, run);
            lit_samples = samples;
        }
        return *room;
    }

    TruthSet truth_set(const TruthParams& params) {
        // The panorama's key stands for the program version that rendered it.
        const std::string result = finished_stage(folder.root, "panorama").value_or(StageRecord{}).result;
        TruthParams asked = params;
        asked.bounds = false;
        if (asked.where == "room") asked.radius_m = TruthParams{}.radius_m;  // ignored
        const Json what{
            {"truth", fields_json(asked)}, {"prompt", prompt_of(recorded.request.source)}, {"room", recorded.seed}};
        const std::string key = stage_key("metrics", what, {result}, run.seed);
        const std::string name = params.where == "room" ? "room" : fmt::format("radius-{}", params.radius_m);
        make_directories(kept);
        const auto make = [&](const std::filesystem::path& out) {
            save_truth_set(out, make_truth_set(lit_room(params.samples), params, run));
        };
        run_stage(kept, name, key, run, make);
        return load_truth_set(kept / name);
    }
};

RunTruth::RunTruth(const std::filesystem::path& run_dir, std::filesystem::path kept, const Run& run) {
    const RunFolder folder{run_dir};
    const RecordedRun recorded = recorded_run(folder);
    if (!has_room(recorded.request.source))
        throw UsageError(
            "{}: expected a scene from a prompt: a picture has no known room to compare with; use `splat DIR "
            "--splat-eval-every N` to hold out views instead",
            run_dir.string());
    const auto walk = finished_stage(folder.root, "walk"), splat = finished_stage(folder.root, "splat");
    if (!walk || !splat)
        throw UsageError(
            "{}: expected a finished run (run.json … splat/scene.ply), found none: run `fastscene make` first",
            run_dir.string());
    if (kept.empty()) kept = folder.metrics() / "kept";
    impl_ = std::make_unique<Impl>(Impl{folder, std::move(kept), run, recorded, *walk, nullptr, 0});
}

RunTruth::~RunTruth() = default;

Json RunTruth::measure(const TruthParams& params, const std::filesystem::path& splats, const std::filesystem::path& out,
                       const SplatBackend& backend) {
    const RunFolder& folder = impl_->folder;
    const std::filesystem::path to = out.empty() ? folder.metrics() : out;
    const SceneParams& settings = impl_->recorded.request.params;
    TruthInputs inputs;
    inputs.truth = impl_->truth_set(params);
    inputs.room = [&]() -> const TracedRoom& { return impl_->lit_room(params.samples); };
    inputs.first = load_first_panorama(folder);
    inputs.first.range = inputs.first.seen_range();  // as the true panoramas have it
    inputs.world_from_pano = load_walk_poses(folder);
    inputs.walked = [&] {
        std::vector<ImageRgb8> colors;
        for (const Panorama& p : load_walk(folder)) colors.push_back(srgb8_from_linear(p.color));
        return colors;
    };
    inputs.splats = splats.empty() ? load_splat_ply(folder.scene_ply()) : load_splats(splats).splats;
    inputs.backend = backend;
    inputs.views = settings.views;
    inputs.splat = splat_of(impl_->recorded.request.source, settings.depth, settings.walk, settings.splat);
    inputs.shot = panorama_parts(panorama_of_run(impl_->recorded, params.samples).trace);
    inputs.key = stage_key("metrics", json_of_params(settings), {impl_->walk.result}, impl_->recorded.seed);
    const Json truth = measure_truth(inputs, params, to, impl_->run);

    Json report = previous_report(to / "report.json");
    report["truth"] = truth;
    if (params.where == "room") report["truth_of_room"] = truth;
    else report["truth_by_radius"][fmt::format("{}", params.radius_m)] = truth;
    write_json(to / "report.json", report);
    return report;
}

Json measure_run(const std::filesystem::path& run_dir, const TruthParams& params, const Run& run,
                 const SplatBackend& backend) {
    return RunTruth(run_dir, {}, run).measure(params, {}, {}, backend);
}

}  // namespace fastscene

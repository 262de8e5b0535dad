#include "fastscene/pipeline/truth.h"

#include <algorithm>

#include "fastscene/base/file.h"
#include "fastscene/io/splat_io.h"
#include "fastscene/pipeline/pipeline.h"
#include "fastscene/pipeline/stage_cache.h"

namespace fastscene {
namespace {

Json previous_report(const std::filesystem::path& path) {
    if (!std::filesystem::exists(path)) return Json::object();
    try {
        return read_json(path);
    } catch (const Error&) {
        return Json::object();  // a broken report is written anew
    }
}

}  // namespace

Json measure_run(const std::filesystem::path& run_dir, const TruthParams& params, const Run& run) {
    const RunFolder folder{run_dir};
    const RecordedRun recorded = recorded_run(folder);
    const SceneRequest& request = recorded.request;
    if (!request.source.has_room())
        throw UsageError("{}: expected a scene from a prompt: behind a picture there is no room to compare with", run_dir.string());
    const auto walk = finished_stage(folder.root, "walk"), splat = finished_stage(folder.root, "splat");
    if (!walk || !splat) throw UsageError("{}: expected a finished run (run.json … splat/scene.ply), found none: run `fastscene make` first", run_dir.string());

    // The same room under the same light as the panorama; a truth that asks for more samples gets them.
    const Run room_run{recorded.seed, run.events, run.stop};
    PanoramaParams panorama = request.params.panorama;
    panorama.trace.cell_samples = std::max(panorama.trace.cell_samples, params.samples);
    PromptSpec prompt = read_prompt(request.source.prompt, panorama);
    const auto room = make_traced_room(prompt, panorama, room_run);

    TruthInputs inputs;
    inputs.room = room.get();
    inputs.first = load_first_panorama(folder);
    inputs.world_from_pano = load_walk_poses(folder);
    inputs.splats = load_splat_ply(folder.scene_ply());
    inputs.views = request.params.views;
    inputs.splat = request.params.splat;
    inputs.shot = panorama_parts(panorama.trace);
    inputs.key = stage_key("metrics", json_of_params(request.params), {walk->result}, recorded.seed);
    const Json truth = measure_truth(inputs, params, folder.metrics(), run);

    Json report = previous_report(folder.metrics() / "report.json");
    report["truth"] = truth;
    report["truth_by_radius"][fmt::format("{}", params.radius_m)] = truth;
    write_json(folder.metrics() / "report.json", report);
    return report;
}

}  // namespace fastscene

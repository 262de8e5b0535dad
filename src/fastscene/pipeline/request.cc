#include "fastscene/pipeline/request.h"

#include "fastscene/base/error.h"
#include "fastscene/pipeline/build_info.h"
#include "fastscene/pipeline/edited_run.h"

namespace fastscene {
namespace fs = std::filesystem;

Json json_of_request(const SceneRequest& request, std::uint64_t seed, SourceFiles& files,
                     const std::optional<GoneSource>& gone) {
    Json json = json_of_source(request.source);
    json["identity"] = gone ? gone->record.at("identity") : Json(identity_of(request.source, files));
    json["contents"] = gone ? gone->record.at("contents") : contents_of(request.source, files);
    json["seed"] = seed;
    json["quality"] = request.quality;
    json["params"] = json_of_params(request.params);
    json["versions"] = build_json();
    return json;
}

RecordedRun recorded_run(const RunFolder& folder) {
    if (is_edit_half_finished(folder)) {
        const FolderLock lock(folder.root);
        resume_finishing_edit(folder);
    }
    if (!fs::exists(folder.run_json()))
        throw UsageError(
            "{}: expected the folder of a run, found no run.json; make one with `fastscene make \"…\" -o {}`",
            folder.root.string(), folder.root.string());
    const Json json = read_json(folder.run_json());
    if (json.contains("capture"))
        throw UsageError(
            "{}: expected a run from a prompt or a panorama, found splats of photographs: only splat, render and view "
            "go on with those",
            folder.root.string());
    try {
        RecordedRun recorded;
        recorded.request.source = source_from_json(json);
        recorded.request.quality = json.at("quality");
        recorded.request.params = params_from_json(json.at("params"), params_of_quality(recorded.request.quality));
        recorded.seed = json.at("seed");
        return recorded;
    } catch (const Json::exception& e) {
        throw Error("{}: expected prompt, quality, params and seed: {}", folder.run_json().string(), e.what());
    } catch (const Error& e) {  // prefixes the file, since the error may concern any run
        if (!std::string_view(e.what()).starts_with("run.json: ")) throw;
        throw Error("{}", (folder.root / e.what()).string());
    }
}

}  // namespace fastscene

#include "fastscene/pipeline/find_earlier_run.h"

#include "fastscene/base/hash.h"
#include "fastscene/pipeline/room_of_run.h"
#include "fastscene/pipeline/run_files.h"
#include "fastscene/pipeline/stage_cache.h"

namespace fastscene {
namespace fs = std::filesystem;

std::string hash_of_run(const RunFolder& folder) {
    Hash hash;
    for (const std::string_view stage : kStages)
        if (const auto record = finished_stage(folder.root, stage)) hash.add(stage).add(record->result);
    return hash.hex();
}

DocumentSource edit_of(DocumentSource document, const RunFolder& folder) {
    document.edited_from = folder.root;
    document.edited_from_hash = hash_of_run(folder);
    return document;
}

namespace {

// What is kept is as near to the truth as the eye needs, by each edit again: after so many all is rendered.
constexpr int kMostEdits = 8;

int edits_of(const RunFolder& folder) { return about_of_stage(folder.stage("panorama")).value("edits", 0); }

// Why the run cannot be begun from; empty: it can.
std::string obstacle(const RunFolder& folder, const DocumentSource& source, const SceneRequest& request) {
    if (!fs::exists(folder.run_json())) return "it no longer exists";
    if (hash_of_run(folder) != source.edited_from_hash) return "it has been remade since";
    if (request.params.panorama.trace.backend.name != TraceBackend{}.name)
        return "with a graphics card no light is kept";
    if (!fs::exists(folder.room_light())) return "it keeps no light: an older version made it";
    if (edits_of(folder) >= kMostEdits) return fmt::format("it has been edited {} times", kMostEdits);
    const RecordedRun recorded = recorded_run(folder);
    const auto settings = [](const SceneParams& p) {
        return fields_json(p.panorama).dump() + fields_json(p.depth).dump() + fields_json(p.walk).dump();
    };
    if (settings(recorded.request.params) != settings(request.params)) return "it has other settings";
    return {};
}

}  // namespace

std::optional<EarlierRun> find_earlier_run(const SceneRequest& request, const Run& run) {
    const auto* source = std::get_if<DocumentSource>(&request.source);
    if (!source || source->edited_from.empty()) return {};
    EarlierRun out;
    out.folder = {source->edited_from};
    out.edits = 1 + edits_of(out.folder);
    const auto nothing = [&](const std::string& why) {
        run.note(fmt::format("{}: the scene is made without it: {}", source->edited_from.string(), why));
        return std::nullopt;
    };
    try {
        if (const std::string why = obstacle(out.folder, *source, request); !why.empty()) return nothing(why);
        const Run quiet{run.seed, nullptr, run.stop};
        out.room = room_with_kept_light(out.folder, recorded_run(out.folder), quiet);
        out.change = change_between(out.room->room(),
                                    make_unlit_room(origin_of(request.source), request.params.panorama, quiet).room());
    } catch (const Error& e) {
        return nothing(e.what());
    }
    if (out.change.lights) return nothing("the edit changes lamps, windows or the outside");
    return out;
}

}  // namespace fastscene

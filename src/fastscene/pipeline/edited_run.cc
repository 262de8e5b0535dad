#include "fastscene/pipeline/edited_run.h"

#include <algorithm>

#include "fastscene/rooms/document.h"

namespace fastscene {
namespace fs = std::filesystem;

RoomDocument document_of_run(const RunFolder& folder, const RecordedRun& recorded, const Run& run) {
    if (!has_room(recorded.request.source))
        throw UsageError("{}: expected a scene from a prompt or a room: {} has no known room to edit",
                         folder.root.string(), what_is_behind(recorded.request.source));
    if (fs::exists(folder.room_json()) && read_json(folder.room_json()).contains("format"))
        return load_document(folder.room_json());
    return document_of(known_room(origin_of(recorded.request.source), recorded.request.params.panorama,
                                  {recorded.seed, run.events, run.stop}));
}

RunFolder unfinished_edit(const RunFolder& folder) { return {folder.root / ".edit.unfinished"}; }

void finish_edit(const RunFolder& folder) {
    const RunFolder made = unfinished_edit(folder);
    const FolderLock lock(folder.root);
    try {
        // The record last: whoever is killed before finds the earlier run, some of whose stages are to be made again.
        std::vector<std::string> names = RunFolder::owned();
        std::partition(names.begin(), names.end(),
                       [&](const std::string& name) { return name != folder.run_json().filename(); });
        for (const std::string& name : names) {
            fs::remove_all(folder.root / name);
            if (fs::exists(made.root / name)) fs::rename(made.root / name, folder.root / name);
        }
        fs::remove_all(made.root);
    } catch (const fs::filesystem_error& e) {
        throw Error("{}: cannot be written: {}", folder.root.string(), e.code().message());
    }
}

std::string_view last_finished_stage(const RunFolder& folder) {
    std::string_view last = "panorama";
    for (const std::string_view stage : kStages)
        if (fs::exists(folder.stage(stage) / "stage.json")) last = stage;
    return last;
}

}  // namespace fastscene

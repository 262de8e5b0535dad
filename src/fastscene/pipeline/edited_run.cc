#include "fastscene/pipeline/edited_run.h"

#include <algorithm>

#include "fastscene/base/file.h"
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

namespace {

// In unfinished_edit: what is to be moved, and the files that it replaces.
constexpr const char *kComplete = "complete.json", *kReplaced = "replaced";

}  // namespace

void finish_edit(const RunFolder& folder, const std::string& command) {
    const RunFolder made = unfinished_edit(folder);
    fs::remove_all(made.root / kReplaced);  // of an edit that was interrupted after its last rename
    Json names = Json::array();
    for (const std::string& name : RunFolder::owned())
        if (fs::exists(made.root / name)) names.push_back(name);
    write_json(made.root / kComplete, {{"command", command}, {"names", names}});
    resume_finishing_edit(folder);
}

bool is_edit_half_finished(const RunFolder& folder) { return fs::exists(unfinished_edit(folder).root / kComplete); }

std::optional<std::string> resume_finishing_edit(const RunFolder& folder) {
    if (!is_edit_half_finished(folder)) return {};
    const RunFolder made = unfinished_edit(folder);
    const Json complete = read_json(made.root / kComplete);
    const auto is_moved = [&](const std::string& name) {
        const Json& names = complete.at("names");
        return std::find(names.begin(), names.end(), Json(name)) != names.end();
    };
    try {
        // Renames only, so that there is hardly a moment between; the old files are removed with the folder.
        const fs::path old = made.root / kReplaced;
        make_directories(old);
        for (const std::string& name : RunFolder::owned()) {
            const bool comes = is_moved(name);
            if (comes && !fs::exists(made.root / name)) continue;  // was moved before the interruption
            if (fs::exists(folder.root / name)) fs::rename(folder.root / name, old / name);
            if (comes) fs::rename(made.root / name, folder.root / name);
        }
        fs::remove(made.root / kComplete);
        fs::remove_all(made.root);
    } catch (const fs::filesystem_error& e) {
        throw Error("{}: cannot be written: {}", folder.root.string(), e.code().message());
    }
    return complete.at("command").get<std::string>();
}

std::string_view last_finished_stage(const RunFolder& folder) {
    std::string_view last = "panorama";
    for (const std::string_view stage : kStages)
        if (fs::exists(folder.stage(stage) / "stage.json")) last = stage;
    return last;
}

}  // namespace fastscene

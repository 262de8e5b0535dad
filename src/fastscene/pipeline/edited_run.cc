#include "fastscene/pipeline/edited_run.h"

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

std::string_view last_finished_stage(const RunFolder& folder) {
    std::string_view last = "panorama";
    for (const std::string_view stage : kStages)
        if (fs::exists(folder.stage(stage) / "stage.json")) last = stage;
    return last;
}

}  // namespace fastscene

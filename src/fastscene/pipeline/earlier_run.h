// The run that an edited one begins from. What an edit leaves as it was is taken over from it: light, pixels, splats.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "fastscene/pipeline/request.h"
#include "fastscene/trace/room_change.h"
#include "fastscene/trace/trace.h"

namespace fastscene {

// Of the results of a run's stages.
std::string hash_of_run(const RunFolder& folder);
// The source of a run that begins from `folder`.
DocumentSource edit_of(DocumentSource document, const RunFolder& folder);

struct EarlierRun {
    RunFolder folder;
    std::shared_ptr<const TracedRoom> room;  // lit
    RoomChange change;                       // what the edit changes
};
// Nothing if the source is no edit of a run. Nothing with a note, which says why, if that run is gone or was made again
// since, has other settings or another room in this version, or if the edit changes the light of all.
std::optional<EarlierRun> find_earlier_run(const SceneRequest& request, const Run& run);

}  // namespace fastscene

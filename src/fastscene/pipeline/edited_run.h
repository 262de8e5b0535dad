// The room of a run as a document, to be edited.
#pragma once

#include <string_view>

#include "fastscene/pipeline/request.h"

namespace fastscene {

// Of panorama/room.json; of a run that an older version made, from its prompt. Throws UsageError for scenes of pictures
// and photographs, which have no known room.
RoomDocument document_of_run(const RunFolder& folder, const RecordedRun& recorded, const Run& run);
// Where an edited run is made before it takes the place of the run it is an edit of: within that run's folder.
RunFolder unfinished_edit(const RunFolder& folder);
// Moves it there. What else is in the folder stays.
void finish_edit(const RunFolder& folder);
// "splat" of a whole scene; at least "panorama".
std::string_view last_finished_stage(const RunFolder& folder);

}  // namespace fastscene

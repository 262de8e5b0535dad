// The room of a run as a document, to be edited.
#pragma once

#include <string_view>

#include "fastscene/pipeline/request.h"

namespace fastscene {

// Of panorama/room.json; of a run that an older version made, from its prompt. Throws UsageError for scenes of pictures
// and photographs, which have no known room.
RoomDocument document_of_run(const RunFolder& folder, const RecordedRun& recorded, const Run& run);
// "splat" of a whole scene; at least "panorama".
std::string_view last_finished_stage(const RunFolder& folder);

}  // namespace fastscene

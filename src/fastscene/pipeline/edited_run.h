// The room of a run as a document, to be edited.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "fastscene/pipeline/request.h"

namespace fastscene {

// Of panorama/room.json; of a run that an older version made, from its prompt. Throws UsageError for scenes of pictures
// and photographs, which have no known room.
RoomDocument document_of_run(const RunFolder& folder, const RecordedRun& recorded, const Run& run);
// Where an edit in place is made: within the folder of the run that it replaces.
RunFolder unfinished_edit(const RunFolder& folder);
// Replaces the run by the complete one in unfinished_edit; what else is in the folder stays. `command`: what asked for
// the edit. The caller holds the folder's lock.
void finish_edit(const RunFolder& folder, const std::string& command);
// Whether that was interrupted.
bool is_edit_half_finished(const RunFolder& folder);
// Goes on with a finish_edit that was interrupted, and returns its command; nothing if none was.
std::optional<std::string> resume_finishing_edit(const RunFolder& folder);
// "splat" of a whole scene; at least "panorama".
std::string_view last_finished_stage(const RunFolder& folder);

}  // namespace fastscene

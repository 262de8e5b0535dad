// Recreates the room of a run from its prompt, lit as for its panorama.
#pragma once

#include <memory>

#include "fastscene/pipeline/request.h"

namespace fastscene {

// Lit with the light that the run keeps, or gathered anew if it keeps none. Throws UsageError if the run has no known
// room, Error if this version of the program would make another room than the run's.
std::shared_ptr<const TracedRoom> room_of_run(const RunFolder& folder, const RecordedRun& recorded, const Run& run);
// The same with its light gathered anew, for ground truth. `least_cell_samples`: minimum light paths per cell, if more
// are wanted than in the run's settings.
std::shared_ptr<const TracedRoom> newly_lit_room_of_run(const RunFolder& folder, const RecordedRun& recorded,
                                                        int least_cell_samples, const Run& run);
// The same with the run's light, or not at all: throws Error if that is of another room or settings, or damaged.
std::shared_ptr<const TracedRoom> room_with_kept_light(const RunFolder& folder, const RecordedRun& recorded,
                                                       const Run& run);
// The same room without its light, in a fraction of a second.
std::shared_ptr<const TracedRoom> unlit_room_of_run(const RunFolder& folder, const RecordedRun& recorded,
                                                    const Run& run);
// Render settings of that room's panoramas with that many light paths.
PanoramaParams panorama_of_run(const RecordedRun& recorded, int least_cell_samples);

}  // namespace fastscene

// The room behind a run from a prompt: made and lit again as its panorama saw it.
#pragma once

#include <memory>

#include "fastscene/pipeline/request.h"

namespace fastscene {

// `least_cell_samples`: light paths a cell, where more are wanted than the run's own settings say. Throws UsageError
// when the run has no room behind it, Error when this program would make another room than the run's.
std::shared_ptr<const TracedRoom> room_of_run(const RunFolder& folder, const RecordedRun& recorded,
                                              int least_cell_samples, const Run& run);
// How that room's panoramas are shot with so many light paths.
PanoramaParams panorama_of_run(const RecordedRun& recorded, int least_cell_samples);

}  // namespace fastscene

// The panorama as it meets the disk. A stage always starts from files, even right after they were made: a color that
// went through 8 bits is not the color before it, and a resumed run must end in the same bytes.
#pragma once

#include <filesystem>
#include <memory>

#include "fastscene/panorama/panorama.h"
#include "fastscene/pipeline/run_folder.h"
#include "fastscene/pipeline/source.h"
#include "fastscene/pipeline/source_files.h"
#include "fastscene/trace/trace.h"

namespace fastscene {

// Writes the files of the stage into `out` (run_folder.h has their names), as every stage does. Returns the room that
// was traced, lit, for a walk that wants to look into it; null where there is none.
std::shared_ptr<const TracedRoom> make_panorama(const SceneSource& source, const PanoramaParams& params,
                                                SourceFiles& files, const std::filesystem::path& out, const Run& run);

}  // namespace fastscene

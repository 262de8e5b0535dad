// The panorama stage. Stages always start from files, even right after they were written: quantization to 8 bits
// changes colors, and a resumed run must give the same bytes.
#pragma once

#include <filesystem>
#include <memory>

#include "fastscene/panorama/panorama.h"
#include "fastscene/pipeline/fill_missing.h"
#include "fastscene/pipeline/run_folder.h"
#include "fastscene/pipeline/source.h"
#include "fastscene/pipeline/source_files.h"
#include "fastscene/trace/trace.h"

namespace fastscene {

struct EarlierRun;

// Writes the stage's files into `out` (names in run_folder.h). Returns the traced and lit room, for a walk that renders
// it again; null if there is none.
// `filler`: for what a partial panorama lacks.
std::shared_ptr<const TracedRoom> make_panorama(const SceneSource& source, const PanoramaParams& params,
                                                const Filler& filler, SourceFiles& files, const EarlierRun* earlier,
                                                const std::filesystem::path& out, const Run& run);

}  // namespace fastscene

// Validates a source before minutes are spent on it.
#pragma once

#include <string>

#include "fastscene/base/run.h"
#include "fastscene/pipeline/quality.h"
#include "fastscene/pipeline/source.h"
#include "fastscene/pipeline/source_files.h"

namespace fastscene {

// Reads the source as far as needed to validate it, and warns about prompt parts that were not understood; writes
// nothing. Throws UsageError or Error as make_scene does.
void check_source(const SceneSource& source, const SceneParams& params, const std::string& last_stage,
                  SourceFiles& files, const Run& run);

}  // namespace fastscene

// The views stage.
#pragma once

#include <filesystem>

#include "fastscene/base/run.h"
#include "fastscene/pipeline/run_folder.h"
#include "fastscene/views/views.h"

namespace fastscene {

void make_views(const RunFolder& folder, const ViewsParams& params, const std::filesystem::path& out, const Run& run);

}  // namespace fastscene

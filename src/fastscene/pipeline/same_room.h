// The room behind a run is made again from its prompt and seed. The room maker changes from version to version: then it
// is another room.
#pragma once

#include <filesystem>

#include "fastscene/trace/trace.h"

namespace fastscene {

// Throws Error naming the run when its exact range map shows another room than this one.
void check_same_room(const TracedRoom& room, const ImageF& range, const std::filesystem::path& run_dir);

}  // namespace fastscene

// Verifies that the room recreated from a run's prompt and seed is the same. The room generator changes between
// versions: then it is another room.
#pragma once

#include <filesystem>

#include "fastscene/trace/trace.h"

namespace fastscene {

// Throws Error naming the run if its exact range map does not match this room.
void check_same_room(const TracedRoom& room, const ImageF& range, const std::filesystem::path& run_dir);

}  // namespace fastscene

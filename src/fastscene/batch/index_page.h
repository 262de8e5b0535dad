// The page of a batch: all scenes with their pictures, and a search.
#pragma once

#include <filesystem>
#include <vector>

#include "fastscene/batch/journal.h"

namespace fastscene {

// Writes folder/index.html. Pictures load lazily, so a page of 10,000 scenes opens immediately.
void save_index(const std::vector<BatchRecord>& records, const std::filesystem::path& folder);

}  // namespace fastscene

// Exports a data set in a common training format.
#pragma once

#include <filesystem>
#include <string>

#include "fastscene/base/json.h"
#include "fastscene/base/run.h"
#include "fastscene/dataset/format.h"

namespace fastscene::dataset {

// The same bytes for any number of threads. The same call resumes an export that was stopped, and mends a damaged one.
// Returns {"format", "pictures", "splits": {"train": 10, …}, "files", "bytes"}. Throws UsageError if the format cannot
// hold the set's pictures or `out` has other files, Error if the set is not complete or damaged, or if something cannot
// be written.
Json export_dataset(const std::filesystem::path& folder, const std::string& format, const ExportSettings& settings,
                    const std::filesystem::path& out, const Run& run);

}  // namespace fastscene::dataset

// Finds what is missing, truncated or damaged in a data set or in an export of one.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fastscene/base/run.h"

namespace fastscene::dataset {

struct FoundFault {
    std::string file;   // within the folder
    std::string fault;  // "missing", "truncated: expected 812 bytes, found 400" …
    int picture = -1;   // to be regenerated; -1: none
    int room = -1;      // whose document is to be regenerated
};
struct VerifyReport {
    bool is_export = false;  // else a set
    std::int64_t files = 0;  // that were looked at
    std::vector<FoundFault> faults;
};
// `quick`: only names and sizes, not contents. Throws UsageError if the folder is neither a set nor an export.
VerifyReport verify(const std::filesystem::path& folder, bool quick, const Run& run);

// Removes what marks the damaged pictures and rooms of a set as finished, so that make_dataset makes them again.
void forget_damaged(const std::filesystem::path& folder, const VerifyReport& report);

}  // namespace fastscene::dataset

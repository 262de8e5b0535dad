// The formats that data sets are exported to: one entry each, in a source file of its own under
// dataset/dataset_formats/. --help, errors and the contract test take their lists from here.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "fastscene/base/registry.h"
#include "fastscene/base/run.h"
#include "fastscene/dataset/export_folder.h"
#include "fastscene/dataset/set.h"
#include "fastscene/dataset/split.h"

namespace fastscene::dataset {

struct ExportSettings {
    SplitShares splits{0.8, 0.1, 0.1};
    int shard_samples = 1000;                        // of archives: pictures …
    std::uint64_t shard_bytes = 1000 * 1000 * 1000;  // … and bytes of one, at most
};

// What an export works on.
struct ExportJob {
    const DataSet& set;
    const ExportSettings& settings;
    const std::array<std::vector<const SetPicture*>, 3>& splits;
    ExportFolder& out;
    const Run& run;

    // Calls work(split, picture) for every picture, several at a time.
    void for_each(const std::function<void(std::size_t split, const SetPicture&)>& work) const;
};

}  // namespace fastscene::dataset

namespace fastscene {

struct DatasetFormat {
    std::string name = {};     // as its source file
    std::string about = {};    // what it is, in half a sentence
    std::string readers = {};  // what reads it
    bool panoramas = true;     // can hold panoramas
    bool perspective = true;   // can hold perspective pictures
    bool sharded = false;      // writes archives: --shard-samples and --shard-mb count
    void (*write)(const dataset::ExportJob& job) = nullptr;
};

}  // namespace fastscene

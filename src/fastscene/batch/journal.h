// What became of each scene of a batch: batch.jsonl, a line for every try that ended. Lines are only ever appended, so
// a process that is killed loses at most the line it was writing.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "fastscene/base/json.h"

namespace fastscene {

struct BatchRecord {
    std::string name, prompt;
    std::string key;    // of prompt, seed, settings and program: a record with another key does not count
    bool done = false;  // else it failed
    int tries = 0;
    double seconds = 0;
    std::string error;  // the last one of the program's own words
};

class BatchJournal {
  public:
    // Reads what there is; a last line without its end is dropped. Throws Error naming a line that is none of ours.
    explicit BatchJournal(const std::filesystem::path& folder);
    // Throws Error if it cannot be written.
    void add(const BatchRecord& record);
    // The last record of each name, in the order of their first.
    const std::vector<BatchRecord>& records() const { return records_; }
    const BatchRecord* find(const std::string& name) const;

  private:
    void keep(BatchRecord record);
    std::filesystem::path file_;
    std::vector<BatchRecord> records_;
    std::map<std::string, std::size_t> places_;
};

}  // namespace fastscene

// The outcome of each scene of a batch: a file of lines, one for every attempt that ended. Lines are only ever
// appended, so a process that is killed loses at most the line it was writing. A file has one writer: batch.jsonl the
// process that makes the batch, tasks/NUMBER.jsonl the one that makes that chunk.
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
    std::string error;  // the program's last error message
};

// The last record of each name, in the order of the first ones.
class BatchRecords {
  public:
    void keep(BatchRecord record);
    const std::vector<BatchRecord>& all() const { return all_; }
    const BatchRecord* find(const std::string& name) const;

  private:
    std::vector<BatchRecord> all_;
    std::map<std::string, std::size_t> places_;
};

class BatchJournal {
  public:
    // Reads the existing file; an incomplete last line is dropped. Throws Error naming a line that is not a record.
    explicit BatchJournal(const std::filesystem::path& folder, const std::string& name = "batch.jsonl");
    // Throws Error if it cannot be written.
    void add(const BatchRecord& record);
    const std::vector<BatchRecord>& records() const { return records_.all(); }
    const BatchRecord* find(const std::string& name) const { return records_.find(name); }

  private:
    std::filesystem::path file_;
    BatchRecords records_;
};

// The records of all journals of a batch. Leaves the files alone, as others may be writing them.
BatchRecords all_records(const std::filesystem::path& folder);

// Moves the records of chunks into batch.jsonl. No other process may work on the batch.
void collect_journals(const std::filesystem::path& folder);

}  // namespace fastscene

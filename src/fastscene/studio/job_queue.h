// The queue: jobs run one after the other, each with all cores. A studio that ends stops its job; the next one on the
// same folder goes on with it. Of a studio that was killed the process lives on, and is waited for.
#pragma once

#include <condition_variable>
#include <filesystem>
#include <list>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/studio/board.h"
#include "fastscene/studio/job.h"
#include "fastscene/studio/library.h"
#include "fastscene/studio/looks.h"

namespace fastscene::studio {

struct QueueParams {
    std::filesystem::path program;  // fastscene itself
    int threads = 0;                // of a job; 0: all cores
};

class JobQueue {
  public:
    // Reads the jobs that an earlier studio left.
    JobQueue(Library& library, Board& board, Looks& looks, QueueParams params);
    ~JobQueue();  // stops the running job; it waits for the next studio

    void add(Job job);
    // Each throws Refusal 404 for an unknown job, 409 where the job's state does not allow it.
    void stop(const std::string& id);
    void resume(const std::string& id);
    void forget(const std::string& id);      // of a job that is not running; what it has made is kept
    void move_first(const std::string& id);  // among those that wait

    Json jobs() const;
    bool has(const std::string& id) const;
    // A picture of what is to come, while there is no other: empty if there is none.
    std::filesystem::path look(const std::string& id) const;

  private:
    struct Entry {
        Job job;
        std::stop_source stop;
        double started = 0;
    };
    using Entries = std::list<Entry>;

    Entry& entry(const std::string& id);
    void work(const std::stop_token& end);
    void run(Entry& entry, const std::stop_token& end);
    void make_look(Entry& entry, const std::stop_token& stop);
    int make(Entry& entry, const std::stop_token& stop);
    // Of a process that an earlier studio began.
    void wait_for_other(Entry& entry, const std::stop_token& stop);
    void follow_log(Entry& entry, const std::stop_token& end);
    void save(const Entry& entry) const;
    std::filesystem::path record(const std::string& id) const;
    std::filesystem::path log(const std::string& id) const;

    Library& library_;
    Board& board_;
    Looks& looks_;
    QueueParams params_;
    std::filesystem::path folder_;
    mutable std::mutex mutex_;
    std::condition_variable_any condition_;
    Entries entries_;
    std::jthread worker_;
};

}  // namespace fastscene::studio

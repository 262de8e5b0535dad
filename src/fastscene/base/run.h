// Run: the context passed to every stage: seed, event sink, stop request. The only global state is the number of worker
// threads (parallel.h).
#pragma once

#include <atomic>
#include <cstdint>
#include <stop_token>
#include <string>
#include <utility>

#include "fastscene/base/error.h"
#include "fastscene/base/events.h"

namespace fastscene {

struct Run {
    std::uint64_t seed = 0;
    EventSink* events = nullptr;  // may be null: events are discarded
    std::stop_token stop;

    void note(std::string text) const {
        if (events) events->tell(NoteEvent{std::move(text)});
    }
    void warn(std::string text) const {
        if (events) events->tell(WarningEvent{std::move(text)});
    }
    // Throws Stopped if a stop was requested. Call it between pieces of work.
    void check_stop() const {
        if (stop.stop_requested()) throw Stopped();
    }
};

// Counts finished units of work and reports progress. Thread safe.
class Progress {
  public:
    Progress(const Run& run, std::string work, std::int64_t total)
        : run_(run), work_(std::move(work)), total_(total < 1 ? 1 : total) {
        tell(0);
    }
    void advance(std::int64_t units = 1) { tell(done_ += units); }

  private:
    void tell(std::int64_t done) const {
        if (run_.events) run_.events->tell(ProgressEvent{work_, done < total_ ? done : total_, total_});
    }
    const Run& run_;
    std::string work_;
    std::int64_t total_;
    std::atomic<std::int64_t> done_{0};
};

}  // namespace fastscene

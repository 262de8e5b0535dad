// Events: how the library communicates. It never prints; it sends events to an EventSink, which decides what to show
// (command line, batch log, test).
#pragma once

#include <cstdint>
#include <string>
#include <variant>

namespace fastscene {

// `done` of `total` units of the named work are finished. total > 0; done <= total.
struct ProgressEvent {
    std::string work;
    std::int64_t done = 0;
    std::int64_t total = 1;
    double overall = -1;  // progress of the whole run, 0..1; negative = unknown
};
// Information that needs no action.
struct NoteEvent {
    std::string text;
};
// A problem that the user should fix; the work continues.
struct WarningEvent {
    std::string text;
};
using Event = std::variant<ProgressEvent, NoteEvent, WarningEvent>;

struct EventSink {
    virtual ~EventSink() = default;
    virtual void tell(const Event& event) = 0;  // may be called from any thread
};

}  // namespace fastscene

// Events: how the library speaks. It never prints; it tells an EventSink, and whoever listens
// (the command line, a batch log, a test) decides what to show.
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
    double overall = -1;  // share of the whole run that is finished, 0..1; negative = not known
};
// Something the user should know but need not act on.
struct NoteEvent {
    std::string text;
};
// Something the user should act on; the work goes on.
struct WarningEvent {
    std::string text;
};
using Event = std::variant<ProgressEvent, NoteEvent, WarningEvent>;

struct EventSink {
    virtual ~EventSink() = default;
    virtual void tell(const Event& event) = 0;  // may be called from any thread
};

}  // namespace fastscene

// Displays the library's events on stderr.
#pragma once

#include <chrono>
#include <iosfwd>
#include <map>
#include <mutex>
#include <string>
#include <string_view>

#include "fastscene/base/events.h"

namespace fastscene::cli {

// `line`: one line, rewritten. `plain`: occasional lines, for logs. `json`: one object per line. `none`: warnings only.
enum class ProgressStyle { line, plain, json, none };
// Throws UsageError for an unknown name; "auto" is `line` on a terminal, else `plain`.
ProgressStyle progress_style(const std::string& name, bool is_terminal);

// Messages may quote damaged files: control bytes that would affect the terminal are shown as \x1b.
std::string printable(std::string_view text);

class ProgressDisplay : public EventSink {
  public:
    ProgressDisplay(std::ostream& out, ProgressStyle style) : out_(out), style_(style) {}
    ~ProgressDisplay() override { end_line(); }
    void tell(const Event& event) override;
    // Ends the rewritten line, so that other text can follow.
    void end_line();

  private:
    using Clock = std::chrono::steady_clock;
    void show(const ProgressEvent& event);
    void say(const std::string& kind, const std::string& text);
    double seconds_left(const ProgressEvent& event) const;  // of the whole run if known; negative = unknown

    std::ostream& out_;
    ProgressStyle style_;
    std::mutex mutex_;
    std::string work_;                 // current task
    Clock::time_point begin_, shown_;  // when it started, and when it was last displayed
    Clock::time_point overall_begin_;  // when the run's progress was first reported, and its value then
    double overall_first_ = -1;
    int shown_percent_ = -1;
    std::size_t line_length_ = 0;  // length of the rewritten line on screen; 0 = none
};

}  // namespace fastscene::cli

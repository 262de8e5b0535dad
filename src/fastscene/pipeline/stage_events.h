// Forwards a stage's events, prefixed with its name and with the progress of the whole run.
#pragma once

#include <mutex>
#include <string>
#include <string_view>

#include "fastscene/base/events.h"

namespace fastscene {

class StageEvents : public EventSink {
  public:
    // `last_stage`: where the run ends. `sink` may be null.
    StageEvents(std::string_view stage, std::string_view last_stage, EventSink* sink);
    void tell(const Event& event) override;

  private:
    double overall(const ProgressEvent& event);

    std::string stage_;
    EventSink* sink_;
    std::mutex mutex_;
    std::string work_;              // the current task
    int works_before_ = -1;         // finished tasks of this stage
    double begin_ = 0, share_ = 0;  // within the whole run
};

}  // namespace fastscene

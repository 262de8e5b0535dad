// Forwards events of one scene, prefixed with its number and with the progress of the whole suite.
#pragma once

#include <algorithm>
#include <string>

#include "fastscene/base/events.h"

namespace fastscene {

class JobEvents : public EventSink {
  public:
    // The scene covers the share `share` of the total progress, starting at `begin`. `sink` may be null.
    JobEvents(std::string name, double begin, double share, EventSink* sink)
        : name_(std::move(name)), begin_(begin), share_(share), sink_(sink) {}

    void tell(const Event& event) override {
        if (!sink_) return;
        const auto* progress = std::get_if<ProgressEvent>(&event);
        if (!progress) return sink_->tell(event);
        // Making a scene reports its progress and takes most of the time; measuring does not report.
        constexpr double kMaking = 0.8;
        if (progress->overall >= 0) within_ = std::max(within_, kMaking * progress->overall);
        sink_->tell(
            ProgressEvent{name_ + ": " + progress->work, progress->done, progress->total, begin_ + share_ * within_});
    }

  private:
    std::string name_;
    double begin_, share_, within_ = 0;
    EventSink* sink_;
};

}  // namespace fastscene

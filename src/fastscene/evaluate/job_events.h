// Passes on what one scene of many says, with its number before it and with how far the whole suite is.
#pragma once

#include <algorithm>
#include <string>

#include "fastscene/base/events.h"

namespace fastscene {

class JobEvents : public EventSink {
  public:
    // The scene takes `share` of the whole, from `begin` on. `sink` may be null.
    JobEvents(std::string name, double begin, double share, EventSink* sink)
        : name_(std::move(name)), begin_(begin), share_(share), sink_(sink) {}

    void tell(const Event& event) override {
        if (!sink_) return;
        const auto* progress = std::get_if<ProgressEvent>(&event);
        if (!progress) return sink_->tell(event);
        // Making a scene knows how far it is, and is most of it; measuring comes after and does not.
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

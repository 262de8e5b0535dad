// Ctrl-C and SIGTERM request a stop; a second signal ends the program at once.
#pragma once

#include <atomic>
#include <stop_token>
#include <thread>

namespace fastscene::cli {

class SignalWatch {
  public:
    // Create it before any other thread, so that all threads leave the signals to this one.
    SignalWatch();
    ~SignalWatch();
    std::stop_token token() const { return stop_.get_token(); }
    int signal() const { return signal_; }  // the received signal, 0 = none

  private:
    std::stop_source stop_;
    std::atomic<int> signal_{0};
    std::jthread thread_;
};

}  // namespace fastscene::cli

// Ctrl-C, SIGTERM and SIGHUP (a closed terminal) request a stop. Work that does not notice within a second is ended
// where it is (base/forced_exit.h); a second signal ends the program at once.
#pragma once

#include <atomic>
#include <stop_token>
#include <string_view>
#include <thread>

namespace fastscene::cli {

inline constexpr std::string_view kStoppedText = "stopped; finished work is kept, the same command resumes";

class SignalWatch {
  public:
    // Create it before any other thread, so that all threads leave the signals to this one.
    SignalWatch();
    ~SignalWatch();
    // From now on signals are answered. Before, they wait, also across exec.
    void begin();
    std::stop_token token() const { return stop_.get_token(); }
    int signal() const { return signal_; }  // the received signal, 0 = none

  private:
    void watch(const std::stop_token& end);
    std::stop_source stop_;
    std::atomic<int> signal_{0};
    std::jthread thread_;
};

}  // namespace fastscene::cli

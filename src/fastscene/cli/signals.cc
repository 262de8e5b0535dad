#include "fastscene/cli/signals.h"

#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <iostream>

#include "fastscene/base/forced_exit.h"

namespace fastscene::cli {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

// From a stop request to a forced exit. With what duties take, the program is gone within two seconds.
constexpr auto kPatience = 1000ms;
// Reports what delays the exit, such as a checkpoint that is being written.
constexpr auto kSaySaving = 1500ms;

sigset_t watched() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    // Under nohup it is ignored, and stays so.
    struct sigaction hang_up {};
    if (::sigaction(SIGHUP, nullptr, &hang_up) == 0 && hang_up.sa_handler != SIG_IGN) sigaddset(&set, SIGHUP);
    return set;
}

void say(std::string_view text) {
    if (::isatty(STDERR_FILENO) == 1) std::cerr << '\n';  // a line of progress may be open
    std::cerr << "fastscene: " << text << std::endl;
}

}  // namespace

SignalWatch::SignalWatch() {
    // A closed pipe or a file size limit is reported by the writer as an error instead of killing the process.
    ::signal(SIGPIPE, SIG_IGN);
    ::signal(SIGXFSZ, SIG_IGN);
    const sigset_t set = watched();
    ::pthread_sigmask(SIG_BLOCK, &set, nullptr);
}

SignalWatch::~SignalWatch() = default;

void SignalWatch::begin() {
    thread_ = std::jthread([this](const std::stop_token& end) { watch(end); });
}

void SignalWatch::watch(const std::stop_token& end) {
    const sigset_t signals = watched();
    Clock::time_point asked{};
    bool said = false;
    while (!end.stop_requested()) {
        const timespec wait{0, 50'000'000};
        const int got = ::sigtimedwait(&signals, nullptr, &wait);
        if (got > 0) {
            if (signal_ != 0) ::_exit(128 + got);
            signal_ = got;
            asked = Clock::now();
            stop_.request_stop();
        }
        if (signal_ == 0 || Clock::now() - asked < kPatience) continue;
        if (begin_forced_exit()) {
            say(kStoppedText);
            ::_exit(128 + signal_);
        }
        if (said || Clock::now() - asked < kSaySaving) continue;
        said = true;
        say("stopping, once what is done is saved");
    }
}

}  // namespace fastscene::cli

#include "fastscene/cli/signals.h"

#include <signal.h>
#include <unistd.h>

namespace fastscene::cli {
namespace {

sigset_t watched() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    return set;
}

}  // namespace

SignalWatch::SignalWatch() {
    // A closed pipe or a file size limit is reported by the writer as an error instead of killing the process.
    ::signal(SIGPIPE, SIG_IGN);
    ::signal(SIGXFSZ, SIG_IGN);
    const sigset_t set = watched();
    ::pthread_sigmask(SIG_BLOCK, &set, nullptr);
    thread_ = std::jthread([this](std::stop_token end) {
        const sigset_t signals = watched();
        while (!end.stop_requested()) {
            const timespec wait{0, 50'000'000};
            const int got = ::sigtimedwait(&signals, nullptr, &wait);
            if (got <= 0) continue;
            if (signal_ != 0) ::_exit(128 + got);
            signal_ = got;
            stop_.request_stop();
        }
    });
}

SignalWatch::~SignalWatch() = default;

}  // namespace fastscene::cli

#include "fastscene/base/forced_exit.h"

#include <mutex>

namespace fastscene {
namespace {

struct Exit {
    std::recursive_mutex mutex;  // duties write files, which have duties of their own
    std::list<std::function<void()>> duties;
    int holds = 0;
};

// Never destroyed: threads may outlive main().
Exit& the_exit() {
    static Exit* const exit = new Exit;
    return *exit;
}

}  // namespace

ExitHold::ExitHold() {
    const std::lock_guard lock(the_exit().mutex);
    ++the_exit().holds;
}

ExitHold::~ExitHold() {
    const std::lock_guard lock(the_exit().mutex);
    --the_exit().holds;
}

ExitDuty::ExitDuty(std::function<void()> act) {
    const std::lock_guard lock(the_exit().mutex);
    the_exit().duties.push_front(std::move(act));
    place_ = the_exit().duties.begin();
}

ExitDuty::~ExitDuty() { dismiss(); }

void ExitDuty::dismiss() {
    const std::lock_guard lock(the_exit().mutex);
    if (is_due_) the_exit().duties.erase(place_);
    is_due_ = false;
}

bool begin_forced_exit() {
    the_exit().mutex.lock();
    if (the_exit().holds > 0) {
        the_exit().mutex.unlock();
        return false;
    }
    // A copy: duties may make and end others.
    const std::list<std::function<void()>> duties = the_exit().duties;
    for (const std::function<void()>& duty : duties) {
        try {
            duty();
        } catch (...) {
        }
    }
    return true;  // still locked
}

}  // namespace fastscene

// Ending a program that does not unwind in time. A stop request that the work does not notice within a second, because
// it is inside a long step, ends the process anyway (cli/signals.h). What must not be cut off holds the exit; what must
// still happen is a duty.
//
// Library code may use both at any time; a program that never forces its exit is not affected.
#pragma once

#include <functional>
#include <list>

namespace fastscene {

// While one exists, a forced exit waits: for a change in memory that a duty must not see half done, for a checkpoint
// that is being written. Where the exit has begun, the constructor blocks until the process is gone.
class ExitHold {
  public:
    ExitHold();
    ~ExitHold();
    ExitHold(const ExitHold&) = delete;
    ExitHold& operator=(const ExitHold&) = delete;
};

// Called by a forced exit, the newest first, on another thread: removes temporary files, saves what would be lost. It
// must not wait for the thread that made it. Exceptions are ignored.
class ExitDuty {
  public:
    explicit ExitDuty(std::function<void()> act);
    ~ExitDuty();
    ExitDuty(const ExitDuty&) = delete;
    ExitDuty& operator=(const ExitDuty&) = delete;
    // Not needed any more. Where the exit has begun, blocks until the process is gone: a file that a duty may be
    // removing is not renamed.
    void dismiss();

  private:
    std::list<std::function<void()>>::iterator place_;
    bool is_due_ = true;
};

// If nothing holds the exit, does all duties and returns true; from then on holds and duties block. The caller ends the
// process.
bool begin_forced_exit();

}  // namespace fastscene

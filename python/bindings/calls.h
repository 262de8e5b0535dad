// Long work without the interpreter's lock: other Python threads go on, Ctrl-C stops it, and callbacks get the lock
// back.
#pragma once

#include <pybind11/pybind11.h>

#include <condition_variable>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "fastscene/base/run.h"

namespace fastscene::python {

namespace py = pybind11;

// What a call tells Python while it works: progress to a callback, warnings as Python's warnings.
class Caller : public EventSink {
  public:
    explicit Caller(py::object on_progress) : on_progress_(std::move(on_progress)) {}
    void tell(const Event& event) override;
    // Calls Python with the lock. What it throws stops the work and is thrown when that has ended.
    template <class Call>
    void call(const Call& what) {
        const py::gil_scoped_acquire lock;
        if (error_) return;
        try {
            what();
        } catch (const py::error_already_set& e) {
            keep(e);
        }
    }
    // Ctrl-C, and other signals that Python handles. Needs no lock.
    void check_signals();
    std::stop_token stop() const { return stop_.get_token(); }
    // With the lock, after the work: throws what a callback or a signal threw; issues the warnings.
    void finish();

  private:
    void keep(const py::error_already_set& error) {
        error_ = error;
        stop_.request_stop();
    }
    py::object on_progress_;
    std::optional<py::error_already_set> error_;
    std::vector<std::string> warnings_;  // guarded by mutex_
    std::mutex mutex_;
    std::stop_source stop_;
};

// work(run, caller) in a thread of its own; returns what it returns, throws what it throws.
template <class Work>
auto long_call(std::uint64_t seed, py::object on_progress, const Work& work) {
    Caller caller(std::move(on_progress));
    const Run run{seed, &caller, caller.stop()};
    std::optional<decltype(work(run, caller))> result;
    std::exception_ptr failed;
    std::mutex mutex;
    std::condition_variable ended;
    bool done = false;
    {
        const py::gil_scoped_release unlocked;
        std::thread worker([&] {
            try {
                result.emplace(work(run, caller));
            } catch (...) {
                failed = std::current_exception();
            }
            const std::lock_guard lock(mutex);
            done = true;
            ended.notify_all();
        });
        // How long Ctrl-C waits for an answer.
        constexpr auto kPatience = std::chrono::milliseconds(50);
        std::unique_lock lock(mutex);
        while (!ended.wait_for(lock, kPatience, [&] { return done; })) {
            lock.unlock();
            caller.check_signals();
            lock.lock();
        }
        lock.unlock();
        worker.join();
    }
    caller.finish();
    if (failed) std::rethrow_exception(failed);
    return std::move(*result);
}

}  // namespace fastscene::python

// Board: notifies the pages that something has changed; they then request what they show again.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace fastscene::studio {

class Board {
  public:
    void changed() {
        {
            const std::lock_guard lock(mutex_);
            ++version_;
        }
        condition_.notify_all();
    }
    std::uint64_t version() const {
        const std::lock_guard lock(mutex_);
        return version_;
    }
    // Returns early when the version is no longer `seen`.
    std::uint64_t wait(std::uint64_t seen, std::chrono::milliseconds longest) const {
        std::unique_lock lock(mutex_);
        condition_.wait_for(lock, longest, [&] { return version_ != seen; });
        return version_;
    }

  private:
    mutable std::mutex mutex_;
    mutable std::condition_variable condition_;
    std::uint64_t version_ = 1;
};

}  // namespace fastscene::studio

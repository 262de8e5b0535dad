// How much work a submission holds: drivers reset a card that is busy for seconds, displays stand still meanwhile, and
// people stop runs.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace fastscene::vulkan {

class Pace {
  public:
    explicit Pace(double first) : items_(first) {}
    // Items of the next submission, of `left`.
    std::int64_t next(std::int64_t left) {
        now_ = std::clamp<std::int64_t>(static_cast<std::int64_t>(items_), 1, std::max<std::int64_t>(left, 1));
        start_ = Clock::now();
        return now_;
    }
    // Returns the seconds that it took.
    double done() {
        const double took = std::chrono::duration<double>(Clock::now() - start_).count();
        const double could = static_cast<double>(now_) * kSeconds / std::max(took, 1e-5);
        // Parts of a picture differ: faster cautiously, slower at once.
        items_ = std::max(1.0, std::min(could, kFaster * items_));
        return took;
    }

  private:
    using Clock = std::chrono::steady_clock;
    static constexpr double kSeconds = 0.1, kFaster = 3;
    double items_;
    std::int64_t now_ = 0;
    Clock::time_point start_;
};

}  // namespace fastscene::vulkan

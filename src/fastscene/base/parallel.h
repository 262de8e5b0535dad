// Work split over threads. A loop's pieces are fixed by `grain`, not by the number of threads, so a
// loop whose pieces write to separate places gives the same bytes for 1 or 64 threads.
#pragma once

#include <cstdint>
#include <functional>

namespace fastscene {

// Number of worker threads for everything that follows; 0 = all cores. Returns what it became.
int set_threads(int count);
int thread_count();

// Calls body(begin, end) for consecutive pieces of [0, count), `grain` items each (the last may be shorter).
// The first exception thrown by a piece is rethrown here.
void parallel_for(std::int64_t count, std::int64_t grain,
                  const std::function<void(std::int64_t begin, std::int64_t end)>& body);

}  // namespace fastscene

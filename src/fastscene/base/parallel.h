// Parallel loops. Pieces are determined by `grain`, not by the number of threads, so loops whose pieces write to
// separate places give the same bytes for any number of threads.
#pragma once

#include <cstdint>
#include <functional>

namespace fastscene {

// Sets the number of worker threads; 0 = all cores. Returns the actual number.
int set_threads(int count);
int thread_count();

// Calls body(begin, end) for consecutive pieces of [0, count), `grain` items each (the last may be shorter). Rethrows
// the first exception thrown by a piece.
void parallel_for(std::int64_t count, std::int64_t grain,
                  const std::function<void(std::int64_t begin, std::int64_t end)>& body);

}  // namespace fastscene

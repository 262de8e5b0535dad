#include "fastscene/base/parallel.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <memory>
#include <mutex>

#include "fastscene/base/check.h"

namespace fastscene {
namespace {

// oneTBB's thread limit is in effect while this object exists.
std::unique_ptr<tbb::global_control>& limit() {
    static std::unique_ptr<tbb::global_control> control;
    return control;
}

}  // namespace

int set_threads(int count) {
    if (count <= 0) count = tbb::info::default_concurrency();
    limit().reset();
    limit() = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                    static_cast<std::size_t>(count));
    return count;
}

int thread_count() {
    return static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

void parallel_for(std::int64_t count, std::int64_t grain, const std::function<void(std::int64_t, std::int64_t)>& body) {
    FASTSCENE_CHECK(grain > 0);
    if (count <= 0) return;
    const std::int64_t pieces = (count + grain - 1) / grain;
    tbb::parallel_for(
        std::int64_t{0}, pieces, [&](std::int64_t piece) { body(piece * grain, std::min(count, (piece + 1) * grain)); },
        tbb::simple_partitioner());
}

}  // namespace fastscene

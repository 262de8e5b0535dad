#include "fastscene/export/splat_labels.h"

#include "fastscene/base/parallel.h"
#include "fastscene/export/instances.h"

namespace fastscene {
namespace {

// Splats start on surfaces, and training moves them by centimetres. What is farther away shows the view outside.
constexpr float kReach_m = 0.5f;

}  // namespace

std::vector<std::uint16_t> splat_labels(const Splats& splats, const TracedRoom& room, const Run& run) {
    const std::vector<std::uint16_t> by_mesh = instance_by_mesh(room.room());
    std::vector<std::uint16_t> labels(splats.size());
    Progress progress(run, "labels", static_cast<std::int64_t>(splats.size()));
    parallel_for(static_cast<std::int64_t>(splats.size()), 4096, [&](std::int64_t begin, std::int64_t end) {
        run.check_stop();
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
            if (const int mesh = room.nearest_mesh(splats.mean_m[i], kReach_m); mesh >= 0)
                labels[i] = by_mesh[static_cast<std::size_t>(mesh)];
        progress.advance(end - begin);
    });
    return labels;
}

}  // namespace fastscene

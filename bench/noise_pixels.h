// Compares default pictures with converged path tracing at random pixels: many paths for every pixel of a large picture
// would take days, for a few thousand pixels a minute or two, with the same estimate of the mean squared error.
#pragma once

#include <cstdint>
#include <string>

#include "fastscene/base/json.h"
#include "fastscene/trace/trace.h"

namespace fastscene::bench {

struct Lot {
    std::uint64_t seed = 1;  // of the pixel selection and the paths
    int height = 1024;       // of the panorama that the pixels belong to
    int count = 2000;
    int samples = 4096;  // paths per pixel, distributed over its 16 parts
};

// Path traces the pixels and stores the radiance of each one's 16 parts in `path`.
Json trace_reference(const TracedRoom& room, const Lot& lot, const std::string& path);

// Compares `picture` (tone mapped, of the lot's height) with that reference, tone mapped alike. Lists the worst
// hundredth of the pixels, or all.
Json compare_with_reference(const TracedRoom& room, const Shot& picture, const Lot& lot, const std::string& path,
                            bool list_all);

}  // namespace fastscene::bench

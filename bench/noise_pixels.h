// A picture as users get it against the light's true average, at pixels drawn by lot: many paths for each pixel of a
// large picture would take days, for a few thousand they take a minute or two and tell the mean squared error as well.
#pragma once

#include <cstdint>
#include <string>

#include "fastscene/base/json.h"
#include "fastscene/trace/trace.h"

namespace fastscene::bench {

struct Lot {
    std::uint64_t seed = 1;  // of the draw and of the paths
    int height = 1024;       // of the panorama that the pixels belong to
    int count = 2000;
    int samples = 4096;  // paths a pixel, over 16 parts of it
};

// Path traces the lot and keeps the radiances of each pixel's 16 parts in `path`.
Json trace_reference(const TracedRoom& room, const Lot& lot, const std::string& path);

// `picture` (developed, of the lot's height) against that reference, developed as the picture was. Names the worst
// hundredth of the pixels, or all.
Json compare_with_reference(const TracedRoom& room, const Shot& picture, const Lot& lot, const std::string& path,
                            bool list_all);

}  // namespace fastscene::bench
